// The input of the targets on convex bodies: any bytes give two bodies and some scalings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "reference/space/convex/convex_polyhedron.hpp"
#include "reference/space/integer_points.hpp"
#include "tests/fuzzing/reference/dice.hpp"
#include "tests/fuzzing/reference/hull_of_points.hpp"

namespace minkref::fuzzing {

/// One byte after the other; zeros after the end.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : left_(bytes) {}
  bool empty() const { return left_.empty(); }
  std::uint8_t next() {
    if (left_.empty()) return 0;
    const std::uint8_t byte = left_.front();
    left_ = left_.subspan(1);
    return byte;
  }
  /// Two's complement.
  int next_signed() { return static_cast<std::int8_t>(next()); }

 private:
  std::span<const std::uint8_t> left_;
};

/// Points of a small or a large grid, sometimes with the other body's points or their mirror
/// images; never all coplanar.
std::vector<LatticePoint> next_points(Bytes& bytes, const std::vector<LatticePoint>& other);

/// Factors that give an integer body other magnitudes or denominators; mostly 1.
Scaling next_magnitude(Bytes& bytes);

/// Another scaling: multiplies one axis or all axes by a ratio or almost 1; multiplies an axis by a
/// power of two, or moves it to make a facet of one body parallel to an edge of the other.
Scaling next_scaling(Bytes& bytes, Scaling from, const ConvexPolyhedron& P,
                     const ConvexPolyhedron& Q);

/// The outward normal of a strictly convex face, from its first three corners.
inline IntegerVector normal_of(const std::vector<IntegerVector>& points, const Face& face) {
  return cross(points[face[1]] - points[face[0]], points[face[2]] - points[face[0]]);
}

struct BodyPair {
  Polyhedron P, Q;
  std::vector<Scaling> scalings;  ///< in the order of the updates
};

/// Prints the law, what breaks it, the bodies and the scalings, and ends the process.
[[noreturn]] void broken(const std::string& law, const BodyPair& pair,
                         const std::string& what = "");
void expect_same(const std::string& law, const BodyPair& pair, const Polyhedron& expected,
                 const Polyhedron& actual);

/// Runs one input: `check` takes its bodies from the bytes, and its dice depend only on these
/// bytes. An exception from `check` is a finding.
int check_bodies(const std::uint8_t* data, std::size_t size,
                 const std::function<void(BodyPair&, Bytes&, Dice&)>& check);

}  // namespace minkref::fuzzing
