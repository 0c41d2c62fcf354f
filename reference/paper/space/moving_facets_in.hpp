// Facets of the reduced convolution at all scales, with one arithmetic.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/number/scalar.hpp"
#include "reference/paper/space/two_facets.hpp"
#include "reference/space/critical/moving_facet.hpp"

namespace minkref::inline space {

/// An integer vector, each coordinate the arithmetic's nearest number.
template <class T>
Eigen::Matrix<T, 3, 1> vector_in(const IntegerVector& v, const Arithmetic<T>& in) {
  return {in(Rational(v[0])), in(Rational(v[1])), in(Rational(v[2]))};
}

/// The corners s p + q of each facet, in the unit of the operands' integers: one over their common
/// denominator, so that products of short decimals are not rounded. Linear.
template <class T>
std::vector<typename TwoFacets<T>::Facet> facets_in(const MovingConvolution& convolution,
                                                    const Arithmetic<T>& in) {
  std::vector<typename TwoFacets<T>::Facet> facets;
  facets.reserve(convolution.facets.size());
  for (const MovingFacet& facet : convolution.facets) {
    auto& corners = facets.emplace_back();
    for (std::size_t k = 0; k < facet.size; ++k) {
      const auto& [of_P, of_Q] = facet.names[k];
      corners.push_back({vector_in(convolution.P.points[of_P].exact, in),
                         vector_in(convolution.Q.points[of_Q].exact, in), of_P, of_Q});
    }
  }
  return facets;
}

}  // namespace minkref::inline space
