// Offsets by definition: distances of their pieces, and their area between the areas of sums with
// polygons inside and outside the disc.
#include "reference/disc/distance/static_offset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/plane/sum.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::of_static_offset {
namespace {

struct Spot {
  double x, y;
};

Spot spot(const Point& p) { return {to_double(p.x), to_double(p.y)}; }

/// A piece in doubles: its ends, and an arc's angles.
struct Drawn {
  Spot from, to, middle;
  bool is_arc;
  Spot centre;
  double first_angle, last_angle;
};

Drawn drawn(const StaticOffset& offset, const OffsetPiece& piece) {
  const double radius = std::sqrt(to_double(offset.at->squared_radius()));
  const OffsetPatch& patch = offset.at->curves().patches[piece.patch];
  const auto key = [&](const PatchPlace& place, double first, double last) {
    if (place.at == PatchPlace::At::start) return first;
    if (place.at == PatchPlace::At::end) return last;
    return approximate(place.near);
  };
  if (patch.edge != OffsetPatch::none) {
    const OffsetEdge& edge = offset.at->curves().edges[patch.edge];
    const Spot start = spot(edge.start);
    const double dx = to_double(edge.along.x), dy = to_double(edge.along.y);
    const double length = std::hypot(dx, dy);
    const auto at = [&](double u) -> Spot {
      return {start.x + u * dx + radius * dy / length, start.y + u * dy - radius * dx / length};
    };
    const double u = key(piece.from, 0, 1), v = key(piece.to, 0, 1);
    return {at(u), at(v), at((u + v) / 2), false, {}, 0, 0};
  }
  const Spot centre = spot(patch.centre);
  const double fx = to_double(patch.first.x), fy = to_double(patch.first.y),
               lx = to_double(patch.last.x), ly = to_double(patch.last.y);
  const double mx = fx + lx, my = fy + ly, length = std::hypot(mx, my), middle = std::atan2(my, mx);
  const auto of_normal = [&](double nx, double ny) {
    return std::asin((mx * ny - my * nx) / (length * std::hypot(nx, ny)));
  };
  const auto angle = [&](const PatchPlace& place) {
    if (place.at == PatchPlace::At::start) return middle + of_normal(fx, fy);
    if (place.at == PatchPlace::At::end) return middle + of_normal(lx, ly);
    return middle + std::asin(approximate(place.near) / (radius * length));
  };
  const auto at = [&](double a) -> Spot {
    return {centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)};
  };
  const double a = angle(piece.from), b = angle(piece.to);
  return {at(a), at(b), at((a + b) / 2), true, centre, a, b};
}

