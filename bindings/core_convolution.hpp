// The readings of "between" for Python.
#pragma once

#include "reference/plane/convolution/between.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::python {

/// As refuse_large_convolution of core.hpp, for a given reading.
void refuse_large_convolution(const PolygonSet& P, const PolygonSet& Q, bool full, Between between);

}  // namespace minkref::python
