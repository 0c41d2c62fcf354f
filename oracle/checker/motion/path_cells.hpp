// Places of a segment at a range of scales, and what is linear on them.
// docs/certificates-paths.md, "Cells"
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "oracle/checker/plane/pieces.hpp"

namespace minkref::checker {

/// At t / w along a segment and the scale s / w; w = 0: far up.
struct Corner {
  mpz_class t, s, w;
  friend bool operator==(const Corner&, const Corner&) = default;
};
using Cell = std::vector<Corner>;  ///< a convex polygon, a segment or a point

/// a t + b s + c w.
struct Gap {
  mpz_class a, b, c;
  mpz_class at(const Corner& corner) const { return a * corner.t + b * corner.s + c * corner.w; }
};

/// The part of a cell where the gap is not positive.
Cell not_above(const Gap& gap, const Cell& cell);
/// A cell cut in the middle of its places: the later half, the earlier one.
std::array<Cell, 2> halves(const Cell& cell);

/// Just below a scale, or just above it; without a scale: infinity.
struct Cut {
  std::optional<mpq_class> scale;
  bool above = false;
  friend bool operator==(const Cut&, const Cut&) = default;
  friend bool operator<(const Cut& a, const Cut& b) {
    if (a.scale && b.scale && *a.scale == *b.scale) return !a.above && b.above;
    return a.scale && (!b.scale || *a.scale < *b.scale);
  }
};

/// All scales from one to another, each of which belongs to them or does not.
struct Scales {
  Cut low, high;
  explicit Scales(const Value& value);
  bool operator==(const Scales&) const = default;
  std::array<Corner, 2> ends() const;  ///< with t = 0
  mpq_class middle() const;            ///< one of the scales
  /// Whether a hull of corners has a point at one of the scales, and not only at an end that does
  /// not belong to them.
  bool meet(const Cell& corners) const;
  std::string said() const;
};

using Path = std::vector<Point>;
Path read_path(const Value& value);

/// The place at + s slope.
struct MovingPlace {
  Point at, slope;
  friend bool operator==(const MovingPlace&, const MovingPlace&) = default;
};
using MovingPath = std::vector<MovingPlace>;
MovingPlace moving(const Value& value);
/// Reads places with two numbers, which stay, or with four: x0, x1, y0, y1.
MovingPath read_moving_path(const Value& value);
MovingPath staying(const Path& path);

/// From each place to the next; of one place a segment from it to itself.
template <class Place>
std::vector<std::pair<Place, Place>> segments(const std::vector<Place>& path) {
  std::vector<std::pair<Place, Place>> found;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) found.emplace_back(path[i], path[i + 1]);
  if (found.empty()) found.emplace_back(path[0], path[0]);
  return found;
}

/// The step `pieces` of R, and that of O.
using PiecesOfBoth = std::array<const Pieces*, 2>;

/// A segment of places of R, in whole numbers. Its ends may move with the scale, its direction d
/// may not: the places p(s) + t d for 0 <= t <= (q(s) - p(s)) / d.
class Way {
 public:
  /// Throws NotVerified where the segment turns between the first and the last scale.
  Way(const PiecesOfBoth& by, const std::pair<MovingPlace, MovingPlace>& ends, const Scales& scales,
      const mpz_class& unit, Normals& normals);
  /// All t and s of the segment at the scales.
  const Cell& cell() const { return cell_; }
  /// Positive where n (x + s a) > n b for all a of node A of R and b of node B of O.
  Gap gap(const Vector& normal, std::uint32_t A, std::uint32_t B) const;

 private:
  const PiecesOfBoth& by_;
  Normals& normals_;
  mpz_class parts_, square_;
  Vector start_, slope_, along_;
  Cell cell_;
};

/// Normals of half-planes that have in common a convex polygon, a segment or a point.
std::vector<Vector> sides(const std::vector<Vector>& ring);

}  // namespace minkref::checker
