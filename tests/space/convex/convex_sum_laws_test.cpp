// Laws for all sums of convex bodies.
#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>

#include "reference/interrupt.hpp"
#include "tests/space/convex/bodies.hpp"

namespace minkref::of_convex_sum_laws {
namespace {

using bodies::canonical;
using bodies::for_each_seed;
using bodies::random_body;
using bodies::random_scaling;
using bodies::sum;

constexpr unsigned seeds = 60;

TEST(ConvexSum, IsCommutative) {
  for_each_seed(seeds, [&](std::mt19937& dice) {
    const Polyhedron P = random_body(dice, 3), Q = random_body(dice, 3);
    const Scaling s = random_scaling(dice);
    EXPECT_EQ(sum(P, Q, s).surface, sum(Q, scaled(P, s)).surface);
  });
}

TEST(ConvexSum, OfScaledOperandsIsTheScaledSum) {
  for_each_seed(seeds, [&](std::mt19937& dice) {
    const Polyhedron P = random_body(dice, 3), Q = random_body(dice, 3);
    const Scaling s = random_scaling(dice);
    EXPECT_EQ(sum(P, scaled(Q, s), s).surface, scaled(sum(P, Q).surface, s));
  });
}

TEST(ConvexSum, IsTranslatedWithTheUnscaledOperand) {
  for_each_seed(seeds, [&](std::mt19937& dice) {
    const Polyhedron P = random_body(dice, 3), Q = random_body(dice, 3);
    const Scaling s = random_scaling(dice);
    const SpacePoint by{Rational(1, 3), -7, Rational("123456789123456789123")};
    EXPECT_EQ(sum(P, translated(Q, by), s).surface, translated(sum(P, Q, s).surface, by));
  });
}

TEST(ConvexSum, IsAssociative) {
  for_each_seed(20, [&](std::mt19937& dice) {
    const Polyhedron a = random_body(dice, 2), b = random_body(dice, 2), c = random_body(dice, 2);
    EXPECT_EQ(sum(sum(a, b).surface, c).surface, sum(a, sum(b, c).surface).surface);
  });
}

TEST(ConvexSum, WithItselfIsTheBodyTwiceAsLarge) {
  for_each_seed(seeds, [&](std::mt19937& dice) {
    const Polyhedron P = random_body(dice, 3);
    EXPECT_EQ(sum(P, P).surface, scaled(canonical(P), {2, 2, 2}));
  });
}

TEST(ConvexSum, AllRoutesFindTheSamePairs) {
  for_each_seed(seeds, [&](std::mt19937& dice) {
    const ConvexPolyhedron P(random_body(dice, 3)), Q(random_body(dice, 3));
    Contacts contacts(P, Q);
    contacts.rescale(random_scaling(dice));
    EXPECT_EQ(by_traversal(contacts), by_brute_force(contacts));
  });
}

TEST(ConvexSum, UpdatesGiveWhatIsFoundFromScratch) {
  for_each_seed(seeds, [&](std::mt19937& dice) {
    const ConvexPolyhedron P(random_body(dice, 3)), Q(random_body(dice, 3));
    DynamicConvexSum moving(P, Q, random_scaling(dice));
    Contacts contacts(P, Q);
    for (int step = 0; step < 10; ++step) {
      const Scaling s = random_scaling(dice);
      moving.update(s);
      contacts.rescale(s);
      const Compatibility found = by_traversal(contacts);
      ASSERT_EQ(moving.compatibility(), found);
      EXPECT_EQ(moving.vertices().pairs(), SumVertices(P, Q, found).pairs());
      EXPECT_EQ(surface_of(moving).surface, surface_of(P, Q, s, found).surface);
    }
  });
}

/// Where many checks are left out because the scaling has hardly drifted.
TEST(ConvexSum, ManySmallUpdatesGiveWhatIsFoundFromScratch) {
  for_each_seed(10, [&](std::mt19937& dice) {
    const ConvexPolyhedron P(random_body(dice, 9)), Q(random_body(dice, 9));
    Scaling s = bodies::unit;
    DynamicConvexSum moving(P, Q, s);
    Contacts contacts(P, Q);
    std::uniform_int_distribution<int> percent(-2, 2);
    std::uint64_t left_out = 0;
    for (int step = 0; step < 200; ++step) {
      for (Rational& factor : s) factor *= Rational(100 + percent(dice), 100);
      left_out += P.facets() + Q.facets() - moving.update(s).facets_examined;
      contacts.rescale(s);
      ASSERT_EQ(moving.compatibility(), by_traversal(contacts)) << "step " << step;
    }
    EXPECT_GT(left_out, 0U);
  });
}

/// A scaling that makes a facet of Q parallel to an edge of P, unlike scalings nearby.
std::optional<Scaling> tie(std::mt19937& dice, const ConvexPolyhedron& P,
                           const ConvexPolyhedron& Q) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    Scaling s = random_scaling(dice);
    const auto facet = std::uniform_int_distribution<std::uint32_t>(0, Q.facets() - 1)(dice);
    const auto edge = std::uniform_int_distribution<std::uint32_t>(0, P.edges() - 1)(dice);
    const IntegerVector m = Q.normal(facet), d = P.vector(P.half_edge(edge));
    const Rational rest = s[0] * Rational(m[0] * d[0]) + s[1] * Rational(m[1] * d[1]);
    if (m[2] * d[2] == 0 || rest == 0) continue;
    s[2] = -rest / Rational(m[2] * d[2]);
    if (s[2] > 0) return s;
  }
  return std::nullopt;
}

