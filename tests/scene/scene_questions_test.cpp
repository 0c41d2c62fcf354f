// Places, ways and room to grow in a scene: against the placed sums' interiors, copy by copy.
#include "reference/scene/scene_questions.hpp"

#include <gtest/gtest.h>

#include "reference/plane/witness.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_scene_questions {
namespace {

Scene random_scene(Source& random, const Case& c) {
  Scene scene{c.Q, {c.P, region(rectangle(-1, -1, 1, 1))}, {}};
  const std::size_t copies = 1 + random.below(5);
  for (std::size_t k = 0; k < copies; ++k) {
    scene.copies.push_back({static_cast<std::uint32_t>(random.below(2)),
                            Rational(random.between(1, 6), random.between(1, 3)),
                            {random.between(-9, 9), random.between(-9, 9)}});
  }
  return scene;
}

PolygonSet turned(PolygonSet set) {
  for (Polygon& polygon : set.polygons) {
    for (Point& p : polygon.outer) p = {-p.x, -p.y};
    for (Ring& hole : polygon.holes) {
      for (Point& p : hole) p = {-p.x, -p.y};
    }
  }
  return set;
}

Contact contact(const Scene& scene, std::size_t k, const Rational& factor, const Point& x) {
  const Copy& c = scene.copies[k];
  return decide(scene.shapes[c.shape], turned(scene.robot), Rational(c.scale * factor),
                {x.x - c.place.x, x.y - c.place.y})
      .contact;
}

bool collides(const Scene& scene, const Rational& factor, const Point& x, ContactRule rule) {
  for (std::size_t k = 0; k < scene.copies.size(); ++k) {
    const Contact found = contact(scene, k, factor, x);
    if (found == Contact::overlapping) return true;
    if (found == Contact::touching && rule == ContactRule::forbidden) return true;
  }
  return false;
}

/// Holders and freedom of a place, and its growth at factors on both sides of the bound.
std::string wrong_at(const Scene& scene, const SceneQuestions& questions, const Point& x,
                     std::size_t& bounded) {
  std::vector<Holder> expected;
  for (std::uint32_t k = 0; k < scene.copies.size(); ++k) {
    const Contact found = contact(scene, k, 1, x);
    if (found != Contact::empty) expected.push_back({k, found});
  }
  if (questions.holders(x) != expected) return "holders at " + text(x);
  for (const ContactRule rule : {ContactRule::allowed, ContactRule::forbidden}) {
    const bool is_free = !collides(scene, 1, x, rule);
    if (questions.way({x}, rule).free != is_free) return "a place at " + text(x);
    const auto growth = questions.growth({x}, rule);
    if (growth.has_value() != is_free) return "growth of a place that is not free";
    if (!growth) continue;
    const Rational top = growth->factor.value_or(50);
    if (top < 1) return "a factor below 1";
    for (int k = 0; k < 8; ++k) {
      const Rational below = 1 + (top - 1) * Rational(k, 8);
      if ((growth->included || below < top) && collides(scene, below, x, rule))
        return "stopped at " + to_string(below) + ", below " + to_string(top);
    }
    if (!growth->factor) continue;
    ++bounded;
    if (collides(scene, top, x, rule) == growth->included) return "the bound itself";
    const Rational beyond = top + Rational(1, 1000000000);
    if (!collides(scene, beyond, x, rule)) return "free beyond " + to_string(top);
    if (growth->at.point != x) return "the place of the contact";
    if (contact(scene, growth->copy, top, x) != Contact::touching) return "no contact of the copy";
  }
  return "";
}

TEST(SceneQuestions, PlacesAreAsTheDefinitionSays) {
  MINKREF_SEEDED(random, 5101);
  std::size_t bounded = 0;
  expect_law(random, 40, [&](const Case& c) -> std::string {
    const Scene scene = random_scene(random, c);
    const SceneQuestions questions(scene);
    for (int k = 0; k < 6; ++k) {
      const Point x{Rational(random.between(-40, 40), 2), Rational(random.between(-40, 40), 2)};
      const std::string wrong = wrong_at(scene, questions, x, bounded);
      if (!wrong.empty()) return wrong;
    }
    return "";
  });
  EXPECT_GT(bounded, 20U);
}

TEST(SceneQuestions, AWayIsFreeIffItsPlacesAre) {
  MINKREF_SEEDED(random, 5102);
  std::size_t stopped = 0;
  expect_law(random, 100, [&](const Case& c) -> std::string {
    const Scene scene = random_scene(random, c);
    const SceneQuestions questions(scene);
    const Point a{random.between(-6, 6), random.between(-6, 6)};
    const Point b{random.between(-6, 6), random.between(-6, 6)};
    for (const ContactRule rule : {ContactRule::allowed, ContactRule::forbidden}) {
      const auto answer = questions.way({a, b}, rule);
      if (answer.free != answer.stopped_by.empty()) return "stopped by nobody";
      stopped += !answer.free;
      for (int k = 0; answer.free && k <= 30; ++k) {
        const Point x{a.x + (b.x - a.x) * Rational(k, 30), a.y + (b.y - a.y) * Rational(k, 30)};
        if (collides(scene, 1, x, rule)) return "not free at " + text(x);
      }
    }
    return "";
  });
  EXPECT_GT(stopped, 20U);
}

Scene two_boxes(const PolygonSet& robot) {
  return {robot, {region(rectangle(0, 0, 1, 1))}, {{0, 1, {0, 0}}, {0, 1, {1, 0}}}};
}

TEST(SceneQuestions, ASeamStopsAPoint) {
  const SceneQuestions questions(two_boxes({{{{{0, 0}}, {}}}}));
  const std::vector<Point> seam{{1, 2}, {1, -1}};
  const auto answer = questions.way(seam, ContactRule::allowed);
  EXPECT_FALSE(answer.free);
  EXPECT_TRUE(answer.stopped_by.empty());
  EXPECT_TRUE(questions.way({{0, 2}, {0, -1}}, ContactRule::allowed).free);
}

TEST(SceneQuestions, GrowthEndsWhereACornerComes) {
  const SceneQuestions questions(two_boxes(region(rectangle(0, 0, 1, 1))));
  const auto growth = questions.growth({{4, 0}}, ContactRule::allowed);
  ASSERT_TRUE(growth && growth->factor);
  EXPECT_EQ(*growth->factor, 3);
  EXPECT_TRUE(growth->included);
  EXPECT_EQ(growth->copy, 1U);
  EXPECT_EQ(growth->touching.x, 4);
  const auto none = questions.growth({{-4, 0}}, ContactRule::allowed);
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->factor);
  EXPECT_FALSE(questions.growth({{0, 0}}, ContactRule::allowed));
}

}  // namespace
}  // namespace minkref::testing::of_scene_questions
