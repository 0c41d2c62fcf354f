// The segments that may bear the boundary of sP + Q, and the convex sums that unite to sP + Q.
#pragma once

#include "oracle/sampled/operand.hpp"

namespace minkref::sampled {

/// The points start + t d, 0 <= t <= length: an edge at a corner of the other operand. d is
/// primitive; the sum lies to the left.
template <class Int>
struct Segment {
  Linear<Int> x, y, length;
  Vec<Int> d;
  Linear<Int> offset;  ///< cross(d, x) for the segment's points x
  int direction;       ///< index among the directions
};

/// The half-plane cross(d, x) >= offset.
template <class Int>
struct HalfPlane {
  Vec<Int> d;
  Linear<Int> offset;
};

/// The sum of a piece from P and a piece from Q.
template <class Int>
using Piece = std::vector<HalfPlane<Int>>;

/// The segments bear the boundary at every scale. Proof: take a triangle of P with an edge from p0
/// to p1, a triangle of Q with the vertex q, and the edge s p0p1 + q of their sum. The whole sum
/// has the open edge in its interior if Q, near q, reaches to the right of the edge (P has the
/// left, at q; what reaches out carries the right along), and also if P lies on both sides of the
/// edge, which is then no edge of P. So from all edges of sums of triangles there remain edges at
/// corners with the other operand to their left, the same at all scales. Corners in the middle of
/// an edge add nothing: edges with one direction are covered from both ends.
template <class Int>
struct Moving {
  std::vector<Segment<Int>> segments;
  std::vector<Piece<Int>> pieces;
  std::vector<Vec<Int>> directions;
  long double coefficient = 1, direction = 1;  ///< the largest ones

  Moving(const Operand<Int>& P, const Operand<Int>& Q) {
    for (const Edge<Int>& e : P.edges) {
      for (const Corner<Int>& q : Q.corners) add(e, q, true);
    }
    for (const Edge<Int>& e : Q.edges) {
      for (const Corner<Int>& p : P.corners) add(e, p, false);
    }
    for (const auto& p : P.pieces) {
      for (const auto& q : Q.pieces) pieces.push_back(sum_of(p, q));
    }
    if constexpr (!std::is_same_v<Int, mpz_class>) find_sizes();
    // Reserves room for candidates' products: offsets times two directions, compared as fractions.
    const long double root = 8 * coefficient * direction * direction;
    demand_room<Int>(64 * root * root);
  }

 private:
  void add(const Edge<Int>& e, const Corner<Int>& corner, bool scales) {
    const Vec<Int> all = e.to - e.from;
    const Int parts = gcd_of<Int>(all.x, all.y);
    const Vec<Int> d{Int(all.x / parts), Int(all.y / parts)};
    if (!corner.left_of(d)) return;
    // An edge of Q at p moves with s p; an edge of P at q has q as the fixed part.
    const Vec<Int>&still = scales ? corner.at : e.from, &moved = scales ? e.from : corner.at;
    Segment<Int> s{{still.x, moved.x}, {still.y, moved.y}, {Int(0), Int(0)}, d, {}, 0};
    (scales ? s.length.b : s.length.a) = parts;
    s.offset = {cross(d, still), cross(d, moved)};
    const auto known = std::find(directions.begin(), directions.end(), d);
    s.direction = static_cast<int>(known - directions.begin());
    if (known == directions.end()) directions.push_back(d);
    segments.push_back(s);
  }

  static Int least(const Vec<Int>& d, const std::vector<Vec<Int>>& points) {
    Int found = cross(d, points[0]);
    for (const auto& p : points) found = std::min<Int>(found, cross(d, p));
    return found;
  }

  static Piece<Int> sum_of(const std::vector<Vec<Int>>& p, const std::vector<Vec<Int>>& q) {
    Piece<Int> piece;
    for (const auto* points : {&p, &q}) {
      for (std::size_t k = 0; k < points->size() && points->size() > 1; ++k) {
        const Vec<Int> all = (*points)[(k + 1) % points->size()] - (*points)[k];
        const Int parts = gcd_of<Int>(all.x, all.y);
        const Vec<Int> d{Int(all.x / parts), Int(all.y / parts)};
        const bool known =
            std::any_of(piece.begin(), piece.end(), [&](const auto& h) { return h.d == d; });
        if (!known) piece.push_back({d, {least(d, q), least(d, p)}});
      }
    }
    return piece;
  }

  void find_sizes() {
    const auto see = [](long double& most, std::initializer_list<Int> numbers) {
      for (const Int& n : numbers) most = std::max(most, size_of(n));
    };
    for (const auto& s : segments) {
      see(coefficient,
          {s.x.a, s.x.b, s.y.a, s.y.b, s.length.a, s.length.b, s.offset.a, s.offset.b});
      see(direction, {s.d.x, s.d.y});
    }
    for (const auto& piece : pieces) {
      for (const auto& h : piece) {
        see(coefficient, {h.offset.a, h.offset.b});
        see(direction, {h.d.x, h.d.y});
      }
    }
  }
};

}  // namespace minkref::sampled
