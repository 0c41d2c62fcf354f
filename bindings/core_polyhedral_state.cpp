#include "bindings/core_polyhedral_state.hpp"

#include <utility>

#include "reference/error.hpp"
#include "reference/plane/boundary/canonical.hpp"

namespace minkref::python {
namespace {

[[noreturn]] void refuse() {
  throw BadInput("damaged-set", "these are not the planes of a set in canonical form",
                 "unpickle what was pickled");
}

Integer integer_of(const std::string& text) {
  const Rational value = parse_rational(text);
  if (denominator(value) != 1) refuse();
  return numerator(value);
}

std::vector<ExactPoint> texts_of(const Ring& ring) {
  std::vector<ExactPoint> result;
  for (const Point& point : ring) result.emplace_back(to_string(point.x), to_string(point.y));
  return result;
}

Ring ring_of(const std::vector<ExactPoint>& texts) {
  if (texts.size() < 3) refuse();
  Ring result;
  for (const auto& [x, y] : texts) result.push_back({parse_rational(x), parse_rational(y)});
  return result;
}

}  // namespace

std::vector<PlaneRow> state_of(const PolyhedralSet& set) {
  std::vector<PlaneRow> rows;
  for (const auto& [plane, region] : set.faces) {
    look_for_interrupt();
    std::vector<std::vector<std::vector<ExactPoint>>> polygons;
    for (const Polygon& polygon : region.polygons) {
      auto& rings = polygons.emplace_back();
      rings.push_back(texts_of(polygon.outer));
      for (const Ring& hole : polygon.holes) rings.push_back(texts_of(hole));
    }
    const IntegerVector& n = plane.normal;
    rows.emplace_back(ExactSpacePoint(n[0].str(), n[1].str(), n[2].str()), to_string(plane.offset),
                      std::move(polygons));
  }
  return rows;
}

PolyhedralSet set_of_state(const std::vector<PlaneRow>& state) {
  PolyhedralSet set;
  for (const auto& [normal, offset, polygons] : state) {
    look_for_interrupt();
    const auto& [x, y, z] = normal;
    const IntegerVector n{integer_of(x), integer_of(y), integer_of(z)};
    if (is_zero(n) || primitive(n) != n || polygons.empty()) refuse();
    PlaneRegion face{{n, parse_rational(offset)}, {}};
    for (const auto& rings : polygons) {
      if (rings.empty()) refuse();
      Polygon polygon{ring_of(rings[0]), {}};
      for (std::size_t k = 1; k < rings.size(); ++k) polygon.holes.push_back(ring_of(rings[k]));
      face.region.polygons.push_back(std::move(polygon));
    }
    const Canonical canonical = canonicalize(face.region);
    if (!canonical.well_formed || !(canonical.region == face.region)) refuse();
    if (!set.faces.empty() && !(set.faces.back().plane < face.plane)) refuse();
    set.faces.push_back(std::move(face));
  }
  return set;
}

}  // namespace minkref::python
