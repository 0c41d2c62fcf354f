// Scales at which a part keeps a distance from obstacles, for Python.
#pragma once

#include <nanobind/nanobind.h>

namespace minkref::python {

void bind_clearance(nanobind::module_& module);

}  // namespace minkref::python
