// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's convex partitions behind lines of JSON: {"ring": [["x", "y"], ...], "optimal": bool} asks
// about a simple polygon without straight vertices, counter-clockwise, numbers being "n" or "n/d".
// Each answer is {"approximate": pieces, "seconds": s} by Hertel and Mehlhorn's way, with "optimal"
// and "optimal_seconds" where asked for (Greene's way: n^4 time, n^3 memory), or {"error": what}.
// The caller limits this process.
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>

#include <iterator>
#include <list>
#include <nlohmann/json.hpp>

#include "oracle/cgal/kernel.hpp"
#include "oracle/cgal/line_service.hpp"

namespace {

using nlohmann::json;
using namespace minkref::cgal_oracle;
using Traits = CGAL::Partition_traits_2<Kernel>;

/// The number of pieces, and the seconds.
template <class Partition>
std::pair<std::size_t, double> counted(const CgalRing& ring, Partition&& partition) {
  std::list<Traits::Polygon_2> pieces;
  const auto start = std::chrono::steady_clock::now();
  partition(ring.vertices_begin(), ring.vertices_end(), std::back_inserter(pieces), Traits());
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  return {pieces.size(), spent.count()};
}

json answer(const json& request) {
  Ring given;
  for (const json& point : request.at("ring")) {
    given.push_back({read_number(point.at(0), "ring"), read_number(point.at(1), "ring")});
  }
  const CgalRing ring = to_cgal(given);
  if (!ring.is_simple() || !ring.is_counterclockwise_oriented()) {
    throw BadOperand("the ring is not simple and counter-clockwise");
  }
  const auto [pieces, seconds] =
      counted(ring, [](auto... all) { CGAL::approx_convex_partition_2(all...); });
  json found{{"approximate", pieces}, {"seconds", seconds}};
  if (!request.value("optimal", false)) return found;
  const auto [fewest, longer] =
      counted(ring, [](auto... all) { CGAL::optimal_convex_partition_2(all...); });
  found["optimal"] = fewest;
  found["optimal_seconds"] = longer;
  return found;
}

}  // namespace

int main() {
  minkref::cgal_oracle::answer_lines(answer);
  return 0;
}
