#include "reference/plane/dynamic/edge_sweep.hpp"

#include <algorithm>
#include <cmath>

#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref {
namespace {

constexpr std::uint32_t always = EdgeNode::always;
using V = Vector2<Rational>;

/// What the boundary is to a sub-edge.
enum class Status : std::uint8_t { interior, boundary, tight };

struct DoubleEdge {
  double px, py, qx, qy, dx, dy;
};

/// A scale with its nearest double.
struct Sample {
  Rational scale;
  double approximate = 0;
};

/// Something that happens on the edge in a group.
struct Happening {
  enum class Kind : std::uint8_t { arrival, departure, swap, overlap } kind;
  std::uint32_t group;
  std::uint32_t first, second;  ///< local node; the other edges of a triple; the parallel edge
};

template <class T>
struct ByEdge {
  std::vector<T> items;
  std::vector<std::uint32_t> first;

  explicit ByEdge(std::size_t edges) : first(edges + 1, 0) {}
  /// report(add) is called twice, and calls add(edge, item) for each item.
  template <class Report>
  void fill(Report&& report) {
    report([&](std::uint32_t edge, const T&) { ++first[edge + 1]; });
    for (std::size_t e = 0; e + 1 < first.size(); ++e) first[e + 1] += first[e];
    items.resize(first.back());
    std::vector<std::uint32_t> place(first.begin(), first.end() - 1);
    report([&](std::uint32_t edge, const T& item) { items[place[edge]++] = item; });
  }
};

}  // namespace

struct EdgeSweep::Impl {
  const ArrangementEvents& events;
  InteriorTest interior;
  std::unique_ptr<NodeArithmetic> arithmetic;
  std::vector<DoubleEdge> doubles;
  ByEdge<Happening> shared;                  ///< swaps and overlaps
  ByEdge<std::uint32_t> always_on_one_line;  ///< edges on the line of an edge at every scale

  // Of the edge being swept. Local nodes count from 0; then come the edge's start and end.
  std::uint32_t edge = 0, begin = 0, count = 0;
  std::vector<double> slope, value;
  std::vector<std::uint32_t> list;
  std::vector<Status> status;           ///< of the gap after each element of the list
  std::vector<std::uint32_t> sub_edge;  ///< likewise
  std::vector<Happening> happenings;
  std::uint32_t exact_group = always;
  Fraction exact_scale;
  EdgeHistory* out = nullptr;

  Impl(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events_)
      : events(events_),
        interior(P, Q),
        arithmetic(node_arithmetic(P, Q, events_)),
        shared(events_.edges().size()),
        always_on_one_line(events_.edges().size()) {
    for (const RationalEdge& e : events.moving()) {
      doubles.push_back({to_double(e.p.x()), to_double(e.p.y()), to_double(e.q.x()),
                         to_double(e.q.y()), to_double(e.d.x()), to_double(e.d.y())});
    }
    shared.fill([&](auto&& add) {
      for (std::size_t t = 0; t < events.triples().size(); ++t) {
        const TripleEvent& triple = events.triples()[t];
        const std::uint32_t group = events.group_of_triple(t);
        const auto along = [&](int bit, std::uint32_t e, std::uint32_t f, std::uint32_t g) {
          if (triple.swaps >> bit & 1) add(e, {Happening::Kind::swap, group, f, g});
        };
        along(0, triple.a, triple.b, triple.c);
        along(1, triple.b, triple.a, triple.c);
        along(2, triple.c, triple.a, triple.b);
      }
      for (std::size_t i = 0; i < events.pairs().events.size(); ++i) {
        const PairEvent& event = events.pairs().events[i];
        if (!event.parallel || event.change != Change::overlap) continue;
        const std::uint32_t group = events.group_of_pair_event(i);
        if (group == always) continue;
        add(event.a, {Happening::Kind::overlap, group, event.b, 0});
        add(event.b, {Happening::Kind::overlap, group, event.a, 0});
      }
    });
    always_on_one_line.fill([&](auto&& add) {
      for (const MeetingPair& pair : events.pairs().meeting) {
        if (pair.kind != MeetingPair::Kind::one_line_always) continue;
        add(pair.a, pair.b);
        add(pair.b, pair.a);
      }
    });
  }

