// A topology timeline as rows for Python.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/exact_number.hpp"
#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/history/topology_timeline.hpp"

namespace minkref::python {

/// The convolution that a way through the scales follows: "dynamic" the reduced one, "winding" the
/// full one. Throws BadInput ("unknown-route") for another word.
ConvolutionType convolution_followed(const std::string& route);

ScaleWindow window_of(const std::optional<std::string>& from, const std::optional<std::string>& to);

/// Rows for the events within a closed window; `scale` gives the scale of a group.
class TimelineRows {
 public:
  TimelineRows(const TopologyTimeline& timeline, const ScaleWindow& window,
               std::function<Rational(std::uint32_t)> scale)
      : timeline_(timeline), window_(window), scale_(std::move(scale)) {}

  using OptionalText = std::optional<std::string>;

  /// For "hole" (the outside left out) or "component": name, scales of birth and death of features
  /// that live at some scale of the window; none for a birth or death outside the window.
  using LifeRow = std::tuple<std::uint32_t, std::optional<ExactNumber>, std::optional<ExactNumber>>;
  std::vector<LifeRow> lives(const std::string& kind) const;

  /// scale, change, edges, place.
  using BoundaryRow = std::tuple<std::string, std::string, std::vector<std::uint32_t>, ExactPoint>;
  std::vector<BoundaryRow> boundary_events() const;

  /// scale, feature ("hole" or "component"), change, before, after, parts at the scale, place.
  using TopologyRow = std::tuple<std::string, std::string, std::string, std::vector<std::uint32_t>,
                                 std::vector<std::uint32_t>, std::size_t, ExactPoint>;
  std::vector<TopologyRow> topology_events() const;

  /// For "hole" (0 is the outside) or "component": scales of birth and death.
  using FeatureRow = std::pair<OptionalText, OptionalText>;
  std::vector<FeatureRow> features(const std::string& kind) const;

  /// For each state of the boundary: its first scale (none: the window's start), its counts of
  /// holes, components and vertices, and the counts of holes and components at the scale itself.
  using CountRow = std::tuple<OptionalText, std::array<std::uint32_t, 5>>;
  std::vector<CountRow> state_counts() const;

  /// A boundary state's first scale (none: the window's start); its rings: whether the ring bounds
  /// a hole, its component, the hole on its other side, its vertices as tracks.
  using RingRow = std::tuple<bool, std::uint32_t, std::uint32_t, std::vector<std::uint32_t>>;
  using RingState = std::pair<OptionalText, std::vector<RingRow>>;

 private:
  /// The features of kind "hole" or "component". Throws BadInput ("unknown-feature") for another
  /// word.
  const std::vector<Feature>& of_kind(const std::string& kind) const;
  bool within(std::uint32_t group) const;
  std::string text(std::uint32_t group) const { return to_string(scale_(group)); }

  const TopologyTimeline& timeline_;
  const ScaleWindow& window_;
  std::function<Rational(std::uint32_t)> scale_;
};

/// Binds the constructor of a class for sP + Q over a window, and the convolution it follows.
template <typename Class>
nanobind::class_<Class>& bind_of_window(nanobind::class_<Class>& bound) {
  using Bound = std::optional<std::string>;
  using nanobind::arg;
  return bound.def(
      nanobind::init<const Set&, const Set&, const Bound&, const Bound&, const std::string&>(),
      arg("P"), arg("Q"), arg("from_scale") = nanobind::none(), arg("to_scale") = nanobind::none(),
      arg("route") = "dynamic", Released(),
      "`route`: dynamic follows the reduced convolution, winding the full one.");
}

/// Binds the answers of a class that has followed the boundary through a window.
template <typename Class>
void bind_history(nanobind::class_<Class>& bound) {
  using nanobind::arg;
  bound
      .def("boundary_events", &Class::boundary_events, Released(),
           "(scale, change, edges, place), ascending.")
      .def("topology_events", &Class::topology_events, Released(),
           "(scale, feature, change, before, after, parts at the scale, place), ascending.")
      .def("features", &Class::features, arg("kind"), Released(),
           "Scales of birth and death of each hole (0 is the outside) or component.")
      .def("lives", &Class::lives, arg("kind"), Released(),
           "Holes (the outside left out) or components that live within the window: name, scales "
           "of birth and death.")
      .def("tracks", &Class::tracks, Released(), "The point a + s b of each track: a, b.")
      .def("ring_states", &Class::ring_states, arg("report"),
           "Calls report with each state of the boundary: where it begins, and its rings as (is a "
           "hole's, component, hole, tracks).");
}

}  // namespace minkref::python
