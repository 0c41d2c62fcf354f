// Tight passages against their definition, point by point: the sum of the interiors misses a point
// that lies inside the sum. Edges cut at edges judge the first condition, the union of triangle
// sums the second; neither uses the convolution.
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/sum.hpp"
#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_tight_passages {
namespace {

using Pieces = std::vector<TightPassage>;

Pieces pieces(const Case& c) { return tight_passages(c.P, c.Q, c.scale); }

std::string listed(const Pieces& all) {
  std::string out;
  for (const TightPassage& piece : all) out += (out.empty() ? "" : " ") + text(piece.points);
  return "{" + out + "}";
}

bool on(const TightPassage& piece, const Point& x) {
  for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
    if (on_segment(x, piece.points[i], piece.points[i + 1])) return true;
  }
  return x == piece.points.front();
}

bool on(const Pieces& all, const Point& x) {
  return std::any_of(all.begin(), all.end(), [&](const auto& piece) { return on(piece, x); });
}

/// Nodes of the reduced convolution's arrangement, and three points of each sub-edge.
std::vector<Point> points_of_arrangement(const Case& c) {
  const PolygonSet P = stretched(c.P, c.scale);
  return on_exact_frame(P, c.Q, [&](const auto& frame) {
    Statistics statistics;
    const auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, false, statistics);
    const auto at = [&](std::uint32_t n) { return position(frame, built.arrangement.node(n)); };
    std::vector<Point> points;
    for (std::uint32_t n = 0; n < built.arrangement.node_count(); ++n) points.push_back(at(n));
    for (std::uint32_t h = 0; h < built.arrangement.half_edge_count(); h += 2) {
      const Point a = at(built.arrangement.origin(h)), b = at(built.arrangement.target(h));
      for (const Rational& t : {Rational(1, 7), Rational(1, 2), Rational(9, 10)}) {
        points.push_back(a + t * (b - a));
      }
    }
    return points;
  });
}

std::vector<Point> vertices(const PolygonSet& set) {
  std::vector<Point> all;
  for_each_ring(set, [&](const Ring& ring) { all.insert(all.end(), ring.begin(), ring.end()); });
  return all;
}

/// Sums of vertices and of edge midpoints, which need not lie on the convolution, and points
/// between them.
std::vector<Point> other_points(Source& random, const Case& c) {
  const std::vector<Point> p = vertices(c.P), q = vertices(c.Q);
  std::vector<Point> points;
  for (int i = 0; i < 40; ++i) {
    const auto any = [&](const std::vector<Point>& all) { return all[random.below(all.size())]; };
    const Point a = c.scale * any(p) + any(q), b = c.scale * any(p) + any(q);
    points.push_back(a);
    points.push_back(midpoint(a, b));
    points.push_back({a.x, b.y});
  }
  return points;
}

/// The pieces' fault as a set of points.
std::string wrong_points(Source& random, const Case& c) {
  const Pieces found = pieces(c);
  const PolygonSet sum = minkowski_sum(c.P, c.Q, c.scale, Route::definition).region;
  std::vector<Point> trial = points_of_arrangement(c);
  for (const Point& x : other_points(random, c)) trial.push_back(x);
  for (const Point& x : trial) {
    if (where(sum, x) != Where::inside) continue;
    const bool missed = contact_at(c.P, c.Q, c.scale, x) == Contact::touching;
    if (missed != on(found, x)) return (missed ? "not found: " : "invented: ") + text(x);
  }
  for (const TightPassage& piece : found) {
    for (const Point& x : piece.points) {
      if (contact_at(c.P, c.Q, c.scale, x) != Contact::touching) return "not tight: " + text(x);
    }
    if (piece.points.size() == 1 && where(sum, piece.points[0]) != Where::inside) {
      return "a point on the boundary: " + text(piece.points[0]);
    }
    for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
      // Avoids the middle: two passages on one line may meet at a boundary point.
      const Point x = piece.points[i] + Rational(5, 11) * (piece.points[i + 1] - piece.points[i]);
      if (where(sum, x) != Where::inside) return "a segment on the boundary: " + text(x);
    }
  }
  return "";
}

bool less(const std::vector<Point>& a, const std::vector<Point>& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less_xy);
}

/// Counts the pieces that end at a point; a closed piece counts twice.
std::size_t ends_at(const Pieces& all, const Point& x) {
  std::size_t count = 0;
  for (const TightPassage& piece : all) {
    count += piece.points.front() == x;
    count += piece.points.size() > 1 && piece.points.back() == x;
  }
  return count;
}

