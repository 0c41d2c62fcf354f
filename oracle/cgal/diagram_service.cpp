// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's segment Delaunay graph behind lines of JSON: {"segments": [["x", "y", "x", "y"], ...]}
// asks, numbers being "n" or "n/d", and each answer is {"vertices": [{"at": [x, y],
// "squared_radius": r, "sites": [site, site, site]}, ...]}, plus "seconds", or {"error": what}. A
// site is ["x", "y"] or a segment. {"segments": ..., "edges": true} asks for edges too: {"sites":
// [site, site], "ends": [number, number], "infinite": whether}, with -1 for a segment's end and for
// infinity. The caller limits this process.
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "oracle/cgal/diagram.hpp"
#include "oracle/cgal/line_service.hpp"

namespace {

using nlohmann::json;
using namespace minkref::cgal_oracle;

json written(const DiagramSite& site) {
  json found{site.start.x.get_str(), site.start.y.get_str()};
  if (site.end) {
    found.push_back(site.end->x.get_str());
    found.push_back(site.end->y.get_str());
  }
  return found;
}

Segment read_segment(const json& value) {
  if (!value.is_array() || value.size() != 4) throw BadOperand("a segment has four numbers");
  const auto at = [&](std::size_t k) { return read_number(value[k], "segments"); };
  const Segment found{{at(0), at(1)}, {at(2), at(3)}};
  if (found.start == found.end) throw BadOperand("a segment has no length");
  return found;
}

json answer(const json& request) {
  std::vector<Segment> segments;
  for (const json& each : request.at("segments")) segments.push_back(read_segment(each));
  const auto start = std::chrono::steady_clock::now();
  const Diagram found = diagram_of(segments);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  json vertices = json::array();
  for (const DiagramVertex& vertex : found.vertices) {
    json sites = json::array();
    for (const DiagramSite& site : vertex.sites) sites.push_back(written(site));
    vertices.push_back({{"at", {vertex.x, vertex.y}},
                        {"squared_radius", vertex.squared_radius},
                        {"sites", std::move(sites)}});
  }
  json told = {{"vertices", std::move(vertices)}, {"seconds", spent.count()}};
  if (!request.value("edges", false)) return told;
  told["edges"] = json::array();
  for (const DiagramEdge& edge : found.edges) {
    told["edges"].push_back(
        {{"sites", json::array({written(edge.sites[0]), written(edge.sites[1])})},
         {"ends", edge.ends},
         {"infinite", edge.is_infinite}});
  }
  return told;
}

}  // namespace

int main() {
  minkref::cgal_oracle::answer_lines(answer);
  return 0;
}
