// A point next to a carrier: along it, then into a sector, by vanishing amounts.
#pragma once

#include <functional>
#include <optional>

#include "reference/space/edges/line.hpp"

namespace minkref::inline space {

/// x + ε along + ε² into + ε³ across, for ε small enough; the three directions are independent, so
/// that no integer plane contains the point.
class NudgedPoint {
 public:
  struct Exact {
    IntegerVector point;
    Integer weight;  ///< positive; x is point / weight
    IntegerVector along, into;
  };
  /// Calls `exact` at most once.
  NudgedPoint(BoundedVector rounded, std::function<Exact()> exact)
      : rounded_(rounded), make_exact_(std::move(exact)) {}

  const BoundedVector& rounded() const { return rounded_; }

  /// The point's side of a plane, 1 or -1. `form` makes a FormIn<T>; a zero normal gives 0.
  template <class Form>
  int side(SignCounts& signs, Form&& form) const {
    const FormIn<BoundedDouble> near = form(std::type_identity<BoundedDouble>{});
    const int certain = (dot(near.normal, rounded_) - near.offset).certain_sign();
    if (certain == 1 || certain == -1) {
      ++signs.by_float;
      return certain;
    }
    ++signs.by_integer;
    return exact_side(form(std::type_identity<Integer>{}));
  }

  /// 1 or -1: along an axis the point lies above or below x.
  int step(std::size_t axis) const {
    IntegerVector normal{0, 0, 0};
    normal[axis] = 1;
    return exact_step(normal);
  }

 private:
  const Exact& exact() const {
    if (!exact_) exact_ = make_exact_();
    return *exact_;
  }

  int exact_side(const FormIn<Integer>& form) const {
    const int sign = Integer(dot(form.normal, exact().point) - form.offset * exact().weight).sign();
    return sign != 0 ? sign : exact_step(form.normal);
  }

  int exact_step(const IntegerVector& normal) const {
    if (const int step = dot(normal, exact().along).sign(); step != 0) return step;
    if (const int step = dot(normal, exact().into).sign(); step != 0) return step;
    return dot(normal, cross(exact().along, exact().into)).sign();
  }

  BoundedVector rounded_;
  std::function<Exact()> make_exact_;
  mutable std::optional<Exact> exact_;
};

}  // namespace minkref::inline space
