// Differences of moving facets' corners, and normals, as words of 128 bits or as integers.
#pragma once

#include <array>
#include <type_traits>

#include "reference/space/critical/moving_facet.hpp"

namespace minkref::inline space {

/// slope s + height.
template <class T>
struct MovingHeight {
  T slope, height;
};

/// `T` is Int128, for a convolution with words, or Integer.
template <class T>
class ExactCorners {
 public:
  static constexpr bool is_in_words = std::is_same_v<T, Int128>;
  using Step = std::conditional_t<is_in_words, WordVector, IntegerVector>;
  using Normal = std::array<T, 3>;
  using Corner = ConvolutionFacet::Corner;

  explicit ExactCorners(const MovingConvolution& convolution) : convolution_(convolution) {}

  /// From a corner to the next, up to the scale.
  Step along(const MovingFacet& facet, std::size_t k) const {
    const Corner &a = facet.names[k], &b = facet.names[(k + 1) % facet.size];
    return a.of_P != b.of_P ? of_P(b) - of_P(a) : of_Q(b) - of_Q(a);
  }

  /// Up to a factor above 0.
  Normal normal(const MovingFacet& facet) const {
    if constexpr (is_in_words) {
      return cross(along(facet, 0), along(facet, 1));
    } else {
      return facet.normal.exact;
    }
  }

  /// How far corner b lies beyond corner a along a direction.
  MovingHeight<T> height(const Normal& n, const Corner& a, const Corner& b) const {
    return {product(n, of_P(b) - of_P(a)), product(n, of_Q(b) - of_Q(a))};
  }

  static T product(const Normal& n, const Step& v) {
    return T(n[0] * v[0] + n[1] * v[1] + n[2] * v[2]);
  }

 private:
  const Step& of_P(const Corner& corner) const {
    if constexpr (is_in_words) {
      return convolution_.words->P[corner.of_P];
    } else {
      return convolution_.P.points[corner.of_P].exact;
    }
  }
  const Step& of_Q(const Corner& corner) const {
    if constexpr (is_in_words) {
      return convolution_.words->Q[corner.of_Q];
    } else {
      return convolution_.Q.points[corner.of_Q].exact;
    }
  }

  const MovingConvolution& convolution_;
};

}  // namespace minkref::inline space
