// SPDX-License-Identifier: GPL-3.0-or-later
// Which operands CGAL is asked about at all.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// Why an operand is outside what CGAL's Minkowski sums take, or nothing if it is inside: exactly
/// one polygon, of at least three vertices, whose rings repeat no vertex and do not meet each
/// other. Where `holes` is false, without holes. (CGAL reads an empty boundary as the whole plane,
/// and its polygon with holes that touch leaves open what its algorithms do there: such operands
/// would convict CGAL of what it never promised.) Throws BadOperand where a ring is turned the
/// wrong way. The caller promises that no ring crosses itself. Exact; O(n log n) on usual input.
std::optional<std::string> outside_of_cgal(const std::vector<Polygon>& operand, bool holes,
                                           const std::string& name);

}  // namespace minkref::cgal_oracle
