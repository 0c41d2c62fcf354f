#include "reference/disc/features/rest_measures.hpp"

#include <utility>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

/// Sums over rings at any precision; the rest lies on the right.
class RestSums {
 public:
  RestSums(const RegionOutlines& outlines, const RestMaterial& rest)
      : outlines_(outlines), rest_(rest) {}

  void add(const RestRing& ring) {
    if (ring.pieces.empty()) {
      for (OutlineStep& step : outlines_.outline({{}, ring.walk}, true)) steps_.push_back(step);
    }
    for (const RestPiece& piece : ring.pieces) {
      if (piece.is_arc) {
        arcs_.push_back(piece.number);
      } else {
        outlines_.add_part(outlines_.regions().parts.hidden[piece.number], steps_);
      }
    }
  }

  bool has_arcs() const { return !arcs_.empty(); }

  /// Within the frame.
  MpfrInterval area(long bits) const {
    MpfrInterval sum(0, bits);
    for (const OutlineStep& step : steps_)
      sum = sum + cross(near(step.from, bits), near(step.to, bits));
    for (const std::uint32_t number : arcs_) {
      look_for_interrupt();
      const FreeArc& arc = rest_.arcs[number];
      const Vector<MpfrInterval> centre = near(*outlines_.corners()[arc.corner].corner, bits),
                                 from = end(arc, true, bits), to = end(arc, false, bits);
      const MpfrInterval angle = atan2(cross(from, to), dot(from, to));
      sum = sum + MpfrInterval(squared(), bits) * angle + cross(centre, to - from);
    }
    return MpfrInterval(Rational(-1, 2), bits) * sum;
  }

  /// The steps alone.
  RootTerms terms(const Rational& unit) const {
    RootTerms found;
    for (const OutlineStep& step : steps_) add_cross(outlines_.index(), step, -unit, found);
    return found;
  }

 private:
  const Rational& squared() const { return *outlines_.regions().radius.squared; }
  static Vector<MpfrInterval> near(const RootPoint& p, long bits) {
    return {p.x.enclosure(bits), p.y.enclosure(bits)};
  }

  /// From the centre.
  Vector<MpfrInterval> end(const FreeArc& arc, bool at_start, long bits) const {
    const ArcEnd& end = at_start ? arc.from : arc.to;
    const CornerBridge& corner = outlines_.corners()[arc.corner];
    const Vector<MpfrInterval> centre = near(*corner.corner, bits);
    if (end.is_foot()) return near(at_start ? corner.chord.from : corner.chord.to, bits) - centre;
    const Vector<MpfrInterval> other = near(*outlines_.corners()[end.with.front()].corner, bits);
    return arc_end(outlines_.index().diagram().curves, end, centre, other,
                   MpfrInterval(squared(), bits), MpfrInterval(Rational(1, 2), bits), at_start);
  }

  const RegionOutlines& outlines_;
  const RestMaterial& rest_;
  std::vector<OutlineStep> steps_;
  std::vector<std::uint32_t> arcs_;
};

}  // namespace

bool is_around_rest(const RegionOutlines& outlines, const RestMaterial& rest,
                    const RestRing& ring) {
  RestSums sums(outlines, rest);
  sums.add(ring);
  for (long bits = RealNumber::first_bits;; bits *= 2) {
    const int sign = sums.area(bits).certain_sign();
    if (sign != 0) return sign > 0;
  }
}

namespace {

/// Encloses an area with some rest, times a factor.
Interval enclosed(const RegionOutlines& outlines, const RestSums& sums, const Rational& area,
                  int sign) {
  const Rational factor = outlines.index().diagram().factor, unit = sign / (factor * factor);
  if (!sums.has_arcs()) {  // whole holes, or nothing
    const RootTerms found = sums.terms(unit);
    return Interval(found.terms().empty() ? area : area + found.terms().begin()->second);
  }
  const auto near = [&](long bits) {
    return MpfrInterval(area, bits) + MpfrInterval(unit, bits) * sums.area(bits);
  };
  return Interval(enclose(RealNumber{near, {}}));
}

}  // namespace

Interval rest_area(const RegionOutlines& outlines, const RestMaterial& rest,
                   const std::vector<std::size_t>& features) {
  const FloatEnvironment standard;
  RestSums sums(outlines, rest);
  for (const std::size_t feature : features) {
    for (const RestRing& ring : rest.features[feature].rings) sums.add(ring);
  }
  return enclosed(outlines, sums, 0, 1);
}

Interval area_with_rest(const RegionOutlines& outlines, const RestMaterial& rest,
                        const Rational& area, int sign) {
  const FloatEnvironment standard;
  RestSums sums(outlines, rest);
  for (const FeatureRest& feature : rest.features) {
    for (const RestRing& ring : feature.rings) sums.add(ring);
  }
  return enclosed(outlines, sums, area, sign);
}

}  // namespace minkref::inline disc
