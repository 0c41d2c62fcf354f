// The static sum: three routes, the canonical form, areas, points by the definition, and laws.
#include <algorithm>
#include <tuple>

#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/location.hpp"
#include "reference/plane/sum.hpp"
#include "reference/plane/witness.hpp"
#include "tests/fuzzing/reference/pair_change.hpp"
#include "tests/fuzzing/reference/pair_input.hpp"

namespace minkref::fuzzing {

const Bounds bounds{.vertices = 16, .product = 80};

namespace {

/// The definition route takes all pairs of triangles: above this product it runs only now and then.
constexpr std::size_t definition_product = 40;

/// Equal canonical forms have equal digests.
void expect_same(const std::string& law, const Case& pair, const Sum& expected, const Sum& actual) {
  if (expected.region != actual.region) {
    broken(law, pair,
           canonical_json(expected.region) + "\nagainst\n" + canonical_json(actual.region));
  }
  if (expected.components != actual.components || expected.holes != actual.holes) {
    broken(law + ": components and holes", pair);
  }
}

/// A canonical form is its own form and an operand; holes and components equal the counts.
void check_canonical(const Case& pair, const Sum& sum) {
  const Canonical again = canonicalize(sum.region);
  if (!again.well_formed) broken("rings of a canonical form do not overlap", pair);
  expect_same("a canonical form is its own canonical form", pair, sum,
              {again.region, again.components, again.holes, {}, {}});
  validate(sum.region);
  if (sum.region.polygons.size() != sum.components) {
    broken("a canonical form has a polygon for each component", pair);
  }
}

/// Brunn and Minkowski: sqrt(sum's area) >= sqrt(area of sP) + sqrt(area of Q).
void check_area(const Case& pair, const Rational& s, const Sum& sum) {
  if (pair.P.empty() || pair.Q.empty()) {
    if (!sum.region.empty()) broken("a sum with the empty set is empty", pair);
    return;
  }
  const auto area_of = [](const PolygonSet& set) {
    return set.is_region() ? area(set) : Rational(0);
  };
  const Rational p = s * s * area_of(pair.P), q = area_of(pair.Q);
  const Rational more = area(sum) - p - q;
  if (sign(more) < 0 || more * more < 4 * p * q) {
    broken("Brunn and Minkowski's inequality", pair, to_string(more));
  }
}

/// Tests points on and near the convolution, decided by pairs of triangles.
void check_points(const Case& pair, const Rational& s, const Sum& sum, Dice& dice) {
  if (pair.P.empty() || pair.Q.empty()) return;
  const PolygonSet P = scaled(pair.P, s);
  const Membership membership(pair.P, pair.Q, s);
  const ChangeSite pick{dice, const_cast<PolygonSet&>(P), pair.Q};
  const auto vertex = [&] { return dice.of(pick.some_ring(P)) + dice.of(pick.some_ring(pair.Q)); };
  for (int i = 0; i < 4; ++i) {
    Point x = vertex();
    if (i % 2 == 1) x = Rational(1, 2) * (x + vertex());
    if (i == 3) x = x + Point{power_of_two(-30), -power_of_two(-31)};
    const Witness witness = membership.decide(x);
    const Location location = locate(sum.region, x);
    const std::string at = "(" + to_string(x.x) + ", " + to_string(x.y) + ")";
    if ((witness.contact == Contact::empty) != (location == Location::outside)) {
      broken("a point is in the sum where P and x - Q meet", pair, at);
    }
    if (i == 0 && location == Location::outside) broken("p + q is in the sum", pair, at);
    if (membership.contact(x) != witness.contact) broken("doubles tell true overlaps", pair, at);
    if (location == Location::boundary && witness.contact == Contact::overlapping) {
      broken("interiors do not meet on the boundary of the sum", pair, at);
    }
    if (witness.p && witness.q && s * *witness.p + *witness.q != x) {
      broken("s p + q is the point", pair, at);
    }
  }
}

struct Linear {
  int xx, xy, yx, yy;
  Point operator()(const Point& p) const { return {xx * p.x + xy * p.y, yx * p.x + yy * p.y}; }
};

PolygonSet mapped(PolygonSet set, const Linear& map) {
  map_points(set, map);
  orient(set);
  return set;
}

/// Every ring from another vertex, with a straight vertex more; polygons in another order.
PolygonSet written_otherwise(PolygonSet set, Dice& dice) {
  if (!set.is_region()) return set;
  const auto again = [&](Ring& ring) {
    const std::size_t n = ring.size(), k = dice.below(n);
    const Point middle = Rational(1, 3) * (ring[k] + Rational(2) * ring[(k + 1) % n]);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k) + 1, middle);
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(dice.below(n)),
                ring.end());
  };
  for (Polygon& polygon : set.polygons) {
    again(polygon.outer);
    for (Ring& hole : polygon.holes) again(hole);
    std::reverse(polygon.holes.begin(), polygon.holes.end());
  }
  std::reverse(set.polygons.begin(), set.polygons.end());
  return set;
}

