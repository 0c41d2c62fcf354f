// The boundary of a polyhedral set.
#pragma once

#include "bindings/core.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::python {

void bind_space_surface(nanobind::module_& module, nanobind::class_<PolyhedralSet>& set);

}  // namespace minkref::python
