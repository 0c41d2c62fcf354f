// The union of placed sums: that of the sums as sets, with all owners, however it came about.
#include "reference/scene/scene_union.hpp"

#include <gtest/gtest.h>

#include <set>

#include "reference/error.hpp"
#include "reference/plane/boundary/set_operations.hpp"
#include "reference/plane/sum.hpp"
#include "tests/scene/random_scenes.hpp"

namespace minkref::testing::of_scene_unions {
namespace {

PolygonSet placed_sum(const Scene& scene, const Copy& copy) {
  const Sum sum = minkowski_sum(scene.shapes[copy.shape], scaled(scene.robot, -1), copy.scale);
  return translated(sum.region, copy.place);
}

Canonical united_sums(const Scene& scene) {
  std::vector<PolygonSet> sums;
  for (const Copy& copy : scene.copies) sums.push_back(placed_sum(scene, copy));
  return combined(SetOperation::unite, sums);
}

/// Whether the edges run the same way along one line and share more than a point.
bool runs_along(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a;
  if (sign(cross(u, d - c)) != 0 || sign(cross(u, c - a)) != 0 || dot(u, d - c) <= 0) return false;
  return dot(u, c - a) < dot(u, u) && dot(u, d - a) > 0;
}

/// The owners of a side, tried one by one.
std::vector<Owner> owners_of(const Scene& scene, const Point& a, const Point& b) {
  const PolygonSet reflected = scaled(scene.robot, -1);
  std::vector<Owner> owners;
  for (std::uint32_t k = 0; k < scene.copies.size(); ++k) {
    const Copy& copy = scene.copies[k];
    const PolygonSet& shape = scene.shapes[copy.shape];
    for (const ConvolutionEdge& edge : reduced_convolution(shape, reflected)) {
      const Segment at = at_scale(edge, shape, reflected, copy.scale);
      if (runs_along(a, b, at.start + copy.place, at.end + copy.place)) owners.push_back({k, edge});
    }
  }
  sort_unique(owners);
  return owners;
}

std::vector<const Ring*> rings_of(const PolygonSet& set) {
  std::vector<const Ring*> rings;
  for (const Polygon& polygon : set.polygons) {
    rings.push_back(&polygon.outer);
    for (const Ring& hole : polygon.holes) rings.push_back(&hole);
  }
  return rings;
}

void expect_owners(const Scene& scene, const SceneUnion& found) {
  const auto rings = rings_of(found.region().region);
  ASSERT_EQ(found.owners().size(), rings.size());
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = *rings[r];
    ASSERT_EQ(found.owners()[r].size(), ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      EXPECT_EQ(found.owners()[r][i], owners_of(scene, ring[i], ring[(i + 1) % ring.size()]));
    }
  }
}

void expect_equal(const SceneUnion& a, const SceneUnion& b) {
  EXPECT_EQ(a.copies(), b.copies());
  EXPECT_EQ(a.region().region, b.region().region);
  EXPECT_EQ(a.region().components, b.region().components);
  EXPECT_EQ(a.region().holes, b.region().holes);
  EXPECT_EQ(a.owners(), b.owners());
  EXPECT_EQ(a.passages(), b.passages());
}

TEST(SceneUnion, IsTheUnionOfAllSumsWithAllOwners) {
  Source random(11);
  for (int k = 0; k < 250; ++k) {
    const Scene scene = k % 3 == 0 ? lattice_scene(random) : random_scene(random);
    SCOPED_TRACE(text(scene));
    BuildOptions options;
    options.threads = random.coin() ? 1 : 3;
    const SceneUnion found(scene, random.coin(), options);
    const Canonical expected = united_sums(scene);
    ASSERT_EQ(found.region().region, expected.region);
    EXPECT_EQ(found.region().components, expected.components);
    EXPECT_EQ(found.region().holes, expected.holes);
    expect_owners(scene, found);
    for (std::uint32_t c = 0; c < scene.copies.size(); ++c)
      EXPECT_EQ(found.sum_of(c).region, placed_sum(scene, scene.copies[c]));
    if (HasFailure()) return;
  }
}

TEST(SceneUnion, OfARobotWithoutAreaIsTheUnionOfAllSumsToo) {
  Source random(12);
  for (int k = 0; k < 150; ++k) {
    const Scene scene = random_scene(random, true);
    SCOPED_TRACE(text(scene));
    const SceneUnion found(scene, true);
    ASSERT_EQ(found.region().region, united_sums(scene).region);
    for (const RingOwners& ring : found.owners()) {
      for (const std::vector<Owner>& side : ring) EXPECT_FALSE(side.empty());
    }
    if (scene.robot.is_point()) expect_owners(scene, found);
    if (HasFailure()) return;
  }
}

TEST(SceneUnion, AfterAChangeIsThatFromScratchAndAfterTheChangeBackTheSame) {
  Source random(13);
  for (int k = 0; k < 200; ++k) {
    Scene scene = k % 3 == 0 ? lattice_scene(random) : random_scene(random, random.below(5) == 0);
    const SceneUnion first(scene, true);
    SceneUnion now = first;
    for (int step = 0; step < 3; ++step) {
      SCOPED_TRACE(text(scene));
      const SceneUnion before = now;
      const Copy copy = random_copy(random, scene, random.between(1, 15), random.coin());
      if (scene.copies.empty() || random.below(3) == 0) {
        scene.copies.push_back(copy);
        now = now.added(copy);
        const auto last = static_cast<std::uint32_t>(scene.copies.size() - 1);
        expect_equal(now.removed(last), before);
      } else if (random.below(3) == 0) {
        const auto gone = static_cast<std::uint32_t>(random.below(scene.copies.size()));
        scene.copies.erase(scene.copies.begin() + gone);
        now = now.removed(gone);
      } else {
        const auto moved = static_cast<std::uint32_t>(random.below(scene.copies.size()));
        const Copy old = scene.copies[moved];
        scene.copies[moved] = {old.shape, copy.scale, copy.place};
        now = now.changed(moved, copy.scale, copy.place);
        expect_equal(now.changed(moved, old.scale, old.place), before);
      }
      SCOPED_TRACE(text(scene));
      expect_equal(now, SceneUnion(scene, true));
      if (HasFailure()) return;
    }
  }
}

/// The scene under x -> factor x + shift.
Scene image(Scene scene, const Rational& factor, const Point& shift) {
  scene.robot = scaled(scene.robot, factor);
  for (PolygonSet& shape : scene.shapes) shape = scaled(shape, factor);
  for (Copy& copy : scene.copies) copy.place = factor * copy.place + shift;
  return scene;
}

TEST(SceneUnion, HoldsBeyondTheRangeOfDoublesAndFarFromTheOrigin) {
  Source random(15);
  const Rational huge(Integer(1) << 1022), far(Integer(1) << 70);
  for (int k = 0; k < 60; ++k) {
    const Scene plain = k % 2 == 0 ? lattice_scene(random) : random_scene(random);
    const Rational factor = k % 3 == 0 ? huge : k % 3 == 1 ? Rational(1 / huge / far) : 1 / far;
    const Point shift = k % 3 == 2 ? Point{far, Rational(1, 3)} : Point{};
    const Scene scene = image(plain, factor, shift);
    SCOPED_TRACE(text(scene));
    const SceneUnion found(scene, true), before(plain, true);
    ASSERT_EQ(found.region().region, united_sums(scene).region);
    EXPECT_EQ(found.owners(), before.owners());
    ASSERT_EQ(found.passages().size(), before.passages().size());
    for (std::size_t i = 0; i < found.passages().size(); ++i)
      EXPECT_EQ(found.passages()[i].owners, before.passages()[i].owners);
  }
}

const PolygonSet unit = box(0, 0, 1, 1);

Scene boxes(std::vector<Point> places) {
  Scene scene{unit, {unit}, {}};
  for (Point& place : places) scene.copies.push_back({0, 1, std::move(place)});
  return scene;
}

TEST(SceneUnion, NoCopyGivesTheEmptySet) {
  const SceneUnion found({unit, {}, {}}, true);
  EXPECT_TRUE(found.region().region.empty());
  EXPECT_TRUE(found.owners().empty());
  EXPECT_TRUE(found.passages().empty());
  EXPECT_EQ(found.components(ContactRule::allowed).count, 1U);
}

TEST(SceneUnion, OfEqualCopiesHasTwoOwnersAndTheRemovalOfOneChangesNothingElse) {
  const SceneUnion found(boxes({{0, 0}, {0, 0}}), true);
  const SceneUnion one = found.removed(1);
  EXPECT_EQ(one.region().region, found.region().region);
  EXPECT_EQ(one.counts().edges_redone, 0U);
  std::set<std::uint32_t> copies;
  for (const Owner& owner : found.owners()[0][0]) copies.insert(owner.copy);
  EXPECT_EQ(copies, (std::set<std::uint32_t>{0, 1}));
}

TEST(SceneUnion, KeepsCopiesApartThatDifferByNextToNothing) {
  const Rational tiny(Integer(1), Integer(1) << 100);
  const SceneUnion found(boxes({{0, 0}, {tiny, 0}, {4 + tiny + tiny, 0}, {2, 0}}), true);
  EXPECT_EQ(found.region().components, 2U);
  EXPECT_EQ(found.region().region.polygons[0].outer[1].x, 3);
  EXPECT_EQ(found.region().region.polygons[1].outer[0].x, 3 + tiny + tiny);
}

TEST(SceneUnion, RedoesOnlyWhatAChangeReaches) {
  std::vector<Point> places;
  for (int x = 0; x < 20; ++x) {
    for (int y = 0; y < 20; ++y) places.push_back({3 * x, 3 * y});
  }
  const SceneUnion found(boxes(places), true);
  EXPECT_EQ(found.counts().copies_redone, 400U);
  EXPECT_EQ(found.counts().sums_evaluated, 1U);
  const SceneUnion changed = found.changed(210, 1, {31, 31});
  EXPECT_LE(changed.counts().copies_redone, 4U);
  EXPECT_EQ(changed.counts().sums_evaluated, 0U);
}

template <class Ask>
std::string refusal(Ask&& ask) {
  try {
    ask();
  } catch (const BadInput& refused) {
    return refused.code();
  }
  return "";
}

TEST(SceneUnion, OfManyScalesIsReadOffAnIndexAndTheSame) {
  Source random(14);
  Scene scene{random_convex_polygon(random), {random_region(random)}, {}};
  std::vector<Copy> late;
  for (int k = 0; k < 230; ++k) {
    late.push_back({0, Rational(k + 20, 100), {random.between(-99, 99), random.between(-99, 99)}});
    if (k < 190) scene.copies.push_back(late.back());
  }
  SceneUnion one_by_one(scene, true);
  EXPECT_EQ(one_by_one.counts().indices_built, 0U);
  for (std::size_t k = scene.copies.size(); k < late.size(); ++k)
    one_by_one = one_by_one.added(late[k]);
  scene.copies = late;
  const SceneUnion found(scene, true);
  EXPECT_EQ(found.counts().indices_built, 1U);
  expect_equal(found, one_by_one);
  // Within the index's window, at its end, and beside it.
  for (const Rational& scale :
       {Rational(99, 41), Rational(249, 100), Rational(1, 7), Rational(9)}) {
    expect_equal(found.changed(7, scale, {1, 2}), one_by_one.changed(7, scale, {1, 2}));
  }
}

TEST(SceneUnion, RefusesWhatIsNoScene) {
  EXPECT_EQ(refusal([] { SceneUnion({unit, {unit}, {{0, 0, {}}}}); }), "bad-scale");
  EXPECT_EQ(refusal([] { SceneUnion({unit, {unit}, {{1, 1, {}}}}); }), "no-shape");
  EXPECT_EQ(refusal([] { SceneUnion({point_set(0, 0), {point_set(1, 1)}, {}}); }), "no-area");
  const Scene segments{segment_set({0, 0}, {1, 0}), {segment_set({0, 0}, {1, 0})}, {}};
  EXPECT_EQ(refusal([&] { const SceneUnion found(segments); }), "no-area");
  const SceneUnion found(boxes({{0, 0}}));
  EXPECT_EQ(refusal([&] { found.removed(1); }), "no-copy");
  EXPECT_EQ(refusal([&] { found.passages(); }), "no-passages");
}

}  // namespace
}  // namespace minkref::testing::of_scene_unions
