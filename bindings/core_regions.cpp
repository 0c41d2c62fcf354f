// Foreign results, as rings in any order, brought to canonical form; the difference of two sets.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "bindings/core.hpp"
#include "formats/input.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/witness.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// Set, components, holes, a point of a ring without area, a point where the rings overlap.
using Region =
    std::tuple<Set, std::size_t, std::size_t, std::optional<ExactPoint>, std::optional<ExactPoint>>;

Polygon alone(Ring outer) { return {std::move(outer), {}}; }

Ring reversed(Ring ring) {
  std::ranges::reverse(ring);
  return ring;
}

/// The closure of `first` without `second`: the points with positive winding number of the rings of
/// `first` and the reversed rings of `second`.
PolygonSet minus(const PolygonSet& first, const PolygonSet& second) {
  if (first.empty()) return {};
  PolygonSet rings = first;
  for (const Polygon& polygon : second.polygons) {
    rings.polygons.push_back(alone(reversed(polygon.outer)));
    for (const Ring& hole : polygon.holes) rings.polygons.push_back(alone(reversed(hole)));
  }
  return canonicalize(rings).region;
}

/// Throws LimitExceeded for coordinates beyond the reader's limit on digits: foreign sets may have
/// crossings of any length.
void refuse_long_numbers(const PolygonSet& set) {
  const std::size_t most = ReadLimits{}.number.digits;
  const auto is_long = [&](const Rational& value) {
    return mpz_sizeinbase(mpq_numref(value.backend().data()), 10) +
               mpz_sizeinbase(mpq_denref(value.backend().data()), 10) >
           most + 2;
  };
  const auto look = [&](const Ring& ring) {
    for (const Point& point : ring) {
      if (is_long(point.x) || is_long(point.y)) {
        throw LimitExceeded("number-too-long",
                            "a coordinate has more than " + std::to_string(most) + " digits",
                            "round the input, or raise the limit on digits");
      }
    }
  };
  for (const Polygon& polygon : set.polygons) {
    look(polygon.outer);
    for (const Ring& hole : polygon.holes) look(hole);
  }
}

std::optional<ExactPoint> inner_point(const PolygonSet& set) {
  const auto found = difference(set, {});
  return found ? std::optional(to_strings(found->point)) : std::nullopt;
}

/// A point that the rings wind around twice or more, or less than zero times.
std::optional<ExactPoint> overlap(const PolygonSet& rings, const PolygonSet& canonical) {
  if (auto twice = inner_point(minus(rings, canonical))) return twice;
  PolygonSet turned;
  for (const Polygon& polygon : rings.polygons) {
    turned.polygons.push_back(alone(reversed(polygon.outer)));
    for (const Ring& hole : polygon.holes) turned.polygons.push_back(alone(reversed(hole)));
  }
  return inner_point(canonicalize(turned).region);
}

/// Whether all vertices lie on one line.
bool is_flat(const Ring& ring) {
  const auto other = std::ranges::find_if(ring, [&](const Point& p) { return p != ring.front(); });
  if (other == ring.end()) return true;
  const Rational dx = other->x - ring.front().x, dy = other->y - ring.front().y;
  return std::all_of(other, ring.end(), [&](const Point& p) {
    return Rational(dx * (p.y - ring.front().y)) == dy * (p.x - ring.front().x);
  });
}

/// The ring, turned to run counter-clockwise (`left`) or clockwise.
Ring turned(Ring ring, bool left) {
  return (doubled_area(ring) > 0) == left ? ring : reversed(std::move(ring));
}

/// The rings of a result, sorted out.
class Claim {
 public:
  void add(const std::vector<Ring>& rings, bool turn) {
    for (const Ring& ring : rings) {
      if (ring.size() < 3) note(short_, ring);
    }
    if (rings.empty() || rings[0].size() < 3) return;
    Polygon polygon;
    for (std::size_t i = 1; i < rings.size(); ++i) {
      if (rings[i].size() < 3 || flat(rings[i])) continue;
      polygon.holes.push_back(turn ? turned(rings[i], false) : rings[i]);
    }
    if (flat(rings[0])) return;
    polygon.outer = turn ? turned(rings[0], true) : rings[0];
    kept_.polygons.push_back(std::move(polygon));
  }

  Region region() const {
    Canonical form = canonicalize(kept_);
    std::optional<ExactPoint> twice;
    if (!form.well_formed) twice = overlap(kept_, form.region);
    return {Set{std::move(form.region), true}, form.components, form.holes, short_ ? short_ : flat_,
            twice};
  }

 private:
  static void note(std::optional<ExactPoint>& first, const Ring& ring) {
    if (!first && !ring.empty()) first = to_strings(ring.front());
  }

  bool flat(const Ring& ring) {
    const bool is = is_flat(ring);
    if (is) note(flat_, ring);
    return is;
  }

  PolygonSet kept_;
  std::optional<ExactPoint> short_, flat_;  ///< a point of the first ring of fewer than three
                                            ///< vertices, of the first other one without area
};

std::string number(nb::handle value) {
  return nb::isinstance<nb::str>(value) ? nb::cast<std::string>(value)
                                        : nb::cast<std::string>(nb::str(value));
}

/// Numbers the rings as they come.
class RingReader {
 public:
  Ring ring(nb::handle points) {
    Place where;
    where.ring = rings_++;
    Ring ring;
    for (const nb::handle point : points) {
      where.vertices = {ring.size()};
      input_.count_vertex(where);
      Rational x = input_.number(number(point[0]), where);
      ring.push_back({std::move(x), input_.number(number(point[1]), where)});
    }
    return ring;
  }

 private:
  ReadLimits limits_;
  Input input_{"", limits_};
  std::size_t rings_ = 0;
};

Region region_of_rings(const nb::sequence& polygons, bool turn) {
  RingReader reader;
  std::vector<std::vector<Ring>> read;
  for (const nb::handle polygon : polygons) {
    auto& rings = read.emplace_back();
    for (const nb::handle ring : polygon) rings.push_back(reader.ring(ring));
  }
  const Computing released;
  Claim claim;
  for (const auto& rings : read) claim.add(rings, turn);
  return claim.region();
}

}  // namespace

void bind_regions(nb::module_& module) {
  module.def("region_of_rings", region_of_rings, "polygons"_a, "turned"_a = false,
             nb::sig("def region_of_rings(polygons: collections.abc.Sequence[typing.Any], turned: "
                     "bool = False) -> "
                     "tuple[PolygonSet, int, int, tuple[str, str] | None, tuple[str, str] | None]"),
             "The set of points around which the rings wind a positive number of times, canonical; "
             "its components and holes; a point of a ring without area, if there is one; a point "
             "around which the rings wind twice or more, or less than zero times. Polygons: lists "
             "of rings, the outer one first, of points (x, y) of texts, ints or Fractions. With "
             "`turned` outer rings are made to run counter-clockwise and holes clockwise; without, "
             "a ring that runs the wrong way counts as it runs. Exact.");
  module.def(
      "minus",
      [](const Set& first, const Set& second) {
        refuse_long_numbers(first.value);
        refuse_long_numbers(second.value);
        return Set{minus(first.value, second.value), true};
      },
      "first"_a, "second"_a, Released(),
      "The closure of `first` without `second`, canonical. Raises LimitExceeded for coordinates of "
      "more digits than are read.");
  module.def(
      "inner_point", [](const Set& set) { return inner_point(set.value); }, "set"_a, Released(),
      "A point in the interior of the set, of few digits; None where it is empty.");
}

}  // namespace minkref::python
