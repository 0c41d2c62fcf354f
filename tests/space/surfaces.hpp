// Surfaces for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <utility>

#include "reference/space/polyhedron.hpp"
#include "tests/space/convex/bodies.hpp"

namespace minkref::surfaces {

using bodies::at;
using bodies::box;
using bodies::tetrahedron;

inline Polyhedron together(std::initializer_list<Polyhedron> parts) {
  Polyhedron result;
  for (const Polyhedron& part : parts) {
    const auto before = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.insert(result.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Face& face : part.faces) {
      for (std::uint32_t& v : result.faces.emplace_back(face)) v += before;
    }
  }
  return result;
}

inline Polyhedron inside_out(Polyhedron surface) {
  for (Face& face : surface.faces) std::reverse(face.begin(), face.end());
  return surface;
}

inline Polyhedron box_at(int x, int y, int z, int dx, int dy, int dz) {
  return translated(box(dx, dy, dz), at(x, y, z));
}

/// A box of side 4 with a roof-shaped dent in its top; the ridge lies at this height.
inline Polyhedron dented(int height) {
  Polyhedron result = box(4, 4, 4);
  result.vertices.push_back(at(1, 2, height));
  result.vertices.push_back(at(3, 2, height));
  result.faces.erase(result.faces.begin() + 1);
  for (const Face& face : {Face{4, 5, 9, 8}, Face{5, 6, 9}, Face{6, 7, 8, 9}, Face{7, 4, 8}}) {
    result.faces.push_back(face);
  }
  return result;
}

using Place3 = std::array<double, 3>;

/// A square tube of triangles around a closed curve. The direction `across` never runs along the
/// curve; a unit is 1/1000.
inline Polyhedron tube(const std::function<Place3(double)>& curve,
                       const std::function<Place3(double)>& across, double radius, int sections) {
  const auto cross = [](const Place3& a, const Place3& b) {
    return Place3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto unit = [](Place3 a) {
    const double length = std::hypot(a[0], a[1], a[2]);
    for (double& c : a) c /= length;
    return a;
  };
  Polyhedron result;
  for (int k = 0; k < sections; ++k) {
    const double t = 2 * std::acos(-1.0) * k / sections;
    const Place3 from = curve(t - 1e-4), to = curve(t + 1e-4), middle = curve(t);
    const Place3 along = unit({to[0] - from[0], to[1] - from[1], to[2] - from[2]});
    const Place3 first = unit(cross(along, across(t))), second = cross(along, first);
    for (const auto& [a, b] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
      std::array<int, 3> p{};
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = static_cast<int>(
            std::lround(1000 * (middle[i] + radius * (a * first[i] + b * second[i]))));
      }
      result.vertices.push_back(at(p[0], p[1], p[2]));
    }
  }
  const auto n = static_cast<std::uint32_t>(sections);
  for (std::uint32_t k = 0; k < n; ++k) {
    for (std::uint32_t j = 0; j < 4; ++j) {
      const std::uint32_t a = 4 * k + j, b = 4 * k + (j + 1) % 4;
      const std::uint32_t c = 4 * ((k + 1) % n) + (j + 1) % 4, d = 4 * ((k + 1) % n) + j;
      result.faces.push_back({a, b, c});
      result.faces.push_back({a, c, d});
    }
  }
  return sextuple_volume(result) < 0 ? inside_out(result) : result;
}

/// Around a torus, `p` times the long way and `q` times the short one.
inline Polyhedron torus_knot(int p, int q, double radius, int sections) {
  const auto curve = [=](double t) {
    const double r = 3 + std::cos(q * t);
    return Place3{r * std::cos(p * t), r * std::sin(p * t), std::sin(q * t)};
  };
  const auto across = [=](double t) {
    const double c = std::cos(q * t);
    return Place3{c * std::cos(p * t), c * std::sin(p * t), std::sin(q * t)};
  };
  return tube(curve, across, radius, sections);
}

/// A tube along a figure eight that crosses itself at lift 0, and otherwise passes above itself.
inline Polyhedron figure_eight(double lift) {
  const auto curve = [=](double t) {
    return Place3{2 * std::sin(t), 2 * std::sin(t) * std::cos(t), lift * std::cos(t)};
  };
  return tube(curve, [](double) { return Place3{0, 0, 1}; }, 0.2, 40);
}

}  // namespace minkref::surfaces
