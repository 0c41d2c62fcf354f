// Valid scales of a path, fits and traps, for Python.
#include "bindings/core_paths.hpp"

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
#include "reference/motion/fits_and_traps.hpp"
#include "reference/motion/path_diagram.hpp"
#include "reference/motion/star_centre.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// The feature: whether an edge, its ring, its index.
using FeatureRow = std::tuple<bool, std::uint32_t, std::uint32_t>;
/// Scale, whether the bound blocks; segment, t and point of the path; features of the part and of
/// the obstacles; the touching point.
using PathBoundRow = std::tuple<std::string, bool, std::uint32_t, std::string, ExactPoint,
                                FeatureRow, FeatureRow, ExactPoint>;
/// Scale, whether the range ends there, event, place, contact.
using FreeBoundRow =
    std::tuple<std::string, bool, std::string, ExactPoint, std::optional<PathBoundRow>>;
using PathAnswer = std::tuple<std::vector<RangeRow>, std::vector<PathBoundRow>, Fields>;
using FreeAnswer = std::tuple<std::vector<RangeRow>, std::vector<FreeBoundRow>,
                              std::vector<std::pair<std::string, bool>>, std::uint64_t>;

/// Segment, pieces of part and obstacles, corners (t, s).
template <typename Number>
using BadPolygonRow =
    std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::vector<std::pair<Number, Number>>>;
template <typename Number>
using Pieces = std::vector<std::vector<std::pair<Number, Number>>>;
template <typename Number>
using DiagramAnswer =
    std::tuple<Pieces<Number>, Pieces<Number>, std::vector<BadPolygonRow<Number>>>;

FeatureRow row(const TouchingFeature& feature) {
  return {feature.is_edge, feature.id.ring, feature.id.index};
}

PathBoundRow row(const PathBound& bound) {
  return {
      to_string(bound.scale),     bound.blocks,    bound.at.segment,    to_string(bound.at.t),
      to_strings(bound.at.point), row(bound.part), row(bound.obstacle), to_strings(bound.touching)};
}

Point point_of(const ExactPoint& text) {
  return {parse_rational(text.first), parse_rational(text.second)};
}

template <typename Number>
DiagramAnswer<Number> answer(const PathDiagram& found, Number (*number)(const Rational&)) {
  const auto pieces_of = [&](const std::vector<ConvexCorners>& pieces) {
    Pieces<Number> result;
    for (const ConvexCorners& piece : pieces) {
      auto& corners = result.emplace_back();
      for (const Point& p : piece) corners.emplace_back(number(p.x), number(p.y));
    }
    return result;
  };
  std::vector<BadPolygonRow<Number>> polygons;
  for (const BadPolygon& polygon : found.polygons) {
    std::vector<std::pair<Number, Number>> corners;
    for (const StripPoint& p : polygon.corners) corners.emplace_back(number(p.t), number(p.s));
    polygons.emplace_back(polygon.segment, polygon.part, polygon.obstacle, std::move(corners));
  }
  return {pieces_of(found.part_pieces), pieces_of(found.obstacle_pieces), std::move(polygons)};
}

template <typename Number>
DiagramAnswer<Number> diagram_of(const Set& part, const Set& obstacles,
                                 const std::vector<ExactPoint>& path, const std::string& contact,
                                 const OptionalText& from, const std::string& to, std::size_t most,
                                 Number (*number)(const Rational&)) {
  std::vector<Point> points;
  for (const ExactPoint& p : path) points.push_back(point_of(p));
  return answer(path_diagram(part.value, obstacles.value, points, contact_rule(contact),
                             window_of(from, to), most),
                number);
}

PathAnswer answer(const ValidScales& found) {
  std::vector<PathBoundRow> bounds;
  for (const PathBound& bound : found.bounds) bounds.push_back(row(bound));
  const nb::gil_scoped_acquire locked;
  return {range_rows(found.valid), std::move(bounds), statistics_fields(found.statistics)};
}

FreeAnswer answer(const FreeScales& found) {
  std::vector<FreeBoundRow> bounds;
  for (const FreeBound& bound : found.bounds) {
    std::optional<PathBoundRow> contact;
    if (bound.contact) contact = row(*bound.contact);
    bounds.emplace_back(to_string(bound.scale), bound.ends, bound.event, to_strings(bound.at),
                        std::move(contact));
  }
  std::vector<std::pair<std::string, bool>> proofs;
  for (const StaticProof& proof : found.proofs) {
    proofs.emplace_back(to_string(proof.scale), proof.holds);
  }
  return {range_rows(found.scales), std::move(bounds), std::move(proofs), found.critical_scales};
}

void bind_star_centres(nb::module_& module) {
  module.def(
      "star_shaped", [](const Set& part) { return star_shaped(part.value); }, "part"_a, Released(),
      "Whether each point of the set sees the origin in it.");
  module.def(
      "star_centre",
      [](const Set& part) -> std::optional<std::pair<ExactPoint, bool>> {
        const std::optional<StarCentre> found = star_centre(part.value);
        if (!found) return std::nullopt;
        return std::pair(to_strings(found->at), found->is_inside);
      },
      "part"_a, Released(),
      "A point that sees the whole set, and whether it lies strictly on the inner side of every "
      "edge; None without such a point.");
  module.def(
      "is_inner_star_centre",
      [](const Set& part, const ExactPoint& at) {
        return is_inner_star_centre(part.value, point_of(at));
      },
      "part"_a, "at"_a, Released(),
      "Whether a point sees the whole set, strictly on the inner side of every edge.");
}

}  // namespace

