// How far a proof at one scale extends: all its conditions are linear in the scale.
#pragma once

#include "certify/plane/cell_complex.hpp"

namespace minkref::certify {

class Validity {
 public:
  /// Within [from, to].
  Validity(const CellComplex& complex, Rational from, Rational to);

  /// The edges of a cell keep their directions, and no length falls below zero.
  void keep_cell(const std::vector<std::uint32_t>& corners);
  /// The corners stay in sA + B.
  void keep_cover(const std::vector<std::uint32_t>& corners, std::uint32_t A, std::uint32_t B);
  /// The normals of a code (separation.hpp) go on separating.
  void keep_code(const std::vector<std::uint32_t>& corners, const std::vector<std::int64_t>& code);

  /// The scales at which all conditions hold: a closed interval around the complex's scale.
  std::pair<Rational, Rational> interval() const;

 private:
  /// constant + slope s >= 0.
  void keep(const Rational& constant, const Rational& slope);
  const MovingPoint& moving(std::uint32_t corner);

  const CellComplex& complex_;
  Rational from_, to_;
  bool anywhere_else_ = true;
  std::vector<std::optional<MovingPoint>> moving_;
};

}  // namespace minkref::certify
