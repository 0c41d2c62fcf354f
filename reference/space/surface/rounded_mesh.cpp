#include "reference/space/surface/rounded_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/face_triangles.hpp"
#include "reference/space/surface/space_vertex.hpp"

namespace minkref::inline space {
namespace {

/// The nearest float, ties to even.
double nearest_float(const Rational& value) {
  const double near = to_double(value);
  const auto nearest = static_cast<float>(near);
  const float infinity = std::numeric_limits<float>::infinity();
  // Half-way between the largest float and its would-be successor: only values above have no float.
  if (std::fabs(near) == 0x1.ffffffp127 && abs(value) < from_double(0x1.ffffffp127)) {
    return near < 0 ? -0x1.fffffep127 : 0x1.fffffep127;
  }
  const float other = std::nextafter(nearest, near > double{nearest} ? infinity : -infinity);
  // If the double lies half-way, the value may be nearer to the other float.
  if (near - double{nearest} != double{other} - near) return nearest;
  const int side = value.compare(from_double(near));
  if (side == 0) return nearest;
  return (side > 0) == (other > nearest) ? other : nearest;
}

Rational rounded_coordinate(const Rational& value, Precision precision) {
  const double nearest = precision == Precision::float32 ? nearest_float(value) : to_double(value);
  if (!std::isfinite(nearest)) {
    throw LimitExceeded("not-representable", "a coordinate leaves the range of floating point",
                        "write the mesh as JSON, or scale it down");
  }
  return from_double(nearest);
}

template <class Vector>
Vector triangle_area(const Vector& a, const Vector& b, const Vector& c) {
  return cross(b - a, c - a);
}
RationalVector triangle_area(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  return cross(b - a, c - a);
}

bool is_null(const RationalVector& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& x) { return x.is_zero(); });
}

/// The vertices before and after.
class Rounding {
 public:
  Rounding(const Polyhedron& before, const Polyhedron& after) {
    for (const SpacePoint& p : before.vertices) before_.emplace_back(p);
    for (const SpacePoint& p : after.vertices) after_.emplace_back(p);
  }

  RoundingReport report(const std::vector<Face>& faces) const {
    RoundingReport result;
    for (std::size_t v = 0; v < before_.size(); ++v) {
      const RationalVector moved = after_[v].exact - before_[v].exact;
      result.moved_vertices += !is_null(moved);
      for (const Rational& by : moved) {
        result.largest_displacement = std::max(result.largest_displacement, Rational(abs(by)));
      }
    }
    result.merged_vertices =
        shared_points(before_).points.size() - shared_points(after_).points.size();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      look_for_interrupt();
      judge(faces[f], f, result);
    }
    return result;
  }

 private:
  void judge(const Face& face, std::size_t number, RoundingReport& result) const {
    bool degenerate = false, turned = false;
    const auto look_at = [&](const Face& triangle) {
      const int state = state_of(triangle);
      degenerate = degenerate || state == 0;
      turned = turned || state < 0;
    };
    if (face.size() == 3) {
      look_at(face);
    } else {
      std::vector<SpacePoint> corners;
      Face own;
      for (const std::uint32_t v : face) {
        own.push_back(static_cast<std::uint32_t>(corners.size()));
        corners.push_back(before_[v].exact);
      }
      const IntegerPoints whole = integer_points(corners);
      const auto triangles = face_triangles(own, VertexSigns(whole.points));
      if (!triangles) {
        Place place;
        place.face = number;
        throw BadInput("not-representable", "the face is not planar and simple",
                       "cut the face into triangles", place);
      }
      for (const TriangleCorners& t : *triangles) look_at({face[t[0]], face[t[1]], face[t[2]]});
      result.bent_faces += is_bent(face);
    }
    result.degenerate_faces += degenerate;
    result.turned_faces += turned;
  }

  /// 1: upright, 0: without area, -1: turned over.
  int state_of(const Face& t) const {
    const auto area = [&](const std::vector<SpaceVertex>& at) {
      return triangle_area(at[t[0]].rounded, at[t[1]].rounded, at[t[2]].rounded);
    };
    if (dot(area(before_), area(after_)).certain_sign() == 1) return 1;
    const auto exact_area = [&](const std::vector<SpaceVertex>& at) {
      return triangle_area(at[t[0]].exact, at[t[1]].exact, at[t[2]].exact);
    };
    const RationalVector after = exact_area(after_);
    if (is_null(after)) return 0;
    return dot(exact_area(before_), after) > 0 ? 1 : -1;
  }

  bool is_bent(const Face& face) const {
    const SpacePoint& origin = after_[face[0]].exact;
    RationalVector normal{0, 0, 0};
    for (std::size_t k = 2; k < face.size(); ++k) {
      normal = normal + triangle_area(origin, after_[face[k - 1]].exact, after_[face[k]].exact);
    }
    return std::any_of(face.begin(), face.end(), [&](std::uint32_t v) {
      return !dot(normal, after_[v].exact - origin).is_zero();
    });
  }

  std::vector<SpaceVertex> before_, after_;
};

}  // namespace

RoundedMesh rounded_mesh(const Polyhedron& mesh, Precision precision) {
  const FloatEnvironment standard;
  validate_faces(mesh);
  RoundedMesh result{mesh, {}};
  for (SpacePoint& p : result.mesh.vertices) {
    look_for_interrupt();
    p = {rounded_coordinate(p.x, precision), rounded_coordinate(p.y, precision),
         rounded_coordinate(p.z, precision)};
  }
  result.report = Rounding(mesh, result.mesh).report(mesh.faces);
  return result;
}

}  // namespace minkref::inline space
