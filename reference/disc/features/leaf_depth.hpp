// How deep a reflex vertex lies behind the bridges of its feature.
#pragma once

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

/// The least squared distance of a vertex from the lines of some bridges at one radius; infinite
/// without a bridge; 0 for a leaf that is no vertex. Exact: by intervals, then by roots.
class LeafDepth {
 public:
  /// 0.
  LeafDepth() = default;
  /// `bridges` and `halves` must outlive it. O(n) for n halves.
  LeafDepth(const Bridges& bridges, const Point& vertex, const std::vector<std::uint32_t>& halves,
            const BridgeRadius& radius);

  /// The sign of a - b. Surds beyond their limit of bits throw LimitExceeded ("too-many-roots").
  friend int compare(const LeafDepth& a, const LeafDepth& b);

  bool is_zero() const { return halves_ == nullptr; }
  bool is_infinite() const { return halves_ != nullptr && halves_->empty(); }
  /// Encloses a finite depth, within the frame.
  Interval near() const;
  /// One of the halves whose bridges are nearest, of a depth neither 0 nor infinite.
  std::uint32_t nearest() const;

 private:
  SquaredDistance<Surd> of_half(std::size_t k) const;
  const SquaredDistance<Surd>& exact() const;
  std::size_t nearest_number() const;

  const Bridges* bridges_ = nullptr;
  const std::vector<std::uint32_t>* halves_ = nullptr;
  Point vertex_{};
  const BridgeRadius* radius_ = nullptr;
  std::vector<Interval> near_;  ///< by half
  mutable std::optional<SquaredDistance<Surd>> exact_;
};

int compare(const LeafDepth& a, const LeafDepth& b);

}  // namespace minkref::inline disc
