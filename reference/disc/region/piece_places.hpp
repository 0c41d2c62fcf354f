// Numbers the places where boundary pieces start.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "reference/disc/distance/static_offset.hpp"

namespace minkref::inline disc {

/// Numbers all pieces' starts; starts at one place share a number. Exact. O(n log n), and O(k^2)
/// for k starts that doubles do not tell apart.
class PiecePlaces {
 public:
  explicit PiecePlaces(const StaticOffset& offset)
      : offset_(offset), numbers_(offset.pieces.size()) {
    std::vector<Vector<Interval>> near;
    for (const OffsetPiece& piece : offset.pieces) {
      near.push_back(offset.at->position(piece.patch, piece.from));
    }
    std::iota(numbers_.begin(), numbers_.end(), 0U);
    std::vector<std::uint32_t> order = numbers_;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return near[a].x.lower() < near[b].x.lower();
    });
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (std::size_t l = k + 1; l < order.size(); ++l) {
        const std::uint32_t a = order[k], b = order[l];
        if (near[b].x.lower() > near[a].x.upper()) break;
        if (numbers_[b] == b && overlap(near[a].y, near[b].y) && are_same_point(a, b)) {
          numbers_[b] = numbers_[a];
        }
      }
    }
  }

  std::uint32_t of_start(std::uint32_t piece) const { return numbers_[piece]; }

 private:
  static bool overlap(const Interval& a, const Interval& b) {
    return a.lower() <= b.upper() && b.lower() <= a.upper();
  }
  RootPoint point(std::uint32_t piece) const {
    const OffsetPiece& own = offset_.pieces[piece];
    return offset_.at->point(own.patch, own.from);
  }
  bool are_same_point(std::uint32_t a, std::uint32_t b) const {
    return are_same(point(a), point(b));
  }

  const StaticOffset& offset_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace minkref::inline disc
