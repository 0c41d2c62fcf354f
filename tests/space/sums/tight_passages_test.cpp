// Tight passages of sums of polycubes, against the definition: cells, squares, edges and points of
// the grid, counted.
#include "reference/space/definition/tight_passages.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/error.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/space/definition/open_cones.hpp"
#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_tight_passages {
namespace {

using bodies::for_each_seed;
using polycubes::block;
using polycubes::Cell;
using polycubes::Cells;
using polycubes::identity;
using polycubes::is_valid;
using polycubes::Matrix;
using polycubes::solid;
using polycubes::with;
using polycubes::without;

/// A relatively open element of the grid: of each coordinate twice the middle. Odd: an open
/// interval of length 1; even: a point.
using Element = Cell;
using Elements = std::set<Element>;

int dimension(const Element& e) {
  return static_cast<int>(std::count_if(e.begin(), e.end(), [](int c) { return c % 2 != 0; }));
}

/// Calls `look` for each element whose coordinates differ from e's by at most 1, and differ only if
/// `varies` accepts the coordinate.
template <class Vary, class Look>
void around(const Element& e, Vary&& varies, Look&& look) {
  Element near;
  const auto range = [&](std::size_t k) { return varies(e[k]) ? 1 : 0; };
  for (near[0] = e[0] - range(0); near[0] <= e[0] + range(0); ++near[0]) {
    for (near[1] = e[1] - range(1); near[1] <= e[1] + range(1); ++near[1]) {
      for (near[2] = e[2] - range(2); near[2] <= e[2] + range(2); ++near[2]) look(near);
    }
  }
}
bool is_even(int c) { return c % 2 == 0; }
bool is_odd(int c) { return c % 2 != 0; }

/// The elements inside the union of cells: all cells about them belong to the union.
Elements interior(const Cells& cells) {
  Elements found;
  for (const Cell& cell : cells) {
    const Element middle{2 * cell[0] + 1, 2 * cell[1] + 1, 2 * cell[2] + 1};
    around(middle, is_odd, [&](const Element& e) {
      bool inside = true;
      around(e, is_even, [&](const Element& n) {
        if (dimension(n) < 3) return;
        inside = inside && cells.contains({(n[0] - 1) / 2, (n[1] - 1) / 2, (n[2] - 1) / 2});
      });
      if (inside) found.insert(e);
    });
  }
  return found;
}

/// The sum of two open sets: two open intervals add up to an interval of length 2, with its
/// midpoint.
Elements sum_of(const Elements& A, const Elements& B) {
  Elements sum;
  for (const Element& a : A) {
    for (const Element& b : B) {
      const Element middle{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
      Element first = middle, last = middle;
      for (std::size_t k = 0; k < 3; ++k) {
        if (is_odd(a[k]) && is_odd(b[k])) --first[k], ++last[k];
      }
      for (Element e = first; e[0] <= last[0]; ++e[0]) {
        for (e[1] = first[1]; e[1] <= last[1]; ++e[1]) {
          for (e[2] = first[2]; e[2] <= last[2]; ++e[2]) sum.insert(e);
        }
      }
    }
  }
  return sum;
}

SpacePoint image(const Element& corner, const Matrix& m) {
  std::array<Rational, 3> at;
  for (std::size_t row = 0; row < 3; ++row) {
    Integer value = 0;
    for (std::size_t k = 0; k < 3; ++k) value += m[row][k] * corner[k];
    at[row] = Rational(value, 2);
  }
  return {at[0], at[1], at[2]};
}

OrientedPlane plane_through(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  const IntegerPoints points = integer_points({a, b, c});
  const auto& p = points.points;
  IntegerVector normal = primitive(cross(p[1] - p[0], p[2] - p[0]));
  if (normal < IntegerVector{0, 0, 0}) normal = {-normal[0], -normal[1], -normal[2]};
  return {normal, Rational(dot(normal, p[0]), points.denominator)};
}

using Segment = std::pair<SpacePoint, SpacePoint>;
bool before(const SpacePoint& a, const SpacePoint& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// Segments cut at the points of the grid, ascending.
std::vector<Segment> at_grid(std::vector<Segment> segments) {
  for (auto& [a, b] : segments) {
    if (before(b, a)) std::swap(a, b);
  }
  std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) {
    return s.first == t.first ? before(s.second, t.second) : before(s.first, t.first);
  });
  return segments;
}

/// Joins segments that follow each other on a line.
std::vector<Segment> joined(std::vector<Segment> segments) {
  segments = at_grid(std::move(segments));
  for (std::size_t k = 0; k < segments.size(); ++k) {
    for (std::size_t j = 0; j < segments.size(); ++j) {
      if (j == k || !(segments[k].second == segments[j].first)) continue;
      const auto p =
          integer_points({segments[k].first, segments[k].second, segments[j].second}).points;
      if (!is_zero(cross(p[1] - p[0], p[2] - p[0]))) continue;
      segments[k].second = segments[j].second;
      segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(j));
      return joined(std::move(segments));
    }
  }
  return segments;
}

