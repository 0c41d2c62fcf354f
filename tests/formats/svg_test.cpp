#include "formats/svg.hpp"

#include "formats/write.hpp"
#include "tests/formats/refusal.hpp"

namespace minkref::of_svg {
namespace {

PolygonSet wkt(std::string_view text) { return read_text(text, Format::wkt, "").set; }

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos;
       at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(Svg, LayersShareOneFrameAndYPointsUp) {
  const std::string text = write_svg(
      {Layer{.name = "low", .region = wkt("POLYGON ((0 0, 10 0, 10 5, 0 5, 0 0))"), .fill = "#c33"},
       Layer{.name = "high", .region = wkt("POLYGON ((0 5, 10 5, 10 10, 0 10, 0 5))")}});
  EXPECT_NE(text.find("viewBox=\"-20 -20 1040 1040\""), std::string::npos);
  EXPECT_NE(text.find("M0,1000L1000,1000L1000,500L0,500Z"), std::string::npos);
  EXPECT_NE(text.find("M0,500L1000,500L1000,0L0,0Z"), std::string::npos);
  EXPECT_NE(text.find("fill=\"#c33\" fill-rule=\"evenodd\""), std::string::npos);
  EXPECT_LT(text.find("<title>low</title>"), text.find("<title>high</title>"));
}

TEST(Svg, HolesAreInThePathOfTheirPolygon) {
  const std::string text =
      write(wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 2, 2 1, 1 1))"), Format::svg);
  EXPECT_EQ(count(text, "<path"), 1U);
  EXPECT_EQ(count(text, "Z"), 2U);
}

TEST(Svg, PointsSegmentsAndConvolutionEdgesAreDrawn) {
  EXPECT_EQ(count(write(wkt("POINT (1 2)"), Format::svg), "<circle"), 1U);
  EXPECT_EQ(count(write(wkt("LINESTRING (0 0, 1 0)"), Format::svg), "M0,0L1000,0"), 1U);
  const std::string text = write_svg({Layer{
      .name = "edges",
      .segments = {{point("0", "0"), point("1", "0")}, {point("1", "0"), point("1", "1")}}}});
  EXPECT_NE(text.find("M0,1000L1000,1000M1000,1000L1000,0"), std::string::npos);
}

TEST(Svg, FarAndHugeCoordinatesAreDrawnInFull) {
  const std::string text =
      write(wkt("POLYGON ((1e400 0, 1.0000000001e400 0, 1e400 1e390, 1e400 0))"), Format::svg);
  EXPECT_NE(text.find("M0,1000L1000,1000L0,0Z"), std::string::npos) << text;
}

TEST(Svg, NamesAndColoursAreEscaped) {
  const std::string text = write_svg({Layer{.name = "a<b & \"c\"", .stroke = "\"><script>"}});
  EXPECT_EQ(count(text, "<script>"), 0U);
  EXPECT_NE(text.find("<title>a&lt;b &amp; &quot;c&quot;</title>"), std::string::npos);
}

TEST(Svg, TheEmptySetIsAnEmptyPicture) {
  const std::string text = write({}, Format::svg);
  EXPECT_EQ(count(text, "<path"), 0U);
  EXPECT_NE(text.find("viewBox=\"-20 -20 40 40\""), std::string::npos);
}

}  // namespace
}  // namespace minkref::of_svg