  // Nodes.
  std::uint32_t start() const { return count; }
  std::uint32_t end() const { return count + 1; }
  std::uint32_t name(std::uint32_t local) const {
    return local == start() ? start_of_edge : local == end() ? end_of_edge : begin + local;
  }
  const EdgeNode& node(std::uint32_t local) const { return events.table().nodes[begin + local]; }
  PositionAlong<Rational> position(std::uint32_t local) const {
    if (local == start()) return {};
    if (local == end()) {
      return events.moving()[edge].is_s() ? PositionAlong<Rational>{1, 0, 1}
                                          : PositionAlong<Rational>{0, 1, 1};
    }
    return node_position(PlainKernel<Rational>{}, events.moving(), edge, node(local));
  }
  static Rational at(const PositionAlong<Rational>& p, const Rational& scale) {
    return (p.slope * scale + p.value) / p.den;
  }

  /// The sign of x - y.
  static int sign_of_difference(double x, double y, double terms) {
    const double bound = terms * 2 * filter_bound + 1e-300;
    return x - y > bound ? 1 : x - y < -bound ? -1 : 0;
  }
  int compare_at(std::uint32_t x, std::uint32_t y, std::uint32_t group) {
    if (x == y) return 0;
    const double s = events.approximate(group);
    const int sign = sign_of_difference(
        slope[x] * s + value[x], slope[y] * s + value[y],
        (std::abs(slope[x]) + std::abs(slope[y])) * s + std::abs(value[x]) + std::abs(value[y]));
    if (sign != 0) return sign;
    if (exact_group != group) {
      exact_group = group;
      exact_scale = arithmetic->scale(group);
    }
    return arithmetic->compare(edge, name(x), name(y), exact_scale);
  }
  int compare_slopes(std::uint32_t x, std::uint32_t y) const {
    const int sign =
        sign_of_difference(slope[x], slope[y], std::abs(slope[x]) + std::abs(slope[y]));
    return sign != 0 ? sign : arithmetic->compare_slopes(edge, name(x), name(y));
  }
  /// Order just above a scale where both are at one place.
  bool before_after_meeting(std::uint32_t x, std::uint32_t y) const {
    if (x == y) return false;
    if (x == start() || y == end()) return true;
    if (y == start() || x == end()) return false;
    const int order = compare_slopes(x, y);
    return order != 0 ? order < 0 : x < y;
  }
  bool same_track(std::uint32_t x, std::uint32_t y) const {
    if (sign_of_difference(slope[x], slope[y], std::abs(slope[x]) + std::abs(slope[y])) != 0 ||
        sign_of_difference(value[x], value[y], std::abs(value[x]) + std::abs(value[y])) != 0) {
      return false;
    }
    return arithmetic->same_track(edge, name(x), name(y));
  }

  // Samples.

  /// A scale between two groups; `always`: the end of the window.
  Sample between(std::uint32_t low, std::uint32_t high) {
    const ScaleWindow& window = events.window();
    const double from = low != always ? events.approximate(low)
                        : window.from ? to_double(*window.from)
                                      : 0.0;
    const double to = high != always ? events.approximate(high)
                      : window.to    ? to_double(*window.to)
                                     : 2 * from + 1;
    const double room = to - from, error = (from + to) * 4 * filter_bound;
    if (room > 64 * error && std::isfinite(to) && room > 1e-290) {
      // As few bits as the room allows.
      const int exponent = std::ilogb(room) - 2;
      const double unit = std::ldexp(1.0, exponent);
      const double middle = std::round((from + room / 2) / unit) * unit;
      if (middle > from + error && middle < to - error) return {from_double(middle), middle};
    }
    const auto exact_end = [&](std::uint32_t group, const std::optional<Rational>& bound,
                               const Rational& otherwise) {
      return group != always ? events.exact(group) : bound ? *bound : otherwise;
    };
    const Rational lower = exact_end(low, window.from, 0);
    const Rational upper = exact_end(high, window.to, 2 * lower + 1);
    const Rational middle = (lower + upper) / 2;
    return {middle, to_double(middle)};
  }

  Point middle_of(std::uint32_t x, std::uint32_t y, const Rational& scale) const {
    const Rational along = (at(position(x), scale) + at(position(y), scale)) / 2;
    const RationalEdge& e = events.moving()[edge];
    return {e.p.x() * scale + e.q.x() + e.d.x() * along,
            e.p.y() * scale + e.q.y() + e.d.y() * along};
  }

  // Status.

