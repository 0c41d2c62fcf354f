// Binds the paper's own update of a sum in space.
#pragma once

#include <nanobind/nanobind.h>

namespace minkref::python {

void bind_paper_space_update(nanobind::module_& module);

}  // namespace minkref::python
