// Tight passages of a scene: by their definition, at every place where one could be.
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/plane/boundary/set_operations.hpp"
#include "reference/plane/witness.hpp"
#include "reference/scene/scene_union.hpp"
#include "tests/scene/random_scenes.hpp"

namespace minkref::testing::of_scene_passages {
namespace {

using Line = std::pair<Point, Point>;

/// Obstacles with their places: copies, or beside a segment the components of their union.
struct Judge {
  explicit Judge(const Scene& scene) : reflected(scaled(scene.robot, -1)) {
    std::vector<PolygonSet> placed, sums;
    for (const Copy& copy : scene.copies)
      placed.push_back(translated(scaled(scene.shapes[copy.shape], copy.scale), copy.place));
    if (scene.robot.is_segment()) {
      const PolygonSet merged = combined(SetOperation::unite, placed).region;
      placed.clear();
      for (const Polygon& polygon : merged.polygons) placed.push_back({{polygon}});
    }
    for (const PolygonSet& obstacle : placed) {
      if (obstacle.empty()) continue;
      memberships.emplace_back(obstacle, reflected, 1);
      const Sum sum =
          minkowski_sum(obstacle, reflected, 1, Route::paper, "rational", Passages::find);
      sums.push_back(sum.region);
      add_lines(sum);
    }
    region = combined(SetOperation::unite, sums).region;
  }

  void add_lines(const Sum& sum) {
    for (const Polygon& polygon : sum.region.polygons) {
      std::vector<Ring> rings = polygon.holes;
      rings.push_back(polygon.outer);
      for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i)
          lines.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
      }
    }
    for (const TightPassage& piece : *sum.tight_passages) {
      nodes.push_back(piece.points[0]);
      for (std::size_t i = 0; i + 1 < piece.points.size(); ++i)
        lines.emplace_back(piece.points[i], piece.points[i + 1]);
    }
  }

  /// In the union's interior, and in no open sum.
  bool is_tight(const Point& x) const {
    if (where(region, x) != Where::inside) return false;
    return std::none_of(memberships.begin(), memberships.end(), [&](const Membership& membership) {
      return membership.contact(x) == Contact::overlapping;
    });
  }

  /// Nodes of all boundaries and passages, and middles between neighbouring nodes of a line.
  std::vector<Point> places() const {
    std::vector<Point> all = nodes;
    for (const auto& [a, b] : lines) {
      std::vector<Point> stops{a, b};
      for (const auto& [c, d] : lines) {
        const Point u = b - a, v = d - c;
        const Rational det = cross(u, v);
        if (sign(det) != 0) {
          const Rational t = cross(c - a, v) / det;
          const Point p{Rational(a.x + t * u.x), Rational(a.y + t * u.y)};
          if (on_segment(p, a, b) && on_segment(p, c, d)) stops.push_back(p);
        } else {
          for (const Point& p : {c, d}) {
            if (on_segment(p, a, b)) stops.push_back(p);
          }
        }
      }
      std::sort(stops.begin(), stops.end(), less_xy);
      for (std::size_t i = 0; i < stops.size(); ++i) {
        all.push_back(stops[i]);
        if (i > 0) all.push_back(midpoint(stops[i - 1], stops[i]));
      }
    }
    std::sort(all.begin(), all.end(), less_xy);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  PolygonSet reflected, region;
  std::vector<Membership> memberships;
  std::vector<Line> lines;
  std::vector<Point> nodes;
};

bool lies_on(const Point& x, const std::vector<ScenePassage>& passages) {
  return std::any_of(passages.begin(), passages.end(), [&](const ScenePassage& piece) {
    if (piece.points[0] == x) return true;
    for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
      if (on_segment(x, piece.points[i], piece.points[i + 1])) return true;
    }
    return false;
  });
}

