#include "reference/disc/region/exact_pieces.hpp"

#include "reference/interrupt.hpp"

namespace minkref::inline disc {

std::vector<ExactPiece> exact_pieces(const OffsetRegion& region, const OffsetRing& ring) {
  const PatchesAt& at = *region.offset.at;
  std::vector<ExactPiece> found;
  for (const std::uint32_t number : ring.pieces) {
    look_for_interrupt();
    const OffsetPiece& piece = region.offset.pieces[number];
    found.push_back({&at.curves().patches[piece.patch], at.point(piece.patch, piece.from), {}});
  }
  for (std::size_t k = 0; k < found.size(); ++k) {
    found[k].to = found[k + 1 == found.size() ? 0 : k + 1].from;
  }
  return found;
}

}  // namespace minkref::inline disc
