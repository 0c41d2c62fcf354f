// The paper's update in space (Sec. 5) with rational numbers and corrected readings: the exact sum.
#include "reference/paper/space/paper_space_update.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "reference/error.hpp"
#include "reference/space/edges/edge_sum.hpp"
#include "tests/space/sums/polycubes.hpp"
#include "tests/space/surfaces.hpp"

namespace minkref::of_paper_space_update {
namespace {

using surfaces::at;
using surfaces::box;
using surfaces::box_at;
using surfaces::together;

std::unique_ptr<PaperSpaceUpdate> corrected(const Polyhedron& P, const Polyhedron& Q,
                                            const Rational& first) {
  return PaperSpaceUpdate::make(P, Q, first, "rational", corrected_space_update_readings());
}

/// Random events from the walk, each followed by a scale between events.
std::vector<Rational> scales_of(const PaperSpaceUpdate& walk, std::size_t most,
                                std::mt19937& dice) {
  std::vector<Rational> scales;
  for (const auto& event : walk.events()) scales.push_back(event.scale);
  scales.erase(std::unique(scales.begin(), scales.end()), scales.end());
  std::vector<Rational> chosen;
  for (std::size_t k = 0; k < most && !scales.empty(); ++k) {
    const std::size_t i = std::uniform_int_distribution<std::size_t>(0, scales.size() - 1)(dice);
    chosen.push_back(scales[i]);
    chosen.push_back((scales[i] + scales[(i + 1) % scales.size()]) / 2);
  }
  if (chosen.empty()) chosen = {1, Rational(1, 3), 2};
  return chosen;
}

/// Compares sums at random scales, every second scale an event.
void expect_exact_sums(const Polyhedron& P, const Polyhedron& Q, std::size_t most,
                       std::mt19937& dice, const std::string& name) {
  const auto walk = corrected(P, Q, Rational(1, 2));
  for (const Rational& s : scales_of(*walk, most, dice)) {
    walk->move_to(s);
    const PaperSpaceSum sum = walk->sum();
    const PolyhedralSet exact = edge_sum(P, Q, {s, s, s}).set;
    EXPECT_TRUE(*sum.set == exact) << name << " at " << s;
  }
}

Polyhedron random_tetrahedron(std::mt19937& dice) {
  std::uniform_int_distribution<int> coordinate(-6, 6);
  for (;;) {
    const auto corner = [&] { return at(coordinate(dice), coordinate(dice), coordinate(dice)); };
    Polyhedron body = surfaces::tetrahedron(corner(), corner(), corner(), corner());
    if (polycubes::is_valid(body)) return body;
  }
}

/// A triangular prism with a triangular hole through it, along the third axis.
Polyhedron frame() {
  Polyhedron body;
  for (const int z : {0, 2}) {
    for (const auto& [x, y] : {std::pair{0, 0}, {9, 0}, {0, 9}, {2, 2}, {4, 2}, {2, 4}}) {
      body.vertices.push_back(at(x, y, z));
    }
  }
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t next = (k + 1) % 3;
    body.faces.push_back({k, next, next + 6, k + 6});          // outside
    body.faces.push_back({next + 3, k + 3, k + 9, next + 9});  // in the hole
    body.faces.push_back({next, k, k + 3, next + 3});          // below
    body.faces.push_back({k + 6, next + 6, next + 9, k + 9});  // above
  }
  return body;
}

TEST(PaperSpaceUpdate, EqualsTheExactSumOfBoxes) {
  std::mt19937 dice(1);
  expect_exact_sums(box(1, 2, 3), box(2, 2, 2), 3, dice, "boxes");
  expect_exact_sums(box(1, 1, 1), together({box(2, 2, 2), box_at(0, 0, 5, 2, 1, 3)}), 3, dice,
                    "two boxes");
}

TEST(PaperSpaceUpdate, EqualsTheExactSumOfTetrahedra) {
  const unsigned seed = 20260;
  std::mt19937 dice(seed);
  for (int trial = 0; trial < 3; ++trial) {
    const Polyhedron P = random_tetrahedron(dice), Q = random_tetrahedron(dice),
                     more = translated(random_tetrahedron(dice), at(20, 1, 3));
    expect_exact_sums(P, together({Q, more}), 2, dice,
                      "seed 20260, trial " + std::to_string(trial));
  }
}

TEST(PaperSpaceUpdate, EqualsTheExactSumWhereAHoleCloses) {
  std::mt19937 dice(3);
  ASSERT_TRUE(polycubes::is_valid(frame()));
  expect_exact_sums(surfaces::tetrahedron(at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)),
                    frame(), 3, dice, "a frame");
  expect_exact_sums(surfaces::tetrahedron(at(0, 0, 0), at(1, 0, 1), at(0, 1, 0), at(0, 0, 1)),
                    surfaces::dented(1), 2, dice, "a dent");
}

