// Triangle pairs that clusters omit never cross or cover each other; surfaces and rings with
// slivers get the verdict of all pairs, in near-linear time.
#include "reference/near/near_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>

#include "reference/error.hpp"
#include "reference/plane/polygon_set.hpp"
#include "reference/space/integer_points.hpp"
#include "reference/space/surface_triangles.hpp"
#include "reference/space/triangle_contact.hpp"
#include "tests/space/surfaces.hpp"

namespace minkref::of_near_pairs {
namespace {

using surfaces::at;
using surfaces::tetrahedron;
using surfaces::together;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// A star whose radius alternates between `radius` and half `radius`.
std::vector<std::pair<long, long>> star(int corners, double radius) {
  std::vector<std::pair<long, long>> result;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::acos(-1.0) * k / corners, r = k % 2 == 0 ? radius : radius / 2;
    result.emplace_back(std::lround(r * std::cos(angle)), std::lround(r * std::sin(angle)));
  }
  return result;
}

Polyhedron double_cone(int corners, double radius) {
  Polyhedron result;
  for (const auto& [x, y] : star(corners, radius)) result.vertices.push_back({x, y, 0});
  const auto n = static_cast<std::uint32_t>(corners);
  result.vertices.push_back({0, 0, static_cast<long>(radius)});
  result.vertices.push_back({0, 0, -static_cast<long>(radius)});
  for (std::uint32_t k = 0; k < n; ++k) {
    result.faces.push_back({k, (k + 1) % n, n});
    result.faces.push_back({(k + 1) % n, k, n + 1});
  }
  return result;
}

Polyhedron star_prism(int corners, double radius) {
  Polyhedron result;
  const auto n = static_cast<std::uint32_t>(corners);
  for (const long z : {0L, 1000L}) {
    for (const auto& [x, y] : star(corners, radius)) result.vertices.push_back({x, y, z});
  }
  Face bottom, top;
  for (std::uint32_t k = 0; k < n; ++k) {
    bottom.push_back(n - 1 - k);
    top.push_back(n + k);
    const std::uint32_t next = (k + 1) % n;
    result.faces.push_back({k, next, n + next, n + k});
  }
  result.faces.push_back(bottom);
  result.faces.push_back(top);
  return result;
}

struct Triangles {
  IntegerPoints points;
  VertexSigns signs;
  std::vector<SurfaceTriangle> all;
  explicit Triangles(const Polyhedron& mesh)
      : points(integer_points(mesh.vertices)),
        signs(points.points),
        all(surface_triangles(mesh.faces, signs)) {}
};

std::set<Pair> near_pairs(const Triangles& triangles) {
  std::vector<IntegerVector> places = triangles.points.points;
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<NearPoint> points;
  for (const IntegerVector& p : places) {
    points.push_back(
        {{p[0].convert_to<double>(), p[1].convert_to<double>(), p[2].convert_to<double>()},
         0});  // all are short
  }
  std::vector<NearItem> items;
  for (const SurfaceTriangle& t : triangles.all) {
    NearItem& item = items.emplace_back(NearItem{{}, t.face});
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place =
          std::lower_bound(places.begin(), places.end(), triangles.points.points[t.corners[k]]);
      item.corners[k] = static_cast<std::uint32_t>(place - places.begin());
    }
  }
  std::set<Pair> result;
  NearPairs(points, items).pairs([&](std::uint32_t i, std::uint32_t j) {
    EXPECT_TRUE(result.emplace(i, j).second) << "twice";
    EXPECT_LT(i, j);
  });
  return result;
}

/// Counts the pairs that cross or cover each other.
std::size_t expect_all_contacts_found(const Polyhedron& mesh) {
  const Triangles triangles(mesh);
  const std::set<Pair> found = near_pairs(triangles);
  std::size_t contacts = 0;
  for (std::uint32_t i = 0; i < triangles.all.size(); ++i) {
    for (std::uint32_t j = i + 1; j < triangles.all.size(); ++j) {
      if (triangles.all[i].face == triangles.all[j].face) continue;
      if (contact_of(triangles.all, triangles.signs, i, j) == TriangleContact::none) continue;
      ++contacts;
      EXPECT_TRUE(found.contains({i, j})) << i << ", " << j;
    }
  }
  return contacts;
}