TightPassagesInSpace expected(const Cells& P, const Cells& Q, const Matrix& m) {
  const Elements open = sum_of(interior(P), interior(Q));
  Elements tight;
  for (const Element& e : interior(polycubes::sum_of_cells(P, Q))) {
    if (!open.contains(e)) tight.insert(e);
  }
  TightPassagesInSpace result;
  std::map<OrientedPlane, PolygonSet> planes;
  std::vector<Segment> segments;
  for (const Element& e : tight) {
    bool in_larger = false;
    around(e, is_even, [&](const Element& n) {
      in_larger = in_larger || (dimension(n) > dimension(e) && tight.contains(n));
    });
    std::vector<SpacePoint> corners;
    around(e, is_odd, [&](const Element& n) {
      if (dimension(n) == 0) corners.push_back(image(n, m));
    });
    EXPECT_LT(dimension(e), 3);
    if (dimension(e) == 2) {
      std::swap(corners[2], corners[3]);
      const OrientedPlane plane = plane_through(corners[0], corners[1], corners[2]);
      Ring ring;
      for (const SpacePoint& c : corners) ring.push_back(seen(c, viewing_axis(plane.normal)));
      planes[plane].polygons.push_back({ring, {}});
    } else if (dimension(e) == 1 && !in_larger) {
      segments.emplace_back(corners[0], corners[1]);
    } else if (dimension(e) == 0 && !in_larger) {
      result.points.push_back(corners[0]);
    }
  }
  for (auto& [plane, parts] : planes) {
    orient(parts);
    result.sheets.push_back({plane, canonicalize(parts).region});
  }
  result.lines = joined(std::move(segments));
  std::sort(result.points.begin(), result.points.end(), before);
  return result;
}

TightPassagesInSpace expect_passages(const Cells& P, const Cells& Q, const Matrix& m = identity) {
  const TightPassagesInSpace found = tight_passages_in_space(solid(P, m), solid(Q, m), {1, 1, 1});
  const TightPassagesInSpace wanted = expected(P, Q, m);
  EXPECT_EQ(found.sheets, wanted.sheets);
  EXPECT_EQ(found.lines, wanted.lines);
  EXPECT_EQ(found.points, wanted.points);
  return wanted;
}

TEST(TightPassages, ABlockInAHoleOfItsSize) {
  const Cells plate = without(block({0, 0, 0}, {5, 5, 5}), block({2, 2, 2}, {3, 3, 3}));
  EXPECT_EQ(expect_passages(plate, block({0, 0, 0}, {1, 1, 1})).points.size(), 1U);
}

TEST(TightPassages, ABarInATunnelOfItsWidth) {
  const Cells tunnel = without(block({0, 0, 0}, {5, 5, 4}), block({2, 2, 0}, {3, 3, 4}));
  EXPECT_EQ(expect_passages(tunnel, block({0, 0, 0}, {1, 1, 1})).lines.size(), 1U);
}

TEST(TightPassages, APlateInASlotOfItsThickness) {
  const Cells slot = without(block({0, 0, 0}, {5, 5, 3}), block({1, 1, 1}, {5, 5, 2}));
  EXPECT_EQ(expect_passages(slot, block({0, 0, 0}, {1, 1, 1})).sheets.size(), 1U);
}

