// The arrangement of segments, with every degeneracy.
#include <gtest/gtest.h>

#include "tests/plane/arrangement_laws.hpp"
#include "tests/plane/random_cases.hpp"
#include "tests/plane/random_segments.hpp"

namespace minkref::testing::of_arrangement {
namespace {

std::string fault_of(const std::vector<Edge>& segments) {
  try {
    return ArrangementLaws(segments).fault();
  } catch (const std::exception& e) {
    return std::string("throws: ") + e.what();
  }
}

void expect_laws(std::vector<Edge> segments) {
  if (fault_of(segments).empty()) return;
  for (std::size_t i = 0; i < segments.size();) {  // drop what does not matter
    std::vector<Edge> fewer = segments;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!fewer.empty() && !fault_of(fewer).empty()) {
      segments = fewer;
      i = 0;
    } else {
      ++i;
    }
  }
  std::string shown;
  for (const Edge& e : segments) shown += "[" + text(e.from) + "," + text(e.to) + "]\n";
  FAIL() << fault_of(segments) << "\n" << shown;
}

TEST(Arrangement, LawsHoldOnRandomDegenerateSegments) {
  MINKREF_SEEDED(random, 1600);
  for (int i = 0; i < repetitions(800) && !::testing::Test::HasFailure(); ++i) {
    expect_laws(random_segments(random));
  }
}

TEST(Arrangement, LawsHoldOnRandomRationalSegments) {
  MINKREF_SEEDED(random, 1601);
  for (int i = 0; i < repetitions(100) && !::testing::Test::HasFailure(); ++i) {
    std::vector<Edge> all;
    for (int k = random.between(2, 12); k > 0; --k) {
      all.push_back(
          {{random.rational(4), random.rational(40)}, {random.rational(4), random.rational(4)}});
      if (all.back().from == all.back().to) all.pop_back();
    }
    if (!all.empty()) expect_laws(all);
  }
}

TEST(Arrangement, LawsHoldOnManySegments) {
  MINKREF_SEEDED(random, 1602);
  std::vector<Edge> all;
  for (int i = 0; i < 60; ++i) {
    const Edge e{random_grid_point(random, 12), random_grid_point(random, 12)};
    if (e.from != e.to) all.push_back(e);
  }
  expect_laws(all);
}

TEST(Arrangement, LawsHoldOnNestedComponents) {
  // Nested squares, antennas, and components side by side within one face.
  std::vector<Edge> all;
  for (int i = 0; i < 4; ++i) {
    for (const Edge& e : edges(box(i, i, 20 - i, 20 - i))) all.push_back(e);
  }
  for (const Edge& e : edges(together(box(5, 5, 7, 7), box(9, 9, 12, 12)))) all.push_back(e);
  all.push_back({{6, 6}, {8, 6}});  // leaves a square, ends in the face around it
  all.push_back({{10, 10}, {11, 11}});
  all.push_back({{14, 14}, {15, 15}});
  all.push_back({{5, 5}, {4, 4}});
  expect_laws(all);
}

std::vector<Edge> star(int rays) {
  std::vector<Edge> all;
  for (int i = 0; i < rays; ++i) all.push_back({{i - rays, -7 - i}, {rays - i, 7 + i}});
  return all;
}

TEST(Arrangement, OneNodeWhereManySegmentsCross) {
  const std::vector<Edge> all = star(12);
  const ArrangementLaws laws(all);
  EXPECT_EQ(laws.fault(), "");
  EXPECT_EQ(laws.arrangement().node_count(), 25U);
  EXPECT_EQ(laws.arrangement().half_edge_count(), 48U);
  EXPECT_EQ(laws.arrangement().face_count(), 1U);
}

TEST(Arrangement, OneSubEdgeWhereManySegmentsOverlap) {
  std::vector<Edge> all;
  for (int i = 0; i < 5; ++i) {
    all.push_back({{i, i}, {10 + i, 10 + i}});
    all.push_back({{10, 10}, {4, 4}});
  }
  const ArrangementLaws laws(all);
  EXPECT_EQ(laws.fault(), "");
  EXPECT_EQ(laws.arrangement().node_count(), 10U);
  EXPECT_EQ(laws.arrangement().half_edge_count(), 18U);
  std::size_t most = 0;
  for (std::uint32_t h = 0; h < laws.arrangement().half_edge_count(); ++h) {
    most = std::max<std::size_t>(
        most, laws.arrangement().covers_end(h) - laws.arrangement().covers_begin(h));
  }
  EXPECT_EQ(most, 10U);
}

TEST(Arrangement, OfNothingIsOneFace) {
  const ExactKernel kernel;
  const ExactArrangement nothing(kernel, {}, {});
  EXPECT_EQ(nothing.node_count(), 0U);
  EXPECT_EQ(nothing.half_edge_count(), 0U);
  EXPECT_EQ(nothing.face_count(), 1U);
}

TEST(Arrangement, SegmentsOfNoLengthAreIgnored) {
  const ExactKernel kernel;
  using V = Vector2<Rational>;
  // Two crossing segments, and three points: at the crossing, on one segment, and apart.
  const std::vector<V> vertices{V(0, 0), V(4, 4), V(0, 4), V(4, 0), V(2, 2), V(1, 1), V(9, 9)};
  const ExactArrangement built(kernel, vertices, {{0, 1}, {2, 3}, {4, 4}, {5, 5}, {6, 6}});
  EXPECT_EQ(built.half_edge_count(), 8U);
  EXPECT_EQ(built.face_count(), 1U);
}

TEST(Arrangement, VerticesMayBeSharedAndGivenTwice) {
  const ExactKernel kernel;
  using V = Vector2<Rational>;
  const std::vector<V> vertices{V(0, 0), V(4, 0), V(4, 4), V(0, 4), V(0, 0), V(4, 4)};
  const ExactArrangement built(kernel, vertices, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}});
  EXPECT_EQ(built.node_count(), 4U);
  EXPECT_EQ(built.half_edge_count(), 10U);
  EXPECT_EQ(built.face_count(), 3U);
}

}  // namespace
}  // namespace minkref::testing::of_arrangement
