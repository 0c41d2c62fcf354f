// Points equally far from several features of P: corners of the outer Voronoi diagram.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/disc/curves/patch_numbers.hpp"

namespace minkref::inline disc {

/// A place and its squared distance from some features.
template <class N>
struct Equidistant {
  Vector<N> at;
  N squared_radius;
};

/// A feature of P: a vertex, or an edge's line with P behind.
struct Site {
  bool is_point;
  Point point;  ///< the vertex, or a point of the line
  Direction normal;

  static Site of(const OffsetCurves& curves, std::uint32_t feature) {
    const OffsetCurves::Feature& own = curves.features[feature];
    if (own.edge == OffsetPatch::none) return {true, own.centre, {}};
    const OffsetEdge& edge = curves.edges[own.edge];
    return {false, edge.start, edge.normal};
  }
  Rational squared_length() const { return dot(normal, normal); }
  Rational level() const { return normal.x * point.x + normal.y * point.y; }
};

/// The candidates for three features, at most two of them right: one for each branch of a root.
template <class N>
class EquidistantPoints {
 public:
  /// Candidates for the place in front of all three features.
  static std::vector<Equidistant<N>> of(Site a, Site b, Site c) {
    if (!a.is_point && b.is_point) std::swap(a, b);
    if (!b.is_point && c.is_point) std::swap(b, c);
    if (!a.is_point && b.is_point) std::swap(a, b);
    if (c.is_point) return of_points(a, b, c);
    if (b.is_point) return of_points_and_line(a, b, c);
    if (a.is_point) return of_point_and_lines(a, b, c);
    return of_lines(a, b, c);
  }

  /// The place right in front of an edge's end, equally far from another feature.
  static std::vector<Equidistant<N>> in_front(const Point& end, const Site& edge,
                                              const Site& other) {
    const Direction& n = edge.normal;
    N far;
    if (other.is_point) {
      const Direction w = from_to(other.point, end);
      const Rational along = dot(w, n);
      if (along >= 0) return {};
      far = N(Rational(-dot(w, w) / (2 * along)));
    } else {
      const N k = sqrt(N(Rational(edge.squared_length() * other.squared_length())));
      const Rational height = other.normal.x * end.x + other.normal.y * end.y - other.level();
      const N slope = k - N(dot(other.normal, n));
      if (sign(slope) == 0) return {};
      far = N(height) / slope;
    }
    return {{numbers<N>(end) + far * numbers<N>(n), far * far * N(edge.squared_length())}};
  }

  /// The place between two features at their least distance.
  static std::vector<Equidistant<N>> between(const Site& a, const Site& b) {
    if (a.is_point && b.is_point) {
      const Direction w = from_to(a.point, b.point);
      const Point middle{(a.point.x + b.point.x) / 2, (a.point.y + b.point.y) / 2};
      return {{numbers<N>(middle), N(Rational(dot(w, w) / 4))}};
    }
    if (!a.is_point && !b.is_point) return {};
    const Site &point = a.is_point ? a : b, &line = a.is_point ? b : a;
    const Rational height =
        line.normal.x * point.point.x + line.normal.y * point.point.y - line.level();
    const Rational part = height / (2 * line.squared_length());
    return {{{N(Rational(point.point.x - part * line.normal.x)),
              N(Rational(point.point.y - part * line.normal.y))},
             N(Rational(part * height / 2))}};
  }

 private:
  static std::vector<Equidistant<N>> of_points(const Site& a, const Site& b, const Site& c) {
    const Direction u = from_to(a.point, b.point), v = from_to(a.point, c.point);
    const Rational turn = 2 * cross(u, v);
    if (turn == 0) return {};
    const Rational square_u = dot(u, u), square_v = dot(v, v);
    const Rational x = (v.y * square_u - u.y * square_v) / turn,
                   y = (u.x * square_v - v.x * square_u) / turn;
    return {{{N(Rational(a.point.x + x)), N(Rational(a.point.y + y))}, N(Rational(x * x + y * y))}};
  }

