// The Appendix's whole program: P grown by the disc sQ, followed from scale to scale in any
// arithmetic, each formula as read (Behar & Lien 2012, Appendix).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "reference/paper/disc/appendix_readings.hpp"
#include "reference/paper/disc/disc_answer.hpp"

namespace minkref::inline disc {

/// The interface of a DiscUpdate, whatever its arithmetic.
class DiscUpdate {
 public:
  struct Options {
    Rational squared_unit = 1;  ///< r²: the squared radius of the disc at s = 1
    /// "rational" (rational numbers and their square roots: exact), "double" or "mpfr:BITS".
    std::string arithmetic = "rational";
    AppendixReadings readings;
    std::uint64_t memory = 0;  ///< bytes of the process; 0: no limit
  };

  /// Finds the scales at which segments and arcs meet, for all pairs in the reduced convolution,
  /// and starts at a squared radius. Exact with exact arithmetic and corrected readings; otherwise
  /// the paper's formulas decide the result. P is a valid polygon set, a point or a segment. Throws
  /// BadInput ("bad-radius") for radii that are not above 0,
  /// ("unknown-arithmetic"), LimitExceeded beyond `memory`. O(N^2 + k log k) for N features and k
  /// meetings.
  static std::unique_ptr<DiscUpdate> make(const PolygonSet& P, const Rational& squared_radius,
                                          const Options& options);
  virtual ~DiscUpdate() = default;

  struct Step {
    std::uint64_t insertions = 0, deletions = 0;
    std::uint64_t updated = 0;  ///< intersections at the scale that is reached
  };
  /// Steps through the array of events up or down to the scale s = √(squared_radius / r²). Throws
  /// BadInput for radii that are not above 0. O(events crossed).
  virtual Step move_to(const Rational& squared_radius) = 0;

  /// Gives each intersection on the list its place, by I(s); returns their number. O(k).
  virtual std::size_t place_intersections() = 0;

  /// Does the work saved by the update: finds all intersections at a radius from all feature pairs,
  /// without the list, in the same arithmetic, with corrected formulas; returns their number.
  /// O(N^2).
  virtual std::size_t search_intersections(const Rational& squared_radius) const = 0;

  /// Loops, nesting and collision detection (Sec. 3) where the list stands: the arithmetic's
  /// answer. O((N + k) log N) and as much again for each face with a collision test.
  virtual DiscAnswer answer() = 0;

  /// An event of the array: two features begin or cease to share a point.
  struct Event {
    std::uint32_t a = 0, b = 0;
    std::int8_t branch = 0;
    bool is_overlap = false, insertion = false;
    double low = 0, high = 0;  ///< around the scale
  };
  virtual std::vector<Event> events() const = 0;

  /// Compares the array with the exact array for the same P and r. Right events agree in features
  /// and branch, and differ by at most 2^-`bits` times the scale.
  struct Agreement {
    std::uint64_t right = 0, misplaced = 0, missed = 0, invented = 0;
  };
  /// Throws std::logic_error unless `truth` is exact.
  virtual Agreement agreement(const DiscUpdate& truth, long bits) const = 0;

  struct Counts {
    std::uint64_t segments = 0, arcs = 0;
    std::uint64_t pairs = 0;      ///< that were looked at
    std::uint64_t meetings = 0;   ///< of pairs and branches that meet at some scale
    std::uint64_t undecided = 0;  ///< pairs left out: a number was NaN
  };
  virtual Counts counts() const = 0;

  virtual const OffsetCurves& curves() const = 0;
  virtual const std::vector<OffsetFeature>& features() const = 0;
  virtual Rational squared_radius() const = 0;
};

/// The canonical text of an answer, as that of the exact sum (docs/disc.md).
std::string canonical_json(const DiscAnswer& answer, const DiscUpdate& update);

}  // namespace minkref::inline disc
