// The SumSurface of Python.
#pragma once

#include <memory>

#include "reference/space/surface/surface_edges.hpp"

namespace minkref::python {

struct SumSurface {
  std::shared_ptr<const SurfaceEdges> value;
};

}  // namespace minkref::python
