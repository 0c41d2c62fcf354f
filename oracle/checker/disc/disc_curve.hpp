// Curves that may bound the sum of a region with a disc, and what lies along them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "oracle/checker/disc/disc_edges.hpp"
#include "oracle/checker/disc/root.hpp"

namespace minkref::checker {

/// A joint's number, or the edge or arc that goes on at an end of a curve.
struct Key {
  enum class Kind : std::uint8_t { none, joint, edge, arc } kind = Kind::none;
  std::uint32_t number = 0;
  bool is_joint() const { return kind == Kind::joint; }
  friend auto operator<=>(const Key&, const Key&) = default;
};

/// On a curve. `mark`: how far along an edge (`x`), or the direction from a vertex.
struct Place {
  RootPoint at, mark;
  Key key;
};

/// The region's edges with what the sum needs: edges near each edge, and the edge before each one
/// clockwise. Rings are simple, meet at vertices and have P on their left, or NotVerified is
/// thrown.
class DiscRegion : public DiscEdges {
 public:
  DiscRegion(const Operand& P, const mpq_class& square, Budget& budget);

  using DiscEdges::along, DiscEdges::budget_, DiscEdges::count, DiscEdges::height,
      DiscEdges::square_, DiscEdges::winds;
  const Point& at(std::uint32_t n) const { return at_[n]; }
  const Point& end_of(std::uint32_t n) const { return at_[next_[n]]; }
  bool has_end(std::uint32_t n, const Point& p) const { return at(n) == p || end_of(n) == p; }
  std::uint32_t before(std::uint32_t n) const { return before_[n]; }
  bool turns_left(std::uint32_t n) const { return cross(along(before_[n]), along(n)) > 0; }
  const std::vector<std::uint32_t>& near(std::uint32_t n) const { return near_[n]; }
  Key key_after(std::uint32_t n) const;
  /// The sign of the distance of a point from an edge less the radius.
  int far(const RootPoint& p, std::uint32_t f) const;
  /// The same number for all edges of a component of the sum.
  std::uint32_t component(std::uint32_t n) const;
  std::size_t components() const;
  std::string of_radius() const { return DiscEdges::of_radius(); }

 private:
  bool joins(std::uint32_t n, std::uint32_t f) const;
  std::uint32_t around(std::size_t ring) const;
  std::uint32_t first_right(std::uint32_t n, const std::vector<std::uint32_t>& arriving) const;

  std::vector<std::vector<std::uint32_t>> rings_;
  std::vector<std::uint32_t> ring_, before_, after_, root_;
  std::vector<std::vector<std::uint32_t>> near_;
};

class DiscCurve;
struct DiscPiece {
  Key start, end;
  const DiscCurve* curve;
};
struct FreePart {
  const DiscCurve* curve;
  Place from, to;
  std::size_t piece;
};

/// Collected along all curves.
struct Followed {
  std::vector<RootPoint> joints;
  std::map<Key, Key> ends;
  std::set<std::tuple<std::uint32_t, std::uint32_t, bool>> on;  ///< joints, by curve
  std::set<std::pair<std::uint32_t, std::uint32_t>> touched;    ///< joints and edges
  std::vector<FreePart> parts;
  std::vector<DiscPiece> pieces;
};

/// Edge n, moved to its right by the radius; or the arc about the vertex where edge n begins. P is
/// on the left.
class DiscCurve {
 public:
  DiscCurve(const DiscRegion& region, std::uint32_t n, bool is_arc);

  std::uint32_t edge() const { return n_; }
  bool is_arc() const { return is_arc_; }
  const Point& centre() const { return v_; }
  /// Follows the places and links of a walk. Throws NotVerified.
  void follow(const Value& walk, Followed& all) const;
  /// 1 if a mark comes after another, on an arc within half a turn.
  int order(const RootPoint& x, const RootPoint& y) const;
  /// As in the canonical form: an arc before a line, then numbers.
  std::vector<mpq_class> name() const;
  std::string what() const;

 private:
  struct Over {
    mpq_class height, along;
    friend bool operator<(const Over& a, const Over& b) {
      return a.height != b.height ? a.height < b.height : a.along < b.along;
    }
  };
  Place place(const Point& t, Key key = {}) const;
  Place joint(const Value& value, const Followed& all) const;
  Place end(const Value& value, const Place& end, Followed& all) const;
  Place between(const Value& value, const Followed& all) const;
  std::pair<Over, Over> over(std::uint32_t f) const;
  Root height(const RootPoint& p) const { return cross(minus(p, v_), along_); }
  bool is_nearest(std::uint32_t f, const Place& x, const Place& y) const;
  bool is_nearest_to_line(std::uint32_t f, const Place& x, const Place& y) const;
  void demand_free(const Place& x, const Place& y, Followed& all) const;
  void demand_blocked(const Place& x, const Place& y, std::uint32_t f) const;
  void demand_facing(const Place& x, const Place& y, std::uint32_t f) const;

  const DiscRegion& region_;
  std::uint32_t n_;
  bool is_arc_;
  Point v_, along_, tips_[2];
  mpq_class square_;  ///< the edge's squared length
  std::vector<Place> ends_;
};

}  // namespace minkref::checker
