// Scales at which the moving segments' arrangement may change.
#pragma once

#include <optional>

#include "oracle/sampled/moving.hpp"

namespace minkref::sampled {

/// A point in units of the scale's denominator, w > 0, in lowest terms.
template <class Int>
struct Point {
  Int x, y, w;
  friend bool operator==(const Point& a, const Point& b) {
    return a.x == b.x && a.y == b.y && a.w == b.w;
  }
  friend bool operator<(const Point& a, const Point& b) {
    const Int ax = a.x * b.w, bx = b.x * a.w;
    return ax != bx ? ax < bx : a.y * b.w < b.y * a.w;
  }
};

template <class Int>
Point<Int> reduced(Int x, Int y, Int w) {
  const Int common = gcd_of<Int>(gcd_of<Int>(x, y), w);
  if (w < 0) return {Int(-x / common), Int(-y / common), Int(-w / common)};
  return {Int(x / common), Int(y / common), Int(w / common)};
}

/// Returns the crossing of two lines cross(d, x) = offset and cross(e, x) = other, not parallel.
template <class Int>
Point<Int> crossing(const Vec<Int>& d, const Int& offset, const Vec<Int>& e, const Int& other) {
  return reduced<Int>(Int(offset * e.x - other * d.x), Int(offset * e.y - other * d.y),
                      cross(d, e));
}

/// The scales, ends included, at which two segments, not parallel, share a point.
template <class Int>
struct Meeting {
  bool is_any = false;
  Fraction<Int> from{Int(0), Int(1)}, to{Int(1), Int(0)};
  bool holds(const Fraction<Int>& s) const { return is_any && from <= s && s <= to; }
  /// Keeps only scales with m + n s >= 0.
  void bound(const Int& m, const Int& n) {
    if (n == 0) {
      is_any = is_any && m >= 0;
      return;
    }
    const Fraction<Int> root = n > 0 ? fraction<Int>(-m, n) : fraction<Int>(m, -n);
    if (n > 0 && from < root) from = root;
    if (n < 0 && root < to) to = root;
    is_any = is_any && from <= to && to.p > 0;
  }
};

/// Strictly between neighbouring scales the segments' arrangement keeps its nodes, in the same
/// order on each segment. Two nodes come together only where
/// - an end of a segment comes to lie on another segment (an end of its Meeting),
/// - two parallel segments come to lie on one line,
/// - the ends of two segments on one line meet,
/// - three segments, not parallel, share a point.
/// Unless `all`, a scale is left out if a sum of two pieces has all these places in its interior:
/// the places stay inside for a while, and belong to no boundary.
template <class Int>
class Candidates {
 public:
  Candidates(const Moving<Int>& moving, bool all) : moving_(moving), all_(all) {
    const std::size_t n = moving_.segments.size();
    meetings_.resize(n * n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) add_pair(i, j);
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        if (!meeting(i, j).is_any) continue;
        for (std::size_t k = j + 1; k < n; ++k) {
          if (meeting(i, k).is_any && meeting(j, k).is_any) add_triple(i, j, k);
        }
      }
    }
  }

  /// Returns the scales ascending, each once.
  std::vector<Fraction<Int>> scales() {
    std::sort(found_.begin(), found_.end(),
              [](const Found& a, const Found& b) { return a.s < b.s; });
    std::vector<Fraction<Int>> result;
    for (const Found& each : found_) {
      if (!result.empty() && result.back() == each.s) continue;
      if (all_ || !each.place || !is_within_a_piece(*each.place, each.s)) result.push_back(each.s);
    }
    return result;
  }

 private:
  struct Found {
    Fraction<Int> s;
    std::optional<Point<Int>> place;  ///< none for more than a point
  };

  const Segment<Int>& segment(std::size_t i) const { return moving_.segments[i]; }
  Meeting<Int>& meeting(std::size_t i, std::size_t j) {
    return meetings_[i * moving_.segments.size() + j];
  }

  void add_pair(std::size_t i, std::size_t j) {
    const Segment<Int>&a = segment(i), &b = segment(j);
    Int c = cross(a.d, b.d);
    if (c == 0) {
      add_parallel(a, b);
      return;
    }
    Meeting<Int>& m = meeting(i, j);
    m.is_any = true;
    // a.start + t a.d lies on b's line: t c = cross(b.start - a.start, b.d); likewise for b.
    const Linear<Int> x{Int(b.x.a - a.x.a), Int(b.x.b - a.x.b)},
        y{Int(b.y.a - a.y.a), Int(b.y.b - a.y.b)};
    for (const auto& [d, length] : {std::pair(b.d, a.length), std::pair(a.d, b.length)}) {
      Int t0 = x.a * d.y - y.a * d.x, t1 = x.b * d.y - y.b * d.x, size = c;
      if (c < 0) {
        t0 = -t0;
        t1 = -t1;
        size = -c;
      }
      m.bound(t0, t1);
      m.bound(Int(size * length.a - t0), Int(size * length.b - t1));
    }
    if (!m.is_any) return;
    for (const Fraction<Int>& s : {m.from, m.to}) {
      if (s.p > 0 && s.q > 0) add_crossing(a, b, s);
    }
  }

  void add_crossing(const Segment<Int>& a, const Segment<Int>& b, const Fraction<Int>& s) {
    if constexpr (!std::is_same_v<Int, mpz_class>) demand_room_at(s);
    found_.push_back({s, crossing<Int>(a.d, a.offset.at(s), b.d, b.offset.at(s))});
  }

  void add_parallel(const Segment<Int>& a, const Segment<Int>& b) {
    // How far b's line lies to the left of a's line.
    const Int g = a.d == b.d ? Int(1) : Int(-1);
    const Int m = g * b.offset.a - a.offset.a, n = g * b.offset.b - a.offset.b;
    if (n != 0) {
      const Fraction<Int> s = fraction<Int>(-m, n);
      if (s.p > 0) add_overlap(a, b, s);
      return;
    }
    if (m != 0) return;
    // Always on one line: finds the scales at which the ends meet.
    for (const bool end : {false, true}) {
      for (const bool other_end : {false, true}) {
        const Linear<Int> x = end_of(a, end, a.d), y = end_of(b, other_end, a.d);
        const Int now = x.a - y.a, speed = x.b - y.b;
        if (speed == 0) continue;
        const Fraction<Int> s = fraction<Int>(-now, speed);
        if (s.p <= 0) continue;
        if constexpr (!std::is_same_v<Int, mpz_class>) demand_room_at(s);
        const Int t = end ? a.length.at(s) : Int(0);
        found_.push_back(
            {s, reduced<Int>(Int(a.x.at(s) + t * a.d.x), Int(a.y.at(s) + t * a.d.y), Int(1))});
      }
    }
  }

  /// Returns an end's position along d.
  static Linear<Int> end_of(const Segment<Int>& a, bool end, const Vec<Int>& d) {
    const Int step = end ? dot(a.d, d) : Int(0);
    return {Int(a.x.a * d.x + a.y.a * d.y + step * a.length.a),
            Int(a.x.b * d.x + a.y.b * d.y + step * a.length.b)};
  }

  void add_overlap(const Segment<Int>& a, const Segment<Int>& b, const Fraction<Int>& s) {
    if constexpr (!std::is_same_v<Int, mpz_class>) demand_room_at(s);
    Int a0 = end_of(a, false, a.d).at(s), a1 = end_of(a, true, a.d).at(s);
    Int b0 = end_of(b, false, a.d).at(s), b1 = end_of(b, true, a.d).at(s);
    if (b1 < b0) std::swap(b0, b1);
    if (a0 <= b1 && b0 <= a1) found_.push_back({s, std::nullopt});
  }

  void add_triple(std::size_t i, std::size_t j, std::size_t k) {
    const Segment<Int>&a = segment(i), &b = segment(j), &c = segment(k);
    const Int bc = cross(b.d, c.d), ca = cross(c.d, a.d), ab = cross(a.d, b.d);
    const Int n = a.offset.b * bc + b.offset.b * ca + c.offset.b * ab;
    if (n == 0) return;  // never, or always
    const Int m = a.offset.a * bc + b.offset.a * ca + c.offset.a * ab;
    if (sign(m) * sign(n) >= 0) return;
    const Fraction<Int> s = fraction<Int>(-m, n);
    if (meeting(i, j).holds(s) && meeting(i, k).holds(s) && meeting(j, k).holds(s)) {
      add_crossing(a, b, s);
    }
  }

  void demand_room_at(const Fraction<Int>& s) const {
    const long double d = moving_.direction;
    demand_room<Int>(64 * moving_.coefficient * (size_of(s.p) + size_of(s.q)) * d * d * d);
  }

  bool is_within_a_piece(const Point<Int>& x, const Fraction<Int>& s) const {
    return std::any_of(moving_.pieces.begin(), moving_.pieces.end(), [&](const Piece<Int>& piece) {
      return std::all_of(piece.begin(), piece.end(), [&](const HalfPlane<Int>& h) {
        return Int(h.d.x * x.y - h.d.y * x.x) > Int(h.offset.at(s) * x.w);
      });
    });
  }

  const Moving<Int>& moving_;
  bool all_;
  std::vector<Meeting<Int>> meetings_;
  std::vector<Found> found_;
};

}  // namespace minkref::sampled
