#include "reference/plane/left_rays.hpp"

#include "reference/interrupt.hpp"

namespace minkref::inline plane {
namespace {

/// Equal points have overlapping boxes, since rounding is monotone.
Box point_box(const FilteredPoint& point) { return {point.x(), point.y(), point.x(), point.y()}; }

}  // namespace

const FilteredPoint& LeftRays::low(std::uint32_t e) const {
  const Edge& edge = edges_[e];
  return compare_y(*edge.from, *edge.to) <= 0 ? *edge.from : *edge.to;
}

const FilteredPoint& LeftRays::high(std::uint32_t e) const {
  const Edge& edge = edges_[e];
  return compare_y(*edge.from, *edge.to) <= 0 ? *edge.to : *edge.from;
}

/// For two edges, none level, across a common height.
bool LeftRays::is_right_of(std::uint32_t g, std::uint32_t h) const {
  const FilteredPoint &g0 = low(g), &g1 = high(g), &h0 = low(h), &h1 = high(h);
  if (compare_y(g0, h0) >= 0) {
    const int side = orientation(h0, h1, g0);
    return side != 0 ? side < 0 : orientation(h0, h1, g1) < 0;
  }
  const int side = orientation(g0, g1, h0);
  return side != 0 ? side > 0 : orientation(g0, g1, h1) > 0;
}

bool LeftRays::touches(std::uint32_t e, const FilteredPoint& point) const {
  const FilteredPoint &a = *edges_[e].from, &b = *edges_[e].to;
  return compare_y(a, point) * compare_y(b, point) <= 0 &&
         compare_x(a, point) * compare_x(b, point) <= 0 && orientation(a, b, point) == 0;
}

bool LeftRays::passes_left_of(std::uint32_t e, const FilteredPoint& point) const {
  const FilteredPoint &lower = low(e), &upper = high(e);
  return compare_y(lower, point) <= 0 && compare_y(point, upper) < 0 &&
         orientation(lower, upper, point) < 0;
}

void LeftRays::grow_tree() {
  std::vector<Box> boxes;
  boxes.reserve(edges_.size());
  for (const Edge& edge : edges_) {
    boxes.push_back(point_box(*edge.from));
    boxes.back().add(point_box(*edge.to));
  }
  tree_ = RayTree(std::move(boxes));
}

LeftRays::Hit LeftRays::first(const FilteredPoint& point,
                              const std::function<bool(std::uint32_t)>& counts) {
  Hit hit;
  const auto passes = [&](std::uint32_t e) {
    look_for_interrupt();
    if (!counts(e)) return false;
    hit.touches = hit.touches || touches(e, point);
    return passes_left_of(e, point);
  };
  if (++asked_ < rays_before_a_tree) {
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (passes(e) && (hit.edge == no_entry || is_right_of(e, hit.edge))) hit.edge = e;
    }
    return hit;
  }
  if (tree_.size() == 0) grow_tree();
  hit.edge = tree_.first(point_box(point), passes, [&](std::uint32_t e, std::uint32_t other) {
    return is_right_of(e, other);
  });
  return hit;
}

}  // namespace minkref::inline plane
