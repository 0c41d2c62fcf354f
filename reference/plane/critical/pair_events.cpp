#include "reference/plane/critical/pair_events.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/convolution/convolution_rule.hpp"
#include "reference/plane/critical/event_scale.hpp"
#include "reference/plane/critical/moving_pairs.hpp"
#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"

namespace minkref::inline plane {

std::string_view name(Change change) {
  switch (change) {
    case Change::birth:
      return "birth";
    case Change::death:
      return "death";
    case Change::touch:
      return "touch";
    case Change::overlap:
      return "overlap";
  }
  return "";
}
namespace {

double column(const Rational& value) { return to_double(value); }
template <class Int>
double column(const Int& value) {
  return grid_double(value);
}

/// Compares scales with a closed window.
template <class K>
class Window {
 public:
  explicit Window(const ScaleWindow& window) : window_(window) {
    if (window.from) from_ = to_double(*window.from);
    if (window.to) to_ = to_double(*window.to);
  }
  /// Doubles around the window.
  double from() const { return from_ * (1 - 0x1p-50); }
  double to() const {
    return window_.to ? to_ * (1 + 0x1p-50) : std::numeric_limits<double>::infinity();
  }
  bool before(const K& kernel, const typename K::Parameter& t) const {
    return window_.from && compare(kernel, t, *window_.from, from_) < 0;
  }
  bool after(const K& kernel, const typename K::Parameter& t) const {
    return window_.to && compare(kernel, t, *window_.to, to_) > 0;
  }

 private:
  static int compare(const K& kernel, const typename K::Parameter& t, const Rational& bound,
                     double approximate) {
    const double value = K::approximation(t), difference = value - approximate;
    const double error = (std::abs(value) + std::abs(approximate)) * filter_bound;
    if (difference > error) return 1;
    if (difference < -error) return -1;
    return sign(Rational(exact_parameter(kernel, t) - bound));
  }

  ScaleWindow window_;
  double from_ = 0, to_ = 0;
};

template <class K>
class PairSearch {
 public:
  PairSearch(const K& kernel, std::vector<MovingEdge<typename K::Vector>> edges,
             const ScaleWindow& window, EventKind kind, Form form, bool keep_meeting,
             PairEvents& result)
      : kernel_(kernel),
        edges_(std::move(edges)),
        window_(window),
        kind_(kind),
        form_(form),
        keep_meeting_(keep_meeting),
        result_(result) {}

  void run() {
    const auto count = static_cast<std::uint32_t>(edges_.size());
    std::uint64_t looked_at = 0;
    if (form_ == Form::corrected) {
      looked_at = look_at_those_that_may_meet();
    } else {
      // The filter proves that edges never meet; the printed rule ignores such proofs.
      for (std::uint32_t a = 0; a < count; ++a) {
        look_for_interrupt_now();
        for (std::uint32_t b = a + 1; b < count; ++b) pair(a, b);
        looked_at += count - a - 1;
      }
    }
    result_.pairs = std::uint64_t{count} * (count - (count > 0 ? 1 : 0)) / 2;
    result_.filtered_pairs = result_.pairs - looked_at;
    std::sort(result_.meeting.begin(), result_.meeting.end(),
              [](const MeetingPair& x, const MeetingPair& y) {
                return std::tie(x.a, x.b) < std::tie(y.a, y.b);
              });
    sort();
  }

 private:
  using Parameter = typename K::Parameter;

  std::uint64_t look_at_those_that_may_meet() {
    std::vector<RoundedEdge> rounded;
    for (const auto& e : edges_) {
      rounded.push_back({column(e.p.x()), column(e.p.y()), column(e.q.x()), column(e.q.y()),
                         column(e.d.x()), column(e.d.y()), e.is_s()});
    }
    const double from = window_.from(), to = window_.to();
    const MovingPairs pairs(rounded, from, to);
    std::uint64_t looked_at = 0;
    std::vector<std::uint32_t> room;
    for (std::uint32_t block = 0; block < pairs.blocks(); ++block) {
      look_for_interrupt_now();
      pairs.of_block(block, room, [&](std::uint32_t a, std::uint32_t b) {
        if (pair_range(rounded[a], rounded[b], from, to, pairs.error()).is_empty()) return;
        pair(a, b);
        ++looked_at;
      });
    }
    return looked_at;
  }

