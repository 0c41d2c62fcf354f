// What is read off the index is the sum.
#include "reference/scalespace/scale_space_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/error.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing {
namespace {

/// All events, a scale in each interval between two, and beyond the last ones.
std::vector<Rational> telling_scales(const ScaleSpaceIndex& index) {
  const std::vector<Rational>& events = index.boundary().events;
  std::vector<Rational> scales;
  for (std::size_t k = 0; k < events.size(); ++k) {
    scales.push_back(events[k]);
    if (k + 1 < events.size()) scales.push_back((events[k] + events[k + 1]) / 2);
  }
  const ScaleWindow& window = index.window();
  const Rational first = events.empty() ? window.to.value_or(Rational(2)) : events.front(),
                 last = events.empty() ? window.from.value_or(Rational(1)) : events.back();
  scales.push_back(window.from ? (*window.from + first) / 2 : first / 2);
  scales.push_back(window.to ? (*window.to + last) / 2 : last * 2);
  if (window.from) scales.push_back(*window.from);
  if (window.to) scales.push_back(*window.to);
  return scales;
}

ScaleWindow some_window(const Case& c) {
  if (c.scale == 1) return {};
  if (c.scale == 2) return {Rational(1, 3), std::nullopt};
  return {c.scale / 2, c.scale * 3};
}

TEST(ScaleSpaceIndex, GivesTheSumAtAndBetweenAllEvents) {
  MINKREF_SEEDED(random, 920);
  expect_law(random, 60, [](const Case& c) -> std::string {
    const ScaleSpaceIndex index(c.P, c.Q, some_window(c));
    for (const Rational& scale : telling_scales(index)) {
      const Sum found = index.sum(scale), expected = minkowski_sum(c.P, c.Q, scale);
      if (found.region == expected.region && found.components == expected.components &&
          found.holes == expected.holes) {
        continue;
      }
      return "at scale " + to_string(scale) + ": " + unequal(expected.region, found.region);
    }
    return "";
  });
}

std::vector<std::pair<double, double>> vertices(const PolygonSet& set) {
  std::vector<std::pair<double, double>> result;
  const auto add = [&](const Ring& ring) {
    for (const Point& p : ring) result.emplace_back(to_double(p.x), to_double(p.y));
  };
  for (const Polygon& polygon : set.polygons) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return result;
}

TEST(ScaleSpaceIndex, RingsInDoublesAreThoseOfTheSumWithinTheirError) {
  MINKREF_SEEDED(random, 921);
  expect_law(random, 60, [](const Case& c) -> std::string {
    const ScaleSpaceIndex index(c.P, c.Q, some_window(c));
    RoundedRings rings;
    for (const Rational& scale : telling_scales(index)) {
      const auto place = index.place(scale);
      const ScaleWindow& window = index.window();
      if (place.at_event || scale == window.from || scale == window.to) continue;
      index.rings(place.interval, to_double(scale), rings);
      const Sum sum = minkowski_sum(c.P, c.Q, scale);
      const auto expected = vertices(sum.region);
      if (expected.size() != rings.x.size()) {
        return "at scale " + to_string(scale) + ": " + std::to_string(rings.x.size()) +
               " vertices, not " + std::to_string(expected.size());
      }
      if (rings.ring_ends.size() != sum.region.rings()) return "other rings";
      for (const auto& [x, y] : expected) {
        bool found = false;
        for (std::size_t k = 0; k < rings.x.size(); ++k) {
          found = found || (std::fabs(rings.x[k] - x) <= rings.error + std::fabs(x) * 0x1p-52 &&
                            std::fabs(rings.y[k] - y) <= rings.error + std::fabs(y) * 0x1p-52);
        }
        if (!found) return "at scale " + to_string(scale) + ": a vertex is missing";
      }
      double area = 0;
      for (std::size_t ring = 0, first = 0; ring < rings.ring_ends.size(); ++ring) {
        const std::size_t end = rings.ring_ends[ring];
        for (std::size_t k = first; k < end; ++k) {
          const std::size_t next = k + 1 == end ? first : k + 1;
          area += (rings.x[k] * rings.y[next] - rings.y[k] * rings.x[next]) / 2;
        }
        first = end;
      }
      if (std::fabs(area - to_double(minkref::area(sum))) > 1e-9 * (1 + std::fabs(area))) {
        return "at scale " + to_string(scale) + ": the rings enclose another area";
      }
    }
    return "";
  });
}

TEST(ScaleSpaceIndex, HoldsNoScaleOutsideItsWindow) {
  const ScaleSpaceIndex index(box(0, 0, 1, 1), box(0, 0, 2, 1), {Rational(1, 2), Rational(3)});
  EXPECT_THROW(index.sum(Rational(1, 3)), BadInput);
  EXPECT_THROW(index.sum(4), BadInput);
  EXPECT_THROW(index.sum(0), BadInput);
  EXPECT_EQ(index.sum(3).region, minkowski_sum(box(0, 0, 1, 1), box(0, 0, 2, 1), 3).region);
}

}  // namespace
}  // namespace minkref::testing
