// When two convolution edges meet (Behar & Lien 2012, Sec. 4.1 to 4.2.3), printed and corrected.
#include "reference/plane/critical/pair_interval.hpp"

#include <gtest/gtest.h>

#include "reference/plane/critical/parallel_pair.hpp"
#include "reference/plane/kernel/frame.hpp"
#include "tests/plane/critical/pairs_of_edges.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_pair_interval {
namespace {

using K = PlainKernel<Rational>;
using Scales = BoundedScales<Rational>;

Rational r(int numerator, int denominator = 1) { return Rational(numerator, denominator); }

std::string text(const Scales& scales) {
  if (scales.empty) return "empty";
  std::string result = scales.lower ? "[" + to_string(*scales.lower) : "(0";
  result += scales.upper ? ", " + to_string(*scales.upper) + "]" : ", oo)";
  return result;
}

Scales corrected(const PairOfEdges& pair) {
  return corrected_interval<Rational>(end_conditions<Rational>(pair.a, pair.b));
}
Scales printed(const PairOfEdges& pair, Form solves = Form::printed) {
  return printed_interval<Rational>(
      end_scales<Rational>(end_conditions<Rational>(pair.a, pair.b), solves));
}
Scales by_half_lines(const PairOfEdges& pair, Form form = Form::corrected) {
  const K kernel;
  const auto conditions = pair_conditions<K>(kernel, pair.a, pair.b);
  const auto interval = form == Form::printed
                            ? printed_rule<K>(kernel, conditions.half_lines)
                            : intersection_of_half_lines<K>(kernel, conditions.half_lines);
  Scales result{interval.empty, {}, {}};
  if (interval.empty) return result;
  if (interval.lower) result.lower = interval.lower->scale;
  if (interval.upper) result.upper = interval.upper->scale;
  return result;
}

/// Scales at the bounds, between them and just outside, decided by orientation signs.
void expect_truth(const Scales& scales, const PairOfEdges& pair) {
  const Rational hair = Rational(1) / (Integer(1) << 60);
  const auto expect = [&](const Rational& s, bool meet) {
    EXPECT_EQ(meet_at(pair, s), meet)
        << "at " << to_string(s) << " of " << text(scales) << text(pair);
  };
  if (scales.empty) {
    for (const Rational& s : {r(1, 7), r(1, 2), r(1), r(3, 2), r(2), r(3), r(11)}) expect(s, false);
    return;
  }
  if (scales.lower) {
    ASSERT_GT(*scales.lower, 0);
    expect(*scales.lower, true);
    expect(*scales.lower * (1 - hair), false);
    expect(*scales.lower / 3, false);
  }
  if (scales.upper) {
    expect(*scales.upper, true);
    expect(*scales.upper * (1 + hair), false);
    expect(*scales.upper * 3, false);
  }
  const Rational low = scales.lower   ? *scales.lower
                       : scales.upper ? Rational(*scales.upper / 64)
                                      : r(1, 64);
  const Rational high = scales.upper ? *scales.upper : Rational(64 * low);
  expect((low + high) / 2, true);
  expect((15 * low + high) / 16, true);
}

TEST(Observation1, PrintedParameterIsWrongAndCorrectedIsRight) {
  // a from (0,0) to (4,0), b from (1,-1) to (1,1): they meet at r = 1/4.
  const Vector v = vector(4, 0), w = vector(0, 2), u = vector(-1, 1);
  EXPECT_EQ(observation_1<Rational>(v, w, u, Form::corrected), r(1, 4));
  EXPECT_EQ(observation_1<Rational>(v, w, u, Form::printed), r(1, 2));
}

/// Checks random non-parallel pairs.
template <class Check>
void expect_of_crossing_pairs(Source& random, Check&& check) {
  for (int i = 0; i < repetitions(500); ++i) {
    const PairOfEdges pair = random_pair(random, types[random.below(3)]);
    if (K::cross(pair.a.d, pair.b.d) != 0) check(pair);
  }
}

TEST(MovingIntersection, IsLinearInTheScale) {
  MINKREF_SEEDED(random, 3001);
  expect_of_crossing_pairs(random, [](const PairOfEdges& pair) {
    const auto x = line_intersection<Rational>(pair.a, pair.b);
    for (const Rational& s : {r(1, 3), r(1), r(5, 2), r(7)}) {
      EXPECT_EQ(x.at(s), intersection_at<Rational>(pair.a, pair.b, s)) << text(pair);
    }
  });
}

TEST(ScaleSolve, AlphaAndBetaAreMultiplesOfTheDirectionOfTheEdge) {
  MINKREF_SEEDED(random, 3002);
  expect_of_crossing_pairs(random, [](const PairOfEdges& pair) {
    const auto conditions = end_conditions<Rational>(pair.a, pair.b);
    for (const auto& [direction, alpha, beta] : conditions) {
      EXPECT_EQ(K::cross(direction, alpha), 0) << text(pair);
      EXPECT_EQ(K::cross(direction, beta), 0) << text(pair);
    }
    // Therefore both forms of the solve agree in exact arithmetic.
    const auto by_consistency = end_scales<Rational>(conditions, Form::printed);
    const auto along = end_scales<Rational>(conditions, Form::corrected);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(by_consistency[k].kind, along[k].kind) << text(pair);
      EXPECT_EQ(by_consistency[k].scale, along[k].scale) << text(pair);
    }
  });
}

