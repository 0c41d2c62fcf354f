// SPDX-License-Identifier: GPL-3.0-or-later
// The full convolution: winding numbers of faces of all convolution cycles.
#include <CGAL/minkowski_sum_2.h>

#include "oracle/cgal/kernel.hpp"

namespace minkref::cgal_oracle {
namespace {

Sum full(const Polygon& p, const Polygon& q) {
  return sum_of_simple(p, q, [](const auto& a, const auto& b) {
    return CGAL::minkowski_sum_by_full_convolution_2(a, b);
  });
}

constexpr Method kMethods[] = {{"full", false, full}};

}  // namespace

std::span<const Method> methods() { return kMethods; }
std::string cgal_version() { return CGAL_VERSION_STR; }

}  // namespace minkref::cgal_oracle