/// Just below, at and just above a tie three states are different ones, whichever came before.
TEST(ConvexSum, UpdatesOntoAndAcrossATieGiveWhatIsFoundFromScratch) {
  int ties = 0;
  for_each_seed(seeds, [&](std::mt19937& dice) {
    const ConvexPolyhedron P(random_body(dice, 3)), Q(random_body(dice, 3));
    const std::optional<Scaling> at = tie(dice, P, Q);
    if (!at) return;
    ++ties;
    Scaling below = *at, above = *at;
    below[2] *= Rational(999, 1000);
    above[2] *= Rational(1001, 1000);
    DynamicConvexSum moving(P, Q, bodies::unit);
    Contacts contacts(P, Q);
    for (const Scaling& s : {below, *at, above, *at, below, above, bodies::unit, *at}) {
      moving.update(s);
      contacts.rescale(s);
      const Compatibility found = by_traversal(contacts);
      ASSERT_EQ(moving.compatibility(), found);
      EXPECT_EQ(surface_of(moving).surface, surface_of(P, Q, s, found).surface);
    }
  });
  EXPECT_GE(ties, testing::repetitions(30));
}

/// Drift adds up over many updates: steps far below the drift must not get lost.
TEST(ConvexSum, TinyStepsAfterManyHugeOnesGiveWhatIsFoundFromScratch) {
  const Rational half_step = 1 + Rational(1, Integer(1) << 34);
  const Polyhedron tent{
      {{2, 0, 1},
       {-2, 0, 1},
       {2, 0, -1},
       {-2, 0, -1},
       {0, 2, 1},
       {0, -2, 1},
       {0, 2, -1},
       {0, -2, -1}},
      {{0, 4, 1, 5}, {2, 7, 3, 6}, {0, 2, 6, 4}, {4, 6, 3, 1}, {1, 3, 7, 5}, {5, 7, 2, 0}}};
  const Polyhedron post{
      {{0, half_step, 1},
       {1, 0, 1},
       {0, -1, 1},
       {-1, 0, 1},
       {0, half_step, -1},
       {1, 0, -1},
       {0, -1, -1},
       {-1, 0, -1}},
      {{1, 0, 3, 2}, {5, 6, 7, 4}, {1, 5, 4, 0}, {0, 4, 7, 3}, {3, 7, 6, 2}, {2, 6, 5, 1}}};
  const ConvexPolyhedron P(tent), Q(post);
  const Rational tenth(1, 10);
  DynamicConvexSum moving(P, Q, bodies::unit);
  for (int swing = 0; swing < 4000; ++swing) {
    moving.update({tenth, 1, 10});
    moving.update({10, 1, tenth});
  }
  moving.update(bodies::unit);
  Contacts contacts(P, Q);
  const Rational step(1, Integer(1) << 42);
  for (int k = 1; k <= 700; ++k) {
    const Scaling s{1 - k * step, 1, 1};
    moving.update(s);
    contacts.rescale(s);
    ASSERT_EQ(moving.compatibility(), by_traversal(contacts)) << "step " << k;
  }
}

