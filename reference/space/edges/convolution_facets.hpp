// The reduced convolution in space: the facets that contain the sum's boundary (Sec. 3).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/space/edges/operand.hpp"

namespace minkref::inline space {

/// fv: P's triangle at Q's vertex. vf: P's vertex at Q's triangle. ee: the parallelogram between an
/// edge of P and an edge of Q (docs/definitions.md, "In space").
enum class FacetKind : std::uint8_t { fv, vf, ee };

/// A convex facet with the sum below, on the side away from the normal.
struct ConvolutionFacet {
  /// A corner adds a vertex of P and a vertex of Q.
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

/// A segment where facets end: one operand's edge at the other operand's vertex.
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

/// Finds all compatible pairs. Ties break as if a vanishing linear map in general position moved P
/// (docs/convex-polyhedra.md). The facets contain the boundary of P ⊕ Q, and the sum lies below
/// each facet. At most one operand has no volume. Exact. O(|P| |Q|).
Convolution convolution_facets(const SpaceOperand& P, const SpaceOperand& Q);

/// Leaves out the marked facets, and clears the uses of every side where such a facet ends.
void leave_out(Convolution& convolution, const std::vector<bool>& facets);

}  // namespace minkref::inline space
