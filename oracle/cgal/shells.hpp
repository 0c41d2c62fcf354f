// SPDX-License-Identifier: GPL-3.0-or-later
// The shells of a surface.
#pragma once

#include "oracle/cgal/solid.hpp"

namespace minkref::cgal_oracle {

/// Six times the enclosed volume, negative where the faces look inwards.
mpq_class six_volumes(const Solid& shell);

/// The parts that share no vertex, by their volume, the largest first: what lies in a shell comes
/// after it.
std::vector<Solid> shells_by_size(const Solid& solid);

}  // namespace minkref::cgal_oracle
