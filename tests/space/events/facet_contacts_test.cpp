// The paper's way to events of two facets (Sec. 5.1, 5.2), over rational numbers.
#include "reference/paper/space/facet_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_facet_contacts {
namespace {

using Contacts = FacetContacts<Rational>;

Contacts::Facet facet_of(const MovingConvolution& convolution, const MovingFacet& facet) {
  const auto vector = [](const IntegerVector& v) {
    return Contacts::Vector(Rational(v[0]), Rational(v[1]), Rational(v[2]));
  };
  Contacts::Facet corners;
  for (std::size_t k = 0; k < facet.size; ++k) {
    corners.push_back({vector(convolution.P.points[facet.names[k].of_P].exact),
                       vector(convolution.Q.points[facet.names[k].of_Q].exact)});
  }
  return corners;
}

std::set<Rational> scales_of(const std::vector<PaperContact<Rational>>& contacts) {
  std::set<Rational> scales;
  for (const auto& contact : contacts) {
    if (contact.scale) scales.insert(*contact.scale);
  }
  return scales;
}

bool has_a_side_along(const MovingFacet& a, const MovingFacet& b) {
  const auto along = [](const MovingFacet& own, const MovingFacet& other) {
    for (std::size_t k = 0; k < own.size; ++k) {
      if (dot(other.normal.exact, own.along[k].exact).is_zero()) return true;
    }
    return false;
  };
  return along(a, b) || along(b, a);
}

/// With exact numbers the three equations agree. The printed form finds nothing if a side is
/// parallel to the other plane: at the scale that puts the side into the plane, it may cross sides.
TEST(FacetContacts, HaveTheScalesOfTheExactEvents) {
  std::size_t events = 0, missed = 0;
  bodies::for_each_seed(2, [&](std::mt19937& dice) {
    const auto u_shape = [&] {
      return polycubes::solid(polycubes::without(polycubes::block({0, 0, 0}, {3, 2, 1}),
                                                 polycubes::block({1, 1, 0}, {2, 2, 1})),
                              polycubes::random_matrix(dice, 4));
    };
    const Polyhedron P = u_shape(), Q = u_shape();
    const SpaceOperands operands = space_operands(P, Q, {1, 1, 1});
    const MovingConvolution convolution(operands.P, operands.Q);
    for (std::size_t i = 0; i < convolution.facets.size(); ++i) {
      for (std::size_t j = i + 1; j < convolution.facets.size(); ++j) {
        if ((i + j) % 12 != 9) continue;  // exact systems are slow
        const MovingFacet &a = convolution.facets[i], &b = convolution.facets[j];
        if (is_zero(cross(a.normal.exact, b.normal.exact))) continue;
        SignCounts signs;
        std::set<Rational> truth;
        for (const FacetEvent& event : ContactRegion(convolution, a, b, signs).events()) {
          truth.insert(event.s.exact());
        }
        const Contacts::Facet first = facet_of(convolution, a), second = facet_of(convolution, b);
        ASSERT_EQ(scales_of(Contacts(first, second, Form::corrected).all()), truth);
        const auto printed = scales_of(Contacts(first, second, Form::printed).all());
        ASSERT_TRUE(std::includes(truth.begin(), truth.end(), printed.begin(), printed.end()));
        ASSERT_TRUE(printed == truth || has_a_side_along(a, b));
        events += truth.size();
        missed += truth.size() - printed.size();
      }
    }
  });
  EXPECT_GT(events, 30U);
  EXPECT_GT(missed, 0U);
}

}  // namespace
}  // namespace minkref::of_facet_contacts
