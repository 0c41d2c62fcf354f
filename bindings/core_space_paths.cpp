// Valid scales of a path through space, and fits at a place, for Python.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_paths.hpp"
#include "bindings/core_space.hpp"
#include "bindings/core_timeline.hpp"
#include "bindings/path_rows.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/motion/space/valid_scales.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// "vertex", "edge" or "face"; its number, or the two vertices.
using SpaceFeatureRow = std::tuple<std::string, std::vector<std::uint32_t>>;
/// Scale, whether the bound blocks; segment, t and point of the path; features of the part and of
/// the obstacles; the touching point.
using SpaceBoundRow = std::tuple<std::string, bool, std::uint32_t, std::string, ExactSpacePoint,
                                 SpaceFeatureRow, SpaceFeatureRow, ExactSpacePoint>;
using SpacePathAnswer = std::tuple<std::vector<RangeRow>, std::vector<SpaceBoundRow>, Fields>;
using ProofRow = std::pair<std::string, bool>;

SpaceFeatureRow feature_row(const SpaceFeature& feature) {
  switch (feature.kind) {
    case SpaceFeature::Kind::vertex:
      return {"vertex", {feature.first}};
    case SpaceFeature::Kind::edge:
      return {"edge", {feature.first, feature.second}};
    default:
      return {"face", {feature.first}};
  }
}

SpacePathAnswer space_answer(const SpaceValidScales& found) {
  std::vector<SpaceBoundRow> bounds;
  for (const SpacePathBound& bound : found.bounds) {
    bounds.emplace_back(to_string(bound.scale), bound.blocks, bound.at.segment,
                        to_string(bound.at.t), to_strings(bound.at.point), feature_row(bound.part),
                        feature_row(bound.obstacle), to_strings(bound.touching));
  }
  const nb::gil_scoped_acquire locked;
  return {range_rows(found.valid), std::move(bounds), statistics_fields(found.statistics)};
}

}  // namespace

void bind_space_paths(nb::module_& module) {
  module.def(
      "valid_scales_in_space",
      [](const Surface& part, const Surface& obstacles, const std::vector<ExactSpacePoint>& path,
         const std::string& contact, const OptionalText& from, const OptionalText& to,
         const std::string& route) {
        std::vector<SpacePoint> points;
        for (const ExactSpacePoint& p : path) points.push_back(to_point(p));
        const Computing computing;
        return space_answer(valid_scales(part.value(), obstacles.value(), points,
                                         contact_rule(contact), window_of(from, to),
                                         path_route(route)));
      },
      "part"_a, "obstacles"_a, "path"_a, "contact"_a = "allowed", "from_scale"_a = nb::none(),
      "to_scale"_a = nb::none(), "route"_a = "pieces",
      "As valid_scales, of polyhedra and a polyline in space; a feature is (vertex, edge or face, "
      "its number or the two vertices).");
  module.def(
      "star_shaped_in_space", [](const Surface& part) { return star_shaped(part.value()); },
      "part"_a, Released(), "Whether each point of the polyhedron sees the origin in it.");
  module.def(
      "fit_at_in_space",
      [](const Surface& part, const Surface& container, const ExactSpacePoint& at,
         const std::string& contact) {
        const Computing computing;
        const SpaceFit found = scales_that_fit_at(part.value(), container.value(), to_point(at),
                                                  contact_rule(contact));
        std::vector<ProofRow> proofs;
        for (const SweptProof& proof : found.proofs) {
          proofs.emplace_back(to_string(proof.scale), proof.holds);
        }
        return std::pair(space_answer(found.scales), std::move(proofs));
      },
      "part"_a, "container"_a, "at"_a, "contact"_a = "allowed",
      "((ranges, bounds, statistics), proofs) of the scales at which the part at this place lies "
      "in the container; a proof is (scale, whether it fits).");
}

}  // namespace minkref::python
