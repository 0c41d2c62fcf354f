// How deep a reflex vertex lies behind the bridges of its feature.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reference/disc/features/bridge.hpp"

namespace minkref::inline disc {

/// A squared distance, top / bottom.
template <class N>
struct SquaredDistance {
  N top, bottom;
};

/// Returns the squared distance of a point from a bridge's line.
template <class N>
SquaredDistance<N> squared_distance(const Vector<N>& from, const Chord<N>& bridge) {
  const Vector<N> along = bridge.to - bridge.from;
  const N area = cross(along, from - bridge.from);
  return {area * area, dot(along, along)};
}

/// A vertex's least squared distance from some bridges' lines at a radius; infinite without a
/// bridge; 0 for a leaf without a vertex. Exact: intervals, then a field with roots (RootNumber),
/// quick at equal numbers, then, beyond most_roots, Surd. Congruent figures are equal without.
class LeafDepth {
 public:
  /// 0.
  LeafDepth() = default;
  /// `bridges`, `halves` and `radius` must outlive it. O(n) for n halves.
  LeafDepth(const Bridges& bridges, const Point& vertex, const std::vector<std::uint32_t>& halves,
            const BridgeRadius& radius);

  /// The sign of a - b. Throws LimitExceeded ("too-many-roots") beyond the bits of a Surd.
  friend int compare(const LeafDepth& a, const LeafDepth& b);

  bool is_zero() const { return halves_ == nullptr; }
  bool is_infinite() const { return halves_ != nullptr && halves_->empty(); }
  /// Encloses a finite depth, within the frame.
  Interval near() const;
  /// The squared depth within the frame, at a given radius; requires a depth not infinite.
  RootNumber exact() const { return is_zero() ? RootNumber(0) : nearest_half().exact.value(); }

 private:
  struct Half {
    std::size_t number;
    std::optional<RootNumber> exact;  ///< empty beyond the roots of a field
  };
  /// Numbers that tell a distance at one radius: equal for a bridge and its mirror image.
  using Shape = std::array<Rational, 4>;
  std::optional<Shape> shape(std::size_t number) const;
  Half of_half(std::size_t number) const;
  const Half& nearest_half() const;
  template <class N>
  SquaredDistance<N> distance(std::size_t number) const;
  static int order(const LeafDepth& a, const Half& x, const LeafDepth& b, const Half& y);

  const Bridges* bridges_ = nullptr;
  const std::vector<std::uint32_t>* halves_ = nullptr;
  Point vertex_{};
  const BridgeRadius* radius_ = nullptr;
  std::vector<Interval> near_;  ///< by half
  mutable std::optional<Half> nearest_;
};

int compare(const LeafDepth& a, const LeafDepth& b);

}  // namespace minkref::inline disc