  void pair(std::uint32_t a, std::uint32_t b) {
    const auto conditions = pair_conditions(kernel_, edges_[a], edges_[b]);
    if (conditions.turn == 0) return parallel(a, b);
    const auto interval = form_ == Form::corrected
                              ? intersection_of_half_lines<K>(kernel_, conditions.half_lines)
                              : printed_rule(kernel_, conditions.half_lines);
    if (!meets_window(interval)) return;
    keep(a, b, MeetingPair::Kind::crossing);
    if (interval.is_point(kernel_)) {
      ++result_.touching_pairs;
      add(a, b, *interval.lower, Change::touch, false);
      return;
    }
    ++result_.intersecting_pairs;
    if (!interval.lower && !interval.upper) ++result_.always_meeting_pairs;
    add_ends(a, b, interval, false);
  }

  void parallel(std::uint32_t a, std::uint32_t b) {
    using Lines = typename ParallelPair<K>::Lines;
    const ParallelPair<K> pair = parallel_pair(kernel_, edges_[a], edges_[b]);
    if (pair.lines == Lines::one_line_at_one_scale) {
      if (pair.meeting == Meeting::never || outside(pair.scale)) return;
      ++result_.parallel_pairs;
      keep(a, b, MeetingPair::Kind::one_line_at_a_scale);
      add(a, b, {0, pair.scale},
          pair.meeting == Meeting::touching ? Change::touch : Change::overlap, true);
    } else if (pair.lines == Lines::one_line_always && meets_window(pair.interval)) {
      ++result_.parallel_pairs;
      keep(a, b, MeetingPair::Kind::one_line_always);
      if (pair.interval.is_point(kernel_)) {
        add(a, b, *pair.interval.lower, Change::touch, true);
      } else {
        add_ends(a, b, pair.interval, true);
      }
    }
  }

  void keep(std::uint32_t a, std::uint32_t b, MeetingPair::Kind kind) {
    if (keep_meeting_) result_.meeting.push_back({a, b, kind});
  }

  bool outside(const Parameter& t) const {
    return window_.before(kernel_, t) || window_.after(kernel_, t);
  }
  bool meets_window(const ScaleInterval<K>& interval) const {
    if (interval.empty) return false;
    if (interval.upper && window_.before(kernel_, interval.upper->scale)) return false;
    return !(interval.lower && window_.after(kernel_, interval.lower->scale));
  }

  void add_ends(std::uint32_t a, std::uint32_t b, const ScaleInterval<K>& interval, bool parallel) {
    if (interval.lower) add(a, b, *interval.lower, Change::birth, parallel);
    if (interval.upper) add(a, b, *interval.upper, Change::death, parallel);
  }
  void add(std::uint32_t a, std::uint32_t b, const typename ScaleInterval<K>::Bound& bound,
           Change change, bool parallel) {
    if (kind_ != EventKind::both && parallel != (kind_ == EventKind::parallel)) return;
    if (outside(bound.scale)) return;
    result_.events.push_back({K::approximation(bound.scale), a, b, 0, change, parallel,
                              static_cast<std::uint8_t>(bound.half_line)});
  }

  /// Sorts by doubles first, then exactly the runs of neighbours with indistinguishable doubles.
  void sort() {
    auto& events = result_.events;
    std::sort(events.begin(), events.end(), [](const PairEvent& x, const PairEvent& y) {
      look_for_interrupt();
      return x.approximate < y.approximate;
    });
    const auto certain = [](const PairEvent& x, const PairEvent& y) {
      return y.approximate - x.approximate > (x.approximate + y.approximate) * filter_bound;
    };
    std::uint32_t rank = 0;
    for (std::size_t first = 0; first < events.size();) {
      std::size_t last = first + 1;
      while (last < events.size() && !certain(events[last - 1], events[last])) ++last;
      rank = sort_exactly(first, last, rank);
      first = last;
    }
    result_.distinct = rank;
  }