/// The fault of the pieces as a canonical list of maximal pieces.
std::string wrong_form(const Case& c) {
  const Pieces found = pieces(c);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& points = found[i].points;
    if (i > 0 && !less(found[i - 1].points, points)) return "not sorted";
    if (less({points.rbegin(), points.rend()}, points)) return "runs the greater way";
    if (found[i].contacts.size() != std::max<std::size_t>(points.size() - 1, 1)) {
      return "not as many contacts as segments";
    }
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      if (sign(cross(points[k] - points[k - 1], points[k + 1] - points[k])) == 0) {
        return "a vertex in the middle of a segment: " + text(points[k]);
      }
      if (ends_at(found, points[k]) != 0) return "passes a branching: " + text(points[k]);
    }
    // A single piece or three pieces end at a point; a closed piece has both ends at one point.
    const bool closed = points.size() > 1 && points.front() == points.back();
    const std::size_t ends = ends_at(found, points.front());
    if (points.size() == 1 && ends != 1) return "a point on another piece";
    if (closed && ends == 2) {
      const auto least = std::min_element(points.begin(), points.end(), less_xy);
      if (*least != points.front()) return "a closed piece begins elsewhere";
    } else if (ends == 2 || (points.size() > 1 && ends_at(found, points.back()) == 2 && !closed)) {
      return "two pieces that are one";
    }
  }
  return "";
}

bool rings_touch(const PolygonSet& set) {
  bool touch = false;
  const std::vector<Edge> all = edges(set);
  for (const Point& x : vertices(set)) {
    touch = touch || std::count_if(all.begin(), all.end(), [&](const Edge& edge) {
                       return on_segment(x, edge.from, edge.to);
                     }) > 2;
  }
  return touch;
}

/// Every contact covers a part of its segment. Both shapes are held from both sides. If no rings
/// touch, the contacts are all reduced convolution edges that cover a part.
std::string wrong_contacts(const Case& c) {
  const auto all = reduced_convolution(c.P, c.Q);
  const bool all_of_them = !rings_touch(c.P) && !rings_touch(c.Q);
  for (const TightPassage& piece : pieces(c)) {
    const bool point = piece.points.size() == 1;
    for (std::size_t i = 0; i < piece.contacts.size(); ++i) {
      const Point a = piece.points[i], d = point ? Point{0, 0} : piece.points[i + 1] - a;
      const auto covers = [&](const ConvolutionEdge& edge) {
        const auto [from, to] = at_scale(edge, c.P, c.Q, c.scale);
        if (point) return on_segment(a, from, to);
        if (sign(cross(d, from - a)) != 0 || sign(cross(d, to - a)) != 0) return false;
        const Rational low = std::min(dot(d, from - a), dot(d, to - a));
        const Rational high = std::max(dot(d, from - a), dot(d, to - a));
        return sign(high) > 0 && low < dot(d, d);
      };
      const auto with = [&](const ConvolutionEdge& edge) {
        const auto [from, to] = at_scale(edge, c.P, c.Q, c.scale);
        return sign(dot(d, to - from)) > 0;
      };
      const auto& found = piece.contacts[i];
      const std::string at = text(a + Rational(1, 2) * d);
      if (!std::all_of(found.begin(), found.end(), covers)) return "no contact at " + at;
      std::vector<ConvolutionEdge> expected;
      std::copy_if(all.begin(), all.end(), std::back_inserter(expected), covers);
      if (all_of_them &&
          !std::is_permutation(found.begin(), found.end(), expected.begin(), expected.end())) {
        return "other contacts than the edges there, at " + at;
      }
      if (!point && (std::all_of(found.begin(), found.end(), with) ||
                     std::none_of(found.begin(), found.end(), with))) {
        return "held from one side only at " + at;
      }
    }
  }
  return "";
}

std::string fault_of(Source& random, const Case& c) {
  for (const std::string& found : {wrong_points(random, c), wrong_form(c), wrong_contacts(c)}) {
    if (!found.empty()) return found + "\npieces " + listed(pieces(c));
  }
  return "";
}

PolygonSet random_lattice_region(Source& random, int most) {
  const Mesh mesh =
      random_mesh(random, random.between(1, most), random.between(1, most), Grid::lattice);
  PolygonSet set = MeshRegion(mesh, random_choice(random, mesh)).rings();
  drop_straight_vertices(random, set, random.between(0, 2) * 50);
  return set;
}

