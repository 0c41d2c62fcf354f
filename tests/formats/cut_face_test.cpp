#include "formats/cut_face.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "reference/error.hpp"
#include "reference/plane/polygon_set.hpp"
#include "reference/space/area_vector.hpp"
#include "reference/space/integer_points.hpp"

namespace minkref::of_cut_face {
namespace {

using Flat = std::vector<std::array<int, 2>>;

/// Lifts a ring into a slanted plane, so that no axis is special.
std::vector<SpacePoint> lifted(const Flat& ring) {
  std::vector<SpacePoint> points;
  for (const auto& [x, y] : ring) points.push_back({Rational(x, 3), y, Rational(2 * x - 3 * y, 7)});
  return points;
}

Face all_of(const Flat& ring) {
  Face face(ring.size());
  std::iota(face.begin(), face.end(), 0U);
  return face;
}

/// Expects triangles of positive area on the face's side, which add up to the face.
void expect_cut(const Flat& ring) {
  const Face face = all_of(ring);
  const auto triangles = triangles_of(face, lifted(ring));
  ASSERT_TRUE(triangles.has_value());
  EXPECT_EQ(triangles->size(), ring.size() - 2);
  const std::vector<IntegerVector> points = integer_points(lifted(ring)).points;
  const IntegerVector whole = area_vector(points, face);
  IntegerVector sum{0, 0, 0};
  for (const Face& triangle : *triangles) {
    const IntegerVector part = area_vector(points, triangle);
    EXPECT_GT(dot(part, whole), 0);
    sum = sum + part;
  }
  EXPECT_EQ(sum, whole);
}

TEST(CutFace, AConvexFaceIsAFanFromItsFirstVertex) {
  const Flat pentagon = {{0, 0}, {4, 0}, {6, 3}, {3, 6}, {-1, 4}};
  EXPECT_EQ(triangles_of(all_of(pentagon), lifted(pentagon)),
            (std::vector<Face>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  expect_cut(pentagon);
}

TEST(CutFace, AClockwiseFaceStaysClockwise) {
  expect_cut({{-1, 4}, {3, 6}, {6, 3}, {4, 0}, {0, 0}});
}

TEST(CutFace, StraightAnglesGiveNoFlatTriangle) {
  expect_cut({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}});
  expect_cut({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}});
  expect_cut({{1, 0}, {2, 0}, {3, 0}, {0, 3}, {0, 0}});
}

TEST(CutFace, FacesThatAreNotConvexAreCut) {
  expect_cut({{0, 0}, {9, 0}, {9, 9}, {5, 1}, {0, 9}});
  expect_cut({{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}});
  // A spiral, and a comb whose teeth end on a common line.
  expect_cut({{0, 0},
              {10, 0},
              {10, 10},
              {2, 10},
              {2, 4},
              {6, 4},
              {6, 6},
              {4, 6},
              {4, 8},
              {8, 8},
              {8, 2},
              {0, 2}});
  expect_cut(
      {{0, 0}, {8, 0}, {8, 4}, {7, 1}, {6, 4}, {5, 1}, {4, 4}, {3, 1}, {2, 4}, {1, 1}, {0, 4}});
}

TEST(CutFace, RandomSimpleFacesAreCut) {
  const unsigned seed = 20260301;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  int cut = 0;
  for (int round = 0; round < 3000; ++round) {
    Flat ring;
    const int size = 4 + static_cast<int>(random() % 9);
    for (int k = 0; k < size; ++k) {
      ring.push_back({static_cast<int>(random() % 9), static_cast<int>(random() % 9)});
    }
    // Sorts half of the rings by angle, which makes simple rings likely.
    if (round % 2 == 0) {
      std::sort(ring.begin(), ring.end(), [](const auto& a, const auto& b) {
        return std::atan2(a[1] - 4.3, a[0] - 4.1) < std::atan2(b[1] - 4.3, b[0] - 4.1);
      });
    }
    Ring plane;
    for (const auto& [x, y] : ring) plane.push_back({x, y});
    PolygonSet set{{{plane, {}}}};
    orient(set);
    try {
      validate(set);
    } catch (const BadInput&) {
      continue;
    }
    expect_cut(ring);
    ++cut;
  }
  EXPECT_GT(cut, 300);
}

TEST(CutFace, AFaceThatCrossesItselfOrHasNoAreaIsNotCut) {
  const Flat flat = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  EXPECT_FALSE(triangles_of(all_of(flat), lifted(flat)).has_value());
  const Flat pair = {{0, 0}, {1, 1}};
  EXPECT_FALSE(triangles_of(all_of(pair), lifted(pair)).has_value());
  // Runs round the same triangle twice.
  const Flat twice = {{0, 0}, {4, 0}, {0, 4}, {0, 0}, {4, 0}, {0, 4}};
  EXPECT_FALSE(triangles_of(all_of(twice), lifted(twice)).has_value());
}

}  // namespace
}  // namespace minkref::of_cut_face