TEST(TightPassages, ThereAreNoneOfConvexOperands) {
  EXPECT_TRUE(expect_passages(block({0, 0, 0}, {2, 3, 1}), block({0, 0, 0}, {1, 1, 4})).empty());
}

/// With a point as Q, each point inside P is inside the sum of interiors: int P + {0}. No seam
/// between convex pieces is a passage.
TEST(TightPassages, ThereAreNoneOfAPoint) {
  const Polyhedron point{{{0, 0, 0}}, {}};
  for_each_seed(20, [&](std::mt19937& dice) {
    const Cells P = polycubes::random_cells(dice, 3 + dice() % 6, 3);
    if (!is_valid(solid(P))) return;
    const Polyhedron body = solid(P, polycubes::random_matrix(dice, 3));
    EXPECT_TRUE(tight_passages_in_space(body, point, {1, 1, 1}).empty());
    EXPECT_TRUE(tight_passages_in_space(point, body, {1, 1, 1}).empty());
  });
}

TEST(TightPassages, OfANeedleAreWhereItFits) {
  const Polyhedron needle{{{0, 0, 0}, {1, 0, 0}}, {}};
  const Cells angle = with(block({0, 0, 0}, {2, 1, 1}), {{0, 1, 0}});
  EXPECT_TRUE(tight_passages_in_space(solid(angle), needle, {1, 1, 1}).empty());
  const Cells fork = with(block({0, 0, 0}, {3, 1, 1}), {{0, 1, 0}, {2, 1, 0}});
  const TightPassagesInSpace found = tight_passages_in_space(solid(fork), needle, {1, 1, 1});
  ASSERT_EQ(found.sheets.size(), 1U);
  EXPECT_TRUE(found.lines.empty() && found.points.empty());
  EXPECT_EQ(found.sheets[0].plane, (OrientedPlane{{1, 0, 0}, 2}));
  EXPECT_EQ(area(found.sheets[0].region), 1);
}

/// By the law alone, with whatever comes.
TEST(TightPassages, OfRandomCells) {
  std::size_t sheets = 0, lines = 0, points = 0;
  for_each_seed(80, [&](std::mt19937& dice) {
    Cells P, Q;
    do {  // solid but for a few cells, or whatever hangs together
      P = dice() % 4 == 0 ? polycubes::random_cells(dice, 20, 4) : block({0, 0, 0}, {4, 4, 5});
      for (const Cell& cell : polycubes::random_cells(dice, 1 + dice() % 5, 3)) {
        P.erase({cell[0] + 1, cell[1] + 1, cell[2] + 1});
      }
    } while (!is_valid(solid(P)));
    do {
      Q = polycubes::random_cells(dice, 1 + dice() % 3, 2);
    } while (!is_valid(solid(Q)));
    const Matrix m = dice() % 2 == 0 ? identity : polycubes::random_matrix(dice, 4);
    const TightPassagesInSpace found = expect_passages(P, Q, m);
    sheets += found.sheets.size();
    lines += found.lines.size();
    points += found.points.size();
  });
  EXPECT_GT(sheets, 10U);
  EXPECT_GT(lines, 10U);
  EXPECT_GE(points, testing::repetitions(2U));
}

TEST(OpenCones, FourHalfSpacesLeaveNoDirectionOpen) {
  const IntegerVector a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1}, d{-1, -1, -1};
  EXPECT_TRUE(cover_all({{a}, {b}, {c}, {d}}));
  EXPECT_FALSE(cover_all({{a}, {b}, {c}}));
  EXPECT_FALSE(cover_all({{a}, {{-1, 0, 0}}}));
  EXPECT_FALSE(cover_all({}));
  EXPECT_TRUE(cover_all_about(c, {{{1, 0, 0}}, {{0, 1, 0}}, {{-1, -1, 0}}}));
  EXPECT_FALSE(cover_all_about(c, {{{1, 0, 0}}, {{-1, 0, 0}}}));
}

}  // namespace
}  // namespace minkref::of_tight_passages
