// Tracks that doubles omit are inside, according to the exact point test.
#include "reference/plane/index/interior_tracks.hpp"

#include <gtest/gtest.h>

#include "reference/plane/location.hpp"
#include "reference/plane/moving/interior_test.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_interior_tracks {
namespace {

double coordinate(Source& random) { return static_cast<double>(random.below(4000)) / 100 - 20; }

TEST(InteriorTracks, AreInsideAtEveryScale) {
  MINKREF_SEEDED(random, 910);
  std::uint64_t certain = 0;
  expect_law(random, 60, [&](const Case& c) -> std::string {
    const InteriorTracks tracks(c.P, c.Q);
    const InteriorTest exact(c.P, c.Q);
    InteriorTracks::Hints hints;
    Source place(c.P.vertices() + 31 * c.Q.vertices());
    for (int k = 0; k < 60; ++k) {
      const RoundedTrack track{coordinate(place), coordinate(place), coordinate(place) / 8,
                               coordinate(place) / 8, 0};
      const double from = 0.25 + static_cast<double>(place.below(64)) / 16,
                   to = from * (1 + static_cast<double>(place.below(64)) / 64);
      if (!tracks.certainly_inside(track, from, to, hints)) continue;
      ++certain;
      for (const double part : {0.0, 0.25, 0.5, 1.0}) {
        const Rational s = from_double(from + part * (to - from));
        const Point x{from_double(track.x0) + s * from_double(track.x1),
                      from_double(track.y0) + s * from_double(track.y1)};
        if (!exact.inside(x, s)) {
          return "not inside at " + to_string(s) + ": (" + to_string(x.x) + ", " + to_string(x.y) +
                 ")";
        }
      }
    }
    return "";
  });
  EXPECT_GE(certain, testing::repetitions(100U));
}

TEST(InteriorTracks, NothingIsCertainOfPointsAndSegments) {
  const PolygonSet square = box(-5, -5, 5, 5);
  InteriorTracks::Hints hints;
  for (const PolygonSet& small : {point_set(0, 0), segment_set({0, 0}, {1, 0})}) {
    EXPECT_FALSE(InteriorTracks(square, small).certainly_inside({}, 1, 1, hints));
    EXPECT_FALSE(InteriorTracks(small, square).certainly_inside({}, 1, 1, hints));
  }
}

TEST(InteriorTracks, AHoleThatDoublesTakeForAPointIsStillThere) {
  Rational tiny = 1;
  for (int k = 0; k < 80; ++k) tiny /= 2;
  PolygonSet Q = box(-8, -8, 8, 8);
  Q.polygons[0].holes.push_back({{3, 3}, {3, 3 + tiny}, {3 + tiny, 3 + tiny}, {3 + tiny, 3}});
  const PolygonSet P = box(-1, -1, 1, 1);
  const double s = to_double(tiny);
  InteriorTracks::Hints hints;
  EXPECT_FALSE(InteriorTracks(P, Q).certainly_inside({3, 3, 0, 0, 0, 0, 0}, s / 8, s / 4, hints));
  EXPECT_LE(SignedDistance(Q).below(3, 3), 0);
}

/// The squared distance of a point to an edge.
Rational squared_distance(const Point& x, const Point& a, const Point& b) {
  const Rational dx = b.x - a.x, dy = b.y - a.y, ux = x.x - a.x, uy = x.y - a.y;
  Rational t = (ux * dx + uy * dy) / (dx * dx + dy * dy);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const Rational vx = ux - t * dx, vy = uy - t * dy;
  return vx * vx + vy * vy;
}

Rational squared_distance(const Point& x, const PolygonSet& set) {
  std::optional<Rational> least;
  const auto look = [&](const Ring& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Rational d = squared_distance(x, ring[k], ring[(k + 1) % ring.size()]);
      if (!least || d < *least) least = d;
    }
  };
  for (const Polygon& polygon : set.polygons) {
    look(polygon.outer);
    for (const Ring& hole : polygon.holes) look(hole);
  }
  return *least;
}

bool is_inside(const Point& x, const PolygonSet& set) {
  return InteriorTest(set, point_set(0, 0)).inside(x, 1);
}

TEST(SignedDistance, IsNeverTooLarge) {
  MINKREF_SEEDED(random, 911);
  expect_law(random, 40, [](const Case& c) -> std::string {
    const SignedDistance distance(c.P);
    Source place(c.P.vertices());
    for (int k = 0; k < 40; ++k) {
      const double x = coordinate(place), y = coordinate(place);
      const Point p{from_double(x), from_double(y)};
      const double told = distance.below(x, y);
      const Rational squared = squared_distance(p, c.P), own = from_double(told);
      const bool right =
          is_inside(p, c.P) ? told <= 0 || own * own <= squared : told <= 0 && own * own >= squared;
      if (!right) return "at (" + std::to_string(x) + ", " + std::to_string(y) + ")";
    }
    return "";
  });
}

TEST(SignedDistance, ItsDiscsAreInTheRegion) {
  MINKREF_SEEDED(random, 912);
  std::uint64_t discs = 0;
  expect_law(random, 40, [&](const Case& c) -> std::string {
    for (const Disc& disc : SignedDistance(c.P).inscribed_discs(20)) {
      ++discs;
      const Point centre{from_double(disc.x), from_double(disc.y)};
      const Rational radius = from_double(disc.radius);
      if (!is_inside(centre, c.P) || radius * radius > squared_distance(centre, c.P)) {
        return "a disc at (" + std::to_string(disc.x) + ", " + std::to_string(disc.y) + ")";
      }
    }
    return "";
  });
  EXPECT_GE(discs, testing::repetitions(400U));
}

}  // namespace
}  // namespace minkref::testing::of_interior_tracks
