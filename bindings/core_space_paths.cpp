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
#include "reference/motion/space/free/fits_and_traps.hpp"
#include "reference/motion/space/held_scales.hpp"
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

SpaceBoundRow bound_row(const SpacePathBound& bound) {
  return {to_string(bound.scale),
          bound.blocks,
          bound.at.segment,
          to_string(bound.at.t),
          to_strings(bound.at.point),
          feature_row(bound.part),
          feature_row(bound.obstacle),
          to_strings(bound.touching)};
}

SpacePathAnswer space_answer(const SpaceValidScales& found) {
  std::vector<SpaceBoundRow> bounds;
  for (const SpacePathBound& bound : found.bounds) bounds.push_back(bound_row(bound));
  const nb::gil_scoped_acquire locked;
  return {range_rows(found.valid), std::move(bounds), statistics_fields(found.statistics)};
}

/// Scale, whether the range ends there, event, place, contact.
using SpaceFreeBoundRow =
    std::tuple<std::string, bool, std::string, ExactSpacePoint, std::optional<SpaceBoundRow>>;
/// Part vertex, container face, weight.
using SupportRow = std::tuple<std::uint32_t, std::uint32_t, std::string>;
using SpaceFreeAnswer = std::tuple<std::vector<RangeRow>, std::vector<SpaceFreeBoundRow>,
                                   std::vector<SupportRow>, std::vector<ProofRow>, std::uint64_t>;

SpaceFreeAnswer free_answer(const SpaceFreeScales& found) {
  std::vector<SpaceFreeBoundRow> bounds;
  for (const SpaceFreeBound& bound : found.bounds) {
    std::optional<SpaceBoundRow> contact;
    if (bound.contact) contact = bound_row(*bound.contact);
    bounds.emplace_back(to_string(bound.scale), bound.ends, bound.event, to_strings(bound.at),
                        std::move(contact));
  }
  std::vector<SupportRow> supports;
  for (const FitSupport& one : found.supports) {
    supports.emplace_back(one.vertex, one.face, to_string(one.weight));
  }
  std::vector<ProofRow> proofs;
  for (const SweptProof& proof : found.proofs) {
    proofs.emplace_back(to_string(proof.scale), proof.holds);
  }
  return {range_rows(found.scales), std::move(bounds), std::move(supports), std::move(proofs),
          found.critical_scales};
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
      "held_scales_in_space",
      [](const Surface& part, const Surface& obstacles, const std::vector<ExactSpacePoint>& way,
         const std::string& contact, const OptionalText& from, const OptionalText& to,
         const std::string& route) {
        std::vector<SpacePoint> points;
        for (const ExactSpacePoint& p : way) points.push_back(to_point(p));
        const Computing computing;
        const SpaceHeldScales found =
            held_scales(part.value(), obstacles.value(), points, contact_rule(contact),
                        window_of(from, to), path_route(route));
        return std::tuple(space_answer(found.fits), space_answer(found.way),
                          held_rows(found.held, bound_row));
      },
      "part"_a, "obstacles"_a, "way"_a, "contact"_a = "allowed", "from_scale"_a = nb::none(),
      "to_scale"_a = nb::none(), "route"_a = "pieces",
      "As held_scales, of polyhedra and a way through space.");
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
  module.def(
      "fit_anywhere_in_space",
      [](const Surface& part, const Surface& container, const std::string& contact) {
        return free_answer(scales_that_fit(part.value(), container.value(), contact_rule(contact)));
      },
      "part"_a, "container"_a, "contact"_a = "allowed", Released(),
      "(ranges, bounds, supports, proofs, critical scales) of the scales at which the part fits "
      "somewhere; a bound is (scale, whether the range ends there, event, place, contact), a "
      "support (vertex of the part, face of the container, weight).");
  module.def(
      "trapped_scales_in_space",
      [](const Surface& part, const Surface& obstacles, const ExactSpacePoint& at,
         const std::string& contact, const OptionalText& from, const OptionalText& to) {
        return free_answer(trapped_scales(part.value(), obstacles.value(), to_point(at),
                                          contact_rule(contact), window_of(from, to)));
      },
      "part"_a, "obstacles"_a, "at"_a, "contact"_a = "allowed", "from_scale"_a = nb::none(),
      "to_scale"_a = nb::none(), Released(),
      "As fit_anywhere_in_space, of the scales at which no translation takes the part away.");
}

}  // namespace minkref::python
