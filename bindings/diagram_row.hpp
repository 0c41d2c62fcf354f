// Events of the outer Voronoi diagram for Python.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/disc/diagram/diagram_graph.hpp"
#include "reference/disc/diagram/edge_names.hpp"

namespace minkref::python {

/// "vertex" and its coordinates, or "edge" with the ring and the index of its first vertex: an edge
/// of the given set, the edge with the nearest point.
using FeatureName = std::tuple<std::string, std::string, std::string>;
/// Kind; the squared radius, if known as rational; a polynomial with this root, the lowest
/// coefficient first; bounds of the radius; the place, rounded; the features.
using DiagramRow =
    std::tuple<std::string, std::optional<std::string>, std::vector<std::string>,
               std::pair<double, double>, std::pair<double, double>, std::vector<FeatureName>>;

/// A squared radius: rational, if known as such; a polynomial with this root, the lowest
/// coefficient first; the radius's bounds.
struct SquareRow {
  std::optional<std::string> rational;
  std::vector<std::string> polynomial;
  std::pair<double, double> radius;
};
SquareRow square_row(const RootNumber& squared_radius);

const char* name(DiagramEvent::Kind kind);
FeatureName vertex_name(const DiagramEvents& found, std::uint32_t feature);
FeatureName edge_row(const VertexId& id);

DiagramRow diagram_row(const DiagramEvents& found, const DiagramEvent& event);

/// At most `count` rows from index `first` on.
std::vector<DiagramRow> diagram_rows(const DiagramEvents& found, std::size_t first,
                                     std::size_t count);

/// The feature of a boundary side, seen from the graph node in front of the side.
FeatureName side_name(const DiagramEvents& diagram, std::uint32_t node, std::uint32_t number,
                      Past past);

/// An end of a part of the diagram: "event" and its number; "vertex" and a reflex vertex's
/// coordinates; "infinity" and two hull vertices around the end.
using PartEnd = std::pair<std::string, std::vector<std::string>>;
/// `vertex`: of a reflex vertex, the feature.
PartEnd part_end(const DiagramEvents& diagram, const DiagramGraph& graph, std::uint32_t node,
                 std::uint32_t vertex);

/// Three features and a branch.
using PlaceRow = std::array<std::uint32_t, 4>;

/// The diagram events of a set: found, or proven again from places that were found before.
DiagramEvents diagram_of(const PolygonSet& P, unsigned threads,
                         const std::optional<std::vector<PlaceRow>>& places);

}  // namespace minkref::python
