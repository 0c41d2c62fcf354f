// Three routes to the valid scales of a path agree, and single scales are as static sums say.
#include "reference/motion/valid_scales.hpp"

#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/motion/path_cuts.hpp"
#include "reference/motion/routes.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "tests/motion/random_paths.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::testing::of_valid_scales {
namespace {

constexpr std::array rules{ContactRule::allowed, ContactRule::forbidden};
constexpr std::array other_routes{PathRoute::contacts, PathRoute::index};

/// Makes a case into a path problem: P is the part, Q the obstacles.
auto with_paths(std::function<Case(Source&)> make, Source& random,
                std::function<std::string(const Case&, const std::vector<Point>&)> law) {
  return [=, &random](int count) {
    for (int i = 0; i < repetitions(count); ++i) {
      const Case c = make(random);
      const std::vector<Point> path = random_path(random, c.P, c.Q);
      const std::string fault = law(c, path);
      if (!fault.empty()) {
        ADD_FAILURE() << "repetition " << i << ": " << fault << "\n"
                      << text(c) << "\n"
                      << "path " << text(path);
        return;
      }
    }
  };
}

std::string routes_agree(const Case& c, const std::vector<Point>& path) {
  if (!c.P.is_region() && !c.Q.is_region()) return "";
  for (const ContactRule rule : rules) {
    const ValidScales expected = valid_scales(c.P, c.Q, path, rule);
    for (const PathRoute route : other_routes) {
      const ValidScales found = valid_scales(c.P, c.Q, path, rule, {}, route);
      if (found.valid != expected.valid) {
        return std::string(rule == ContactRule::allowed ? "allowed" : "forbidden") +
               ", pieces: " + text(expected.valid) + ", route " +
               (route == PathRoute::contacts ? "contacts: " : "index: ") + text(found.valid);
      }
    }
  }
  return "";
}

TEST(ValidScales, OfThreeRoutesAgreeOnRandomSets) {
  MINKREF_SEEDED(random, 3101);
  with_paths(random_case, random, routes_agree)(25);
}

TEST(ValidScales, OfThreeRoutesAgreeOnPiecesOfLattices) {
  MINKREF_SEEDED(random, 3102);
  with_paths(lattice_pieces(2, 4), random, routes_agree)(40);
}

TEST(ValidScales, OfThreeRoutesAgreeOnPointsAndSegments) {
  MINKREF_SEEDED(random, 3103);
  with_paths(thin_and_wide(4, 2), random, routes_agree)(40);
}

/// Whether a place of the path collides, by the static sum at this scale alone: its boundary and
/// tight passages cut the path, and single points are decided from the definition.
bool is_valid_by_static_sum(const PolygonSet& part, const PolygonSet& obstacles,
                            const std::vector<Point>& path, ContactRule rule,
                            const Rational& scale) {
  const PolygonSet turned = reflected_set(part);
  std::vector<Segment> segments;
  for (const ConvolutionEdge& edge : full_convolution(turned, obstacles)) {
    segments.push_back(at_scale(edge, turned, obstacles, scale));
  }
  const Sum sum =
      minkowski_sum(turned, obstacles, scale, Route::definition, "rational", Passages::find);
  for (const TightPassage& passage : *sum.tight_passages) {
    for (std::size_t i = 0; i < passage.points.size(); ++i) {
      segments.push_back(
          {passage.points[i], passage.points[std::min(i + 1, passage.points.size() - 1)]});
    }
  }
  for (const Polygon& polygon : sum.region.polygons) {
    const auto add = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        segments.push_back({ring[i], ring[(i + 1) % ring.size()]});
      }
    };
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  const Membership member(turned, obstacles, scale);
  PathCuts points = path_cuts(path, segments);
  points.cuts.insert(points.cuts.end(), points.between.begin(), points.between.end());
  for (const Point& p : points.cuts) {
    const Contact contact = member.contact(p);
    if (contact == Contact::overlapping) return false;
    if (contact == Contact::touching && rule == ContactRule::forbidden) return false;
  }
  return true;
}

