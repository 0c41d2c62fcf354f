// Three routes that share as little as possible give the same answer.
#include <gtest/gtest.h>

#include "reference/plane/routes/face_points.hpp"
#include "reference/plane/sum.hpp"
#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_routes {
namespace {

std::string disagreement(const Case& c) {
  const Sum paper = minkowski_sum(c.P, c.Q, c.scale, Route::paper);
  for (const Route route : {Route::winding, Route::definition}) {
    const std::string name = route == Route::winding ? "winding: " : "definition: ";
    const Sum other = minkowski_sum(c.P, c.Q, c.scale, route);
    if (other.region != paper.region) return name + unequal(paper.region, other.region);
    if (other.components != paper.components) return name + "components differ";
    if (other.holes != paper.holes) return name + "holes differ";
  }
  return "";
}

TEST(Routes, AgreeOnRandomPairs) {
  MINKREF_SEEDED(random, 200);
  expect_law(random, 250, disagreement);
}

TEST(Routes, AgreeOnPiecesOfLattices) {
  MINKREF_SEEDED(random, 201);
  expect_law(random, 150, lattice_pieces(3, 2), disagreement);
}

TEST(Routes, AgreeOnPointsAndSegments) {
  MINKREF_SEEDED(random, 202);
  expect_law(random, 150, thin_and_wide(2, 3), disagreement);
}

TEST(Routes, AgreeOnNearlyDegeneratePairs) {
  MINKREF_SEEDED(random, 204);
  expect_law(random, 120, shaken_lattice_pieces(random_scale), disagreement);
}

TEST(Routes, AgreeAtScalesNextToDegenerateOnes) {
  MINKREF_SEEDED(random, 205);
  const auto make = [](Source& r) {
    const Rational hair(Integer(r.coin() ? 1 : -1), Integer(1) << r.between(20, 120));
    return Case{random_mesh_region(r, 3), random_mesh_region(r, 2),
                Rational(random_scale(r) + hair)};
  };
  expect_law(random, 120, make, disagreement);
}

TEST(Routes, EveryFaceOfTheArrangementIsDecidedRightly) {
  MINKREF_SEEDED(random, 203);
  expect_law(random, 12, regions, [](const Case& c) -> std::string {
    const PolygonSet region = minkowski_sum(c.P, c.Q, c.scale).region;
    for (const FacePoint& face : face_points(c.P, c.Q, c.scale)) {
      const std::string at = " at " + text(face.point);
      const Contact truth = contact_at(c.P, c.Q, c.scale, face.point);
      if (face.in_sum != (truth != Contact::empty)) return "a face is wrong" + at;
      const Where place = where(region, face.point);
      if (face.in_sum != (place == Where::inside)) return "the region is not its faces" + at;
    }
    return "";
  });
}

}  // namespace
}  // namespace minkref::testing::of_routes
