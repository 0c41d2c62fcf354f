// The canonical form for P ⊕ ρD: rings of curves (docs/disc.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/disc/curves/offset_patch.hpp"

namespace minkref::inline disc {

/// A circle or a line: the curve of P's feature, moved outwards by the radius.
struct OffsetCurve {
  bool is_arc;
  Rational x, y;  ///< of an arc the centre, of a line its direction, in coprime integers
  Rational c;     ///< of a line: N · p = c + ρ |N| for its points p, N = (y, -x)
};
/// `origin`: the curves' frame's origin, given by the answer's coordinates.
OffsetCurve offset_curve(const OffsetCurves& curves, std::uint32_t feature,
                         const Point& origin = {0, 0});

/// Features, one after the other, with the sum on the left.
struct FormRing {
  std::vector<std::uint32_t> curves;
  std::uint32_t id;  ///< what it stands for
};
struct FormComponent {
  FormRing outer;
  std::vector<FormRing> holes;
};
using OffsetForm = std::vector<FormComponent>;

/// Puts rings, holes and components into the order of the form. O(n log n).
void make_canonical(OffsetForm& form, const OffsetCurves& curves);

/// Writes a canonical form as JSON.
std::string canonical_json(const OffsetForm& form, const OffsetCurves& curves,
                           const Rational& squared_radius, const Point& origin = {0, 0});

}  // namespace minkref::inline disc