TEST(PaperSpaceUpdate, FacetSumsAtOneScaleAreExact) {
  const unsigned seed = 77;
  std::mt19937 dice(seed);
  for (int trial = 0; trial < 4; ++trial) {
    Polyhedron P, Q;
    do {
      P = polycubes::solid(polycubes::random_cells(dice, 2, 3));
      Q = polycubes::solid(polycubes::random_cells(dice, 4, 3), polycubes::random_matrix(dice, 2));
    } while (!polycubes::is_valid(P) || !polycubes::is_valid(Q));
    const Rational s(trial + 1, 2);
    EXPECT_TRUE(*facet_sum_at(P, Q, s).set == edge_sum(P, Q, {s, s, s}).set)
        << "seed " << seed << ", trial " << trial;
  }
  const Polyhedron cavity =
      together({box(6, 6, 6), surfaces::inside_out(box_at(1, 1, 1, 3, 4, 3))});
  for (const Rational& s : {Rational(1), Rational(3), Rational(7, 2)}) {
    EXPECT_TRUE(*facet_sum_at(box(1, 1, 1), cavity, s).set ==
                edge_sum(box(1, 1, 1), cavity, {s, s, s}).set)
        << "a cavity at " << s;
  }
}

TEST(PaperSpaceUpdate, TheWalkIsTheSameUpAndDownAndOnTwoThreads) {
  std::mt19937 dice(5);
  const Polyhedron P = random_tetrahedron(dice), Q = frame();
  const auto walk = PaperSpaceUpdate::make(P, Q, 1, "double", corrected_space_update_readings());
  BuildOptions on_two;
  on_two.threads = 2;
  const auto other =
      PaperSpaceUpdate::make(P, Q, 3, "double", corrected_space_update_readings(), on_two);
  EXPECT_EQ(walk->counts().events, other->counts().events);
  for (const Rational& s : {Rational(2, 3), Rational(5, 2), Rational(1, 7)}) {
    EXPECT_EQ(walk->move_to(s).updated, other->move_to(s).updated) << s;
    EXPECT_EQ(walk->place_intersections(), other->place_intersections()) << s;
    EXPECT_EQ(walk->sum().exposed.size(), other->sum().exposed.size()) << s;
  }
}

TEST(PaperSpaceUpdate, FacetsThatMeetHaveBoxesThatMeet) {
  using Pairs = PaperSpaceUpdate::Pairs;
  std::mt19937 dice(6);
  const Polyhedron P = random_tetrahedron(dice), Q = random_tetrahedron(dice);
  const auto walk = corrected(P, Q, 1);
  for (const Rational& s : {Rational(1), Rational(5, 2)}) {
    const std::size_t near = walk->search_intersections(s, Pairs::near);
    EXPECT_EQ(walk->search_intersections(s, Pairs::all), near) << s;
    EXPECT_GT(near, 0U);
  }
}

TEST(PaperSpaceUpdate, ReportsEachFacetAndEndsWhereTheReportThrows) {
  std::mt19937 dice(7);
  const Polyhedron P = random_tetrahedron(dice), Q = frame();
  BuildOptions options;
  std::uint64_t reports = 0, done = 0, total = 0;
  options.progress = [&](const BuildProgress& now) {
    EXPECT_LE(now.done, now.total);
    ++reports;
    done = now.done;
    total = now.total;
  };
  const auto walk =
      PaperSpaceUpdate::make(P, Q, 1, "double", corrected_space_update_readings(), options);
  EXPECT_EQ(total, walk->counts().facets);
  EXPECT_EQ(done, total);
  for (const bool of_sum : {false, true}) {
    reports = 0;
    of_sum ? walk->sum(options) : facet_sum_at(P, Q, 1, options);
    EXPECT_GE(reports, 2U);
    EXPECT_EQ(done, total);
  }
  options.progress = [](const BuildProgress&) { throw LimitExceeded("memory-limit", "", ""); };
  EXPECT_THROW(walk->sum(options), LimitExceeded);
  EXPECT_THROW(facet_sum_at(P, Q, 1, options), LimitExceeded);
}

TEST(PaperSpaceUpdate, RefusesWhatHasNoVolume) {
  const Polyhedron flat{{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)}, {{0, 1, 2}}};
  for (const Polyhedron& bad : {flat, Polyhedron{{at(1, 2, 3)}, {}}}) {
    EXPECT_THROW(PaperSpaceUpdate::make(bad, box(1, 1, 1), 1, "double", {}), BadInput);
  }
  EXPECT_THROW(PaperSpaceUpdate::make(box(1, 1, 1), box(1, 1, 1), 0, "double", {}), BadInput);
  EXPECT_TRUE(PaperSpaceUpdate::make({}, box(1, 1, 1), 1, "rational", {})->sum().set->empty());
}

}  // namespace
}  // namespace minkref::of_paper_space_update
