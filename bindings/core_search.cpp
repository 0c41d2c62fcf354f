// Searches for intersections for Python: the dynamic update's rivals on the clock.
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include "bindings/core.hpp"
#include "bindings/stopwatch.hpp"
#include "reference/paper/trials/intersection_search.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// How many were found, and in how many seconds.
using Found = std::pair<std::size_t, double>;

template <class Search>
Found timed_run(Search& search, const std::string& scale) {
  const Rational s = parse_rational(scale);
  const Stopwatch watch;
  const std::size_t count = search.run(s);
  const double seconds = watch.seconds();
  return {count, seconds};
}

template <class Search>
void bind_search_class(nb::module_& module, const char* name, const char* text) {
  nb::class_<Search>(module, name, text)
      .def(
          "__init__",
          [](Search* self, const Set& P, const Set& Q) { new (self) Search(P.value, Q.value); },
          "P"_a, "Q"_a, Released())
      .def("run", timed_run<Search>, "scale"_a, Released(),
           "How many intersections there are at a scale, and the seconds that it took.");
}

}  // namespace

void bind_search(nb::module_& module) {
  bind_search_class<PairwiseSearch>(
      module, "PairwiseSearch",
      "Every pair of edges of the reduced convolution, in plain doubles: a yardstick, not exact.");
  bind_search_class<ContactSearch>(
      module, "ContactSearch",
      "The contacts of the edges of the reduced convolution by a tree of boxes, exact.");
}

}  // namespace minkref::python
