// Area and length of an inset, enclosed.
#include <optional>
#include <utility>
#include <vector>

#include "reference/disc/region/exact_pieces.hpp"
#include "reference/disc/region/inset_region.hpp"
#include "reference/disc/region/measure_terms.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {
namespace {

/// The sum, if all terms are rational.
std::optional<Rational> rational_sum(const RootTerms& terms) {
  Rational sum = 0;
  for (const auto& [root, factor] : terms.terms()) {
    if (!root.empty()) return std::nullopt;
    sum += factor;
  }
  return sum;
}

/// Measures boundaries without arcs: rational numbers, which bits alone never tell.
class StraightMeasures {
 public:
  explicit StraightMeasures(const OffsetRegion& inset) {
    const auto add = [&](const OffsetRing& ring) {
      for (ExactPiece& piece : exact_pieces(inset, ring)) pieces_.push_back(std::move(piece));
    };
    for (const OffsetComponent& component : inset.components) {
      add(component.outer);
      for (const OffsetRing& hole : component.holes) add(hole);
    }
  }

  /// Rings have the set on their right.
  Interval area(const std::optional<Rational>& rational) const {
    return enclosed(rational, [&](const ExactPiece& piece, long bits) {
      return MpfrInterval(Rational(1, 2), bits) *
             cross(near(piece.to, bits), near(piece.from, bits));
    });
  }
  Interval length(const std::optional<Rational>& rational) const {
    return enclosed(rational, [&](const ExactPiece& piece, long bits) {
      const Vector<MpfrInterval> way = near(piece.to, bits) - near(piece.from, bits);
      return sqrt(dot(way, way));
    });
  }

 private:
  static Vector<MpfrInterval> near(const RootPoint& p, long bits) {
    return {p.x.enclosure(bits), p.y.enclosure(bits)};
  }
  template <class Part>
  Interval enclosed(const std::optional<Rational>& rational, Part&& part) const {
    const Enclosure found = rational ? enclose(RootNumber(*rational))
                                     : enclose(RealNumber{[&](long bits) {
                                                            MpfrInterval sum(0, bits);
                                                            for (const auto& piece : pieces_)
                                                              sum = sum + part(piece, bits);
                                                            return sum;
                                                          },
                                                          {}});
    return {found.lower, found.upper};
  }

  std::vector<ExactPiece> pieces_;
};

std::optional<Rational> negated(std::optional<Rational> value) {
  if (value) value = Rational(-*value);
  return value;
}

}  // namespace

OffsetMeasures inset_measures(const OffsetRegion& inset) {
  const FloatEnvironment standard;
  const MeasureTerms terms = measure_terms(inset);
  if (!terms.angles.empty()) {  // transcendental numbers
    const OffsetMeasures found = measures(inset);
    return {Interval(-found.area.upper(), -found.area.lower()), found.length};
  }
  const StraightMeasures straight(inset);
  return {straight.area(negated(rational_sum(terms.area))),
          straight.length(rational_sum(terms.length))};
}

}  // namespace minkref::inline disc
