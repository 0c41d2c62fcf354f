// SPDX-License-Identifier: GPL-3.0-or-later
// Sums in space by CGAL behind the adapter protocol; the argument says nef or hull.
#include <iostream>
#include <string_view>

#include "oracle/cgal/adapter_loop.hpp"

namespace {

using namespace minkref::cgal_oracle;
using nlohmann::json;

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
                         sum_of_nef_polyhedra);
  }
  if (mode == "hull") {
    return serve_adapter(hello("cgal-hull", {"space", "rational", "non-uniform"}), hull_of_sums);
  }
  if (mode == "--version") {
    std::cout << json{{"cgal", cgal_version_of_nef()}, {"methods", {"nef", "hull"}}}.dump() << '\n';
    return 0;
  }
  std::cerr << "usage: " << arguments[0]
            << " nef|hull|--version\nSpeaks the adapter protocol: docs/adapter-protocol.md.\n";
  return 2;
}
