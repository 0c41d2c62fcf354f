// SPDX-License-Identifier: GPL-3.0-or-later
// The reduced convolution (Behar & Lien 2012, Sec. 3), in CGAL's version.
#include <CGAL/minkowski_sum_2.h>

#include "oracle/cgal/kernel.hpp"

namespace minkref::cgal_oracle {
namespace {

Sum reduced(const Polygon& p, const Polygon& q) {
  return sum_of_any(p, q, [](const auto& a, const auto& b) {
    return CGAL::minkowski_sum_by_reduced_convolution_2(a, b);
  });
}

constexpr Method kMethods[] = {{"reduced", true, reduced}};

}  // namespace

std::span<const Method> methods() { return kMethods; }
std::string cgal_version() { return CGAL_VERSION_STR; }

}  // namespace minkref::cgal_oracle
