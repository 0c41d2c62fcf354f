// The step `clear`: over a range of scales no place on a path collides. docs/certificates-paths.md,
// "Clear"
#pragma once

#include "oracle/checker/motion/path_cells.hpp"

namespace minkref::checker {

class Clear {
 public:
  /// Checks the step with the given members. Throws NotVerified. `strict`: contact is forbidden.
  Clear(const PiecesOfBoth& by, bool strict, MovingPath path, Scales scales, const Value& normals,
        const Value& codes, const mpz_class& unit, Normals& table, Budget& budget);

  const bool strict;
  const MovingPath path;
  const Scales scales;

  /// Whether the normal separates all pieces from a place at all the scales.
  bool apart(const MovingPlace& place, const Vector& normal) const;

 private:
  /// The part of a cell not separated by the gap.
  Cell left(const Cell& cell, const Gap& gap) const;
  void follow(const Way& way, const std::vector<Value>& code) const;
  bool is_empty() const { return by_[0]->hulls.empty() || by_[1]->hulls.empty(); }

  const PiecesOfBoth by_;
  const mpz_class& unit_;
  Normals& table_;
  Budget& budget_;
  std::vector<Vector> normals_;
};

/// A normal of whole numbers, not both 0.
Vector read_normal(const Value& value);

}  // namespace minkref::checker
