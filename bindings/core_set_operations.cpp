// Unions, intersections and differences of polygon sets in Python.
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <stdexcept>
#include <tuple>

#include "bindings/core.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/plane/boundary/set_operations.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

SetOperation operation_of(const std::string& name) {
  if (name == "union") return SetOperation::unite;
  if (name == "intersection") return SetOperation::intersect;
  if (name == "difference") return SetOperation::subtract;
  throw std::invalid_argument("an operation is union, intersection or difference");
}

std::tuple<Set, std::size_t, std::size_t> combined_sets(const std::string& operation,
                                                        const std::vector<Set>& sets) {
  std::vector<PolygonSet> values;
  values.reserve(sets.size());
  for (const Set& set : sets) values.push_back(set.value);
  Canonical form = combined(operation_of(operation), values);
  return {Set{std::move(form.region), true}, form.components, form.holes};
}

FillRule rule_of(const std::string& name) {
  if (name == "nonzero") return FillRule::nonzero;
  if (name == "evenodd") return FillRule::evenodd;
  if (name == "positive") return FillRule::positive;
  throw std::invalid_argument("a rule is nonzero, evenodd or positive");
}

std::pair<Set, bool> filled_rings(const Set& rings, const std::string& rule) {
  Canonical form = filled(rings.value, rule_of(rule));
  return {Set{std::move(form.region), true}, form.well_formed};
}

}  // namespace

void bind_set_operations(nb::module_& module) {
  module.def(
      "combined", &combined_sets, "operation"_a, "sets"_a, Released(),
      "The closure of the interior of a union, of an intersection, or of the first set without "
      "the others (difference), canonical; its components and holes. Points and segments have no "
      "interior. Exact. O((n + k) log n) for n vertices and k crossings.");
  module.def("filled", &filled_rings, "rings"_a, "rule"_a, Released(),
             "The closure of the points inside a set's rings, which may cross, by a rule: nonzero, "
             "evenodd or positive winding numbers; canonical. And whether all winding numbers are "
             "0 or 1. Exact. O((n + k) log n).");
}

}  // namespace minkref::python
