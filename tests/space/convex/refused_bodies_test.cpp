// Each mesh that is no convex polyhedron is refused, with the faulty face and vertices.
#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "reference/error.hpp"
#include "tests/space/convex/bodies.hpp"

namespace minkref::of_refused_bodies {
namespace {

using bodies::at;
using bodies::box;

std::optional<BadInput> refusal(const Polyhedron& surface) {
  try {
    const ConvexPolyhedron body(surface);
  } catch (const BadInput& fault) {
    return fault;
  }
  return std::nullopt;
}

void expect_refused(const Polyhedron& surface, const std::string& code,
                    std::optional<std::size_t> face, const std::vector<std::size_t>& vertices) {
  const auto fault = refusal(surface);
  ASSERT_TRUE(fault.has_value()) << code;
  EXPECT_EQ(fault->code(), code) << fault->what();
  EXPECT_EQ(fault->place().face, face) << fault->what();
  EXPECT_EQ(fault->place().vertices, vertices) << fault->what();
  EXPECT_EQ(fault->place().coordinates.size(), vertices.size());
  EXPECT_FALSE(fault->mend().empty());
}

Polyhedron changed(Polyhedron surface, const std::function<void(Polyhedron&)>& change) {
  change(surface);
  return surface;
}

void expect_code(const std::string& code, const Polyhedron& surface) {
  const auto fault = refusal(surface);
  ASSERT_TRUE(fault.has_value()) << code;
  EXPECT_EQ(fault->code(), code) << fault->what();
}

/// Two surfaces as one.
Polyhedron both(Polyhedron one, const Polyhedron& other) {
  const auto before = static_cast<std::uint32_t>(one.vertices.size());
  one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Face& face : other.faces) {
    for (std::uint32_t& v : one.faces.emplace_back(face)) v += before;
  }
  return one;
}

const Polyhedron cube = box(1, 1, 1);

TEST(RefusedBody, FaceNamesAVertexThatIsNotThere) {
  const auto fault = refusal(changed(cube, [](auto& s) { s.faces[2][1] = 8; }));
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->code(), "index-out-of-range");
  EXPECT_EQ(fault->place().face, 2U);
}
TEST(RefusedBody, FaceOfTwoVertices) {
  expect_refused(changed(cube, [](auto& s) { s.faces[1] = {4, 5}; }), "too-few-vertices", 1,
                 {4, 5});
}
TEST(RefusedBody, FaceThatVisitsAVertexTwice) {
  expect_refused(changed(cube, [](auto& s) { s.faces[1] = {4, 5, 6, 5}; }), "repeated-vertex", 1,
                 {5});
}
TEST(RefusedBody, VertexOfNoFace) {
  expect_refused(changed(cube, [](auto& s) { s.vertices.push_back(at(5, 5, 5)); }), "unused-vertex",
                 std::nullopt, {8});
}
TEST(RefusedBody, EdgeWithoutLength) {
  expect_refused(changed(cube, [](auto& s) { s.vertices[1] = s.vertices[0]; }), "zero-length-edge",
                 0, {1, 0});
}
TEST(RefusedBody, FaceWithoutArea) {
  const Polyhedron flat{{at(0, 0, 0), at(1, 0, 0), at(2, 0, 0), at(0, 0, 1)},
                        {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
  expect_refused(flat, "zero-area", 0, {0, 1, 2});
}
TEST(RefusedBody, FaceInNoPlane) {
  expect_refused(changed(cube, [](auto& s) { s.vertices[6] = at(1, 1, 2); }), "non-planar-face", 1,
                 {5});
}
TEST(RefusedBody, FaceWhoseEdgesCross) {
  const auto fault = refusal(changed(cube, [](auto& s) { s.faces[1] = {4, 6, 5, 7}; }));
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->code(), "face-not-simple") << fault->what();
  const Polyhedron bent{{at(0, 0, 0), at(4, 0, 0), at(4, 4, 0), at(1, -1, 0), at(0, 4, 0)},
                        {{0, 1, 2, 3, 4}}};
  const auto second = refusal(bent);
  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->code(), "face-not-simple");
  EXPECT_EQ(second->place().face, 0U);
  EXPECT_EQ(second->place().vertices.size(), 4U);
}
TEST(RefusedBody, OpenMesh) {
  expect_refused(changed(cube, [](auto& s) { s.faces.pop_back(); }), "open-mesh", 0, {0, 3});
}
TEST(RefusedBody, EdgeOfThreeFaces) {
  const auto fault = refusal(changed(cube, [](auto& s) {
    s.vertices.push_back(at(0, 0, -5));
    s.faces.push_back({0, 1, 8});
  }));
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->code(), "non-manifold-edge");
  EXPECT_EQ(fault->place().vertices.size(), 2U);
}
TEST(RefusedBody, FaceTurnedRound) {
  const auto fault =
      refusal(changed(cube, [](auto& s) { std::swap(s.faces[1][1], s.faces[1][3]); }));
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->code(), "wrong-orientation");
  EXPECT_TRUE(fault->place().other_face.has_value());
}
TEST(RefusedBody, SurfaceInsideOut) {
  const auto fault = refusal(changed(cube, [](auto& s) {
    for (Face& face : s.faces) std::swap(face[1], face[3]);
  }));
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->code(), "wrong-orientation");
}
TEST(RefusedBody, TwoBodiesThatShareAVertex) {
  const Polyhedron two{
      {at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1), at(-1, 0, 0), at(0, -1, 0),
       at(0, 0, -1)},
      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}}};
  const auto fault = refusal(two);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->code(), "non-manifold-vertex") << fault->what();
  EXPECT_EQ(fault->place().vertices, std::vector<std::size_t>{0});
}
TEST(RefusedBody, Dent) {
  // A pyramid with a dented apex.
  const auto fault = refusal(bodies::with_apex(box(4, 4, 4), at(2, 2, 3)));
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->code(), "not-convex");
  EXPECT_TRUE(fault->place().face.has_value());
  EXPECT_EQ(fault->place().vertices.size(), 1U);
}
TEST(RefusedBody, TwoBodiesApart) {
  expect_code("not-convex", both(cube, translated(cube, at(5, 0, 0))));
}
/// Convex at every edge, but with a body inside the other: the surface runs around twice.
TEST(RefusedBody, OneBodyInAnother) {
  expect_code("shell-nesting", both(box(9, 9, 9), translated(cube, at(4, 4, 4))));
}
TEST(RefusedBody, NothingAPointAndASegment) {
  EXPECT_EQ(refusal({})->code(), "not-solid");
  EXPECT_EQ(refusal({{at(1, 2, 3)}, {}})->code(), "not-solid");
  EXPECT_EQ(refusal({{at(1, 2, 3), at(0, 0, 0)}, {}})->code(), "not-solid");
}

}  // namespace
}  // namespace minkref::of_refused_bodies
