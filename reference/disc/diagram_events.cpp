#include "reference/disc/diagram_events.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "reference/build/stage.hpp"
#include "reference/disc/contact_envelope.hpp"
#include "reference/disc/equidistant.hpp"
#include "reference/error.hpp"

namespace minkref::inline disc {
namespace {

using Kind = DiagramEvent::Kind;
using Features = std::vector<std::uint32_t>;

constexpr std::uint32_t none = UINT32_MAX;
constexpr double near_places = 1e-7;  // that are taken for one, of a set of the size 1

[[noreturn]] void refuse() {
  throw LimitExceeded("too-near", "two places of events are nearer to each other than doubles tell",
                      "move vertices that are almost, but not quite, as far from some place");
}

double off(const Vector<Interval>& at, const Spot& x) {
  return std::hypot(approximate(at.x) - x.x, approximate(at.y) - x.y);
}

/// The places that two or three features single out.
template <class N>
std::vector<Equidistant<N>> candidates(const OffsetCurves& curves, const Features& features) {
  const auto site = [&](std::uint32_t feature) { return Site::of(curves, feature); };
  if (features.size() == 2) {
    return EquidistantPoints<N>::between(site(features[0]), site(features[1]));
  }
  for (const std::uint32_t line : features) {
    const Site own = site(line);
    if (own.is_point) continue;
    for (const std::uint32_t end : features) {
      const Site point = site(end);
      if (!point.is_point || dot(own.normal, from_to(own.point, point.point)) != 0) continue;
      const auto other = std::find_if(features.begin(), features.end(),
                                      [&](std::uint32_t f) { return f != line && f != end; });
      return EquidistantPoints<N>::in_front(point.point, own, site(*other));
    }
  }
  return EquidistantPoints<N>::of(site(features[0]), site(features[1]), site(features[2]));
}

Vector<Interval> near(const Vector<Interval>& at) { return at; }

/// By MPFR, since doubles may leave nothing of a difference.
Interval tight(const RootNumber& number) {
  constexpr long precision = 256;
  const MpfrInterval bounds = number.enclosure(precision);
  return {Interval(bounds.low()).lower(), Interval(bounds.high()).upper()};
}

Vector<Interval> near(const RootPoint& at) { return {tight(at.x), tight(at.y)}; }

/// Whether a place is known to some nine digits.
bool is_sharp(const Equidistant<Interval>& place) {
  const auto width = [](const Interval& value) { return value.upper() - value.lower(); };
  const Interval& square = place.squared_radius;
  return square.lower() > 0 && width(square) < 1e-9 * square.upper() &&
         std::max(width(place.at.x), width(place.at.y)) < 1e-9 * std::sqrt(square.lower());
}

bool are_same(const Vector<Interval>&, const Vector<Interval>&) { throw UndecidedSign(); }

/// Throws LimitExceeded ("too-near") where there are two that are not told apart; of intervals
/// UndecidedSign, since they may be one.
template <class N>
std::optional<Equidistant<N>> nearest(const std::vector<Equidistant<N>>& found, const Spot& spot) {
  if (found.empty()) return std::nullopt;
  const auto far = [&](const Equidistant<N>& each) { return off(near(each.at), spot); };
  const bool is_first = found.size() == 1 || far(found[0]) <= far(found[1]);
  const bool are_near = found.size() == 2 && far(found[is_first ? 1 : 0]) < near_places;
  if (are_near && !are_same(found[0].at, found[1].at)) refuse();
  return found[is_first ? 0 : 1];
}

Equidistant<RootNumber> exact_of(const OffsetCurves& curves, const Features& features,
                                 const Spot& spot) {
  auto found = nearest(candidates<RootNumber>(curves, features), spot);
  if (!found) throw std::logic_error("an event has no exact place");
  return *found;
}

/// Finds the events behind candidates, and proves them.
class Prover {
 public:
  Prover(const OffsetCurves& curves, const ContactEnvelopes& envelopes)
      : curves_(curves), envelopes_(envelopes) {
    for (const OffsetEdge& edge : curves.edges) edges_.emplace_back(edge, Rational(1));
  }