/// Whole lattice cells, `density` in a hundred: passages one cell wide are common.
PolygonSet random_maze(Source& random, int nx, int ny, int density) {
  const Mesh mesh = random_mesh(random, nx, ny, Grid::lattice);
  std::vector<bool> chosen(mesh.triangles.size(), false);
  do {
    for (std::size_t cell = 0; cell < chosen.size() / 4; ++cell) {
      const bool taken = random.between(1, 100) <= density;
      for (std::size_t k = 0; k < 4; ++k) chosen[4 * cell + k] = taken;
    }
  } while (std::find(chosen.begin(), chosen.end(), true) == chosen.end());
  PolygonSet set = MeshRegion(mesh, chosen).rings();
  drop_straight_vertices(random, set, 80);
  return set;
}

/// Operands on one lattice, where exact fits are common: a maze and some of its cells, or cells and
/// their quarters.
Case random_lattice_case(Source& random) {
  if (random.below(2) == 0) {
    return {random_maze(random, random.between(3, 6), random.between(3, 6), 60),
            random_maze(random, random.between(1, 2), 1, 90), 1};
  }
  const Rational scales[] = {1, 1, 1, Rational(1, 2), 2};
  return {random_lattice_region(random, 4), random_lattice_region(random, random.between(1, 2)),
          scales[random.below(5)]};
}

/// A lattice segment in one of eight directions.
PolygonSet random_segment(Source& random) {
  for (;;) {
    const Point a{random.between(-2, 2), random.between(-2, 2)};
    const int length = random.between(1, 4), x = random.between(-1, 1), y = random.between(-1, 1);
    if (x != 0 || y != 0) return segment_set(a, {a.x + length * x, a.y + length * y});
  }
}

TEST(TightPassages, AreTheDefinitionPointByPointOnALattice) {
  MINKREF_SEEDED(random, 700);
  std::size_t points = 0, lines = 0, bends = 0, branchings = 0, closed = 0;
  expect_law(random, 200, random_lattice_case, [&](const Case& c) {
    const Pieces found = pieces(c);
    for (const TightPassage& piece : found) {
      points += piece.points.size() == 1;
      lines += piece.points.size() == 2;
      bends += piece.points.size() > 2;
      branchings += ends_at(found, piece.points.front()) > 2;
      closed += piece.points.size() > 1 && piece.points.front() == piece.points.back();
    }
    return fault_of(random, c);
  });
  // These kinds are common on the lattice, so that the test is not vacuous.
  EXPECT_GE(points, testing::repetitions(10U));
  EXPECT_GE(lines, testing::repetitions(20U));
  EXPECT_GE(bends, testing::repetitions(5U));
  EXPECT_GT(branchings, 0U);
  RecordProperty("closed", static_cast<int>(closed));
}

TEST(TightPassages, AreTheDefinitionPointByPointWithASegment) {
  MINKREF_SEEDED(random, 701);
  std::size_t count = 0;
  const auto with_segment = [&](Source& source) {
    Case c = random_lattice_case(source);
    (source.below(2) == 0 ? c.P : c.Q) = random_segment(source);
    return c;
  };
  expect_law(random, 100, with_segment, [&](const Case& c) {
    count += pieces(c).size();
    return fault_of(random, c);
  });
  EXPECT_GE(count, testing::repetitions(20U));
}

TEST(TightPassages, AreTheDefinitionPointByPointOnRegionsOfEveryKind) {
  MINKREF_SEEDED(random, 702);
  expect_law(random, 100, [&](const Case& c) { return fault_of(random, c); });
}

TEST(TightPassages, OfAPointAsAnOperandThereAreNone) {
  MINKREF_SEEDED(random, 703);
  expect_law(random, 200, random_lattice_case, [](const Case& c) {
    const PolygonSet point = point_set(Rational(2, 3), -5);
    const Pieces first = tight_passages(c.P, point, c.scale);
    const Pieces second = tight_passages(point, c.Q, c.scale);
    return first.empty() && second.empty() ? "" : listed(first) + listed(second);
  });
}

TEST(TightPassages, OfConvexOperandsThereAreNone) {
  MINKREF_SEEDED(random, 704);
  for (int i = 0; i < repetitions(100); ++i) {
    const PolygonSet P = random_convex_polygon(random), Q = random_convex_polygon(random);
    EXPECT_TRUE(tight_passages(P, Q, random_scale(random)).empty()) << text(P) << text(Q);
  }
}

TEST(TightPassages, AreTheSameWithEveryRouteAndByThemselves) {
  MINKREF_SEEDED(random, 705);
  expect_law(random, 60, random_lattice_case, [](const Case& c) -> std::string {
    for (const Route route : {Route::paper, Route::winding, Route::definition}) {
      const Sum sum = minkowski_sum(c.P, c.Q, c.scale, route, "rational", Passages::find);
      if (!sum.tight_passages) return "none looked for";
      if (*sum.tight_passages != pieces(c)) return "other ones";
    }
    return "";
  });
}

