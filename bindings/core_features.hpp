// Features of a growing disc for Python.
#pragma once

#include <nanobind/nanobind.h>

namespace minkref::python {

void bind_features(nanobind::module_& module);

}  // namespace minkref::python
