// The degree of incompatibility of a facet and a vertex, as printed and corrected (Sec. 6).
#pragma once

#include <cstdint>
#include <optional>

#include "reference/form.hpp"
#include "reference/space/convex/convex_polyhedron.hpp"

namespace minkref::inline space {

/// IC(f, v) with the witness.
struct Incompatibility {
  /// The squared distance to the plane through v parallel to f, measured on S P for a facet f of P.
  Rational squared_degree;
  std::uint32_t witness;  ///< the half-edge at v whose other end is that far away
};

/// The incompatibility degree of P's facet and Q's vertex, with P scaled (Behar & Lien 2012, Sec.
/// 6: IC(f, v) = max d(e, f) over the edges e at v).
///
/// - printed: d(e, f) is the longest Euclidean distance from e to the plane, on whichever side. So
///   the witness may lead down; and at the apex of an octahedron, over a horizontal facet, where
///   the paper does not define it, it is not 0.
/// - corrected: only what lies above the plane counts; the degree is 0, and the witness level or
///   below, exactly where no edge at v rises above the plane.
///
/// The greatest is the first among equals in half-edge order. Exact. O(degree of v).
Incompatibility incompatibility(const ConvexPolyhedron& P, std::uint32_t facet,
                                const ConvexPolyhedron& Q, std::uint32_t vertex,
                                const Scaling& scaling, Form form);

/// Descends on the degree, each time along the witness, until no edge rises above the facet's
/// plane, or until a vertex recurs: the result is then empty, which `corrected` never gives. Ties
/// stay unbroken: among several farthest vertices the first one met is the answer.
std::optional<std::uint32_t> descend(const ConvexPolyhedron& P, std::uint32_t facet,
                                     const ConvexPolyhedron& Q, std::uint32_t vertex,
                                     const Scaling& scaling, Form form);

}  // namespace minkref::inline space
