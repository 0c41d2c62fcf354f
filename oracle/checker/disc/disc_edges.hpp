// A region's edges, met by discs with a common radius.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "oracle/checker/budget.hpp"
#include "oracle/checker/reading.hpp"
#include "oracle/checker/unions/sides.hpp"

namespace minkref::checker {

inline Point plus(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }

/// Returns the point of a segment that is nearest to a point.
Point nearest(const Point& p, const Point& a, const Point& b);
mpq_class squared_distance(const Point& p, const Point& a, const Point& b);

/// A region's edges. An edge has the number of its first vertex.
class DiscEdges {
 public:
  /// Throws NotVerified for a point or a segment, and for an edge of length zero.
  DiscEdges(const Operand& P, mpq_class square, Budget& budget);

 protected:
  std::uint32_t count() const { return static_cast<std::uint32_t>(at_.size()); }
  Point along(std::uint32_t n) const { return minus(at_[next_[n]], at_[n]); }
  /// How far a point is right of an edge, times the edge's length.
  mpq_class height(std::uint32_t n, const Point& p) const {
    return cross(minus(p, at_[n]), along(n));
  }
  /// How often rings wind around a point off all edges; right of edge `but`, if the point is on it
  /// and `way` leads there.
  int winds(const Point& p, const Point& way = {1, 0}, std::uint32_t but = UINT32_MAX) const;
  std::string of_radius() const { return ", squared radius " + square_.get_str(); }

  const std::vector<Point>& at_;
  mpq_class square_;
  Budget& budget_;
  std::vector<std::uint32_t> next_, last_;
};

/// Follows one claim and returns a line about it.
using FollowClaim = std::function<std::string(const Value& claim)>;
/// Makes the proof for a region and a squared radius.
using MakeProof = std::function<FollowClaim(const Operand& P, const mpq_class& square)>;

/// Returns a certificate's proven claims, a line each. `read_case` reads the case from the path
/// named by the certificate. Throws NotVerified.
std::vector<std::string> check_discs(const Value& certificate,
                                     const std::function<Value(const std::string&)>& read_case,
                                     const MakeProof& make);

}  // namespace minkref::checker
