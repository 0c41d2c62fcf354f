// Boundary events of sP + Q, and components and holes between and at them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "oracle/sampled/operand.hpp"

namespace minkref::sampled {

/// Counts for a state of the boundary: rings and vertices of the canonical form, components of the
/// interior, bounded components of the complement.
struct Counts {
  int rings = 0, vertices = 0, components = 0, holes = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

struct Event {
  mpq_class s;
  Counts below, at, above;
  bool same = false;  ///< the same moving vertices, joined in the same order, below and above
};

struct Question {
  Rings P, Q;  ///< integers; no more than one is a segment or a point
  std::optional<mpq_class> from, to;
  bool all_candidates = false;       ///< also those within the sum
  std::function<bool()> is_in_time;  ///< asked now and then
};

struct Answer {
  std::vector<Event> events;  ///< in the closed window, ascending
  Counts before;              ///< just below the first; without one, everywhere
  std::size_t candidates = 0, sums = 0, bits = 0;
};

/// A limit of time was reached.
struct OutOfTime : std::exception {};

/// A disagreement of the judge with itself: it has a fault, or an operand is not what it should be.
struct Fault : std::logic_error {
  using std::logic_error::logic_error;
};

/// The events by definition: s0 is none iff the rings are, around and at s0, the values of the same
/// cycles of tracks. Exact. O(n^3) for n segments, and for each candidate three sums of
/// O(n m log m) for m pairs of pieces. Throws BadOperand, OutOfTime, Fault.
Answer events(const Question& question);

}  // namespace minkref::sampled
