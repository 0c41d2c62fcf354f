// Convex cells with edges on lines that move parallel to themselves, linearly in the scale.
#pragma once

#include <array>
#include <optional>

#include "certify/plane/piece_tree.hpp"

namespace minkref::certify {

inline constexpr std::uint32_t nothing = 0xffffffffU;

/// The origin of a line, as a certificate states it.
struct LineSource {
  enum class Kind : std::uint8_t {
    wall,  ///< a: side of the box: left, bottom, right, top
    P,     ///< through vertices a and b of P, moved by vertex c of Q
    Q,     ///< through vertices a and b of Q, moved by vertex c of P
    up     ///< vertical, through corner a
  };
  Kind kind = Kind::wall;
  std::uint32_t a = 0, b = 0, c = 0;
};

/// normal * x = constant + slope s, with a normal whose x, or else y, is positive.
struct MovingLine {
  LineSource source;
  std::uint32_t normal = 0;
  Rational constant, slope;
  Value here;  ///< constant + slope s at the scale of the complex
};

/// A point that moves with the scale, as the meet of two lines.
struct Corner {
  Place place;
  std::uint32_t first = nothing, second = nothing;  ///< lines
};

/// Counter-clockwise; edge i runs from corner i along line i.
struct Cell {
  std::vector<std::uint32_t> corners, lines;
};

/// (x, y) = constant + slope s.
struct MovingPoint {
  Point constant, slope;
};

/// Lines and corners, each once, at one scale.
class CellComplex {
 public:
  CellComplex(const PieceTree& P, const PieceTree& Q, NormalTable& normals, Rational scale,
              const std::array<Rational, 4>& box);

  const PieceTree& P() const { return P_; }
  const PieceTree& Q() const { return Q_; }
  NormalTable& normals() const { return normals_; }
  const Rational& scale() const { return scale_; }
  const std::array<Rational, 4>& box() const { return box_; }
  const std::vector<MovingLine>& lines() const { return lines_; }
  const std::vector<Corner>& corners() const { return corners_; }

  /// Adds the line of a P- or Q-source unless the line exists already. Returns the line's number.
  std::uint32_t line(const LineSource& source);
  std::uint32_t vertical_through(std::uint32_t corner);
  /// Adds the corner of two lines, not parallel, unless the corner exists. Returns its number.
  std::uint32_t meet(std::uint32_t first, std::uint32_t second);
  std::optional<std::uint32_t> corner_at(const Point& point) const;
  bool parallel(std::uint32_t first, std::uint32_t second) const;

  /// The sign of normal * corner - (constant + slope s). Exact.
  int side_of(std::uint32_t line, std::uint32_t corner) const;
  /// The largest value of a normal on sA + B, exact; and in doubles, with an error bound.
  Rational most(std::uint32_t A, std::uint32_t B, std::uint32_t normal) const;
  struct Estimate {
    double value, error;
  };
  Estimate estimate(std::uint32_t A, std::uint32_t B, std::uint32_t normal) const;
  /// The sign of normal * corner - most(A, B, normal). Exact.
  int side_of_pair(std::uint32_t A, std::uint32_t B, std::uint32_t normal,
                   std::uint32_t corner) const;

  /// Cuts a cell: the part where normal * x <= the line's value (`below`), and the rest. Empty
  /// parts are left out.
  struct Parts {
    std::optional<Cell> below, above;
  };
  Parts cut(const Cell& cell, std::uint32_t line);

  /// A corner as a moving point. Exact.
  MovingPoint moving(std::uint32_t corner) const;

 private:
  struct Less {
    bool operator()(const Point& a, const Point& b) const {
      return a.x != b.x ? a.x < b.x : a.y < b.y;
    }
  };
  std::uint32_t add_line(const LineSource& source, const Rational& nx, const Rational& ny,
                         const Rational& constant, const Rational& slope);

  const PieceTree &P_, &Q_;
  NormalTable& normals_;
  Rational scale_;
  double approximate_scale_;
  std::array<Rational, 4> box_;
  std::vector<MovingLine> lines_;
  std::map<std::pair<std::uint32_t, Rational>, std::uint32_t> line_at_;
  std::vector<Corner> corners_;
  std::map<Point, std::uint32_t, Less> corner_at_;
};

}  // namespace minkref::certify
