#include "reference/space/definition/summand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/space/area_vector.hpp"

namespace minkref::inline space {
namespace {

using Rounded = std::array<double, 3>;
using Vertices = std::vector<std::uint32_t>;

Rounded rounded_vector(const IntegerVector& v) {
  return {to_double(Rational(v[0])), to_double(Rational(v[1])), to_double(Rational(v[2]))};
}

/// A direction as doubles, each coordinate off by at most 2^-49 `size`.
struct RoundedDirection {
  Rounded value, size;
};

RoundedDirection direction_of(const Rounded& exact) {
  return {exact, {std::abs(exact[0]), std::abs(exact[1]), std::abs(exact[2])}};
}

RoundedDirection cross_of(const Rounded& u, const Rounded& v) {
  RoundedDirection result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    result.value[k] = u[i] * v[j] - u[j] * v[i];
    result.size[k] = std::abs(u[i] * v[j]) + std::abs(u[j] * v[i]);
  }
  return result;
}

/// Every vertex that may be among the farthest along the direction, as doubles have it.
void possibly_farthest(const Summand& summand, const RoundedDirection& direction, Vertices& found) {
  const double relative_error = std::ldexp(1.0, -47), absolute_error = std::ldexp(1.0, -500);
  found.clear();
  double least = -std::numeric_limits<double>::infinity();
  const std::size_t count = summand.rounded.size();
  const auto reach = [&](std::size_t v) {
    double value = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      value += direction.value[k] * summand.rounded[v][k];
      size += direction.size[k] * (std::abs(summand.rounded[v][k]) + absolute_error);
    }
    return std::pair(value, relative_error * size + absolute_error);
  };
  for (std::size_t v = 0; v < count; ++v) {
    const auto [value, doubt] = reach(v);
    if (value - doubt > least) least = value - doubt;
  }
  for (std::size_t v = 0; v < count; ++v) {
    const auto [value, doubt] = reach(v);
    if (!(value + doubt < least)) found.push_back(static_cast<std::uint32_t>(v));
  }
}

/// Keeps only the vertices farthest along the normal.
void keep_farthest(const Summand& summand, const IntegerVector& normal, Vertices& found) {
  if (found.size() < 2) return;
  Vertices farthest;
  Integer most;
  for (const std::uint32_t v : found) {
    const Integer reach = dot(normal, summand.vertices.points[v]);
    if (!farthest.empty() && reach < most) continue;
    if (!farthest.empty() && reach > most) farthest.clear();
    most = reach;
    farthest.push_back(v);
  }
  found = std::move(farthest);
}

class SumFacets {
 public:
  SumFacets(const Summand& A, const Summand& B)
      : A_(A), B_(B), weight_(A.vertices.denominator * B.vertices.denominator) {}

  void add(const IntegerVector& normal, const RoundedDirection& direction) {
    possibly_farthest(A_, direction, of_A_);
    possibly_farthest(B_, direction, of_B_);
    add_found(normal);
  }

  /// Adds the normals at right angles to an edge of each operand, both ways.
  void add_across(const IntegerVector& u, const IntegerVector& v, RoundedDirection direction) {
    std::optional<IntegerVector> normal;
    for (int way = 0; way < 2; ++way) {
      if (way == 1) {
        for (double& coordinate : direction.value) coordinate = -coordinate;
      }
      possibly_farthest(A_, direction, of_A_);
      if (of_A_.size() < 2) continue;
      possibly_farthest(B_, direction, of_B_);
      if (of_B_.size() < 2) continue;
      if (!normal) normal = primitive(cross(u, v));
      if (is_zero(*normal)) return;
      add_found(way == 0 ? *normal : IntegerVector{-(*normal)[0], -(*normal)[1], -(*normal)[2]});
    }
  }

  SumBody body() && {
    if (body_.facets.size() < 4) return {};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    body_.bottom = infinity;
    body_.top = -infinity;
    for (const auto& [pair, corner] : corners_) {
      const auto& [x, y, z] = corner.rounded;
      body_.flat_box.add({below(x), below(y), above(x), above(y)});
      body_.bottom = std::min(body_.bottom, below(z));
      body_.top = std::max(body_.top, above(z));
    }
    return std::move(body_);
  }

 private:
  void add_found(const IntegerVector& normal) {
    keep_farthest(A_, normal, of_A_);
    keep_farthest(B_, normal, of_B_);
    if (of_A_.size() + of_B_.size() < 4 || !known_.insert(normal).second) return;
    std::vector<SolidCorner> points;
    for (const std::uint32_t a : of_A_) {
      for (const std::uint32_t b : of_B_) points.push_back(corner(a, b));
    }
    const SolidCorner first = points[0];
    CornerRing ring = convex_ring(std::move(points), viewing_axis(normal));
    if (ring.size() < 3) return;
    const auto& [point, unit] = *first.exact;
    body_.facets.push_back(
        {CuttingPlane({normal, Rational(dot(normal, point), unit)}), std::move(ring)});
  }

  const SolidCorner& corner(std::uint32_t a, std::uint32_t b) {
    const auto [at, fresh] = corners_.try_emplace({a, b});
    if (fresh) {
      IntegerVector sum;
      for (std::size_t k = 0; k < 3; ++k) {
        sum[k] = A_.vertices.points[a][k] * B_.vertices.denominator +
                 B_.vertices.points[b][k] * A_.vertices.denominator;
      }
      at->second = solid_corner(sum, weight_);
    }
    return at->second;
  }

  const Summand &A_, &B_;
  Integer weight_;
  Vertices of_A_, of_B_;
  std::set<IntegerVector> known_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, SolidCorner> corners_;
  SumBody body_;
};

}  // namespace

Summand::Summand(const Polyhedron& piece) : vertices(integer_points(piece.vertices)) {
  for (const SpacePoint& v : piece.vertices) {
    rounded.push_back({to_double(v.x), to_double(v.y), to_double(v.z)});
  }
  std::set<IntegerVector> lines;
  const auto add_edge = [&](std::uint32_t from, std::uint32_t to) {
    IntegerVector along = primitive(vertices.points[to] - vertices.points[from]);
    if (along < IntegerVector{0, 0, 0}) along = {-along[0], -along[1], -along[2]};
    lines.insert(along);
  };
  if (piece.is_segment()) add_edge(0, 1);
  for (const Face& face : piece.faces) {
    normals.push_back(primitive(area_vector(vertices.points, face)));
    for (std::size_t k = 0; k < face.size(); ++k) add_edge(face[k], face[(k + 1) % face.size()]);
  }
  directions.assign(lines.begin(), lines.end());
}

SumBody sum_of(const Summand& A, const Summand& B) {
  SumFacets facets(A, B);
  for (const Summand* summand : {&A, &B}) {
    for (const IntegerVector& n : summand->normals) {
      look_for_interrupt();
      facets.add(n, direction_of(rounded_vector(n)));
    }
  }
  std::vector<Rounded> directions;
  for (const IntegerVector& v : B.directions) directions.push_back(rounded_vector(v));
  for (const IntegerVector& u : A.directions) {
    look_for_interrupt();
    const Rounded along = rounded_vector(u);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      facets.add_across(u, B.directions[k], cross_of(along, directions[k]));
    }
  }
  return std::move(facets).body();
}

}  // namespace minkref::inline space
