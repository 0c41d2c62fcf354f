// Tight passages of sums with a disc: the definition, at points of a lattice and about each answer.
#include "reference/disc/region/offset_passages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "reference/disc/diagram/diagram_events.hpp"
#include "reference/number/radicals/root_text.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::of_offset_passages {
namespace {

Ring square_ring(int x0, int y0, int x1, int y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
Ring hole_ring(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}; }

std::vector<OffsetPassage> passages_of_set(const PolygonSet& P, const Rational& squared_radius) {
  return offset_passages(PatchesAt(offset_curves(P), squared_radius));
}

/// `(x, y)`, or `(x, y)-(x, y)`.
std::vector<std::string> as_texts(const std::vector<OffsetPassage>& passages) {
  std::vector<std::string> texts;
  for (const OffsetPassage& passage : passages) {
    std::string text;
    for (const RootPoint& x : passage.points) {
      text += (text.empty() ? "(" : "-(") + expression(x.x) + ", " + expression(x.y) + ")";
    }
    texts.push_back(text);
  }
  return texts;
}

using Texts = std::vector<std::string>;

TEST(OffsetPassages, OfASquareHoleIsItsMiddle) {
  const PolygonSet P{{{square_ring(0, 0, 8, 8), {hole_ring(2, 2, 6, 6)}}}};
  const auto found = passages_of_set(P, 4);
  ASSERT_EQ(as_texts(found), Texts{"(4, 4)"});
  EXPECT_EQ(found[0].contacts.size(), 4U);
  EXPECT_EQ(passages_of_set(P, Rational(399, 100)).size(), 0U);
  EXPECT_EQ(passages_of_set(P, Rational(401, 100)).size(), 0U);
}

TEST(OffsetPassages, OfALongHoleIsASegment) {
  const PolygonSet P{{{square_ring(0, 0, 12, 8), {hole_ring(2, 2, 10, 6)}}}};
  const auto found = passages_of_set(P, 4);
  ASSERT_EQ(as_texts(found), Texts{"(4, 4)-(8, 4)"});
  EXPECT_EQ(found[0].contacts.size(), 2U);
}

TEST(OffsetPassages, OfATriangularHoleIsTheCentreOfItsCircle) {
  const PolygonSet P{{{square_ring(-1, -1, 9, 9), {{{0, 0}, {0, 3}, {4, 0}}}}}};
  EXPECT_EQ(as_texts(passages_of_set(P, 1)), Texts{"(1, 1)"});
  const PolygonSet Q{{{square_ring(-1, -1, 9, 9), {{{0, 0}, {0, 1}, {1, 0}}}}}};
  // The radius (2 - √2) / 2 has an irrational square.
  EXPECT_EQ(passages_of_set(Q, Rational(171572875, 2000000000)).size(), 0U);
}

/// Facing edges leave a gap with open ends, and a boundary's corners are not tight, however many
/// curves pass there.
TEST(OffsetPassages, AreNotWhereTheBoundaryOnlyTouchesItself) {
  EXPECT_EQ(as_texts(passages_of_set(
                {{{square_ring(0, 0, 1, 3), {}}, {square_ring(3, 1, 4, 9), {}}}}, 1)),
            Texts{"(2, 1)-(2, 3)"});
  EXPECT_TRUE(
      passages_of_set({{{square_ring(0, 0, 1, 3), {}}, {square_ring(3, 3, 4, 9), {}}}}, 1).empty());
  EXPECT_TRUE(passages_of_set({{{square_ring(0, 0, 1, 1), {}}, {square_ring(4, 5, 5, 6), {}}}},
                              Rational(25, 4))
                  .empty());
  // Three corners at the distance 5 from the origin, with no more than half a turn between two.
  const PolygonSet P{{{{{3, 4}, {9, 4}, {9, 9}}, {}},
                      {{{3, -4}, {9, -9}, {9, -4}}, {}},
                      {{{5, 0}, {9, -1}, {9, 1}}, {}}}};
  EXPECT_TRUE(passages_of_set(P, 25).empty());
}

TEST(OffsetPassages, OfCornersOnACircleIsItsCentre) {
  const std::vector<Direction> ways{{3, 4}, {-4, 3}, {-3, -4}, {4, -3}, {5, 0}, {-5, 0}};
  for (const std::size_t corners : {4U, 6U}) {
    PolygonSet P;
    for (std::size_t k = 0; k < corners; ++k) {
      const Direction& w = ways[k];
      const auto at = [&](int out, int aside) -> Point {
        return {(out * w.x - aside * w.y) / 5, (out * w.y + aside * w.x) / 5};
      };
      P.polygons.push_back({{at(5, 0), at(8, -1), at(8, 1)}, {}});
    }
    const auto found = passages_of_set(P, 25);
    ASSERT_EQ(as_texts(found), Texts{"(0, 0)"});
    EXPECT_EQ(found[0].contacts.size(), corners);
  }
}

/// Two on the upper side touch at a vertex: the segment goes on.
TEST(OffsetPassages, SegmentsThatGoOnAreOne) {
  const PolygonSet P{{{square_ring(0, 0, 8, 1), {}},
                      {{{0, 3}, {4, 3}, {2, 5}}, {}},
                      {{{4, 3}, {8, 3}, {6, 5}}, {}}}};
  EXPECT_EQ(as_texts(passages_of_set(P, 1)), Texts{"(0, 2)-(8, 2)"});
}

// The definition: a point at distance ρ from P is tight iff it is a limit of points, also at
// distance ρ, without a farther point nearby.

Rational squared_distance(const OffsetCurves& curves, const Point& x) {
  Rational least = -1;
  for (const OffsetEdge& edge : curves.edges) {
    const Direction w = from_to(edge.start, x);
    Rational part = dot(edge.along, w) / edge.squared_length;
    part = part < 0 ? Rational(0) : part > 1 ? Rational(1) : part;
    const Direction off{w.x - part * edge.along.x, w.y - part * edge.along.y};
    const Rational square = dot(off, off);
    if (least < 0 || square < least) least = square;
  }
  return least;
}

/// Whether no sample point about x is farther: samples lie straight ahead in many directions, and a
/// little to both sides, by parts of the squared step, as arcs bend. `axis` has unit length, along
/// the grid.
bool is_locally_farthest(const OffsetCurves& curves, const Point& x, const Direction& axis,
                         const Rational& square) {
  const Rational step(1, 4096);
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) {
      if (std::gcd(i, j) != 1) continue;
      for (int bend = -1; bend <= 1; ++bend) {
        const Rational aside = bend * step * step / 64;
        const Rational u = step * i - aside * j, v = step * j + aside * i;
        const Point y{x.x + u * axis.x - v * axis.y, x.y + u * axis.y + v * axis.x};
        if (squared_distance(curves, y) > square) return false;
      }
    }
  }
  return true;
}

