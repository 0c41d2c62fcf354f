// A lazy index answers as an index does, before it is built and afterwards, and builds when the
// static sums before have cost as much.
#include "reference/plane/index/lazy_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reference/error.hpp"
#include "reference/plane/index/rings_at_scale.hpp"
#include "tests/plane/index/windows.hpp"
#include "tests/plane/random_cases.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::testing::of_lazy_index {
namespace {

/// The vertices of a column with `per` integers each, as points.
std::vector<Point> points(const IntegerColumn& column, std::size_t per) {
  std::vector<Point> result;
  for (std::size_t k = 0; k < column.size(); k += per) {
    result.push_back(
        per == 3 ? Point{Rational(column[k], column[k + 2]), Rational(column[k + 1], column[k + 2])}
                 : Point{column.reduced(k), column.reduced(k + 2)});
  }
  return result;
}

/// Rings from their least points, sorted, each with its features.
std::vector<std::pair<Ring, RingFeatures>> sorted_rings(const RingShape& shape,
                                                        const std::vector<Point>& points) {
  const auto less = [](const Point& a, const Point& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  };
  std::vector<std::pair<Ring, RingFeatures>> result;
  std::size_t first = 0;
  for (std::size_t r = 0; r < shape.ring_ends.size(); ++r) {
    const auto at = [&](std::size_t k) { return points.begin() + static_cast<std::ptrdiff_t>(k); };
    Ring ring(at(first), at(shape.ring_ends[r]));
    first = shape.ring_ends[r];
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), less), ring.end());
    result.emplace_back(std::move(ring), shape.rings[r]);
  }
  std::sort(result.begin(), result.end(), [&](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.first.begin(), a.first.end(), b.first.begin(),
                                        b.first.end(), less);
  });
  return result;
}

/// Whether names stand for each other, one to one.
class Renaming {
 public:
  bool holds(std::uint32_t a, std::uint32_t b) {
    return there_.try_emplace(a, b).first->second == b &&
           back_.try_emplace(b, a).first->second == a;
  }

 private:
  std::map<std::uint32_t, std::uint32_t> there_, back_;
};

std::string difference(const std::vector<std::pair<Ring, RingFeatures>>& expected,
                       const std::vector<std::pair<Ring, RingFeatures>>& found) {
  if (expected.size() != found.size()) return "another number of rings";
  Renaming components, holes;
  if (!holes.holds(0, 0)) return "the outside";
  for (std::size_t r = 0; r < found.size(); ++r) {
    const RingFeatures &a = expected[r].second, &b = found[r].second;
    if (expected[r].first != found[r].first) return "another ring";
    if (a.is_hole != b.is_hole) return "a hole's ring is none";
    if (!components.holds(a.component, b.component)) return "another component";
    if (!holes.holds(a.hole, b.hole)) return "another hole";
  }
  return "";
}

/// Whether each side lies along the line and the direction of its edge.
bool sides_lie_on_edges(const Case& c, const Rational& scale, const RingShape& shape,
                        const std::vector<Point>& points,
                        const std::vector<ConvolutionEdge>& edges) {
  std::size_t first = 0;
  for (const std::uint32_t end : shape.ring_ends) {
    for (std::size_t k = first; k < end; ++k) {
      const Point &a = points[k], &b = points[k + 1 == end ? first : k + 1];
      const Segment below = at_scale(edges[shape.edges[k]], c.P, c.Q, scale);
      const Point d = below.end - below.start, side = b - a, to = a - below.start;
      if (d.x * side.y != d.y * side.x || d.x * to.y != d.y * to.x) return false;
      const Rational along = d.x * to.x + d.y * to.y;
      if (d.x * side.x + d.y * side.y <= 0 || along < 0 || along >= d.x * d.x + d.y * d.y) {
        return false;
      }
    }
    first = end;
  }
  return true;
}

