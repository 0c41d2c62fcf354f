// The radii at which the boundary of a sum with a disc changes, and no change between them.
#include "reference/disc/diagram/diagram_events.hpp"

#include <gtest/gtest.h>

#include "reference/disc/region/offset_region.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::of_diagram_events {
namespace {

using Kind = DiagramEvent::Kind;

/// The rings of curves and the hole count, as text.
std::string structure(const PolygonSet& P, const Rational& squared_radius) {
  const OffsetRegion region = offset_region(P, squared_radius);
  const std::string text = canonical_json(region);
  return text.substr(0, text.rfind(",\"squared_radius\"")) + std::to_string(region.holes);
}

struct Radius {
  Interval near;
  RootNumber exact;
};

std::vector<Radius> distinct_radii(const DiagramEvents& found) {
  std::vector<Radius> radii;
  for (const DiagramEvent& event : found.events) {
    const RootNumber exact = found.exact(event).squared_radius;
    if (radii.empty() || compare(radii.back().exact, exact) != 0) {
      const Interval radius = found.radius(event);
      radii.push_back({radius * radius, exact});
    }
  }
  return radii;
}

/// Two radii in each gap between events, and one below and above: the curves stay equal within a
/// gap and differ beyond an event.
void check(const PolygonSet& P) {
  const DiagramEvents found = diagram_events(P);
  const std::vector<Radius> radii = distinct_radii(found);
  std::string before;
  for (std::size_t k = 0; k <= radii.size(); ++k) {
    const Rational low = k == 0 ? Rational(0) : Rational(radii[k - 1].near.upper());
    const Rational high = k == radii.size() ? low * 2 + 1 : Rational(radii[k].near.lower());
    if (low >= high) continue;
    const std::string first = structure(P, (low * 9 + high) / 10),
                      last = structure(P, (low + high * 9) / 10);
    ASSERT_EQ(first, last) << "between " << low << " and " << high;
    ASSERT_NE(first, before) << "at " << low;
    before = first;
  }
}

TEST(DiagramEvents, OfRandomRegions) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    ASSERT_NO_FATAL_FAILURE(check(testing::random_region(random, 4)));
  }
}

TEST(DiagramEvents, OfGrids) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    ASSERT_NO_FATAL_FAILURE(check(testing::random_mesh_region(random, 5)));
  }
}

Rational power(unsigned exponent) {
  return Rational(boost::multiprecision::pow(Integer(10), exponent));
}

/// A moved and scaled set has the same events.
TEST(DiagramEvents, MoveAndGrowWithTheSet) {
  std::size_t events = 0;
  for (unsigned seed = 0; seed < testing::repetitions(40U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_mesh_region(random, 5);
    const DiagramEvents one = diagram_events(P);
    events += one.events.size();
    const Rational factor = seed % 3 == 0 ? power(200) : Rational(1 / power(seed % 3 * 100));
    const Rational far = seed % 2 == 0 ? power(40) : Rational(0);
    PolygonSet moved = P;
    for (Polygon& polygon : moved.polygons) {
      const auto move = [&](Ring& ring) {
        for (Point& p : ring) p = {(p.x + far) * factor, (p.y - far) * factor};
      };
      move(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), move);
    }
    const DiagramEvents other = diagram_events(moved);
    ASSERT_EQ(one.events.size(), other.events.size());
    for (std::size_t k = 0; k < one.events.size(); ++k) {
      ASSERT_EQ(one.events[k].features, other.events[k].features);
      ASSERT_EQ(one.events[k].kind, other.events[k].kind);
      ASSERT_EQ(compare(one.exact(one.events[k]).squared_radius * RootNumber(factor * factor),
                        other.exact(other.events[k]).squared_radius),
                0);
    }
  }
  EXPECT_GT(events, 50U);
}

/// A notch in a square, at any size, has all its events.
TEST(DiagramEvents, OfASmallNotch) {
  for (const unsigned exponent : {0U, 3U, 9U, 15U, 30U, 100U}) {
    SCOPED_TRACE(exponent);
    const Rational e = Rational(1 / power(exponent));
    const PolygonSet P{{{{{0, 0},
                          {9, 0},
                          {9, 9},
                          {4 + 2 * e, 9},
                          {4 + e, 9 - 3 * e},
                          {4 + e, 9 - e},
                          {4, 9},
                          {0, 9}},
                         {}}}};
    const DiagramEvents found = diagram_events(P);
    ASSERT_EQ(
        found.events.size(),
        diagram_events({{{{{0, 0}, {9, 0}, {9, 9}, {6, 9}, {5, 6}, {5, 8}, {4, 9}, {0, 9}}, {}}}})
            .events.size());
  }
}

