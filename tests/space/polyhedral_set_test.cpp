// The set that a surface bounds.
#include "reference/space/polyhedral_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>

#include "reference/plane/boundary/canonical.hpp"
#include "tests/space/convex/bodies.hpp"

namespace minkref::of_polyhedral_set {
namespace {

/// Faces alone in their planes take a short way to the form; the long way changes nothing more.
TEST(PolyhedralSet, FacesAloneInTheirPlanesAreInCanonicalForm) {
  bodies::for_each_seed(20, [](std::mt19937& dice) {
    const PolyhedralSet set = polyhedral_set(bodies::random_body(dice, 4));
    for (std::size_t k = 0; k < set.faces.size(); ++k) {
      EXPECT_EQ(canonicalize(set.faces[k].region).region, set.faces[k].region);
      if (k > 0) {
        EXPECT_LT(set.faces[k - 1].plane, set.faces[k].plane);
      }
    }
  });
}

TEST(PolyhedralSet, TrianglesTurnedAnyWayRoundGiveOneSet) {
  bodies::for_each_seed(20, [](std::mt19937& dice) {
    const Polyhedron body = bodies::random_tetrahedron(dice, 9);
    Polyhedron turned = body;
    for (Face& face : turned.faces) {
      std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(dice() % 3), face.end());
    }
    std::shuffle(turned.faces.begin(), turned.faces.end(), dice);
    EXPECT_EQ(polyhedral_set(turned), polyhedral_set(body));
  });
}

}  // namespace
}  // namespace minkref::of_polyhedral_set
