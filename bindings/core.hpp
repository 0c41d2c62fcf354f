// The pieces of the extension module minkref._core. Exact numbers cross the border as strings, "n"
// or "n/d", coordinates for drawing as doubles. Every computation releases the interpreter lock,
// and ends when a signal's handler raises an exception.
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "formats/reading.hpp"
#include "reference/form.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::python {

using ExactPoint = std::pair<std::string, std::string>;

/// A dictionary of named fields.
using Fields = nanobind::typed<nanobind::dict, nanobind::str, nanobind::any>;

inline ExactPoint to_strings(const Point& point) {
  return {to_string(point.x), to_string(point.y)};
}

/// Python's PolygonSet: the set, whether it is known to be canonical (which saves a
/// canonicalization), the places of its rings within the source file, and the reader's warnings.
struct Set {
  PolygonSet value;
  bool canonical = false;
  std::vector<RingOrigin> origins = {};
  std::vector<std::string> warnings = {};
};

/// kind "S" or "T", sign, ring and index of the edge, ring and index of the vertex.
using EdgeRow =
    std::tuple<std::string, int, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;
std::vector<EdgeRow> convolution_rows(const std::vector<ConvolutionEdge>& edges);

/// Bytes that the process may have in memory while C++ computes: the number set, otherwise nine
/// tenths of the memory available at the first question of a call.
void set_memory_limit(std::uint64_t bytes);
std::uint64_t memory_limit();

/// Throws LimitExceeded ("memory-limit") if the edges of a convolution, or the pairs of triangles
/// for `definition`, would take more memory than allowed; asks before making any.
void refuse_large_convolution(const PolygonSet& P, const PolygonSet& Q, bool full = false);
void refuse_large_definition(const PolygonSet& P, const PolygonSet& Q);

/// "printed" or "corrected"; throws BadInput otherwise.
Form form_named(const std::string& name);

/// A guard: while it lives, C++ computes without the interpreter lock, whatever floating-point
/// environment a library has left to Python's thread; an exception from a signal's handler, like
/// KeyboardInterrupt, ends the work, and so does the memory limit (LimitExceeded).
class Computing {
 public:
  Computing();

 private:
  nanobind::gil_scoped_release released_;
  FloatEnvironment standard_;
  Interruptible interruptible_;
};
using Released = nanobind::call_guard<Computing>;

/// What the work gives, where the rest of a call needs the interpreter lock.
template <class Work>
auto computed(const Work& work) {
  const Computing computing;
  return work();
}

/// For a class whose values never change: copy.copy and copy.deepcopy give the value itself.
template <typename Value>
nanobind::class_<Value>& unchanging(nanobind::class_<Value>&& bound) {
  return bound.def("__copy__", [](const nanobind::object& self) { return self; })
      .def(
          "__deepcopy__", [](const nanobind::object& self, nanobind::handle) { return self; },
          nanobind::arg("memo"));
}

void bind_errors(nanobind::module_& module);
void bind_polygon_set(nanobind::module_& module);
void bind_files(nanobind::module_& module);
void bind_sum(nanobind::module_& module);
void bind_disc(nanobind::module_& module);
void bind_disc_events(nanobind::module_& module);
void bind_disc_index(nanobind::module_& module);
void bind_disc_pair_events(nanobind::module_& module);
void bind_convolution(nanobind::module_& module);
void bind_events(nanobind::module_& module);
void bind_conditions(nanobind::module_& module);
void bind_arrangement(nanobind::module_& module);
void bind_dynamic(nanobind::module_& module);
void bind_index(nanobind::module_& module);
void bind_timed_index(nanobind::module_& module);
void bind_comparison(nanobind::module_& module);
void bind_regions(nanobind::module_& module);
void bind_set_operations(nanobind::module_& module);
void bind_decomposition(nanobind::module_& module);
void bind_paper_disc_update(nanobind::module_& module);
void bind_paper_update(nanobind::module_& module);
void bind_evidence(nanobind::module_& module);
void bind_search(nanobind::module_& module);
void bind_certify(nanobind::module_& module);
void bind_space(nanobind::module_& module);
void bind_polyhedral_set(nanobind::module_& module);
void bind_space_events(nanobind::module_& module);
void bind_contacts_as_read(nanobind::module_& module);
void bind_sum_surface(nanobind::module_& module);
void bind_mesh_files(nanobind::module_& module);
void bind_convex(nanobind::module_& module);
void bind_paper_repair(nanobind::module_& module);

}  // namespace minkref::python