/// Vertices almost equally far from a point: a corner for each vertex, however close the vertices;
/// a single corner for all if nothing is moved.
TEST(DiagramEvents, OfCornersThatAlmostCoincide) {
  const std::vector<Point> circle{{5, 0},  {4, 3},   {3, 4},  {0, 5}, {-3, 4},
                                  {-5, 0}, {-4, -3}, {0, -5}, {3, -4}};
  for (const unsigned exponent : {0U, 8U, 13U, 17U, 40U, 90U}) {
    SCOPED_TRACE(exponent);
    PolygonSet P;
    for (std::size_t k = 0; k < circle.size(); ++k) {
      const Rational by =
          exponent == 0 ? Rational(1) : Rational(1 + Rational(k * k + 1) / power(exponent));
      const Point a{circle[k].x * by, circle[k].y * by}, out{circle[k].x * 2, circle[k].y * 2};
      const Point side{out.x - circle[k].y / 10, out.y + circle[k].x / 10};
      P.polygons.push_back({{a, out, side}, {}});
    }
    const DiagramEvents found = diagram_events(P);
    std::size_t most = 0, in_the_middle = 0;
    for (const DiagramEvent& event : found.events) {
      most = std::max(most, event.features.size());
      const auto place = found.place(event);
      in_the_middle += std::abs(approximate(place.x)) + std::abs(approximate(place.y)) < 1e-3;
    }
    EXPECT_EQ(most, exponent == 0 ? circle.size() : 3);
    const std::size_t expected = exponent == 0 ? 1 : circle.size() - 2;
    EXPECT_EQ(in_the_middle, expected);
  }
}

/// Places found before are proven again, not trusted.
TEST(DiagramEvents, AreProvenAgainFromTheirPlaces) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_region(random, 4);
    const DiagramEvents found = diagram_events(P);
    std::vector<FoundPlace> places = found.places();
    const DiagramEvents again = diagram_events(P, places);
    ASSERT_EQ(again.events.size(), found.events.size());
    for (std::size_t k = 0; k < found.events.size(); ++k) {
      ASSERT_EQ(again.events[k].features, found.events[k].features);
      ASSERT_EQ(again.events[k].kind, found.events[k].kind);
      ASSERT_EQ(compare(again.exact(again.events[k]).squared_radius,
                        found.exact(found.events[k]).squared_radius),
                0);
    }
    if (places.empty()) continue;
    const std::size_t one = random.below(static_cast<unsigned>(places.size()));
    std::vector<FoundPlace> fewer = places;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(one));
    ASSERT_THROW(diagram_events(P, fewer), BadInput);
    for (const std::vector<std::uint32_t>& of :
         {std::vector<std::uint32_t>{0, 1}, {2, 1, 0}, {1, 1, 2}, {0, 1, 4'000'000}}) {
      std::vector<FoundPlace> wrong = places;
      wrong[one].of = of;
      ASSERT_THROW(diagram_events(P, wrong), BadInput);
    }
    // A place too many is no event, and left out.
    places.push_back({places[one].of, 9});
    ASSERT_EQ(diagram_events(P, places).events.size(), found.events.size());
  }
}

TEST(DiagramEvents, OfAConvexSetAreNone) {
  EXPECT_TRUE(diagram_events({{{{{0, 0}, {3, 0}, {1, 2}}, {}}}}).events.empty());
  EXPECT_TRUE(diagram_events({{{{{0, 0}, {3, 4}}, {}}}}).events.empty());
  EXPECT_TRUE(diagram_events({{{{{1, 2}}, {}}}}).events.empty());
  EXPECT_TRUE(diagram_events({}).events.empty());
}

/// A triangular hole closes at its centre.
TEST(DiagramEvents, OfATriangularHole) {
  const PolygonSet P{{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{2, 2}, {2, 6}, {5, 2}}}}}};
  const DiagramEvents found = diagram_events(P);
  ASSERT_EQ(found.events.size(), 1U);  // the centre of the circle in it
  EXPECT_EQ(found.events[0].kind, Kind::maximum);
  EXPECT_EQ(found.exact(found.events[0]).squared_radius, RootNumber(1));
  EXPECT_EQ(found.exact(found.events[0]).at.x, RootNumber(3));
  EXPECT_EQ(found.exact(found.events[0]).at.y, RootNumber(3));
}

TEST(DiagramEvents, BetweenTwoCorners) {
  const PolygonSet P{
      {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, {{{4, 5}, {5, 5}, {5, 6}, {4, 6}}, {}}}};
  const DiagramEvents found = diagram_events(P);
  ASSERT_FALSE(found.events.empty());
  EXPECT_EQ(found.events[0].kind, Kind::saddle);
  EXPECT_EQ(found.exact(found.events[0]).squared_radius, RootNumber(Rational(25, 4)));
}

}  // namespace
}  // namespace minkref::of_diagram_events
