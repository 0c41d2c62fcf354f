// Boundary events of sP + Q; components and holes at and between the events.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "oracle/sampled/operand.hpp"

namespace minkref::sampled {

/// Counts for a boundary state: rings and vertices of the canonical form, components of the
/// interior, bounded components of the complement.
struct Counts {
  int rings = 0, vertices = 0, components = 0, holes = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

struct Event {
  mpq_class s;
  Counts below, at, above;
  bool same = false;  ///< same moving vertices, in the same order, below and above
};

struct Question {
  Rings P, Q;  ///< integers; at most one is a segment or a point
  std::optional<mpq_class> from, to;
  bool all_candidates = false;       ///< including scales within the sum
  std::function<bool()> is_in_time;  ///< asked now and then
};

struct Answer {
  std::vector<Event> events;  ///< in the closed window, ascending
  Counts before;              ///< just below the first event; everywhere if there is none
  std::size_t candidates = 0, sums = 0, bits = 0;
};

/// A time limit was reached.
struct OutOfTime : std::exception {};

/// The judge contradicts itself: the judge is faulty, or an operand breaks the rules.
struct Fault : std::logic_error {
  using std::logic_error::logic_error;
};

/// Finds the events by definition: s0 is no event iff, around and at s0, the same cycles of tracks
/// give the rings. Exact. O(n^3) for n segments, and for each candidate three sums of O(n m log m)
/// for m pairs of pieces. Throws BadOperand, OutOfTime, Fault.
Answer events(const Question& question);

}  // namespace minkref::sampled
