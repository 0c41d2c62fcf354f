// The readings of "between" in Python.
#pragma once

#include "reference/plane/convolution/between.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::python {

/// As that of core.hpp, by a reading.
void refuse_large_convolution(const PolygonSet& P, const PolygonSet& Q, bool full, Between between);

}  // namespace minkref::python
