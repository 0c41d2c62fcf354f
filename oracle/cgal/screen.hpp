// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of operands for CGAL.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// Says why CGAL's Minkowski sums do not take an operand, or nothing for an operand that they take:
/// exactly one polygon with at least three vertices, whose rings repeat no vertex and do not meet
/// each other, and without holes unless `holes`. (CGAL reads an empty boundary as the whole plane,
/// and leaves open how its algorithms treat a polygon whose holes touch: such operands would
/// convict CGAL of breaking promises that it never made.) Throws BadOperand for a ring with the
/// wrong orientation. The caller promises that no ring crosses itself. Exact; O(n log n) on usual
/// input.
std::optional<std::string> outside_of_cgal(const std::vector<Polygon>& operand, bool holes,
                                           const std::string& name);

}  // namespace minkref::cgal_oracle
