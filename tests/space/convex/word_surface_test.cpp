// The surface in words equals the static route's, scaling after scaling: edges find planes here,
// sorting there.
#include "reference/space/convex/word_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "tests/counted_turns.hpp"
#include "tests/space/convex/bodies.hpp"

namespace minkref::of_word_surfaces {
namespace {

using bodies::at;
using bodies::box;
using bodies::for_each_seed;
using bodies::random_body;
using bodies::random_scaling;

/// One surface for all steps of a walk.
class Walk {
 public:
  Walk(const Polyhedron& P, const Polyhedron& Q)
      : P_(P), Q_(Q), moving_(P_, Q_, bodies::unit), contacts_(P_, Q_) {}

  void step(const Scaling& to) {
    moving_.update(to);
    contacts_.rescale(to);
    const ConvexSum wanted = surface_of(P_, Q_, to, by_traversal(contacts_));
    ASSERT_TRUE(surface_.renew(moving_));
    const ConvexSum found = surface_.sum();
    ASSERT_EQ(found.surface, wanted.surface);
    EXPECT_EQ(found.facet_parents, wanted.facet_parents);
    EXPECT_EQ(found.vertex_parents, wanted.vertex_parents);
    (surface_.merged() == 0 ? general : degenerate) += 1;
  }

  int general = 0, degenerate = 0;

