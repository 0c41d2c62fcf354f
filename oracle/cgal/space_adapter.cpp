// SPDX-License-Identifier: GPL-3.0-or-later
// Sums in space by CGAL behind the adapter protocol; the argument says nef or hull.
#include <functional>
#include <iostream>
#include <optional>
#include <string_view>

#include "oracle/cgal/adapter_loop.hpp"
#include "oracle/cgal/polygon.hpp"
#include "oracle/cgal/solid.hpp"

namespace {

using namespace minkref::cgal_oracle;
using nlohmann::json;

mpq_class read_coordinate(const json& value) {
  return value.is_number_integer() ? mpq_class(value.dump(), 10) : read_number(value, "vertices");
}

Solid read_solid(const json& value) {
  Solid solid;
  for (const json& v : value.at("vertices")) {
    if (v.size() != 3) throw BadOperand("a vertex is not [x, y, z]");
    solid.vertices.push_back(
        {read_coordinate(v.at(0)), read_coordinate(v.at(1)), read_coordinate(v.at(2))});
  }
  for (const json& f : value.at("faces")) {
    Face& face = solid.faces.emplace_back(f.get<Face>());
    for (const std::size_t i : face) {
      if (i >= solid.vertices.size()) throw BadOperand("a face names a vertex that is not there");
    }
  }
  return solid;
}

json write_solid(const Solid& solid) {
  json vertices = json::array(), faces = json::array();
  for (const SpacePoint& v : solid.vertices) {
    vertices.push_back({v.x.get_str(), v.y.get_str(), v.z.get_str()});
  }
  for (const Face& face : solid.faces) faces.push_back(face);
  return {{"vertices", std::move(vertices)}, {"faces", std::move(faces)}};
}

using SolidSum = std::function<Solid(const Solid& sP, const Solid& Q)>;

/// Sums of P scaled and the Q of the last `load`.
class Sums {
 public:
  explicit Sums(SolidSum sum) : sum_(std::move(sum)) {}

  json operator()(const std::string& verb, const json& request) {
    if (verb == "load") {
      Q_.reset();
      if (request.at("dimension") != 3) throw Skipped("in space only");
      Q_ = read_solid(request.at("Q"));
      return json::object();
    }
    if (verb != "at") throw Skipped("no verb " + verb + " here");
    if (!Q_) throw BadOperand("`at` before any `load`");
    const Solid found = sum_(read_solid(request.at("sP")), *Q_);
    json result = write_solid(found);
    if (request.value("timed", false)) result["cgal_seconds"] = found.seconds;
    return result;
  }

 private:
  SolidSum sum_;
  std::optional<Solid> Q_;
};

json hello(const char* name, json capabilities) {
  return {{"name", name},
          {"version", cgal_version_of_nef()},
          {"language", "C++"},
          {"arithmetic", "exact"},
          {"numbers", "text"},
          {"sum", "region"},
          {"capabilities", std::move(capabilities)}};
}

}  // namespace

int main(int count, char** arguments) {
  const std::string_view mode = count == 2 ? arguments[1] : "";
  if (mode == "nef") {
    return serve_adapter(hello("cgal-nef", {"space", "non-convex", "holes", "components",
                                            "rational", "non-uniform"}),
                         Sums(sum_of_nef_polyhedra));
  }
  if (mode == "hull") {
    return serve_adapter(hello("cgal-hull", {"space", "rational", "non-uniform"}),
                         Sums(hull_of_sums));
  }
  if (mode == "--version") {
    std::cout << json{{"cgal", cgal_version_of_nef()}, {"methods", {"nef", "hull"}}}.dump() << '\n';
    return 0;
  }
  std::cerr << "usage: " << arguments[0]
            << " nef|hull|--version\nSpeaks the adapter protocol: docs/adapter-protocol.md.\n";
  return 2;
}