bool holds(const std::vector<ScaleRange>& ranges, const Rational& scale) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const ScaleRange& range) { return range.holds(scale); });
}

/// At each bound, just below and just above it, and inside each range and between two.
std::string scales_are_as_static_sums_say(const Case& c, const std::vector<Point>& path) {
  if (!c.P.is_region() && !c.Q.is_region()) return "";
  for (const ContactRule rule : rules) {
    const ValidScales found = valid_scales(c.P, c.Q, path, rule);
    std::vector<Rational> scales{Rational(1, 100), c.scale, 100};
    const Rational hair(1, 1000003);
    for (const PathBound& bound : found.bounds) {
      scales.insert(scales.end(),
                    {bound.scale, bound.scale * (1 - hair), bound.scale * (1 + hair)});
    }
    for (const ScaleRange& range : found.valid) scales.push_back(range.sample());
    for (const Rational& scale : scales) {
      const bool expected = is_valid_by_static_sum(c.P, c.Q, path, rule, scale);
      if (holds(found.valid, scale) != expected) {
        return "at scale " + to_string(scale) + ": static sums say " +
               (expected ? "valid" : "not valid") + ", the path " + text(found.valid);
      }
    }
  }
  return "";
}

TEST(ValidScales, AreAsStaticSumsSayAtAndBesideEachBound) {
  MINKREF_SEEDED(random, 3104);
  with_paths(random_case, random, scales_are_as_static_sums_say)(20);
  with_paths(lattice_pieces(2, 4), random, scales_are_as_static_sums_say)(30);
  with_paths(thin_and_wide(4, 2), random, scales_are_as_static_sums_say)(30);
}

/// Each bound names features that touch at its place: both contain the point.
std::string bounds_touch(const Case& c, const std::vector<Point>& path) {
  if (!c.P.is_region() && !c.Q.is_region()) return "";
  const auto on = [](const PolygonSet& set, const TouchingFeature& f, const Point& p) {
    std::vector<Ring> rings;
    for (const Polygon& polygon : set.polygons) {
      rings.push_back(polygon.outer);
      rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
    }
    const Ring& ring = rings.at(f.id.ring);
    const Point &a = ring.at(f.id.index), &b = ring[(f.id.index + 1) % ring.size()];
    if (!f.is_edge) return a == p;
    return (b.x - a.x) * (p.y - a.y) == (b.y - a.y) * (p.x - a.x) &&
           (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) <= 0;
  };
  for (const ContactRule rule : rules) {
    for (const PathBound& bound : valid_scales(c.P, c.Q, path, rule).bounds) {
      const Point x = bound.at.point;
      const Point on_part{(bound.touching.x - x.x) / bound.scale,
                          (bound.touching.y - x.y) / bound.scale};
      if (!on(c.P, bound.part, on_part)) return "the part does not touch there";
      if (!on(c.Q, bound.obstacle, bound.touching)) return "the obstacle does not touch there";
      const Contact contact = Membership(reflected_set(c.P), c.Q, bound.scale).contact(x);
      if (contact != Contact::touching) return "they do not only touch";
    }
  }
  return "";
}

TEST(ValidScales, HaveBoundsAtContacts) {
  MINKREF_SEEDED(random, 3105);
  with_paths(random_case, random, bounds_touch)(60);
  with_paths(lattice_pieces(2, 4), random, bounds_touch)(60);
  with_paths(thin_and_wide(4, 2), random, bounds_touch)(60);
}

PolygonSet box(const Rational& x0, const Rational& y0, const Rational& x1, const Rational& y1) {
  return {{{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}}};
}
PolygonSet both(PolygonSet a, const PolygonSet& b) {
  a.polygons.insert(a.polygons.end(), b.polygons.begin(), b.polygons.end());
  return a;
}

void expect_valid(const PolygonSet& part, const PolygonSet& obstacles,
                  const std::vector<Point>& path, ContactRule rule, const std::string& expected,
                  const ScaleWindow& window = {}) {
  for (const PathRoute route : {PathRoute::pieces, PathRoute::contacts, PathRoute::index}) {
    EXPECT_EQ(text(valid_scales(part, obstacles, path, rule, window, route).valid), expected);
  }
}

