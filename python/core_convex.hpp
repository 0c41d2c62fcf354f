// What the bindings of convex sums share.
#pragma once

#include <chrono>
#include <memory>

#include "python/core.hpp"
#include "reference/convex/convex_polyhedron.hpp"
#include "reference/convex/dynamic_convex_sum.hpp"

namespace minkref::python {

using Body = std::shared_ptr<const ConvexPolyhedron>;

/// What Python calls a ConvexPolyhedron: shared by the sums that refer to it.
struct ConvexBody {
  Body value;
};

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Fields fields_of(const UpdateCounts& counts);

void bind_timed_convex_walk(nanobind::module_& module);

}  // namespace minkref::python
