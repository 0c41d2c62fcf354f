// Fractions in machine words against GMP.
#include "formats/machine_fraction.hpp"

#include <gtest/gtest.h>

#include <random>

namespace minkref::of_machine_fraction {
namespace {

constexpr std::uint64_t seed = 20;

/// A number of random length, at most `bits` bits.
Int128 drawn(std::mt19937_64& random, int bits) {
  const auto length = static_cast<int>(random() % static_cast<std::uint64_t>(bits + 1));
  if (length == 0) return 0;
  __extension__ typedef unsigned __int128 UInt128;
  const UInt128 value = (static_cast<UInt128>(random()) << 64) | random();
  return static_cast<Int128>(value >> (128 - length));
}

std::string text_of(const MachineFraction& value) {
  std::string text;
  append(text, value);
  return text;
}

TEST(MachineFraction, IsInLowestTermsAsInGmp) {
  std::mt19937_64 random(seed);
  for (int turn = 0; turn < 20'000; ++turn) {
    const Int128 shared = drawn(random, 40) + 1;
    const Int128 n = drawn(random, 80) * shared * (turn % 2 == 0 ? 1 : -1);
    const Int128 d = (drawn(random, 80) + 1) * shared;
    EXPECT_EQ(text_of(reduced(n, d)), to_string(Rational(to_integer(n), to_integer(d))))
        << "seed " << seed << ", turn " << turn;
  }
}

TEST(MachineFraction, PositionIsThatOfGmp) {
  std::mt19937_64 random(seed);
  for (int turn = 0; turn < 50'000; ++turn) {
    const auto word = [&](int bits) {
      const auto value = static_cast<std::int64_t>(drawn(random, bits));
      return random() % 2 == 0 ? value : -value;
    };
    const MachineFraction scale = reduced(drawn(random, 125) + 1, drawn(random, 125) + 1);
    // Multiplies by parts of the scale's denominator, so that something cancels.
    const auto part = static_cast<std::int64_t>(scale.denominator % (Int128{1} << 20)) + 1;
    const std::int64_t p = turn % 3 == 0 ? word(40) * part : word(61);
    const std::int64_t q = turn % 5 == 0 ? word(40) * part : word(61);
    const auto unit = static_cast<std::uint64_t>(drawn(random, turn % 7 == 0 ? 64 : 20)) + 1;
    std::string text;
    append_position(text, scale, p, q, unit == 0 ? 1 : unit);
    const Rational s(to_integer(scale.numerator), to_integer(scale.denominator));
    const Rational right = (s * Rational(p) + Rational(q)) / Rational(unit == 0 ? 1 : unit);
    ASSERT_EQ(text, to_string(right)) << "seed " << seed << ", turn " << turn;
  }
}

TEST(MachineFraction, ZeroAndCancellationToZero) {
  std::string text;
  append_position(text, {3, 2}, 2, -3, 1000);
  text += ' ';
  append_position(text, {1, 7}, 0, 0, 9);
  text += ' ';
  append_position(text, {5, 3}, 0, 6, 4);
  EXPECT_EQ(text, "0 0 3/2");
}

}  // namespace
}  // namespace minkref::of_machine_fraction
