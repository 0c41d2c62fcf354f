// Every refusal of a plane file: its code, and the ring, the vertices, the line and the
// coordinates.
#include "tests/formats/refusal.hpp"

#include <algorithm>

namespace minkref::of_refusal {
namespace {

using Indices = std::vector<std::size_t>;

struct Fault {
  const char* code;
  const char* wkt;
};

class GeometricFault : public testing::TestWithParam<Fault> {};

TEST_P(GeometricFault, IsRefusedWithRingVerticesAndCoordinates) {
  const BadInput refused = refusal_of_text(GetParam().wkt, Format::wkt);
  EXPECT_EQ(refused.code(), GetParam().code) << refused.what();
  EXPECT_TRUE(refused.place().ring.has_value());
  EXPECT_TRUE(refused.place().line.has_value());
  EXPECT_FALSE(refused.place().vertices.empty());
  EXPECT_GE(refused.place().coordinates.size(), refused.place().vertices.size());
}

INSTANTIATE_TEST_SUITE_P(
    Plane, GeometricFault,
    testing::Values(
        Fault{"self-intersection", "POLYGON ((0 0, 4 4, 4 0, 0 6, 0 0))"},
        Fault{"self-intersection", "POLYGON ((0 0, 4 0, 2 2, 4 4, 0 4, 2 2, 0 0))"},
        Fault{"self-intersection", "POLYGON ((0 0, 4 0, 4 4, 2 4, 4 4, 0 4, 0 0))"},
        Fault{"zero-length-edge", "POLYGON ((0 0, 4 0, 4 0, 4 4, 0 0))"},
        Fault{"zero-length-edge", "POLYGON ((0 0, 4 0, 4 4, 0 0, 0 0))"},
        Fault{"zero-length-edge", "LINESTRING (1 2, 1 2)"},
        Fault{"zero-area", "POLYGON ((0 0, 2 0, 4 0, 0 0))"},
        Fault{"hole-outside", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (20 1, 21 1, 20 2, 20 1))"},
        Fault{"overlapping-rings", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 2, 3 3, 0 4, 0 2))"},
        Fault{"crossing-rings", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (5 5, 12 6, 5 7, 5 5))"},
        Fault{"overlapping-polygons",
              "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ((2 2, 4 2, 4 4, 2 4, 2 2)))"}));

TEST(Refusal, VerticesAreThoseOfTheFileThoughTheRingWasTurned) {
  // The file's ring is clockwise: turned, then validated. The file repeats a vertex at 2 and 3.
  const BadInput refused =
      refusal_of_text("POLYGON ((0 0,\n0 4,\n4 4,\n4 4,\n4 0,\n0 0))", Format::wkt);
  EXPECT_EQ(refused.code(), "zero-length-edge");
  Indices vertices = refused.place().vertices;
  std::sort(vertices.begin(), vertices.end());
  EXPECT_EQ(vertices, (Indices{2, 3}));
  EXPECT_EQ(refused.place().coordinates, (std::vector<std::string>{"(4, 4)", "(4, 4)"}));
  EXPECT_GE(refused.place().line, 3U);
  EXPECT_LE(refused.place().line, 4U);
}

TEST(Refusal, TheMessageNamesFileLineRingVertexAndMend) {
  const BadInput refused = refusal_of_text("POLYGON ((0 0,\n 1 0,\n 0 x, 0 0))", Format::wkt);
  EXPECT_EQ(std::string(refused.what()),
            "input: line 3: ring 0: vertex 2: \"x\" is not a number [not-a-number]. To fix it: "
            "write an integer, a decimal or a fraction, such as 3, -30.7428, 1e-3 or 3/7");
}

}  // namespace
}  // namespace minkref::of_refusal
