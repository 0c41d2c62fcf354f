// Canonical form, difference and the decision of a point for Python.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <optional>
#include <tuple>

#include "bindings/core.hpp"
#include "bindings/plane_scale.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/witness.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

std::tuple<Set, std::size_t, std::size_t, bool> canonical(const Set& set) {
  Canonical form = canonicalize(set.value);
  return {Set{std::move(form.region), true}, form.components, form.holes, form.well_formed};
}

nb::object list_of(const std::optional<Point>& point) {
  if (!point) return nb::none();
  nb::list coordinates;
  coordinates.append(to_string(point->x));
  coordinates.append(to_string(point->y));
  return coordinates;
}

const char* word(Contact contact) {
  if (contact == Contact::empty) return "empty";
  return contact == Contact::touching ? "touching" : "overlapping";
}

Fields decision(const Set& P, const Set& Q, const std::string& scale, const std::string& x,
                const std::string& y) {
  Witness witness;
  {
    const Computing released;
    const ScaledOperand operand(P.value, scale);
    witness =
        decide(operand.set(), Q.value, operand.scale(), {parse_rational(x), parse_rational(y)});
    if (witness.p) witness.p = operand.of_P(*witness.p);
  }
  Fields fields;
  fields["contact"] = word(witness.contact);
  fields["p"] = list_of(witness.p);
  fields["q"] = list_of(witness.q);
  return fields;
}

std::optional<Fields> difference_point(const Set& first, const Set& second) {
  std::optional<Difference> found;
  {
    const Computing released;
    found = difference(first.value, second.value);
  }
  if (!found) return std::nullopt;
  Fields fields;
  fields["point"] = list_of(found->point);
  fields["in_first"] = found->in_first;
  return fields;
}

}  // namespace

void bind_comparison(nb::module_& module) {
  module.def(
      "canonicalize", canonical, "set"_a, Released(),
      "Canonical form, components, holes, and whether the rings' winding numbers are 0 and 1.");
  module.def(
      "decide", decision, "P"_a, "Q"_a, "scale"_a, "x"_a, "y"_a,
      "sP against x - Q by pairs of triangles: contact (empty, touching, overlapping), p, q.");
  module.def("difference", difference_point, "first"_a, "second"_a,
             "An interior point of the symmetric difference, or None where the sets are equal.");
}

}  // namespace minkref::python