/// Wherever an interrupt comes, and whatever the next update is.
TEST(ConvexSum, AnInterruptedUpdateKeepsTheStateAndTheNextIsRight) {
  unsigned interrupts = 0;
  for_each_seed(12, [&](std::mt19937& dice) {
    Polyhedron bodies[] = {random_body(dice, 9), random_body(dice, 9)};
    for (Polyhedron& body : bodies) {
      for (int k = 0; k < 5; ++k) body = sum(body, bodies::random_tetrahedron(dice, 9)).surface;
    }
    const ConvexPolyhedron P(bodies[0]), Q(bodies[1]);
    Scaling at = random_scaling(dice);
    DynamicConvexSum moving(P, Q, at);
    Contacts contacts(P, Q);
    for (int looks_left = 0; looks_left < 12; ++looks_left) {
      const Compatibility before = moving.compatibility();
      const auto pairs = moving.vertices().pairs();
      const std::uint64_t ee_pairs = moving.ee_pairs();
      int left = looks_left;
      try {
        const Interruptible interrupt([&] {
          if (left-- == 0) throw std::runtime_error("interrupted");
        });
        const Scaling to = random_scaling(dice);
        moving.update(to);
        at = to;
      } catch (const std::runtime_error&) {
        ++interrupts;
        ASSERT_EQ(moving.scaling(), at);
        ASSERT_EQ(moving.compatibility(), before);
        ASSERT_EQ(moving.vertices().pairs(), pairs);
        ASSERT_EQ(moving.ee_pairs(), ee_pairs);
      }
      if (looks_left % 2 == 0) continue;  // the next step begins after an interrupt, too
      at = random_scaling(dice);
      moving.update(at);
      contacts.rescale(at);
      const Compatibility found = by_traversal(contacts);
      ASSERT_EQ(moving.compatibility(), found);
      EXPECT_EQ(moving.vertices().pairs(), SumVertices(P, Q, found).pairs());
    }
  });
  EXPECT_GT(interrupts, 12U);
}

TEST(ConvexSum, OfTheUniformlyScaledKeepsAllPairs) {
  std::mt19937 dice(1);
  const ConvexPolyhedron P(random_body(dice, 5)), Q(random_body(dice, 5));
  DynamicConvexSum moving(P, Q, bodies::unit);
  const Compatibility before = moving.compatibility();
  for (const Rational& factor : {Rational(1, 1000), Rational(17), parse_rational("1e400")}) {
    const UpdateCounts counts = moving.update({factor, factor, factor});
    EXPECT_EQ(counts.fv_errors + counts.vf_errors + counts.ee_errors, 0U);
    EXPECT_EQ(moving.compatibility(), before);
  }
}

/// Theorem 1 with facets of both operands, on all steps of this walk.
TEST(ConvexSum, NoChainIsWrongWithoutAnErrorOfAFacet) {
  UpdateCounts total;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    std::mt19937 dice(seed);
    const ConvexPolyhedron P(random_body(dice, 4)), Q(random_body(dice, 4));
    DynamicConvexSum moving(P, Q, random_scaling(dice));
    for (int step = 0; step < 10; ++step) total += moving.update(random_scaling(dice));
  }
  EXPECT_GT(total.ee_errors, 1000U);
  EXPECT_EQ(total.chains_without_error, 0U);
}

}  // namespace
}  // namespace minkref::of_convex_sum_laws
