#include "reference/space/edges/boundary_edges.hpp"

#include <algorithm>
#include <chrono>

namespace minkref::inline space {
namespace {

/// The point of the line with the parameter of a cut, as point / weight; weight > 0.
std::pair<IntegerVector, Integer> exact_point(const CarrierLine& carrier, const Cut& cut) {
  const LineIn<Integer>& line = carrier.as<Integer>();
  if (cut.plane.facet == nullptr) {
    return {cut.end == 0 ? line.origin : line.origin + line.direction, line.weight};
  }
  auto [num, den] = carrier.parameter<Integer>(cut.plane);
  if (den.sign() < 0) {
    num = -num;
    den = -den;
  }
  return {den * line.origin + num * line.direction, Integer(den * line.weight)};
}

}  // namespace

EdgeStatistics BoundaryEdgeSearch::statistics() const {
  EdgeStatistics result{cutting_.signs,     pieces_,
                        candidates_,        collision_.tests,
                        collision_.covered, nanoseconds_of_tests_};
  result.signs.add(collision_.signs);
  return result;
}

SpacePoint BoundaryEdgeSearch::point_at(const Cut& cut) const {
  const auto [point, weight] = exact_point(cutting_.line(), cut);
  return {Rational(point[0], weight), Rational(point[1], weight), Rational(point[2], weight)};
}

/// The sign of direction · (a x b) for the vectors of two rays.
int BoundaryEdgeSearch::turn(const Ray& a, const Ray& b) {
  if (a.facet == b.facet) return 0;
  const int sign = filtered_sign(cutting_.signs, [&]<class T>(std::type_identity<T>) {
    return dot(cutting_.line().as<T>().direction,
               cross(facets_[a.facet].normal.as<T>(), facets_[b.facet].normal.as<T>()));
  });
  return sign * a.sign * b.sign;
}

/// Sorts the rays counter-clockwise about the line, from the first ray on.
void BoundaryEdgeSearch::sort_rays(const CarrierPiece& piece) {
  rays_.clear();
  for (const AlongFacet& along : piece.facets) {
    if (along.ahead) rays_.push_back({along.facet, 1});
    if (along.behind) rays_.push_back({along.facet, -1});
  }
  const Ray first = rays_.front();
  const auto in_second_half = [&](const Ray& ray) {
    const int side = turn(first, ray);
    if (side != 0) return side < 0;
    const int along = filtered_sign(cutting_.signs, [&]<class T>(std::type_identity<T>) {
      return dot(facets_[first.facet].normal.as<T>(), facets_[ray.facet].normal.as<T>());
    });
    return along * first.sign * ray.sign < 0;
  };
  const auto middle = std::stable_partition(rays_.begin(), rays_.end(),
                                            [&](const Ray& ray) { return !in_second_half(ray); });
  const auto before = [&](const Ray& a, const Ray& b) { return turn(a, b) > 0; };
  std::stable_sort(rays_.begin(), middle, before);
  std::stable_sort(middle, rays_.end(), before);
  bundles_.clear();
  const auto half = static_cast<std::size_t>(middle - rays_.begin());
  for (std::size_t k = 0; k < rays_.size(); ++k) {
    if (k == 0 || k == half || turn(rays_[k - 1], rays_[k]) != 0) bundles_.push_back(k);
  }
  bundles_.push_back(rays_.size());
}

void BoundaryEdgeSearch::look_along(const std::vector<CarrierPiece>& pieces) {
  for (const CarrierPiece& piece : pieces) {
    ++pieces_;
    sort_rays(piece);
    const std::size_t count = bundles_.size() - 1;
    if (count < 2) continue;
    const auto all = [&](std::size_t bundle, int sign) {
      return std::all_of(rays_.begin() + static_cast<std::ptrdiff_t>(bundles_[bundle]),
                         rays_.begin() + static_cast<std::ptrdiff_t>(bundles_[bundle + 1]),
                         [&](const Ray& ray) { return ray.sign == sign; });
    };
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t next = (k + 1) % count;
      if (!all(k, -1) || !all(next, 1)) continue;
      const Ray first = rays_[bundles_[k]], second = rays_[bundles_[next]];
      const int angle = turn(first, second);
      if (angle == 0) continue;  // flat: no edge
      ++candidates_;
      if (!is_outside(piece, first, second, angle > 0)) continue;
      edges.push_back({point_at(piece.from), point_at(piece.to), first.facet, second.facet});
    }
  }
}

/// Whether the sector from the first ray to the second lies outside the sum; both facets face into
/// the sector. `narrow`: the sector spans less than a half-space.
bool BoundaryEdgeSearch::is_outside(const CarrierPiece& piece, const Ray& first, const Ray& second,
                                    bool narrow) {
  const bool at_end = piece.to.plane.facet == nullptr && piece.from.plane.facet != nullptr;
  const Cut& cut = at_end ? piece.to : piece.from;
  const NudgedPoint x(cutting_.line().point_at(cut.t), [&]() -> NudgedPoint::Exact {
    auto [point, weight] = exact_point(cutting_.line(), cut);
    const IntegerVector& direction = cutting_.line().as<Integer>().direction;
    const IntegerVector &n = facets_[first.facet].normal.exact,
                        &m = facets_[second.facet].normal.exact;
    return {point, weight, at_end ? IntegerVector{} - direction : direction,
            narrow ? cross(direction, m - n) : n + m};
  });
  const auto began = std::chrono::steady_clock::now();
  const bool contained = collision_.contains(x);
  const std::chrono::nanoseconds spent = std::chrono::steady_clock::now() - began;
  nanoseconds_of_tests_ += static_cast<std::uint64_t>(spent.count());
  return !contained;
}

}  // namespace minkref::inline space
