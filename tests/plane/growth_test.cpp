// Work grows nearly as its input where the answer does: turns of loops are counted, no time.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/history/edges_on_lines.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "reference/plane/routes/simply_connected.hpp"
#include "reference/plane/sum.hpp"
#include "tests/counted_turns.hpp"
#include "tests/plane/shapes.hpp"
#include "tests/spiked_star.hpp"

namespace minkref::testing::of_growth {
namespace {

/// A plate with side * side holes, none like another, and twice as many teeth along one side.
PolygonSet plate(int side) {
  std::vector<Ring> holes;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const int x = 100 * i + (7 * i + 13 * j) % 19, y = 100 * j + (11 * i + 5 * j) % 23;
      holes.push_back(rectangle(x + 10, y + 10, x + 60, y + 70));
    }
  }
  Ring outline{{100 * side, 0}, {100 * side, 100 * side}, {0, 100 * side}};
  for (int k = 0; k < 4 * side * side; ++k) {
    outline.push_back({Rational(25 * k, side), k % 2 == 0 ? 0 : -5});
  }
  return region(outline, holes);
}

/// Square frames inside each other.
PolygonSet frames(int count) {
  PolygonSet set;
  for (int k = 1; k <= count; ++k) {
    set = together(set, region(rectangle(-10 * k, -10 * k, 10 * k, 10 * k),
                               {rectangle(3 - 10 * k, 3 - 10 * k, 10 * k - 3, 10 * k - 3)}));
  }
  return set;
}

/// Squares beside each other.
PolygonSet row(int count) {
  PolygonSet set;
  for (int k = 0; k < count; ++k) set.polygons.push_back({rectangle(40 * k, 0, 40 * k + 9, 9), {}});
  return set;
}

/// Rooms with walls, beside each other.
PolygonSet rooms(int count) {
  PolygonSet set;
  for (int k = 0; k < count; ++k) {
    const int x = 99 * k;
    set = together(set, region(rectangle(x, 0, x + 80, 80), {rectangle(x + 5, 5, x + 75, 75)}));
  }
  return set;
}

/// A comb, whose edges fall into few directions.
PolygonSet comb(int teeth) {
  Ring ring{{-20, -100}, {20 * teeth, -100}, {20 * teeth, 0}};
  for (int k = teeth - 1; k >= 0; --k) {
    const int left = 20 * k, top = 90 + k % 7;
    ring.insert(ring.end(), {{left + 9, 0}, {left + 9, top}, {left, top}, {left, 0}});
  }
  ring.push_back({-20, 0});
  return region(ring);
}

const PolygonSet octagon =
    region({{3, -7}, {7, -3}, {7, 3}, {3, 7}, {-3, 7}, {-7, 3}, {-7, -3}, {-3, -7}});

TEST(Growth, ValidationAsksAFewEdgesForEachHole) {
  const PolygonSet small = plate(16), large = plate(32);
  expect_growth([&] { validate(small); }, [&] { validate(large); });
}

TEST(Growth, ValidationListsNoPairsOfNestedRings) {
  const PolygonSet small = frames(64), large = frames(256);
  expect_growth([&] { validate(small); }, [&] { validate(large); });
}

TEST(Growth, CanonicalFormsFindThePlaceOfEachHoleByATree) {
  const PolygonSet small = plate(16), large = plate(32);
  expect_growth([&] { (void)canonicalize(small); }, [&] { (void)canonicalize(large); });
}

TEST(Growth, SumsAskWhetherAPointIsHeldByATree) {
  const PolygonSet small = plate(16), large = plate(32);
  const auto sum = [](const PolygonSet& P) { (void)minkowski_sum(P, octagon, 1); };
  expect_growth([&] { sum(small); }, [&] { sum(large); });
}

TEST(Growth, SumsAskOnlyRingsThatAreNearAPoint) {
  const PolygonSet small = rooms(100), large = rooms(400);
  const auto sum = [](const PolygonSet& P) { (void)minkowski_sum(P, octagon, 1); };
  expect_growth([&] { sum(small); }, [&] { sum(large); });
}

TEST(Growth, ComponentsOfAnArrangementFindTheirFaceByATree) {
  const PolygonSet small = row(400), large = row(1600);
  const auto sum = [](const PolygonSet& P) { (void)minkowski_sum(P, octagon, 1); };
  expect_growth([&] { sum(small); }, [&] { sum(large); });
}

TEST(Growth, SlitsToHolesAreFoundByATree) {
  const PolygonSet small = plate(16), large = plate(32);
  expect_growth([&] { (void)cut_to_simply_connected(small); },
                [&] { (void)cut_to_simply_connected(large); });
}

TEST(Growth, PairsOfEdgesAreFoundByATreeOfMovingBoxes) {
  const PolygonSet small = comb(100), large = comb(400);
  const auto find = [](const PolygonSet& P) {
    (void)pair_events(P, octagon, {Rational(1, 2), Rational(2)});
  };
  expect_growth([&] { find(small); }, [&] { find(large); });
}

TEST(Growth, PairsOfSlantedEdgesAreFoundByBoxesAlongThem) {
  const PolygonSet small = spiked_star(500), large = spiked_star(2000);
  const auto find = [](const PolygonSet& P) {
    (void)pair_events(P, octagon, {Rational(1, 2), Rational(2)});
  };
  expect_growth([&] { find(small); }, [&] { find(large); });
}

TEST(Growth, EdgesOnALineAreFoundByTheirPlaceOnIt) {
  const auto find = [](int count) {
    std::vector<RationalEdge> edges;
    for (int k = 0; k < count; ++k) {
      edges.push_back({ConvolutionEdge::Kind::S, {20 * k, 0}, {0, 0}, {9, 0}});
    }
    const std::vector<Track> tracks{{{-9, 0}, {0, 0}}, {{20 * count, 0}, {20 * count, 0}}};
    const EdgeDirections directions = edge_directions(edges);
    EdgesOnLines lines(edges, directions);
    std::vector<std::uint32_t> found;
    for (std::uint32_t k = 0; k < edges.size(); ++k) {
      lines.along({0, 1, k, 0, 0}, tracks, 1, true, {20 * static_cast<int>(k) + 5, 0}, found);
    }
    ASSERT_EQ(found.size(), edges.size());
    for (std::uint32_t k = 0; k < edges.size(); ++k) EXPECT_EQ(found[k], k);
  };
  expect_growth([&] { find(300); }, [&] { find(1200); });
}

TEST(Growth, AnIndexKeepsNoParallelEdgesThatNeverMeet) {
  const auto kept = [](int teeth) {
    const ScaleWindow window{Rational(1, 2), Rational(2)};
    const auto counts = ScaleIndex(comb(teeth), octagon, window).counts();
    return static_cast<double>(counts.meeting_pairs);
  };
  const double before = kept(20), after = kept(80);
  EXPECT_LT(after, std::pow(4, 1.25) * before) << before << " pairs before";
}

}  // namespace
}  // namespace minkref::testing::of_growth
