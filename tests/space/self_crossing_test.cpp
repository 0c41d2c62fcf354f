// Surfaces that cross or cover themselves, or nest wrongly, are refused with two faces; surfaces
// that only touch themselves are not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "reference/error.hpp"
#include "tests/space/surfaces.hpp"

namespace minkref::of_self_crossing {
namespace {

using bodies::with_apex;
using surfaces::at;
using surfaces::box;
using surfaces::box_at;
using surfaces::inside_out;
using surfaces::tetrahedron;
using surfaces::together;

const Polyhedron cube = box(4, 4, 4);

void expect_taken(const Polyhedron& surface) { EXPECT_NO_THROW(validate(surface)); }

constexpr std::size_t any_two = SIZE_MAX;

/// With two faces, the first below `first_faces` and the second not, or any two.
void expect_refused(const Polyhedron& surface, const std::string& code,
                    const std::string& point = "", std::size_t first_faces = 6) {
  try {
    validate(surface);
    ADD_FAILURE() << "taken, and not refused with " << code;
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.code(), code) << fault.what();
    ASSERT_TRUE(fault.place().face && fault.place().other_face) << fault.what();
    const auto [low, high] = std::minmax(*fault.place().face, *fault.place().other_face);
    EXPECT_LT(low, high);
    EXPECT_TRUE(first_faces == any_two || (low < first_faces && first_faces <= high))
        << fault.what();
    EXPECT_LT(high, surface.faces.size());
    EXPECT_NE(fault.problem().find(point), std::string::npos) << fault.what();
    EXPECT_FALSE(fault.mend().empty());
  }
}

TEST(CrossingSurface, TwoCubesThatOverlap) {
  expect_refused(together({cube, box_at(2, 2, 2, 4, 4, 4)}), "self-intersection");
  expect_refused(together({cube, box_at(1, 1, -1, 1, 1, 9)}), "self-intersection");
}
TEST(CrossingSurface, AnEdgeThroughAFace) {
  const Polyhedron needle = tetrahedron(at(2, 2, 3), at(2, 2, 9), at(3, 2, 9), at(2, 3, 9));
  expect_refused(together({cube, needle}), "self-intersection", ", 4)");
}
TEST(CrossingSurface, AnEdgeAcrossAnEdge) {
  const Polyhedron wedge = tetrahedron(at(3, 3, 2), at(5, 5, 2), at(5, 3, 1), at(5, 3, 3));
  expect_refused(together({cube, wedge}), "self-intersection");
}
TEST(CrossingSurface, ThroughAFaceAlongAnEdgeThatLiesInIt) {
  const SpacePoint a = at(1, 1, 4), b = at(3, 1, 4);
  expect_refused(together({cube, tetrahedron(a, b, at(2, 2, 6), at(2, 2, 2))}),
                 "self-intersection");
  expect_taken(together({cube, tetrahedron(a, b, at(2, 2, 6), at(2, 3, 5))}));
}
TEST(CrossingSurface, AlongAPartOfAnEdge) {
  const SpacePoint a = at(4, 4, 1), b = at(4, 4, 3);
  expect_refused(together({cube, tetrahedron(a, b, at(6, 5, 2), at(3, 3, 2))}),
                 "self-intersection");
  expect_taken(together({cube, tetrahedron(a, b, at(6, 3, 2), at(3, 6, 2))}));
}
/// No inside of a face passes through another.
TEST(CrossingSurface, ThroughAFaceAlongARingOfEdges) {
  const Polyhedron diamond = translated(bodies::octahedron(), at(2, 2, 4));
  expect_refused(together({cube, diamond}), "self-intersection", ", 4)");
}
TEST(CrossingSurface, AlongARingOfItsEdges) {
  const Polyhedron diamond{
      {at(0, 0, 4), at(4, 0, 4), at(4, 4, 4), at(0, 4, 4), at(2, 2, 6), at(2, 2, 2)},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
  expect_refused(together({cube, diamond}), "self-intersection", ", 4)");
}
TEST(CrossingSurface, AlongADiagonalOfAFace) {
  const SpacePoint a = at(0, 0, 4), b = at(4, 4, 4);
  expect_refused(together({cube, tetrahedron(a, b, at(4, 0, 5), at(3, 0, 3))}),
                 "self-intersection");
  expect_taken(together({cube, tetrahedron(a, b, at(4, 0, 5), at(0, 4, 5))}));
}
TEST(CrossingSurface, AFigureEight) {
  expect_refused(surfaces::figure_eight(0), "self-intersection", "", any_two);
  expect_taken(surfaces::figure_eight(1));
}
TEST(CrossingSurface, OneShellThroughItself) {
  expect_refused(with_apex(cube, at(2, 2, -1)), "self-intersection", ", 0)", 1);
  expect_refused(surfaces::dented(-1), "self-intersection", ", 0)", 1);
}

/// Three faces through a common segment, alternating inside and outside: no winding number betrays
/// them.
TEST(CrossingSurface, ThreeFacesThroughOneSegment) {
  const std::vector<SpacePoint> points = {at(0, 0, 0),  at(0, 0, 2),  at(2, 0, 1),   at(1, 2, 1),
                                          at(-1, 2, 1), at(-2, 0, 1), at(-1, -2, 1), at(1, -2, 1)};
  const Polyhedron crossing{points,
                            {{0, 2, 1, 5},
                             {0, 6, 1, 3},
                             {0, 4, 1, 7},
                             {0, 3, 2},
                             {1, 2, 3},
                             {0, 5, 4},
                             {1, 4, 5},
                             {0, 7, 6},
                             {1, 6, 7}}};
  EXPECT_NO_THROW(validate_mesh(crossing));
  expect_refused(crossing, "self-intersection", "(0, 0, 1)", any_two);
  const auto wedge = [&](std::size_t k) {
    return tetrahedron(points[0], points[1], points[k], points[k + 1]);
  };
  expect_taken(together({wedge(2), wedge(4), wedge(6)}));
}

TEST(OverlappingFaces, InOnePlane) {
  expect_refused(together({cube, box_at(0, 0, 4, 4, 4, 4)}), "overlapping-faces", ", 4)");
  expect_refused(together({cube, box_at(3, 3, 4, 4, 4, 4)}), "overlapping-faces", ", 4)");
  expect_refused(together({cube, inside_out(box_at(1, 1, 2, 2, 2, 2))}), "overlapping-faces");
  expect_refused(together({cube, cube}), "overlapping-faces");
}
TEST(OverlappingFaces, WithNothingBetween) {
  const Polyhedron flat{{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)}, {{0, 1, 2}, {0, 2, 1}}};
  expect_refused(flat, "overlapping-faces", "(1/3, 1/3, 0)", 1);
}

TEST(TouchingSurface, AtAVertex) {
  expect_taken(together({cube, box_at(4, 4, 4, 2, 2, 2)}));
  expect_taken(together({cube, tetrahedron(at(2, 2, 4), at(1, 1, 6), at(3, 1, 6), at(2, 3, 6))}));
  expect_taken(with_apex(cube, at(2, 2, 0)));
}
TEST(TouchingSurface, AlongAnEdge) {
  expect_taken(together({cube, box_at(4, 4, 0, 2, 2, 4)}));
  expect_taken(together({cube, box_at(4, 4, 1, 2, 2, 9)}));
  expect_taken(surfaces::dented(0));
}
TEST(TouchingSurface, ACavityAtTheOuterSurface) {
  const Polyhedron inner = tetrahedron(at(2, 2, 4), at(1, 1, 2), at(3, 1, 2), at(2, 3, 2));
  expect_taken(together({cube, inside_out(inner)}));
  expect_refused(together({cube, inner}), "shell-nesting");
}

TEST(NestedShells, Rightly) {
  const Polyhedron cavity = inside_out(box_at(1, 1, 1, 7, 7, 7)), inner = box_at(2, 2, 2, 5, 5, 5);
  expect_taken(together({box(9, 9, 9), cavity}));
  expect_taken(together({inner, cavity, box(9, 9, 9)}));
  expect_taken(together({cube, box_at(5, 0, 0, 1, 1, 1), box_at(0, 7, 0, 1, 1, 1)}));
}
TEST(NestedShells, Wrongly) {
  expect_refused(together({cube, box_at(1, 1, 1, 2, 2, 2)}), "shell-nesting");
  expect_refused(together({box_at(1, 1, 1, 2, 2, 2), cube}), "shell-nesting");
  try {
    validate(together({cube, inside_out(box_at(5, 1, 1, 2, 2, 2))}));
    ADD_FAILURE();
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.code(), "wrong-orientation");
    EXPECT_EQ(fault.place().face, 6U) << fault.what();
  }
}

TEST(Knot, IsTaken) {
  expect_taken(surfaces::torus_knot(2, 3, 0.2, 120));
  expect_taken(surfaces::torus_knot(3, 5, 0.15, 300));
  expect_refused(surfaces::torus_knot(2, 3, 0.9, 120), "self-intersection", "", any_two);
}

}  // namespace
}  // namespace minkref::of_self_crossing
