// Features' regions: the alpha-shape has the components and holes of the closed sum, and areas add
// up, at last to the convex hull's area.
#include "reference/disc/features/feature_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/disc/features/region_outlines.hpp"
#include "reference/disc/features/rest_measures.hpp"
#include "reference/disc/region/offset_region.hpp"
#include "tests/plane/random_polygons.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::of_feature_regions {
namespace {

std::vector<Point> points_of(const PolygonSet& P) {
  std::vector<Point> all;
  for (const Polygon& polygon : P.polygons) {
    all.insert(all.end(), polygon.outer.begin(), polygon.outer.end());
  }
  return all;
}

/// The rational number of terms without roots.
std::optional<Rational> rational(const RootTerms& terms) {
  if (terms.terms().empty()) return Rational(0);
  if (terms.terms().size() > 1 || !terms.terms().begin()->first.empty()) return std::nullopt;
  return terms.terms().begin()->second;
}

/// Radii inside a gap: a quarter, a half and three quarters of the way.
std::vector<Rational> inside(const DiscIndex& index, std::uint32_t gap) {
  const auto radius = [&](std::uint32_t number) {
    return index.diagram().radius(index.diagram().events[index.event_at(number)]);
  };
  const Rational low = gap == 0 ? Rational(0) : Rational(radius(gap - 1).upper());
  const Rational high =
      gap == index.radii() ? Rational(2 * low + 1) : Rational(radius(gap).lower());
  std::vector<Rational> found;
  for (int k = 1; k < 4; ++k) {
    const Rational at = from_double(to_double(low + (high - low) * k / 4));
    if (low < at && at < high) found.push_back(at);
  }
  return found;
}

void expect_counts(const PolygonSet& P, const DiscIndex& index, std::uint32_t gap) {
  const Bridges bridges(index);
  for (const Rational& radius : inside(index, gap)) {
    const FeatureRegions found = feature_regions(index, radius * radius);
    const OffsetRegion sum = offset_region(P, radius * radius);
    ASSERT_EQ(found.components, sum.components.size()) << to_string(radius);
    ASSERT_EQ(found.holes, sum.holes) << to_string(radius);
    // Rings around holes of the alpha-shape run clockwise, those around components do not.
    const RegionOutlines outlines(bridges, found);
    std::size_t holes = 0;
    Interval shape(0), regions(0);
    for (const PartRing& ring : found.parts.visible_rings) {
      const Interval area = ring_area(outlines, ring, false).bounds;
      holes += area.upper() < 0 ? 1 : 0;
      shape += area;
    }
    ASSERT_EQ(holes, sum.holes) << to_string(radius);
    for (const FeatureRegion& feature : found.features) {
      const Interval area = region_area(outlines, feature).bounds;
      ASSERT_GE(area.upper(), 0);
      regions += area;
    }
    ASSERT_TRUE((shape - regions - Interval(area(P))).contains_zero()) << to_string(radius);
  }
}

TEST(FeatureRegions, AlphaShapeHasTheCountsOfTheClosedSum) {
  for (unsigned seed = 0; seed < testing::repetitions(40U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P =
        seed % 2 == 0 ? testing::random_region(random, 3) : testing::random_mesh_region(random, 3);
    const DiscIndex index(P);
    const Bridges bridges(index);
    for (int k = 0; k < 6; ++k) {
      const auto gap =
          static_cast<std::uint32_t>(random.between(0, static_cast<int>(index.radii())));
      ASSERT_NO_FATAL_FAILURE(expect_counts(P, index, gap));
    }
  }
}

TEST(FeatureRegions, FillTheConvexHullAtInfinity) {
  for (unsigned seed = 0; seed < testing::repetitions(150U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P =
        seed % 2 == 0 ? testing::random_region(random, 4) : testing::random_mesh_region(random, 4);
    const DiscIndex index(P);
    const Bridges bridges(index);
    const FeatureRegions found = feature_regions(index, std::nullopt);
    const RegionOutlines outlines(bridges, found);
    Rational sum = area(P);
    for (const FeatureRegion& feature : found.features) {
      const auto area = rational(region_area(outlines, feature).terms);
      ASSERT_TRUE(area);
      sum += *area;
    }
    EXPECT_EQ(2 * sum, doubled_area(testing::convex_hull(points_of(P))));
    EXPECT_EQ(found.components, 1U);
    EXPECT_EQ(found.holes, 0U);
  }
}

/// Areas of chord tiles: a polygon of nearest points for each event, and for each part of the
/// diagram a quadrilateral between its chords at both ends.
class Tiles {
 public:
  Tiles(const DiscIndex& index, const FeatureRegions& found, const RegionOutlines& outlines)
      : index_(index), graph_(index.graph()), found_(found), outlines_(outlines) {}

  Interval area_of(const FeatureRegion& feature) const {
    const auto& events = index_.diagram().events;
    Interval sum(0);
    for (const std::uint32_t node : feature.nodes) {
      if (graph_.is_event(node)) sum += hull_of_feet(events[node]);
    }
    for (std::uint32_t k = 0; k < graph_.halves.size(); ++k) {
      const DiagramHalf& half = graph_.halves[k];
      const std::uint32_t low = index_.rises(k) ? half.from : half.to;
      if (half.twin < k || index_.low(k) > found_.radius.level) continue;
      if (!std::binary_search(feature.nodes.begin(), feature.nodes.end(), low)) continue;
      const std::uint32_t high = low == half.from ? half.to : half.from;
      const bool is_cut = index_.high(k) > found_.radius.level;
      const auto end = [&](std::uint32_t half_side, std::uint32_t node) {
        return is_cut && node == high ? near(outlines_.foot(half_side)) : foot_at(half_side, node);
      };
      sum += area(
          {end(k, half.from), end(k, half.to), end(half.twin, half.to), end(half.twin, half.from)});
    }
    return sum;
  }

 private:
  using Place = Vector<Interval>;

  static Place near(const RootPoint& p) { return {p.x.enclosure(), p.y.enclosure()}; }
  static Interval area(const std::vector<Place>& ring) {
    Interval doubled(0);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      doubled += cross(ring[i], ring[(i + 1) % ring.size()]);
    }
    return (approximate(doubled) < 0 ? -doubled : doubled) / Interval(2);
  }
  Place foot_below(std::uint32_t feature, const Place& at) const {
    const Site own = Site::of(index_.diagram().curves, feature);
    if (own.is_point) return numbers<Interval>(own.point);
    const Place along = turned(numbers<Interval>(own.normal));
    const Interval part = dot(along, at - numbers<Interval>(own.point)) / dot(along, along);
    return numbers<Interval>(own.point) + part * along;
  }
  Place foot_at(std::uint32_t half, std::uint32_t node) const {
    const DiagramHalf& own = graph_.halves[half];
    const DiagramEvents& diagram = index_.diagram();
    if (graph_.is_event(node)) return foot_below(own.feature, diagram.events[node].at);
    const BoundarySide& side = diagram.walks.sides[node == own.from ? own.from_side : own.to_side];
    const std::uint32_t vertex = node == own.from ? side.from : side.to;
    return numbers<Interval>(diagram.curves.features[vertex].centre);
  }
  Interval hull_of_feet(const DiagramEvent& event) const {
    std::vector<std::pair<double, Place>> feet;
    for (const std::uint32_t feature : event.features) {
      const Place foot = foot_below(feature, event.at), way = foot - event.at;
      feet.emplace_back(std::atan2(approximate(way.y), approximate(way.x)), foot);
    }
    std::sort(feet.begin(), feet.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Place> ring;
    for (const auto& [angle, foot] : feet) ring.push_back(foot);
    return area(ring);
  }

  const DiscIndex& index_;
  const DiagramGraph& graph_;
  const FeatureRegions& found_;
  const RegionOutlines& outlines_;
};

TEST(FeatureRegions, AreTiledByChords) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P =
        seed % 2 == 0 ? testing::random_region(random, 3) : testing::random_mesh_region(random, 3);
    const DiscIndex index(P);
    const Bridges bridges(index);
    const Rational factor = index.diagram().factor;
    for (int k = 0; k < 6; ++k) {
      const auto gap =
          static_cast<std::uint32_t>(random.between(0, static_cast<int>(index.radii())));
      for (const Rational& radius : inside(index, gap)) {
        const FeatureRegions found = feature_regions(index, radius * radius);
        const RegionOutlines outlines(bridges, found);
        const Tiles tiles(index, found, outlines);
        for (const FeatureRegion& feature : found.features) {
          const Interval area = Interval(factor * factor) * region_area(outlines, feature).bounds;
          const Interval other = tiles.area_of(feature);
          ASSERT_TRUE((area - other).contains_zero()) << area.lower() << " " << other.lower();
          ASSERT_LT(other.upper() - other.lower(), 1e-9);
        }
      }
    }
  }
}

TEST(FeatureRegions, AtTheRadiusOfAnEventAreThoseJustBelow) {
  // A slot of width 1: its flat ridge has the radius 1/2, and no region before.
  const PolygonSet P =
      testing::region({{0, 0}, {9, 0}, {9, 6}, {5, 6}, {5, 2}, {4, 2}, {4, 6}, {0, 6}});
  const DiscIndex index(P);
  const Bridges bridges(index);
  for (const auto& [radius, count, area] : std::vector<std::tuple<Rational, std::size_t, Rational>>{
           {Rational(1, 4), 2, Rational(1, 16)},
           {Rational(1, 2), 2, Rational(1, 4)},
           {Rational(3, 4), 1, Rational(4)}}) {
    const FeatureRegions found = feature_regions(index, radius * radius);
    const RegionOutlines outlines(bridges, found);
    EXPECT_EQ(found.features.size(), count);
    Rational sum = 0;
    for (const FeatureRegion& feature : found.features) {
      sum += rational(region_area(outlines, feature).terms).value();
    }
    EXPECT_EQ(sum, area) << to_string(radius);
  }
}

TEST(FeatureRegions, OfConvexSetsPointsAndSegmentsAreNone) {
  for (const PolygonSet& P :
       {testing::box(0, 0, 2, 1), testing::point_set(1, 2), testing::segment_set({0, 0}, {2, 1})}) {
    const DiscIndex index(P);
    const Bridges bridges(index);
    for (const auto& radius : {std::optional(Rational(3)), std::optional<Rational>()}) {
      const FeatureRegions found = feature_regions(index, radius);
      EXPECT_TRUE(found.features.empty());
      EXPECT_EQ(found.components, 1U);
      EXPECT_EQ(found.holes, 0U);
    }
  }
}

/// Components and area of the rest material.
std::pair<std::size_t, Interval> rest_of(const DiscIndex& index, const Rational& radius) {
  const Bridges bridges(index);
  const FeatureRegions found = feature_regions(index, radius * radius);
  const RegionOutlines outlines(bridges, found);
  const RestMaterial rest = rest_material(outlines);
  std::vector<std::size_t> all;
  std::size_t components = 0;
  for (std::size_t k = 0; k < rest.features.size(); ++k) {
    all.push_back(k);
    components += rest.features[k].components;
  }
  return {components, rest_area(outlines, rest, all)};
}

TEST(RestMaterial, FallsApartBetweenFlatTipsWithoutAnEvent) {
  using testing::region;
  const PolygonSet P = testing::together(
      region({{0, Rational(-1, 2)}, {0, Rational(1, 2)}, {-4, Rational(3)}, {-4, Rational(-3)}}),
      region({{2, Rational(-1, 2)}, {6, Rational(-3)}, {6, Rational(3)}, {2, Rational(1, 2)}}));
  const DiscIndex index(P);
  const Bridges bridges(index);
  for (const auto& [radius, components] :
       std::vector<std::pair<Rational, std::size_t>>{{Rational(101, 100), 2},
                                                     {Rational(124, 100), 2},
                                                     {Rational(5, 4), 2},
                                                     {Rational(126, 100), 1},
                                                     {Rational(2), 1}}) {
    const auto found = rest_of(index, radius);
    EXPECT_EQ(found.first, components) << to_string(radius);
    EXPECT_GT(found.second.lower(), 0);
  }
}

}  // namespace
}  // namespace minkref::of_feature_regions
