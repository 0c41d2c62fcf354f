// Events of facet pairs: nothing changes between events, and each event changes something.
#include "reference/space/critical/facet_event.hpp"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_facet_event {
namespace {

using bodies::for_each_seed;
using polycubes::block;
using polycubes::solid;
using polycubes::with;
using RationalVector = std::array<Rational, 3>;

Rational dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
RationalVector minus(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
RationalVector product(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A facet at a scale, in rational numbers.
struct FixedFacet {
  std::vector<RationalVector> corners;
  RationalVector normal;

  FixedFacet(const MovingConvolution& convolution, const MovingFacet& facet, const Rational& s) {
    for (std::size_t k = 0; k < facet.size; ++k) {
      const auto& p = convolution.P.points[facet.names[k].of_P].exact;
      const auto& q = convolution.Q.points[facet.names[k].of_Q].exact;
      RationalVector corner;
      for (std::size_t i = 0; i < 3; ++i) corner[i] = s * Rational(p[i]) + Rational(q[i]);
      corners.push_back(corner);
    }
    normal = product(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
  }
};

/// The common part of two facets: the sides that bound its two ends on the planes' common line.
struct Shared {
  bool empty = false, is_point = false;
  std::set<std::size_t> first, last;
  friend bool operator==(const Shared&, const Shared&) = default;
};

Shared shared(const FixedFacet& f, const FixedFacet& g) {
  const RationalVector along = product(f.normal, g.normal);
  const Rational a = dot(f.normal, f.corners[0]), b = dot(g.normal, g.corners[0]);
  // x = (a (g x d) + b (d x f)) / (d . d) + t d is on both planes.
  const RationalVector u = product(g.normal, along), v = product(along, f.normal);
  const Rational square = dot(along, along);
  RationalVector start;
  for (std::size_t k = 0; k < 3; ++k) start[k] = (a * u[k] + b * v[k]) / square;
  Shared result;
  std::optional<Rational> low, high;
  std::size_t number = 0;
  for (const FixedFacet* facet : {&f, &g}) {
    for (std::size_t k = 0; k < facet->corners.size(); ++k, ++number) {
      const RationalVector& from = facet->corners[k];
      const RationalVector side = minus(facet->corners[(k + 1) % facet->corners.size()], from);
      const RationalVector inwards = product(facet->normal, side);
      const Rational height = dot(inwards, minus(start, from)), slope = dot(inwards, along);
      if (slope == 0) {
        result.empty = result.empty || height < 0;
        if (height == 0) result.first.insert(number), result.last.insert(number);
        continue;
      }
      const Rational t = -height / slope;
      auto& bound = slope > 0 ? low : high;
      auto& sides = slope > 0 ? result.first : result.last;
      if (!bound || (slope > 0 ? t > *bound : t < *bound)) {
        std::erase_if(sides, [&](std::size_t other) {
          const FixedFacet& owner = other < f.corners.size() ? f : g;
          const std::size_t at = other < f.corners.size() ? other : other - f.corners.size();
          const RationalVector edge =
              minus(owner.corners[(at + 1) % owner.corners.size()], owner.corners[at]);
          return dot(product(owner.normal, edge), along) != 0;
        });
        bound = t;
      }
      if (t == *bound) sides.insert(number);
    }
  }
  result.empty = result.empty || *low > *high;
  result.is_point = !result.empty && *low == *high;
  if (result.empty) result.first.clear(), result.last.clear();
  return result;
}

struct Counts {
  std::size_t events = 0, births = 0, deaths = 0, touches = 0, vertices = 0, edges = 0;
};

void check_pair(const MovingConvolution& convolution, const MovingFacet& a, const MovingFacet& b,
                Counts& counts) {
  space::SignCounts signs;
  const auto events = ContactRegion(convolution, a, b, signs).events();
  const auto at = [&](const Rational& s) {
    return shared(FixedFacet(convolution, a, s), FixedFacet(convolution, b, s));
  };
  std::vector<Rational> scales{Rational(1, 1000)};
  for (const FacetEvent& event : events) {
    EXPECT_EQ(event.s.sign(), 1);
    if (event.s.exact() > scales.back()) scales.push_back(event.s.exact());
    ++counts.events;
    counts.births += event.change == ContactChange::birth ? 1 : 0;
    counts.deaths += event.change == ContactChange::death ? 1 : 0;
    counts.touches += event.change == ContactChange::touch ? 1 : 0;
    (event.kind == ContactKind::vertex ? counts.vertices : counts.edges) += 1;
  }
  scales.push_back(scales.back() * 1000 + 1000);
  for (std::size_t k = 0; k + 1 < scales.size(); ++k) {
    const Rational &low = scales[k], &high = scales[k + 1];
    const Shared first = at(low + (high - low) / 1000), last = at(high - (high - low) / 1000);
    ASSERT_EQ(first, last) << "between " << low << " and " << high;
    if (k == 0) continue;
    const Shared before = at(low - (low - scales[k - 1]) / 1000), here = at(low);
    ASSERT_FALSE(before == first && here == first) << "at " << low;
    for (const FacetEvent& event : events) {
      if (event.s.exact() != low) continue;
      ASSERT_FALSE(here.empty);
      ASSERT_EQ(before.empty,
                event.change == ContactChange::birth || event.change == ContactChange::touch);
      ASSERT_EQ(first.empty,
                event.change == ContactChange::death || event.change == ContactChange::touch);
    }
  }
}

Counts check_all(const Polyhedron& P, const Polyhedron& Q) {
  const SpaceOperands operands = space_operands(P, Q, {1, 1, 1});
  const MovingConvolution convolution(operands.P, operands.Q);
  Counts counts;
  for (std::size_t i = 0; i < convolution.facets.size(); ++i) {
    for (std::size_t j = i + 1; j < convolution.facets.size(); ++j) {
      const MovingFacet &a = convolution.facets[i], &b = convolution.facets[j];
      if (!is_zero(cross(a.normal.exact, b.normal.exact))) check_pair(convolution, a, b, counts);
      if (::testing::Test::HasFatalFailure()) return counts;
    }
  }
  return counts;
}

TEST(FacetEvent, OfRandomTetrahedra) {
  for_each_seed(6, [&](std::mt19937& dice) {
    check_all(bodies::random_tetrahedron(dice, 9), bodies::random_tetrahedron(dice, 9));
  });
}

/// Everything ties: facets along the axes, of few different sizes.
TEST(FacetEvent, OfPolycubes) {
  Counts counts;
  for_each_seed(6, [&](std::mt19937& dice) {
    const auto part = [&] { return polycubes::random_cells(dice, 3, 2); };
    const Counts found = check_all(solid(part()), solid(part()));
    counts.events += found.events;
    counts.births += found.births;
    counts.deaths += found.deaths;
    counts.touches += found.touches;
    counts.vertices += found.vertices;
    counts.edges += found.edges;
  });
  EXPECT_GT(counts.births, 20U);
  EXPECT_GT(counts.deaths, 20U);
  EXPECT_GT(counts.vertices, 20U);
}

TEST(FacetEvent, OfAnAngleAndATetrahedron) {
  Counts counts;
  for_each_seed(10, [&](std::mt19937& dice) {
    const auto angle = with(block({0, 0, 0}, {2, 1, 1}), block({0, 0, 0}, {1, 2, 1}));
    const Counts found = check_all(solid(angle, polycubes::random_matrix(dice, 3)),
                                   bodies::random_tetrahedron(dice, 5));
    counts.edges += found.edges;
    counts.births += found.births;
  });
  EXPECT_GT(counts.edges, 20U);
  EXPECT_GE(counts.births, testing::repetitions(20U));
}

}  // namespace
}  // namespace minkref::of_facet_event
