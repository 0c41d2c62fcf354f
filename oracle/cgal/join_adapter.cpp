// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of polygon sets by CGAL behind the adapter protocol.
#include <iostream>
#include <string_view>

#include "oracle/cgal/adapter_loop.hpp"
#include "oracle/cgal/join.hpp"

namespace {

using namespace minkref::cgal_oracle;
using nlohmann::json;

json united(const std::string& verb, const json& request) {
  if (verb != "union") throw Skipped("no verb " + verb + " here");
  std::vector<std::vector<Polygon>> sets;
  for (const json& set : request.at("sets")) sets.push_back(read_polygons(set, "sets"));
  return write_polygons(join_of(sets));
}

}  // namespace

int main(int count, char** arguments) {
  const std::string_view mode = count == 2 ? arguments[1] : "";
  if (mode == "join") {
    return serve_adapter({{"name", "cgal-join"},
                          {"version", cgal_version_of_join()},
                          {"language", "C++"},
                          {"arithmetic", "exact"},
                          {"numbers", "text"},
                          {"sum", "none"},
                          {"capabilities",
                           {"plane", "non-convex", "holes", "components", "touching", "empty",
                            "point", "segment", "rational", "union"}}},
                         united);
  }
  if (mode == "--version") {
    std::cout << json{{"cgal", cgal_version_of_join()}, {"methods", {"join"}}}.dump() << '\n';
    return 0;
  }
  std::cerr << "usage: " << arguments[0]
            << " join|--version\nSpeaks the adapter protocol: docs/adapter-protocol.md.\n";
  return 2;
}
