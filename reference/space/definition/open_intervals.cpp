#include "reference/space/definition/open_intervals.hpp"

#include <algorithm>
#include <utility>

namespace minkref::inline space {
namespace {

bool same(const SolidCorner& a, const SolidCorner& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (compare_along(a, b, axis) != 0) return false;
  }
  return true;
}

/// factor a + other b.
IntegerVector plus(const Integer& factor, const IntegerVector& a, const Integer& other,
                   const IntegerVector& b) {
  IntegerVector sum;
  for (std::size_t k = 0; k < 3; ++k) sum[k] = factor * a[k] + other * b[k];
  return sum;
}

/// The order of points along a segment.
class Order {
 public:
  explicit Order(const CornerSegment& segment) {
    while (axis_ < 2 && compare_along(segment.from, segment.to, axis_) == 0) ++axis_;
    sign_ = compare_along(segment.from, segment.to, axis_) > 0 ? -1 : 1;
  }
  int operator()(const SolidCorner& a, const SolidCorner& b) const {
    return sign_ * compare_along(a, b, axis_);
  }

 private:
  std::size_t axis_ = 0;
  int sign_ = 1;
};

/// The segment's part within a body's interior; the part may include an end of the segment.
struct Interval {
  SolidCorner from, to;
  bool has_from, has_to;
};

std::optional<Interval> open_interval(const CornerSegment& segment, const SumBody& body) {
  CornerSegment part = segment;
  if (!clip(part, body) || part.is_point()) return std::nullopt;
  const bool on_border = std::any_of(body.facets.begin(), body.facets.end(), [&](auto& facet) {
    return facet.plane.side(part.from) == 0 && facet.plane.side(part.to) == 0;
  });
  if (on_border) return std::nullopt;
  return Interval{part.from, part.to, is_inside(part.from, body), is_inside(part.to, body)};
}

}  // namespace

bool CornerSegment::is_point() const { return same(from, to); }

bool is_inside(const SolidCorner& corner, const SumBody& body) {
  return std::all_of(body.facets.begin(), body.facets.end(),
                     [&](const SumFacet& facet) { return facet.plane.side(corner) < 0; });
}

std::optional<CornerSegment> crossing(const CornerRing& ring, const CuttingPlane& plane) {
  const RingSides sides = sides_of(ring, plane);
  std::vector<SolidCorner> found;
  bool flat = true;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const std::size_t next = (k + 1) % ring.size();
    if (sides.sides[k] == 0) found.push_back(ring[k]);
    flat = flat && sides.sides[k] == 0;
    if (sides.sides[k] * sides.sides[next] < 0) found.push_back(plane.meeting(ring[k], ring[next]));
  }
  if (flat || found.empty()) return std::nullopt;
  return CornerSegment{found.front(), found.back()};
}

bool clip(CornerSegment& segment, const SumBody& body) {
  for (const SumFacet& facet : body.facets) {
    const int from = facet.plane.side(segment.from), to = facet.plane.side(segment.to);
    if (from > 0 && to > 0) return false;
    if (from <= 0 && to <= 0) continue;
    const SolidCorner end =
        from == 0 ? segment.from
                  : (to == 0 ? segment.to : facet.plane.meeting(segment.from, segment.to));
    (from > 0 ? segment.from : segment.to) = end;
  }
  return true;
}

std::vector<CornerSegment> left_open(const CornerSegment& segment,
                                     const std::vector<SumBody>& bodies,
                                     const std::vector<std::uint32_t>& among) {
  if (segment.is_point()) {
    const bool covered = std::any_of(among.begin(), among.end(), [&](std::uint32_t b) {
      return is_inside(segment.from, bodies[b]);
    });
    return covered ? std::vector<CornerSegment>{} : std::vector{segment};
  }
  std::vector<Interval> intervals;
  for (const std::uint32_t b : among) {
    const auto interval = open_interval(segment, bodies[b]);
    if (!interval) continue;
    if (interval->has_from && interval->has_to) return {};
    intervals.push_back(*interval);
  }
  const Order order(segment);
  std::sort(intervals.begin(), intervals.end(), [&](const Interval& a, const Interval& b) {
    const int first = order(a.from, b.from);
    return first != 0 ? first < 0 : a.has_from && !b.has_from;
  });
  std::vector<CornerSegment> left;
  SolidCorner reached = segment.from;  // in no interval so far
  for (const Interval& interval : intervals) {
    const int gap = order(interval.from, reached);
    if (gap > 0 || (gap == 0 && !interval.has_from)) left.push_back({reached, interval.from});
    if (interval.has_to) return left;
    if (order(interval.to, reached) > 0) reached = interval.to;
  }
  left.push_back({reached, segment.to});
  return left;
}

std::vector<CornerSegment> cut_at_bodies(const CornerSegment& segment,
                                         const std::vector<SumBody>& bodies,
                                         const std::vector<std::uint32_t>& among) {
  std::vector<SolidCorner> cuts{segment.from, segment.to};
  for (const std::uint32_t b : among) {
    CornerSegment part = segment;
    if (!clip(part, bodies[b])) continue;
    cuts.push_back(part.from);
    cuts.push_back(part.to);
  }
  const Order order(segment);
  std::sort(cuts.begin(), cuts.end(),
            [&](const SolidCorner& a, const SolidCorner& b) { return order(a, b) < 0; });
  std::vector<CornerSegment> pieces;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (order(cuts[k], cuts[k + 1]) != 0) pieces.push_back({cuts[k], cuts[k + 1]});
  }
  return pieces;
}

SolidCorner middle_of(const CornerSegment& segment) {
  const auto& [a, v] = *segment.from.exact;
  const auto& [b, w] = *segment.to.exact;
  return solid_corner(plus(w, a, v, b), 2 * v * w);
}

IntegerVector direction_of(const CornerSegment& segment) {
  const auto& [a, v] = *segment.from.exact;
  const auto& [b, w] = *segment.to.exact;
  IntegerVector along = primitive(plus(v, b, Integer(-w), a));
  if (along < IntegerVector{0, 0, 0}) along = {-along[0], -along[1], -along[2]};
  return along;
}

}  // namespace minkref::inline space
