// Radii at which two offset features start or stop to share points: between two of them, and at
// each, the features share as many points as the list says, counted on curves that stand still.
#include "reference/disc/pairs/pair_events.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/plane/random_polygons.hpp"

namespace minkref::of_pair_events {
namespace {

constexpr int all_of_a_segment = FeatureEvent::segment;

/// Whether a feature holds a point of its line or circle, given relative to the feature's first
/// point of P.
bool is_on(const OffsetFeature& f, const RootPoint& from_first) {
  if (f.is_arc) {
    return sign(cross(numbers<RootNumber>(f.way[0]), from_first)) >= 0 &&
           sign(cross(from_first, numbers<RootNumber>(f.way[1]))) >= 0;
  }
  const Direction along = from_to(f.at[0], f.at[1]);
  const RootNumber part = dot(numbers<RootNumber>(along), from_first);
  return sign(part) >= 0 && sign(part - RootNumber(dot(along, along))) <= 0;
}

int count_on_both(const OffsetFeature& a, const OffsetFeature& b,
                  const std::vector<RootPoint>& from_a) {
  const RootPoint way = numbers<RootNumber>(from_to(b.at[0], a.at[0]));
  int count = 0;
  for (const RootPoint& x : from_a) count += is_on(a, x) && is_on(b, x + way) ? 1 : 0;
  return count;
}

int shared_by_parallel(const OffsetFeature& a, const OffsetFeature& b, const Rational& square) {
  const Direction &n = a.way[0], &m = b.way[0], along = from_to(a.at[0], a.at[1]);
  const RootNumber k = sqrt(RootNumber(square * dot(n, n)));  // ρ times the length of a
  const Rational gap = dot(n, from_to(a.at[0], b.at[0]));
  const RootNumber moved = dot(n, m) > 0 ? RootNumber(0) : RootNumber(2) * k;
  if (sign(moved - RootNumber(gap)) != 0) return 0;
  Rational low = dot(along, from_to(a.at[0], b.at[0])),
           high = dot(along, from_to(a.at[0], b.at[1]));
  if (low > high) std::swap(low, high);
  low = std::max(low, Rational(0));
  high = std::min(high, dot(along, along));
  if (low > high) return 0;
  return low == high ? 1 : all_of_a_segment;
}

/// The points shared by two features at a radius, with that radius squared given: the curves stand
/// still.
int shared(const OffsetFeature& a, const OffsetFeature& b, const Rational& square) {
  if (b.is_arc && !a.is_arc) return shared(b, a, square);
  const Direction w = from_to(a.at[0], b.at[0]);
  if (!a.is_arc) {
    const Direction &n = a.way[0], &m = b.way[0];
    const Rational turn = cross(n, m);
    if (turn == 0) return shared_by_parallel(a, b, square);
    const RootNumber c = sqrt(RootNumber(square * dot(n, n)));
    const RootNumber own = sqrt(RootNumber(square * dot(m, m)).in(c.field()));
    const RootNumber d = RootNumber(dot(m, w)) + own, inverse(Rational(1 / turn));
    const RootPoint x{inverse * (c * RootNumber(m.y) - d * RootNumber(n.y)),
                      inverse * (RootNumber(n.x) * d - RootNumber(m.x) * c)};
    return count_on_both(a, b, {x});
  }
  Direction foot, across;  // of places foot ± √left across
  if (b.is_arc) {
    const Rational length = dot(w, w);
    if (length == 0 || square < length / 4) return 0;
    foot = {w.x / 2, w.y / 2};
    across = turned(w);
    const RootNumber root = sqrt(RootNumber((square - length / 4) / length));
    const RootPoint f = numbers<RootNumber>(foot), t = numbers<RootNumber>(across);
    if (sign(root) == 0) return count_on_both(a, b, {f});
    return count_on_both(a, b, {f + root * t, f - root * t});
  }
  const Direction &n = b.way[0], along = from_to(b.at[0], b.at[1]);
  const Rational length = dot(n, n);
  const RootNumber level = RootNumber(dot(n, w)) + sqrt(RootNumber(square * length));
  const RootNumber left = RootNumber(square * length) - level * level;
  const RootNumber part(Rational(1 / length));
  const RootPoint f = (level * part) * numbers<RootNumber>(n), t = numbers<RootNumber>(along);
  if (sign(left) < 0) return 0;
  if (sign(left) == 0) return count_on_both(a, b, {f});
  const RootNumber root = part * sqrt(left);
  return count_on_both(a, b, {f + root * t, f - root * t});
}

struct Numbers {
  std::size_t events = 0, at_radii = 0, gaps = 0;
  std::map<std::string, std::size_t> changes;
};

/// Compares the whole event list of one pair with the count.
void check_pair(const OffsetFeature& a, const OffsetFeature& b, Numbers& numbers) {
  const FeatureNumbers<Interval> near_a(a), near_b(b);
  FeaturePair pair(a, b, near_a, near_b);
  const std::vector<FeatureEvent> events = pair.events();
  std::vector<Interval> squares;
  for (const FeatureEvent& event : events) {
    const MpfrInterval tight = pair.squared_radius(event.contacts[0]).enclosure(200);
    squares.emplace_back(Interval(tight.low()).lower(), Interval(tight.high()).upper());
    ++numbers.events;
    ++numbers.changes[std::string(name(event.change))];
    ASSERT_TRUE(event.meets());
    ASSERT_NE(event.change, PairChange::none);
    const RootNumber square = pair.squared_radius(event.contacts[0]);
    if (square.field()->roots() > 0) continue;
    ++numbers.at_radii;
    ASSERT_EQ(shared(a, b, square.coefficients()[0]), event.at);
  }
  for (std::size_t k = 0; k <= events.size(); ++k) {
    const Rational low = k == 0 ? Rational(0) : Rational(squares[k - 1].upper());
    const Rational high = k == events.size() ? low * 4 + 50 : Rational(squares[k].lower());
    ASSERT_LT(low, high);
    int count = 0;
    if (k > 0) {
      count = events[k - 1].after;
    } else if (!events.empty()) {
      count = events[0].before;
    } else {
      count = shared(a, b, Rational(1, 1000));  // the same at every radius
    }
    for (const int part : {1, 20, 39}) {
      ++numbers.gaps;
      ASSERT_EQ(shared(a, b, low + (high - low) * part / 40), count) << "gap " << k;
    }
    if (k > 0 && k < events.size()) {
      ASSERT_EQ(events[k - 1].after, events[k].before);
    }
  }
}

Numbers check_all(const PolygonSet& P) {
  Numbers numbers;
  const std::vector<OffsetFeature> features = offset_features(offset_curves(P));
  for (std::size_t a = 0; a < features.size(); ++a) {
    for (std::size_t b = a + 1; b < features.size(); ++b) {
      SCOPED_TRACE("features " + std::to_string(a) + " and " + std::to_string(b));
      check_pair(features[a], features[b], numbers);
      if (::testing::Test::HasFatalFailure()) return numbers;
    }
  }
  return numbers;
}

/// An arc between two normals.
OffsetFeature arc(const Point& centre, const Direction& first, const Direction& last) {
  return OffsetFeature::arc(centre, turned(first), turned(last));
}

/// "radius²: before-at-after change; ..."
std::string told(const OffsetFeature& a, const OffsetFeature& b) {
  const FeatureNumbers<Interval> near_a(a), near_b(b);
  FeaturePair pair(a, b, near_a, near_b);
  std::string text;
  for (const FeatureEvent& event : pair.events()) {
    const RootNumber square = pair.squared_radius(event.contacts[0]);
    text += text.empty() ? "" : "; ";
    text += square.field()->roots() == 0 ? to_string(square.coefficients()[0]) : "root";
    for (const int count : {event.before, event.at, event.after}) {
      text += " " + (count == all_of_a_segment ? "segment" : std::to_string(count));
    }
    text += " " + std::string(name(event.change));
  }
  Numbers numbers;
  check_pair(a, b, numbers);
  return text;
}

TEST(DiscPairEvents, OfEdgesByHand) {
  const auto edge = OffsetFeature::edge;
  EXPECT_EQ(told(edge({0, 0}, {10, 0}), edge({10, 0}, {10, 10})), "");  // about a convex vertex
  EXPECT_EQ(told(edge({20, 10}, {10, 10}), edge({10, 10}, {10, 20})), "100 1 1 0 death");
  EXPECT_EQ(told(edge({3, 8}, {-7, 8}), edge({-4, 5}, {-12, 11})),
            "9 0 1 1 birth; 225 1 1 0 death");
  EXPECT_EQ(told(edge({0, 10}, {10, 10}), edge({-10, 0}, {-10, 5})), "100 0 1 0 touch");
}

TEST(DiscPairEvents, OfParallelEdgesByHand) {
  const auto edge = OffsetFeature::edge;
  EXPECT_EQ(told(edge({8, 6}, {8, 2}), edge({4, 2}, {4, 6})), "4 0 segment 0 overlap");
  EXPECT_EQ(told(edge({8, 6}, {8, 2}), edge({4, 6}, {4, 9})), "4 0 1 0 touch");
  EXPECT_EQ(told(edge({8, 6}, {8, 2}), edge({4, 7}, {4, 9})), "");
  EXPECT_EQ(told(edge({12, 6}, {8, 6}), edge({4, 6}, {0, 6})), "");
  EXPECT_EQ(told(edge({4, 2}, {4, 6}), edge({8, 6}, {8, 2})), "4 0 segment 0 overlap");
  EXPECT_EQ(told(edge({4, 6}, {4, 2}), edge({8, 2}, {8, 6})), "");  // back to back
}

TEST(DiscPairEvents, OfArcsByHand) {
  EXPECT_EQ(told(arc({0, 0}, {3, -4}, {4, 3}), arc({6, 0}, {-3, 4}, {0, -1})),
            "9 0 1 2 birth; 225/16 2 2 1 death; 25 1 1 0 death");
  // Both arcs end halfway, on the same side, then on opposite sides.
  EXPECT_EQ(told(arc({0, 0}, {0, -1}, {1, 0}), arc({6, 0}, {-1, 0}, {0, -1})), "9 0 1 1 birth");
  EXPECT_EQ(told(arc({0, 0}, {0, -1}, {1, 0}), arc({6, 0}, {0, 1}, {-1, 0})), "9 0 1 0 touch");
}

/// P lies below the floor: the arc looks down at the floor growing towards it.
TEST(DiscPairEvents, OfAnArcAndAnEdgeByHand) {
  const OffsetFeature floor = OffsetFeature::edge({9, 0}, {-9, 0});
  // They touch half way. To the right the arc ends when its end is as high as the line.
  EXPECT_EQ(told(arc({0, 2}, {-1, 0}, {3, -4}), floor),
            "1 0 1 2 birth; 100/81 2 2 1 death; "
            "4 1 1 0 death");
  EXPECT_EQ(told(arc({0, 0}, {-1, 0}, {3, -4}), floor), "");   // on the line
  EXPECT_EQ(told(arc({0, -2}, {-1, 0}, {3, -4}), floor), "");  // behind it
  // Both sides of an arc that looks away meet the line later; the edge ends.
  EXPECT_EQ(told(arc({0, 2}, {1, 0}, {-1, 0}), floor), "4 0 2 2 birth; 7225/16 2 2 0 death");
  // One point leaves the edge while the other reaches the arc.
  EXPECT_EQ(told(arc({0, 2}, {4, 3}, {-3, 4}), OffsetFeature::edge({6, 0}, {-9, 0})),
            "25 0 1 1 birth; 100 1 2 1 swap; 7225/16 1 1 0 death");
}

/// Squared radii by one printed sentence of the Appendix, and whether the features meet there.
std::string printed(const OffsetFeature& a, const OffsetFeature& b, Form DiscReadings::* sentence,
                    bool has_unit_radius = true) {
  const FeatureNumbers<Interval> near_a(a), near_b(b);
  FeaturePair pair(a, b, near_a, near_b);
  pair.events();
  DiscReadings readings;
  readings.*sentence = Form::printed;
  std::string text;
  for (const FeatureEvent& event : pair.printed_events(readings, has_unit_radius)) {
    text += text.empty() ? "" : "; ";
    text += to_string(pair.squared_radius(event.contacts[0]).coefficients()[0]);
    text += " " + std::string(name(event.change)) + (event.meets() ? "" : ", apart");
  }
  return text;
}

TEST(DiscPairEvents, AsTheAppendixPrintsThem) {
  const auto edge = OffsetFeature::edge;
  // Kept where t is 0 or less on both: never at a last end, and before the other's start.
  EXPECT_EQ(printed(edge({3, 8}, {-7, 8}), edge({-4, 5}, {-12, 11}), &DiscReadings::rejected), "");
  EXPECT_EQ(printed(edge({0, 10}, {10, 10}), edge({-10, 0}, {-10, 5}), &DiscReadings::rejected),
            "100 touch");
  EXPECT_EQ(printed(edge({0, 10}, {10, 10}), edge({-10, 3}, {-10, 5}), &DiscReadings::rejected),
            "49 none, apart; 100 none, apart");
  // Two events or none.
  EXPECT_EQ(printed(edge({3, 8}, {-7, 8}), edge({-4, 5}, {-12, 11}), &DiscReadings::number),
            "9 birth; 225 death");
  EXPECT_EQ(printed(edge({20, 10}, {10, 10}), edge({10, 10}, {10, 20}), &DiscReadings::number), "");
  EXPECT_EQ(printed(edge({8, 6}, {8, 2}), edge({4, 2}, {4, 6}), &DiscReadings::parallel), "");
  // r under the radical.
  const OffsetFeature a = arc({0, 0}, {3, -4}, {4, 3}), b = arc({6, 0}, {-3, 4}, {0, -1});
  EXPECT_EQ(printed(a, b, &DiscReadings::radical), "9 birth; 225/16 death; 25 death");
  EXPECT_EQ(printed(a, b, &DiscReadings::radical, false), "9 birth");
  // The line that the circle touched at 1 stays: 5/4 is not 10/9, and the line's ends are not met.
  EXPECT_EQ(printed(arc({0, 2}, {-1, 0}, {3, -4}), edge({1, 0}, {-9, 0}), &DiscReadings::line),
            "1 birth; 25/16 none, apart");
}

bool are_same(const DiscPairEvent& x, const DiscPairEvent& y) {
  return x.a == y.a && x.b == y.b && x.contacts == y.contacts && x.before == y.before &&
         x.at == y.at && x.after == y.after && x.change == y.change;
}

/// A window keeps its events, and a limit keeps the first events; both in the order of the whole
/// list.
TEST(DiscPairEvents, OfAWindowAndALimit) {
  std::size_t kept = 0;
  testing::Source random(3);
  SCOPED_TRACE("seed " + std::to_string(random.seed()));
  for (int k = 0; k < 12; ++k) {
    SCOPED_TRACE("region " + std::to_string(k));
    const PolygonSet P = testing::random_mesh_region(random, 4);
    const DiscPairEvents all = disc_pair_events(P);
    ASSERT_EQ(all.count, all.events.size());
    for (std::size_t i = 1; i < all.events.size(); ++i) {
      const DiscPairEvent &x = all.events[i - 1], &y = all.events[i];
      const int order = compare(all.squared_radius(x), all.squared_radius(y));
      ASSERT_LE(order, 0);
      ASSERT_EQ(y.rank - x.rank, order == 0 ? 0U : 1U);
    }
    const Rational from(1, 4), to(4);
    std::vector<DiscPairEvent> wanted = all.events;
    std::erase_if(wanted, [&](const DiscPairEvent& event) {
      const RootNumber square = all.squared_radius(event);
      return compare(square, from) < 0 || compare(square, to) > 0;
    });
    DiscPairOptions window;
    window.from = from;
    window.to = to;
    window.most = 7;
    const DiscPairEvents some = disc_pair_events(P, window);
    ASSERT_EQ(some.count, wanted.size());
    ASSERT_EQ(some.events.size(), std::min<std::size_t>(7, wanted.size()));
    for (std::size_t i = 0; i < some.events.size(); ++i) {
      ASSERT_TRUE(are_same(some.events[i], wanted[i]));
    }
    kept += some.filtered_pairs > 0 ? some.events.size() : 0;
  }
  EXPECT_GT(kept, 5U);
}

/// A feature on a small grid, so that ends meet ends and edges are parallel; some are in general
/// position.
OffsetFeature random_feature(testing::Source& random) {
  for (;;) {
    const auto number = [&] { return Rational(random.between(-3, 3)); };
    const Point p{number(), number()}, q{number(), number()};
    const Direction in{number(), number()}, out{number(), number()};
    const bool has_turn = cross(in, out) > 0 || (cross(in, out) == 0 && dot(in, out) < 0);
    if (random.between(0, 1) == 0 && has_turn) return OffsetFeature::arc(p, in, out);
    if (p.x != q.x || p.y != q.y) return OffsetFeature::edge(p, q);
  }
}

TEST(DiscPairEvents, OfRandomPairs) {
  Numbers numbers;
  testing::Source random(7);
  SCOPED_TRACE("seed " + std::to_string(random.seed()));
  for (int k = 0; k < 4000; ++k) {
    SCOPED_TRACE("pair " + std::to_string(k));
    const OffsetFeature a = random_feature(random), b = random_feature(random);
    const bool is_one_place = a.at[0].x == b.at[0].x && a.at[0].y == b.at[0].y;
    if (a.is_arc && b.is_arc && is_one_place) continue;
    ASSERT_NO_FATAL_FAILURE(check_pair(a, b, numbers));
  }
  for (const char* change : {"birth", "death", "touch", "overlap"}) {
    EXPECT_GT(numbers.changes[change], 2U) << change;
  }
}

TEST(DiscPairEvents, OfRandomRegions) {
  Numbers all;
  testing::Source random(4);
  SCOPED_TRACE("seed " + std::to_string(random.seed()));
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE("region " + std::to_string(k));
    const Numbers numbers = check_all(k % 2 == 0 ? testing::random_mesh_region(random, 4)
                                                 : testing::random_region(random, 4));
    ASSERT_FALSE(HasFatalFailure());
    all.events += numbers.events;
    all.at_radii += numbers.at_radii;
    all.gaps += numbers.gaps;
    for (const auto& [change, count] : numbers.changes) all.changes[change] += count;
  }
  for (const char* change : {"birth", "death", "touch", "overlap"}) {
    EXPECT_GT(all.changes[change], 2U) << change;
  }
  EXPECT_GT(all.at_radii, 100U);
}

}  // namespace
}  // namespace minkref::of_pair_events