/// Cells of a grid, some whole, some cut into halves and quarters.
PolygonSet random_cells(testing::Source& random) {
  const int nx = random.between(3, 6), ny = random.between(3, 6);
  const testing::Mesh mesh = testing::random_mesh(random, nx, ny, testing::Grid::lattice);
  std::vector<bool> chosen;
  for (int cell = 0; cell < nx * ny; ++cell) {
    const bool is_cut = random.below(6) == 0, is_whole = random.below(3) != 0;
    for (int k = 0; k < 4; ++k) chosen.push_back(is_cut ? random.below(2) == 0 : is_whole);
  }
  PolygonSet P = testing::MeshRegion(mesh, chosen).rings();
  testing::drop_straight_vertices(random, P, 100);
  return P;
}

Rational value(const RootNumber& number) {
  EXPECT_EQ(number.field()->roots(), 0U);
  return number.coefficients()[0];
}

bool is_on(const Point& x, const OffsetPassage& passage) {
  const auto at = [&](const RootPoint& p) {
    return compare(p.x, RootNumber(x.x)) == 0 && compare(p.y, RootNumber(x.y)) == 0;
  };
  if (at(passage.points.front()) || at(passage.points.back())) return true;
  if (passage.points.size() == 1) return false;
  const RootPoint a = numbers<RootNumber>(x) - passage.points.front(),
                  b = numbers<RootNumber>(x) - passage.points.back();
  return compare(a.x * b.y, a.y * b.x) == 0 && sign(a.x * b.x + a.y * b.y) < 0;
}

