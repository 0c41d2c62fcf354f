// Coordinates equal the text's exact numbers, for every format.
#include "tests/formats/refusal.hpp"

namespace minkref::of_numbers_from_text {
namespace {

Point first_vertex(const Reading& reading) { return reading.set.polygons.at(0).outer.at(0); }

Point read_point(std::string_view text, Format format) {
  return first_vertex(read_text(text, format, ""));
}

TEST(NumbersFromText, AJsonTenthIsOneTenthAndNoDouble) {
  const Rational tenth(1, 10);
  EXPECT_EQ(read_point(R"({"type":"Point","coordinates":[0.1,-0.1]})", Format::geojson),
            (Point{tenth, -tenth}));
  EXPECT_EQ(read_point(R"({"polygons":[{"outer":[[0.1,"0.1"]]}]})", Format::json),
            (Point{tenth, tenth}));
  EXPECT_EQ(read_point("POINT (0.1 1e-1)", Format::wkt), (Point{tenth, tenth}));
}

TEST(NumbersFromText, IntegersOfFiftyDigitsKeepEveryDigit) {
  const std::string big = "12345678901234567890123456789012345678901234567890";
  const Point expected = {Rational(Integer(big)), Rational(-Integer(big))};
  const std::string pair = "[" + big + ",-" + big + "]";
  EXPECT_EQ(read_point(R"({"type":"Point","coordinates":)" + pair + "}", Format::geojson),
            expected);
  EXPECT_EQ(read_point(R"({"polygons":[{"outer":[)" + pair + "]}]}", Format::json), expected);
  EXPECT_EQ(read_point("POINT (" + big + " -" + big + ")", Format::wkt), expected);
}

TEST(NumbersFromText, NumbersBeyondTheRangeOfDoublesAreExact) {
  const Rational huge(pow(Integer(10), 400));
  const Point expected = {huge, 1 / huge};
  EXPECT_EQ(read_point(R"({"type":"Point","coordinates":[1e400,1E-400]})", Format::geojson),
            expected);
  EXPECT_EQ(read_point("POINT (1e+400 1e-400)", Format::wkt), expected);
}

TEST(NumbersFromText, FractionsAreReadWhereNumbersAreText) {
  const Point expected = {Rational(3, 7), Rational(-1, 3)};
  EXPECT_EQ(read_point(R"({"polygons":[{"outer":[["6/14","-1/3"]]}]})", Format::json), expected);
  EXPECT_EQ(read_point("POINT (3/7 -1/3)", Format::wkt), expected);
}

TEST(NumbersFromText, IntegersBeyondTwoToThe53StayApart) {
  const Reading reading =
      read_text("LINESTRING (9007199254740993 0, 9007199254740992 0)", Format::wkt, "");
  EXPECT_NE(reading.set.polygons[0].outer[0], reading.set.polygons[0].outer[1]);
}

}  // namespace
}  // namespace minkref::of_numbers_from_text
