// An index of changed operands is the same as a new one, and looks at what changed only.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "tests/plane/index/windows.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::testing::of_index_update {
namespace {

template <class T>
bool same_bytes(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}
bool same_bytes(const IntegerColumn& a, const IntegerColumn& b) {
  return a.words == b.words && same_bytes(a.data, b.data);
}

/// The first column to differ, by name, or nothing.
std::string difference(const ScaleIndex& one, const ScaleIndex& other) {
  const IndexColumns &a = one.columns(), &b = other.columns();
#define MINKREF_COMPARE(column) \
  if (!same_bytes(a.column, b.column)) return #column
  MINKREF_COMPARE(window);
  MINKREF_COMPARE(rings_of_P);
  MINKREF_COMPARE(rings_of_Q);
  MINKREF_COMPARE(coordinates_of_P);
  MINKREF_COMPARE(coordinates_of_Q);
  MINKREF_COMPARE(edges);
  MINKREF_COMPARE(directions);
  MINKREF_COMPARE(events);
  MINKREF_COMPARE(events_in_doubles);
  MINKREF_COMPARE(tracks);
  MINKREF_COMPARE(tracks_in_doubles);
  MINKREF_COMPARE(links);
  MINKREF_COMPARE(bucket_of);
  MINKREF_COMPARE(buckets);
  MINKREF_COMPARE(entries);
  MINKREF_COMPARE(ring_ends);
  MINKREF_COMPARE(ring_features);
  MINKREF_COMPARE(areas);
  MINKREF_COMPARE(feature_counts);
  MINKREF_COMPARE(merged);
  MINKREF_COMPARE(pieces);
  MINKREF_COMPARE(at_events);
  MINKREF_COMPARE(holes);
  MINKREF_COMPARE(components);
  MINKREF_COMPARE(topology);
  MINKREF_COMPARE(boundary);
  MINKREF_COMPARE(lists);
  MINKREF_COMPARE(places);
#undef MINKREF_COMPARE
  return a.counts.pieces == b.counts.pieces && one.bytes() == other.bytes() ? "" : "counts";
}

Ring& some_ring(Source& random, PolygonSet& set) {
  Polygon& polygon = set.polygons[random.below(set.polygons.size())];
  const std::size_t k = random.below(polygon.holes.size() + 1);
  return k == 0 ? polygon.outer : polygon.holes[k - 1];
}

/// A change that is local as a rule; the result may be no set.
PolygonSet some_change(Source& random, PolygonSet set) {
  Polygon& polygon = set.polygons[random.below(set.polygons.size())];
  Ring& ring = some_ring(random, set);
  const std::size_t k = random.below(ring.size()), next = (k + 1) % ring.size();
  const auto at = [&](auto& list, std::size_t i) {
    return list.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const Point step{Rational(random.between(-4, 4), random.between(1, 3)),
                   Rational(random.between(-4, 4), random.between(1, 3))};
  switch (random.below(11)) {
    case 0:  // a vertex moved
    case 1:
      ring[k] = ring[k] + step;
      break;
    case 2: {  // onto the line of an edge
      const Ring& other = some_ring(random, set);
      const Point a = other[0], b = other[1];
      const Rational t(random.between(-2, 4), 2);
      ring[k] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      break;
    }
    case 3:  // a vertex more, straight or not
      ring.insert(at(ring, next), {(ring[k].x + ring[next].x) / 2 + (random.coin() ? step.x : 0),
                                   (ring[k].y + ring[next].y) / 2});
      break;
    case 4:
      ring.erase(at(ring, k));
      break;
    case 5: {  // a hole or a component more
      const Point c = ring[k] + step;
      Ring fresh{c, {c.x + 1, c.y}, {c.x + 1, c.y + Rational(random.between(1, 3), 2)}};
      if (random.coin()) {
        polygon.holes.push_back(std::move(fresh));
      } else {
        set.polygons.push_back({std::move(fresh), {}});
      }
      break;
    }
    case 6:  // a hole or a component less
      if (!polygon.holes.empty()) {
        polygon.holes.pop_back();
      } else if (set.polygons.size() > 1) {
        set.polygons.pop_back();
      }
      break;
    case 7:  // a hole moved, often until it touches
      if (!polygon.holes.empty()) {
        Ring& hole = polygon.holes.back();
        const Point by = random.coin() ? step : Point{ring[k].x - hole[0].x, ring[k].y - hole[0].y};
        for (Point& p : hole) p = p + by;
      }
      break;
    case 8:  // a ring that begins elsewhere, and a vertex moved
      std::rotate(ring.begin(), at(ring, k), ring.end());
      ring[0].x += Rational(1, 5);
      break;
    case 9:  // other polygons first
      std::reverse(set.polygons.begin(), set.polygons.end());
      break;
    default:  // long numbers
      ring[k].y += Rational(1, 1'000'003);
  }
  orient(set);
  return set;
}

PolygonSet changed(Source& random, const PolygonSet& set) {
  for (int tries = 0; tries < 200; ++tries) {
    PolygonSet next = some_change(random, set);
    if (next.is_region() && next != set && is_valid(next)) return next;
  }
  return set;
}

/// Regions side by side beside a small one, in a window with a lower bound.
Case spread_out(Source& random) {
  PolygonSet P;
  for (int k = 0; k < 5; ++k) P = together(P, shifted(random_region(random), {80 * k, 7 * k}));
  return {P, stretched(random_region(random, 2), Rational(1, 4)), random.between(2, 4)};
}

std::uint64_t reused = 0, rebuilt = 0;

/// Makes ten changes in a row, each to P or to Q.
void expect_same(Source& random, int count, Case (*make)(Source&)) {
  expect_law(random, count, make, [&](const Case& c) -> std::string {
    if (!c.P.is_region() || !c.Q.is_region()) return "";
    const ScaleWindow window = some_window(c);
    ScaleIndex index(c.P, c.Q, window);
    PolygonSet P = c.P, Q = c.Q;
    for (int step = 0; step < 10; ++step) {
      PolygonSet& of = random.below(4) == 0 ? Q : P;
      of = changed(random, of);
      index = index.updated(P, Q);
      const ScaleIndex fresh(P, Q, window);
      const std::string other = difference(index, fresh);
      if (!other.empty()) return "step " + std::to_string(step) + ": " + other + text(P) + text(Q);
      reused += index.reuse().reused;
      rebuilt += index.reuse().rebuilt;
    }
    const std::vector<Rational> scales = telling_scales(index);
    const Rational& scale = scales[random.below(scales.size())];
    return fault_of_sum(P, Q, scale, index.sum(scale));
  });
}

TEST(IndexUpdate, IsANewIndexForOperandsOfAllKinds) {
  MINKREF_SEEDED(random, 980);
  expect_same(random, 12, random_case);
}

TEST(IndexUpdate, IsANewIndexWhereChangesAreFarFromTheRest) {
  MINKREF_SEEDED(random, 981);
  reused = rebuilt = 0;
  expect_same(random, 12, spread_out);
  EXPECT_GT(reused, rebuilt);
}

TEST(IndexUpdate, IsANewIndexForLatticePieces) {
  MINKREF_SEEDED(random, 982);
  expect_same(random, 10, [](Source& source) { return lattice_pieces(4, 1)(source); });
}

PolygonSet comb(int teeth) {
  Ring ring{{0, 0}, {8 * teeth, 0}};
  for (int k = teeth - 1; k >= 0; --k) {
    ring.insert(ring.end(),
                {{8 * k + 4, 3}, {8 * k + 3, 40 + k % 5}, {8 * k + 1, 40 + k % 3}, {8 * k, 3}});
  }
  return {{{ring, {}}}};
}
PolygonSet grid_of_holes(int side) {
  PolygonSet set = box(0, 0, 10 * side, 10 * side);
  for (int x = 3; x < 10 * side; x += 10) {
    for (int y = 3; y < 10 * side; y += 10) {
      set.polygons[0].holes.push_back({{x, y}, {x + 1, y + 4}, {x + 4, y + 5}, {x + 4, y}});
    }
  }
  return set;
}
PolygonSet kite() { return region({{0, 0}, {2, 0}, {3, 1}, {1, 2}}); }

const ScaleWindow around_one{Rational(1, 2), Rational(2)};

/// The counts of an update.
ScaleIndex::Reuse work(const PolygonSet& P, const PolygonSet& changed) {
  const ScaleIndex::Reuse did = ScaleIndex(P, kite(), around_one).updated(changed, kite()).reuse();
  EXPECT_GT(did.reused, 10 * did.rebuilt);
  return did;
}

TEST(IndexUpdate, LooksAtAsMuchInOperandsOfAnySize) {
  std::vector<ScaleIndex::Reuse> of_combs, of_holes;
  for (const int size : {1, 2, 4}) {
    PolygonSet P = comb(60 * size), next = P;
    next.polygons[0].outer[static_cast<std::size_t>(2 + 4 * 30 + 2)].y += Rational(1, 2);
    of_combs.push_back(work(P, next));
    P = next = grid_of_holes(6 * size);
    next.polygons[0].holes.erase(next.polygons[0].holes.begin() + 6 * size * 3 + 2);
    of_holes.push_back(work(P, next));
  }
  for (const auto& all : {of_combs, of_holes}) {
    EXPECT_GT(all[2].reused, 3 * all[0].reused);
    EXPECT_EQ(all[2].rebuilt, all[0].rebuilt);
    EXPECT_EQ(all[2].faces, all[0].faces);
    EXPECT_LE(all[2].pairs, 2 * all[0].pairs + 64);  // blocks of edges are cut elsewhere
  }
}

TEST(IndexUpdate, IsTheSameByAnyNumberOfThreads) {
  PolygonSet P = comb(20), next = P;
  next.polygons[0].outer[40].x += Rational(1, 3);
  const ScaleIndex before(P, kite(), around_one);
  BuildOptions options;
  options.threads = 3;
  EXPECT_EQ(difference(before.updated(next, kite()), before.updated(next, kite(), options)), "");
}

TEST(IndexUpdate, IsBuiltAnewFromAFileOrWhereAllPatchesMeet) {
  PolygonSet P = comb(8), next = P;
  next.polygons[0].outer[9].x += Rational(1, 3);
  const auto path = std::filesystem::temp_directory_path() /
                    ("minkref_update_" + std::to_string(::getpid()) + ".index");
  ScaleIndex(P, kite(), around_one).save(path);
  const ScaleIndex opened = ScaleIndex::open(path);
  std::filesystem::remove(path);
  const ScaleIndex updated = opened.updated(next, kite());
  EXPECT_EQ(difference(updated, ScaleIndex(next, kite(), around_one)), "");
  EXPECT_EQ(updated.reuse().reused, 0U);
  EXPECT_EQ(opened.reuse().rebuilt, 0U);
  const ScaleIndex all(P, kite(), {});
  EXPECT_EQ(all.updated(next, kite()).reuse().reused, 0U);
  EXPECT_EQ(difference(all.updated(next, kite()), ScaleIndex(next, kite(), {})), "");
  // A segment may stay, beside a region with a local change, but not change itself.
  const PolygonSet segment = segment_set({0, 0}, {1, 2});
  const ScaleIndex thin(P, segment, around_one);
  EXPECT_GT(thin.updated(next, segment).reuse().reused, 0U);
  EXPECT_EQ(difference(thin.updated(next, segment), ScaleIndex(next, segment, around_one)), "");
  EXPECT_EQ(difference(thin.updated(P, kite()), ScaleIndex(P, kite(), around_one)), "");
  EXPECT_EQ(difference(thin.updated({}, segment), ScaleIndex({}, segment, around_one)), "");
  EXPECT_EQ(difference(thin.updated(P, segment), thin), "");
}

TEST(IndexUpdate, EndsByAnInterruptOrTheMemoryLimitAndLeavesTheIndex) {
  PolygonSet P = comb(20), next = P;
  next.polygons[0].outer[40].x += Rational(1, 3);
  const ScaleIndex before(P, kite(), around_one);
  BuildOptions options;
  options.memory_limit = 1;
  EXPECT_THROW(before.updated(next, kite(), options), LimitExceeded);
  struct Interrupted {};
  {
    const Interruptible interruptible([] { throw Interrupted{}; });
    EXPECT_THROW(before.updated(next, kite()), Interrupted);
  }
  EXPECT_EQ(difference(before, ScaleIndex(P, kite(), around_one)), "");
  EXPECT_EQ(difference(before.updated(next, kite()), ScaleIndex(next, kite(), around_one)), "");
}

}  // namespace
}  // namespace minkref::testing::of_index_update