  /// On the bisector of the points, m + t w.
  static std::vector<Equidistant<N>> of_points_and_line(const Site& a, const Site& b,
                                                        const Site& line) {
    const Direction way = from_to(a.point, b.point), w = turned(way);
    const Point m{(a.point.x + b.point.x) / 2, (a.point.y + b.point.y) / 2};
    const Rational height = line.normal.x * m.x + line.normal.y * m.y - line.level(),
                   slope = dot(line.normal, w), length = line.squared_length();
    const Rational square = dot(way, way), quarter = square / 4;
    const Rational A = square - slope * slope / length, B = height * slope / length,
                   C = quarter - height * height / length;
    std::vector<Equidistant<N>> found;
    const auto add = [&](const N& t) {
      found.push_back({numbers<N>(m) + t * numbers<N>(w), N(quarter) + t * t * N(square)});
    };
    if (A == 0) {
      if (B != 0) add(N(Rational(C / (2 * B))));
      return found;
    }
    const Rational discriminant = B * B - A * C;
    if (discriminant < 0) return found;
    const N root = sqrt(N(discriminant));
    add((N(B) + root) / N(A));
    add((N(B) - root) / N(A));
    return found;
  }

  static std::vector<Equidistant<N>> of_point_and_lines(const Site& point, const Site& a,
                                                        const Site& b) {
    const N length_a = sqrt(N(a.squared_length())),
            length_b = sqrt(joined(N(b.squared_length()), length_a));
    const Vector<N> q = numbers<N>(point.point);
    const Rational turn = cross(a.normal, b.normal);
    std::vector<Equidistant<N>> found;
    if (turn == 0) {
      const N radius = -(N(a.level()) / length_a + N(b.level()) / length_b) / N(2);
      const Rational at = a.normal.x * point.point.x + a.normal.y * point.point.y;
      const N height = radius + N(Rational(a.level() - at)) / length_a;
      const N square = radius * radius - height * height;
      if (sign(square) < 0) return found;
      const N root = sqrt(square);
      const Vector<N> foot = q + (height / length_a) * numbers<N>(a.normal),
                      along = (root / length_a) * numbers<N>(turned(a.normal));
      found.push_back({foot + along, radius * radius});
      found.push_back({foot - along, radius * radius});
      return found;
    }
    const Vector<N> n = numbers<N>(a.normal), m = numbers<N>(b.normal);
    const N c(a.level()), d(b.level()), inverse = N(1) / N(turn);
    const Vector<N> w = Vector<N>{inverse * (c * m.y - d * n.y), inverse * (n.x * d - m.x * c)} - q;
    const Vector<N> v{inverse * (length_a * m.y - length_b * n.y),
                      inverse * (n.x * length_b - m.x * length_a)};
    const N A = dot(v, v) - N(1), B = dot(w, v);
    const N discriminant = B * B - A * dot(w, w);
    if (sign(discriminant) < 0 || sign(A) == 0) return found;
    const N root = sqrt(discriminant);
    for (const int way : {-1, 1}) {
      const N radius = (N(way) * root - B) / A;
      found.push_back({q + w + radius * v, radius * radius});
    }
    return found;
  }

  static std::vector<Equidistant<N>> of_lines(const Site& a, const Site& b, const Site& c) {
    const N length_a = sqrt(N(a.squared_length())),
            length_b = sqrt(joined(N(b.squared_length()), length_a)),
            length_c = sqrt(joined(N(c.squared_length()), length_b));
    const auto turn = [](const Site& s, const Site& t) { return N(cross(s.normal, t.normal)); };
    const N of_a = turn(b, c), of_b = turn(c, a), of_c = turn(a, b);
    const N under = length_a * of_a + length_b * of_b + length_c * of_c;
    if (sign(under) == 0) return {};
    const N radius = -(N(a.level()) * of_a + N(b.level()) * of_b + N(c.level()) * of_c) / under;
    // Two lines that are not parallel tell the place.
    const auto place = [&](const Site& s, const N& length_s, const Site& t,
                           const N& length_t) -> Equidistant<N> {
      const N inverse = N(1) / turn(s, t);
      const N e = N(s.level()) + radius * length_s, f = N(t.level()) + radius * length_t;
      const Vector<N> n = numbers<N>(s.normal), m = numbers<N>(t.normal);
      return {{inverse * (e * m.y - f * n.y), inverse * (n.x * f - m.x * e)}, radius * radius};
    };
    if (cross(a.normal, b.normal) != 0) return {place(a, length_a, b, length_b)};
    return {place(a, length_a, c, length_c)};
  }
};

}  // namespace minkref::inline disc
