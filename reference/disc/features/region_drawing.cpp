#include "reference/disc/features/region_drawing.hpp"

#include <algorithm>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {
namespace {

using DrawnPoint = std::pair<double, double>;

double nearest(const Surd& value) {
  if (const auto rational = value.rational()) return to_double(*rational) + 0.0;
  return nearest_double(RealNumber{
      [value](long bits) { return value.enclosure(bits); },
      [value](const Rational& other) { return sign(value - Surd(other)); }, value.enclosure()});
}

/// An arc's end: a foot, or where circles meet.
DrawnPoint drawn_end(const RegionOutlines& outlines, const FreeArc& arc, bool at_start) {
  const ArcEnd& end = at_start ? arc.from : arc.to;
  const Chord<RootNumber>& chord = outlines.corners()[arc.corner].chord;
  if (end.is_foot()) return drawn_point(outlines, at_start ? chord.from : chord.to);
  const DiagramEvents& diagram = outlines.index().diagram();
  const Vector<Surd> centre = outlines.surd_corner(arc.corner),
                     other = outlines.surd_corner(end.with.front());
  const Vector<Surd> place =
      centre + arc_end(diagram.curves, end, centre, other, Surd(*outlines.regions().radius.squared),
                       Surd(Rational(1, 2)), at_start);
  const Surd scale(Rational(1 / diagram.factor));
  return {nearest(scale * place.x + Surd(diagram.origin.x)),
          nearest(scale * place.y + Surd(diagram.origin.y))};
}

DrawnStep drawn_arc(const RegionOutlines& outlines, const FreeArc& arc) {
  const auto [x0, y0] = drawn_end(outlines, arc, true);
  const auto [x1, y1] = drawn_end(outlines, arc, false);
  const auto [cx, cy] = drawn_point(outlines, *outlines.corners()[arc.corner].corner);
  return {true, x0, y0, x1, y1, cx, cy};
}

void add_steps(const RegionOutlines& outlines, const std::vector<OutlineStep>& steps,
               std::vector<DrawnStep>& found) {
  for (const OutlineStep& step : steps) {
    look_for_interrupt();
    const auto [x0, y0] = drawn_point(outlines, step.from);
    const auto [x1, y1] = drawn_point(outlines, step.to);
    if (x0 == x1 && y0 == y1) continue;
    found.push_back({false, x0, y0, x1, y1, 0, 0});
  }
}

}  // namespace

RootPoint placed(const RegionOutlines& outlines, const RootPoint& point) {
  const DiagramEvents& diagram = outlines.index().diagram();
  return RootNumber(Rational(1 / diagram.factor)) * point + numbers<RootNumber>(diagram.origin);
}

DrawnPoint drawn_point(const RegionOutlines& outlines, const RootPoint& point) {
  const RootPoint at = placed(outlines, point);
  return {nearest_double(at.x), nearest_double(at.y)};
}

std::vector<DrawnStep> drawn_outline(const RegionOutlines& outlines, const PartRing& ring,
                                     bool is_hidden) {
  const FloatEnvironment standard;
  std::vector<DrawnStep> found;
  add_steps(outlines, outlines.outline(ring, is_hidden), found);
  return found;
}

std::vector<DrawnStep> drawn_rest(const RegionOutlines& outlines, const RestMaterial& rest,
                                  const RestRing& ring) {
  const FloatEnvironment standard;
  if (ring.pieces.empty()) return drawn_outline(outlines, {{}, ring.walk}, true);
  std::vector<DrawnStep> found;
  for (const RestPiece& piece : ring.pieces) {
    look_for_interrupt();
    if (!piece.is_arc) {
      std::vector<OutlineStep> steps;
      outlines.add_part(outlines.regions().parts.hidden[piece.number], steps);
      add_steps(outlines, steps, found);
      continue;
    }
    found.push_back(drawn_arc(outlines, rest.arcs[piece.number]));
  }
  return found;
}

std::vector<DrawnStep> drawn_closing(const RegionOutlines& outlines, const RestMaterial& rest,
                                     const ClosingRing& ring) {
  const FloatEnvironment standard;
  std::vector<DrawnStep> found;
  const auto add_backwards = [&](std::vector<OutlineStep> steps) {
    std::reverse(steps.begin(), steps.end());
    for (OutlineStep& step : steps) std::swap(step.from, step.to);
    add_steps(outlines, steps, found);
  };
  if (ring.pieces.empty()) add_backwards(outlines.outline({{}, ring.walk}, false));
  for (const ClosingPiece& piece : ring.pieces) {
    look_for_interrupt();
    if (piece.is_arc) {
      found.push_back(drawn_arc(outlines, rest.arcs[piece.number]));
      continue;
    }
    std::vector<OutlineStep> steps;
    outlines.add_part(outlines.regions().parts.visible[piece.number], steps);
    add_backwards(std::move(steps));
  }
  return found;
}

}  // namespace minkref::inline disc