void expect_passages(const Scene& scene, std::size_t& pieces, std::size_t& points) {
  const Judge judge(scene);
  const SceneUnion found(scene, true);
  const std::vector<ScenePassage>& passages = found.passages();
  for (const ScenePassage& piece : passages) {
    ++pieces;
    points += piece.points.size() == 1 ? 1 : 0;
    if (piece.points.size() == 1) {
      EXPECT_TRUE(judge.is_tight(piece.points[0]));
    }
    EXPECT_EQ(piece.owners.size(), std::max<std::size_t>(piece.points.size() - 1, 1));
    for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
      // Not at a node, most likely.
      const Point &a = piece.points[i], &b = piece.points[i + 1];
      const Rational t(37, 101);
      EXPECT_TRUE(judge.is_tight({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
    }
    for (const std::vector<Owner>& owners : piece.owners) EXPECT_FALSE(owners.empty());
  }
  for (const Point& x : judge.places()) {
    if (!judge.is_tight(x)) continue;
    EXPECT_TRUE(lies_on(x, passages)) << to_string(x.x) << " " << to_string(x.y);
  }
}

TEST(ScenePassages, AreAllTightPlacesAndNoOther) {
  Source random(21);
  std::size_t pieces = 0, points = 0;
  for (int k = 0; k < 150; ++k) {
    const Scene scene = k % 3 == 0 ? random_scene(random, false, 5) : lattice_scene(random);
    SCOPED_TRACE(text(scene));
    expect_passages(scene, pieces, points);
    if (HasFailure()) return;
  }
  EXPECT_GT(pieces, 40U);
  EXPECT_GT(points, 0U);
}

TEST(ScenePassages, OfASegmentAreThoseBesideMergedObstacles) {
  Source random(22);
  std::size_t pieces = 0, points = 0;
  for (int k = 0; k < 80; ++k) {
    const Scene scene = random_scene(random, true, 5);
    if (scene.robot.is_point()) continue;
    SCOPED_TRACE(text(scene));
    expect_passages(scene, pieces, points);
    if (HasFailure()) return;
  }
}

const PolygonSet unit = box(0, 0, 1, 1);

Scene scene_of(PolygonSet robot, PolygonSet shape, std::vector<Point> places) {
  Scene scene{std::move(robot), {std::move(shape)}, {}};
  for (Point& place : places) scene.copies.push_back({0, 1, std::move(place)});
  return scene;
}

std::size_t components(const SceneUnion& found, ContactRule rule) {
  return found.components(rule).count;
}

TEST(ScenePassages, AGapAsWideAsTheRobotIsOnePolyline) {
  const SceneUnion found(scene_of(unit, box(0, 0, 1, 5), {{0, 0}, {2, 0}}), true);
  ASSERT_EQ(found.passages().size(), 1U);
  EXPECT_EQ(found.passages()[0].points, (std::vector<Point>{{1, -1}, {1, 5}}));
}

TEST(ScenePassages, TwoRoomsBehindAGapHangTogetherByContact) {
  // A wall of four boxes round a room, with a gap as wide as the robot.
  Scene scene{unit, {box(0, 0, 5, 1), box(0, 0, 1, 5), box(0, 0, 1, 2)}, {}};
  scene.copies = {{0, 1, {0, 0}}, {0, 1, {0, 4}}, {1, 1, {0, 0}}, {2, 1, {4, 0}}, {2, 1, {4, 3}}};
  const SceneUnion found(scene, true);
  EXPECT_EQ(components(found, ContactRule::forbidden), 2U);
  EXPECT_EQ(components(found, ContactRule::allowed), 1U);
}

TEST(ScenePassages, ARoomThatTheRobotFitsExactlyIsAPoint) {
  const SceneUnion found(scene_of(unit, unit, {{0, 1}, {1, 2}, {2, 1}, {1, 0}}), true);
  ASSERT_EQ(found.passages().size(), 1U);
  EXPECT_EQ(found.passages()[0].points, (std::vector<Point>{{1, 1}}));
  EXPECT_EQ(components(found, ContactRule::forbidden), 1U);
  EXPECT_EQ(components(found, ContactRule::allowed), 2U);
}

TEST(ScenePassages, SeamsOfObstaclesAreBlockedForARobotWithoutArea) {
  const std::vector<Point> places{{0, 0}, {1, 0}};
  EXPECT_TRUE(SceneUnion(scene_of(point_set(0, 0), unit, places), true).passages().empty());
  EXPECT_TRUE(
      SceneUnion(scene_of(segment_set({0, 0}, {0, 1}), unit, places), true).passages().empty());
  const SceneUnion apart(scene_of(segment_set({0, 0}, {1, 0}), unit, {{0, 0}, {2, 0}}), true);
  EXPECT_EQ(apart.passages().size(), 1U);
}

TEST(ScenePassages, ACopysOwnPassageEndsWhereAnotherCovers) {
  // A corridor as wide as the robot, half of it filled by another copy.
  const PolygonSet corridor =
      region({{0, 0}, {1, 0}, {1, 5}, {2, 5}, {2, 0}, {3, 0}, {3, 6}, {0, 6}});
  Scene scene{unit, {corridor, box(0, 0, 3, 3)}, {{0, 1, {0, 0}}}};
  const std::vector<ScenePassage> alone = SceneUnion(scene, true).passages();
  scene.copies.push_back({1, 1, {0, 3}});
  const std::vector<ScenePassage> filled = SceneUnion(scene, true).passages();
  ASSERT_EQ(alone.size(), 1U);
  ASSERT_EQ(filled.size(), 1U);
  EXPECT_EQ(alone[0].points, (std::vector<Point>{{1, -1}, {1, 4}}));
  EXPECT_EQ(filled[0].points, (std::vector<Point>{{1, -1}, {1, 2}}));
}

}  // namespace
}  // namespace minkref::testing::of_scene_passages
