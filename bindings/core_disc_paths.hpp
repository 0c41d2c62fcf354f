// How large a disc may be on a path, at a place and between places, for Python.
#pragma once

#include <nanobind/nanobind.h>

namespace minkref::python {

void bind_disc_paths(nanobind::module_& module);

}  // namespace minkref::python
