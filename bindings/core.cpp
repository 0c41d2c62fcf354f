// The extension module minkref._core.
#include "bindings/core.hpp"

#include <gmp.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <new>

#include "bindings/core_clearance.hpp"
#include "bindings/core_convolution.hpp"
#include "bindings/core_disc_paths.hpp"
#include "bindings/core_erosion.hpp"
#include "bindings/core_features.hpp"
#include "bindings/core_paper_space_update.hpp"
#include "bindings/core_paths.hpp"
#include "bindings/core_scene.hpp"
#include "reference/error.hpp"
#include "reference/memory.hpp"
#include "reference/plane/convolution/convolution_size.hpp"

namespace minkref::python {
namespace {

std::atomic<std::uint64_t> limit_that_was_set = 0;

/// For each look the interpreter has to be free: some times a second are enough.
class Look {
 public:
  void operator()() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return;
    last_ = now;
    if (limit_ == 0) limit_ = memory_limit();
    check_memory(limit_, "this");
    const nanobind::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw nanobind::python_error();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::uint64_t limit_ = 0;
};

}  // namespace

void set_memory_limit(std::uint64_t bytes) { limit_that_was_set = bytes; }

std::uint64_t memory_limit() {
  if (const std::uint64_t bytes = limit_that_was_set; bytes != 0) return bytes;
  const std::uint64_t rest = available_bytes();
  return resident_bytes() + rest / 10 * 9;
}

namespace {

/// The least memory of every route for each edge of the convolution, or each pair of triangles.
constexpr std::uint64_t least_bytes = 100;

void require_room(std::uint64_t count, const std::string& what) {
  const std::uint64_t limit = memory_limit(), now = resident_bytes();
  if (now <= limit && count <= (limit - now) / least_bytes) return;
  throw LimitExceeded("memory-limit",
                      "there are " + std::to_string(count) + " " + what + ", which take " +
                          std::to_string((count * least_bytes >> 20) + 1) +
                          " MiB at the least; the process has " + std::to_string(now >> 20) +
                          " MiB of the " + std::to_string(limit >> 20) + " MiB that it may have",
                      "raise the limit, or take simpler operands");
}

}  // namespace

void refuse_large_convolution(const PolygonSet& P, const PolygonSet& Q, bool full) {
  refuse_large_convolution(P, Q, full, Between::half_open);
}

void refuse_large_convolution(const PolygonSet& P, const PolygonSet& Q, bool full,
                              Between between) {
  constexpr std::uint64_t few = 1 << 20;
  if (std::uint64_t{2} * P.vertices() * Q.vertices() < few) return;
  require_room(convolution_size(P, Q, full, between), "edges of the convolution");
}

void refuse_large_definition(const PolygonSet& P, const PolygonSet& Q) {
  require_room(std::uint64_t{P.vertices()} * Q.vertices(), "pairs of triangles");
}

/// Lets GMP throw when memory runs out; by default GMP ends the process.
void let_gmp_raise() {
  static constexpr auto check = [](void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
  };
  mp_set_memory_functions(
      [](std::size_t bytes) { return check(std::malloc(bytes)); },
      [](void* old, std::size_t, std::size_t bytes) { return check(std::realloc(old, bytes)); },
      [](void* memory, std::size_t) { std::free(memory); });
}

Computing::Computing() : interruptible_(Look()) {}

}  // namespace minkref::python

NB_MODULE(_core, module) {
  using namespace nanobind::literals;
  // Objects alive at the interpreter's end, as of a thread that runs on, are no fault to report.
  nanobind::set_leak_warnings(false);
  minkref::python::let_gmp_raise();
  if (const char* fault = minkref::FloatEnvironment::fault(); fault != nullptr) {
    throw nanobind::import_error(fault);
  }
  module.doc() =
      "The exact reference, in the plane and in space; exact numbers are Fractions, or texts n and "
      "n/d in rows.";
  module.attr("__version__") = MINKREF_VERSION;
  minkref::python::bind_errors(module);
  module.def("set_memory_limit", &minkref::python::set_memory_limit, "bytes"_a,
             "Bytes that the process may have in memory while C++ computes; 0: nine tenths of what "
             "the system has. Beyond them a call raises LimitExceeded.");
  module.def("memory_limit", &minkref::python::memory_limit,
             "The bytes that were set, or what is free now.");
  minkref::python::bind_polygon_set(module);
  minkref::python::bind_files(module);
  minkref::python::bind_sum(module);
  minkref::python::bind_disc(module);
  minkref::python::bind_disc_events(module);
  minkref::python::bind_disc_index(module);
  minkref::python::bind_disc_pair_events(module);
  minkref::python::bind_disc_paths(module);
  minkref::python::bind_features(module);
  minkref::python::bind_convolution(module);
  minkref::python::bind_conditions(module);
  minkref::python::bind_events(module);
  minkref::python::bind_arrangement(module);
  minkref::python::bind_dynamic(module);
  minkref::python::bind_index(module);
  minkref::python::bind_paths(module);
  minkref::python::bind_clearance(module);
  minkref::python::bind_scene(module);
  minkref::python::bind_scene_questions(module);
  minkref::python::bind_space_paths(module);
  minkref::python::bind_timed_index(module);
  minkref::python::bind_comparison(module);
  minkref::python::bind_regions(module);
  minkref::python::bind_set_operations(module);
  minkref::python::bind_decomposition(module);
  minkref::python::bind_erosion(module);
  minkref::python::bind_paper_disc_update(module);
  minkref::python::bind_paper_update(module);
  minkref::python::bind_evidence(module);
  minkref::python::bind_search(module);
  minkref::python::bind_certify(module);
  minkref::python::bind_space(module);
  minkref::python::bind_polyhedral_set(module);
  minkref::python::bind_paper_space_update(module);
  minkref::python::bind_space_events(module);
  minkref::python::bind_contacts_as_read(module);
  minkref::python::bind_sum_surface(module);
  minkref::python::bind_mesh_files(module);
  minkref::python::bind_convex(module);
  minkref::python::bind_paper_repair(module);
}
