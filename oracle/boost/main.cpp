// Boost.Polygon's Voronoi diagram of segments behind lines of JSON: {"segments": [[x, y, x, y],
// ...]} asks, numbers being integers of 32 bits, and each answer is {"vertices": [{"at": [x, y],
// "sites": [site, ...]}, ...]}, plus "seconds", or {"error": what}. A site [k] is open segment k;
// [k, 0] and [k, 1] are the segment's start and end. {"segments": ..., "edges": true} asks for
// {"sites": [site, site], "ends": [number, number], "infinite": whether} for each edge, too, with
// -1 for infinity. The caller limits this process.
//
// Places are doubles, most within 64 units in the last place (README.md). A vertex equally far from
// k sites comes once, with all k. The caller promises that segments meet only at their ends.
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using nlohmann::json;
using Diagram = boost::polygon::voronoi_diagram<double>;
using Point = boost::polygon::point_data<std::int32_t>;
using Segment = boost::polygon::segment_data<std::int32_t>;

std::int32_t read_number(const json& value) {
  if (!value.is_number_integer()) throw std::invalid_argument("a coordinate is no integer");
  const auto number = value.get<std::int64_t>();
  if (number != static_cast<std::int32_t>(number)) {
    throw std::invalid_argument("a coordinate has more than 32 bits");
  }
  return static_cast<std::int32_t>(number);
}

Segment read_segment(const json& value) {
  if (!value.is_array() || value.size() != 4) {
    throw std::invalid_argument("a segment has four numbers");
  }
  const auto at = [&](std::size_t k) { return read_number(value[k]); };
  const Point start(at(0), at(1)), end(at(2), at(3));
  if (start == end) throw std::invalid_argument("a segment has no length");
  return {start, end};
}

json site_of(const Diagram::cell_type& cell) {
  switch (cell.source_category()) {
    case boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT:
      return {cell.source_index(), 0};
    case boost::polygon::SOURCE_CATEGORY_SEGMENT_END_POINT:
      return {cell.source_index(), 1};
    default:
      return json::array({cell.source_index()});
  }
}

/// Each edge once.
json edges_of(const Diagram& diagram) {
  const auto number = [&](const Diagram::vertex_type* vertex) {
    return vertex == nullptr ? -1 : static_cast<int>(vertex - &diagram.vertices().front());
  };
  json found = json::array();
  for (const Diagram::edge_type& edge : diagram.edges()) {
    if (edge.twin() < &edge) continue;
    found.push_back({{"sites", {site_of(*edge.cell()), site_of(*edge.twin()->cell())}},
                     {"ends", {number(edge.vertex0()), number(edge.vertex1())}},
                     {"infinite", !edge.is_finite()}});
  }
  return found;
}

json answer(const json& request) {
  std::vector<Segment> segments;
  for (const json& each : request.at("segments")) segments.push_back(read_segment(each));
  const auto start = std::chrono::steady_clock::now();
  Diagram diagram;
  boost::polygon::construct_voronoi(segments.begin(), segments.end(), &diagram);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  json vertices = json::array();
  for (const Diagram::vertex_type& vertex : diagram.vertices()) {
    json sites = json::array();
    const Diagram::edge_type* edge = vertex.incident_edge();
    do {
      sites.push_back(site_of(*edge->cell()));
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
    vertices.push_back({{"at", {vertex.x(), vertex.y()}}, {"sites", std::move(sites)}});
  }
  json told = {{"vertices", std::move(vertices)}, {"seconds", spent.count()}};
  if (request.value("edges", false)) told["edges"] = edges_of(diagram);
  return told;
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    json found;
    try {
      found = answer(json::parse(line));
    } catch (const std::exception& error) {
      found = {{"error", error.what()}};
    }
    std::cout << found.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
  }
  return 0;
}
