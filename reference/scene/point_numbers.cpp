#include "reference/scene/point_numbers.hpp"

#include <algorithm>
#include <bit>

#include "reference/no_entry.hpp"

namespace minkref::inline scene {
namespace {

/// Equal points have the same nearest doubles.
std::uint64_t digest(const FilteredPoint& point) {
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U;
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };
  const std::uint64_t x = bits(point.x()) * odd;
  const std::uint64_t both = (std::rotl(x, 29) ^ bits(point.y())) * odd;
  return both ^ (both >> 32);  // short numbers have only zeros in their low bits
}

bool equal(const FilteredPoint& a, const FilteredPoint& b) {
  return a.x() == b.x() && a.y() == b.y() && a.exact() == b.exact();
}

}  // namespace

std::uint32_t PointNumbers::find(const FilteredPoint& point, std::uint64_t digest) const {
  if (first_.empty()) return no_entry;
  std::uint32_t at = first_[digest & (first_.size() - 1)];
  while (at != no_entry && (digests_[at] != digest || !equal(*points_[at], point))) at = next_[at];
  return at;
}

std::uint32_t PointNumbers::find(const FilteredPoint& point) const {
  return find(point, digest(point));
}

void PointNumbers::grow() {
  first_.assign(std::max<std::size_t>(2 * first_.size(), 64), no_entry);
  for (std::uint32_t k = 0; k < size(); ++k) {
    std::uint32_t& first = first_[digests_[k] & (first_.size() - 1)];
    next_[k] = first;
    first = k;
  }
}

std::uint32_t PointNumbers::number(const FilteredPoint& point) {
  const std::uint64_t own = digest(point);
  if (const std::uint32_t known = find(point, own); known != no_entry) return known;
  if (points_.size() >= first_.size()) grow();
  const std::uint32_t at = size();
  std::uint32_t& first = first_[own & (first_.size() - 1)];
  points_.push_back(&point);
  digests_.push_back(own);
  next_.push_back(first);
  first = at;
  return at;
}

}  // namespace minkref::inline scene
