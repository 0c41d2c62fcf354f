// The paper's whole program of Sec. 4: sP + Q followed from one scale to another with one
// arithmetic, each formula as read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "reference/paper/event_walk.hpp"
#include "reference/paper/plane/readings.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

/// The interface of a PaperUpdate, whatever its arithmetic.
class PaperUpdate {
 public:
  /// Finds the critical regions of all pairs of edges of the reduced convolution and the
  /// arrangement at the first scale. `arithmetic`: "rational", "interval", "double", "mpfr:BITS".
  /// Exact with exact arithmetic and corrected readings; otherwise the paper's formulas decide the
  /// result. Throws BadInput for bad operands, scales and arithmetics, LimitExceeded if the regions
  /// take more than `memory` bytes (0: no limit), UndecidedSign where "interval" cannot tell a
  /// sign. The same whatever the number of threads. O(N^2 + k log k) for N edges and k regions.
  static std::unique_ptr<PaperUpdate> make(const PolygonSet& P, const PolygonSet& Q,
                                           const Rational& first_scale,
                                           const std::string& arithmetic, const Readings& readings,
                                           std::uint64_t memory = 0, unsigned threads = 1);
  virtual ~PaperUpdate() = default;

  using Step = WalkStep;
  /// Steps through the array of events up or down to a scale s > 0 (Sec. 4.2.4). Throws BadInput
  /// for other scales. O(events crossed); with intersections kept in order, times the logarithm and
  /// the length of an edge's list.
  virtual Step move_to(const Rational& scale) = 0;

  /// Gives each intersection on the list its place, x0 + (s - 1) sigma, at the walk's current scale
  /// ("we update all of the remaining nodes"), and returns their number; intersections of parallel
  /// edges have no place. O(N + k).
  virtual std::size_t place_intersections() = 0;

  /// Does the work that the update saves: finds the intersections at a scale s > 0 by Observation 1
  /// for all pairs of edges, with the same arithmetic, without the list; returns their number.
  /// Unlike the list, this number counts the common vertices of edges, once for each pair. Throws
  /// BadInput for other scales, UndecidedSign. O(N^2).
  virtual std::size_t search_intersections(const Rational& scale) const = 0;

  /// Loops, nesting and collision detection (Sec. 3) at the list's current scale: the arithmetic's
  /// answer, as a canonical form. O((N + k) log N).
  virtual Sum sum() = 0;

  /// An event of the array: two edges of the reduced convolution begin or cease to meet.
  struct Event {
    Rational scale;  ///< the arithmetic's scale, exactly
    std::uint32_t a = 0, b = 0;
    bool insertion = false;
  };
  virtual std::vector<Event> events() const = 0;

  struct Counts {
    std::uint64_t edges = 0, pairs = 0;  ///< pairs that were looked at
    std::uint64_t regions = 0;           ///< pairs that meet at some scale
    std::uint64_t undecided = 0;         ///< pairs left out: a sign was NaN
  };
  virtual Counts counts() const = 0;
};

}  // namespace minkref::inline plane
