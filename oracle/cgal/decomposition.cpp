// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts both operands into convex pieces, adds the pieces pairwise, and unites the sums.
#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>

#include "oracle/cgal/kernel.hpp"

namespace minkref::cgal_oracle {
namespace {

template <class Strategy>
Sum of_any(const Polygon& p, const Polygon& q) {
  return sum_of_any(
      p, q, [](const auto& a, const auto& b) { return CGAL::minkowski_sum_2(a, b, Strategy()); });
}

template <class Strategy>
Sum of_simple(const Polygon& p, const Polygon& q) {
  return sum_of_simple(
      p, q, [](const auto& a, const auto& b) { return CGAL::minkowski_sum_2(a, b, Strategy()); });
}

constexpr Method kMethods[] = {
    {"vertical", true, of_any<CGAL::Polygon_vertical_decomposition_2<Kernel>>},
    {"triangulation", true, of_any<CGAL::Polygon_triangulation_decomposition_2<Kernel>>},
    {"ssab", false, of_simple<CGAL::Small_side_angle_bisector_decomposition_2<Kernel>>},
    {"optimal", false, of_simple<CGAL::Optimal_convex_decomposition_2<Kernel>>},
    {"hertel-mehlhorn", false, of_simple<CGAL::Hertel_Mehlhorn_convex_decomposition_2<Kernel>>},
    {"greene", false, of_simple<CGAL::Greene_convex_decomposition_2<Kernel>>},
};

}  // namespace

std::span<const Method> methods() { return kMethods; }
std::string cgal_version() { return CGAL_VERSION_STR; }

}  // namespace minkref::cgal_oracle
