// The sum's boundary at one scale: segment parts with no sum of two pieces to their right.
#pragma once

#include "oracle/sampled/candidates.hpp"

namespace minkref::sampled {

/// A piece of the boundary, the sum to its left.
template <class Int>
struct BoundaryEdge {
  int direction;
  int segment;  ///< some segment that bears the piece
  Int offset;
  Point<Int> from, to;
};

template <class Int>
class Boundaries {
 public:
  explicit Boundaries(const Moving<Int>& moving) : moving_(moving) {
    for (const Segment<Int>& s : moving.segments) {
      for (const Piece<Int>& piece : moving.pieces) {
        for (const HalfPlane<Int>& h : piece) {
          table_.push_back({{Int(h.d.x * s.y.a - h.d.y * s.x.a - h.offset.a),
                             Int(h.d.x * s.y.b - h.d.y * s.x.b - h.offset.b)},
                            cross(h.d, s.d),
                            dot(h.d, s.d) < 0});
        }
      }
    }
  }

  /// Returns maximal edges, united on each line; each ends where another begins, but may pass
  /// through other edges' ends. `same`: whether segments on one line share a line at all scales, as
  /// always between candidates.
  std::vector<BoundaryEdge<Int>> at(const Fraction<Int>& s, bool& same) {
    if constexpr (!std::is_same_v<Int, mpz_class>) {
      const long double d = moving_.direction;
      demand_room<Int>(64 * moving_.coefficient * (size_of(s.p) + size_of(s.q)) * d * d * d * d *
                       d);
    }
    std::vector<BoundaryEdge<Int>> edges;
    std::size_t row = 0;
    for (std::size_t k = 0; k < moving_.segments.size(); ++k) add_bare_parts(k, s, row, edges);
    same = true;
    return united(std::move(edges), same);
  }

 private:
  struct Row {  ///< For a segment and a half-plane: the value along the segment is `start` + t
                ///< `slope`.
    Linear<Int> start;
    Int slope;
    bool is_against;
  };
  struct Interval {
    Fraction<Int> from, to;
  };

  /// Finds the part of [0, length] with a piece just to its right; false without such a part.
  bool covered(const Fraction<Int>& s, const Row* row, std::size_t count, Interval& t) const {
    for (std::size_t h = 0; h < count; ++h, ++row) {
      const Int start = row->start.at(s);
      if (row->slope == 0) {
        if (start < 0 || (start == 0 && !row->is_against)) return false;
        continue;
      }
      const bool rises = row->slope > 0;
      const Fraction<Int> root{rises ? Int(-start) : start, rises ? row->slope : Int(-row->slope)};
      if (rises ? t.from < root : root < t.to) (rises ? t.from : t.to) = root;
      if (t.to <= t.from) return false;
    }
    return true;
  }

  void add_bare_parts(std::size_t k, const Fraction<Int>& s, std::size_t& row,
                      std::vector<BoundaryEdge<Int>>& edges) {
    const Segment<Int>& segment = moving_.segments[k];
    const Interval whole{{Int(0), Int(1)}, {segment.length.at(s), Int(1)}};
    intervals_.clear();
    bool is_covered = false;
    for (const Piece<Int>& piece : moving_.pieces) {
      Interval t = whole;
      if (!is_covered && covered(s, &table_[row], piece.size(), t)) {
        is_covered = t.from == whole.from && t.to == whole.to;
        intervals_.push_back(t);
      }
      row += piece.size();
    }
    if (is_covered) return;
    std::sort(intervals_.begin(), intervals_.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
    Fraction<Int> reached = whole.from;
    const auto add = [&](const Fraction<Int>& to) {
      if (!(reached < to)) return;
      edges.push_back({segment.direction, static_cast<int>(k), segment.offset.at(s),
                       along(segment, s, reached), along(segment, s, to)});
    };
    for (const Interval& t : intervals_) {
      add(t.from);
      if (reached < t.to) reached = t.to;
    }
    add(whole.to);
  }

  static Point<Int> along(const Segment<Int>& a, const Fraction<Int>& s, const Fraction<Int>& t) {
    return reduced<Int>(Int(a.x.at(s) * t.q + t.p * a.d.x), Int(a.y.at(s) * t.q + t.p * a.d.y),
                        t.q);
  }

  std::vector<BoundaryEdge<Int>> united(std::vector<BoundaryEdge<Int>> edges, bool& same) const {
    const auto place = [&](const BoundaryEdge<Int>& e, const Point<Int>& x) {
      const Vec<Int>& d = moving_.directions[static_cast<std::size_t>(e.direction)];
      return Fraction<Int>{Int(d.x * x.x + d.y * x.y), x.w};
    };
    std::sort(edges.begin(), edges.end(),
              [&](const BoundaryEdge<Int>& a, const BoundaryEdge<Int>& b) {
                if (a.direction != b.direction) return a.direction < b.direction;
                if (a.offset != b.offset) return a.offset < b.offset;
                return place(a, a.from) < place(b, b.from);
              });
    std::vector<BoundaryEdge<Int>> result;
    for (const BoundaryEdge<Int>& e : edges) {
      if (!result.empty() && result.back().direction == e.direction &&
          result.back().offset == e.offset && place(e, e.from) <= place(e, result.back().to)) {
        if (place(e, result.back().to) < place(e, e.to)) result.back().to = e.to;
        const auto line = [&](int k) {
          return moving_.segments[static_cast<std::size_t>(k)].offset;
        };
        same = same && line(result.back().segment) == line(e.segment);
      } else {
        result.push_back(e);
      }
    }
    return result;
  }

  const Moving<Int>& moving_;
  std::vector<Row> table_;
  std::vector<Interval> intervals_;
};

}  // namespace minkref::sampled
