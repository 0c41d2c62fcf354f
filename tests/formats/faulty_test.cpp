// Reading of rings whose faults `minkref repair` mends.
#include <gtest/gtest.h>

#include "formats/read.hpp"
#include "tests/formats/refusal.hpp"

namespace minkref {
namespace {

FaultyReading faulty(const std::string& text, Format format) {
  return read_faulty_text(text, format, "input");
}

TEST(Faulty, RingsStayAsWritten) {
  const FaultyReading found = faulty(
      "GEOMETRYCOLLECTION (POLYGON ((0 0, 0 4, 4 4, 4 0), (1 1, 2 2, 1 1), (7 7)), POINT (9 9))",
      Format::wkt);
  ASSERT_EQ(found.reading.set.polygons.size(), 2U);
  const Polygon& polygon = found.reading.set.polygons[0];
  EXPECT_EQ(polygon.outer, (Ring{{0, 0}, {0, 4}, {4, 4}, {4, 0}}));  // clockwise, not turned
  EXPECT_EQ(polygon.holes, (std::vector<Ring>{{{1, 1}, {2, 2}}, {{7, 7}}}));
  EXPECT_EQ(found.reading.set.polygons[1].outer, (Ring{{9, 9}}));
  EXPECT_EQ(found.open, (std::vector<bool>{true, false, false, false}));
}

TEST(Faulty, AHoleInNoOuterRingIsTheFirstOnes) {
  const FaultyReading found =
      faulty("4\n3 out\n0 0\n1 0\n0 1\n3 out\n5 0\n6 0\n5 1\n3 in\n9 9\n9 8\n8 9\n2 in\n1 1\n2 2\n",
             Format::poly);
  ASSERT_EQ(found.reading.set.polygons.size(), 3U);
  EXPECT_EQ(found.reading.set.polygons[0].outer.size(), 2U);
  EXPECT_EQ(found.reading.set.polygons[1].holes.size(), 1U);
  EXPECT_TRUE(found.reading.set.polygons[2].holes.empty());
}

TEST(Faulty, OtherFaultsAreRefusedAsEver) {
  const auto code = [](const std::string& text) {
    return refusal_of([&] { faulty(text, Format::wkt); }).code();
  };
  EXPECT_EQ(code("POLYGON ((0 0, nan 1, 1 1, 0 0))"), "not-a-number");
  EXPECT_EQ(code("POLYGON ((0 0, 1 1"), "truncated");
  EXPECT_EQ(code("LINESTRING (0 0)"), "not-a-segment");
}

}  // namespace
}  // namespace minkref
