#include <algorithm>

#include "tests/formats/refusal.hpp"

namespace minkref::of_poly {
namespace {

Reading poly(std::string_view text) { return read_valid_text(text, Format::poly, "input"); }
std::string code(std::string_view text) { return code_of(text, Format::poly); }

TEST(Poly, CommentsBlankLinesAndIndicesAreSkipped) {
  const PolygonSet set =
      poly("# 3 out\n\n1  # one ring\n\n4 out # square\n0 0\n\n9 0\n9 9\n0 9\n1 2\n3 4\n\n").set;
  const Ring square = {point("0", "0"), point("9", "0"), point("9", "9"), point("0", "9")};
  EXPECT_EQ(set, (PolygonSet{{{square, {}}}}));
}

TEST(Poly, IndicesAreTheOrderInWhichTheRingRuns) {
  const std::string square = "4 out\n0 0\n9 9\n9 0\n0 9\n", hole = "3 in\n1 1\n2 1\n1 2\n";
  const PolygonSet expected = poly("2\n4 out\n0 0\n9 0\n9 9\n0 9\n3 in\n1 1\n1 2\n2 1\n").set;
  EXPECT_EQ(poly("2\n" + square + "1 3 2 4\n" + hole + "1 3 2\n").set, expected);
  // Broken over lines, like long rings in published files.
  EXPECT_EQ(poly("2\n" + square + "1 3\n2 4\n" + hole + "1 3 2\n").set, expected);
  EXPECT_EQ(code("1\n" + square), "self-intersection");
}

TEST(Poly, ARefusedIndexIsNamedWithItsRingAndLine) {
  const BadInput twice =
      refusal_of_text("2\n3 out\n0 0\n9 0\n0 9\n3 in\n1 1\n2 1\n1 2\n1 3 3\n", Format::poly);
  EXPECT_EQ(twice.place().ring, 1U);
  EXPECT_EQ(twice.place().line, 10U);
  EXPECT_NE(std::string(twice.what()).find("the index 3 comes twice"), std::string::npos);
  // After the indices have been put in order a vertex still has its own line.
  const BadInput empty = refusal_of_text("1\n4 out\n0 0\n9 9\n9 0\n9 9\n1 3 2 4\n", Format::poly);
  EXPECT_EQ(empty.code(), "zero-length-edge");
  EXPECT_TRUE(empty.place().line == 4U || empty.place().line == 6U);
}

TEST(Poly, CarriageReturnsAndAMissingLastLineBreakDoNotMatter) {
  EXPECT_EQ(poly("1\r\n3 out\r\n0 0\r\n1 0\r\n0 1").set, poly("1\n3 out\n0 0\n1 0\n0 1\n").set);
}

TEST(Poly, ATokenWithTwoDecimalPointsIsSplitWithAWarning) {
  const Reading reading = poly("1\n3 out\n-6.64248.788605\n1 0\n8.5 -1.25\n");
  const Ring& ring = reading.set.polygons[0].outer;
  EXPECT_NE(std::find(ring.begin(), ring.end(), point("-6.64248", "0.788605")), ring.end());
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_EQ(reading.warnings[0],
            "input: line 3: \"-6.64248.788605\" has two decimal points: read as \"-6.64248\" and "
            "\".788605\"");
}

TEST(Poly, WarningsAreCountedBeyondAHundred) {
  std::string text = "1\n2000 out\n";
  for (int i = 0; i < 1000; ++i) text += std::to_string(i) + ".0.5\n";
  for (int i = 999; i >= 0; --i) text += std::to_string(i) + ".0 9\n";
  const Reading reading = read_text(text, Format::poly, "input");
  EXPECT_EQ(reading.warnings.size(), 101U);
  EXPECT_EQ(reading.warnings.back(), "and 900 more warnings of this kind");
}

TEST(Poly, AHashInsideAWordBeginsNoComment) {
  EXPECT_EQ(code("1\n3 out\n0 -1.#IND\n1 0\n0 1\n"), "not-a-number");
  EXPECT_EQ(code("1\n3 out#\n0 -1\n1 0\n0 1\n"), "syntax");
}

TEST(Poly, ATokenWithThreeDecimalPointsIsRefused) {
  EXPECT_EQ(code("1\n3 out\n1.2.3.4\n1 0\n0 1\n"), "syntax");
}

TEST(Poly, HolesGoToTheSmallestOuterRingThatContainsThem) {
  // A square with a hole, inside it an island with a separate hole; holes come first, out of order.
  const PolygonSet set =
      poly(
          "4\n3 in\n41 41\n41 45\n45 41\n4 in\n10 10\n10 90\n90 90\n90 10\n"
          "4 out\n0 0\n100 0\n100 100\n0 100\n4 out\n40 40\n60 40\n60 60\n40 60\n")
          .set;
  ASSERT_EQ(set.polygons.size(), 2U);
  ASSERT_EQ(set.polygons[0].holes.size(), 1U);
  EXPECT_EQ(set.polygons[0].holes[0].size(), 4U);
  ASSERT_EQ(set.polygons[1].holes.size(), 1U);
  EXPECT_EQ(set.polygons[1].holes[0].size(), 3U);
}

// The C-shaped ring touches the hole at all its vertices and middles of edges, from the outside; so
// does the ring that the hole lies in, which the C surrounds.
TEST(Poly, AHoleThatTouchesAnotherRingEverywhereIsOutsideOfIt) {
  const PolygonSet set =
      poly(
          "3\n17 out\n0 0\n-20 0\n-20 -20\n30 -20\n30 20\n-20 20\n-20 4\n2 4\n2 6.5\n4 8\n6 6.5\n"
          "6 4\n8 2.5\n8 0\n6 -1\n4 0\n2 -1\n"
          "12 out\n0 0\n2 -0.5\n4 0\n6 -0.5\n8 0\n7.5 2.25\n6 4\n5.5 6.25\n4 8\n2.5 6.25\n2 4\n"
          "0.5 2.25\n3 in\n0 0\n4 8\n8 0\n")
          .set;
  ASSERT_EQ(set.polygons.size(), 2U);
  for (const Polygon& polygon : set.polygons) {
    EXPECT_EQ(polygon.holes.size(), polygon.outer.size() == 12U ? 1U : 0U);
  }
}

TEST(Poly, AHoleThatTouchesItsOuterRingAtAPointIsInside) {
  const PolygonSet set = poly(
                             "4\n4 out\n0 0\n9 0\n9 9\n0 9\n4 out\n10 0\n20 0\n20 9\n10 9\n"
                             "3 in\n9 4\n7 3\n7 5\n3 in\n10 5\n11 6\n11 4\n")
                             .set;
  EXPECT_EQ(set.polygons[0].holes.size(), 1U);
  EXPECT_EQ(set.polygons[1].holes.size(), 1U);
}

TEST(Poly, AHoleInNoOuterRingIsRefusedWithItsPlace) {
  const BadInput refused = refusal_of_text(
      "3\n3 out\n0 0\n1 0\n0 1\n3 in\n50 50\n50 51\n51 50\n3 out\n9 9\n8 9\n9 8\n", Format::poly);
  EXPECT_EQ(refused.code(), "hole-outside");
  EXPECT_EQ(refused.place().ring, 1U);
  EXPECT_EQ(refused.place().line, 7U);
  EXPECT_EQ(refused.place().coordinates, (std::vector<std::string>{"(50, 50)"}));
  EXPECT_EQ(code("1\n3 in\n0 0\n1 0\n0 1\n"), "hole-outside");
}

TEST(Poly, RefusalsOfValidationNameRingAndVertexOfTheFile) {
  // The second ring of the file becomes the third of the set (holes go with their outer ring).
  const BadInput refused = refusal_of_text(
      "3\n3 out\n0 0\n9 0\n0 9\n4 out\n20 20\n30 30\n30 20\n20 30\n3 in\n1 1\n1 2\n2 1\n",
      Format::poly);
  EXPECT_EQ(refused.code(), "self-intersection");
  EXPECT_EQ(refused.place().ring, 1U);
  EXPECT_EQ(refused.place().line, 7U);
}

TEST(Poly, WrongStructureIsRefused) {
  expect_code(code, "syntax",
              {"one\n3 out\n0 0\n1 0\n0 1\n", "1 1\n3 out\n0 0\n1 0\n0 1\n", "-1\n",
               "1\n3 outer\n0 0\n1 0\n0 1\n"});
  EXPECT_EQ(code("1\n3 out\n0 0 0\n1 0 0\n0 1 0\n"), "three-dimensional");
  expect_code(code, "syntax",
              {"1\n3 out\n0 0\n1 0\n0 1\n1 3 3\n", "1\n3 out\n0 0\n1 0\n0 1\n0 1 2\n",
               "1\n3 out\n0 0\n1 0\n0 1\n2 3 4\n", "1\n3 out\n0 0\n1 0\n0 1\n2 3 -1\n"});
  EXPECT_EQ(code("1\n3 out\n0 0\n1 0\n0 1\n2 3\n"), "truncated");
  EXPECT_EQ(code("1\n3 out\n0 0\n1 0\n0 1\n1 2 3 4\n"), "syntax");
  EXPECT_EQ(code("2\n3 out\n0 0\n1 0\n0 1\n1 2\n3 in\n"), "syntax");
  EXPECT_EQ(code("1\n3 out\n0 0\n1 0\n0 1\n3 in\n"), "trailing-text");
  EXPECT_EQ(code("1\n2 out\n0 0\n1 0\n"), "too-few-vertices");
  EXPECT_EQ(code("99999999999999999999\n"), "syntax");
  EXPECT_EQ(code("9999999999\n3 out\n0 0\n1 0\n0 1\n"), "truncated");
}

TEST(Poly, NoRingIsTheEmptySet) { EXPECT_TRUE(poly("0\n").set.empty()); }

}  // namespace
}  // namespace minkref::of_poly
