// Input made to break readers: refused in bounded time and memory, never a crash.
#include "formats/case.hpp"
#include "tests/formats/refusal.hpp"

namespace minkref::of_hostile {
namespace {

const std::vector<Format> read_formats = {Format::wkt, Format::geojson, Format::poly, Format::json,
                                          Format::case_json};

struct Sample {
  Format format;
  std::string text;
};

/// A small good text of each format.
std::vector<Sample> samples() {
  const std::string set = R"({"polygons":[{"outer":[["0","0"],[9,0],["9.0","9"],["0","90e-1"]],)"
                          R"("holes":[[["1","1"],["1","2"],["2","1"]]]}]})";
  return {
      {Format::wkt, "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 2, 2 1, 1 1))"},
      {Format::geojson,
       R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[[[0,0],[9,0],[0,9],[0,0]]]}})"},
      {Format::poly, "# x\n2\n3 out\n0 0\n9 0\n0 9\n1 2 3\n3 in\n1 1\n1 2\n2 1\n1 2 3\n"},
      {Format::json, set},
      {Format::case_json, R"({"schema":"case-v1","id":"a","dimension":2,"scales":[1],"P":)" +
                              std::string(R"({"polygons":[]},"Q":{"polygons":[]}})")},
  };
}

/// `text` is read, or refused as BadInput. Anything else fails.
void read_or_refuse(std::string_view text, Format format) {
  try {
    read_valid_text(text, format, "input");
  } catch (const BadInput& e) {
    EXPECT_FALSE(e.mend().empty());
  }
}

TEST(Hostile, AFileCutAtAnyByteIsReadOrRefused) {
  for (const Sample& sample : samples()) {
    EXPECT_NO_THROW(read_valid_text(sample.text, sample.format, "input"));
    for (std::size_t length = 0; length < sample.text.size(); ++length) {
      read_or_refuse(std::string_view(sample.text).substr(0, length), sample.format);
    }
  }
}