 private:
  ConvexPolyhedron P_, Q_;
  DynamicConvexSum moving_;
  Contacts contacts_;
  WordSurface surface_;
};

Polyhedron prism(int sides, int height, double phase = 0) {
  Polyhedron result;
  Face bottom, top;
  for (int k = 0; k < sides; ++k) {
    const double angle = phase + 2 * 3.14159265358979 * k / sides;
    const int x = static_cast<int>(std::lround(1e6 * std::cos(angle))),
              y = static_cast<int>(std::lround(1e6 * std::sin(angle)));
    const auto here = static_cast<std::uint32_t>(2 * k),
               next = static_cast<std::uint32_t>(2 * ((k + 1) % sides));
    result.vertices.push_back(at(x, y, 0));
    result.vertices.push_back(at(x, y, height));
    bottom.insert(bottom.begin(), here);
    top.push_back(here + 1);
    result.faces.push_back({here, next, next + 1, here + 1});
  }
  result.faces.push_back(bottom);
  result.faces.push_back(top);
  return result;
}

/// Over and, for two, below a polygon, which else is a facet.
Polyhedron cones(int sides, bool two) {
  const Polyhedron rim = prism(sides, 1, 0.1);
  Polyhedron result;
  const auto n = static_cast<std::uint32_t>(sides);
  Face bottom;
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    result.vertices.push_back(rim.vertices[2 * k]);
    result.faces.push_back({k, next, n});
    if (two) result.faces.push_back({next, k, n + 1});
    bottom.insert(bottom.begin(), k);
  }
  result.vertices.push_back(at(0, 0, 700000));
  if (two) {
    result.vertices.push_back(at(0, 0, -900000));
  } else {
    result.faces.push_back(bottom);
  }
  return result;
}

TEST(WordSurface, OfRandomBodiesIsTheStaticOne) {
  int general = 0, degenerate = 0;
  for (const int size : {2, 3, 30}) {
    for_each_seed(40, [&](std::mt19937& dice) {
      const Polyhedron P = random_body(dice, size);
      Walk walk(P, random_body(dice, size));
      for (int k = 0; k < 6; ++k) walk.step(random_scaling(dice));
      walk.step(bodies::unit);
      general += walk.general;
      degenerate += walk.degenerate;
    });
  }
  EXPECT_GT(general, 100);
  EXPECT_GT(degenerate, 100);
}

TEST(WordSurface, OfParallelFacetsAndEdgesIsTheStaticOne) {
  const std::vector<Polyhedron> alike{
      box(1, 1, 1),         box(3, 1, 2),
      bodies::octahedron(), bodies::with_apex(box(2, 2, 1), at(1, 1, 2)),
      prism(6, 5),          prism(40, 3),
      prism(40, 7, 0.02),   cones(40, false),
      prism(4, 10, 0),      cones(4, true)};
  std::mt19937 dice(1);
  int degenerate = 0;
  for (const Polyhedron& P : alike) {
    for (const Polyhedron& Q : alike) {
      Walk walk(P, Q);
      for (const Scaling& s :
           {bodies::unit, random_scaling(dice), Scaling{2, 2, 2}, Scaling{Rational(1, 3), 1, 1},
            Scaling{5, 5, Rational(1, 7)}, bodies::unit}) {
        walk.step(s);
      }
      degenerate += walk.degenerate;
    }
  }
  EXPECT_GT(degenerate, 300);
}

TEST(WordSurface, OfTheSameBodyInSmallStepsIsTheStaticOne) {
  int general = 0;
  for_each_seed(10, [&](std::mt19937& dice) {
    Polyhedron P = random_body(dice, 99);
    P = bodies::sum(P, random_body(dice, 99)).surface;
    Walk walk(P, P);
    Scaling s = bodies::unit;
    std::uniform_int_distribution<int> percent(-1, 1);
    for (int step = 0; step < 20; ++step) {
      walk.step(s);
      for (Rational& factor : s) factor *= Rational(100 + percent(dice), 100);
      if (step % 5 == 4) s = bodies::unit;
    }
    general += walk.general;
    EXPECT_GT(walk.degenerate, 0);
  });
  EXPECT_GT(general, 10);
}

TEST(WordSurface, BeyondWordsThereIsNone) {
  const Rational far = Integer(1) << 60;
  const ConvexPolyhedron P(box(1, 2, 3)), Q(translated(box(1, 1, 1), {far, 0, 0}));
  const DynamicConvexSum sum(P, Q, bodies::unit);
  WordSurface surface;
  EXPECT_FALSE(surface.renew(sum));
  EXPECT_EQ(surface.facets().size(), 0U);
  EXPECT_EQ(surface_of(sum).surface,
            translated(bodies::sum(P.surface(), box(1, 1, 1)).surface, {far, 0, 0}));
}

/// Round an apex, too, no step asks all pairs of facets or corners.
TEST(WordSurface, GrowsAsTheSum) {
  const auto renewed = [](int sides) {
    const ConvexPolyhedron P(cones(sides, false)), Q(cones(sides, true));
    const DynamicConvexSum sum(P, Q, {1, Rational(6, 5), Rational(1, 3)});
    return testing::turns([&] { EXPECT_TRUE(WordSurface().renew(sum)); });
  };
  const double before = renewed(250), after = renewed(1000);
  EXPECT_GT(before, 20);
  EXPECT_LT(after, std::pow(4, 1.25) * before) << before << " turns of 64 before";
}

TEST(RingCertificate, RefusesWhatIsNotClosedOrNotStrictlyConvex) {
  const auto rings = [](const std::vector<Face>& faces) {
    Rings result;
    for (const Face& face : faces) {
      result.corners.insert(result.corners.end(), face.begin(), face.end());
      result.close();
    }
    return result;
  };
  const auto proven = [&](const std::vector<WordVector>& points, const std::vector<Face>& faces) {
    const Rings all = rings(faces);
    try {
      RingCertificate().require(points, all);
    } catch (const std::logic_error&) {
      return false;
    }
    return true;
  };
  std::vector<WordVector> cube;
  for (std::int64_t k = 0; k < 8; ++k) cube.push_back({k & 1, k >> 1 & 1, k >> 2});
  std::vector<Face> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  EXPECT_TRUE(proven(cube, faces));
  std::vector<Face> open = faces;
  open.pop_back();
  EXPECT_FALSE(proven(cube, open));
  std::vector<Face> cut = faces;
  cut[0] = {0, 2, 3};
  cut.push_back({0, 3, 1});
  EXPECT_FALSE(proven(cube, cut));  // two facets in one plane
  std::vector<Face> inside_out = faces;
  for (Face& face : inside_out) std::reverse(face.begin(), face.end());
  EXPECT_FALSE(proven(cube, inside_out));
  std::vector<WordVector> bent = cube;
  bent[7] = {2, 2, 2};
  EXPECT_FALSE(proven(bent, faces));  // no plane for three of the faces
  std::vector<Face> twice = faces;
  twice.insert(twice.end(), faces.begin(), faces.end());
  EXPECT_FALSE(proven(cube, twice));
  // Ten triangles about an axis, twice around: convex at each edge, and not at the poles.
  std::vector<WordVector> round{{0, 0, 1000}, {0, 0, -1000}};
  std::vector<Face> wound;
  for (std::uint32_t k = 0; k < 10; ++k) {
    const double angle = 4 * 3.14159265358979 * k / 10;
    round.push_back({std::lround(1000 * std::cos(angle)), std::lround(1000 * std::sin(angle)), 0});
    const std::uint32_t here = 2 + k, next = 2 + (k + 1) % 10;
    wound.push_back({here, next, 0});
    wound.push_back({next, here, 1});
  }
  EXPECT_FALSE(proven(round, wound));
  for (std::uint32_t k = 0; k < 10; ++k) {
    const double angle = 2 * 3.14159265358979 * k / 10;
    round[2 + k] = {std::lround(1000 * std::cos(angle)), std::lround(1000 * std::sin(angle)), 0};
  }
  EXPECT_TRUE(proven(round, wound));
}

}  // namespace
}  // namespace minkref::of_word_surfaces
