// Large faces of any shape are cut into triangles with positive areas that add up to the face.
#include "reference/space/monotone_triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "reference/space/area_vector.hpp"

namespace minkref::of_monotone_triangles {
namespace {

using Flat = std::vector<std::pair<long, long>>;

/// Cuts the ring in three planes, seen from both sides. The function itself adds areas up: this
/// check adds them again, and counts edges.
void expect_cut(const Flat& ring) {
  for (const std::size_t axis : {0U, 1U, 2U}) {
    for (const bool turned : {false, true}) {
      std::vector<IntegerVector> points;
      for (const auto& [x, y] : ring) {
        IntegerVector p{Integer(x), Integer(y), Integer(x + 2 * y)};
        std::rotate(p.begin(), p.begin() + axis, p.end());
        points.push_back(p);
      }
      Face face(points.size());
      std::iota(face.begin(), face.end(), 0U);
      if (turned) std::reverse(face.begin(), face.end());
      const VertexSigns signs(points);
      const auto triangles = monotone_triangles(face, signs);
      ASSERT_TRUE(triangles);
      ASSERT_EQ(triangles->size() + 2, face.size());
      const IntegerVector whole = area_vector(points, face);
      IntegerVector sum{0, 0, 0};
      std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
      for (const auto& [a, b, c] : *triangles) {
        const IntegerVector area = cross(points[b] - points[a], points[c] - points[a]);
        EXPECT_GT(dot(area, whole), 0);
        sum = sum + area;
        for (const auto& run : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
          runs.push_back(run);
        }
      }
      EXPECT_EQ(sum, whole);
      // Each diagonal runs once either way, each edge once.
      std::sort(runs.begin(), runs.end());
      EXPECT_EQ(std::adjacent_find(runs.begin(), runs.end()), runs.end());
      for (std::size_t k = 0; k < face.size(); ++k) {
        const std::pair edge(face[k], face[(k + 1) % face.size()]);
        EXPECT_TRUE(std::binary_search(runs.begin(), runs.end(), edge));
      }
    }
  }
}

TEST(MonotoneTriangles, OfCombsWithStraightAngles) {
  Flat comb;
  for (long k = 0; k < 40; ++k) {
    comb.insert(comb.end(),
                {{4 * k, 0}, {4 * k, 9}, {4 * k + 1, 9}, {4 * k + 2, 9}, {4 * k + 2, 0}});
  }
  comb.insert(comb.end(), {{158, -5}, {80, -5}, {0, -5}});
  std::reverse(comb.begin(), comb.end());
  expect_cut(comb);
}

TEST(MonotoneTriangles, OfSpirals) {
  Flat out, in;
  for (long k = 1; k < 40; ++k) {
    const long r = 3 * k;
    out.insert(out.end(), {{r, -r}, {r + 1, r}, {-r - 1, r + 1}, {-r - 2, -r - 2}});
    in.insert(in.end(), {{r + 1, -r - 1}, {r + 2, r + 1}, {-r - 2, r + 2}, {-r - 3, -r - 3}});
  }
  std::reverse(in.begin(), in.end());
  out.insert(out.end(), in.begin(), in.end());
  std::reverse(out.begin(), out.end());
  expect_cut(out);
}

TEST(MonotoneTriangles, OfRandomStarsOnAGrid) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int turn = 0; turn < 200; ++turn) {
    Flat ring;
    const int corners = 4 + static_cast<int>(random() % 60);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::acos(-1.0) * k / corners;
      const double r = turn % 2 == 0 ? 10 + random() % 1000 : 100.0 * (1 + random() % 3);
      ring.emplace_back(std::lround(r * std::cos(angle)) * 2, std::lround(r * std::sin(angle)) * 2);
    }
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    Flat refined;  // with corners in the middle of edges
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto& [x, y] = ring[k];
      const auto& [u, v] = ring[(k + 1) % ring.size()];
      refined.emplace_back(x, y);
      if (random() % 3 == 0) refined.emplace_back((x + u) / 2, (y + v) / 2);
    }
    expect_cut(turn % 4 < 2 ? ring : refined);
  }
}

TEST(MonotoneTriangles, WhatIsNotSimpleIsNotCut) {
  const std::vector<IntegerVector> points = {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 5, 0}};
  EXPECT_FALSE(monotone_triangles({0, 1, 2, 3}, VertexSigns(points)));
}

}  // namespace
}  // namespace minkref::of_monotone_triangles
