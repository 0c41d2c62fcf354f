// Valid scales in space: two routes agree, prisms are as the plane says, and what must hold does.
#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/motion/space/contact_scales.hpp"
#include "tests/motion/space/random_space_paths.hpp"

namespace minkref::testing::of_space_paths {
namespace {

using bodies::at;
using bodies::box;
using Kind = SpaceFeature::Kind;

constexpr std::array rules{ContactRule::allowed, ContactRule::forbidden};
constexpr std::array routes{PathRoute::pieces, PathRoute::contacts};

std::string routes_agree(const SpaceCase& c) {
  for (const ContactRule rule : rules) {
    const auto expected = valid_scales(c.part, c.obstacles, c.path, rule).valid;
    const auto found =
        valid_scales(c.part, c.obstacles, c.path, rule, {}, PathRoute::contacts).valid;
    if (found != expected) {
      return std::string(rule == ContactRule::allowed ? "allowed" : "forbidden") +
             ", pieces: " + text(expected) + ", contacts: " + text(found);
    }
  }
  return "";
}

/// Draws cases of solids, or (`thin`) of a solid and an operand without volume.
template <class Law>
void with_cases(unsigned count, bool thin, const Law& law) {
  bodies::for_each_seed(static_cast<unsigned>(repetitions(static_cast<int>(count))),
                        [&](std::mt19937& dice) {
                          SpaceCase c{drawn_solid(dice), drawn_solid(dice), {}};
                          if (thin)
                            (below_in(dice, 2) == 0 ? c.part : c.obstacles) = drawn_thin(dice);
                          c.path = drawn_path(dice, c.part, c.obstacles);
                          ASSERT_EQ(law(c), "") << text(c);
                        });
}

TEST(SpacePaths, OfTwoRoutesAgree) { with_cases(40, false, routes_agree); }
TEST(SpacePaths, OfTwoRoutesAgreeWhereOneOperandIsThin) { with_cases(60, true, routes_agree); }

/// (x, y, z) -> (x, y + 2 x, z + x - y): prisms become oblique.
SpacePoint sheared(const SpacePoint& p) { return {p.x, p.y + 2 * p.x, p.z + p.x - p.y}; }
Polyhedron sheared(Polyhedron body) {
  for (SpacePoint& v : body.vertices) v = sheared(v);
  return body;
}

/// Prisms of the same heights about the path's plane meet iff their polygons do.
std::string prisms_are_as_polygons(const PolygonSet& part, const PolygonSet& obstacles,
                                   const std::vector<Point>& path, bool with_contacts) {
  const auto tall = prism(part, -1, 1), walls = prism(obstacles, -3, 2);
  if (!tall || !walls || (!part.is_region() && !obstacles.is_region())) return "";
  SpacePath flat, oblique;
  for (const Point& p : path) {
    flat.push_back({p.x, p.y, 0});
    oblique.push_back(sheared(flat.back()));
  }
  for (const ContactRule rule : rules) {
    const ValidScales expected = valid_scales(part, obstacles, path, rule);
    const auto differs = [&](const SpaceValidScales& found) -> std::string {
      if (found.valid != expected.valid) {
        return "plane: " + text(expected.valid) + ", space: " + text(found.valid);
      }
      for (std::size_t k = 0; k < found.bounds.size(); ++k) {
        const auto& a = expected.bounds[k].at;
        const auto& b = found.bounds[k].at;
        if (a.segment != b.segment || a.t != b.t) return "a bound is at another place";
      }
      return "";
    };
    std::string fault = differs(valid_scales(*tall, *walls, flat, rule));
    if (fault.empty())
      fault = differs(valid_scales(sheared(*tall), sheared(*walls), oblique, rule));
    if (fault.empty() && with_contacts) {
      fault = differs(valid_scales(*tall, *walls, flat, rule, {}, PathRoute::contacts));
    }
    if (!fault.empty()) return fault;
  }
  return "";
}

template <class Make>
void with_prisms(Source& random, int count, Make&& make, bool with_contacts = true) {
  for (int i = 0; i < repetitions(count); ++i) {
    const Case c = make(random);
    const std::vector<Point> path = random_path(random, c.P, c.Q);
    const std::string fault = prisms_are_as_polygons(c.P, c.Q, path, with_contacts);
    ASSERT_EQ(fault, "") << "repetition " << i << "\n" << text(c) << "\npath " << text(path);
  }
}

TEST(SpacePaths, OfPrismsAreThoseOfPolygons) {
  MINKREF_SEEDED(random, 3201);
  with_prisms(random, 15, random_case, false);
  with_prisms(random, 20, lattice_pieces(2, 3));
}

TEST(SpacePaths, OfPrismsOfPointsAndSegmentsAreThoseOfPolygons) {
  MINKREF_SEEDED(random, 3202);
  with_prisms(random, 30, thin_and_wide(4, 2));
}

Polyhedron box_from(const SpacePoint& low, const SpacePoint& high) {
  Polyhedron result = box(1, 1, 1);
  for (SpacePoint& v : result.vertices) {
    v = {v.x == 0 ? low.x : high.x, v.y == 0 ? low.y : high.y, v.z == 0 ? low.z : high.z};
  }
  return result;
}

void expect_valid(const Polyhedron& part, const Polyhedron& obstacles, const SpacePath& path,
                  ContactRule rule, const std::string& expected, const ScaleWindow& window = {}) {
  for (const PathRoute route : routes) {
    EXPECT_EQ(text(valid_scales(part, obstacles, path, rule, window, route).valid), expected);
  }
}

/// Bad scales: (1/3, 2), where [2 s, 3 s] meets (1, 4), and (2, 9/2), where [2 s, 3 s] meets (6,
/// 9).
TEST(SpacePaths, MayBeValidAtOneScaleAlone) {
  const Polyhedron part = box_from(at(2, 0, 0), at(3, 1, 1));
  const Polyhedron walls = surfaces::together(
      {box_from(at(1, -1, -1), at(4, 9, 9)), box_from(at(6, -1, -1), at(9, 9, 9))});
  expect_valid(part, walls, {at(0, 0, 0)}, ContactRule::allowed, "(0, 1/3] [2, 2] [9/2, inf) ");
  expect_valid(part, walls, {at(0, 0, 0)}, ContactRule::forbidden, "(0, 1/3) (9/2, inf) ");
  expect_valid(part, walls, {at(0, 0, 0)}, ContactRule::allowed, "[2, 2] ", {1, 3});
  const SpaceValidScales found = valid_scales(part, walls, {at(0, 0, 0)});
  ASSERT_EQ(found.bounds.size(), 4U);
  EXPECT_FALSE(found.bounds[1].blocks);
  EXPECT_TRUE(found.bounds[2].blocks);
  EXPECT_FALSE(star_shaped(part));
}

/// An octahedron whose edges touch a bar's edges: |x| + |z| <= s against x + z >= 3.
TEST(SpacePaths, EndWhereTwoEdgesTouch) {
  const Polyhedron part = bodies::octahedron();
  // A bar along y with the edge x = 1, z = 2 towards the part, which passes along z = 0.
  const Polyhedron bar = box_from(at(1, -9, 2), at(4, 9, 5));
  expect_valid(part, bar, {at(0, -2, 0), at(0, 2, 0)}, ContactRule::allowed, "(0, 3] ");
  expect_valid(part, bar, {at(0, -2, 0), at(0, 2, 0)}, ContactRule::forbidden, "(0, 3) ");
  const SpaceValidScales found = valid_scales(part, bar, {at(0, -2, 0), at(0, 2, 0)});
  ASSERT_EQ(found.bounds.size(), 1U);
  EXPECT_EQ(found.bounds[0].part.kind, Kind::edge);
  EXPECT_EQ(found.bounds[0].obstacle.kind, Kind::edge);
  EXPECT_EQ(found.bounds[0].at.t, 0);
  EXPECT_EQ(found.bounds[0].touching, at(1, -2, 2));
}

/// The part's tip meets a wall's inside; and an obstacle's corner meets the part's face.
TEST(SpacePaths, EndWhereAVertexMeetsAFace) {
  const Polyhedron part = bodies::octahedron(), wall = box_from(at(-9, -9, 5), at(9, 9, 6));
  const SpaceValidScales tip = valid_scales(part, wall, {at(0, 0, 0)});
  ASSERT_EQ(text(tip.valid), "(0, 5] ");
  EXPECT_EQ(tip.bounds[0].part, (SpaceFeature{Kind::vertex, 4, 0}));
  EXPECT_EQ(tip.bounds[0].obstacle, (SpaceFeature{Kind::face, 0, 0}));
  const Polyhedron block = box_from(at(1, 1, 1), at(4, 4, 4));
  const SpaceValidScales corner = valid_scales(part, block, {at(0, 0, 0)});
  ASSERT_EQ(text(corner.valid), "(0, 3] ");
  EXPECT_EQ(corner.bounds[0].part.kind, Kind::face);
  EXPECT_EQ(corner.bounds[0].obstacle, (SpaceFeature{Kind::vertex, 0, 0}));
}

/// The part fits a square hole of width 2 exactly at scale 1, and slides through it.
TEST(SpacePaths, MayPassThroughAHoleWithoutClearance) {
  polycubes::Cells cells = polycubes::without(polycubes::block({0, 0, 0}, {4, 4, 1}),
                                              polycubes::block({1, 1, 0}, {3, 3, 1}));
  const Polyhedron frame = polycubes::solid(cells);
  const Polyhedron part = box_from(at(-1, -1, -1), at(1, 1, 1));
  const SpacePath through{at(2, 2, -5), at(2, 2, 5)};
  expect_valid(part, frame, through, ContactRule::allowed, "(0, 1] ");
  expect_valid(part, frame, through, ContactRule::forbidden, "(0, 1) ");
  expect_valid(part, frame, {{2, 2, -5}, {2, 2, 5}, {0, 2, 5}}, ContactRule::allowed, "(0, 1] ");
  expect_valid(part, frame, {{2, 2, -5}, {Rational(5, 2), 2, 5}}, ContactRule::allowed,
               "(0, 2/3] ");
}

/// Slides along a face, along an edge, and past a vertex that it touches for an instant.
TEST(SpacePaths, MaySlideInContact) {
  const Polyhedron block = box_from(at(0, 0, 0), at(4, 4, 4));
  const Polyhedron part = box_from(at(-1, -1, 0), at(1, 1, 1));
  expect_valid(part, block, {at(-3, 2, 4), at(7, 2, 4)}, ContactRule::allowed, "(0, inf) ");
  expect_valid(part, block, {at(-3, 2, 4), at(7, 2, 4)}, ContactRule::forbidden, "none");
  expect_valid(part, block, {at(0, 0, 4), at(4, 0, 4)}, ContactRule::allowed, "(0, inf) ");
  const Polyhedron point{{at(0, 0, 0)}, {}};
  expect_valid(point, block, {at(0, 0, 4), at(4, 0, 4)}, ContactRule::allowed, "(0, inf) ");
  expect_valid(point, block, {at(0, 0, 4), at(4, 0, 4)}, ContactRule::forbidden, "none");
  const Polyhedron octahedron = bodies::octahedron();
  expect_valid(octahedron, block, {at(7, 6, 5), at(5, 6, 7)}, ContactRule::allowed, "(0, 6] ");
}

/// A point passes through a solid along the seams of its convex pieces.
TEST(SpacePaths, OfAPointSeeSeams) {
  const Polyhedron bent = polycubes::solid(polycubes::with(polycubes::block({0, 0, 0}, {2, 1, 2}),
                                                           polycubes::block({0, 1, 0}, {1, 2, 1})));
  ASSERT_NO_THROW(validate(bent));
  const Polyhedron point{{at(0, 0, 0)}, {}};
  const Rational half(1, 2);
  for (const SpacePath& path :
       {SpacePath{{half, 1, half}}, SpacePath{{half, half, 1}}, SpacePath{{1, half, half}},
        SpacePath{{1, half, 1}}, SpacePath{{half, half, half}, {half, half, 1}}}) {
    expect_valid(point, bent, path, ContactRule::allowed, "none");
  }
  expect_valid(point, bent, {{half, 1, 1}}, ContactRule::allowed, "(0, inf) ");
  expect_valid(point, bent, {{half, 1, 1}}, ContactRule::forbidden, "none");
  // Seven of eight cells: seams meet at the middle, on the surface.
  const Polyhedron corner = polycubes::solid(polycubes::without(
      polycubes::block({0, 0, 0}, {2, 2, 2}), polycubes::block({1, 1, 1}, {2, 2, 2})));
  expect_valid(point, corner, {at(1, 1, 1)}, ContactRule::allowed, "(0, inf) ");
  expect_valid(point, corner, {{1, 1, half}}, ContactRule::allowed, "none");
  // A segment lies in a seam at a single scale, crossing the dent's reflex edge.
  const Polyhedron needle{{at(1, 0, 0), at(1, 1, 0)}, {}};
  expect_valid(needle, corner, {{0, half, half}}, ContactRule::allowed, "[2, inf) ");
}

TEST(SpacePaths, AreAllWithoutAPartOrObstacles) {
  expect_valid({}, box(1, 1, 1), {at(0, 0, 0)}, ContactRule::forbidden, "(0, inf) ");
  expect_valid(box(1, 1, 1), {}, {at(0, 0, 0)}, ContactRule::allowed, "[1, 2] ", {1, 2});
}

TEST(SpacePaths, RefuseWhatHasNoAnswer) {
  const Polyhedron point{{at(1, 0, 0)}, {}}, cube = box(1, 1, 1);
  EXPECT_THROW(valid_scales(cube, cube, SpacePath{}), BadInput);
  EXPECT_THROW(valid_scales(point, point, {at(0, 0, 0)}), BadInput);
  EXPECT_THROW(valid_scales(cube, point, {at(0, 0, 0)}, ContactRule::allowed, {2, 1}), BadInput);
  EXPECT_THROW(valid_scales(cube, cube, {at(0, 0, 0)}, ContactRule::allowed, {}, PathRoute::index),
               BadInput);
}

/// Finds the contact whatever else touches or overlaps: for a path that is a place, for a path
/// across the plane of the moving vertex and edge, and for a path within that plane.
TEST(ContactScales, AreAllAtWhichAVertexComesToAnEdge) {
  const Polyhedron part = box_from(at(-1, -1, -1), at(1, 1, 1));
  const Polyhedron block = box_from(at(3, 3, -9), at(6, 6, 9));  // an edge x = 3, y = 3
  for (const SpacePath& path : {SpacePath{at(6, 6, 0)}, SpacePath{at(5, 7, 0), at(7, 5, 0)},
                                SpacePath{at(6, 6, 0), at(7, 7, 1)}}) {
    const std::vector<Rational> scales = contact_scales(part, block, path);
    EXPECT_TRUE(std::binary_search(scales.begin(), scales.end(), Rational(3)));
  }
}

TEST(SpacePaths, RefuseMoreThanTheyHoldInMemory) {
  Polyhedron many;
  for (int k = 0; k < 100; ++k) {
    many = surfaces::together({many, translated(box(1, 1, 1), at(2 * k, 0, 0))});
  }
  const SpacePath path(most_pairs_on_a_path / 100, at(0, 5, 0));
  EXPECT_THROW(valid_scales(box(1, 1, 1), many, path), LimitExceeded);
}

/// All scaled together, all moved together, the way back, and a segment cut in two.
std::string does_not_change(const SpaceCase& c) {
  const auto expected = valid_scales(c.part, c.obstacles, c.path).valid;
  const Rational factor(7, 3);
  const Scaling by{factor, factor, factor};
  SpacePath larger, moved, halved;
  for (const SpacePoint& p : c.path) {
    if (!halved.empty()) {
      const SpacePoint& a = halved.back();
      halved.push_back({(2 * a.x + p.x) / 3, (2 * a.y + p.y) / 3, (2 * a.z + p.z) / 3});
    }
    halved.push_back(p);
    larger.push_back({p.x * factor, p.y * factor, p.z * factor});
    moved.push_back({p.x + 5, p.y - factor, p.z});
  }
  if (valid_scales(scaled(c.part, by), scaled(c.obstacles, by), larger).valid != expected) {
    return "scaled together, other scales are valid";
  }
  if (valid_scales(c.part, translated(c.obstacles, {5, -factor, 0}), moved).valid != expected) {
    return "moved together, other scales are valid";
  }
  if (valid_scales(c.part, c.obstacles, SpacePath(c.path.rbegin(), c.path.rend())).valid !=
      expected) {
    return "another answer on the way back";
  }
  if (valid_scales(c.part, c.obstacles, halved).valid != expected) {
    return "another answer where a segment is cut in two";
  }
  return "";
}
TEST(SpacePaths, DoNotChangeWhereAllIsScaledOrMoved) { with_cases(40, false, does_not_change); }

/// Scales are valid among two obstacles iff they are valid among each.
TEST(SpacePaths, AmongTwoObstaclesAreThoseOfBoth) {
  bodies::for_each_seed(static_cast<unsigned>(repetitions(40)), [](std::mt19937& dice) {
    const Polyhedron part = drawn_solid(dice), first = bodies::random_tetrahedron(dice, 3);
    const Polyhedron second = translated(bodies::random_tetrahedron(dice, 3), at(7, 1, 0));
    const Polyhedron both = surfaces::together({first, second});
    const SpacePath path = drawn_path(dice, part, both);
    for (const ContactRule rule : rules) {
      ScaleSet bad;
      for (const Polyhedron& one : {first, second}) {
        ScaleSet valid;
        for (const ScaleRange& range : valid_scales(part, one, path, rule).valid) {
          valid.add(range.from, range.to);
        }
        for (const ScaleRange& range : valid.left_of({})) bad.add(range.from, range.to);
      }
      ASSERT_EQ(text(valid_scales(part, both, path, rule).valid), text(bad.left_of({})))
          << text(SpaceCase{part, both, path});
    }
  });
}

/// Also where a window begins or ends at a bound.
std::string windows_cut(const SpaceCase& c) {
  for (const ContactRule rule : rules) {
    const SpaceValidScales all = valid_scales(c.part, c.obstacles, c.path, rule);
    ScaleWindow window{Rational(1, 3), 2};
    if (!all.bounds.empty()) window = {all.bounds.front().scale, all.bounds.back().scale};
    for (const PathRoute route : routes) {
      ScaleSet found;
      for (const ScaleRange& range :
           valid_scales(c.part, c.obstacles, c.path, rule, window, route).valid) {
        found.add(range.from, range.to);
      }
      ScaleSet expected;
      for (const ScaleRange& range : all.valid) expected.add(range.from, range.to);
      ScaleSet bad;
      for (const ScaleRange& range : expected.left_of({})) bad.add(range.from, range.to);
      if (found.ranges() != bad.left_of(window)) {
        return "in a window " + text(found.ranges()) + ", of all " + text(all.valid);
      }
    }
  }
  return "";
}
TEST(SpacePaths, OfAWindowAreThoseInIt) { with_cases(15, false, windows_cut); }

/// Each bound names features that contain the contact point.
std::string bounds_touch(const SpaceCase& c) {
  const auto holds = [](const Polyhedron& body, const SpaceFeature& f, const SpacePoint& p) {
    const auto& v = body.vertices;
    if (f.kind == Kind::vertex) return v.at(f.first) == p;
    const auto minus = [](const SpacePoint& a, const SpacePoint& b) {
      return SpacePoint{a.x - b.x, a.y - b.y, a.z - b.z};
    };
    const auto product = [](const SpacePoint& a, const SpacePoint& b) {
      return SpacePoint{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    };
    const auto times = [](const SpacePoint& a, const SpacePoint& b) -> Rational {
      return a.x * b.x + a.y * b.y + a.z * b.z;
    };
    if (f.kind == Kind::edge) {
      const SpacePoint a = minus(v.at(f.first), p), b = minus(v.at(f.second), p);
      return product(a, b) == SpacePoint{} && times(a, b) < 0;
    }
    const Face& face = body.faces.at(f.first);
    return times(product(minus(v[face[1]], v[face[0]]), minus(v[face[2]], v[face[0]])),
                 minus(p, v[face[0]])) == 0;
  };
  for (const ContactRule rule : rules) {
    for (const SpacePathBound& bound : valid_scales(c.part, c.obstacles, c.path, rule).bounds) {
      const SpacePoint &p = bound.touching, &x = bound.at.point;
      const SpacePoint on_part{(p.x - x.x) / bound.scale, (p.y - x.y) / bound.scale,
                               (p.z - x.z) / bound.scale};
      if (!holds(c.part, bound.part, on_part)) return "the part does not touch there";
      if (!holds(c.obstacles, bound.obstacle, p)) return "the obstacle does not touch there";
      // With the path shortened to the place, both touch but do not overlap.
      const ScaleWindow here{bound.scale, bound.scale};
      if (valid_scales(c.part, c.obstacles, {x}, ContactRule::allowed, here).valid.empty()) {
        return "they do not only touch";
      }
      if (!valid_scales(c.part, c.obstacles, {x}, ContactRule::forbidden, here).valid.empty()) {
        return "they do not touch";
      }
    }
  }
  return "";
}
TEST(SpacePaths, HaveBoundsAtContacts) {
  with_cases(60, false, bounds_touch);
  with_cases(60, true, bounds_touch);
}

TEST(SpacePaths, OfAStarShapedPartAreOneIntervalFromZero) {
  unsigned stars = 0;
  const auto law = [&](const SpaceCase& c) -> std::string {
    if (!star_shaped(c.part)) return "";
    ++stars;
    const auto valid = valid_scales(c.part, c.obstacles, c.path).valid;
    const bool is_one = valid.size() == 1 && valid[0].from.scale == 0;
    return valid.empty() || is_one ? "" : "valid: " + text(valid);
  };
  with_cases(150, false, law);
  with_cases(150, true, law);
  EXPECT_GE(stars, testing::repetitions(10U));
}

TEST(SpacePaths, KnowStarShapedParts) {
  EXPECT_TRUE(star_shaped(box(1, 1, 1)));
  EXPECT_FALSE(star_shaped(translated(box(1, 1, 1), at(1, 0, 0))));
  EXPECT_TRUE(star_shaped({{at(-1, 0, 0), at(1, 0, 0)}, {}}));
  EXPECT_FALSE(star_shaped({{at(1, 0, 0), at(2, 0, 0)}, {}}));
  EXPECT_TRUE(star_shaped({{at(-1, 0, 0), at(1, 0, 0), at(0, 1, 0)}, {{0, 1, 2}}}));
  EXPECT_FALSE(star_shaped({{at(-1, 0, 1), at(1, 0, 1), at(0, 1, 1)}, {{0, 1, 2}}}));
}

/// A torus knot along which a small box slips through the loops.
TEST(SpacePaths, AmongLoopsOfAKnotAgree) {
  const Polyhedron knot = surfaces::torus_knot(2, 3, 0.35, 24);
  ASSERT_NO_THROW(validate(knot));
  const Polyhedron part =
      bodies::tetrahedron(at(-300, -300, -300), at(500, 0, 0), at(0, 500, 0), at(0, 0, 500));
  const SpacePath path{at(0, 0, 9000), at(0, 0, 0), at(500, 100, -200)};
  const auto expected = valid_scales(part, knot, path).valid;
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(expected.size(), 1U);
  EXPECT_EQ(
      text(valid_scales(part, knot, path, ContactRule::allowed, {}, PathRoute::contacts).valid),
      text(expected));
}

}  // namespace
}  // namespace minkref::testing::of_space_paths
