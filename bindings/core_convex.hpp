// Declarations shared by the bindings of convex sums.
#pragma once

#include <memory>

#include "bindings/core.hpp"
#include "bindings/stopwatch.hpp"
#include "reference/space/convex/convex_polyhedron.hpp"
#include "reference/space/convex/dynamic_convex_sum.hpp"

namespace minkref::python {

using Body = std::shared_ptr<const ConvexPolyhedron>;

/// Python's ConvexPolyhedron: shared by all sums that refer to it.
struct ConvexBody {
  Body value;
};

Fields fields_of(const UpdateCounts& counts);

void bind_timed_convex_walk(nanobind::module_& module);

}  // namespace minkref::python
