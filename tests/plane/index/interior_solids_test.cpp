// Patch parts that convex pieces' pairs, or discs, show to be inside are exactly inside.
#include "reference/plane/index/interior_solids.hpp"

#include <gtest/gtest.h>

#include "reference/plane/index/patch_cells.hpp"
#include "reference/plane/moving/interior_test.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_interior_solids {
namespace {

double coordinate(Source& random) { return static_cast<double>(random.below(4000)) / 100 - 20; }

/// An edge, near the middle of a sum more often than not, and a part of its patch.
struct Drawn {
  RoundedEdge edge;
  PatchCell cell;

  explicit Drawn(Source& place) {
    edge = {coordinate(place) / 8, coordinate(place) / 8, coordinate(place),  coordinate(place),
            coordinate(place) / 4, coordinate(place) / 4, place.below(2) == 0};
    cell.low = 0.25 + static_cast<double>(place.below(64)) / 16;
    cell.high = cell.low * (1 + static_cast<double>(place.below(64)) / 128);
    cell.from = static_cast<double>(place.below(8)) / 8;
    cell.to = cell.from + 0.125;
  }

  /// Names the first sample point of the cell that lies outside; empty if all lie inside.
  std::string outside(const InteriorTest& exact) const {
    for (const double along : {0.0, 0.5, 1.0}) {
      for (const double up : {0.0, 0.25, 1.0}) {
        const Rational s = from_double(cell.low + up * (cell.high - cell.low));
        Rational t = from_double(cell.from + along * (cell.to - cell.from));
        if (edge.is_s) t *= s;
        const Point x{s * from_double(edge.px) + from_double(edge.qx) + t * from_double(edge.dx),
                      s * from_double(edge.py) + from_double(edge.qy) + t * from_double(edge.dy)};
        if (!exact.inside(x, s)) {
          return "not inside at " + to_string(s) + ": (" + to_string(x.x) + ", " + to_string(x.y) +
                 ")";
        }
      }
    }
    return "";
  }
};

TEST(InteriorSolids, WhatOneHoldsIsInside) {
  MINKREF_SEEDED(random, 931);
  std::uint64_t by_chosen = 0, by_some = 0;
  expect_law(random, 60, [&](const Case& c) -> std::string {
    InteriorSolids solids(c.P, c.Q);
    const InteriorTest exact(c.P, c.Q);
    Source place(c.P.vertices() + 31 * c.Q.vertices());
    std::vector<Drawn> drawn;
    for (int k = 0; k < 80; ++k) drawn.emplace_back(place);
    std::vector<SweptQuad> quads;
    for (const Drawn& d : drawn) quads.push_back(swept_quad(d.edge, d.cell));
    solids.choose(quads);
    std::uint32_t hint = 0;
    InteriorSolids::Pair pair;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      const bool chosen = solids.chosen_holds(quads[k], hint),
                 some = solids.some_pair_holds(quads[k], 1000, pair);
      by_chosen += chosen ? 1 : 0;
      by_some += some ? 1 : 0;
      if (chosen && !some) return "a chosen pair is none of all pairs";
      if (!some) continue;
      const std::string why = drawn[k].outside(exact);
      if (!why.empty()) return why;
    }
    return "";
  });
  EXPECT_GT(by_some, 100U);
  EXPECT_GE(by_some, by_chosen);
  EXPECT_GT(by_chosen, 50U);
}

TEST(InteriorSolids, NothingIsHeldOfPointsAndSegments) {
  const PolygonSet square = box(-5, -5, 5, 5);
  const SweptQuad middle{{}, {}, 1, 1};
  for (const PolygonSet& small : {point_set(0, 0), segment_set({0, 0}, {1, 0})}) {
    for (InteriorSolids solids : {InteriorSolids(square, small), InteriorSolids(small, square)}) {
      solids.choose({middle});
      std::uint32_t hint = 0;
      InteriorSolids::Pair pair;
      EXPECT_FALSE(solids.chosen_holds(middle, hint));
      EXPECT_FALSE(solids.some_pair_holds(middle, 1000, pair));
    }
  }
}

TEST(InteriorSolids, TheSidesOfTheSumAreNotInside) {
  // [-1, 1]^2 scaled, and [-2, 2]^2: at s the sum is [-2 - s, 2 + s]^2.
  const InteriorSolids solids(box(-1, -1, 1, 1), box(-2, -2, 2, 2));
  InteriorSolids::Pair pair;
  const auto holds = [&](double share) {
    const double low = 3 * share, high = 4 * share;
    return solids.some_pair_holds({{low, low, high, high}, {-1, 1, -1, 1}, 1, 2}, 1000, pair);
  };
  EXPECT_FALSE(holds(1));
  EXPECT_FALSE(holds(1 - 0x1p-50));
  EXPECT_TRUE(holds(1 - 0x1p-20));
}

TEST(InteriorTracks, OfDiscsThatMaySettleAPartOneThatDoesIsKept) {
  MINKREF_SEEDED(random, 932);
  std::uint64_t held = 0, parts = 0;
  expect_law(random, 40, [&](const Case& c) -> std::string {
    const InteriorTracks tracks(c.P, c.Q);
    const InteriorTest exact(c.P, c.Q);
    const InteriorTracks::Discs all = tracks.all_discs();
    Source place(c.P.vertices() + 17 * c.Q.vertices());
    for (int k = 0; k < 40; ++k) {
      const Drawn drawn(place);
      const auto by = [&](const PatchCell& cell, const InteriorTracks::Discs& discs,
                          InteriorTracks::Discs& hopeful) {
        return tracks.some_disc_holds(middle_of(drawn.edge, cell).first, cell.low, cell.high, discs,
                                      hopeful);
      };
      InteriorTracks::Discs hopeful, of_part;
      if (by(drawn.cell, all, hopeful)) {
        ++held;
        const std::string why = drawn.outside(exact);
        if (!why.empty()) return why;
        continue;
      }
      PatchCell part = drawn.cell;
      part.to = (part.from + part.to) / 2;
      part.high = cut_between(part.low, part.high);
      const bool is_held = by(part, all, of_part);
      parts += is_held ? 1 : 0;
      if (is_held != by(part, hopeful, of_part)) return "a part of it lost its disc";
    }
    return "";
  });
  EXPECT_GT(held, 50U);
  EXPECT_GT(parts, 5U);
}

}  // namespace
}  // namespace minkref::testing::of_interior_solids
