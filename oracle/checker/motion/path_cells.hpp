// Places on a segment over a range of scales, and linear functions on them.
// docs/certificates-paths.md, "Cells"
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "oracle/checker/plane/pieces.hpp"

namespace minkref::checker {

/// The place t / w along a segment and the scale s / w; w = 0: far up.
struct Corner {
  mpz_class t, s, w;
  friend bool operator==(const Corner&, const Corner&) = default;
};
using Cell = std::vector<Corner>;  ///< a convex polygon, a segment or a point

/// The linear function a t + b s + c w.
struct Gap {
  mpz_class a, b, c;
  mpz_class at(const Corner& corner) const { return a * corner.t + b * corner.s + c * corner.w; }
};

/// Returns the part of a cell where the gap is not positive.
Cell not_above(const Gap& gap, const Cell& cell);
/// Cuts a cell halfway between its places: the later half, the earlier half.
std::array<Cell, 2> halves(const Cell& cell);

/// A cut just below a scale, or just above it; without a scale: infinity.
struct Cut {
  std::optional<mpq_class> scale;
  bool above = false;
  friend bool operator==(const Cut&, const Cut&) = default;
  friend bool operator<(const Cut& a, const Cut& b) {
    if (a.scale && b.scale && *a.scale == *b.scale) return !a.above && b.above;
    return a.scale && (!b.scale || *a.scale < *b.scale);
  }
};

/// A range of scales; each end belongs to the range or not.
struct Scales {
  Cut low, high;
  explicit Scales(const Value& value);
  bool operator==(const Scales&) const = default;
  std::array<Corner, 2> ends() const;  ///< with t = 0
  mpq_class middle() const;            ///< some scale between the ends
  /// Whether a hull of corners has a point at some scale of the range, not just at an excluded end.
  bool meet(const Cell& corners) const;
  std::string said() const;
};

using Path = std::vector<Point>;
Path read_path(const Value& value);

/// The place `at` + s `slope`.
struct MovingPlace {
  Point at, slope;
  friend bool operator==(const MovingPlace&, const MovingPlace&) = default;
};
using MovingPath = std::vector<MovingPlace>;
MovingPlace moving(const Value& value);
/// Reads places: two numbers for a fixed place, or four: x0, x1, y0, y1.
MovingPath read_moving_path(const Value& value);
MovingPath staying(const Path& path);

/// Returns the segments from each place to the next; for a single place, a segment from the place
/// to itself.
template <class Place>
std::vector<std::pair<Place, Place>> segments(const std::vector<Place>& path) {
  std::vector<std::pair<Place, Place>> found;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) found.emplace_back(path[i], path[i + 1]);
  if (found.empty()) found.emplace_back(path[0], path[0]);
  return found;
}

/// The steps `pieces` for R and for O.
using PiecesOfBoth = std::array<const Pieces*, 2>;

/// A segment of places for R, with whole numbers. The ends may move with the scale while the
/// direction d stays: the places p(s) + t d for 0 <= t <= (q(s) - p(s)) / d.
class Way {
 public:
  /// Throws NotVerified where the segment turns between the first and the last scale.
  Way(const PiecesOfBoth& by, const std::pair<MovingPlace, MovingPlace>& ends, const Scales& scales,
      const mpz_class& unit, Normals& normals);
  /// The segment's t and s at all the scales.
  const Cell& cell() const { return cell_; }
  /// Positive where n (x + s a) > n b for all points a of R's node A and b of O's node B.
  Gap gap(const Vector& normal, std::uint32_t A, std::uint32_t B) const;

 private:
  const PiecesOfBoth& by_;
  Normals& normals_;
  mpz_class parts_, square_;
  Vector start_, slope_, along_;
  Cell cell_;
};

/// Returns normals of half-planes that intersect exactly in a convex polygon, a segment or a point.
std::vector<Vector> sides(const std::vector<Vector>& ring);

}  // namespace minkref::checker
