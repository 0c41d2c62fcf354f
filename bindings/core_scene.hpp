// Scenes of placed, scaled sums in Python.
#pragma once

#include <nanobind/nanobind.h>

namespace minkref::python {

void bind_scene(nanobind::module_& module);
void bind_scene_questions(nanobind::module_& module);

}  // namespace minkref::python