void bind_paths(nb::module_& module) {
  bind_star_centres(module);
  module.def(
      "valid_scales",
      [](const Set& part, const Set& obstacles, const std::vector<ExactPoint>& path,
         const std::string& contact, const OptionalText& from, const OptionalText& to,
         const std::string& route) {
        std::vector<Point> points;
        for (const ExactPoint& p : path) points.push_back(point_of(p));
        const Computing computing;
        return answer(valid_scales(part.value, obstacles.value, points, contact_rule(contact),
                                   window_of(from, to), path_route(route)));
      },
      "part"_a, "obstacles"_a, "path"_a, "contact"_a = "allowed", "from_scale"_a = nb::none(),
      "to_scale"_a = nb::none(), "route"_a = "pieces",
      "(ranges, bounds, statistics) of a polyline: a range is (from, with it, to, with it), a "
      "bound (scale, blocks, segment, t, place, part, obstacle, where they touch).");
  module.def(
      "held_scales",
      [](const Set& part, const Set& obstacles, const std::vector<ExactPoint>& way,
         const std::string& contact, const OptionalText& from, const OptionalText& to,
         const std::string& route) {
        std::vector<Point> points;
        for (const ExactPoint& p : way) points.push_back(point_of(p));
        const Computing computing;
        const HeldScales found =
            held_scales(part.value, obstacles.value, points, contact_rule(contact),
                        window_of(from, to), path_route(route));
        return std::tuple(answer(found.fits), answer(found.way),
                          held_rows(found.held, [](const PathBound& one) { return row(one); }));
      },
      "part"_a, "obstacles"_a, "way"_a, "contact"_a = "allowed", "from_scale"_a = nb::none(),
      "to_scale"_a = nb::none(), "route"_a = "pieces",
      "(fits, way, held): the first two as valid_scales, of the way's first vertex and of the way; "
      "a held range is (range, begin, end, stop), an end (whether at the place, bound) or None.");
  module.def(
      "path_diagram",
      [](const Set& part, const Set& obstacles, const std::vector<ExactPoint>& path,
         const std::string& contact, const OptionalText& from, const std::string& to,
         std::size_t most) {
        return diagram_of<std::string>(part, obstacles, path, contact, from, to, most,
                                       [](const Rational& x) { return to_string(x); });
      },
      "part"_a, "obstacles"_a, "path"_a, "contact"_a, "from_scale"_a.none(), "to_scale"_a, "most"_a,
      Released(),
      "(pieces of the part, of the obstacles, bad polygons) of a path; a polygon is (segment, "
      "piece "
      "of the part, of the obstacles, corners (t, s)). Refuses more than `most` of them.");
  module.def(
      "path_drawing",
      [](const Set& part, const Set& obstacles, const std::vector<ExactPoint>& path,
         const std::string& contact, const OptionalText& from, const std::string& to,
         std::size_t most) {
        return diagram_of<double>(part, obstacles, path, contact, from, to, most,
                                  [](const Rational& x) { return to_double(x); });
      },
      "part"_a, "obstacles"_a, "path"_a, "contact"_a, "from_scale"_a.none(), "to_scale"_a, "most"_a,
      Released(), "As path_diagram, in doubles.");
  module.def(
      "fit_at",
      [](const Set& part, const Set& container, const ExactPoint& at, const std::string& contact) {
        return answer(
            scales_that_fit_at(part.value, container.value, point_of(at), contact_rule(contact)));
      },
      "part"_a, "container"_a, "at"_a, "contact"_a = "allowed", Released(),
      "As fit_anywhere, of the scales at which the part at this place lies in the container.");
  module.def(
      "fit_anywhere",
      [](const Set& part, const Set& container, const std::string& contact) {
        return answer(scales_that_fit(part.value, container.value, contact_rule(contact)));
      },
      "part"_a, "container"_a, "contact"_a = "allowed", Released(),
      "(ranges, bounds, proofs, critical scales); a bound is (scale, whether the range ends there, "
      "event, place, contact).");
  module.def(
      "fit_between",
      [](const Set& part, const Set& container, const ExactPoint& from, const ExactPoint& to,
         const std::string& contact) {
        return answer(scales_that_pass(part.value, container.value, point_of(from), point_of(to),
                                       contact_rule(contact)));
      },
      "part"_a, "container"_a, "start"_a, "end"_a, "contact"_a = "allowed", Released(),
      "As fit_anywhere, of the scales at which the part gets from one place to the other.");
  module.def(
      "trapped_scales",
      [](const Set& part, const Set& obstacles, const ExactPoint& at, const std::string& contact,
         const OptionalText& from, const OptionalText& to) {
        refuse_large_convolution(part.value, obstacles.value);
        return answer(trapped_scales(part.value, obstacles.value, point_of(at),
                                     contact_rule(contact), window_of(from, to)));
      },
      "part"_a, "obstacles"_a, "at"_a, "contact"_a = "allowed", "from_scale"_a = nb::none(),
      "to_scale"_a = nb::none(), Released(),
      "As fit_anywhere, of the scales at which no translation takes the part away.");
}

}  // namespace minkref::python
