// Paths, fits and traps for Python: bound by core.cpp.
#pragma once

#include <nanobind/nanobind.h>

namespace minkref::python {

void bind_paths(nanobind::module_& module);
void bind_space_paths(nanobind::module_& module);

}  // namespace minkref::python
