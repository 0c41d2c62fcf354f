// The reduced convolution in space: the facets of which the boundary of a sum is a part (Sec. 3).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/space/edges/operand.hpp"

namespace minkref::inline space {

/// fv: a triangle of P at a vertex of Q. vf: a vertex of P at a triangle of Q. ee: the
/// parallelogram of an edge of P and an edge of Q (docs/definitions.md, "In space").
enum class FacetKind : std::uint8_t { fv, vf, ee };

/// A convex facet with the sum below it, that is, on the side away from its normal.
struct ConvolutionFacet {
  /// A corner is the sum of a vertex of P and a vertex of Q.
  struct Corner {
    std::uint32_t of_P, of_Q;
    friend bool operator==(const Corner&, const Corner&) = default;
  };
  FacetKind kind;
  std::uint8_t size;            ///< of its corners, 3 or 4
  std::uint32_t of_P, of_Q;     ///< a triangle, edge or vertex of each operand
  std::array<Corner, 4> names;  ///< counter-clockwise seen from above
  std::array<FilteredVector, 4> corners;
  std::array<std::uint32_t, 4> sides;  ///< of Convolution::sides, from each corner to the next
  FilteredVector normal;
  FilteredInteger offset;  ///< its plane is normal · x = offset
  SpaceBox box;

  bool has_corner(const Corner& name) const {
    for (std::size_t k = 0; k < size; ++k) {
      if (names[k] == name) return true;
    }
    return false;
  }
};

/// A segment in which facets end: an edge of one operand at a vertex of the other.
struct FacetSide {
  ConvolutionFacet::Corner from, to;
  struct Use {
    std::uint32_t facet;
    std::uint8_t side;
  };
  std::vector<Use> uses;
};

struct Convolution {
  long shift = 0;  ///< of the doubles of coordinates
  std::vector<ConvolutionFacet> facets;
  std::vector<FacetSide> sides;
  SignCounts signs;
};

/// All compatible pairs. Ties are those of P moved by a vanishing linear map in general position
/// (docs/convex-polyhedra.md). The boundary of P ⊕ Q lies in the facets, and the sum below each of
/// them. At most one operand has no volume. Exact. O(|P| |Q|).
Convolution convolution_facets(const SpaceOperand& P, const SpaceOperand& Q);

/// Leaves facets out, and sides in which they end: these are left without uses.
void leave_out(Convolution& convolution, const std::vector<bool>& facets);

}  // namespace minkref::inline space