Sum canonical_sum(const PolygonSet& region) {
  Canonical form = canonicalize(region);
  return {std::move(form.region), form.components, form.holes, {}, {}};
}

/// Checks a random law with a random route.
void check_law(const Case& pair, const Rational& s, const Sum& sum, Dice& dice) {
  static constexpr Route routes[] = {Route::paper,   Route::paper,   Route::paper,
                                     Route::winding, Route::winding, Route::definition};
  const Route route = dice.of(routes);
  const auto other = [&](const PolygonSet& P, const PolygonSet& Q, const Rational& scale) {
    return minkowski_sum(P, Q, scale, route);
  };
  const auto& [P, Q] = std::tie(pair.P, pair.Q);
  switch (dice.below(6)) {
    case 0: {
      const Point t{Rational(dice.between(-9, 9), 7), power_of_two(dice.between(0, 70))};
      return expect_same("translation of P", pair, canonical_sum(translated(sum.region, s * t)),
                         other(translated(P, t), Q, s));
    }
    case 1:
      return expect_same("exchange of operands", pair, canonical_sum(scaled(sum.region, 1 / s)),
                         other(Q, P, 1 / s));
    case 2: {
      const Rational k = dice.one_in(2) ? Rational(3, 7) : power_of_two(dice.between(-80, 80));
      return expect_same("scaling of both", pair, canonical_sum(scaled(sum.region, k)),
                         other(scaled(P, k), scaled(Q, k), s));
    }
    case 3:
      return expect_same("the scale as a part of P", pair, sum, other(scaled(P, s), Q, 1));
    case 4: {
      static constexpr Linear maps[] = {{-1, 0, 0, 1}, {0, -1, 1, 0}, {1, 2, 0, 1},
                                        {2, 1, 1, 1},  {3, 0, 0, 1},  {0, 1, 1, 0}};
      const Linear& map = dice.of(maps);
      return expect_same("a linear map", pair, canonical_sum(mapped(sum.region, map)),
                         other(mapped(P, map), mapped(Q, map), s));
    }
    default:
      return expect_same("the same sets written otherwise", pair, sum,
                         other(written_otherwise(P, dice), written_otherwise(Q, dice), s));
  }
}

void check(const Case& pair, Dice& dice) {
  const Rational s = scale_of(pair);
  const Sum sum = minkowski_sum(pair.P, pair.Q, s);
  expect_same("route winding is route paper", pair, sum,
              minkowski_sum(pair.P, pair.Q, s, Route::winding));
  if (pair.P.vertices() * pair.Q.vertices() <= definition_product || dice.one_in(4)) {
    expect_same("route definition is route paper", pair, sum,
                minkowski_sum(pair.P, pair.Q, s, Route::definition));
  }
  check_canonical(pair, sum);
  check_area(pair, s, sum);
  check_points(pair, s, sum, dice);
  check_law(pair, s, sum, dice);
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minkref::fuzzing::check_pair(data, size, minkref::fuzzing::check);
}
