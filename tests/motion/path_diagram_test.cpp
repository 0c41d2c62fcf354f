// The bad polygons of a path contain exactly the colliding places and scales.
#include "reference/motion/path_diagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/error.hpp"
#include "reference/motion/routes.hpp"
#include "tests/motion/random_paths.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::testing::of_path_diagram {
namespace {

constexpr std::size_t many = 100000;
const ScaleWindow window{Rational(1, 3), Rational(5)};

/// For 0 < t < 1, or a point of the path, and s inside of the window.
bool holds(const BadPolygon& polygon, const Rational& t, const Rational& s, bool strict) {
  const auto& corners = polygon.corners;
  if (corners.size() == 1) return !strict && corners[0] == StripPoint{t, s};
  bool inside = true;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const StripPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const Rational side = (b.t - a.t) * (s - a.s) - (b.s - a.s) * (t - a.t);
    inside = inside && (strict && corners.size() > 2 ? side > 0 : side >= 0);
  }
  if (corners.size() > 2) return inside;
  const auto [least, greatest] = std::minmax(corners[0].s, corners[1].s);
  const auto [left, right] = std::minmax(corners[0].t, corners[1].t);
  if (strict) return s > least && s < greatest;
  return inside && s >= least && s <= greatest && t >= left && t <= right;
}

std::string polygons_hold_what_collides(const Case& c, const std::vector<Point>& path,
                                        Source& random) {
  if (!c.P.is_region() && !c.Q.is_region()) return "";
  const PolygonSet turned = reflected_set(c.P);
  for (const ContactRule rule : {ContactRule::allowed, ContactRule::forbidden}) {
    const bool strict = rule == ContactRule::allowed;
    const PathDiagram diagram = path_diagram(c.P, c.Q, path, rule, window, many);
    for (int k = 0; k < 16; ++k) {
      const std::size_t segment = random.below(std::max<std::size_t>(path.size() - 1, 1));
      const Point& a = path[segment];
      const Point& b = path[std::min(segment + 1, path.size() - 1)];
      Rational t(random.between(1, 7), 8);
      Rational s = Rational(1, 3) + Rational(14, 3) * Rational(random.between(1, 11), 12);
      if (!diagram.polygons.empty() && random.below(2) == 0) {  // a corner, or near one
        const BadPolygon& one = diagram.polygons[random.below(diagram.polygons.size())];
        if (one.segment == segment) {
          t = one.corners[0].t;
          s = one.corners[0].s;
        }
      }
      if (a == b) t = 0;
      if ((a != b && (t == 0 || t == 1)) || s == *window.from || s == *window.to) continue;
      const Membership member(turned, c.Q, s);
      const Contact contact = member.contact({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      const bool collides =
          contact == Contact::overlapping || (!strict && contact == Contact::touching);
      const bool held = std::any_of(
          diagram.polygons.begin(), diagram.polygons.end(), [&](const BadPolygon& polygon) {
            return polygon.segment == segment && holds(polygon, t, s, strict);
          });
      if (held != collides) {
        return std::string(strict ? "allowed" : "forbidden") + ", segment " +
               std::to_string(segment) + ", t = " + to_string(t) + ", s = " + to_string(s) +
               (held ? " is held, and free" : " collides, and is not held");
      }
    }
  }
  return "";
}

void on_random_paths(std::function<Case(Source&)> make, Source& random, int count) {
  for (int i = 0; i < repetitions(count); ++i) {
    const Case c = make(random);
    const std::vector<Point> path = random_path(random, c.P, c.Q);
    const std::string fault = polygons_hold_what_collides(c, path, random);
    ASSERT_EQ(fault, "") << "repetition " << i << "\n" << text(c) << "\npath " << text(path);
  }
}

TEST(PathDiagram, HoldsWhatCollidesOfRandomSets) {
  MINKREF_SEEDED(random, 3121);
  on_random_paths(random_case, random, 25);
}

TEST(PathDiagram, HoldsWhatCollidesOfPiecesOfLattices) {
  MINKREF_SEEDED(random, 3122);
  on_random_paths(lattice_pieces(2, 4), random, 40);
}

TEST(PathDiagram, HoldsWhatCollidesOfPointsAndSegments) {
  MINKREF_SEEDED(random, 3123);
  on_random_paths(thin_and_wide(4, 2), random, 40);
}

PolygonSet box(int x, int y, int width, int height) {
  return {{{{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, {}}}};
}

/// [2s, 3s] x [0, s] at x = 10 t meets [20, 24]: 10 t + 2s < 24 and 10 t + 3s > 20.
TEST(PathDiagram, OfTwoBoxesIsAPolygonWithKnownCorners) {
  const PathDiagram diagram = path_diagram(box(2, 0, 1, 1), box(20, 0, 4, 1), {{0, 0}, {10, 0}},
                                           ContactRule::allowed, {std::nullopt, Rational(8)}, many);
  ASSERT_EQ(diagram.polygons.size(), 1U);
  EXPECT_EQ(diagram.part_pieces.size(), 1U);
  std::vector<StripPoint> corners = diagram.polygons[0].corners;
  std::sort(corners.begin(), corners.end(), [](const StripPoint& a, const StripPoint& b) {
    return a.t != b.t ? a.t < b.t : a.s < b.s;
  });
  const std::vector<StripPoint> expected{
      {0, Rational(20, 3)}, {0, 8}, {Rational(4, 5), 8}, {1, Rational(10, 3)}, {1, 7}};
  EXPECT_EQ(corners, expected);
}

TEST(PathDiagram, RefusesAnEndlessWindowAndTooManyPolygons) {
  const PolygonSet part = box(2, 0, 1, 1), wall = box(20, 0, 4, 1);
  const std::vector<Point> path{{0, 0}, {10, 0}};
  const auto diagram = [&](const ScaleWindow& scales, std::size_t most) {
    return path_diagram(part, wall, path, ContactRule::allowed, scales, most);
  };
  EXPECT_THROW(diagram({}, many), BadInput);
  EXPECT_THROW(diagram({Rational(2), Rational(2)}, many), BadInput);
  EXPECT_THROW(diagram({std::nullopt, Rational(8)}, 0), LimitExceeded);
  EXPECT_THROW(
      path_diagram(part, wall, {}, ContactRule::allowed, {std::nullopt, Rational(8)}, many),
      BadInput);
}

}  // namespace
}  // namespace minkref::testing::of_path_diagram