  /// None where another feature is nearer, or where one of them is none of its own: a vertex on
  /// an edge, or at which an edge goes on straight as the next. `is_nearer` tells which.
  std::optional<DiagramEvent> event(const Features& features, const Spot& spot) {
    exact_.reset();
    spot_ = spot;
    is_nearer = false;
    DiagramEvent event;
    event.of = features;
    try {
      const auto found = nearest(candidates<Interval>(curves_, features), spot);
      if (!found) return std::nullopt;
      event.at = found->at;
      event.squared_radius = found->squared_radius;
      if (!is_sharp(*found)) throw UndecidedSign();
    } catch (const UndecidedSign&) {
      if (candidates<RootNumber>(curves_, features).empty()) return std::nullopt;
      event.at = near(exact(event).at);
      event.squared_radius = tight(exact(event).squared_radius);
      if (sign(exact(event).squared_radius) <= 0) return std::nullopt;
    }
    const double reach = std::sqrt(event.squared_radius.upper()) * (1 + 1e-9);
    plane::Box box = box_of(event.at);
    box = {box.xmin - reach, box.ymin - reach, box.xmax + reach, box.ymax + reach};
    std::set<std::uint32_t> found, at_joints;
    straight_here_.clear();
    met_inside_.clear();
    bool is_empty = true;
    envelopes_.edges().query(box, [&](std::uint32_t number) {
      is_empty &= add(number, event, found, at_joints);
      return !is_empty;
    });
    is_nearer = !is_empty;
    if (is_nearer) return std::nullopt;
    for (const std::uint32_t vertex : straight_here_) found.erase(vertex);
    // A vertex on an edge that is met right there is nothing of its own either.
    std::erase_if(found, [&](std::uint32_t vertex) {
      const Site own = Site::of(curves_, vertex);
      return own.is_point && std::any_of(met_inside_.begin(), met_inside_.end(), [&](auto line) {
               const Site other = Site::of(curves_, line);
               return dot(other.normal, from_to(other.point, own.point)) == 0;
             });
    });
    std::erase_if(at_joints, [&](std::uint32_t vertex) { return !found.contains(vertex); });
    for (const std::uint32_t feature : features) {
      if (!found.contains(feature)) return std::nullopt;
    }
    event.features.assign(found.begin(), found.end());
    event.at_joint = !at_joints.empty();
    event.kind = kind_of(event, at_joints);
    return event;
  }

  std::uint64_t exact_signs = 0;
  bool is_nearer = false;

 private:
  const Equidistant<RootNumber>& exact(const DiagramEvent& event) {
    if (!exact_) exact_ = exact_of(curves_, event.of, spot_);
    return *exact_;
  }

  /// By intervals; then by those around the exact numbers, which may be far tighter; then by these.
  template <class InIntervals, class Exact>
  int sign_of(DiagramEvent& event, InIntervals&& in_intervals, Exact&& by_roots) {
    if (const auto certain = certified_sign(in_intervals())) return *certain;
    if (!exact_) {
      event.at = near(exact(event).at);
      event.squared_radius = tight(exact(event).squared_radius);
      if (const auto certain = certified_sign(in_intervals())) return *certain;
    }
    ++exact_signs;
    return sign(by_roots());
  }

