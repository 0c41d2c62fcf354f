#include "reference/disc/features/region_outlines.hpp"

#include <utility>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

/// The edge before a half; none for a vertex.
std::uint32_t edge_before(const DiscIndex& index, std::uint32_t half) {
  return index.diagram().curves.features[index.graph().halves[half].feature].edge;
}

}  // namespace

RegionOutlines::RegionOutlines(const Bridges& bridges, const FeatureRegions& regions)
    : bridges_(bridges), regions_(regions), radius_(bridges.of_events(index().radii() + 1)) {
  const FloatEnvironment standard;
  const auto& squared = regions.radius.squared;
  if (squared) radius_ = {DiagramGraph::none, *squared, {}, 0};
  corner_of_half_.assign(index().graph().halves.size(), DiagramGraph::none);
  for (const BoundaryPart& part : regions.parts.hidden) {
    look_for_interrupt();
    const std::uint32_t half = part.to, twin = index().graph().halves[half].twin;
    corner_of_half_[half] = corner_of_half_[twin] = static_cast<std::uint32_t>(corners_.size());
    CornerBridge corner{half, std::nullopt, bridges.chord<RootNumber>(half, radius_)};
    if (squared) corner.corner = bridges.place<RootNumber>(half, radius_);
    corners_.push_back(std::move(corner));
  }
}

const RootPoint& RegionOutlines::foot(std::uint32_t half) const {
  const CornerBridge& corner = corners_[corner_of_half_[half]];
  return corner.half == half ? corner.chord.from : corner.chord.to;
}

Vector<Surd> RegionOutlines::surd_corner(std::uint32_t number) const {
  return bridges_.place<Surd>(corners_[number].half, radius_);
}

Chord<Surd> RegionOutlines::surd_chord(std::uint32_t number) const {
  return bridges_.chord<Surd>(corners_[number].half, radius_);
}

void RegionOutlines::add_part(const BoundaryPart& part, std::vector<OutlineStep>& steps) const {
  const auto& features = index().diagram().curves.features;
  RootPoint at = foot(part.from);
  std::uint32_t edge = edge_before(index(), part.from);
  for (const std::uint32_t vertex : part.vertices) {
    const RootPoint next = numbers<RootNumber>(features[vertex].centre);
    steps.push_back({at, next, DiagramGraph::none});
    at = next;
    edge = DiagramGraph::none;
  }
  const std::uint32_t last = edge_before(index(), part.to);
  if (part.vertices.empty() && edge == DiagramGraph::none && last == edge) return;  // one vertex
  if (edge != last) edge = DiagramGraph::none;
  steps.push_back({at, foot(part.to), edge});
}

std::vector<OutlineStep> RegionOutlines::outline(const PartRing& ring, bool is_hidden) const {
  std::vector<OutlineStep> steps;
  if (ring.parts.empty()) {
    const auto& features = index().diagram().curves.features;
    const std::vector<std::uint32_t> vertices = walk_vertices(index(), ring.walk);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const std::uint32_t next = vertices[k + 1 == vertices.size() ? 0 : k + 1];
      steps.push_back({numbers<RootNumber>(features[vertices[k]].centre),
                       numbers<RootNumber>(features[next].centre), DiagramGraph::none});
    }
  }
  for (const std::uint32_t number : ring.parts) {
    const auto& parts = is_hidden ? regions_.parts.hidden : regions_.parts.visible;
    add_part(parts[number], steps);
    const std::uint32_t half = parts[number].to, twin = index().graph().halves[half].twin;
    steps.push_back({foot(half), foot(twin), DiagramGraph::none});
  }
  return steps;
}

void add_cross(const DiscIndex& index, const OutlineStep& step, const Rational& factor,
               RootTerms& terms) {
  const Rational half = factor / 2;
  if (step.edge == DiagramGraph::none) {
    terms.add(cross(step.from, step.to), half);
    return;
  }
  // Along a line only the ends' difference counts.
  const RootPoint on = numbers<RootNumber>(index.diagram().curves.edges[step.edge].start);
  terms.add(cross(on, step.to), half);
  terms.add(cross(on, step.from), -half);
}

namespace {

OutlineArea area_of(const RegionOutlines& outlines, const std::vector<OutlineStep>& steps,
                    int side) {
  const Rational factor = outlines.index().diagram().factor, unit = side / (factor * factor);
  OutlineArea found;
  for (const OutlineStep& step : steps) {
    look_for_interrupt();
    add_cross(outlines.index(), step, unit, found.terms);
  }
  const auto& terms = found.terms.terms();
  if (terms.empty()) {
    found.bounds = Interval(0);
  } else if (terms.size() == 1 && terms.begin()->first.empty()) {
    found.bounds = Interval(terms.begin()->second);
  } else {
    const auto near = [&](long bits) {
      MpfrInterval sum(0, bits);
      for (const OutlineStep& step : steps) {
        const auto by_bits = [&](const RootPoint& p) -> Vector<MpfrInterval> {
          return {p.x.enclosure(bits), p.y.enclosure(bits)};
        };
        sum = sum + cross(by_bits(step.from), by_bits(step.to));
      }
      return MpfrInterval(unit / 2, bits) * sum;
    };
    found.bounds = Interval(enclose(RealNumber{near, {}}));
  }
  return found;
}

}  // namespace

OutlineArea region_area(const RegionOutlines& outlines, const FeatureRegion& feature) {
  const FloatEnvironment standard;
  std::vector<OutlineStep> steps;
  for (const PartRing& ring : feature.rings) {
    for (OutlineStep& step : outlines.outline(ring, true)) steps.push_back(std::move(step));
  }
  return area_of(outlines, steps, -1);
}

OutlineArea ring_area(const RegionOutlines& outlines, const PartRing& ring, bool is_hidden) {
  const FloatEnvironment standard;
  return area_of(outlines, outlines.outline(ring, is_hidden), is_hidden ? -1 : 1);
}

OutlineArea shape_area(const RegionOutlines& outlines) {
  const FloatEnvironment standard;
  std::vector<OutlineStep> steps;
  for (const PartRing& ring : outlines.regions().parts.visible_rings) {
    for (OutlineStep& step : outlines.outline(ring, false)) steps.push_back(std::move(step));
  }
  return area_of(outlines, steps, 1);
}

}  // namespace minkref::inline disc
