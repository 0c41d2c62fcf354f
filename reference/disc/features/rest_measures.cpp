#include "reference/disc/features/rest_measures.hpp"

#include <optional>
#include <utility>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

constexpr long most_bits = 1 << 14;

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
      // Half a turn at most, which the ends' cross product would not tell from none.
      const MpfrInterval half = atan2(length(to - from), length(to + from));
      const MpfrInterval angle = half + half;
      sum = sum + MpfrInterval(squared(), bits) * angle + cross(centre, to - from);
    }
    return MpfrInterval(Rational(-1, 2), bits) * sum;
  }

  /// The angle that the boundary turns through as seen from a place; a whole turn within each arc's
  /// chord counts. Nothing where the precision does not tell on which side of an arc the place is.
  std::optional<MpfrInterval> turn_about(const Vector<MpfrInterval>& place, long bits) const {
    const MpfrInterval one(1, bits), quarter = atan2(one, one) + atan2(one, one);
    MpfrInterval sum(0, bits);
    const auto add_seen = [&](const Vector<MpfrInterval>& a, const Vector<MpfrInterval>& b) {
      sum = sum + atan2(cross(a - place, b - place), dot(a - place, b - place));
    };
    for (const OutlineStep& step : steps_) add_seen(near(step.from, bits), near(step.to, bits));
    for (const std::uint32_t number : arcs_) {
      look_for_interrupt();
      const FreeArc& arc = rest_.arcs[number];
      const Vector<MpfrInterval> centre = near(*outlines_.corners()[arc.corner].corner, bits),
                                 from = centre + end(arc, true, bits),
                                 to = centre + end(arc, false, bits), way = place - centre;
      add_seen(from, to);
      const int within = (MpfrInterval(squared(), bits) - dot(way, way)).certain_sign(),
                behind = cross(place - from, to - from).certain_sign();
      if (within < 0 || behind < 0) continue;
      if (within == 0 || behind == 0) return std::nullopt;
      for (int k = 0; k < 4; ++k) sum = sum + quarter;
    }
    return sum;
  }

  const std::vector<OutlineStep>& steps() const { return steps_; }
  /// The point at this share along a step.
  Vector<MpfrInterval> along(const OutlineStep& step, const Rational& share, long bits) const {
    const Vector<MpfrInterval> from = near(step.from, bits);
    return from + MpfrInterval(share, bits) * (near(step.to, bits) - from);
  }

  /// The steps alone.
  RootTerms terms(const Rational& unit) const {
    RootTerms found;
    for (const OutlineStep& step : steps_) add_cross(outlines_.index(), step, -unit, found);
    return found;
  }

 private:
  static MpfrInterval length(const Vector<MpfrInterval>& v) { return sqrt(dot(v, v)); }
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

bool is_within_ring(const RegionOutlines& outlines, const RestMaterial& rest,
                    const RestRing& around, const RestRing& ring) {
  RestSums outer(outlines, rest), inner(outlines, rest);
  outer.add(around);
  inner.add(ring);
  for (long bits = RealNumber::first_bits; bits <= most_bits; bits *= 2) {
    for (const OutlineStep& step : inner.steps()) {
      // Rings touch at single points: at most a few of these places are no answer.
      for (const Rational& share : {Rational(1, 2), Rational(1, 3), Rational(3, 5)}) {
        const auto turn = outer.turn_about(inner.along(step, share, bits), bits);
        if (!turn) continue;
        // Either nothing or whole turns.
        const int is_inside = (*turn * *turn - MpfrInterval(9, bits)).certain_sign();
        if (is_inside != 0) return is_inside > 0;
      }
    }
  }
  throw LimitExceeded("nested-rest", "two rings of the rest material are too near to each other",
                      "take a little larger or smaller radius");
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
