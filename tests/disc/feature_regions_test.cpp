// Features' regions: the alpha-shape has the components and holes of the closed sum, and areas add
// up, at last to the convex hull's area.
#include "reference/disc/features/feature_regions.hpp"

#include <gtest/gtest.h>

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
  const Rational high = gap == index.radii() ? Rational(2 * low + 1) : Rational(radius(gap).lower());
  std::vector<Rational> found;
  for (int k = 1; k < 4; ++k) {
    const Rational at = from_double(to_double(low + (high - low) * k / 4));
    if (low < at && at < high) found.push_back(at);
  }
  return found;
}

void expect_counts(const PolygonSet& P, const DiscIndex& index, std::uint32_t gap) {
  for (const Rational& radius : inside(index, gap)) {
    const FeatureRegions found = feature_regions(index, radius * radius);
    const OffsetRegion sum = offset_region(P, radius * radius);
    ASSERT_EQ(found.components, sum.components.size()) << to_string(radius);
    ASSERT_EQ(found.holes, sum.holes) << to_string(radius);
    // Rings around holes of the alpha-shape run clockwise, those around components do not.
    const RegionOutlines outlines(index, found);
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
    const PolygonSet P = seed % 2 == 0 ? testing::random_region(random, 3)
                                       : testing::random_mesh_region(random, 3);
    const DiscIndex index(P);
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
    const PolygonSet P = seed % 2 == 0 ? testing::random_region(random, 4)
                                       : testing::random_mesh_region(random, 4);
    const DiscIndex index(P);
    const FeatureRegions found = feature_regions(index, std::nullopt);
    const RegionOutlines outlines(index, found);
    Rational sum = area(P);
    for (const FeatureRegion& feature : found.features) {
      const auto area = rational(region_area(outlines, feature).terms);
      ASSERT_TRUE(area);
      sum += *area;
    }
    EXPECT_EQ(2 * sum, doubled_area(testing::convex_hull(points_of(P))));
    EXPECT_EQ(found.components, 1);
    EXPECT_EQ(found.holes, 0);
  }
}

/// Components and area of the rest material.
std::pair<std::size_t, Interval> rest_of(const DiscIndex& index, const Rational& radius) {
  const FeatureRegions found = feature_regions(index, radius * radius);
  const RegionOutlines outlines(index, found);
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
  for (const auto& [radius, components] :
       std::vector<std::pair<Rational, std::size_t>>{{Rational(101, 100), 2},
                                                     {Rational(124, 100), 2},
                                                     {Rational(5, 4), 2},
                                                     {Rational(126, 100), 1},
                                                     {Rational(2), 1}}) {
    const auto found = rest_of(index, radius);
    EXPECT_EQ(found.first, components) << to_string(radius);
    std::cout << to_string(radius) << " " << found.second.lower() << "\n";
  }
}

}  // namespace
}  // namespace minkref::of_feature_regions