/// The part is away from its origin: s <= 5/3, as 3 s <= 5, and s >= 3, as 2 s >= 6.
TEST(ValidScales, AreSeveralIntervalsOfAPartThatIsNotStarShaped) {
  const PolygonSet part = box(2, Rational(-1, 2), 3, Rational(1, 2)), wall = box(5, -1, 6, 1);
  EXPECT_FALSE(star_shaped(part));
  expect_valid(part, wall, {{0, 0}}, ContactRule::allowed, "(0, 5/3] [3, inf) ");
  expect_valid(part, wall, {{0, 0}}, ContactRule::forbidden, "(0, 5/3) (3, inf) ");
  expect_valid(part, wall, {{0, 0}}, ContactRule::allowed, "[1, 5/3] [3, 3] ", {1, 3});
  const ValidScales found = valid_scales(part, wall, {{0, 0}});
  ASSERT_EQ(found.bounds.size(), 2U);
  EXPECT_TRUE(found.bounds[0].blocks);
  EXPECT_FALSE(found.bounds[1].blocks);
}

/// Bad scales: (1/3, 2), where [2 s, 3 s] meets (1, 4), and (2, 9/2), where [2 s, 3 s] meets (6,
/// 9).
TEST(ValidScales, MayBeASingleScale) {
  const PolygonSet part = box(2, 0, 3, 1);
  const PolygonSet walls = both(box(1, 0, 4, 1), box(6, 0, 9, 1));
  expect_valid(part, walls, {{0, 0}}, ContactRule::allowed, "(0, 1/3] [2, 2] [9/2, inf) ");
  expect_valid(part, walls, {{0, 0}}, ContactRule::forbidden, "(0, 1/3) (9/2, inf) ");
  const ValidScales found = valid_scales(part, walls, {{0, 0}});
  ASSERT_EQ(found.bounds.size(), 4U);
  EXPECT_EQ(found.bounds[1].scale, 2);
  EXPECT_FALSE(found.bounds[1].blocks);
  EXPECT_EQ(found.bounds[2].scale, 2);
  EXPECT_TRUE(found.bounds[2].blocks);
}

TEST(ValidScales, OfASlideAlongAnEdgeAreThoseOfTheOtherSide) {
  const PolygonSet part = box(-1, 0, 1, 1), corridor = both(box(0, -1, 20, 0), box(0, 3, 20, 4));
  expect_valid(part, corridor, {{2, 0}, {18, 0}}, ContactRule::allowed, "(0, 3] ");
  expect_valid(part, corridor, {{2, 0}, {18, 0}}, ContactRule::forbidden, "none");
}

TEST(ValidScales, OfAPointPartAreThoseAtWhichItsTrackIsOutside) {
  const PolygonSet point{{{{{1, 0}}, {}}}};
  expect_valid(point, box(2, -1, 3, 1), {{0, 0}}, ContactRule::allowed, "(0, 2] [3, inf) ");
  // Along a seam of any triangulation, with the part at its origin.
  const PolygonSet origin{{{{{0, 0}}, {}}}};
  expect_valid(origin, box(0, 0, 2, 2), {{0, 0}, {2, 2}}, ContactRule::allowed, "none");
  expect_valid(origin, box(0, 0, 2, 2), {{2, 0}, {0, 2}}, ContactRule::allowed, "none");
}

TEST(ValidScales, AreAllWithoutAPartOrObstacles) {
  expect_valid({}, box(0, 0, 1, 1), {{0, 0}}, ContactRule::forbidden, "(0, inf) ");
  expect_valid(box(0, 0, 1, 1), {}, {{0, 0}}, ContactRule::allowed, "[1, 2] ", {1, 2});
}

TEST(ValidScales, RefuseWhatHasNoAnswer) {
  EXPECT_THROW(valid_scales(box(0, 0, 1, 1), box(0, 0, 1, 1), {}), BadInput);
  const PolygonSet point{{{{{1, 0}}, {}}}};
  EXPECT_THROW(valid_scales(point, point, {{0, 0}}), BadInput);
  EXPECT_THROW(valid_scales(box(0, 0, 1, 1), point, {{0, 0}}, ContactRule::allowed, {2, 1}),
               BadInput);
}

