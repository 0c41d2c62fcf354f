#include "reference/space/critical/critical_events.hpp"

#include <algorithm>
#include <memory>
#include <tuple>

#include "reference/build/stage.hpp"
#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/critical/meeting_facets.hpp"
#include "reference/space/critical/moving_box.hpp"
#include "reference/space/critical/parallel_facets.hpp"

namespace minkref::inline space {
namespace {

void refuse_bad_window(const Rational& from, const Rational& to) {
  if (from > 0 && from <= to) return;
  throw BadInput("bad-window",
                 "the window from " + to_string(from) + " to " + to_string(to) + " is none",
                 "give two positive scales, the smaller one first");
}

BoundedDouble bounded(const Rational& number) {
  const double value = to_double(number);
  return {value, std::abs(value) * 0x1p-52 + 1e-300};
}

BoundedVector corner_at(const MovingConvolution& convolution,
                        const ConvolutionFacet::Corner& corner, const BoundedDouble& s) {
  const BoundedVector &p = convolution.P.points[corner.of_P].rounded,
                      &q = convolution.Q.points[corner.of_Q].rounded;
  return s * p + q;
}

class PairSearch {
 public:
  PairSearch(const MovingConvolution& convolution, const Rational& from, const Rational& to,
             EventsOf what)
      : convolution_(convolution),
        facets_(convolution.facets),
        from_(from),
        window_{EventScale(from), EventScale(to)},
        what_(what),
        first_scale_(bounded(from)),
        last_scale_(bounded(to)) {}

  void look_at(std::uint32_t i, std::uint32_t j, bool filtered) {
    const MovingFacet &a = facets_[i], &b = facets_[j];
    if (filtered && (stays_aside(convolution_, a, b, first_scale_, last_scale_) ||
                     stays_aside(convolution_, b, a, first_scale_, last_scale_))) {
      return;
    }
    const bool parallel =
        filtered ? are_parallel(a, b) : is_zero(cross(a.normal.exact, b.normal.exact));
    std::optional<ContactRegion> region;
    if (!parallel) region.emplace(convolution_, a, b, signs);
    const std::vector<FacetEvent> found =
        region ? region->events(&window_) : parallel_events(convolution_, a, b, signs, &window_);
    const bool has_event = add(found, i, j);
    if (what_ == EventsOf::pairs) return;
    if (parallel ? !are_coplanar(convolution_, a, b) : share_a_side(a, b)) return;
    if (!has_event &&
        !(region ? region->meet_at(from_) : parallel_facets_meet(convolution_, a, b, from_))) {
      return;
    }
    MeetingPair pair{i, j, parallel, below(window_.from), above(window_.to)};
    for (const FacetEvent& event : found) {
      const bool starts = event.change == ContactChange::birth,
                 stops = event.change == ContactChange::death,
                 only = event.change == ContactChange::touch;
      if (starts || only) pair.low = below(event.s);
      if (stops || only) pair.high = above(event.s);
    }
    meeting.push_back(pair);
  }

  void give_to(CriticalEvents& result, std::vector<MeetingPair>& all_meeting) {
    std::move(events.begin(), events.end(), std::back_inserter(result.events));
    all_meeting.insert(all_meeting.end(), meeting.begin(), meeting.end());
    result.near_pairs += near_pairs;
    result.meeting_pairs += meeting_pairs;
    result.signs.add(signs);
  }

  std::vector<MeetingPair> meeting;
  std::vector<SpacePairEvent> events;
  std::uint64_t near_pairs = 0, meeting_pairs = 0;
  SignCounts signs;

 private:
  /// Adds the events within the window; returns whether any exist.
  bool add(const std::vector<FacetEvent>& found, std::uint32_t i, std::uint32_t j) {
    bool has_event = false;
    for (const FacetEvent& event : found) {
      if (!window_.has(event.s)) continue;
      events.push_back({event, i, j});
      has_event = true;
    }
    meeting_pairs += has_event ? 1 : 0;
    return has_event;
  }

  bool are_parallel(const MovingFacet& a, const MovingFacet& b) {
    for (const BoundedDouble& c : cross(a.normal.rounded, b.normal.rounded)) {
      const int certain = c.certain_sign();
      if (certain == 1 || certain == -1) return false;
    }
    return is_zero(cross(a.normal.exact, b.normal.exact));
  }