/// Sets of cells at radii in quarters, with or without a rational rotation.
TEST(OffsetPassages, AreTheDefinitionOnALattice) {
  std::size_t tight = 0, segments = 0, asked = 0;
  for (unsigned seed = 0; seed < testing::repetitions(20U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const bool is_turned = seed % 4 == 3;
    const auto placed = [&](const Rational& x, const Rational& y) -> Point {
      if (!is_turned) return {x, y};
      return {(3 * x - 4 * y) / 5, (4 * x + 3 * y) / 5};
    };
    const Direction axis = from_to(placed(0, 0), placed(1, 0));
    PolygonSet P = random_cells(random);
    const Point corner = P.polygons.empty() ? Point{0, 0} : P.polygons[0].outer[0];
    for (Polygon& polygon : P.polygons) {
      const auto move = [&](Ring& ring) {
        for (Point& p : ring) p = placed(p.x, p.y);
      };
      move(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), move);
    }
    const OffsetCurves curves = offset_curves(P);
    if (curves.edges.empty()) continue;
    for (const Rational& square : {Rational(1, 4), Rational(1, 2), Rational(1), Rational(2),
                                   Rational(5, 4), Rational(4), Rational(25, 16)}) {
      const auto found = passages_of_set(P, square);
      for (const OffsetPassage& passage : found) {
        (passage.points.size() == 1 ? tight : segments) += 1;
        EXPECT_GE(passage.contacts.size(), 2U);
        if (std::any_of(passage.points.begin(), passage.points.end(), [](const RootPoint& x) {
              return x.x.field()->roots() + x.y.field()->roots() > 0;
            })) {
          continue;
        }
        const auto at = [&](const Rational& part) -> Point {
          const RootPoint &a = passage.points.front(), &b = passage.points.back();
          return {value(a.x) + part * (value(b.x) - value(a.x)),
                  value(a.y) + part * (value(b.y) - value(a.y))};
        };
        // A segment's ends are limits.
        for (const Rational& part : {Rational(1, 2), Rational(1, 7), Rational(9, 10)}) {
          EXPECT_EQ(squared_distance(curves, at(part)), square);
          EXPECT_TRUE(is_locally_farthest(curves, at(part), axis, square));
        }
        EXPECT_EQ(squared_distance(curves, at(0)), square);
        EXPECT_EQ(squared_distance(curves, at(1)), square);
      }
      for (int i = -14; i <= 14; ++i) {
        for (int j = -14; j <= 14; ++j) {
          const Point x =
              placed(Rational(corner.x + Rational(i, 2)), Rational(corner.y + Rational(j, 2)));
          if (squared_distance(curves, x) != square ||
              testing::where(P, x) != testing::Where::outside) {
            continue;
          }
          ++asked;
          const bool is_tight = std::any_of(found.begin(), found.end(),
                                            [&](const auto& each) { return is_on(x, each); });
          if (is_locally_farthest(curves, x, axis, square)) {
            EXPECT_TRUE(is_tight) << x.x << ", " << x.y << " at " << square;
          } else if (is_tight) {  // only as a limit
            EXPECT_TRUE(std::any_of(
                found.begin(), found.end(),
                [&](const auto& each) { return each.points.size() == 2 && is_on(x, each); }))
                << x.x << ", " << x.y << " at " << square;
          }
        }
      }
    }
  }
  EXPECT_GT(tight, testing::repetitions(5U));
  EXPECT_GE(segments, testing::repetitions(20U));
  EXPECT_GT(asked, 1000U);
}

/// Single tight points are maxima of the diagram, or places where a ridge ends both ways; between
/// events nothing is tight.
TEST(OffsetPassages, AreAtEventsOfTheDiagram) {
  std::size_t maxima = 0;
  for (unsigned seed = 100; seed < 100 + testing::repetitions(20U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = random_cells(random);
    const DiagramEvents events = diagram_events(P);
    std::set<Rational> squares;
    for (const DiagramEvent& event : events.events) {
      const auto exact = events.exact(event);
      if (exact.squared_radius.field()->roots() == 0) {
        squares.insert(exact.squared_radius.coefficients()[0]);
      }
    }
    for (const Rational& square : squares) {
      const auto found = passages_of_set(P, square);
      for (const DiagramEvent& event : events.events) {
        const auto exact = events.exact(event);
        if (event.kind != DiagramEvent::Kind::maximum ||
            compare(exact.squared_radius, RootNumber(square)) != 0) {
          continue;
        }
        ++maxima;
        EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const OffsetPassage& each) {
          return each.points.size() == 1 && are_same(each.points[0], exact.at);
        })) << square;
      }
      for (const OffsetPassage& each : found) {
        if (each.points.size() == 2) continue;
        EXPECT_TRUE(std::any_of(events.events.begin(), events.events.end(), [&](const auto& event) {
          return (event.kind == DiagramEvent::Kind::maximum ||
                  event.kind == DiagramEvent::Kind::ridge) &&
                 are_same(each.points[0], events.exact(event).at);
        })) << square;
      }
    }
    for (const Rational& square : {Rational(1237, 10000), Rational(1, 11), Rational(1117, 1000)}) {
      if (!squares.contains(square)) {
        EXPECT_TRUE(passages_of_set(P, square).empty());
      }
    }
  }
  EXPECT_GE(maxima, testing::repetitions(10U));
}

}  // namespace
}  // namespace minkref::of_offset_passages