  /// How an edge lies: whether nothing of it is nearer. What of it is as near is added.
  bool add(std::uint32_t number, DiagramEvent& event, std::set<std::uint32_t>& found,
           std::set<std::uint32_t>& at_joints) {
    const OffsetEdge& edge = curves_.edges[number];
    const auto is_of = [&](std::uint32_t feature) {
      return std::find(event.of.begin(), event.of.end(), feature) != event.of.end();
    };
    // A line and an end of it single out the place in front of the end.
    const auto foot_from = [&](const Point& from, std::uint32_t feature) {
      if (is_of(edge.feature) && is_of(feature)) return 0;
      return sign_of(
          event, [&] { return dot(edges_[number].along, event.at - numbers<Interval>(from)); },
          [&] {
            return dot(numbers<RootNumber>(edge.along),
                       exact(event).at - numbers<RootNumber>(from));
          });
    };
    const int after_start = foot_from(edge.start, edge.start_feature);
    const int after_end = after_start < 0 ? -1 : foot_from(edge.end, edge.end_feature);
    int order = 0;
    if (after_start > 0 && after_end < 0) {
      if (!is_of(edge.feature)) order = height_order(number, event);
      if (order == 0) found.insert(edge.feature);
      if (order == 0) met_inside_.insert(edge.feature);
    } else {
      const bool at_start = after_start <= 0;
      const std::uint32_t feature = at_start ? edge.start_feature : edge.end_feature;
      if (!is_of(feature)) order = distance_order(at_start ? edge.start : edge.end, event);
      if (order == 0) found.insert(feature);
      if (order == 0 && (after_start == 0 || after_end == 0) && is_in_front(number, event)) {
        found.insert(edge.feature);
        const bool is_straight = envelopes_.is_within(edge.feature, feature);
        (is_straight ? straight_here_ : at_joints).insert(feature);
      }
    }
    return order >= 0;
  }

  int distance_order(const Point& from, DiagramEvent& event) {
    return sign_of(
        event,
        [&] {
          const auto w = event.at - numbers<Interval>(from);
          return dot(w, w) - event.squared_radius;
        },
        [&] {
          const RootPoint w = exact(event).at - numbers<RootNumber>(from);
          return dot(w, w) - exact(event).squared_radius;
        });
  }

  int height_order(std::uint32_t number, DiagramEvent& event) {
    const OffsetEdge& edge = curves_.edges[number];
    return sign_of(
        event,
        [&] {
          const EdgeNumbers<Interval>& own = edges_[number];
          const Interval height = dot(own.normal, event.at - own.start);
          return height * height - event.squared_radius * own.squared_length;
        },
        [&] {
          const RootNumber height = dot(numbers<RootNumber>(edge.normal),
                                        exact(event).at - numbers<RootNumber>(edge.start));
          return height * height - exact(event).squared_radius * RootNumber(edge.squared_length);
        });
  }

  /// Not behind the line of an edge.
  bool is_in_front(std::uint32_t number, DiagramEvent& event) {
    const OffsetEdge& edge = curves_.edges[number];
    return sign_of(
               event, [&] { return dot(edges_[number].normal, event.at - edges_[number].start); },
               [&] {
                 return dot(numbers<RootNumber>(edge.normal),
                            exact(event).at - numbers<RootNumber>(edge.start));
               }) > 0;
  }

  /// By the directions of the features; in front of the end of an edge its line has that of the
  /// end.
  Kind kind_of(DiagramEvent& event, const std::set<std::uint32_t>& at_joints) {
    Features ways;
    std::copy_if(event.features.begin(), event.features.end(), std::back_inserter(ways),
                 [&](std::uint32_t feature) { return !at_joints.contains(feature); });
    bool is_inside = true, has_opposite = false;
    for (const std::uint32_t a : ways) {
      bool has_left = false, has_right = false;
      for (const std::uint32_t b : ways) {
        if (a == b) continue;
        const int turn =
            event.of.size() == 2 && event.features.size() == 2
                ? 0
                : sign_of(
                      event,
                      [&] { return cross(way<Interval>(a, event.at), way<Interval>(b, event.at)); },
                      [&] {
                        return cross(way<RootNumber>(a, exact(event).at),
                                     way<RootNumber>(b, exact(event).at));
                      });
        has_left |= turn > 0;
        has_right |= turn < 0;
        has_opposite |= turn == 0;
      }
      is_inside &= has_left && has_right;
    }
    if (is_inside && ways.size() > 2) return Kind::maximum;
    // Opposite lines are as near all along.
    const bool has_point = std::any_of(ways.begin(), ways.end(), [&](std::uint32_t feature) {
      return Site::of(curves_, feature).is_point;
    });
    if (has_opposite) return ways.size() == 2 && has_point ? Kind::saddle : Kind::ridge;
    return event.at_joint && event.features.size() == 3 ? Kind::joint : Kind::corner;
  }

  template <class N>
  Vector<N> way(std::uint32_t feature, const Vector<N>& from) const {
    const Site own = Site::of(curves_, feature);
    if (own.is_point) return numbers<N>(own.point) - from;
    return N(-1) * numbers<N>(own.normal);
  }