  struct Place {
    double x, y, error;
  };
  Place place(double along, double along_terms, double s) const {
    const DoubleEdge& e = doubles[edge];
    const double terms =
        std::max(std::abs(e.px) * s + std::abs(e.qx), std::abs(e.py) * s + std::abs(e.qy)) +
        std::max(std::abs(e.dx), std::abs(e.dy)) * along_terms;
    return {e.px * s + e.qx + e.dx * along, e.py * s + e.qy + e.dy * along,
            terms * 0x1p-46 + 1e-300};
  }

  /// Whether the sub-edge just after (or before) a node runs on the left of the edge that crosses
  /// there, where everything is inside the sum. False if doubles cannot tell.
  bool certainly_left(std::uint32_t local, bool after, double s) const {
    if (local >= count || node(local).kind != EdgeNode::Kind::crossing) return false;
    const DoubleEdge &e = doubles[edge], &f = doubles[node(local).other];
    const double left = f.dx * e.dy, right = f.dy * e.dx;
    const double bound = (std::abs(left) + std::abs(right)) * 0x1p-48 + 1e-300;
    if (after ? !(left - right > bound) : !(left - right < -bound)) return false;
    // Not at an end of the other edge, beyond which it has no left side.
    const Place x = place(slope[local] * s + value[local],
                          std::abs(slope[local]) * s + std::abs(value[local]), s);
    const bool is_s = events.moving()[node(local).other].is_s();
    const double length = is_s ? s : 1.0;
    const double ax = f.px * s + f.qx, ay = f.py * s + f.qy;
    const double bx = ax + f.dx * length, by = ay + f.dy * length;
    const double error =
        x.error + (std::abs(f.px) * s + std::abs(f.qx) + std::abs(f.py) * s + std::abs(f.qy) +
                   std::abs(f.dx) * length + std::abs(f.dy) * length) *
                      0x1p-46;
    const auto apart = [&](double ux, double uy) {
      return std::abs(x.x - ux) > error || std::abs(x.y - uy) > error;
    };
    return apart(ax, ay) && apart(bx, by);
  }

  /// Whether an edge on this line in the other direction runs along a point of this edge.
  bool covered_against(const Point& x, const Rational& scale, std::uint32_t other) const {
    const RationalEdge &e = events.moving()[edge], &f = events.moving()[other];
    if (minkref::sign(PlainKernel<Rational>::dot(e.d, f.d)) > 0) return false;
    const V to_start = minkref::at(start_of(f), scale), to_end = minkref::at(end_of(f), scale);
    const Rational along = e.d.x() * x.x + e.d.y() * x.y;
    return along < e.d.dot(to_start) && along > e.d.dot(to_end);
  }

  /// Of the sub-edge between two neighbours at a scale; `overlaps`: edges on this line at this
  /// scale only.
  Status status_at(std::uint32_t x, std::uint32_t y, const Sample& sample,
                   const std::vector<std::uint32_t>& overlaps = {}) {
    const double s = sample.approximate;
    const double along = (slope[x] * s + value[x] + slope[y] * s + value[y]) / 2;
    const Place near = place(
        along,
        (std::abs(slope[x]) + std::abs(slope[y])) * s + std::abs(value[x]) + std::abs(value[y]), s);
    if (interior.certainly_inside(near.x, near.y, near.error, s)) {
      ++out->decided_by_doubles;
      return Status::interior;
    }
    ++out->decided_exactly;
    const Point point = middle_of(x, y, sample.scale);
    if (interior.inside(point, sample.scale)) return Status::interior;
    const auto against = [&](std::uint32_t other) {
      return covered_against(point, sample.scale, other);
    };
    const auto* const one_line = always_on_one_line.items.data();
    if (std::any_of(one_line + always_on_one_line.first[edge],
                    one_line + always_on_one_line.first[edge + 1], against) ||
        std::any_of(overlaps.begin(), overlaps.end(), against)) {
      return Status::tight;
    }
    return Status::boundary;
  }
  Status status_between(std::uint32_t x, std::uint32_t y, std::uint32_t low, std::uint32_t high) {
    const Sample sample = between(low, high);
    if (certainly_left(x, true, sample.approximate) ||
        certainly_left(y, false, sample.approximate)) {
      return Status::interior;
    }
    return status_at(x, y, sample);
  }

  // The sweep.