double distance(const OffsetCurves& curves, const Spot& x) {
  double least = INFINITY;
  for (const OffsetEdge& edge : curves.edges) {
    const Spot p = spot(edge.start);
    const double dx = to_double(edge.along.x), dy = to_double(edge.along.y);
    const double t =
        std::clamp(((x.x - p.x) * dx + (x.y - p.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(x.x - p.x - t * dx, x.y - p.y - t * dy));
  }
  if (curves.edges.empty()) {
    const Spot p = spot(curves.patches[0].centre);
    least = std::hypot(x.x - p.x, x.y - p.y);
  }
  return least;
}

double area(const StaticOffset& offset) {
  const double radius = std::sqrt(to_double(offset.at->squared_radius()));
  double doubled = 0;
  for (const auto& ring : offset.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Drawn piece = drawn(offset, offset.pieces[ring[k]]),
                  next = drawn(offset, offset.pieces[ring[(k + 1) % ring.size()]]);
      EXPECT_NEAR(piece.to.x, next.from.x, 1e-7);
      EXPECT_NEAR(piece.to.y, next.from.y, 1e-7);
      if (piece.is_arc) {
        doubled += radius * radius * (piece.last_angle - piece.first_angle) +
                   piece.centre.x * (piece.to.y - piece.from.y) -
                   piece.centre.y * (piece.to.x - piece.from.x);
      } else {
        doubled += piece.from.x * piece.to.y - piece.from.y * piece.to.x;
      }
    }
  }
  return doubled / 2;
}

/// A polygon on the circle, from rational tangents of half angles.
PolygonSet polygon_in_disc(const Rational& radius, int corners) {
  Ring ring;
  for (int k = 0; k < corners; ++k) {
    const double half = std::numbers::pi * (2 * k - corners + 1) / (2.0 * corners);
    const Rational t(static_cast<long>(std::lround(std::tan(half) * 100000)), 100000);
    const Rational q = 1 + t * t;
    ring.push_back({radius * (1 - t * t) / q, radius * 2 * t / q});
  }
  return {{{ring, {}}}};
}

void check(const PolygonSet& P, const Rational& squared_radius) {
  const StaticOffset offset = static_offset(P, squared_radius);
  const double r = std::sqrt(to_double(squared_radius));
  const Rational below(static_cast<long>(std::floor(r * 1e6)), 1000000),
      above(static_cast<long>(std::ceil(r * 1e6)), 1000000);
  for (const OffsetPiece& piece : offset.pieces) {
    const Drawn line = drawn(offset, piece);
    for (const Spot& x : {line.from, line.middle, line.to}) {
      ASSERT_NEAR(distance(offset.at->curves(), x), r, 1e-7);
    }
  }
  constexpr int corners = 48;
  const double
      inside = to_double(area(minkowski_sum(P, polygon_in_disc(below, corners), 1).region)),
      outside = to_double(
          area(minkowski_sum(P, polygon_in_disc(above * Rational(1003, 1000), corners), 1).region));
  const double found = area(offset);
  ASSERT_GE(found, inside - 1e-7);
  ASSERT_LE(found, outside + 1e-7);
}

TEST(StaticOffset, OfRandomRegions) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_region(random, 2);
    for (const Rational& radius : {Rational(1, 3), Rational(1), Rational(7, 4), Rational(30)}) {
      SCOPED_TRACE(radius);
      ASSERT_NO_FATAL_FAILURE(check(P, radius * radius));
    }
  }
}

/// Radii are half the distances between grid points: wall offsets coincide, arcs touch, several
/// curves pass through a point.
TEST(StaticOffset, OfGridsAtCriticalRadii) {
  for (unsigned seed = 0; seed < testing::repetitions(40U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_mesh_region(random, 2);
    for (const int eighths : {1, 2, 4, 8, 9, 10, 16, 50}) {
      SCOPED_TRACE(eighths);
      ASSERT_NO_FATAL_FAILURE(check(P, Rational(eighths, 8)));
    }
  }
}

TEST(StaticOffset, OfAPointIsADisc) {
  const StaticOffset offset = static_offset({{{{{1, 2}}, {}}}}, Rational(2));
  EXPECT_EQ(offset.rings.size(), 1U);
  EXPECT_EQ(offset.pieces.size(), 4U);
  EXPECT_NEAR(area(offset), 2 * std::numbers::pi, 1e-12);
}

TEST(StaticOffset, OfASegmentIsAStadium) {
  const StaticOffset offset = static_offset({{{{{0, 0}, {3, 4}}, {}}}}, Rational(4));
  EXPECT_EQ(offset.rings.size(), 1U);
  EXPECT_NEAR(area(offset), 4 * std::numbers::pi + 20, 1e-12);
}

/// The hole of a frame, 4 wide, is a square until the radius reaches 2.
TEST(StaticOffset, FillsAHole) {
  const PolygonSet frame{
      {{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, {{{-2, -2}, {-2, 2}, {2, 2}, {2, -2}}}}}};
  EXPECT_EQ(static_offset(frame, Rational(1)).rings.size(), 2U);
  EXPECT_EQ(static_offset(frame, Rational(4)).rings.size(), 1U);
}

}  // namespace
}  // namespace minkref::of_static_offset
