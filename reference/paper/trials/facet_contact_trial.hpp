// The paper's way to the events of two facets (Behar & Lien 2012, Sec. 5.1, 5.2) with its own
// arithmetic, on trial against the exact events.
#pragma once

#include <cstdint>
#include <string>

#include "reference/paper/space/facet_readings.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref {

struct FacetContactTrial {
  std::uint64_t pairs = 0;            ///< of facets
  std::uint64_t parallel_pairs = 0;   ///< of `pairs`: parallel, and coplanar at one scale at most
  std::uint64_t coplanar_pairs = 0;   ///< of `pairs`: coplanar at all scales
  std::uint64_t undecided_pairs = 0;  ///< the arithmetic could not tell a sign; left out below

  // The systems of three equations for s.
  std::uint64_t roots = 0;               ///< with a root, in truth
  std::uint64_t false_inconsistent = 0;  ///< of `roots`: answered "inconsistent"
  std::uint64_t false_identity = 0;      ///< of `roots`: answered "identity"
  std::uint64_t invented_roots = 0;      ///< a root answered, but none in truth

  // Events with s > 0, one for each corner and each two sides; two for sides of coplanar facets.
  std::uint64_t events = 0;  ///< in truth
  std::uint64_t missed = 0;  ///< in truth, and nothing is answered for its scale
  // The part of `missed` with nothing to solve: a singular matrix.
  std::uint64_t parallel_faces = 0;    ///< the faces are parallel
  std::uint64_t parallel_sides = 0;    ///< the sides are, and the faces are not
  std::uint64_t side_along_plane = 0;  ///< a side is parallel to the other face's plane only
  std::uint64_t invented = 0;          ///< answered, not in truth
  std::uint64_t misplaced = 0;         ///< answered, off by more than an ulp of the scale
};

/// Tries all pairs of facets of the convolution of sP and Q; the truth is that of all readings
/// corrected and rational numbers. "rational", "interval", "double" or "mpfr:BITS". O(N^2) pairs,
/// of up to 40 systems each; refuses operands with more than some thousand facets.
FacetContactTrial facet_contact_trial(const Polyhedron& P, const Polyhedron& Q,
                                      const std::string& arithmetic, const FacetReadings& readings);

}  // namespace minkref