/// Corners on a small grid: most corners are shared, and many faces are coplanar.
TEST(NearPairs, LeaveNoCrossingAside) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const auto number = [&](int most) { return static_cast<int>(random() % (most + 1U)); };
  std::size_t contacts = 0;
  for (int turn = 0; turn < 80; ++turn) {
    Polyhedron mesh;
    for (int k = 0; k < 12; ++k) {
      const auto corner = [&] { return at(number(4), number(4), number(4)); };
      const Polyhedron part = tetrahedron(corner(), corner(), corner(), corner());
      if (sextuple_volume(part) != 0) mesh = together({mesh, part});
    }
    if (turn % 3 == 0) {
      const Polyhedron cone = double_cone(24 + 2 * number(20), 4 + number(40));
      mesh = together({mesh, cone, translated(cone, at(number(2), number(2), 8 * number(1)))});
    }
    contacts += expect_all_contacts_found(mesh);
  }
  EXPECT_GT(contacts, 300U);
}

/// Each spike of the second star begins at a corner of the first: crossings through shared corners.
TEST(NearPairs, StarsThroughTheCornersOfStars) {
  const Polyhedron cone = double_cone(120, 1e6);
  EXPECT_EQ(expect_all_contacts_found(cone), 0U);
  Polyhedron other = cone;
  std::rotate(other.vertices.begin(), other.vertices.begin() + 2, other.vertices.begin() + 120);
  EXPECT_GT(expect_all_contacts_found(together({cone, other})), 0U);
  EXPECT_GT(expect_all_contacts_found(together({cone, translated(cone, at(0, 0, 1000000))})), 0U);
}

TEST(NearPairs, AreFewAmongSlivers) {
  for (const Polyhedron& mesh : {double_cone(2000, 1e9), star_prism(400, 1e9)}) {
    const Triangles triangles(mesh);
    EXPECT_LT(near_pairs(triangles).size(), 40 * triangles.all.size());
    EXPECT_NO_THROW(validate(mesh));
  }
}

std::string code_of(const auto& value) {
  try {
    validate(value);
  } catch (const BadInput& fault) {
    return fault.code();
  }
  return "";
}

/// Large enough that boxes alone give up.
TEST(NearPairs, FaultsAmongManySliversAreFound) {
  const Polyhedron whole = double_cone(2000, 1e9);
  EXPECT_EQ(code_of(whole), "");
  Polyhedron pierced = whole;  // a spike bent across its neighbours
  std::swap(pierced.vertices[900], pierced.vertices[904]);
  EXPECT_EQ(code_of(pierced), "self-intersection");
  const SpacePoint up = at(0, 0, 2000000000);
  EXPECT_EQ(code_of(together({whole, translated(whole, up)})), "");  // apex to apex
  EXPECT_EQ(code_of(together({whole, whole})), "overlapping-faces");
}

TEST(NearPairs, RingsOfSpikesAreJudgedAsAllPairsJudgeThem) {
  const auto code = [](const Ring& ring) { return code_of(PolygonSet{{Polygon{ring, {}}}}); };
  Ring ring;
  for (const auto& [x, y] : star(1000, 1e9)) ring.push_back({x, y});
  EXPECT_EQ(code(ring), "");
  Ring crossing = ring;
  std::swap(crossing[500], crossing[504]);
  EXPECT_EQ(code(crossing), "self-intersection");
  Ring touching = ring;
  touching[601] = touching[301];
  EXPECT_EQ(code(touching), "self-intersection");
}

TEST(NearPairs, RingsBeyondTheRangeOfDoubles) {
  Ring ring;
  for (const auto& [x, y] : star(300, 1e9)) ring.push_back({x, y});
  for (const char* factor : {"1e400", "1e-400"}) {
    EXPECT_EQ(code_of(scaled(PolygonSet{{Polygon{ring, {}}}}, parse_rational(factor))), "");
  }
}

}  // namespace
}  // namespace minkref::of_near_pairs