  void change(std::uint32_t step, NodeChange::Kind kind, std::size_t index) {
    out->changes.push_back(
        {step, edge, name(list[index]), static_cast<std::uint32_t>(index - 1), kind});
  }

  std::uint32_t open(std::uint32_t x, std::uint32_t y, std::uint32_t interval) {
    out->sub_edges.push_back({edge, name(x), name(y), interval, always});
    return static_cast<std::uint32_t>(out->sub_edges.size() - 1);
  }

  void run(std::uint32_t edge_, EdgeHistory& history) {
    out = &history;
    edge = edge_;
    begin = events.table().begin(edge);
    count = events.table().end(edge) - begin;
    arithmetic->columns(edge, slope, value);
    const bool is_s = events.moving()[edge].is_s();
    slope.insert(slope.end(), {0.0, is_s ? 1.0 : 0.0});
    value.insert(value.end(), {0.0, is_s ? 0.0 : 1.0});

    happenings.assign(shared.items.begin() + shared.first[edge],
                      shared.items.begin() + shared.first[edge + 1]);
    list.clear();
    for (std::uint32_t n = 0; n < count; ++n) {
      if (node(n).from == always) {
        list.push_back(n);
      } else {
        happenings.push_back({Happening::Kind::arrival, node(n).from, n, 0});
      }
      if (node(n).to != always) {
        happenings.push_back({Happening::Kind::departure, node(n).to, n, 0});
      }
    }
    std::sort(happenings.begin(), happenings.end(), [](const Happening& x, const Happening& y) {
      return std::tie(x.group, x.kind, x.first, x.second) <
             std::tie(y.group, y.kind, y.first, y.second);
    });
    first_order();
    auto& names = history.initial.emplace_back();
    for (std::size_t i = 1; i + 1 < list.size(); ++i) names.push_back(name(list[i]));

    const std::uint32_t first_group = happenings.empty() ? always : happenings.front().group;
    status.assign(list.size() - 1, Status::interior);
    sub_edge.assign(list.size() - 1, no_sub_edge);
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
      if (same_track(list[i], list[i + 1])) continue;
      status[i] = status_between(list[i], list[i + 1], always, first_group);
      if (status[i] == Status::boundary) sub_edge[i] = open(list[i], list[i + 1], 0);
    }
    for (std::size_t i = 0; i < happenings.size();) {
      std::size_t j = i;
      while (j < happenings.size() && happenings[j].group == happenings[i].group) ++j;
      const std::uint32_t next = j < happenings.size() ? happenings[j].group : always;
      pass({happenings.data() + i, happenings.data() + j}, happenings[i].group, next);
      i = j;
    }
    const auto intervals = static_cast<std::uint32_t>(events.groups());
    for (const std::uint32_t s : sub_edge) {
      if (s != no_sub_edge) history.sub_edges[s].last = intervals;
    }
  }

  /// The order in interval 0: just above the beginning of the window.
  void first_order() {
    const Rational from = events.window().from.value_or(0);
    const double s = to_double(from);
    std::sort(list.begin(), list.end(), [&](std::uint32_t x, std::uint32_t y) {
      if (x == y) return false;
      int order = sign_of_difference(
          slope[x] * s + value[x], slope[y] * s + value[y],
          (std::abs(slope[x]) + std::abs(slope[y])) * s + std::abs(value[x]) + std::abs(value[y]));
      if (order == 0) {
        order = minkref::sign(Rational(at(position(x), from) - at(position(y), from)));
      }
      return order != 0 ? order < 0 : before_after_meeting(x, y);
    });
    list.insert(list.begin(), start());
    list.push_back(end());
  }

  struct Range {
    const Happening *first, *last;
  };

  /// Across a group of events; `next` is the next group on this edge.
  void pass(Range range, std::uint32_t group, std::uint32_t next) {
    const std::vector<std::uint32_t> old = list;
    const std::vector<Status> old_status = status;
    const std::vector<std::uint32_t> old_sub_edge = sub_edge;
    std::vector<std::uint32_t> arriving, departing, changed, overlaps;
    for (const Happening* h = range.first; h != range.last; ++h) {
      switch (h->kind) {
        case Happening::Kind::arrival:
          arriving.push_back(h->first);
          changed.push_back(h->first);
          break;
        case Happening::Kind::departure:
          departing.push_back(h->first);
          changed.push_back(h->first);
          break;
        case Happening::Kind::swap:
          for (std::size_t i = 1; i + 1 < old.size(); ++i) {
            const std::uint32_t other = node(old[i]).other;
            if (other == h->first || other == h->second) changed.push_back(old[i]);
          }
          break;
        case Happening::Kind::overlap:
          overlaps.push_back(h->first);
          break;
      }
    }
    const auto in = [](const std::vector<std::uint32_t>& set, std::uint32_t x) {
      return std::find(set.begin(), set.end(), x) != set.end();
    };

    // At the scale of the group.
    for (const std::uint32_t x : arriving) {
      const auto place = std::lower_bound(
          list.begin() + 1, list.end() - 1, x,
          [&](std::uint32_t y, std::uint32_t z) { return compare_at(y, z, group) < 0; });
      const auto index = static_cast<std::size_t>(place - list.begin());
      list.insert(place, x);
      change(2 * group, NodeChange::Kind::insertion, index);
    }
    const std::vector<std::uint32_t> here = list;
    std::vector<bool> tied(here.size(), false);  // with the next
    for (std::size_t i = 1; i + 1 < here.size(); ++i) {
      if (!in(changed, here[i])) continue;
      for (std::size_t k = i; k > 0 && !tied[k - 1]; --k) {
        if (compare_at(here[k - 1], here[k], group) != 0) break;
        tied[k - 1] = true;
      }
      for (std::size_t k = i; k + 1 < here.size() && !tied[k]; ++k) {
        if (compare_at(here[k], here[k + 1], group) != 0) break;
        tied[k] = true;
      }
    }

    // Just above it.
    for (std::size_t i = list.size() - 1; i-- > 1;) {
      if (!in(departing, list[i])) continue;
      change(2 * group + 1, NodeChange::Kind::deletion, i);
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    }
    for (std::size_t i = 0, at = 0; i < here.size();) {
      std::size_t j = i, kept = 0;
      for (;; ++j) {
        kept += !in(departing, here[j]);
        if (!tied[j]) break;
      }
      if (kept > 1) {
        for (std::size_t k = at + 1; k < at + kept; ++k) {
          for (std::size_t m = k; m > at && before_after_meeting(list[m], list[m - 1]); --m) {
            change(2 * group + 1, NodeChange::Kind::swap, m - 1);
            std::swap(list[m - 1], list[m]);
          }
        }
      }
      at += kept;
      i = j + 1;
    }
    boundary(old, old_status, old_sub_edge, here, tied, arriving, departing, overlaps, group, next);
  }

  /// Carries the status of the gaps across a group.
  void boundary(const std::vector<std::uint32_t>& old, const std::vector<Status>& old_status,
                const std::vector<std::uint32_t>& old_sub_edge,
                const std::vector<std::uint32_t>& here, const std::vector<bool>& tied,
                const std::vector<std::uint32_t>& arriving,
                const std::vector<std::uint32_t>& departing,
                const std::vector<std::uint32_t>& overlaps, std::uint32_t group,
                std::uint32_t next) {
    const auto in = [](const std::vector<std::uint32_t>& set, std::uint32_t x) {
      return std::find(set.begin(), set.end(), x) != set.end();
    };
    // Stretches of positive length at the scale of the group, each within one gap before and one
    // after.
    struct Stretch {
      std::uint32_t from, to;
      std::size_t before, after;
      bool overlapped = false;
      std::size_t from_index;
    };
    std::vector<Stretch> stretches;
    std::size_t before = 0, after = 0;
    for (std::size_t i = 0; i + 1 < here.size(); ++i) {
      before += !in(arriving, here[i]);
      after += !in(departing, here[i]);
      if (!tied[i] && !same_track(here[i], here[i + 1])) {
        stretches.push_back({here[i], here[i + 1], before - 1, after - 1, false, i});
      }
    }
    if (!overlaps.empty()) {
      for (Stretch& stretch : stretches) {
        const Point point = middle_of(stretch.from, stretch.to, events.exact(group));
        stretch.overlapped = std::any_of(overlaps.begin(), overlaps.end(), [&](std::uint32_t f) {
          return covers(point, events.exact(group), f);
        });
      }
    }

    status.assign(list.size() - 1, Status::interior);
    sub_edge.assign(list.size() - 1, no_sub_edge);
    std::vector<bool> goes_on(stretches.size(), false);
    for (std::size_t j = 0, k = 0; j + 1 < list.size(); ++j) {
      const std::size_t first = k;
      bool same = true, overlapped = false;
      for (; k < stretches.size() && stretches[k].after == j; ++k) {
        overlapped = overlapped || stretches[k].overlapped;
        same = same && old_status[stretches[k].before] == old_status[stretches[first].before];
      }
      if (first == k) {
        if (same_track(list[j], list[j + 1])) continue;
        status[j] = status_between(list[j], list[j + 1], group, next);
      } else if (!same || overlapped) {
        status[j] = status_between(list[j], list[j + 1], group, next);
      } else {
        status[j] = old_status[stretches[first].before];
      }
      if (status[j] != Status::boundary) continue;
      if (first < k) {
        const std::size_t gap = stretches[first].before;
        const bool whole = (first == 0 || stretches[first - 1].before != gap) &&
                           stretches[k - 1].before == gap &&
                           (k == stretches.size() || stretches[k].before != gap);
        if (whole && old_sub_edge[gap] != no_sub_edge && old[gap] == list[j] &&
            old[gap + 1] == list[j + 1]) {
          sub_edge[j] = old_sub_edge[gap];
          if (k - first == 1 && !overlapped) {
            goes_on[first] = true;
          } else {
            out->interrupted.emplace_back(group, sub_edge[j]);
          }
          continue;
        }
      }
      sub_edge[j] = open(list[j], list[j + 1], group + 1);
    }
    for (const std::uint32_t s : old_sub_edge) {
      if (s != no_sub_edge && !in(sub_edge, s)) out->sub_edges[s].last = group;
    }
    pieces(old_status, old_sub_edge, stretches, goes_on, overlaps, group);
    coincident(old_status, here, tied, stretches, group);
  }

  template <class Stretches>
  void pieces(const std::vector<Status>& old_status, const std::vector<std::uint32_t>& old_sub_edge,
              const Stretches& stretches, const std::vector<bool>& goes_on,
              const std::vector<std::uint32_t>& overlaps, std::uint32_t group) {
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      const auto& stretch = stretches[k];
      const bool was = old_status[stretch.before] == Status::boundary;
      const bool is = status[stretch.after] == Status::boundary;
      if (goes_on[k] || !(was || is)) continue;
      const bool now = stretch.overlapped
                           ? status_at(stretch.from, stretch.to,
                                       {events.exact(group), events.approximate(group)},
                                       overlaps) == Status::boundary
                           : was && is;
      if (!now) continue;
      out->at_groups.push_back({group, edge, name(stretch.from), name(stretch.to),
                                old_sub_edge[stretch.before], sub_edge[stretch.after]});
    }
  }

  /// Blocks of coincident nodes that the boundary touches, before or after.
  template <class Stretches>
  void coincident(const std::vector<Status>& old_status, const std::vector<std::uint32_t>& here,
                  const std::vector<bool>& tied, const Stretches& stretches, std::uint32_t group) {
    const auto touches = [&](std::size_t first, std::size_t last) {
      for (const auto& stretch : stretches) {
        if (stretch.from_index + 1 != first && stretch.from_index != last) continue;
        if (old_status[stretch.before] == Status::boundary ||
            status[stretch.after] == Status::boundary) {
          return true;
        }
      }
      return false;
    };
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (!tied[i]) continue;
      std::size_t j = i;
      while (tied[j]) ++j;
      if (touches(i, j)) {
        CoincidentNodes block{group, edge, {}};
        for (std::size_t k = i; k <= j; ++k) block.nodes.push_back(name(here[k]));
        out->coincident.push_back(std::move(block));
      }
      i = j;
    }
  }

  /// Whether a parallel edge runs along a point of this edge.
  bool covers(const Point& x, const Rational& scale, std::uint32_t other) const {
    const RationalEdge &e = events.moving()[edge], &f = events.moving()[other];
    const V a = minkref::at(start_of(f), scale), b = minkref::at(end_of(f), scale);
    const Rational along = e.d.x() * x.x + e.d.y() * x.y, from = e.d.dot(a), to = e.d.dot(b);
    return along > std::min(from, to) && along < std::max(from, to);
  }
};

EdgeSweep::EdgeSweep(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events)
    : impl_(std::make_unique<Impl>(P, Q, events)) {}
EdgeSweep::~EdgeSweep() = default;

void EdgeSweep::sweep(std::uint32_t edge, EdgeHistory& history) { impl_->run(edge, history); }

}  // namespace minkref
