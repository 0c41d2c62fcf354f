// SPDX-License-Identifier: GPL-3.0-or-later
// Sums by an executable's methods.
#include <algorithm>

#include "oracle/cgal/method.hpp"
#include "oracle/cgal/screen.hpp"
#include "oracle/cgal/service.hpp"
#include "oracle/cgal/vanishing_holes.hpp"

namespace minkref::cgal_oracle {

using nlohmann::json;

namespace {

const Method* find_method(const std::string& name) {
  const auto all = methods();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Method& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

json description() {
  json names = json::array();
  json with_holes = json::array();
  for (const Method& method : methods()) {
    names.push_back(method.name);
    if (method.holes) with_holes.push_back(method.name);
  }
  return {{"cgal", cgal_version()}, {"methods", names}, {"methods_with_holes", with_holes}};
}

bool has_method(const std::string& method) { return find_method(method) != nullptr; }

json answer_of(const Request& request) {
  const Method& method = *find_method(request.method);
  const auto p = read_polygons(member(request, "P"), "P");
  const auto q = read_polygons(member(request, "Q"), "Q");
  if (const auto reason = outside_of_cgal(p, method.holes, "P")) return refusal("skipped", *reason);
  if (const auto reason = outside_of_cgal(q, method.holes, "Q")) return refusal("skipped", *reason);
  Polygon first = p.front();
  Polygon second = q.front();
  if (!request.value.value("raw", false)) {
    first = without_vanishing_holes(first, second);
    second = without_vanishing_holes(second, first);
  }
  const std::size_t removed =
      p.front().holes.size() + q.front().holes.size() - first.holes.size() - second.holes.size();
  const Sum sum = method.sum(first, second);
  return {{"status", "result"},
          {"seconds", sum.seconds},
          {"removed_holes", removed},
          {"result", write_polygons({sum.region})}};
}

}  // namespace minkref::cgal_oracle
