// Copies growing about thin robots until seams close: by hand, and against grown copies' union.
#include "reference/scene/seam_growth.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/scene/scene_questions.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::testing::of_seam_growth {
namespace {

Scene grown(Scene scene, const Rational& factor) {
  for (Copy& copy : scene.copies) copy.scale *= factor;
  return scene;
}

/// By the copies' union, which knows nothing about growth.
bool is_free(const Scene& scene, const Rational& factor, const std::vector<Point>& way) {
  return SceneQuestions(grown(scene, factor)).way(way, ContactRule::allowed).free;
}

PolygonSet shape(Source& random) {
  const int x = random.between(-2, 0), y = random.between(-2, 0);
  const int w = random.between(1, 2), h = random.between(1, 2);
  switch (random.below(4)) {
    case 0:
      return region({{x, y}, {x + w, y}, {x, y + w}});
    case 1:
      return region({{x + w, y + w}, {x, y + w}, {x + w, y}});
    default:
      return region({{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}});
  }
}

/// A mirrored shape; `upright`: in the y-axis, else in the x-axis.
PolygonSet mirrored(PolygonSet set, bool upright) {
  for (Polygon& polygon : set.polygons) {
    for (Point& p : polygon.outer) p = upright ? Point{-p.x, p.y} : Point{p.x, -p.y};
    std::reverse(polygon.outer.begin(), polygon.outer.end());
  }
  return set;
}

struct Asked {
  Scene scene;
  std::vector<Point> way;
};

/// Draws lattice boxes, right triangles; robots are points or upright segments. `mirror`: copies
/// come in pairs or fours about ways along an axis, or about origins; some get lost.
Asked drawn(Source& random, bool mirror) {
  const Point a{0, 0}, b{0, 1};
  const bool is_point = random.coin();
  Asked asked{{is_point ? PolygonSet{{{{a}, {}}}} : PolygonSet{{{{a, b}, {}}}}, {}, {}}, {}};
  const auto add = [&](const PolygonSet& set, const Rational& scale, const Point& place) {
    if (mirror && random.below(8) == 0) return;
    asked.scene.copies.push_back(
        {static_cast<std::uint32_t>(asked.scene.shapes.size()), scale, place});
    asked.scene.shapes.push_back(set);
  };
  const std::size_t kind = random.below(3);
  for (int k = mirror ? random.between(1, 3) : random.between(3, 7); k > 0; --k) {
    const PolygonSet set = shape(random);
    const Rational scale(1, random.between(1, 2));
    const Point at{random.between(-4, 4), random.between(-4, 4)};
    add(set, scale, at);
    if (!mirror) continue;
    add(mirrored(set, true), scale, {-at.x, at.y});
    if (kind != 0) continue;
    add(mirrored(set, false), scale, {at.x, -at.y});
    add(mirrored(mirrored(set, false), true), scale, {-at.x, -at.y});
  }
  const Point first{mirror ? 0 : random.between(-2, 2),
                    kind == 0 && mirror ? 0 : random.between(-2, 2)};
  asked.way = {first};
  if (kind != 0) asked.way.push_back({first.x, first.y + random.between(1, 4)});
  if (kind == 2) asked.way.push_back({first.x + random.between(-1, 1), first.y + 5});
  return asked;
}

std::string wrong_growth(const Scene& scene, const std::vector<Point>& way, const Growth& growth) {
  const Rational top = growth.factor.value_or(7);
  for (int q = 1; q <= 4; ++q) {
    for (int p = q; p <= 5 * q && Rational(p, q) < top; ++p) {
      if (!is_free(scene, Rational(p, q), way)) return "not free at " + to_string(Rational(p, q));
    }
  }
  if (!growth.factor) return "";
  if (top > 1 && !is_free(scene, (1 + 999 * top) / 1000, way)) return "not free just below";
  if (is_free(scene, top, way) != growth.included) return "the bound itself";
  if (growth.included && is_free(scene, top * Rational(1000001, 1000000), way))
    return "free just above";
  return "";
}

TEST(SeamGrowth, AWayIsFreeOfTheUnionUpToTheFactorAndNoFurther) {
  MINKREF_SEEDED(random, 5211);
  std::size_t bounded = 0, seams = 0, above = 0;
  const std::size_t count = repetitions(300);
  for (std::size_t n = 0; n < count; ++n) {
    const auto [scene, way] = drawn(random, n % 2 == 0);
    const auto growth = SceneQuestions(scene).growth(way, ContactRule::allowed);
    if (!growth) continue;
    ++bounded;
    seams += !growth->seam.empty();
    above += !growth->seam.empty() && growth->included;
    ASSERT_EQ(wrong_growth(scene, way, *growth), "") << n;
  }
  std::printf("%zu free ways, %zu ended by seams, %zu of them just above\n", bounded, seams, above);
  EXPECT_GT(seams, bounded / 20);
}

PolygonSet origin() { return {{{{{0, 0}}, {}}}}; }

TEST(SeamGrowth, TwoBoxesCloseASeamAcrossTheWay) {
  const Scene scene{origin(),
                    {region({{0, -1}, {1, -1}, {1, 1}, {0, 1}})},
                    {{0, 1, {0, 0}}, {0, 1, {1, 3}}, {0, Rational(1, 2), {-4, 0}}}};
  // Neither box is to the left of its place; a third one ends at x = -4 + f / 2.
  const auto growth = SceneQuestions(scene).growth({{0, 0}, {0, 0}}, ContactRule::allowed);
  ASSERT_TRUE(growth && growth->factor);
  EXPECT_EQ(*growth->factor, 8);
  EXPECT_FALSE(growth->included);
  EXPECT_EQ(growth->seam, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(growth->touching, (Point{0, 0}));
}

TEST(SeamGrowth, ASeamAlongTheWayClosesJustAbove) {
  const PolygonSet left = region({{-1, 0}, {0, 0}, {0, 1}, {-1, 1}});
  const PolygonSet right = region({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Scene scene{origin(), {left, right}, {{0, 1, {0, 0}}, {1, 1, {0, 0}}}};
  const auto growth = SceneQuestions(scene).growth({{0, 3}, {0, 5}}, ContactRule::allowed);
  ASSERT_TRUE(growth && growth->factor);
  EXPECT_EQ(*growth->factor, 3);
  EXPECT_TRUE(growth->included);
  EXPECT_EQ(growth->seam, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(growth->at.point.x, 0);
}

TEST(SeamGrowth, FourCornersCloseAPlace) {
  const PolygonSet box = region({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  Scene scene{origin(), {box}, {}};
  for (const int x : {-2, 2})
    for (const int y : {-2, 2}) scene.copies.push_back({0, 1, {x, y}});
  const auto growth = SceneQuestions(scene).growth({{0, 0}}, ContactRule::allowed);
  ASSERT_TRUE(growth && growth->factor);
  EXPECT_EQ(*growth->factor, 2);
  EXPECT_FALSE(growth->included);
  EXPECT_EQ(growth->seam, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  scene.copies.pop_back();
  const auto three = SceneQuestions(scene).growth({{0, 0}}, ContactRule::allowed);
  EXPECT_TRUE(three->included && three->seam.empty());
}

}  // namespace
}  // namespace minkref::testing::of_seam_growth