TEST(LazyIndex, SingleSumsGiveTheRingsOfTheIndexInAllForms) {
  MINKREF_SEEDED(random, 940);
  expect_law(random, 60, [](const Case& c) -> std::string {
    const ScaleIndex index(c.P, c.Q, some_window(c));
    const auto edges = index.edges();
    for (const Rational& scale : telling_scales(index)) {
      const std::string where = " at " + to_string(scale);
      RationalRings expected, rational;
      index.rings(scale, expected);
      Statistics statistics;
      const PointRings found = rings_at_scale(c.P, c.Q, scale, statistics);
      const std::string fault = difference(sorted_rings(expected, points(expected.column(), 4)),
                                           sorted_rings(found, found.points));
      if (!fault.empty()) return fault + where;
      if (!sides_lie_on_edges(c, scale, found, found.points, edges)) return "an edge" + where;
      if (!found.points.empty() &&
          statistics.by_float + statistics.by_integer + statistics.by_rational == 0) {
        return "a sum without work" + where;
      }
      write_rings(found, rational);
      HomogeneousRings homogeneous;
      write_rings(found, homogeneous);
      RoundedRings rounded;
      write_rings(found, rounded);
      for (const RingShape* shape :
           {static_cast<const RingShape*>(&rational), static_cast<const RingShape*>(&homogeneous),
            static_cast<const RingShape*>(&rounded)}) {
        if (shape->ring_ends != found.ring_ends || shape->edges != found.edges) {
          return "another shape" + where;
        }
      }
      if (points(rational.column(), 4) != found.points) return "lowest terms" + where;
      if (points(homogeneous.column(), 3) != found.points) return "homogeneous" + where;
      for (std::size_t k = 0; k < found.points.size(); ++k) {
        const auto off = [&](double near, const Rational& exact) {
          return near != to_double(exact) || abs(from_double(near) - exact) > rounded.error;
        };
        if (off(rounded.x[k], found.points[k].x) || off(rounded.y[k], found.points[k].y)) {
          return "doubles" + where;
        }
      }
    }
    return "";
  });
}

const PolygonSet square = region(rectangle(0, 0, 1, 1));
const PolygonSet frame = region(rectangle(0, 0, 6, 6), {rectangle(1, 1, 4, 4)});

TEST(LazyIndex, BuildsWhenSingleSumsHaveCostAsMuch) {
  const LazyIndex lazy(frame, frame, {Rational(1, 2), 5});
  const ScaleIndex index(frame, frame, {Rational(1, 2), 5});
  EXPECT_EQ(lazy.price(), 0U);
  int sums = 0;
  for (std::uint64_t before = 0; !lazy.is_built(); ++sums) {
    ASSERT_LT(sums, 100000);
    const Rational scale(sums % 9 + 2, 4);
    const Sum found = lazy.sum(scale);
    EXPECT_EQ(found.region, index.sum(scale).region) << scale;
    if (lazy.is_built()) {
      EXPECT_GE(lazy.work(), lazy.price());
      EXPECT_EQ(lazy.work(), before);  // the index has answered
    } else {
      EXPECT_GT(lazy.work(), before);
    }
    before = lazy.work();
  }
  EXPECT_GT(sums, 2);
  EXPECT_EQ(lazy.sum(3).region, index.sum(3).region);
  EXPECT_EQ(lazy.features(3).holes, index.features(3).holes);
}

TEST(LazyIndex, BuildsAtOnceForManyQuestions) {
  const LazyIndex lazy(frame, square, {Rational(1, 2), 5});
  lazy.expect(1000000);
  EXPECT_FALSE(lazy.is_built());  // the price of a sum is not known
  RoundedRings rings;
  lazy.rings(1, rings);
  lazy.expect(1);
  EXPECT_FALSE(lazy.is_built());
  lazy.expect(1000000);
  EXPECT_TRUE(lazy.is_built());
}

TEST(LazyIndex, TracksAreOfTheIndex) {
  const LazyIndex lazy(frame, square, {Rational(1, 2), 5});
  TrackRings rings;
  lazy.rings(2, rings);
  EXPECT_TRUE(lazy.is_built());
  EXPECT_EQ(rings.tracks.size(), 8U);
}

TEST(LazyIndex, RefusesWhatAnIndexRefuses) {
  EXPECT_THROW(LazyIndex(point_set(0, 0), point_set(1, 1), {}), BadInput);
  EXPECT_THROW(LazyIndex(frame, square, {2, 1}), BadInput);
  const LazyIndex lazy(frame, square, {1, 2});
  RoundedRings rings;
  for (const Rational& scale : {Rational(1, 2), Rational(3), Rational(0)}) {
    EXPECT_THROW(lazy.rings(scale, rings), BadInput);
    EXPECT_THROW((void)lazy.sum(scale), BadInput);
    EXPECT_THROW((void)lazy.features(scale), BadInput);
  }
}

TEST(LazyIndex, SingleSumsGoOnWhereMemoryEndsTheBuild) {
  BuildOptions options;
  options.memory_limit = 1;
  const LazyIndex lazy(frame, frame, {Rational(1, 2), 5}, options);
  (void)lazy.sum(1);
  const std::uint64_t price = lazy.price();
  lazy.expect(1000000);
  EXPECT_FALSE(lazy.is_built());
  EXPECT_GE(lazy.price(), 2 * price);
  EXPECT_EQ(lazy.sum(2).region, minkowski_sum(frame, frame, 2).region);
  EXPECT_THROW((void)lazy.index(), LimitExceeded);
}

TEST(LazyIndex, NothingHasNoPrice) {
  const LazyIndex lazy({}, frame, {});
  EXPECT_TRUE(lazy.sum(1).region.empty());
  lazy.expect(1000000);
  EXPECT_FALSE(lazy.is_built());
}

}  // namespace
}  // namespace minkref::testing::of_lazy_index
