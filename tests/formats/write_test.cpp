// Writing and reading a set gives the same set.
#include "formats/write.hpp"

#include <random>

#include "formats/decimal.hpp"
#include "tests/formats/refusal.hpp"

namespace minkref::of_write {
namespace {

const std::vector<Format> all_formats = {Format::wkt, Format::geojson, Format::poly, Format::json};

PolygonSet wkt(std::string_view text) { return read_text(text, Format::wkt, "").set; }

std::vector<PolygonSet> operands() {
  return {
      wkt("POLYGON EMPTY"),
      wkt("POINT (0.5 -2)"),
      wkt("LINESTRING (0 0, 1e-3 7)"),
      wkt("POLYGON ((0 0, 9.125 0, 9 9, 0 9, 0 0), (1 1, 1 2, 2 1, 1 1), (5 5, 5 6, 6 5, 5 5))"),
      wkt("MULTIPOLYGON (((0 0, 100 0, 100 100, 0 100, 0 0), (10 10, 10 90, 90 90, 90 10, 10 10)), "
          "((40 40, 60 40, 60 60, 40 60, 40 40), (41 41, 41 45, 45 41, 41 41)))"),
      wkt("POLYGON ((1e400 0, 2e400 0, 1e400 1e-400, 1e400 0))"),
  };
}

TEST(Write, EveryOperandIsReadBackFromEveryFormat) {
  for (const PolygonSet& set : operands()) {
    for (const Format format : all_formats) {
      if (!writes_exactly(set, format)) continue;
      const std::string text = write(set, format);
      EXPECT_EQ(text.back(), '\n');
      EXPECT_EQ(read_valid_text(text, format, "").set, set) << name(format) << ": " << text;
    }
  }
}

TEST(Write, DecimalOperandsAreExactInEveryFormat) {
  for (const PolygonSet& set : operands()) {
    for (const Format format : all_formats) {
      const bool bare = set.is_point() || set.is_segment();
      EXPECT_EQ(writes_exactly(set, format), format != Format::poly || !bare);
    }
  }
}

TEST(Write, RandomTrianglesAreReadBackFromEveryExactFormat) {
  const unsigned seed = 20261122;
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::size_t decimal_sets = 0;
  for (int round = 0; round < 300; ++round) {
    const auto number = [&] {
      return Rational(static_cast<int>(random() % 2000001) - 1000000,
                      static_cast<int>(random() % (round % 2 == 0 ? 4 : 40)) + 1);
    };
    Ring ring;
    for (int i = 0; i < 3; ++i) ring.push_back({number(), number()});
    PolygonSet set{{{ring, {}}}};
    if (doubled_area(ring) == 0) continue;
    orient(set);
    for (const Format format : all_formats) {
      if (!writes_exactly(set, format)) continue;
      decimal_sets += format == Format::wkt ? 1 : 0;
      EXPECT_EQ(read_valid_text(write(set, format), format, "").set, set);
    }
  }
  EXPECT_GT(decimal_sets, 5U);
}

TEST(Write, TheWordsOfEachFormat) {
  EXPECT_EQ(write(wkt("POLYGON EMPTY"), Format::wkt), "POLYGON EMPTY\n");
  EXPECT_EQ(write(wkt("POLYGON EMPTY"), Format::geojson),
            "{\"type\":\"MultiPolygon\",\"coordinates\":[]}\n");
  EXPECT_EQ(write(wkt("POLYGON EMPTY"), Format::json), "{\"polygons\":[]}\n");
  EXPECT_EQ(write(wkt("POLYGON EMPTY"), Format::poly), "0\n");
  const PolygonSet triangle = wkt("POLYGON ((0 0, 0.5 0, 0 -1, 0 0))");
  EXPECT_EQ(write(triangle, Format::wkt), "POLYGON ((0 -1, 0.5 0, 0 0, 0 -1))\n");
  EXPECT_EQ(write(triangle, Format::geojson),
            "{\"type\":\"Polygon\",\"coordinates\":[[[0,-1],[0.5,0],[0,0],[0,-1]]]}\n");
  EXPECT_EQ(
      write(triangle, Format::json),
      "{\"polygons\":[{\"holes\":[],\"outer\":[[\"0\",\"-1\"],[\"1/2\",\"0\"],[\"0\",\"0\"]]}]}\n");
  EXPECT_EQ(write(triangle, Format::poly), "1\n3 out\n0 -1\n0.5 0\n0 0\n1 2 3\n");
}

TEST(Write, ThirdsAreRoundedToTheNearestDoubleAndSaidToBeInexact) {
  const PolygonSet set = {{{{point("1/3", "-2/3")}, {}}}};
  EXPECT_FALSE(writes_exactly(set, Format::wkt));
  EXPECT_TRUE(writes_exactly(set, Format::json));
  EXPECT_EQ(write(set, Format::wkt), "POINT (0.33333333333333331 -0.66666666666666663)\n");
}

TEST(Write, WhatNoFormatHoldsIsRefused) {
  const Rational huge(pow(Integer(10), 400), 3);
  const PolygonSet far = {{{{{huge, 0}}, {}}}};
  EXPECT_EQ(refusal_of([&] { write(far, Format::wkt); }).code(), "not-representable");
  EXPECT_EQ(read_text(write(far, Format::json), Format::json, "").set, far);
  EXPECT_EQ(refusal_of([] { write(wkt("POINT (1 2)"), Format::poly); }).code(),
            "not-representable");
  EXPECT_EQ(refusal_of([] { write({}, Format::case_json); }).code(), "unknown-format");
}

TEST(Decimal, IsExactWhereTheDenominatorIsAProductOfTwosAndFives) {
  EXPECT_EQ(exact_decimal(0), "0");
  EXPECT_EQ(exact_decimal(-120), "-120");
  EXPECT_EQ(exact_decimal(Rational(1, 10)), "0.1");
  EXPECT_EQ(exact_decimal(Rational(-1, 8)), "-0.125");
  EXPECT_EQ(exact_decimal(Rational(307428, 10000)), "30.7428");
  EXPECT_EQ(exact_decimal(Rational(1, 1024)), "0.0009765625");
  EXPECT_EQ(exact_decimal(Rational(3, 625)), "0.0048");
  EXPECT_EQ(exact_decimal(Rational(1, 3)), std::nullopt);
  EXPECT_EQ(exact_decimal(Rational(1, 70)), std::nullopt);
  EXPECT_FALSE(has_exact_decimal(Rational(1, 70)));
  EXPECT_TRUE(has_exact_decimal(Rational(7, 80)));
}

}  // namespace
}  // namespace minkref::of_write
