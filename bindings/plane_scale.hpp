// A scale in the plane as Python gives it: "S", or "SX,SY" with a factor for each axis.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reference/plane/scaling.hpp"

namespace minkref::python {

/// The factors of "SX,SY"; none for "S". Throws BadInput for a text other than a number.
inline std::optional<PlaneScaling> axes_of(const std::string& scale) {
  const std::size_t comma = scale.find(',');
  if (comma == scale.npos) return std::nullopt;
  return PlaneScaling{parse_rational(scale.substr(0, comma)),
                      parse_rational(scale.substr(comma + 1))};
}

/// P with its scale. A factor for each axis is applied here: the set is S P then, and its scale 1.
/// A set that is not scaled here has to outlive the object.
class ScaledOperand {
 public:
  /// Throws BadInput for a text other than a scale, and for a factor <= 0.
  ScaledOperand(const PolygonSet& P, const std::string& scale) : axes_(axes_of(scale)), given_(&P) {
    if (axes_) {
      made_ = std::make_shared<const PolygonSet>(scaled(P, *axes_));
    } else {
      scale_ = parse_rational(scale);
    }
  }

  const PolygonSet& set() const { return made_ ? *made_ : *given_; }
  const Rational& scale() const { return scale_; }
  /// The point of P behind a point of the set.
  Point of_P(const Point& p) const {
    return axes_ ? Point{Rational(p.x / axes_->x), Rational(p.y / axes_->y)} : p;
  }

 private:
  std::optional<PlaneScaling> axes_;
  const PolygonSet* given_;
  std::shared_ptr<const PolygonSet> made_;
  Rational scale_ = 1;
};

}  // namespace minkref::python
