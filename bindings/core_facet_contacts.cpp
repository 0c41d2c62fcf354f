// Two facets at all scales, as the paper reads them (Sec. 5), over rational numbers.
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_readings.hpp"
#include "bindings/core_space.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/paper/space/facet_contacts.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using Contacts = FacetContacts<Rational>;
using CornerText = std::pair<ExactSpacePoint, ExactSpacePoint>;  ///< of s p + q: p and q
/// "vertex" or "edge", the scale if there is an event.
using ContactRow = std::tuple<std::string, std::optional<std::string>>;

/// The points' numbers: equal points have one.
class PointNumbers {
 public:
  std::uint32_t operator()(const ExactSpacePoint& point) {
    const auto found = std::ranges::find(points_, point);
    if (found != points_.end()) return static_cast<std::uint32_t>(found - points_.begin());
    points_.push_back(point);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

 private:
  std::vector<ExactSpacePoint> points_;
};

std::vector<ContactRow> facet_contacts(const std::vector<CornerText>& first,
                                       const std::vector<CornerText>& second,
                                       const Words& readings) {
  PointNumbers of_P, of_Q;
  const auto vector = [](const ExactSpacePoint& point) {
    const auto& [x, y, z] = point;
    return Contacts::Vector(parse_rational(x), parse_rational(y), parse_rational(z));
  };
  const auto facet = [&](const std::vector<CornerText>& corners) {
    if (corners.size() < 3) throw std::invalid_argument("a facet has three corners or more");
    Contacts::Facet result;
    for (const auto& [p, q] : corners) {
      result.push_back({vector(p), vector(q), of_P(p), of_Q(q)});
    }
    return result;
  };
  const Contacts::Facet a = facet(first), b = facet(second);
  const auto as_read = readings_of<FacetReadings>(readings);
  const Rational zero = 0;
  std::vector<ContactRow> rows;
  for (const auto& contact : Contacts(a, b, as_read, zero).all()) {
    std::optional<std::string> scale;
    if (contact.scale) scale = to_string(*contact.scale);
    rows.emplace_back(contact.kind == ContactKind::vertex ? "vertex" : "edge", std::move(scale));
  }
  return rows;
}

}  // namespace

void bind_contacts_as_read(nb::module_& module) {
  module.def(
      "facet_contacts", &facet_contacts, "first"_a, "second"_a, "readings"_a = Words{}, Released(),
      "Contacts of two convex facets with corners s p + q, each given by p and q (Sec. 5.1, 5.2), "
      "as read: vertex for each corner of the first and of the second, edge for each side of the "
      "first with each of the second, and once more for the second scale of coplanar sides; the "
      "scale, if there is an event. `readings`: as `facet_readings` lists them; those left out are "
      "the printed ones. Rational numbers. Raises BadInput, and ValueError for fewer than three "
      "corners. O(1) for triangles and parallelograms.");
}

}  // namespace minkref::python
