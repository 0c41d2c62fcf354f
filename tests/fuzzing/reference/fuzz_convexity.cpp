// Convexity of surfaces: a triangulated hull with a few moved or exchanged vertices is accepted
// exactly if no vertex lies above a face and the volume equals the hull's volume: the surface does
// not run around its middle twice.
#include <utility>

#include "reference/error.hpp"
#include "tests/fuzzing/reference/body_input.hpp"

namespace minkref::fuzzing {
namespace {

constexpr int most_moves = 4;

/// Moves a vertex a little, onto another vertex, onto the middle of two, or exchanges it with
/// another.
void move_vertex(Polyhedron& surface, Bytes& bytes) {
  std::vector<SpacePoint>& all = surface.vertices;
  SpacePoint& moved = all[bytes.next() % all.size()];
  SpacePoint& a = all[bytes.next() % all.size()];
  const SpacePoint& b = all[bytes.next() % all.size()];
  const unsigned how = bytes.next();
  if (how < 16) {
    std::swap(moved, a);
  } else if (how < 32) {
    moved = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  } else if (how < 48) {
    moved = a;
  } else {
    moved.x += static_cast<int>(how % 3) - 1;
    moved.y += static_cast<int>(how / 3 % 3) - 1;
    moved.z += static_cast<int>(how / 9 % 3) - 1;
  }
}

bool has_vertex_above_face(const IntegerPoints& whole, const std::vector<Face>& faces) {
  for (const Face& face : faces) {
    const IntegerVector normal = normal_of(whole.points, face);
    for (const IntegerVector& p : whole.points) {
      if (dot(normal, p - whole.points[face[0]]) > 0) return true;
    }
  }
  return false;
}

Polyhedron hull_of(const IntegerPoints& whole) {
  std::vector<LatticePoint> points;
  for (const IntegerVector& p : whole.points) {
    points.push_back({static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1]),
                      static_cast<std::int64_t>(p[2])});
  }
  const Rational unit(1, whole.denominator);
  return scaled(hull_of_points(points), {unit, unit, unit});
}

void check_surface(const BodyPair& pair) {
  const Polyhedron& surface = pair.P;
  try {
    validate(surface);
  } catch (const BadInput&) {
    return;
  }
  const IntegerPoints whole = integer_points(surface.vertices);
  const Polyhedron hull = hull_of(whole);
  const Rational volume = sextuple_volume(surface);
  const bool convex =
      volume > 0 && volume == sextuple_volume(hull) && !has_vertex_above_face(whole, surface.faces);
  try {
    const ConvexPolyhedron body(surface);
    if (!convex) broken("a surface that is not convex is refused", pair);
    expect_same("a convex surface is that of its hull", pair, ConvexPolyhedron(hull).surface(),
                body.surface());
  } catch (const BadInput& refused) {
    if (convex) broken("a convex surface is accepted", pair, refused.what());
    if (refused.code() != "not-convex") broken("it is refused as such", pair, refused.what());
  }
}

void check(BodyPair& pair, Bytes& bytes, Dice&) {
  pair.P = triangulated(hull_of_points(next_points(bytes, {})));
  for (int move = 0; move < most_moves; ++move) {
    check_surface(pair);
    if (bytes.empty()) return;
    move_vertex(pair.P, bytes);
  }
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minkref::fuzzing::check_bodies(data, size, minkref::fuzzing::check);
}