  std::uint32_t sort_exactly(std::size_t first, std::size_t last, std::uint32_t rank) {
    auto& events = result_.events;
    if (last - first == 1) {
      events[first].rank = rank;
      return rank + 1;
    }
    std::vector<std::pair<Parameter, PairEvent>> run;
    run.reserve(last - first);
    for (std::size_t i = first; i < last; ++i) {
      look_for_interrupt();
      const PairEvent& e = events[i];
      run.emplace_back(event_scale(kernel_, edges_[e.a], edges_[e.b], e), e);
    }
    std::sort(run.begin(), run.end(), [&](const auto& x, const auto& y) {
      look_for_interrupt();
      const int order = kernel_.compare(x.first, y.first);
      if (order != 0) return order < 0;
      return std::tie(x.second.a, x.second.b) < std::tie(y.second.a, y.second.b);
    });
    for (std::size_t i = 0; i < run.size(); ++i) {
      if (i > 0 && kernel_.compare(run[i - 1].first, run[i].first) != 0) ++rank;
      run[i].second.rank = rank;
      events[first + i] = run[i].second;
    }
    return rank + 1;
  }

  const K& kernel_;
  std::vector<MovingEdge<typename K::Vector>> edges_;
  Window<K> window_;
  EventKind kind_;
  Form form_;
  bool keep_meeting_;
  PairEvents& result_;
};

}  // namespace

PairEvents pair_events(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                       EventKind kind, Form form, bool keep_meeting, ConvolutionType of) {
  const FloatEnvironment standard;
  refuse_bad_operands(P, Q, 1);
  refuse_bad_window(window);
  PairEvents result;
  if (P.empty() || Q.empty()) return result;
  on_exact_frame(P, Q, [&](const auto& frame) {
    using K = typename std::decay_t<decltype(frame)>::K;
    result.edges = convolution_edges(frame.kernel, frame.P, frame.Q, of == ConvolutionType::full);
    PairSearch<K>(frame.kernel, moving_edges(result.edges, frame.P, frame.Q), window, kind, form,
                  keep_meeting, result)
        .run();
    result.statistics.kernel = frame.name();
    add_counts(result.statistics, frame.kernel.counts);
  });
  for (const ConvolutionEdge& e : result.edges) {
    ++(e.kind == ConvolutionEdge::Kind::S ? result.statistics.s_edges : result.statistics.t_edges);
  }
  return result;
}

FormComparison compare_forms(const PolygonSet& P, const PolygonSet& Q) {
  const FloatEnvironment standard;
  refuse_bad_operands(P, Q, 1);
  FormComparison result;
  if (P.empty() || Q.empty()) return result;
  on_exact_frame(P, Q, [&](const auto& frame) {
    using K = typename std::decay_t<decltype(frame)>::K;
    const auto edges =
        moving_edges(convolution_edges(frame.kernel, frame.P, frame.Q, false), frame.P, frame.Q);
    for (std::size_t a = 0; a < edges.size(); ++a) {
      look_for_interrupt_now();
      for (std::size_t b = a + 1; b < edges.size(); ++b) {
        const auto conditions = pair_conditions(frame.kernel, edges[a], edges[b]);
        if (conditions.turn == 0) continue;
        const auto truth = intersection_of_half_lines<K>(frame.kernel, conditions.half_lines);
        const auto printed = printed_rule(frame.kernel, conditions.half_lines);
        if (truth.empty) {
          result.printed_invented += !printed.empty;
        } else if (truth.is_point(frame.kernel)) {
          ++result.touching;
        } else {
          ++result.intersecting;
          const bool right = same_scales(frame.kernel, truth, printed);
          const bool roots =
              std::all_of(conditions.half_lines.begin(), conditions.half_lines.end(),
                          [&](const auto& line) { return frame.kernel.sign(line.slope) != 0; });
          result.printed_right += right;
          result.printed_right_by_roots += right && roots;
          result.printed_empty += printed.empty;
        }
      }
    }
  });
  return result;
}

std::vector<Rational> critical_scales(const PairEvents& events, const PolygonSet& P,
                                      const PolygonSet& Q) {
  const FloatEnvironment standard;
  std::vector<Rational> result;
  if (events.events.empty()) return result;
  result.reserve(events.distinct);
  on_exact_frame(P, Q, [&](const auto& frame) {
    const auto edges = moving_edges(events.edges, frame.P, frame.Q);
    for (const PairEvent& e : events.events) {
      look_for_interrupt();
      if (e.rank < result.size()) continue;
      result.push_back(
          exact_parameter(frame.kernel, event_scale(frame.kernel, edges[e.a], edges[e.b], e)));
    }
  });
  return result;
}

}  // namespace minkref::inline plane
