// Work in space grows nearly as its input where the answer does: turns of loops are counted, no
// time. Fans of slivers have boxes that all overlap.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/space/polyhedral_set.hpp"
#include "reference/space/surface/mesh_of.hpp"
#include "reference/space/surface/near_things.hpp"
#include "reference/space/surface/surface_edges.hpp"
#include "tests/space/surfaces.hpp"

namespace minkref::of_growth_in_space {
namespace {

using surfaces::at;

/// Two cones over a star with many spikes of different lengths.
Polyhedron double_cone(int corners) {
  Polyhedron result;
  const auto count = static_cast<std::uint32_t>(corners);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * 3.14159265358979 * k / corners;
    const double radius = k % 2 == 0 ? 1e6 : 3e6 + 1e5 * ((7 * k) % 31);
    result.vertices.push_back(
        at(std::lround(radius * std::cos(angle)), std::lround(radius * std::sin(angle)), 0));
  }
  result.vertices.push_back(at(0, 0, 4000000));
  result.vertices.push_back(at(0, 0, -4000000));
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t next = (k + 1) % count;
    result.faces.push_back({k, next, count});
    result.faces.push_back({next, k, count + 1});
  }
  return result;
}

double turns(const std::function<void()>& work) {
  std::uint64_t looks = 0;
  const Interruptible counting([&] { ++looks; });
  work();
  return static_cast<double>(looks);
}

/// Four times the input.
void expect_growth(const std::function<void(const Polyhedron&)>& work, double exponent) {
  const Polyhedron small = double_cone(250), large = double_cone(1000);
  const double before = turns([&] { work(small); }), after = turns([&] { work(large); });
  EXPECT_GT(before, 20);
  EXPECT_LT(after, std::pow(4, exponent) * before) << before << " turns of 64 before";
}

TEST(GrowthInSpace, ValidationOfFansAsksFewPairs) {
  expect_growth([](const Polyhedron& fan) { validate(fan); }, 1.5);
}

TEST(GrowthInSpace, TheSurfaceOfFansAsksFewPairs) {
  expect_growth([](const Polyhedron& fan) { (void)surface_edges(polyhedral_set(fan)); }, 1.5);
}

TEST(GrowthInSpace, AFanKeepsItsFaces) {
  const Polyhedron fan = double_cone(250);
  const Polyhedron mesh = mesh_of(surface_edges(polyhedral_set(fan)));
  EXPECT_EQ(mesh.vertices.size(), fan.vertices.size());
  EXPECT_EQ(mesh.faces.size(), fan.faces.size());
}

/// A fan of segments, and two polygons across: one that is not convex and one with many corners.
TEST(NearThings, OfAFanAreThoseThatMeetInMoreThanACorner) {
  constexpr std::uint32_t spokes = 400, sides = 40;
  std::vector<SpaceVertex> points{SpaceVertex(at(0, 0, 0))};
  const auto add = [&](long x, long y, long z) {
    points.emplace_back(at(static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)));
    return static_cast<std::uint32_t>(points.size() - 1);
  };
  const auto round = [](double radius, double angle) {
    return std::pair(std::lround(radius * std::cos(angle)), std::lround(radius * std::sin(angle)));
  };
  constexpr double turn = 2 * 3.14159265358979;
  std::vector<std::vector<std::uint32_t>> things;
  for (std::uint32_t k = 0; k < spokes; ++k) {
    const auto [x, y] = round(1e6, turn * k / spokes);
    things.push_back({0, add(x, y, 1000)});
  }
  // A U that the spoke along the x axis pierces in its right arm, at the height 500.
  const std::vector<std::pair<int, int>> corners{{-20, 0},  {520, 0}, {520, 900}, {480, 900},
                                                 {480, 20}, {20, 20}, {20, 900},  {-20, 900}};
  things.emplace_back();
  for (const auto& [y, z] : corners) things.back().push_back(add(500000, 1000 * (y - 500), z));
  things.emplace_back();
  for (std::uint32_t k = 0; k < sides; ++k) {
    const auto [y, z] = round(90, turn * k / sides);
    things.back().push_back(add(-500000, 100 * y, 500 + z));
  }
  NearThings near(points);
  for (const auto& thing : things) near.add(thing);
  for (const std::uint32_t first : {0U, spokes}) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    near.pairs([&](std::uint32_t i, std::uint32_t j) { found.insert({i, j}); }, first);
    EXPECT_TRUE(found.contains({0, spokes})) << first;
    EXPECT_TRUE(found.contains({spokes / 2, spokes + 1})) << first;
    EXPECT_FALSE(found.contains({spokes / 4, spokes})) << first;
    EXPECT_LT(found.size(), spokes * spokes / 4) << first;
  }
}

}  // namespace
}  // namespace minkref::of_growth_in_space
