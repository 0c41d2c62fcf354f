// Number texts: exact readings, and refusals before any work.
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <string>

#include "reference/error.hpp"
#include "reference/number/rational.hpp"
#include "tests/number/random_numbers.hpp"

namespace minkref::of_rational_parse {
namespace {

std::string code_of(const std::string& text, const NumberLimits& limits = {}) {
  try {
    const Rational value = parse_rational(text, limits);
    return "read as " + to_string(value);
  } catch (const BadInput& refusal) {
    EXPECT_FALSE(refusal.problem().empty());
    EXPECT_FALSE(refusal.mend().empty());
    EXPECT_LT(std::string(refusal.what()).size(), 400U);  // a long text is not repeated
    return refusal.code();
  }
}

/// "1" and `count` zeros.
std::string power_of_ten(std::size_t count) { return std::string("1").append(count, '0'); }

std::string read(const std::string& text, const NumberLimits& limits = {}) {
  return to_string(parse_rational(text, limits));
}

TEST(ParseRational, DecimalsAndFractionsAreReadAsTheExactNumberTheyName) {
  EXPECT_EQ(read("0"), "0");
  EXPECT_EQ(read("-0"), "0");
  EXPECT_EQ(read("-0.000"), "0");
  EXPECT_EQ(read("3"), "3");
  EXPECT_EQ(read("007"), "7");
  EXPECT_EQ(read("0.1"), "1/10");
  EXPECT_EQ(read("-30.7428"), "-76857/2500");
  EXPECT_EQ(read("+.5"), "1/2");
  EXPECT_EQ(read("5."), "5");
  EXPECT_EQ(read("1e-3"), "1/1000");
  EXPECT_EQ(read("1E3"), "1000");
  EXPECT_EQ(read("-12.50e+1"), "-125");
  EXPECT_EQ(read("1.25e1"), "25/2");
  EXPECT_EQ(read("1e000000003"), "1000");
  EXPECT_EQ(read("3/7"), "3/7");
  EXPECT_EQ(read("-6/4"), "-3/2");
  EXPECT_EQ(read("+0/5"), "0");
  EXPECT_EQ(read("0.3669092445"), "733818489/2000000000");
  EXPECT_EQ(read("123456789012345678901234567890/3"), "41152263004115226300411522630");
}

TEST(ParseRational, TextThatIsNotANumberIsRefused) {
  using namespace std::string_literals;
  for (const std::string& text :
       {""s,       "+"s,     "-"s,     "."s,    "+."s,    "e5"s,       ".e1"s,       "1e"s,
        "1e+"s,    "1.2.3"s, "1..2"s,  "0x10"s, "1_000"s, "1,5"s,      "1 000"s,     " 1"s,
        "1 "s,     "\t1"s,   "1\n"s,   "--1"s,  "+-1"s,   "1-"s,       "1e5e5"s,     "1e1.5"s,
        "/"s,      "1/"s,    "/2"s,    "1/-2"s, "1/+2"s,  "1/2/3"s,    "1.5/2"s,     "1/2.5"s,
        "1/2e3"s,  "1e3/2"s, "nan"s,   "NaN"s,  "-nan"s,  "inf"s,      "-Infinity"s, "1f"s,
        "1d"s,     "0b1"s,   "1'000"s, "(1)"s,  "$1"s,    "1\0"s,      "\0"s,        "1\0002"s,
        "٣"s,      "１２"s,  "½"s,     "−1"s,   "1⁄2"s,   "\xff\xfe"s, "²"s,         "1\u00a0"s,
        "\ufeff1"s}) {
    EXPECT_EQ(code_of(text), "not-a-number") << '"' << text << '"';
  }
}

TEST(ParseRational, ZeroDenominatorIsRefused) {
  for (const char* text : {"1/0", "-1/0", "0/0", "1/00000000000000000000000000"}) {
    EXPECT_EQ(code_of(text), "zero-denominator") << text;
  }
}

TEST(ParseRational, LimitsHoldToTheLastDigit) {
  const NumberLimits limits{.digits = 20, .exponent = 30};
  EXPECT_EQ(read(std::string(20, '9'), limits), std::string(20, '9'));
  EXPECT_EQ(read("-1234567890.1234567890", limits), "-1234567890123456789/1000000000");
  EXPECT_EQ(code_of(std::string(21, '9'), limits), "number-too-long");
  EXPECT_EQ(code_of(std::string("+").append(10, '1').append(".").append(11, '1'), limits),
            "number-too-long");
  EXPECT_EQ(code_of(std::string(10, '1') + "/" + std::string(11, '1'), limits), "number-too-long");
  EXPECT_EQ(code_of(std::string("1e").append(20, '0'), limits), "number-too-long");
  EXPECT_EQ(read("1e30", limits), power_of_ten(30));
  EXPECT_EQ(read("1e-30", limits), std::string("1/").append(power_of_ten(30)));
  EXPECT_EQ(code_of("1e31", limits), "exponent-too-large");
  EXPECT_EQ(code_of("1e-31", limits), "exponent-too-large");
  EXPECT_EQ(code_of("0e31", limits), "exponent-too-large");
}

TEST(ParseRational, HugeButLegalNumbersAreRead) {
  const std::string nines(10'000, '9');
  EXPECT_EQ(read(nines), nines);
  EXPECT_EQ(read(std::string("-").append(nines)), std::string("-").append(nines));
  EXPECT_EQ(read("1e10000"), power_of_ten(10'000));
  EXPECT_EQ(read("1e-10000"), std::string("1/").append(power_of_ten(10'000)));
  EXPECT_EQ(read(std::string("0.").append(9'998, '0').append("1")),
            std::string("1/").append(power_of_ten(9'999)));
  EXPECT_EQ(read(std::string(5'000, '4') + "/" + std::string(5'000, '2')), "2");
  EXPECT_EQ(read(std::string(1'000'000, '7'), {.digits = 1'000'000}), std::string(1'000'000, '7'));
}

TEST(ParseRational, MillionDigitsAndBillionExponentAreRefusedBeforeWorkIsDone) {
  const std::string million(1'000'000, '7');
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(code_of(million), "number-too-long");
    ASSERT_EQ(code_of("0." + million), "number-too-long");
    ASSERT_EQ(code_of("1/" + million), "number-too-long");
    ASSERT_EQ(code_of("1e1000000000"), "exponent-too-large");
    ASSERT_EQ(code_of("-1E-1000000000"), "exponent-too-large");
    ASSERT_EQ(code_of("1e99999999999999999999999999999999"), "exponent-too-large");
    ASSERT_EQ(code_of("1e9223372036854775808"), "exponent-too-large");
  }
  // Converting a million digits once takes longer than copying the text a thousand times.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(ParseRational, UnlimitedExponentLimitDoesNotOverflow) {
  const NumberLimits limits{.digits = 100, .exponent = std::numeric_limits<long>::max()};
  EXPECT_EQ(code_of("1e9223372036854775808", limits), "exponent-too-large");
  EXPECT_EQ(read("0e9223372036854775807", limits), "0");
}

TEST(ParseRational, RefusalShowsTheTextCutAndWithoutControlCharacters) {
  try {
    parse_rational("1\x1b[2Jx" + std::string(100, 'y'));
    FAIL() << "read";
  } catch (const BadInput& refusal) {
    EXPECT_EQ(refusal.problem(), "\"1?[2Jx" + std::string(34, 'y') + "\" (cut) is not a number");
  }
}

TEST(ParseRational, ReadingWhatWasWrittenGivesTheSameNumber) {
  MINKREF_SEEDED(random, 20120401);
  for (int i = 0; i < 20'000; ++i) {
    const Rational value = random.rational(300);
    ASSERT_EQ(parse_rational(to_string(value)), value);
    const std::string text = to_string(value);
    const auto bar = text.find('/');
    if (bar != std::string::npos) {
      const Integer n(text.substr(0, bar)), d(text.substr(bar + 1));
      ASSERT_GT(d, 1);
      ASSERT_EQ(boost::multiprecision::gcd(n, d), 1);
    }
  }
}

TEST(ParseRational, DecimalIsItsDigitsTimesAPowerOfTen) {
  MINKREF_SEEDED(random, 20120402);
  for (int i = 0; i < 20'000; ++i) {
    const Integer whole = random.integer(random.between(1, 90));
    const int places = random.between(0, 40), exponent = random.between(-40, 40);
    std::string digits = whole.str();
    if (digits.size() < static_cast<std::size_t>(places))
      digits.insert(0, places - digits.size(), '0');
    const bool negative = random.coin();
    std::string text = negative ? "-" : "+";
    text.append(digits, 0, digits.size() - places).append(".");
    text.append(digits, digits.size() - places).append("e").append(std::to_string(exponent));
    Rational expected(whole);
    for (int k = 0; k < exponent - places; ++k) expected *= 10;
    for (int k = 0; k < places - exponent; ++k) expected /= 10;
    ASSERT_EQ(parse_rational(text), negative ? Rational(-expected) : expected) << text;
  }
}

}  // namespace
}  // namespace minkref::of_rational_parse