  const MovingConvolution& convolution_;
  const std::vector<MovingFacet>& facets_;
  const Rational& from_;
  ScaleWindow window_;
  EventsOf what_;
  BoundedDouble first_scale_, last_scale_;
};

void sort_events(std::vector<SpacePairEvent>& events) {
  std::vector<std::pair<double, std::uint32_t>> keys;
  keys.reserve(events.size());
  for (std::uint32_t k = 0; k < events.size(); ++k) {
    keys.emplace_back(events[k].event.s.rounded(), k);
  }
  std::sort(keys.begin(), keys.end(), [&](const auto& a, const auto& b) {
    if (EventScale::tell_the_order(a.first, b.first)) return a.first < b.first;
    const SpacePairEvent &e = events[a.second], &f = events[b.second];
    if (const int order = e.event.s.compare(f.event.s); order != 0) return order < 0;
    return std::tie(e.first, e.second, e.event.of_first, e.event.of_second) <
           std::tie(f.first, f.second, f.event.of_first, f.event.of_second);
  });
  // In place, since memory may not hold the events twice: follows each cycle of the order.
  for (std::uint32_t start = 0; start < keys.size(); ++start) {
    if (keys[start].second == start) continue;
    SpacePairEvent first = std::move(events[start]);
    std::uint32_t to = start;
    for (std::uint32_t from; (from = keys[to].second) != start; to = from) {
      events[to] = std::move(events[from]);
      keys[to].second = to;
    }
    events[to] = std::move(first);
    keys[to].second = to;
  }
}

std::vector<MovingBox> boxes_of(const MovingConvolution& convolution, const Rational& from,
                                const Rational& to) {
  const BoundedDouble first = bounded(from), last = bounded(to);
  std::vector<MovingBox> boxes(convolution.facets.size());
  for (std::size_t f = 0; f < boxes.size(); ++f) {
    for (std::size_t k = 0; k < convolution.facets[f].size; ++k) {
      const auto& corner = convolution.facets[f].names[k];
      boxes[f].at_first.add(box_around(corner_at(convolution, corner, first)));
      boxes[f].at_last.add(box_around(corner_at(convolution, corner, last)));
    }
  }
  return boxes;
}

const MovingConvolution& set_up(CriticalEvents& result, const Polyhedron& P, const Polyhedron& Q) {
  result.operands = std::make_shared<const SpaceOperands>(space_operands(P, Q, {1, 1, 1}));
  result.convolution =
      std::make_shared<const MovingConvolution>(result.operands->P, result.operands->Q);
  return *result.convolution;
}

}  // namespace

CriticalEvents critical_events_in_space(const Polyhedron& P, const Polyhedron& Q,
                                        const Rational& from, const Rational& to,
                                        const BuildOptions& options, EventsOf what,
                                        MostEvents most) {
  const FloatEnvironment standard;
  refuse_bad_window(from, to);
  CriticalEvents result;
  if (P.empty() || Q.empty()) return result;
  const MovingConvolution& convolution = set_up(result, P, Q);
  const std::vector<MovingBox> boxes = boxes_of(convolution, from, to);
  const MovingBoxTree tree(boxes);
  const BuildControl control(options, "the list of events");
  std::vector<std::unique_ptr<PairSearch>> searches(control.threads());
  in_parallel(boxes.size(), control, BuildProgress::Stage::pairs, [&](unsigned thread) {
    searches[thread] = std::make_unique<PairSearch>(convolution, from, to, what);
    return [&, search = searches[thread].get()](std::size_t i) {
      tree.query(boxes[i], [&](std::uint32_t j) {
        if (j <= i) return false;
        control.look();
        ++search->near_pairs;
        search->look_at(static_cast<std::uint32_t>(i), j, true);
        if (search->events.size() > most.count) refuse_long_list(most);
        return false;
      });
    };
  });
  std::vector<MeetingPair> meeting;
  std::size_t all = 0;
  for (const auto& search : searches) all += search ? search->events.size() : 0;
  result.events.reserve(all);
  for (auto& search : searches) {
    if (search) search->give_to(result, meeting);
    search.reset();
  }
  sort_events(result.events);
  if (what == EventsOf::all) {
    add_concurrent_events(convolution, std::move(meeting), EventScale(from), EventScale(to),
                          control, most, result);
  }
  return result;
}

namespace {

SpacePoint scaled_down(const CriticalEvents& events, const std::array<Rational, 3>& x) {
  const Rational unit(Integer(1), events.operands->denominator);
  return {x[0] * unit, x[1] * unit, x[2] * unit};
}

}  // namespace

SpacePoint place_of(const CriticalEvents& events, const ConcurrentEvent& event) {
  return scaled_down(events, place_of(*events.convolution, event));
}

std::optional<SpacePoint> place_of(const CriticalEvents& events, const SpacePairEvent& event) {
  const SpaceOperands& operands = *events.operands;
  const Rational s = event.event.s.exact();
  using Vector = std::array<Rational, 3>;
  const auto corner = [&](const MovingFacet& facet, std::size_t k) -> Vector {
    const IntegerVector &p = operands.P.points[facet.names[k].of_P].exact,
                        &q = operands.Q.points[facet.names[k].of_Q].exact;
    return {s * Rational(p[0]) + Rational(q[0]), s * Rational(p[1]) + Rational(q[1]),
            s * Rational(p[2]) + Rational(q[2])};
  };
  const MovingFacet &first = events.convolution->facets[event.first],
                    &second = events.convolution->facets[event.second];
  if (event.event.kind != ContactKind::edge) {
    if (event.event.of_first != FacetEvent::no_corner) {
      return scaled_down(events, corner(first, event.event.of_first));
    }
    if (event.event.of_second != FacetEvent::no_corner) {
      return scaled_down(events, corner(second, event.event.of_second));
    }
    return std::nullopt;
  }
  // Two lines a + t u and c + r v that meet, not parallel: (c - a) x v = t (u x v).
  const auto side = [&](const MovingFacet& facet, std::size_t k) -> std::pair<Vector, Vector> {
    const Vector from = corner(facet, k), to = corner(facet, (k + 1) % facet.size);
    return {from, {to[0] - from[0], to[1] - from[1], to[2] - from[2]}};
  };
  const auto product = [](const Vector& a, const Vector& b) -> Vector {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto [a, u] = side(first, event.event.of_first);
  const auto [c, v] = side(second, event.event.of_second);
  const Vector moved = product({c[0] - a[0], c[1] - a[1], c[2] - a[2]}, v), across = product(u, v);
  std::size_t axis = 0;
  while (axis < 2 && across[axis] == 0) ++axis;
  const Rational t = moved[axis] / across[axis];
  return scaled_down(events, {a[0] + t * u[0], a[1] + t * u[1], a[2] + t * u[2]});
}

std::uint64_t distinct_scales(const std::vector<SpacePairEvent>& events,
                              const std::vector<ConcurrentEvent>& others) {
  std::uint64_t count = 0;
  const EventScale* last = nullptr;
  std::size_t i = 0, j = 0;
  while (i < events.size() || j < others.size()) {
    const bool first =
        j == others.size() || (i < events.size() && events[i].event.s <= others[j].s);
    const EventScale& s = first ? events[i++].event.s : others[j++].s;
    count += last == nullptr || *last != s ? 1 : 0;
    last = &s;
  }
  return count;
}

CriticalEvents critical_events_of_all_pairs(const Polyhedron& P, const Polyhedron& Q,
                                            const Rational& from, const Rational& to,
                                            EventsOf what) {
  const FloatEnvironment standard;
  refuse_bad_window(from, to);
  CriticalEvents result;
  if (P.empty() || Q.empty()) return result;
  const MovingConvolution& convolution = set_up(result, P, Q);
  PairSearch search(convolution, from, to, what);
  for (std::uint32_t i = 0; i < convolution.facets.size(); ++i) {
    for (std::uint32_t j = i + 1; j < convolution.facets.size(); ++j) {
      look_for_interrupt();
      search.look_at(i, j, false);
    }
  }
  std::vector<MeetingPair> meeting;
  search.give_to(result, meeting);
  sort_events(result.events);
  if (what == EventsOf::all) {
    const BuildOptions options;
    const BuildControl control(options, "the list of events");
    add_concurrent_events(convolution, std::move(meeting), EventScale(from), EventScale(to),
                          control, {}, result);
  }
  return result;
}

}  // namespace minkref::inline space