TEST(ScaleSolve, RootInconsistentAndIdentityInTwoAndThreeDimensions) {
  using V3 = ScaleVector<Rational, 3>;
  const V3 direction(r(1), r(2), r(3)), zero(r(0), r(0), r(0));
  for (const Form form : {Form::printed, Form::corrected}) {
    const auto root =
        solve_scale<Rational, 3>(direction, V3(direction * r(2)), V3(direction * r(5)), form);
    EXPECT_EQ(root.kind, Solution::root);
    EXPECT_EQ(root.scale, r(5, 2));
    EXPECT_EQ((solve_scale<Rational, 3>(direction, zero, direction, form).kind),
              Solution::inconsistent);
    EXPECT_EQ((solve_scale<Rational, 3>(direction, zero, zero, form).kind), Solution::identity);
  }
  EXPECT_EQ((solve_by_consistency<Rational, 2>(vector(1, 1), vector(2, 3)).kind),
            Solution::inconsistent);
}

TEST(ScaleSolve, ConsistencyFailsInDoublesWhereARootExists) {
  // Multiples of the direction (1, 3) by factors without an exact double.
  const auto alpha = Vector2<double>(0.1, 0.1 * 3), beta = Vector2<double>(0.7, 0.7 * 3);
  EXPECT_EQ((solve_by_consistency<double, 2>(alpha, beta).kind), Solution::inconsistent);
  EXPECT_EQ((solve_along<double, 2>(Vector2<double>(1, 3), alpha, beta).kind), Solution::root);
}

TEST(PairInterval, PrintedIsEmptyWhereTwoTEdgesMeet) {
  const PairOfEdges pair{t_edge(vector(3, 3), vector(0, 4), vector(-4, -4)),
                         t_edge(vector(2, -3), vector(-6, 6), vector(-3, 2))};
  EXPECT_EQ(text(printed(pair)), "empty");  // [1, 0]
  EXPECT_EQ(text(corrected(pair)), "[2/3, 1]");
  expect_truth(corrected(pair), pair);
}

TEST(PairInterval, PrintedIsEmptyWhereTwoSEdgesMeet) {
  const PairOfEdges pair{s_edge(vector(3, 6), vector(6, -5), vector(-2, -5)),
                         s_edge(vector(1, 6), vector(1, 1), vector(4, 0))};
  EXPECT_EQ(text(printed(pair)), "empty");  // [81/22, 6/5]
  EXPECT_EQ(text(corrected(pair)), "[81/37, 3]");
  expect_truth(corrected(pair), pair);
}

TEST(PairInterval, PrintedIsNotEmptyWhereTwoSEdgesNeverMeet) {
  const PairOfEdges pair{s_edge(vector(-6, 2), vector(-1, 2), vector(5, -4)),
                         s_edge(vector(4, 6), vector(6, -3), vector(-1, 3))};
  EXPECT_EQ(text(printed(pair)), "[20/49, 40/53]");
  EXPECT_EQ(text(corrected(pair)), "empty");
  expect_truth(corrected(pair), pair);
}

TEST(PairInterval, PrintedIsEmptyWhereAnSEdgeMeetsATEdge) {
  const PairOfEdges pair{s_edge(vector(-5, 2), vector(4, -4), vector(-4, 6)),
                         t_edge(vector(-4, -4), vector(-1, -2), vector(-5, 5))};
  EXPECT_EQ(text(printed(pair)), "empty");  // [10/3, 2/3]
  EXPECT_EQ(text(corrected(pair)), "[2, 10/3]");
  expect_truth(corrected(pair), pair);
}

TEST(PairInterval, BothEndsOfAnSEdgeMayBoundFromBelow) {
  // Sorting the two scales of an edge does not mend the printed form.
  const PairOfEdges pair{s_edge(vector(1, -5), vector(-6, -2), vector(0, -1)),
                         t_edge(vector(0, 6), vector(-3, -2), vector(-5, -2))};
  EXPECT_EQ(text(corrected(pair)), "[21/8, 16/3]");
  expect_truth(corrected(pair), pair);
}