  const OffsetCurves& curves_;
  const ContactEnvelopes& envelopes_;
  std::vector<EdgeNumbers<Interval>> edges_;
  std::set<std::uint32_t> straight_here_, met_inside_;
  std::optional<Equidistant<RootNumber>> exact_;  ///< of the candidate that is looked at
  Spot spot_{};
};

/// Events as they are found, each once.
class Collected {
 public:
  Collected(Prover& prover, double near) : prover_(prover), near_(near) {}

  /// The number of that behind a candidate, none where that is none.
  std::uint32_t number_of(const Features& features, const Spot& spot) {
    std::vector<std::uint32_t>& known = of_candidates_[features];
    for (const std::uint32_t number : known) {
      if (off(events[number].at, spot) < near_) return number;
    }
    auto event = prover_.event(features, spot);
    if (!event) return none;
    const std::uint32_t number = add(std::move(*event));
    known.push_back(number);
    return number;
  }

  std::vector<DiagramEvent> events;

 private:
  /// Of one place where several candidates of the same features lead to it.
  std::uint32_t add(DiagramEvent event) {
    std::vector<std::uint32_t>& same = of_features_[event.features];
    for (const std::uint32_t number : same) {
      const Vector<Interval>& at = events[number].at;
      if (off(event.at, {approximate(at.x), approximate(at.y)}) < near_) return number;
    }
    same.push_back(static_cast<std::uint32_t>(events.size()));
    events.push_back(std::move(event));
    return same.back();
  }

