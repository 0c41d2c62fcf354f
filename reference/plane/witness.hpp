// Points that settle a disagreement: membership in a sum decided from the definition, with p and q.
#pragma once

#include <memory>
#include <optional>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// How `sP` and `x - Q` meet: not at all, with disjoint interiors, or with interiors in common.
enum class Contact { empty, touching, overlapping };

struct Witness {
  Point point;
  Contact contact = Contact::empty;
  std::optional<Point> p, q;  ///< p in P, q in Q with s p + q = x, unless empty
};

/// Decides points by pairs of triangles, from P and from x - Q, without the convolution. A point or
/// a segment as an operand counts with its relative interior.
class Membership {
 public:
  /// Triangulates both operands, which must have passed `validate`; O(m^2 + n^2).
  Membership(const PolygonSet& P, const PolygonSet& Q, const Rational& scale);
  ~Membership();
  Membership(Membership&&) noexcept;

  /// Exact. O(mn) pairs of triangles at worst; boxes discard most.
  Witness decide(const Point& x) const;

  /// The contact that decide(x) finds, without p and q. Exact: doubles tell most overlaps, with a
  /// proof.
  Contact contact(const Point& x) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One point.
Witness decide(const PolygonSet& P, const PolygonSet& Q, const Rational& scale, const Point& x);

/// An interior point of the symmetric difference of two sets given by rings (as for canonicalize),
/// none if they are equal as regular closed sets; with few digits if possible. `in_first` tells the
/// set that holds the point.
struct Difference {
  Point point;
  bool in_first = false;
};
std::optional<Difference> difference(const PolygonSet& first, const PolygonSet& second);

}  // namespace minkref::inline plane
