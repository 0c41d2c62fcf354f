// Scenes of placed, scaled sums in Python.
#pragma once

#include <nanobind/nanobind.h>

namespace minkref::python {

void bind_scene(nanobind::module_& module);

}  // namespace minkref::python
