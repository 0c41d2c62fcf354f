// The reduced convolution in space: the facets that contain the sum's boundary (Sec. 3).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "reference/space/edges/flat_pieces.hpp"
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
  /// A flat face's piece may have rational corners: adds their denominators, and each side's line
  /// as an integer point and a direction.
  struct Piece {
    std::array<FilteredVector, 4> starts, alongs;
    std::array<Integer, 4> weights;
  };
  FacetKind kind;
  std::uint8_t size;            ///< of its corners, 3 or 4
  std::uint32_t of_P, of_Q;     ///< a triangle, edge or vertex of each operand
  std::array<Corner, 4> names;  ///< counter-clockwise seen from above
  /// A piece's exact corners are multiplied by their weights.
  std::array<FilteredVector, 4> corners;
  std::array<std::uint32_t, 4> sides;  ///< of Convolution::sides, from each corner to the next
  FilteredVector normal;
  FilteredInteger offset;  ///< its plane is normal · x = offset
  SpaceBox box;
  std::shared_ptr<const Piece> piece;  ///< null for a triangle or a parallelogram

  /// An integer point on a side's line.
  template <class T>
  const std::array<T, 3>& start(std::size_t side) const {
    return (piece ? piece->starts[side] : corners[side]).template as<T>();
  }
  /// A side's direction.
  template <class T>
  std::array<T, 3> along(std::size_t side) const {
    if (piece) return piece->alongs[side].template as<T>();
    return corners[side + 1 == size ? 0 : side + 1].as<T>() - corners[side].as<T>();
  }
  /// A corner is corners[k].as<T>() / weight<T>(k).
  template <class T>
  T weight(std::size_t corner) const {
    if constexpr (std::is_same_v<T, Integer>) {
      if (piece) return piece->weights[corner];
    }
    return T(1);
  }
  /// Has the sign that tells whether another facet's corner lies above the plane.
  template <class T>
  T height(const ConvolutionFacet& other, std::size_t corner) const {
    const T at = dot(normal.as<T>(), other.corners[corner].as<T>());
    if (!other.piece) return at - offset.as<T>();
    return at - other.weight<T>(corner) * offset.as<T>();
  }

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
  std::uint32_t unnamed = 0;  ///< corners of pieces that are no vertices
  SignCounts signs;
};

/// Finds all compatible pairs. Ties break as if a vanishing linear map in general position moved P
/// (docs/convex-polyhedra.md). The facets contain the boundary of P ⊕ Q, and the sum lies below
/// each facet. At most one operand has no volume. Exact. O(|P| |Q|).
Convolution convolution_facets(const SpaceOperand& P, const SpaceOperand& Q);

/// Replaces triangles with pieces for a body's flat faces, P's or Q's. A piece's side along an edge
/// takes the edge's number if further facets end there, else a number for itself.
void put_pieces(Convolution& convolution, const FlatPieces& pieces, const SpaceOperand& body,
                const SpaceOperand& other, bool of_P);

/// Leaves out the marked facets, and clears the uses of every side where such a facet ends.
void leave_out(Convolution& convolution, const std::vector<bool>& facets);

}  // namespace minkref::inline space
