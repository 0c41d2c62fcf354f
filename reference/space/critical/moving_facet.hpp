// Facets of the reduced convolution as P is scaled about the origin (Sec. 5).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/space/edges/convolution_facets.hpp"
#include "reference/space/word_vectors.hpp"

namespace minkref::inline space {

/// A convex facet at all scales s > 0: the corners are s p + q, and the normal does not depend on
/// s. Neither does the list of facets, as only directions decide.
struct MovingFacet {
  FacetKind kind;
  std::uint8_t size;                              ///< of its corners, 3 or 4
  std::uint32_t of_P, of_Q;                       ///< a triangle, edge or vertex of each operand
  std::array<ConvolutionFacet::Corner, 4> names;  ///< counter-clockwise seen from above
  FilteredVector normal;
  /// From each corner to the next, up to a factor that is above zero at all scales.
  std::array<FilteredVector, 4> along;
};

/// The facets of sP ⊕ Q, and the vertices of P and Q that name the corners.
struct MovingConvolution {
  MovingConvolution(const SpaceOperand& P, const SpaceOperand& Q);

  const SpaceOperand &P, &Q;  ///< must outlive it
  std::vector<MovingFacet> facets;
  /// The vertices of P and Q, if scales of two-facet events fit into words of 128 bits.
  struct Words {
    std::vector<WordVector> P, Q;
    unsigned bits;  ///< of the longest coordinate
  };
  std::optional<Words> words;
};

/// Whether a facet lies on one side of another facet's plane from one scale to another, as far as
/// doubles tell: heights change evenly.
bool stays_aside(const MovingConvolution& convolution, const MovingFacet& flat,
                 const MovingFacet& other, const BoundedDouble& from, const BoundedDouble& to);

}  // namespace minkref::inline space