  Prover& prover_;
  double near_;
  std::map<Features, std::vector<std::uint32_t>> of_candidates_, of_features_;
};

/// Whether two parts of a patch end in one point of the diagram. Where P touches itself there is
/// none between them.
bool meet(const FirstContact& a, const FirstContact& b) {
  return std::hypot(a.last.x - b.first.x, a.last.y - b.first.y) < near_places &&
         std::min(a.last_radius, b.first_radius) > near_places * 1e-2;
}

/// With a box of a size about 1, so that no double is beyond its range.
DiagramEvents in_unit_box(const PolygonSet& P) {
  namespace mp = boost::multiprecision;
  DiagramEvents result{{}, {0, 0}, 1, {}, 0};
  std::optional<std::pair<Point, Point>> box;
  const auto for_points = [](PolygonSet& set, auto&& look) {
    for (Polygon& polygon : set.polygons) {
      std::for_each(polygon.outer.begin(), polygon.outer.end(), look);
      for (Ring& hole : polygon.holes) std::for_each(hole.begin(), hole.end(), look);
    }
  };
  PolygonSet moved = P;
  for_points(moved, [&](const Point& p) {
    if (!box) box = {p, p};
    box->first = {std::min(box->first.x, p.x), std::min(box->first.y, p.y)};
    box->second = {std::max(box->second.x, p.x), std::max(box->second.y, p.y)};
  });
  if (box) {
    result.origin = box->first;
    const Rational size =
        std::max(Rational(box->second.x - box->first.x), Rational(box->second.y - box->first.y));
    if (size > 0) {
      const auto bits = [](const Integer& number) { return static_cast<long>(mp::msb(number)); };
      const long exponent = bits(mp::denominator(size)) - bits(mp::numerator(size));
      const Rational power(Integer(1) << static_cast<unsigned>(std::abs(exponent)));
      result.factor = exponent < 0 ? Rational(1 / power) : power;
    }
  }
  for_points(moved, [&](Point& p) {
    p = {(p.x - result.origin.x) * result.factor, (p.y - result.origin.y) * result.factor};
  });
  result.curves = offset_curves(moved);
  return result;
}

}  // namespace

Equidistant<RootNumber> DiagramEvents::exact(const DiagramEvent& event) const {
  const Spot spot{approximate(event.at.x), approximate(event.at.y)};
  const Equidistant<RootNumber> found = exact_of(curves, event.of, spot);
  const RootNumber inverse(Rational(1 / factor));
  return {inverse * found.at + numbers<RootNumber>(origin),
          inverse * inverse * found.squared_radius};
}

Vector<Interval> DiagramEvents::place(const DiagramEvent& event) const {
  return Interval(Rational(1 / factor)) * event.at + numbers<Interval>(origin);
}

Interval DiagramEvents::radius(const DiagramEvent& event) const {
  return Interval(Rational(1 / factor)) * sqrt(event.squared_radius);
}

Point DiagramEvents::vertex(std::uint32_t feature) const {
  const Point& p = curves.features[feature].centre;
  return {p.x / factor + origin.x, p.y / factor + origin.y};
}

DiagramEvents diagram_events(const PolygonSet& P, const BuildOptions& options) {
  DiagramEvents result = in_unit_box(P);
  const OffsetCurves& curves = result.curves;
  const ContactEnvelopes envelopes(curves);
  const BuildControl control(options, "the events");
  std::vector<std::vector<FirstContact>> contacts(curves.patches.size());
  in_parallel(contacts.size(), control, BuildProgress::Stage::patches, [&](unsigned) {
    return [&](std::size_t k) { contacts[k] = envelopes.of(static_cast<std::uint32_t>(k)); };
  });
  Prover prover(curves, envelopes);
  Collected collected(prover, near_places);
  const auto proven = [&](Features features, const Spot& spot) {
    std::sort(features.begin(), features.end());
    const std::uint32_t number = collected.number_of(features, spot);
    // Three that are as near at no place: points on one line meet at infinity.
    if (number == none && prover.is_nearer) refuse();
    return number;
  };
  // Where one patch goes on as the next.
  std::vector<std::uint32_t> at_start(contacts.size(), none), at_end(contacts.size(), none);
  for (std::uint32_t k = 0; k < curves.patches.size(); ++k) {
    const std::uint32_t next = curves.patches[k].next;
    if (next == OffsetPatch::none || contacts[k].empty() || contacts[next].empty()) continue;
    const FirstContact &a = contacts[k].back(), &b = contacts[next].front();
    const std::uint32_t own = curves.patches[k].feature, other = curves.patches[next].feature;
    if (!meet(a, b) || (own == other && a.feature == b.feature)) continue;
    at_start[next] = at_end[k] = own == other ? proven({own, a.feature, b.feature}, a.last)
                                              : proven({own, other, a.feature}, a.last);
  }
  using Half = std::array<std::uint32_t, 3>;  // a feature, the one that it meets, an event
  std::set<Half> halves;
  for (std::uint32_t k = 0; k < curves.patches.size(); ++k) {
    control.look();
    const std::uint32_t own = curves.patches[k].feature;
    const std::vector<FirstContact>& parts = contacts[k];
    std::uint32_t before = at_start[k];
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const FirstContact& part = parts[i];
      std::uint32_t after = none;
      if (i + 1 == parts.size()) {
        after = at_end[k];
      } else if (meet(part, parts[i + 1])) {
        after = proven({own, part.feature, parts[i + 1].feature}, part.last);
      }
      if (before != after || before == none) {
        for (const std::uint32_t event : {before, after}) {
          if (event != none) halves.insert({own, part.feature, event});
        }
      }
      if (part.has_least) {
        collected.number_of({std::min(own, part.feature), std::max(own, part.feature)}, part.least);
      }
      before = after;
    }
  }
  // A part of the diagram ends where both of its sides say, but where that is an end of a side.
  for (const auto& [own, other, event] : halves) {
    const DiagramEvent& found = collected.events[event];
    if (!found.at_joint && !halves.contains({other, own, event})) refuse();
  }
  result.events = std::move(collected.events);
  std::sort(result.events.begin(), result.events.end(),
            [&](const DiagramEvent& a, const DiagramEvent& b) {
              if (a.squared_radius.upper() < b.squared_radius.lower()) return true;
              if (a.squared_radius.lower() > b.squared_radius.upper()) return false;
              const int order =
                  compare(result.exact(a).squared_radius, result.exact(b).squared_radius);
              return order != 0 ? order < 0 : a.features < b.features;
            });
  result.exact_signs = prover.exact_signs;
  return result;
}

}  // namespace minkref::inline disc
