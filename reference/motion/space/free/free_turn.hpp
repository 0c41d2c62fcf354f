// The event at which a question about free places turns.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "reference/motion/space/free/bounded_free_places.hpp"
#include "reference/motion/space/free/free_events.hpp"

namespace minkref::inline space {

/// Whether a place is free at a scale, contact being allowed.
using IsFree = std::function<bool(const Rational&, const SpacePoint&)>;

struct FoundTurn {
  Rational scale;
  SpacePoint at;                                  ///< a place that is free with contact alone
  std::vector<std::pair<Rational, bool>> proofs;  ///< scale, whether it is small
};

/// A question about free places that holds at small scales, up to some event, and not above.
class FreeTurn {
 public:
  using Question = std::function<bool(const FreeProblemAt&)>;

  FreeTurn(const Polyhedron& turned, const Polyhedron& obstacles, Question small)
      : turned_(turned), obstacles_(obstacles), small_(std::move(small)) {}

  bool is_small(const Rational& scale, FreeRoute route = FreeRoute::definition) const;

  /// Halves a scale until small, then halves the bracket between the last two ten times.
  std::pair<Rational, Rational> bracket(Rational high) const;

  /// Finds the last event with small scales below and none above, among events between a small
  /// scale and `high`, and finds it again by the other route. None if all scales below `high` are
  /// small; `is_high_large`: `high` is not. Exact.
  std::optional<FoundTurn> find(const FreeEvents& events, const Rational& low, const Rational& high,
                                bool is_high_large, const IsFree& is_free) const;

 private:
  /// A point per tight passage; none if too many to find. Exact.
  std::vector<SpacePoint> passages_at(const Rational& scale) const;

  const Polyhedron &turned_, &obstacles_;
  Question small_;
};

}  // namespace minkref::inline space
