// Questions about a scene that need no union, for Python.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <optional>
#include <tuple>
#include <utility>

#include "bindings/core.hpp"
#include "bindings/core_scene.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/scene/scene_questions.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using CopyRow = std::tuple<std::uint32_t, std::string, std::string, std::string>;
using HolderRow = std::pair<std::uint32_t, std::string>;
/// Whether an edge, ring, index.
using FeatureRow = std::tuple<bool, std::uint32_t, std::uint32_t>;
/// Copy; segment, t and point of the way; features of the robot and of the copy; where they touch.
using StopRow = std::tuple<std::uint32_t, std::uint32_t, std::string, ExactPoint, FeatureRow,
                           FeatureRow, ExactPoint>;
/// Copies that stop the robot together; where, as in StopRow.
using SeamRow =
    std::tuple<std::vector<std::uint32_t>, std::uint32_t, std::string, ExactPoint, ExactPoint>;
/// Factor, whether the way is free at the factor itself, what stops the robot.
using GrowthRow =
    std::tuple<std::optional<std::string>, bool, std::optional<StopRow>, std::optional<SeamRow>>;

Point point_of(const ExactPoint& point) {
  return {parse_rational(point.first), parse_rational(point.second)};
}

std::vector<Point> path_of(const std::vector<ExactPoint>& path) {
  std::vector<Point> points;
  points.reserve(path.size());
  for (const ExactPoint& point : path) points.push_back(point_of(point));
  return points;
}

SceneQuestions questions_of(const Set& robot, const std::vector<Set>& shapes,
                            const std::vector<CopyRow>& copies) {
  Scene scene{robot.value, {}, {}};
  for (const Set& shape : shapes) scene.shapes.push_back(shape.value);
  for (const auto& [shape, scale, x, y] : copies) {
    look_for_interrupt();
    scene.copies.push_back({shape, parse_rational(scale), point_of({x, y})});
  }
  return SceneQuestions(std::move(scene));
}

std::vector<HolderRow> holders_of(const SceneQuestions& self, const std::string& x,
                                  const std::string& y) {
  std::vector<HolderRow> rows;
  for (const Holder& holder : self.holders(point_of({x, y}))) {
    const bool touches = holder.contact == Contact::touching;
    rows.emplace_back(holder.copy, touches ? "touching" : "overlapping");
  }
  return rows;
}

std::pair<bool, std::vector<std::uint32_t>> way_of(const SceneQuestions& self,
                                                   const std::vector<ExactPoint>& path,
                                                   const std::string& rule) {
  SceneQuestions::WayAnswer answer = self.way(path_of(path), contact_rule(rule));
  return {answer.free, std::move(answer.stopped_by)};
}

FeatureRow row(const TouchingFeature& feature) {
  return {feature.is_edge, feature.id.ring, feature.id.index};
}

std::optional<GrowthRow> growth_of(const SceneQuestions& self, const std::vector<ExactPoint>& path,
                                   const std::string& rule) {
  const auto growth = self.growth(path_of(path), contact_rule(rule));
  if (!growth) return std::nullopt;
  if (!growth->factor) return GrowthRow{std::nullopt, true, std::nullopt, std::nullopt};
  if (!growth->seam.empty()) {
    return GrowthRow{to_string(*growth->factor), growth->included, std::nullopt,
                     SeamRow{growth->seam, growth->at.segment, to_string(growth->at.t),
                             to_strings(growth->at.point), to_strings(growth->touching)}};
  }
  return GrowthRow{to_string(*growth->factor), growth->included,
                   StopRow{growth->copy, growth->at.segment, to_string(growth->at.t),
                           to_strings(growth->at.point), row(growth->of_robot),
                           row(growth->of_copy), to_strings(growth->touching)},
                   std::nullopt};
}

}  // namespace

void bind_scene_questions(nb::module_& module) {
  unchanging(
      nb::class_<SceneQuestions>(
          module, "SceneQuestions",
          "A scene ready to be asked about places, ways and growth, without a union. Exact."))
      .def(
          "__init__",
          [](SceneQuestions* self, const Set& robot, const std::vector<Set>& shapes,
             const std::vector<CopyRow>& copies) {
            const Computing released;
            new (self) SceneQuestions(questions_of(robot, shapes, copies));
          },
          "robot"_a, "shapes"_a, "copies"_a,
          "Copies are (shape, scale, x, y). Raises BadInput (bad-scale, no-shape, no-area).")
      .def("holders", holders_of, "x"_a, "y"_a, Released(),
           "The copies that the robot meets at a place: (copy, touching or overlapping).")
      .def("way", way_of, "path"_a, "rule"_a, Released(),
           "Whether a way along a polyline is free by a rule of contact (allowed, forbidden), and "
           "the copies that stop it by themselves; none of a way that is not free: a seam does.")
      .def("growth", growth_of, "path"_a, "rule"_a, Released(),
           "How far all copies may grow about their places while a way stays free: (factor, or "
           "None without bound; whether it is free at the factor; copy, segment, t, point of the "
           "way, feature of the robot, feature of the copy, touching point; or copies that "
           "stop it together, segment, t, point of the way, touching point). None if the way is "
           "not free now.");
}

}  // namespace minkref::python
