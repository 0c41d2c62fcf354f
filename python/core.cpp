// The extension module minkref._core.
#include "python/core.hpp"

NB_MODULE(_core, module) {
  module.doc() = "The exact reference, in the plane and in space; numbers are strings, n or n/d.";
  minkref::python::bind_errors(module);
  minkref::python::bind_polygon_set(module);
  minkref::python::bind_files(module);
  minkref::python::bind_sum(module);
  minkref::python::bind_convolution(module);
  minkref::python::bind_events(module);
  minkref::python::bind_dynamic(module);
  minkref::python::bind_index(module);
  minkref::python::bind_timed_index(module);
  minkref::python::bind_comparison(module);
  minkref::python::bind_evidence(module);
  minkref::python::bind_search(module);
  minkref::python::bind_certify(module);
  minkref::python::bind_space(module);
  minkref::python::bind_mesh_files(module);
  minkref::python::bind_convex(module);
}
