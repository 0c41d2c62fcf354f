#include "reference/disc/distance/blocked_part.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "reference/error.hpp"

namespace minkref::inline disc {
namespace {

using At = PatchPlace::At;

Interval near(const Interval& value) { return value; }
Interval near(const RootNumber& value) { return value.enclosure(); }

std::vector<BlockedPart> touch(const PatchPlace& place) {
  if (place.at != At::inside) return {};
  return {{place, place}};
}

}  // namespace

PatchesAt::PatchesAt(OffsetCurves curves, const Rational& squared_radius)
    : curves_(std::move(curves)),
      squared_radius_(squared_radius),
      near_squared_radius_(squared_radius),
      radius_(sqrt(near_squared_radius_)),
      first_arc_(static_cast<std::size_t>(std::ranges::count_if(
          curves_.patches, [](const auto& patch) { return patch.edge != OffsetPatch::none; }))) {
  for (const OffsetEdge& edge : curves_.edges) edges_.emplace_back(edge, squared_radius);
  for (std::size_t k = first_arc_; k < curves_.patches.size(); ++k) {
    arcs_.emplace_back(curves_.patches[k], squared_radius);
  }
}

template <class N>
std::vector<Crossing<N>> PatchesAt::crossings(std::uint32_t number, std::uint32_t by) const {
  const OffsetPatch& patch = curves_.patches[number];
  const OffsetEdge& other = curves_.edges[by];
  const auto add_to = [&](PatchCrossings<N>& found, const auto& own) {
    if (patch.edge == OffsetPatch::none) return;
    const OffsetEdge& edge = curves_.edges[patch.edge];
    const auto has = [&](std::uint32_t circle) {
      return edge.start_feature == circle || edge.end_feature == circle;
    };
    found.add_of_line(own, has(other.start_feature), has(other.end_feature));
  };
  if constexpr (std::is_same_v<N, Interval>) {
    PatchCrossings<N> found(near_squared_radius_, edges_[by]);
    if (patch.edge == OffsetPatch::none) {
      found.add_of_arc(arcs_[number - first_arc_]);
    } else {
      add_to(found, edges_[patch.edge]);
    }
    return found.found();
  } else {
    const N squared_radius(squared_radius_);
    const EdgeNumbers<N> others(other, squared_radius_);
    PatchCrossings<N> found(squared_radius, others);
    if (patch.edge == OffsetPatch::none) {
      found.add_of_arc(ArcNumbers<N>(patch, squared_radius_));
    } else {
      EdgeNumbers<N> own(curves_.edges[patch.edge], squared_radius_);
      // A point alone has no lines beside it, and no reach.
      if (other.squared_length != 0) own.reach = sqrt(joined(own.squared_reach, others.reach));
      add_to(found, own);
    }
    return found.found();
  }
}

std::uint32_t PatchesAt::feature_of(const OffsetEdge& by, NearCurve curve) const {
  switch (curve) {
    case NearCurve::start:
      return by.start_feature;
    case NearCurve::end:
      return by.end_feature;
    case NearCurve::outside:
      return by.feature;
    case NearCurve::inside:
      break;
  }
  return OffsetPatch::none;
}

/// The keys of a patch's start and end.
template <class N>
std::pair<N, N> PatchesAt::ends(std::uint32_t number) const {
  if (curves_.patches[number].edge != OffsetPatch::none) return {N(0), N(1)};
  if constexpr (std::is_same_v<N, Interval>) {
    const ArcNumbers<N>& arc = arcs_[number - first_arc_];
    return {arc.first, arc.last};
  } else {
    const ArcNumbers<N> arc(curves_.patches[number], squared_radius_);
    return {arc.first, arc.last};
  }
}

/// The point at the start (-1), the end (1) or the middle (0) of a patch.
template <class N>
Vector<N> PatchesAt::joint(std::uint32_t number, int end) const {
  const OffsetPatch& patch = curves_.patches[number];
  if (patch.edge != OffsetPatch::none) {
    const OffsetEdge& own = curves_.edges[patch.edge];
    const N out = sqrt(N(Rational(squared_radius_ / own.squared_length)));
    return numbers<N>(own.start) + N(Rational(end + 1, 2)) * numbers<N>(own.along) +
           out * numbers<N>(own.normal);
  }
  const Direction way = end < 0 ? patch.first : end > 0 ? patch.last : middle_of(patch);
  return numbers<N>(patch.centre) +
         sqrt(N(Rational(squared_radius_ / dot(way, way)))) * numbers<N>(way);
}

template <class N>
int PatchesAt::distance_at(std::uint32_t patch, std::uint32_t by, int end) const {
  const EdgeNumbers<N> edge(curves_.edges[by], squared_radius_);
  Vector<N> x = joint<N>(patch, end);
  return sign_of_distance(edge, x, N(squared_radius_));
}

template <class N>
PatchPlace PatchesAt::place_of(std::uint32_t patch, std::uint32_t by,
                               const Crossing<N>& crossing) const {
  const auto [first, last] = ends<N>(patch);
  const int from = order(crossing.key, first), to = order(crossing.key, last);
  if (from <= 0) return from < 0 ? At::before : At::start;
  if (to >= 0) return to > 0 ? At::beyond : At::end;
  PatchPlace place(At::inside);
  place.curve = crossing.curve;
  place.way = crossing.way;
  place.by = by;
  place.feature = feature_of(curves_.edges[by], crossing.curve);
  place.near = near(crossing.key);
  place.position = {near(crossing.point.x), near(crossing.point.y)};
  if constexpr (std::is_same_v<N, RootNumber>) {
    place.exact =
        std::make_shared<const PatchPlace::Exact>(PatchPlace::Exact{crossing.key, crossing.point});
  }
  return place;
}

const PatchPlace::Exact& PatchesAt::exact(std::uint32_t patch, const PatchPlace& place) const {
  if (!place.exact) {
    for (const Crossing<RootNumber>& each : crossings<RootNumber>(patch, place.by)) {
      if (each.curve != place.curve || each.way != place.way) continue;
      place.exact =
          std::make_shared<const PatchPlace::Exact>(PatchPlace::Exact{each.key, each.point});
    }
  }
  if (!place.exact) throw std::logic_error("doubles and roots tell different crossings");
  return *place.exact;
}

int PatchesAt::compare(std::uint32_t patch, const PatchPlace& a, const PatchPlace& b,
                       OffsetCounts& counts) const {
  if (a.at != b.at) return a.at < b.at ? -1 : 1;
  if (a.at != At::inside) return 0;
  if (a.near.upper() < b.near.lower()) return -1;
  if (a.near.lower() > b.near.upper()) return 1;
  if (a.feature != OffsetPatch::none && a.feature == b.feature && a.way == b.way) return 0;
  ++counts.exact_orders;
  return minkref::compare(exact(patch, a).key, exact(patch, b).key);
}

RootPoint PatchesAt::point(std::uint32_t patch, const PatchPlace& place) const {
  if (place.at == At::inside) return exact(patch, place).point;
  return joint<RootNumber>(patch, place.at == At::end ? 1 : -1);
}

Vector<Interval> PatchesAt::position(std::uint32_t patch, const PatchPlace& place) const {
  if (place.at == At::inside) return place.position;
  return joint<Interval>(patch, place.at == At::end ? 1 : -1);
}

Interval PatchesAt::key_of_normal(std::uint32_t arc, const Direction& normal) const {
  return ArcNumbers<Interval>::bound(curves_.patches[arc], normal, squared_radius_);
}

RootNumber PatchesAt::exact_key_of_normal(std::uint32_t arc, const Direction& normal) const {
  return ArcNumbers<RootNumber>::bound(curves_.patches[arc], normal, squared_radius_);
}

RootPoint PatchesAt::tangent(std::uint32_t number, const RootPoint& at) const {
  const OffsetPatch& patch = curves_.patches[number];
  if (patch.edge != OffsetPatch::none) return numbers<RootNumber>(curves_.edges[patch.edge].along);
  return turned(at - numbers<RootNumber>(patch.centre));
}

bool PatchesAt::turns_before(std::uint32_t from, const RootPoint& at, std::uint32_t a,
                             std::uint32_t b) const {
  const RootPoint back = tangent(from, at);  // the way it comes is the reverse
  const RootPoint of_a = tangent(a, at), of_b = tangent(b, at);
  const auto turn = [](const RootPoint& u, const RootPoint& v) { return sign(cross(u, v)); };
  // Clockwise from the reverse of `back`: first those on the left of `back`, then itself, then the
  // right, last the reverse.
  const auto part = [&](const RootPoint& v) {
    const int side = turn(back, v);
    if (side != 0) return side > 0 ? 0 : 2;
    return sign(dot(back, v)) > 0 ? 1 : 3;
  };
  const int part_of_a = part(of_a), part_of_b = part(of_b);
  return part_of_a != part_of_b ? part_of_a < part_of_b : turn(of_a, of_b) < 0;
}

bool PatchesAt::may_be_ridge(std::uint32_t patch, std::uint32_t by) const {
  const EdgeNumbers<Interval>&own = edges_[curves_.patches[patch].edge], &other = edges_[by];
  if (certified_sign(cross(other.along, own.along)).value_or(0) != 0) return false;
  const Interval height = dot(other.normal, own.start - other.start);
  return certified_sign(height * height - Interval(4) * other.squared_reach).value_or(0) == 0;
}

/// The part where another edge's offset line coincides, run the other way: the sum lies on both
/// sides.
std::optional<BlockedPart> PatchesAt::ridge(std::uint32_t patch, std::uint32_t number) const {
  if (!may_be_ridge(patch, number)) return std::nullopt;
  const OffsetEdge &own = curves_.edges[curves_.patches[patch].edge], &by = curves_.edges[number];
  const Rational way = dot(by.along, own.along);
  const Direction across = from_to(by.start, own.start);
  const Rational height = dot(by.normal, across);
  if (cross(by.along, own.along) != 0 || way >= 0 || height <= 0 ||
      height * height != 4 * squared_radius_ * by.squared_length) {
    return std::nullopt;
  }
  const Rational foot = dot(by.along, across);
  const auto place = [&](const Rational& at, NearCurve curve, std::uint32_t feature) -> PatchPlace {
    if (at <= 0) return at < 0 ? At::before : At::start;
    if (at >= 1) return at > 1 ? At::beyond : At::end;
    PatchPlace found(At::inside);
    found.curve = curve;
    found.by = number;
    found.feature = feature;
    const RootPoint from = joint<RootNumber>(patch, -1);
    const RootPoint x = from + RootNumber(at) * numbers<RootNumber>(own.along);
    found.near = Interval(at);
    found.position = {x.x.enclosure(), x.y.enclosure()};
    found.exact = std::make_shared<const PatchPlace::Exact>(PatchPlace::Exact{at, x});
    return found;
  };
  // Here the other edge's line passes into the circles about the edge's ends.
  BlockedPart part{place((by.squared_length - foot) / way, NearCurve::end, by.end_feature),
                   place(-foot / way, NearCurve::start, by.start_feature)};
  const bool is_aside = part.low.at >= At::end || part.high.at <= At::start;
  return is_aside ? std::nullopt : std::optional(part);
}

template <class N>
std::vector<BlockedPart> PatchesAt::blocked_of_line(std::uint32_t patch, std::uint32_t by) const {
  const std::vector<Crossing<N>> found = crossings<N>(patch, by);
  const Crossing<N>*least = nullptr, *greatest = nullptr;
  for (const Crossing<N>& each : found) {
    if (each.touches) {
      const PatchPlace place = place_of(patch, by, each);
      return touch(place);
    }
    if (least == nullptr || order(each.key, least->key) < 0) least = &each;
    if (greatest == nullptr || order(each.key, greatest->key) > 0) greatest = &each;
  }
  if (least == nullptr || order(least->key, greatest->key) == 0) return {};
  const BlockedPart part{place_of(patch, by, *least), place_of(patch, by, *greatest)};
  if (part.low.at >= At::end || part.high.at <= At::start) return {};
  return {part};
}

template <class N>
std::vector<BlockedPart> PatchesAt::blocked_of_arc(std::uint32_t patch, std::uint32_t by) const {
  std::optional<PatchPlace> low, high;
  std::optional<N> low_key, high_key;
  const auto take = [](std::optional<PatchPlace>& end, std::optional<N>& end_key,
                       const PatchPlace& place, const N& key, int wanted) {
    if (end && order(key, *end_key) * wanted <= 0) return;
    end = place;
    end_key = key;
  };
  for (const Crossing<N>& each : crossings<N>(patch, by)) {
    const PatchPlace place = place_of(patch, by, each);
    if (each.touches) return touch(place);
    if (each.enters && place.at >= At::start && place.at < At::end) {
      take(low, low_key, place, each.key, -1);
    }
    if (!each.enters && place.at > At::start && place.at <= At::end) {
      take(high, high_key, place, each.key, 1);
    }
  }
  if (!low && !high) {
    for (const int end : {0, -1, 1}) {
      const int at = distance_at<N>(patch, by, end);
      if (at < 0) return {{At::before, At::beyond}};
      if (at > 0) return {};
    }
    return {};
  }
  if (!low) return {{At::before, *high}};
  if (!high) return {{*low, At::beyond}};
  if (order(*low_key, *high_key) < 0) return {{*low, *high}};
  return {{At::before, *high}, {*low, At::beyond}};
}

template <class N>
std::vector<BlockedPart> PatchesAt::blocked_in(std::uint32_t patch, std::uint32_t by) const {
  return curves_.patches[patch].edge != OffsetPatch::none ? blocked_of_line<N>(patch, by)
                                                          : blocked_of_arc<N>(patch, by);
}

std::vector<BlockedPart> PatchesAt::blocked(std::uint32_t number, std::uint32_t by,
                                            OffsetCounts& counts) const {
  const OffsetPatch& patch = curves_.patches[number];
  const OffsetEdge& other = curves_.edges[by];
  ++counts.pairs;
  if (patch.edge == by) return {};
  // An arc turns away from the edges at its centre.
  if (patch.edge == OffsetPatch::none &&
      (other.start_feature == patch.feature || other.end_feature == patch.feature)) {
    return {};
  }
  if (patch.edge != OffsetPatch::none) {
    if (auto part = ridge(number, by)) return {*part};
  }
  try {
    return blocked_in<Interval>(number, by);
  } catch (const UndecidedSign&) {
    ++counts.exact_pairs;
    return blocked_in<RootNumber>(number, by);
  }
}

}  // namespace minkref::inline disc
