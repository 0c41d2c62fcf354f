// The point of a small hull that is nearest to the origin, in plain floating point.
#pragma once

#include <array>
#include <vector>

namespace minkref {

using NearVector = std::array<double, 3>;

inline double dot(const NearVector& a, const NearVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The nearest point to the origin of the hull of one to four points; keeps those of them whose
/// hull has it in its inside. Null where the origin lies in a tetrahedron. A guess: rounded, with
/// no bound.
NearVector nearest_in_hull(std::vector<NearVector>& points);

}  // namespace minkref
