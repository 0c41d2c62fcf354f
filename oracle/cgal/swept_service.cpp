// SPDX-License-Identifier: GPL-3.0-or-later
// Events of the sum's boundary as vertex heights of the swept solid.
#include <algorithm>
#include <chrono>

#include "oracle/cgal/service.hpp"
#include "oracle/cgal/swept_solid.hpp"

namespace minkref::cgal_oracle {

using nlohmann::json;

namespace {

constexpr std::size_t most_pairs = 24;  // of triangles; a request may name another number

mpq_class read_scale(const Request& request, const char* name) {
  return read_number(member(request, name), name);
}

}  // namespace

json description() {
  return {{"cgal", cgal_version_of_swept_solid()},
          {"methods", json::array({"swept-solid"})},
          {"methods_with_holes", json::array({"swept-solid"})}};
}

bool has_method(const std::string& method) { return method == "swept-solid"; }

json answer_of(const Request& request) {
  const auto p = triangles(read_polygons(member(request, "P"), "P"));
  const auto q = triangles(read_polygons(member(request, "Q"), "Q"));
  const mpq_class from = read_scale(request, "from"), to = read_scale(request, "to");
  if (from < 0 || from >= to) throw BadOperand("not 0 <= \"from\" < \"to\"");
  if (p.empty() || q.empty()) return refusal("skipped", "an operand has no area");
  const std::size_t pairs = p.size() * q.size();
  const auto most = request.value.value("most_pairs", most_pairs);
  if (pairs > most) {
    return refusal("skipped", std::to_string(pairs) + " pairs of triangles, more than " +
                                  std::to_string(most));
  }
  const auto start = std::chrono::steady_clock::now();
  auto vertices = swept_solid_vertices(p, q, from, to);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::sort(vertices.begin(), vertices.end(), [](const SolidVertex& a, const SolidVertex& b) {
    return a.s != b.s ? a.s < b.s : a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  json list = json::array();
  for (const SolidVertex& v : vertices) {
    if (v.s == from || v.s == to) continue;  // the corners of the solid's ends
    list.push_back({{"s", v.s.get_str()}, {"at", {v.x.get_str(), v.y.get_str()}}});
  }
  return {{"status", "result"},
          {"seconds", taken.count()},
          {"pairs", pairs},
          {"vertices", std::move(list)}};
}

}  // namespace minkref::cgal_oracle