TEST(Hostile, ACutInsideTheGeometryIsCalledTruncated) {
  EXPECT_EQ(code_of("POLYGON ((0 0, 9 0, 9 9", Format::wkt), "truncated");
  EXPECT_EQ(code_of("POLYGON ((0 0, 9 0, 9", Format::wkt), "truncated");
  EXPECT_EQ(code_of(R"({"type":"Polygon","coordinates":[[[0,0],[9,)", Format::geojson),
            "truncated");
  EXPECT_EQ(code_of(R"({"type":"Poly)", Format::geojson), "truncated");
  EXPECT_EQ(code_of("1\n4 out\n0 0\n1 0\n1 1\n", Format::poly), "truncated");
  EXPECT_EQ(code_of("2\n3 out\n0 0\n1 0\n1 1\n", Format::poly), "truncated");
  EXPECT_EQ(code_of("1\n3 out\n0 0\n1 0\n1 1\n1 2\n", Format::poly), "truncated");
  EXPECT_EQ(code_of(R"({"polygons":[{"outer":[["0","0)", Format::json), "truncated");
}

TEST(Hostile, AByteChangedToAnyOtherIsReadOrRefused) {
  for (const Sample& sample : samples()) {
    for (std::size_t at = 0; at < sample.text.size(); ++at) {
      std::string text = sample.text;
      for (int byte = 0; byte < 256; byte += 3) {
        text[at] = static_cast<char>(byte);
        read_or_refuse(text, sample.format);
      }
    }
  }
}

TEST(Hostile, TextBehindTheEndIsRefused) {
  for (const Sample& sample : samples()) {
    const std::string code = code_of(sample.text + "\nx", sample.format);
    EXPECT_EQ(code, "trailing-text") << name(sample.format);
  }
}

TEST(Hostile, AMillionBracketsAreRefusedWithoutRecursion) {
  const std::string open(1'000'000, '[');
  EXPECT_EQ(code_of(open, Format::json), "too-deep");
  EXPECT_EQ(code_of(open + std::string(1'000'000, ']'), Format::geojson), "too-deep");
  std::string objects;
  for (int i = 0; i < 200'000; ++i) objects += "{\"a\":";
  EXPECT_EQ(code_of(objects, Format::case_json), "too-deep");
  EXPECT_EQ(code_of("POLYGON " + std::string(1'000'000, '('), Format::wkt), "syntax");
  std::string collections;
  for (int i = 0; i < 100'000; ++i) collections += "GEOMETRYCOLLECTION(";
  EXPECT_EQ(code_of(collections, Format::wkt), "too-deep");
}

TEST(Hostile, TheLimitOnDepthIsExact) {
  ReadLimits limits;
  limits.depth = 3;
  EXPECT_EQ(code_of("[[[[]]]]", Format::json, limits), "too-deep");
  EXPECT_EQ(code_of("[[[]]]", Format::json, limits), "wrong-type");
}

/// A text with `number` as a coordinate, as text and not as a JSON string.
std::string with_number(Format format, const std::string& number) {
  if (format == Format::wkt) return "POLYGON ((0 0, " + number + " 0, 4 4, 0 0))";
  if (format == Format::poly) return "1\n3 out\n0 0\n" + number + " 0\n1 1\n";
  if (format == Format::geojson) {
    return R"({"type":"Polygon","coordinates":[[[0,0],[)" + number + ",0],[1,1],[0,0]]]}";
  }
  const std::string set = R"({"polygons":[{"outer":[[0,0],[)" + number + ",0],[1,1]]}]}";
  if (format == Format::json) return set;
  return R"({"schema":"case-v1","id":"a","dimension":2,"scales":[1],"Q":{"polygons":[]},"P":)" +
         set + "}";
}

TEST(Hostile, ANumberOfAMillionDigitsIsRefused) {
  const std::string number(1'000'000, '7');
  for (const Format format : read_formats) {
    EXPECT_EQ(code_of(with_number(format, number), format), "number-too-long") << name(format);
  }
}

TEST(Hostile, AnExponentOfABillionIsRefused) {
  for (const Format format : read_formats) {
    // A case needs such a number as a string.
    const std::string number = format == Format::case_json ? "\"1e1000000000\"" : "1e1000000000";
    EXPECT_EQ(code_of(with_number(format, number), format), "exponent-too-large") << name(format);
    const std::string small = format == Format::case_json ? "\"1e-1000000000\"" : "1e-1000000000";
    EXPECT_EQ(code_of(with_number(format, small), format), "exponent-too-large") << name(format);
  }
}

TEST(Hostile, NaNAndInfinityAreRefused) {
  for (const Format format : read_formats) {
    for (const char* number : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf"}) {
      EXPECT_EQ(code_of(with_number(format, number), format), "not-a-number")
          << name(format) << " " << number;
    }
  }
  EXPECT_EQ(code_of(with_number(Format::json, "\"NaN\""), Format::json), "not-a-number");
  EXPECT_EQ(code_of(with_number(Format::json, "\"inf\""), Format::json), "not-a-number");
}

TEST(Hostile, LimitsAreErrorsOfTheirOwnType) {
  const std::string number(20'000, '7');
  EXPECT_THROW(read_text(with_number(Format::wkt, number), Format::wkt, ""), LimitExceeded);
  EXPECT_THROW(read_text(std::string(1000, '['), Format::json, ""), LimitExceeded);
}

TEST(Hostile, LimitsCanBeRaised) {
  ReadLimits limits;
  limits.number.digits = 30'000;
  EXPECT_NO_THROW(
      read_text(with_number(Format::wkt, std::string(20'000, '7')), Format::wkt, "", limits));
}

TEST(Hostile, VerticesHaveALimit) {
  ReadLimits limits;
  limits.vertices = 3;
  EXPECT_EQ(code_of("POLYGON ((0 0, 1 0, 0 1, 0 0))", Format::wkt, limits), "too-many-vertices");
  limits.vertices = 4;  // the repeated vertex counts
  EXPECT_NO_THROW(read_text("POLYGON ((0 0, 1 0, 0 1, 0 0))", Format::wkt, "", limits));
}

TEST(Hostile, ShortTextsOfLongNumbersAreBoundedInMemory) {
  ReadLimits limits;
  limits.number_bytes = 100'000;
  std::string text = "POLYGON ((0 0";
  for (int i = 0; i < 100; ++i) text += ", 1e9999 1e-9999";
  EXPECT_EQ(code_of(text + "))", Format::wkt, limits), "too-many-digits");
}

TEST(Hostile, JsonValuesHaveALimit) {
  ReadLimits limits;
  limits.json_values = 100;
  std::string text = "[0";
  for (int i = 0; i < 200; ++i) text += ",0";
  EXPECT_EQ(code_of(text + "]", Format::json, limits), "too-many-values");
}

/// Concentric rings: each hole lies in all outer rings around it.
std::string rings_in_rings(int count) {
  std::string text = std::to_string(count) + "\n";
  for (int i = 1; i <= count; ++i) {
    const std::string r = std::to_string(10 * i);
    text += std::string("4 ") + (i % 2 == 0 ? "out" : "in") + "\n-" + r + " -" + r + "\n" + r +
            " -" + r + "\n" + r + " " + r + "\n-" + r + " " + r + "\n";
  }
  return text;
}

TEST(Hostile, AFewRingsWithoutNestingStayWithinTheLimitOfSteps) {
  ReadLimits limits;
  limits.containment_steps = 1'000;
  EXPECT_EQ(code_of(rings_in_rings(60), Format::poly, limits), "too-much-work");
}

TEST(Hostile, RaysGiveManyRingsTheirOuterOnes) {
  ReadLimits limits;
  limits.containment_steps = 1'000;
  for (const int count : {64, 400, 4'000}) {
    const std::size_t outers = static_cast<std::size_t>(count) / 2;
    const PolygonSet set = read_valid_text(rings_in_rings(count), Format::poly, "", limits).set;
    ASSERT_EQ(set.polygons.size(), outers);
    for (const Polygon& polygon : set.polygons) EXPECT_EQ(polygon.holes.size(), 1U);
  }
}

TEST(Hostile, AnUnclosedCommentOrGarbageIsRefused) {
  for (const Format format : read_formats) {
    for (const char* text :
         {"#", "\x7f\x45\x4c\x46", "<svg/>", "\xff\xff\xff", "%PDF-1.7", "((((", "}}}}"}) {
      read_or_refuse(text, format);
      EXPECT_THROW(read_valid_text(text, format, ""), BadInput) << name(format) << " " << text;
    }
  }
}

}  // namespace
}  // namespace minkref::of_hostile
