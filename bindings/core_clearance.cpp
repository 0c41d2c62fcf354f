#include "bindings/core_clearance.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_timeline.hpp"
#include "bindings/path_rows.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/motion/clearance/clear_scales.hpp"
#include "reference/number/radicals/nearest_double.hpp"
#include "reference/number/radicals/root_text.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// An expression, and doubles around the number.
using RootRow = std::pair<std::string, std::pair<double, double>>;
/// From, whether it belongs to the range, to (none: no end), whether that does.
using RootRangeRow = std::tuple<RootRow, bool, std::optional<RootRow>, bool>;
using FeatureRow = std::tuple<bool, std::uint32_t, std::uint32_t>;
/// Scale, whether it blocks; segment and t; features of the part and of the obstacles.
using ClearBoundRow = std::tuple<RootRow, bool, std::uint32_t, RootRow, FeatureRow, FeatureRow>;
using ClearAnswer = std::pair<std::vector<RootRangeRow>, std::vector<ClearBoundRow>>;

RootRow row(const RootNumber& number) {
  const Enclosure near = enclose(number);
  return {expression(number), {near.lower, near.upper}};
}

FeatureRow row(const TouchingFeature& feature) {
  return {feature.is_edge, feature.id.ring, feature.id.index};
}

/// `vertices`: of the path; its last one is the end of the last segment.
ClearAnswer answer(const ClearScales& found, std::size_t vertices) {
  ClearAnswer rows;
  for (const RootRange& range : found.clear) {
    std::optional<RootRow> to;
    if (range.to) to = row(*range.to);
    rows.first.emplace_back(row(range.from), range.from_in, to, range.to_in);
  }
  for (const ClearBound& bound : found.bounds) {
    const NearFeatures& features = bound.features;
    const bool is_last = vertices > 1 && features.place + 1 == vertices;
    rows.second.emplace_back(row(bound.scale), bound.blocks, features.place - (is_last ? 1 : 0),
                             row(is_last ? RootNumber(1) : bound.t), row(features.part),
                             row(features.obstacle));
  }
  return rows;
}

Point point_of(const ExactPoint& text) {
  return {parse_rational(text.first), parse_rational(text.second)};
}

}  // namespace

void bind_clearance(nb::module_& module) {
  module.def(
      "clear_scales",
      [](const Set& part, const Set& obstacles, const std::vector<ExactPoint>& path,
         const std::string& clearance, const std::string& contact, const OptionalText& from,
         const OptionalText& to) {
        std::vector<Point> points;
        for (const ExactPoint& p : path) points.push_back(point_of(p));
        const ClearScales found =
            clear_scales(part.value, obstacles.value, points, parse_rational(clearance),
                         contact_rule(contact), window_of(from, to));
        return answer(found, points.size());
      },
      "part"_a, "obstacles"_a, "path"_a, "clearance"_a, "contact"_a = "allowed",
      "from_scale"_a = nb::none(), "to_scale"_a = nb::none(), Released(),
      "(ranges, bounds) of the scales at which a part keeps a distance on a polyline: a number is "
      "(expression, doubles around it), a bound (scale, blocks, segment, t, part, obstacle).");
  module.def(
      "scales_clear_at",
      [](const Set& part, const Set& container, const ExactPoint& at, const std::string& clearance,
         const std::string& contact) {
        const ClearScales found = scales_clear_at(part.value, container.value, point_of(at),
                                                  parse_rational(clearance), contact_rule(contact));
        return answer(found, 1);
      },
      "part"_a, "container"_a, "at"_a, "clearance"_a, "contact"_a = "allowed", Released(),
      "The same of a part at a place in a container.");
}

}  // namespace minkref::python
