// Unions of unit cells: their sum is a union of square blocks, which the tests count.
#include <gtest/gtest.h>

#include <set>

#include "reference/plane/sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_polyomino {
namespace {

using Cell = std::pair<int, int>;  // its lower left corner
using Cells = std::set<Cell>;

Cells random_cells(Source& random, int width, int height) {
  Cells cells;
  const int density = random.between(30, 90);
  while (cells.empty()) {
    for (int x = 0; x < width; ++x) {
      for (int y = 0; y < height; ++y) {
        if (random.between(1, 100) <= density) cells.insert({x, y});
      }
    }
  }
  return cells;
}

PolygonSet polygons(const Cells& cells) {
  Mesh mesh;
  std::map<Cell, std::size_t> index;
  const auto at = [&](int x, int y) {
    const auto [found, added] = index.insert({{x, y}, mesh.points.size()});
    if (added) mesh.points.push_back({x, y});
    return found->second;
  };
  for (const auto& [x, y] : cells) {
    const std::size_t a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  const std::vector<bool> all(mesh.triangles.size(), true);
  return MeshRegion(mesh, all).rings();
}

/// a P + b Q for sets of unit cells: each pair of cells sums to a block of (a + b) x (a + b) cells.
Cells block_sum(const Cells& P, int a, const Cells& Q, int b) {
  Cells sum;
  for (const auto& [px, py] : P) {
    for (const auto& [qx, qy] : Q) {
      for (int i = 0; i < a + b; ++i) {
        for (int j = 0; j < a + b; ++j) sum.insert({a * px + b * qx + i, a * py + b * qy + j});
      }
    }
  }
  return sum;
}

/// Counts parts connected by edges: the interior does not join cells that share only a corner, and
/// the open complement does not join such holes.
std::size_t connected_parts(Cells cells) {
  std::size_t parts = 0;
  for (; !cells.empty(); ++parts) {
    std::vector<Cell> front{*cells.begin()};
    cells.erase(cells.begin());
    while (!front.empty()) {
      const auto [x, y] = front.back();
      front.pop_back();
      for (const Cell& next : {Cell{x + 1, y}, Cell{x - 1, y}, Cell{x, y + 1}, Cell{x, y - 1}}) {
        if (cells.erase(next) != 0) front.push_back(next);
      }
    }
  }
  return parts;
}

/// The cells of the frame's box outside the set; one part of them lies outside the frame.
Cells complement(const Cells& cells, int size) {
  Cells rest;
  for (int x = -1; x <= size; ++x) {
    for (int y = -1; y <= size; ++y) {
      if (cells.count({x, y}) == 0) rest.insert({x, y});
    }
  }
  return rest;
}

void expect_blocks(const Cells& P, const Cells& Q, int a, int b, int size, Route route) {
  const Cells truth = block_sum(P, a, Q, b);
  const Sum sum = minkowski_sum(polygons(P), polygons(Q), Rational(a, b), route);
  const std::string shown = text(Case{polygons(P), polygons(Q), Rational(a, b)});
  const PolygonSet region = stretched(sum.region, b);
  ASSERT_EQ(area(region), Rational(truth.size())) << shown;
  ASSERT_EQ(sum.components, connected_parts(truth)) << shown;
  ASSERT_EQ(sum.holes, connected_parts(complement(truth, size)) - 1) << shown;
  for (const auto& [x, y] : truth) {
    ASSERT_EQ(where(region, {x + Rational(1, 2), y + Rational(1, 3)}), Where::inside) << shown;
  }
  ASSERT_EQ(canonical_json(region), canonical_json(canonicalize(polygons(truth)).region)) << shown;
}

void expect_blocks_at_random(std::uint64_t seed, int count, Route route) {
  MINKREF_SEEDED(random, seed);
  for (int i = 0; i < repetitions(count) && !::testing::Test::HasFatalFailure(); ++i) {
    const Cells P = random_cells(random, random.between(1, 7), random.between(1, 7));
    const Cells Q = random_cells(random, random.between(1, 3), random.between(1, 3));
    const int a = random.between(1, 3), b = random.between(1, 2);
    expect_blocks(P, Q, a, b, 7 * a + 3 * b, route);
  }
}

TEST(Polyominoes, SumIsTheUnionOfBlocksByThePapersRoute) {
  expect_blocks_at_random(500, 120, Route::paper);
}
TEST(Polyominoes, SumIsTheUnionOfBlocksByWinding) {
  expect_blocks_at_random(501, 60, Route::winding);
}
TEST(Polyominoes, SumIsTheUnionOfBlocksByDefinition) {
  expect_blocks_at_random(502, 60, Route::definition);
}

TEST(Polyominoes, LargeSparseSetHasManyHolesThatMeetInCorners) {
  MINKREF_SEEDED(random, 503);
  for (int i = 0; i < 4; ++i) {
    Cells P;
    for (int x = 0; x < 24; ++x) {
      for (int y = 0; y < 24; ++y) {
        if (random.between(1, 100) <= 30) P.insert({x, y});
      }
    }
    expect_blocks(P, {{0, 0}}, 1, 1, 26, Route::paper);
  }
}

TEST(Polyominoes, ACheckerboardFillsUp) {
  Cells P;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) {
      if ((x + y) % 2 == 0) P.insert({x, y});
    }
  }
  // The blocks of the cells (0,0) and (5,5) end at [0,2]^2 and [5,7]^2; the corner cells (6,0) and
  // (0,6) of the box [0,7]^2 stay empty.
  const Sum sum = minkowski_sum(polygons(P), box(0, 0, 1, 1), 1);
  EXPECT_EQ(sum.components, 1U);
  EXPECT_EQ(sum.holes, 0U);
  EXPECT_EQ(area(sum), 47);
}

}  // namespace
}  // namespace minkref::testing::of_polyomino