TEST(PairInterval, BothWaysToTheCorrectedOneAgreeWithOrientationSigns) {
  for (const auto& kinds : types) {
    MINKREF_SEEDED(random, 3003);
    int empty = 0, point = 0, interval = 0;
    for (int i = 0; i < repetitions(2000); ++i) {
      const PairOfEdges pair = random_pair(random, kinds);
      if (K::cross(pair.a.d, pair.b.d) == 0) continue;
      const Scales scales = corrected(pair);
      EXPECT_EQ(text(scales), text(by_half_lines(pair))) << text(pair);
      EXPECT_EQ(text(printed(pair)), text(by_half_lines(pair, Form::printed))) << text(pair);
      expect_truth(scales, pair);
      ++(scales.empty ? empty : scales.lower && scales.lower == scales.upper ? point : interval);
    }
    EXPECT_GT(empty, 0);
    EXPECT_GT(point, 0);
    EXPECT_GT(interval, 0);
  }
}

TEST(PairInterval, ShortCutForConvexPIsTheCorrectedOne) {
  MINKREF_SEEDED(random, 3004);
  int meeting = 0;
  for (int i = 0; i < repetitions(60); ++i) {
    const PolygonSet P = random_convex_polygon(random, 6, 12), Q = random_region(random);
    const auto edges = reduced_convolution(P, Q);
    const auto moving = moving_edges<Vector>(edges, scalar_operand<Rational>(P, {}),
                                             scalar_operand<Rational>(Q, {}));
    for (std::size_t a = 0; a < moving.size(); ++a) {
      for (std::size_t b = a + 1; b < moving.size(); ++b) {
        const PairOfEdges pair{moving[a], moving[b]};
        const int turn = sign(K::cross(pair.a.d, pair.b.d));
        if (turn == 0) continue;
        const auto conditions = end_conditions<Rational>(pair.a, pair.b);
        const auto scales = end_scales<Rational>(conditions, Form::corrected);
        const Scales truth = corrected(pair);
        // An identity bounds nothing; an end that is never reached may exclude all scales.
        bool reached = true;
        for (const auto& s : scales) reached = reached && s.kind != Solution::inconsistent;
        if (!reached) continue;
        EXPECT_EQ(text(convex_interval<Rational>(scales, turn)), text(truth)) << text(pair);
        meeting += !truth.empty;
      }
    }
  }
  EXPECT_GT(meeting, 100);
}

TEST(ParallelPair, NeverAtOneScaleOrAlwaysAsOrientationSignsSay) {
  using Lines = ParallelPair<K>::Lines;
  const K kernel;
  for (const auto& kinds : types) {
    MINKREF_SEEDED(random, 3005);
    int seen[3] = {0, 0, 0};
    for (int i = 0; i < repetitions(20000); ++i) {
      const PairOfEdges pair = random_pair(random, kinds);
      if (K::cross(pair.a.d, pair.b.d) != 0) continue;
      const auto found = parallel_pair<K>(kernel, pair.a, pair.b);
      ++seen[static_cast<int>(found.lines)];
      Scales scales{true, {}, {}};
      if (found.lines == Lines::one_line_always && !found.interval.empty) {
        scales.empty = false;
        if (found.interval.lower) scales.lower = found.interval.lower->scale;
        if (found.interval.upper) scales.upper = found.interval.upper->scale;
      } else if (found.lines == Lines::one_line_at_one_scale) {
        EXPECT_EQ(meet_at(pair, found.scale), found.meeting != Meeting::never) << text(pair);
        if (found.meeting != Meeting::never) scales = {false, found.scale, found.scale};
      }
      expect_truth(scales, pair);
    }
    for (const int count : seen) EXPECT_GT(count, 20);
  }
}

TEST(ParallelPair, TouchingOrOverlapping) {
  const K kernel;
  const auto meeting = [&](const Vector& from, const Vector& to) {
    // The S-edge s [(0,1), (2,1)] reaches the line y = 3 at s = 3, as [0,6].
    return parallel_pair<K>(kernel, s_edge(vector(0, 1), vector(2, 1), vector(0, 0)),
                            t_edge(from, to, vector(0, 0)));
  };
  EXPECT_EQ(meeting(vector(5, 3), vector(9, 3)).scale, 3);
  EXPECT_EQ(meeting(vector(5, 3), vector(9, 3)).meeting, Meeting::overlapping);
  EXPECT_EQ(meeting(vector(9, 3), vector(5, 3)).meeting, Meeting::overlapping);
  EXPECT_EQ(meeting(vector(6, 3), vector(9, 3)).meeting, Meeting::touching);
  EXPECT_EQ(meeting(vector(9, 3), vector(6, 3)).meeting, Meeting::touching);
  EXPECT_EQ(meeting(vector(-2, 3), vector(0, 3)).meeting, Meeting::touching);
  EXPECT_EQ(meeting(vector(7, 3), vector(9, 3)).meeting, Meeting::never);
}

}  // namespace
}  // namespace minkref::testing::of_pair_interval
