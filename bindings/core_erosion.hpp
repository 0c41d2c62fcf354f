// Erosion, opening, closing and outsides for Python.
#pragma once

#include <nanobind/nanobind.h>

namespace minkref::python {

void bind_erosion(nanobind::module_& module);

}  // namespace minkref::python
