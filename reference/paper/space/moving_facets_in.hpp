// The facets of the reduced convolution at all scales, in one arithmetic.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/number/scalar.hpp"
#include "reference/paper/space/two_facets.hpp"
#include "reference/space/critical/moving_facet.hpp"

namespace minkref::inline space {

/// An integer vector over a denominator, each coordinate the arithmetic's nearest number.
template <class T>
Eigen::Matrix<T, 3, 1> vector_in(const IntegerVector& v, const Integer& denominator,
                                 const Arithmetic<T>& in) {
  const auto number = [&](const Integer& c) { return in(Rational(c, denominator)); };
  return {number(v[0]), number(v[1]), number(v[2])};
}

/// The corners s p + q of each facet, over the denominator of the operands. Linear.
template <class T>
std::vector<typename TwoFacets<T>::Facet> facets_in(const MovingConvolution& convolution,
                                                    const Integer& denominator,
                                                    const Arithmetic<T>& in) {
  std::vector<typename TwoFacets<T>::Facet> facets;
  facets.reserve(convolution.facets.size());
  for (const MovingFacet& facet : convolution.facets) {
    auto& corners = facets.emplace_back();
    for (std::size_t k = 0; k < facet.size; ++k) {
      const auto& [of_P, of_Q] = facet.names[k];
      corners.push_back({vector_in(convolution.P.points[of_P].exact, denominator, in),
                         vector_in(convolution.Q.points[of_Q].exact, denominator, in), of_P, of_Q});
    }
  }
  return facets;
}

}  // namespace minkref::inline space
