// Sums of convex polygons under non-uniform scaling: their part of the extension module.
#pragma once

#include <nanobind/nanobind.h>

namespace minkref::python {

void bind_convex_polygons(nanobind::module_& module);

}  // namespace minkref::python
