// A line that carries boundary edges, as bounded doubles and, if these fail, as integers.
#pragma once

#include <optional>

#include "reference/space/edges/convolution_facets.hpp"

namespace minkref::inline space {

/// The points (origin + t direction) / weight, weight > 0.
template <class T>
struct LineIn {
  std::array<T, 3> origin, direction;
  T weight;
};

/// A plane as linear form: normal · x = offset.
template <class T>
struct FormIn {
  std::array<T, 3> normal;
  T offset;
};

/// A facet's plane, or the plane across the facet through a side, with the inside above.
struct CutterPlane {
  static constexpr int own = -1;
  const ConvolutionFacet* facet = nullptr;
  int side = own;

  template <class T>
  FormIn<T> form() const {
    const std::array<T, 3>& normal = facet->normal.as<T>();
    if (side == own) return {normal, facet->offset.as<T>()};
    const auto k = static_cast<std::size_t>(side);
    const std::array<T, 3> inwards = cross(normal, facet->along<T>(k));
    return {inwards, dot(inwards, facet->start<T>(k))};
  }
};

class CarrierLine {
 public:
  /// Through a side, t from 0 to 1 along it.
  CarrierLine(const ConvolutionFacet& facet, std::size_t side);
  /// The line where two facets' planes cross; the planes must not be parallel. t is a coordinate,
  /// up to an integer and the sign.
  CarrierLine(const ConvolutionFacet& a, const ConvolutionFacet& b, long shift);

  /// Whether two facets' planes are parallel.
  static bool parallel(const ConvolutionFacet& a, const ConvolutionFacet& b, SignCounts& signs);

  template <class T>
  const LineIn<T>& as() const {
    if constexpr (std::is_same_v<T, BoundedDouble>) {
      return rounded_;
    } else {
      if (!exact_) exact_ = made<Integer>();
      return *exact_;
    }
  }

  /// A parameter as numerator and denominator; undefined if the line lies along the plane.
  template <class T>
  std::pair<T, T> parameter(const CutterPlane& plane) const {
    const LineIn<T>& line = as<T>();
    const FormIn<T> form = plane.form<T>();
    return {form.offset * line.weight - dot(form.normal, line.origin),
            dot(form.normal, line.direction)};
  }

  /// The point with a parameter.
  BoundedVector point_at(const BoundedDouble& t) const;

  /// The sign of normal · direction for a facet's plane.
  int slope(const ConvolutionFacet& facet, SignCounts& signs) const;

 private:
  template <class T>
  LineIn<T> made() const;

  const ConvolutionFacet &a_, &b_;
  int side_ = CutterPlane::own;
  std::size_t axis_ = 0;
  int level_ = 0;      ///< of the axis coordinate, at t = 0, times 2^-shift
  long shift_ = 0;     ///< of the doubles of coordinates
  int direction_ = 1;  ///< the sign that makes the weight positive
  LineIn<BoundedDouble> rounded_;
  mutable std::optional<LineIn<Integer>> exact_;
};

}  // namespace minkref::inline space
