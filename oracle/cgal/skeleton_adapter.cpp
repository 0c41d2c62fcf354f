// SPDX-License-Identifier: GPL-3.0-or-later
// Offsets along CGAL's straight skeleton behind the adapter protocol.
#include <iostream>
#include <string_view>

#include "oracle/cgal/adapter_loop.hpp"
#include "oracle/cgal/skeleton.hpp"

namespace {

using namespace minkref::cgal_oracle;
using nlohmann::json;

json moved(const std::string& verb, const json& request) {
  if (verb != "offset") throw Skipped("no verb " + verb + " here");
  if (request.value("join", "round") != "sharp") throw Skipped("sharp corners only");
  const std::vector<Polygon> P = read_polygons(request.at("P"), "P");
  if (P.empty()) return write_polygons({});
  if (P.size() > 1) throw Skipped("one polygon at a time");
  return write_polygons(skeleton_offset(P.front(), read_number(request.at("radius"), "radius")));
}

}  // namespace

int main(int count, char** arguments) {
  const std::string_view mode = count == 2 ? arguments[1] : "";
  if (mode == "skeleton") {
    return serve_adapter(
        {{"name", "cgal-skeleton"},
         {"version", cgal_version_of_skeleton()},
         {"language", "C++"},
         {"arithmetic", "exact, with lengths rounded to doubles"},
         {"numbers", "text"},
         {"tolerance", {{"relative", "1e-12"}, {"radius", "1e-12"}}},
         {"sum", "none"},
         {"capabilities",
          {"plane", "non-convex", "holes", "empty", "rational", "join-sharp", "inset-sharp"}}},
        moved);
  }
  if (mode == "--version") {
    std::cout << json{{"cgal", cgal_version_of_skeleton()}, {"methods", {"skeleton"}}}.dump()
              << '\n';
    return 0;
  }
  std::cerr << "usage: " << arguments[0]
            << " skeleton|--version\nSpeaks the adapter protocol: docs/adapter-protocol.md.\n";
  return 2;
}
