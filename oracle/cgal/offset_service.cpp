// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's exact offset behind lines of JSON: {"P": polygons, "radius": "n/d"} asks, and each answer
// is {"polygons": [{"outer": ring, "holes": [ring, ...]}, ...]} plus "seconds", or {"error": what}.
// A ring lists pieces {"arc": bool, "conic": ["r", "s", "t", "u", "v", "w"], "ends": [x, y, x, y]}.
// With "tolerance": t the question asks for CGAL's approximated offset; the answer then has the
// number of "curves", and "seconds". With the argument `approximated` the approximated offset
// stands behind the adapter protocol instead. The caller limits this process.
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "oracle/cgal/adapter_loop.hpp"
#include "oracle/cgal/line_service.hpp"
#include "oracle/cgal/offset.hpp"

namespace {

using nlohmann::json;
using namespace minkref::cgal_oracle;

json written(const ConicRing& ring) {
  json found = json::array();
  for (const ConicPiece& piece : ring) {
    json conic = json::array();
    for (const mpq_class& number : piece.conic) conic.push_back(number.get_str());
    found.push_back({{"arc", piece.is_arc}, {"conic", std::move(conic)}, {"ends", piece.ends}});
  }
  return found;
}

json answer(const json& request) {
  const std::vector<Polygon> P = read_polygons(request.at("P"), "P");
  const mpq_class radius = read_number(request.at("radius"), "radius");
  const auto start = std::chrono::steady_clock::now();
  if (request.contains("tolerance")) {
    const double tolerance = request.at("tolerance").get<double>();
    const std::size_t curves = curves_of_offset_near(P, radius, tolerance);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    return {{"curves", curves}, {"seconds", taken.count()}};
  }
  const std::vector<ConicPolygon> found = offset_of(P, radius);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  json polygons = json::array();
  for (const ConicPolygon& polygon : found) {
    json holes = json::array();
    for (const ConicRing& hole : polygon.holes) holes.push_back(written(hole));
    polygons.push_back({{"outer", written(polygon.outer)}, {"holes", std::move(holes)}});
  }
  return {{"polygons", std::move(polygons)}, {"seconds", spent.count()}};
}

constexpr int parts = 2000;  // of the radius: the tolerance

json written(const NearRing& ring) {
  json found = json::array();
  for (const auto& [x, y] : ring) {
    found.push_back({mpq_class(x).get_str(), mpq_class(y).get_str()});
  }
  return found;
}

json grown(const std::string& verb, const json& request) {
  if (verb != "offset") throw Skipped("no verb " + verb + " here");
  const std::vector<Polygon> P = read_polygons(request.at("P"), "P");
  const mpq_class radius = read_number(request.at("radius"), "radius");
  json polygons = json::array();
  for (const NearPolygon& polygon : offset_near(P, radius, radius.get_d() / parts)) {
    json holes = json::array();
    for (const NearRing& hole : polygon.holes) holes.push_back(written(hole));
    polygons.push_back({{"outer", written(polygon.outer)}, {"holes", std::move(holes)}});
  }
  return {{"polygons", std::move(polygons)}};
}

int serve() {
  return serve_adapter(
      {{"name", "cgal-offset"},
       {"version", cgal_version_of_offset()},
       {"language", "C++"},
       {"arithmetic", "exact, then approximated"},
       {"numbers", "text"},
       {"tolerance", {{"relative", "1e-12"}, {"radius", "0.001"}}},
       {"sum", "none"},
       {"capabilities",
        {"plane", "non-convex", "holes", "components", "touching", "empty", "rational", "offset"}}},
      grown);
}

}  // namespace

int main(int count, char** arguments) {
  const std::string_view mode = count > 1 ? arguments[1] : "";
  if (mode == "approximated") return serve();
  answer_lines(answer);
  return 0;
}
