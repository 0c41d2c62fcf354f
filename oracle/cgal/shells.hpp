// SPDX-License-Identifier: GPL-3.0-or-later
// The shells of a surface.
#pragma once

#include "oracle/cgal/solid.hpp"

namespace minkref::cgal_oracle {

/// Computes six times the enclosed volume, negative where the faces look inwards.
mpq_class six_volumes(const Solid& shell);

/// Splits a surface into parts that share no vertex, the largest volume first: a shell comes after
/// any shell around it.
std::vector<Solid> shells_by_size(const Solid& solid);

}  // namespace minkref::cgal_oracle