/// lambda R among lambda O along lambda path: the same scales. Translated together: the same too.
TEST(ValidScales, DoNotChangeWhereAllIsScaledOrMoved) {
  MINKREF_SEEDED(random, 3106);
  const auto law = [](const Case& c, const std::vector<Point>& path) -> std::string {
    const ValidScales expected = valid_scales(c.P, c.Q, path);
    const Rational factor(7, 3);
    std::vector<Point> larger, moved;
    for (const Point& p : path) {
      larger.push_back({p.x * factor, p.y * factor});
      moved.push_back({p.x + 5, p.y - factor});
    }
    if (valid_scales(scaled(c.P, factor), scaled(c.Q, factor), larger).valid != expected.valid) {
      return "scaled together, other scales are valid";
    }
    if (valid_scales(c.P, translated(c.Q, {5, -factor}), moved).valid != expected.valid) {
      return "moved together, other scales are valid";
    }
    std::vector<Point> back(path.rbegin(), path.rend());
    if (valid_scales(c.P, c.Q, back).valid != expected.valid)
      return "another answer on the way back";
    return "";
  };
  with_paths(random_case, random, law)(60);
}

/// Also where a window begins or ends at a bound.
TEST(ValidScales, OfAWindowAreThoseInIt) {
  MINKREF_SEEDED(random, 3108);
  const auto law = [](const Case& c, const std::vector<Point>& path) -> std::string {
    for (const ContactRule rule : rules) {
      const ValidScales all = valid_scales(c.P, c.Q, path, rule);
      ScaleWindow window{c.scale / 3, 2 * c.scale};
      if (!all.bounds.empty()) window = {all.bounds.front().scale, all.bounds.back().scale};
      for (const PathRoute route : {PathRoute::pieces, PathRoute::contacts, PathRoute::index}) {
        const auto found = valid_scales(c.P, c.Q, path, rule, window, route).valid;
        for (const Rational& s :
             {*window.from, *window.to, Rational((*window.from + *window.to) / 2)}) {
          if (holds(found, s) != holds(all.valid, s)) {
            return "at scale " + to_string(s) + ": " + text(found) + ", of all " + text(all.valid);
          }
        }
        if (!found.empty() && (found.front().from.scale < *window.from || !found.back().to ||
                               *window.to < found.back().to->scale)) {
          return "beyond the window: " + text(found);
        }
      }
    }
    return "";
  };
  with_paths(lattice_pieces(2, 3), random, law)(25);
}

TEST(StarShaped, PartsHaveOneIntervalFromZero) {
  MINKREF_SEEDED(random, 3107);
  const auto law = [](const Case& c, const std::vector<Point>& path) -> std::string {
    if (!star_shaped(c.P)) return "";
    const auto valid = valid_scales(c.P, c.Q, path).valid;
    if (valid.empty()) return "";
    return valid.size() == 1 && valid[0].from.scale == 0 ? "" : "valid: " + text(valid);
  };
  with_paths(convex_polygons(), random, law)(200);
  with_paths(thin_and_wide(4, 2), random, law)(100);
}

TEST(StarShaped, NeedsTheOriginOnTheLeftOfAllEdges) {
  EXPECT_TRUE(star_shaped(box(-1, -1, 1, 1)));
  EXPECT_TRUE(star_shaped(box(0, 0, 1, 1)));
  EXPECT_FALSE(star_shaped(box(1, 0, 2, 1)));
  EXPECT_TRUE(star_shaped({{{{{-1, 0}, {1, 0}}, {}}}}));
  EXPECT_FALSE(star_shaped({{{{{1, 0}, {2, 0}}, {}}}}));
  // Two triangles that touch at the origin.
  EXPECT_TRUE(star_shaped({{{{{0, 0}, {1, -1}, {1, 1}}, {}}, {{{0, 0}, {-1, 1}, {-1, -1}}, {}}}}));
}

}  // namespace
}  // namespace minkref::testing::of_valid_scales