TEST(TightPassages, AreLeftOutUnlessAskedForAndInOtherArithmetics) {
  const PolygonSet square = box(0, 0, 1, 1);
  EXPECT_FALSE(minkowski_sum(square, square, 1).tight_passages);
  for (const char* arithmetic : {"interval", "double", "mpfr:53"}) {
    EXPECT_FALSE(
        minkowski_sum(square, square, 1, Route::paper, arithmetic, Passages::find).tight_passages)
        << arithmetic;
  }
  EXPECT_TRUE(minkowski_sum(square, square, 1, Route::paper, "rational", Passages::find)
                  .tight_passages->empty());
  EXPECT_TRUE(minkowski_sum({}, square, 1, Route::paper, "rational", Passages::find)
                  .tight_passages->empty());
}

/// The pieces under a map that keeps the canonical order, without contacts.
template <class Map>
std::string moved(const Pieces& all, Map&& map) {
  Pieces image = all;
  for (TightPassage& piece : image) {
    for (Point& point : piece.points) point = map(point);
  }
  return listed(image);
}

TEST(TightPassages, AreMovedWithTheOperandsAndScaledWithThem) {
  MINKREF_SEEDED(random, 706);
  expect_law(random, 60, random_lattice_case, [&](const Case& c) -> std::string {
    const Point p{random.rational(12), random.rational(12)};
    const Point q{random.rational(12), random.rational(12)};
    const Pieces found = pieces(c);
    const Pieces shifted_too = tight_passages(shifted(c.P, p), shifted(c.Q, q), c.scale);
    const Point by = c.scale * p + q;
    if (moved(found, [&](const Point& x) { return x + by; }) != listed(shifted_too)) return "moved";
    const Pieces scaled_too = tight_passages(c.P, stretched(c.Q, 1 / c.scale), 1);
    if (moved(found, [&](const Point& x) { return (1 / c.scale) * x; }) != listed(scaled_too)) {
      return "scaled";
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].contacts != shifted_too[i].contacts) return "other contacts when moved";
    }
    return "";
  });
}

TEST(TightPassages, AreThoseOfTheSwappedOperands) {
  // The contacts need not be: which of two parallel edges meets the other's end is a convention.
  MINKREF_SEEDED(random, 707);
  expect_law(random, 60, random_lattice_case, [](const Case& c) -> std::string {
    const Pieces swapped = tight_passages(c.Q, stretched(c.P, c.scale), 1);
    return listed(swapped) == listed(pieces(c)) ? "" : "swapped " + listed(swapped);
  });
}

TEST(TightPassages, DoNotDependOnTheKernel) {
  MINKREF_SEEDED(random, 708);
  const Rational large(Integer(1) << 80), huge = Rational(Integer(1) << 300);
  expect_law(random, 40, random_lattice_case, [&](const Case& c) -> std::string {
    const Pieces found = pieces(c);
    for (const Rational& factor : {large, huge}) {
      const Pieces stretched_too =
          tight_passages(stretched(c.P, 1 + factor), stretched(c.Q, 1 + factor), c.scale);
      if (moved(found, [&](const Point& x) { return (1 + factor) * x; }) != listed(stretched_too)) {
        return "another kernel, other pieces: " + listed(stretched_too);
      }
    }
    return "";
  });
}

TEST(TightPassages, OfOperandsShakenApartAreTheDefinitionToo) {
  // Operands that almost fit do not fit.
  MINKREF_SEEDED(random, 709);
  const auto shaken_case = [](Source& source) {
    Case c = random_lattice_case(source);
    for (PolygonSet* set : {&c.P, &c.Q}) {
      PolygonSet moved = shaken(source, *set, 40);
      if (is_valid(moved)) *set = std::move(moved);
    }
    return c;
  };
  expect_law(random, 15, shaken_case, [&](const Case& c) { return fault_of(random, c); });
}

TEST(TightPassages, AreRefusedForWhatTheSumRefuses) {
  const PolygonSet square = box(0, 0, 1, 1), point = point_set(0, 0);
  EXPECT_THROW(tight_passages(square, square, 0), BadInput);
  EXPECT_THROW(tight_passages(point, segment_set({0, 0}, {1, 0}), 1), BadInput);
  EXPECT_TRUE(tight_passages({}, square, 1).empty());
}

}  // namespace
}  // namespace minkref::testing::of_tight_passages
