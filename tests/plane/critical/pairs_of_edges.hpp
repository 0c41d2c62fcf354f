// Pairs of moving edges, handwritten and random, and whether they meet at one scale, from the
// orientation signs of their end points alone.
#pragma once

#include <sstream>
#include <string>

#include "reference/number/eigen.hpp"
#include "reference/number/rational.hpp"
#include "reference/plane/moving/moving_edge.hpp"
#include "tests/plane/critical/segments_meet.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::testing {

using Vector = Vector2<Rational>;
using Edge = MovingEdge<Vector>;
using Kind = ConvolutionEdge::Kind;

inline Vector vector(const Rational& x, const Rational& y) { return Vector(x, y); }

/// s [from, to] + at.
inline Edge s_edge(const Vector& from, const Vector& to, const Vector& at) {
  return {Kind::S, from, at, Vector(to - from)};
}
/// [from, to] + s at.
inline Edge t_edge(const Vector& from, const Vector& to, const Vector& at) {
  return {Kind::T, at, from, Vector(to - from)};
}

struct PairOfEdges {
  Edge a, b;
};

inline std::string text(const PairOfEdges& pair) {
  std::ostringstream out;
  const auto point = [&](const Vector& v) {
    out << "(" << to_string(v.x()) << "," << to_string(v.y()) << ")";
  };
  for (const Edge* e : {&pair.a, &pair.b}) {
    out << (e->is_s() ? " S" : " T") << " p";
    point(e->p);
    out << " q";
    point(e->q);
    out << " d";
    point(e->d);
  }
  return out.str();
}

/// Whether the closed segments have a point in common at scale s.
inline bool meet_at(const PairOfEdges& pair, const Rational& s) {
  const auto end = [&](const Edge& e, bool last) {
    Vector p = e.p, q = e.q;
    if (last) (e.is_s() ? p : q) += e.d;
    return vector(s * p.x() + q.x(), s * p.y() + q.y());
  };
  const Vector a0 = end(pair.a, false), a1 = end(pair.a, true);
  const Vector b0 = end(pair.b, false), b1 = end(pair.b, true);
  return testing::do_segments_meet(a0, a1, b0, b1);
}

/// Types of pairs, as kinds of a and b.
inline constexpr std::pair<Kind, Kind> types[] = {
    {Kind::S, Kind::S}, {Kind::S, Kind::T}, {Kind::T, Kind::T}};

/// A pair on a small grid; a third are degenerate: parallel, always collinear, with a common end,
/// touching at a chosen scale, or with an end that stays on the other edge's line.
inline PairOfEdges random_pair(Source& random, std::pair<Kind, Kind> kinds) {
  const auto grid = [&] { return vector(random.between(-6, 6), random.between(-6, 6)); };
  const auto direction = [&] {
    Vector d = grid();
    while (d.x() == 0 && d.y() == 0) d = grid();
    return d;
  };
  const auto edge = [&](Kind kind) { return Edge{kind, grid(), grid(), direction()}; };
  PairOfEdges pair{edge(kinds.first), edge(kinds.second)};
  if (random.below(3) != 0) return pair;
  Edge& a = pair.a;
  Edge& b = pair.b;
  const auto multiple = [&](const Vector& d) {
    return Vector(d * Rational(random.between(-3, 3)));
  };
  const auto parallel = [&] {
    int factor = 0;
    while (factor == 0) factor = random.between(-2, 2);
    b.d = Vector(a.d * Rational(factor));
  };
  switch (random.below(6)) {
    case 0:
      parallel();
      break;
    case 1:  // one line at all scales
      parallel();
      b.p = Vector(a.p + multiple(a.d));
      b.q = Vector(a.q + multiple(a.d));
      break;
    case 2:  // a common end at all scales
      b.p = a.p;
      b.q = a.q;
      if (random.below(2) == 0) (a.is_s() ? b.p : b.q) += a.d;
      break;
    case 3: {  // an end of b lies on a at the scale s0
      const Rational s0(random.between(1, 6), random.between(1, 4));
      const Rational t(random.between(0, 4), 4);
      const Vector along(a.d * (a.is_s() ? Rational(s0 * t) : t));
      b.q = Vector(a.p * s0 + a.q + along - b.p * s0);
      if (random.below(3) == 0) parallel();
      break;
    }
    case 4:  // the start of b stays on the line of a
      b.p = Vector(a.p + multiple(a.d));
      b.q = Vector(a.q + multiple(a.d));
      break;
    default:  // one edge is the other
      b.p = a.p;
      b.q = a.q;
      b.d = a.d;
  }
  return pair;
}

}  // namespace minkref::testing
