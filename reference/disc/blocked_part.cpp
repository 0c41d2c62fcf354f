#include "reference/disc/blocked_part.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "reference/number/radicals/root_order.hpp"

namespace minkref::inline disc {
namespace {

RootNumber dot(const Direction& a, const RootPoint& b) {
  return RootNumber(a.x) * b.x + RootNumber(a.y) * b.y;
}
RootPoint moved(const Point& from, const Direction& way, const RootNumber& far) {
  return {RootNumber(from.x) + RootNumber(way.x) * far,
          RootNumber(from.y) + RootNumber(way.y) * far};
}
RootPoint operator+(const RootPoint& a, const RootPoint& b) { return {a.x + b.x, a.y + b.y}; }
RootPoint operator-(const RootPoint& a, const Point& b) {
  return {a.x - RootNumber(b.x), a.y - RootNumber(b.y)};
}
RootPoint times(const Direction& way, const RootNumber& far) {
  return {RootNumber(way.x) * far, RootNumber(way.y) * far};
}
RootPoint from_centre(const Point& centre, const RootPoint& way) {
  return {RootNumber(centre.x) + way.x, RootNumber(centre.y) + way.y};
}

/// The direction about which an arc is, and that along which its points are in order.
Direction middle_of(const OffsetPatch& arc) {
  return {arc.first.x + arc.last.x, arc.first.y + arc.last.y};
}

/// The sign of the distance to a closed edge, squared, less the squared radius.
int sign_of_distance(const OffsetEdge& edge, const RootPoint& x, const Rational& squared_radius) {
  const RootPoint w = x - edge.start;
  const RootNumber foot = dot(edge.along, w);
  const auto about = [&](const RootPoint& v) {
    return sign(v.x * v.x + v.y * v.y - RootNumber(squared_radius));
  };
  if (sign(foot) <= 0) return about(w);
  if (sign(foot - RootNumber(edge.squared_length)) >= 0) return about(x - edge.end);
  const RootNumber height = dot(edge.normal, w);
  return sign(height * height - RootNumber(squared_radius * edge.squared_length));
}

}  // namespace

int PatchPlace::compare(const PatchPlace& other) const {
  if (at_ != other.at_) return at_ < other.at_ ? -1 : 1;
  if (at_ != At::inside) return 0;
  if (near_.upper() < other.near_.lower()) return -1;
  if (near_.lower() > other.near_.upper()) return 1;
  return minkref::compare(key_, other.key_);
}

/// Of the boundary of what is near an edge. `enters`: of an arc, which runs counter-clockwise,
/// whether it comes to what is nearer.
struct PatchesAt::Crossing {
  RootNumber key;
  RootPoint point;
  bool enters;
  std::uint32_t feature;  ///< none on the inner side of the edge
};

PatchesAt::PatchesAt(const OffsetCurves& curves, const Rational& squared_radius)
    : curves_(curves), squared_radius_(squared_radius) {}

/// Of the half circle about an end of an edge.
void PatchesAt::add_circle_crossings(const OffsetPatch& patch, const OffsetEdge& by, bool at_end,
                                     std::vector<Crossing>& found) const {
  const Point& q = at_end ? by.end : by.start;
  const std::uint32_t feature = at_end ? by.end_feature : by.start_feature;
  const auto is_beyond = [&](const RootPoint& x) {
    const int foot = sign(dot(by.along, x - q));
    return at_end ? foot >= 0 : foot <= 0;
  };
  if (patch.edge != OffsetPatch::none) {
    const OffsetEdge& own = curves_.edges[patch.edge];
    const Direction w = from_to(q, own.start);
    const Rational height = dot(w, own.normal);
    const RootNumber reach = sqrt(RootNumber(squared_radius_ * own.squared_length));
    const RootNumber square = RootNumber(-height * height) - RootNumber(2 * height) * reach;
    if (sign(square) <= 0) return;  // it touches at most
    const RootNumber root = sqrt(square);
    const RootNumber middle(-dot(w, own.along));
    for (const int side : {-1, 1}) {
      const RootNumber u = (middle + RootNumber(side) * root) / RootNumber(own.squared_length);
      const RootPoint x = moved(own.start, own.along, u) +
                          times(own.normal, reach / RootNumber(own.squared_length));
      if (is_beyond(x)) found.push_back({u, x, side < 0, feature});
    }
    return;
  }
  const Direction w = from_to(patch.centre, q);
  const Rational square = dot(w, w);
  if (square == 0) return;
  const Rational left = squared_radius_ / square - Rational(1, 4);
  if (left <= 0) return;
  const RootNumber root = sqrt(RootNumber(left));
  const Direction middle = middle_of(patch);
  for (const int side : {-1, 1}) {
    const RootPoint y =
        times(w, RootNumber(Rational(1, 2))) + times(turned(w), RootNumber(side) * root);
    if (sign(dot(middle, y)) <= 0 || !is_beyond(from_centre(patch.centre, y))) continue;
    found.push_back({dot(turned(middle), y), from_centre(patch.centre, y), side < 0, feature});
  }
}

/// Of the side that is parallel to the edge, outside (1) or inside (-1) of P.
void PatchesAt::add_line_crossings(const OffsetPatch& patch, const OffsetEdge& by, int side,
                                   std::vector<Crossing>& found) const {
  const std::uint32_t feature = side > 0 ? by.feature : OffsetPatch::none;
  const RootNumber reach = sqrt(RootNumber(squared_radius_ * by.squared_length));
  const auto is_beside = [&](const RootPoint& x) {
    const RootNumber foot = dot(by.along, x - by.start);
    return sign(foot) >= 0 && sign(foot - RootNumber(by.squared_length)) <= 0;
  };
  if (patch.edge != OffsetPatch::none) {
    const OffsetEdge& own = curves_.edges[patch.edge];
    const Rational slope = dot(by.normal, own.along);
    if (slope == 0) return;
    // The length of the other edge in the field of the reach of this one.
    const RootNumber own_reach =
        sqrt(RootNumber(squared_radius_ * own.squared_length).in(reach.field()));
    const RootNumber out = own_reach / RootNumber(own.squared_length);
    const RootNumber u = (RootNumber(dot(by.normal, from_to(own.start, by.start))) +
                          RootNumber(side) * reach - out * RootNumber(dot(by.normal, own.normal))) /
                         RootNumber(slope);
    const RootPoint x = moved(own.start, own.along, u) + times(own.normal, out);
    if (is_beside(x)) found.push_back({u, x, false, feature});
    return;
  }
  const Rational height = dot(by.normal, from_to(patch.centre, by.start));
  const RootNumber level = RootNumber(height) + RootNumber(side) * reach;
  const RootNumber square = RootNumber(squared_radius_ * by.squared_length) - level * level;
  if (sign(square) <= 0) return;
  const RootNumber root = sqrt(square);
  const Direction middle = middle_of(patch);
  for (const int way : {-1, 1}) {
    const RootNumber inverse(Rational(1) / by.squared_length);
    const RootPoint y =
        times(by.normal, level * inverse) + times(by.along, RootNumber(way) * root * inverse);
    if (sign(dot(middle, y)) <= 0 || !is_beside(from_centre(patch.centre, y))) continue;
    found.push_back(
        {dot(turned(middle), y), from_centre(patch.centre, y), way * side > 0, feature});
  }
}

/// Of the start (-1), the end (1) or the middle (0) of a patch.
RootPoint PatchesAt::joint(const OffsetPatch& patch, int end) const {
  if (patch.edge != OffsetPatch::none) {
    const OffsetEdge& own = curves_.edges[patch.edge];
    const RootNumber out =
        sqrt(RootNumber(squared_radius_ * own.squared_length)) / RootNumber(own.squared_length);
    return moved(own.start, own.along, RootNumber(Rational(end + 1, 2))) + times(own.normal, out);
  }
  const Direction way = end < 0 ? patch.first : end > 0 ? patch.last : middle_of(patch);
  return moved(patch.centre, way, sqrt(RootNumber(squared_radius_ / dot(way, way))));
}

RootPoint PatchesAt::point(std::size_t patch, const PatchPlace& place) const {
  if (place.at() == PatchPlace::At::inside) return place.point();
  return joint(curves_.patches[patch], place.at() == PatchPlace::At::end ? 1 : -1);
}

RootPoint PatchesAt::tangent(const OffsetPatch& patch, const RootPoint& at) const {
  if (patch.edge != OffsetPatch::none) {
    const Direction& along = curves_.edges[patch.edge].along;
    return {RootNumber(along.x), RootNumber(along.y)};
  }
  const RootPoint out = at - patch.centre;
  return {-out.y, out.x};
}

bool PatchesAt::turns_before(std::size_t from, const RootPoint& at, std::size_t a,
                             std::size_t b) const {
  const RootPoint back = tangent(curves_.patches[from], at);  // the way it comes is the reverse
  const RootPoint of_a = tangent(curves_.patches[a], at), of_b = tangent(curves_.patches[b], at);
  const auto turn = [](const RootPoint& u, const RootPoint& v) {
    return sign(u.x * v.y - u.y * v.x);
  };
  // Clockwise from the reverse of `back`: first those on the left of `back`, then itself, then the
  // right, last the reverse.
  const auto part = [&](const RootPoint& v) {
    const int side = turn(back, v);
    if (side != 0) return side > 0 ? 0 : 2;
    return sign(back.x * v.x + back.y * v.y) > 0 ? 1 : 3;
  };
  const int part_of_a = part(of_a), part_of_b = part(of_b);
  return part_of_a != part_of_b ? part_of_a < part_of_b : turn(of_a, of_b) < 0;
}

/// Whether the start, the end or the middle of a patch is nearer to an edge than the radius (-1),
/// as near (0) or farther (1).
int PatchesAt::inside_at(const OffsetPatch& patch, const OffsetEdge& by, int end) const {
  return sign_of_distance(by, joint(patch, end), squared_radius_);
}

/// The key of a joint.
RootNumber PatchesAt::arc_bound(const OffsetPatch& patch, const Direction& normal) const {
  const Rational along = dot(turned(middle_of(patch)), normal);
  return RootNumber(along) * sqrt(RootNumber(squared_radius_ / dot(normal, normal)));
}

/// Where the offset line of another edge is the same, run the other way: the sum is on both sides.
std::optional<BlockedPart> PatchesAt::ridge(const OffsetPatch& patch, const OffsetEdge& by) const {
  const OffsetEdge& own = curves_.edges[patch.edge];
  const Rational way = dot(by.along, own.along);
  const Direction across = from_to(by.start, own.start);
  const Rational height = dot(by.normal, across);
  if (cross(by.along, own.along) != 0 || way >= 0 || height <= 0 ||
      height * height != 4 * squared_radius_ * by.squared_length) {
    return std::nullopt;
  }
  const Rational foot = dot(by.along, across);
  const Rational u = (by.squared_length - foot) / way, v = -foot / way;
  using At = PatchPlace::At;
  const auto place = [&](const Rational& at) -> PatchPlace {
    if (at < 0) return At::before;
    if (at > 1) return At::beyond;
    if (at == 0 || at == 1) return at == 0 ? At::start : At::end;
    const RootPoint from = joint(patch, -1);
    return PatchPlace(RootNumber(at), from + times(own.along, RootNumber(at)));
  };
  BlockedPart part{place(u), place(v), {by.feature}, {by.feature}};
  if (part.low.compare(At::end) >= 0 || part.high.compare(At::start) <= 0) return std::nullopt;
  return part;
}

std::vector<BlockedPart> PatchesAt::blocked(std::size_t number, const OffsetEdge& by) const {
  const OffsetPatch& patch = curves_.patches[number];
  using At = PatchPlace::At;
  const bool is_edge = patch.edge != OffsetPatch::none;
  // An arc turns away from the edges at its centre.
  if (!is_edge && (by.start_feature == patch.feature || by.end_feature == patch.feature)) return {};
  if (is_edge) {
    if (auto part = ridge(patch, by)) return {*part};
  }
  std::vector<Crossing> found;
  add_circle_crossings(patch, by, false, found);
  add_circle_crossings(patch, by, true, found);
  add_line_crossings(patch, by, 1, found);
  add_line_crossings(patch, by, -1, found);

  const RootNumber first = is_edge ? RootNumber(0) : arc_bound(patch, patch.first),
                   last = is_edge ? RootNumber(1) : arc_bound(patch, patch.last);
  const auto place_of = [&](const Crossing& crossing) -> PatchPlace {
    const int from = compare(crossing.key, first), to = compare(crossing.key, last);
    if (from < 0) return At::before;
    if (from == 0) return At::start;
    if (to > 0) return At::beyond;
    if (to == 0) return At::end;
    return PatchPlace(crossing.key, crossing.point);
  };
  // Of a line the least and the greatest, of an arc what it enters and leaves by.
  std::optional<PatchPlace> low, high;
  BlockedPart part{At::before, At::beyond, {}, {}};
  const auto take = [&](std::optional<PatchPlace>& end, const PatchPlace& place, int wanted,
                        std::vector<std::uint32_t>& features, std::uint32_t feature) {
    const int order = end ? place.compare(*end) : wanted;
    if (order * wanted < 0) return;
    if (order != 0) features.clear();
    if (order != 0) end = place;
    if (feature != OffsetPatch::none) features.push_back(feature);
  };
  if (is_edge) {
    std::optional<RootNumber> least, greatest;
    for (const Crossing& each : found) {
      if (!least || compare(each.key, *least) < 0) least = each.key;
      if (!greatest || compare(each.key, *greatest) > 0) greatest = each.key;
    }
    if (!least || compare(*least, *greatest) == 0) return {};
    for (const Crossing& each : found) {
      if (compare(each.key, *least) == 0) {
        take(low, place_of(each), -1, part.low_features, each.feature);
      }
      if (compare(each.key, *greatest) == 0) {
        take(high, place_of(each), 1, part.high_features, each.feature);
      }
    }
    part.low = *low;
    part.high = *high;
    const bool is_aside = part.low.compare(At::end) >= 0 || part.high.compare(At::start) <= 0;
    if (is_aside) return {};
    return {part};
  }
  for (const Crossing& each : found) {
    const PatchPlace place = place_of(each);
    if (place.at() == At::before || place.at() == At::beyond) continue;
    take(each.enters ? low : high, place, each.enters ? -1 : 1,
         each.enters ? part.low_features : part.high_features, each.feature);
  }
  const bool enters = low && low->at() != At::end, leaves = high && high->at() != At::start;
  if (!enters && !leaves) {
    for (const int end : {0, -1, 1}) {
      const int at = inside_at(patch, by, end);
      if (at < 0) return {part};
      if (at > 0) return {};
    }
    return {};
  }
  if (enters) part.low = *low;
  if (leaves) part.high = *high;
  if (!enters) part.low_features.clear();
  if (!leaves) part.high_features.clear();
  if (!enters || !leaves || part.low.compare(part.high) < 0) return {part};
  return {{At::before, part.high, {}, part.high_features},
          {part.low, At::beyond, part.low_features, {}}};
}

}  // namespace minkref::inline disc
