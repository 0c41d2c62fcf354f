#include "reference/space/surface/space_vertex.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline space {

SharedPoints shared_points(std::vector<SpaceVertex> given) {
  std::vector<std::uint32_t> order(given.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    look_for_interrupt();
    return compare(given[a], given[b]) < 0;
  });
  SharedPoints shared;
  shared.number.resize(given.size());
  for (const std::uint32_t k : order) {
    if (shared.points.empty() || compare(shared.points.back(), given[k]) != 0) {
      shared.points.push_back(std::move(given[k]));
    }
    shared.number[k] = static_cast<std::uint32_t>(shared.points.size() - 1);
  }
  return shared;
}

FilteredPlane::FilteredPlane(OrientedPlane plane)
    : exact(std::move(plane)),
      normal{BoundedDouble(exact.normal[0]), BoundedDouble(exact.normal[1]),
             BoundedDouble(exact.normal[2])},
      offset(bounded(exact.offset)) {}

int FilteredPlane::side(const SpaceVertex& vertex) const {
  const int certain = (dot(normal, vertex.rounded) - offset).certain_sign();
  return certain != BoundedDouble::undecided ? certain : sign(height(vertex.exact));
}

SpacePoint FilteredPlane::crossing(const SpacePoint& p, const SpacePoint& q) const {
  const Rational above = height(p), part = above / (above - height(q));
  return {p.x + part * (q.x - p.x), p.y + part * (q.y - p.y), p.z + part * (q.z - p.z)};
}

Rational FilteredPlane::height(const SpacePoint& point) const {
  const IntegerVector& n = exact.normal;
  return Rational(n[0]) * point.x + Rational(n[1]) * point.y + Rational(n[2]) * point.z -
         exact.offset;
}

}  // namespace minkref::inline space
