// Bindings that the evidence needs beyond the reference's results.
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <tuple>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/paper/trials/filter_trial.hpp"
#include "reference/plane/routes/face_points.hpp"
#include "reference/plane/witness.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

std::vector<std::tuple<std::string, std::string, bool>> points_of_faces(const Set& P, const Set& Q,
                                                                        const std::string& scale) {
  std::vector<std::tuple<std::string, std::string, bool>> result;
  for (const FacePoint& face : face_points(P.value, Q.value, parse_rational(scale))) {
    result.emplace_back(to_string(face.point.x), to_string(face.point.y), face.in_sum);
  }
  return result;
}

std::vector<std::string> decide_many(const Set& P, const Set& Q, const std::string& scale,
                                     const std::vector<ExactPoint>& points) {
  const Membership membership(P.value, Q.value, parse_rational(scale));
  std::vector<std::string> contacts;
  for (const auto& [x, y] : points) {
    const Contact contact = membership.decide({parse_rational(x), parse_rational(y)}).contact;
    contacts.emplace_back(contact == Contact::empty      ? "empty"
                          : contact == Contact::touching ? "touching"
                                                         : "overlapping");
  }
  return contacts;
}

Fields trial_of_filter(std::uint64_t seed, std::uint64_t count) {
  const FilterTrial trial = computed([&] { return filter_trial(seed, count); });
  Fields fields;
  MINKREF_PUT(trial, trials, by_filter, filter_wrong, handed_on, doubles_wrong);
  return fields;
}

}  // namespace

void bind_evidence(nb::module_& module) {
  module.def("face_points", points_of_faces, "P"_a, "Q"_a, "scale"_a, Released(),
             "An interior point of every bounded face of the reduced convolution's arrangement: x, "
             "y, in_sum.");
  module.def("decide_many", decide_many, "P"_a, "Q"_a, "scale"_a, "points"_a, Released(),
             "The contact (empty, touching, overlapping) of each point, by pairs of triangles.");
  module.def(
      "filter_trial", trial_of_filter, "seed"_a, "count"_a,
      "Hard turns: how many the float filter certified, handed on, and plain doubles got wrong.");
}

}  // namespace minkref::python
