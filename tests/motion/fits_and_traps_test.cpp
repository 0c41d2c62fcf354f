// Fits and traps at single scales are as static sums by another route say.
#include "reference/motion/fits_and_traps.hpp"

#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/motion/container_frame.hpp"
#include "reference/motion/free_space.hpp"
#include "reference/motion/star_centre.hpp"
#include "reference/plane/dynamic/arrangement_events.hpp"
#include "tests/motion/random_paths.hpp"

namespace minkref::testing::of_fits_and_traps {
namespace {

PolygonSet rectangle(const Rational& x0, const Rational& y0, const Rational& x1,
                     const Rational& y1) {
  return {{{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}}};
}

/// A room [0, 4] x [0, 4] with a door of width 1 in the right wall.
PolygonSet room_with_door() {
  return {{{{{-1, -1},
             {5, -1},
             {5, Rational(3, 2)},
             {4, Rational(3, 2)},
             {4, 0},
             {0, 0},
             {0, 4},
             {4, 4},
             {4, Rational(5, 2)},
             {5, Rational(5, 2)},
             {5, 5},
             {-1, 5}},
            {}}}};
}

const Rational half(1, 2);

TEST(TrappedScales, OfASquareInARoomAreThoseTooWideForTheDoor) {
  const PolygonSet square = rectangle(-half, -half, half, half);
  const auto allowed = trapped_scales(square, room_with_door(), {2, 2});
  EXPECT_EQ(text(allowed.scales), "(1, 4] ");
  ASSERT_EQ(allowed.bounds.size(), 2U);
  EXPECT_EQ(allowed.bounds[0].event, "split");
  EXPECT_EQ(allowed.bounds[1].event, "contact");
  EXPECT_EQ(allowed.proofs.size(), 6U);
  const auto forbidden = trapped_scales(square, room_with_door(), {2, 2}, ContactRule::forbidden);
  EXPECT_EQ(text(forbidden.scales), "[1, 4) ");
}

TEST(TrappedScales, OfAWindowAreThoseInIt) {
  const PolygonSet square = rectangle(-half, -half, half, half);
  const auto in = [&](const Rational& from, const Rational& to, ContactRule rule) {
    return text(trapped_scales(square, room_with_door(), {2, 2}, rule, {from, to}).scales);
  };
  EXPECT_EQ(in(1, 4, ContactRule::allowed), "(1, 4] ");
  EXPECT_EQ(in(1, 4, ContactRule::forbidden), "[1, 4) ");
  EXPECT_EQ(in(4, 5, ContactRule::allowed), "[4, 4] ");
  EXPECT_EQ(in(half, 1, ContactRule::allowed), "none");
  EXPECT_EQ(in(half, 1, ContactRule::forbidden), "[1, 1] ");
  EXPECT_EQ(in(2, 3, ContactRule::allowed), "[2, 3] ");
}

TEST(TrappedScales, ArePartOfTheValidScalesOfThePlace) {
  MINKREF_SEEDED(random, 3120);
  expect_law(random, 15, lattice_pieces(2, 5), [](const Case& c) -> std::string {
    Source own(7);
    const Point at = random_path(own, c.P, c.Q)[0];
    for (const ContactRule rule : {ContactRule::allowed, ContactRule::forbidden}) {
      const auto free = valid_scales(c.P, c.Q, {at}, rule).valid;
      const auto trapped = [&] {
        try {
          return trapped_scales(c.P, c.Q, at, rule).scales;
        } catch (const BadInput& refused) {
          if (refused.code() != "touching-rings") throw;
          return std::vector<ScaleRange>{};
        }
      }();
      for (const ScaleRange& range : trapped) {
        if (std::none_of(free.begin(), free.end(), [&](const ScaleRange& of) {
              return !(range.from < of.from) && (!of.to || (range.to && !(*of.to < *range.to)));
            })) {
          return "trapped at " + text(trapped) + ", free at " + text(free);
        }
      }
    }
    return "";
  });
}

TEST(ScalesThatFit, OfARectangleInAnother) {
  const PolygonSet part = rectangle(5, 5, 6, 6), container = rectangle(0, 0, 4, 3);
  EXPECT_EQ(text(scales_that_fit(part, container).scales), "(0, 3] ");
  EXPECT_EQ(text(scales_that_fit(part, container, ContactRule::forbidden).scales), "(0, 3) ");
  const PolygonSet square = rectangle(-half, -half, half, half);
  const FreeScales at = scales_that_fit_at(square, container, {1, 1});
  EXPECT_EQ(text(at.scales), "(0, 2] ");
  ASSERT_EQ(at.bounds.size(), 1U);
  EXPECT_EQ(at.bounds[0].contact->obstacle.id, (VertexId{0, 0}));
  EXPECT_FALSE(at.bounds[0].contact->obstacle.is_edge);
}

/// A ring fits into an equal ring at scale 1, around the island, and into the ring's width of 1
/// while its own width is at most 1. No hole of any sum shows the scale 1.
TEST(ScalesThatFit, OfARingInItselfAreASingleScaleAndThoseInItsWidth) {
  PolygonSet ring = rectangle(-2, -2, 2, 2);
  ring.polygons[0].holes.push_back({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}});
  EXPECT_EQ(text(scales_that_fit(ring, ring).scales), "(0, 1/4] [1, 1] ");
  EXPECT_EQ(text(scales_that_fit(ring, ring, ContactRule::forbidden).scales), "(0, 1/4) ");
}

TEST(ScalesThatPass, AreThoseOfTheDoorBetweenTwoRooms) {
  const PolygonSet rooms{{{{{0, 0},
                            {4, 0},
                            {4, 1},
                            {5, 1},
                            {5, 0},
                            {9, 0},
                            {9, 4},
                            {5, 4},
                            {5, 2},
                            {4, 2},
                            {4, 4},
                            {0, 4}},
                           {}}}};
  const PolygonSet square = rectangle(-half, -half, half, half);
  const auto passes = scales_that_pass(square, rooms, {2, 2}, {7, 2});
  EXPECT_EQ(text(passes.scales), "(0, 1] ");
  EXPECT_EQ(text(scales_that_pass(square, rooms, {2, 2}, {7, 2}, ContactRule::forbidden).scales),
            "(0, 1) ");
}

TEST(ScalesThatFit, RefuseAPoint) {
  const PolygonSet point{{{{{1, 0}}, {}}}};
  EXPECT_THROW(scales_that_fit(point, rectangle(0, 0, 1, 1)), BadInput);
  EXPECT_THROW(scales_that_fit(rectangle(0, 0, 1, 1), point), BadInput);
}

/// Compares at random scales, at event scales and between them.
std::string as_static_sums_say(const Case& c) {
  Source own(11);
  const auto ends = random_path(own, c.P, c.Q);
  for (const ContactRule rule : {ContactRule::allowed, ContactRule::forbidden}) {
    FreeScales trapped, fits;
    try {
      trapped = trapped_scales(c.P, c.Q, ends[0], rule);
      fits = scales_that_fit(c.P, c.Q, rule);
    } catch (const BadInput& refused) {
      if (refused.code() != "touching-rings") throw;
      continue;
    }
    const ContainerFrame frame(c.P, c.Q, {});
    std::vector<Rational> scales{Rational(1, 50), c.scale, 30};
    for (int k = 0; k < 6; ++k) scales.push_back(Rational(own.between(1, 60), own.between(1, 20)));
    for (const auto* found : {&trapped, &fits}) {
      for (const ScaleRange& range : found->scales) scales.push_back(range.sample());
    }
    const auto holds = [](const FreeScales& found, const Rational& scale) {
      return std::any_of(found.scales.begin(), found.scales.end(),
                         [&](const ScaleRange& r) { return r.holds(scale); });
    };
    const PolygonSet turned = reflected_set(c.P);
    for (const Rational& scale : scales) {
      const FreeSpace about(
          minkowski_sum(turned, c.Q, scale, Route::definition, "rational", Passages::find), rule,
          {ends[0]});
      const auto place = about.part_of(ends[0]);
      if (holds(trapped, scale) != (place && *place != 0)) {
        return "trapped at " + text(trapped.scales) + ", but not at scale " + to_string(scale);
      }
      if (scale > *frame.window.to) continue;
      const FreeSpace inside(
          minkowski_sum(turned, frame.set(), scale, Route::definition, "rational", Passages::find),
          rule, {});
      if (holds(fits, scale) != (inside.parts() > 1)) {
        return "fits at " + text(fits.scales) + ", but not as said at scale " + to_string(scale);
      }
    }
  }
  return "";
}

TEST(FreeScales, AreAsStaticSumsSayAtOtherScales) {
  MINKREF_SEEDED(random, 3121);
  expect_law(random, 12, random_case, as_static_sums_say);
  expect_law(random, 12, lattice_pieces(2, 5), as_static_sums_say);
}

/// A convex or a star-shaped part, with its centre at the origin or not.
PolygonSet star_shaped_part(Source& random, bool about_origin) {
  const auto far = [&] { return Rational(random.between(1, 6), random.between(1, 3)); };
  Ring ring{{far(), 0}, {0, far()}, {-far(), 0}, {0, -far()}};
  if (random.below(2) == 0)
    ring = {{far(), far()}, {-far(), far()}, {-far(), -far()}, {far(), -far()}};
  PolygonSet part{{{ring, {}}}};
  if (!about_origin) {
    const Rational x = random.between(-9, 9), y = random.between(-9, 9);
    for (Point& p : part.polygons[0].outer) p = {p.x + x, p.y + y};
  }
  return part;
}

std::string told(const FreeScales& found) {
  std::string all = text(found.scales) + "|";
  for (const FreeBound& bound : found.bounds) {
    all += " " + to_string(bound.scale) + (bound.ends ? " ends" : " begins");
  }
  return all;
}

TEST(FreeScales, OfAStarShapedPartAreThoseOfAllScales) {
  MINKREF_SEEDED(random, 3124);
  expect_law(random, 25, lattice_pieces(2, 5), [&](const Case& c) -> std::string {
    const Point at = random_path(random, c.P, c.Q)[0], other = random_path(random, c.P, c.Q)[0];
    for (const ContactRule rule : {ContactRule::allowed, ContactRule::forbidden}) {
      for (const bool about_origin : {true, false}) {
        const PolygonSet part = star_shaped_part(random, about_origin);
        if (about_origin && !star_shaped(part)) return "the part is not star-shaped";
        const auto differ = [&](const auto& ask) -> std::string {
          std::string narrowed, all;
          try {
            all = told(ask(FitSearch::all));
            narrowed = told(ask(FitSearch::narrowed));
          } catch (const BadInput& refused) {
            if (refused.code() != "touching-rings") throw;
          }
          return narrowed == all ? "" : narrowed + " and not " + all;
        };
        const ScaleWindow window{Rational(random.between(1, 4), 4), Rational(random.between(2, 6))};
        for (const std::string& fault : {
                 differ([&](FitSearch s) { return scales_that_fit(part, c.Q, rule, s); }),
                 differ(
                     [&](FitSearch s) { return scales_that_pass(part, c.Q, at, other, rule, s); }),
                 differ([&](FitSearch s) { return trapped_scales(part, c.Q, at, rule, {}, s); }),
                 differ(
                     [&](FitSearch s) { return trapped_scales(part, c.Q, at, rule, window, s); }),
             }) {
          if (!fault.empty()) return fault;
        }
      }
    }
    return "";
  });
}

TEST(FreeScales, OfARoomWithADoorAreNarrowedToItsWidth) {
  for (const ContactRule rule : {ContactRule::allowed, ContactRule::forbidden}) {
    const PolygonSet square = rectangle(-half, -half, half, half);
    const auto ask = [&](FitSearch search) {
      return trapped_scales(square, room_with_door(), {2, 2}, rule, {}, search);
    };
    const FreeScales narrowed = ask(FitSearch::narrowed), all = ask(FitSearch::all);
    EXPECT_EQ(told(narrowed), told(all));
    EXPECT_EQ(narrowed.proofs.size(), all.proofs.size());
    EXPECT_LE(narrowed.critical_scales, all.critical_scales);
  }
}

/// Room that no door opens: trapped up to the scale that it holds, and no way to another room.
TEST(FreeScales, OfAClosedRoomNeedNoEvents) {
  const PolygonSet square = rectangle(-half, -half, half, half);
  PolygonSet rooms = rectangle(-1, -1, 9, 5);
  const auto hole = [](int left) -> Ring {
    return {{left, 0}, {left, 4}, {left + 3, 4}, {left + 3, 0}};
  };
  rooms.polygons[0].holes = {hole(0), hole(5)};
  PolygonSet container{
      {{{{0, 0}, {3, 0}, {3, 4}, {0, 4}}, {}}, {{{5, 0}, {8, 0}, {8, 4}, {5, 4}}, {}}}};
  for (const ContactRule rule : {ContactRule::allowed, ContactRule::forbidden}) {
    for (const ScaleWindow& window :
         {ScaleWindow{}, ScaleWindow{1, 2}, ScaleWindow{2, 9}, ScaleWindow{3, 4}}) {
      const auto trapped = [&](FitSearch search) {
        return trapped_scales(square, rooms, {Rational(3, 2), 2}, rule, window, search);
      };
      EXPECT_EQ(told(trapped(FitSearch::narrowed)), told(trapped(FitSearch::all)));
    }
    const auto pass = [&](const Point& from, FitSearch search) {
      return told(scales_that_pass(square, container, from, {6, 2}, rule, search));
    };
    for (const Point& from : {Point{1, 2}, Point{7, 1}, Point{3, 2}, Point{4, 2}, Point{5, 4}}) {
      EXPECT_EQ(pass(from, FitSearch::narrowed), pass(from, FitSearch::all));
    }
  }
}

TEST(StarCentre, IsFoundWhereThereIsOne) {
  const PolygonSet angle{{{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, {}}}};
  const PolygonSet arrow{{{{{0, 0}, {4, -4}, {2, 0}, {4, 4}}, {}}}};
  for (const PolygonSet& set : {rectangle(3, 4, 5, 6), angle, arrow}) {
    const auto found = star_centre(set);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->is_inside && is_inner_star_centre(set, found->at));
  }
  EXPECT_FALSE(is_inner_star_centre(angle, {1, Rational(1, 2)}));
  const PolygonSet hook{{{{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}, {}}}};
  EXPECT_FALSE(star_centre(hook));
  const PolygonSet ring{{{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
  EXPECT_FALSE(star_centre(ring));
  const auto end = star_centre({{{{{1, 1}, {2, 3}}, {}}}});
  ASSERT_TRUE(end);
  EXPECT_FALSE(end->is_inside);
}

TEST(StarCentre, IsNotInsideWhereOnlyASegmentSeesAll) {
  const PolygonSet steps{{{{{0, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {1, 2}, {1, 1}, {0, 1}}, {}}}};
  const auto found = star_centre(steps);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->at.y, 1);
  EXPECT_FALSE(found->is_inside);
}

/// At every event scale of the arrangement, compares whether the place is free: no omitted event
/// changes the answer.
TEST(FreeScales, ChangeAtNoEventThatWasLeftOut) {
  MINKREF_SEEDED(random, 3122);
  expect_law(random, 30, lattice_pieces(2, 4), [](const Case& c) -> std::string {
    const ContainerFrame frame(c.P, c.Q, {});
    const PolygonSet turned = reflected_set(c.P);
    const Point at = corners_of(c.Q)[0];
    FreeScales trapped, fits;
    try {
      trapped = trapped_scales(c.P, c.Q, at);
      fits = scales_that_fit(c.P, c.Q);
    } catch (const BadInput& refused) {
      if (refused.code() != "touching-rings") throw;
      return "";
    }
    const auto differs = [&](const PolygonSet& obstacles, const FreeScales& found,
                             const auto& question) -> std::string {
      const ArrangementEvents events(turned, obstacles, {});
      for (std::uint32_t k = 0; k < events.groups() && k < 400; ++k) {
        const Rational scale = events.exact(k);
        if (frame.window.to && scale > *frame.window.to) continue;
        const FreeSpace free(
            minkowski_sum(turned, obstacles, scale, Route::paper, "rational", Passages::find),
            ContactRule::allowed, {at});
        if (question(free) != std::any_of(found.scales.begin(), found.scales.end(),
                                          [&](const ScaleRange& r) { return r.holds(scale); })) {
          return text(found.scales) + " is wrong at scale " + to_string(scale);
        }
      }
      return "";
    };
    const std::string wrong = differs(c.Q, trapped, [&](const FreeSpace& free) {
      const auto place = free.part_of(at);
      return place && *place != 0;
    });
    if (!wrong.empty()) return "trapped at " + wrong;
    const std::string other =
        differs(frame.set(), fits, [](const FreeSpace& free) { return free.parts() > 1; });
    return other.empty() ? "" : "fits at " + other;
  });
}

}  // namespace
}  // namespace minkref::testing::of_fits_and_traps
