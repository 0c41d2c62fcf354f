// The paper's whole program of Sec. 5: sP + Q for polyhedra followed from one scale to another with
// one arithmetic, each sentence as read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/paper/event_walk.hpp"
#include "reference/paper/space/update_readings.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// The arithmetic's answer at one scale, facet by facet of the reduced convolution.
struct PaperSpaceSum {
  using Ring = std::vector<SpacePoint>;
  /// A facet's exposed part: rings with the part on the left, seen along the normal's longest axis
  /// (mirrored or not). Every arrangement node on a ring counts as a corner.
  struct Exposed {
    std::uint32_t facet;
    std::vector<Ring> rings;
  };
  /// A cell from a facet's arrangement, with the answer.
  struct Cell {
    std::uint32_t facet;
    SpacePoint inside;  ///< below the place for collision detection
    bool exposed;
  };

  std::string arithmetic;
  std::vector<Exposed> exposed;        ///< facets ascending
  std::vector<Cell> cells;             ///< facets ascending
  std::optional<PolyhedralSet> set{};  ///< in rational numbers
  std::uint64_t nodes = 0;             ///< of all facets' arrangements
  std::uint64_t asked = 0;             ///< cells that collision detection decided
};

/// Rings as seen along the plane's viewing axis, with the part on the left.
PolygonSet rings_in_view(const PaperSpaceSum::Exposed& part, const OrientedPlane& plane);

/// The interface of a PaperSpaceUpdate, whatever its arithmetic.
class PaperSpaceUpdate {
 public:
  /// Finds the crossings of all pairs of facets of the reduced convolution and the list of those at
  /// the first scale. `arithmetic`: "rational", "interval", "double", "mpfr:BITS". Exact with exact
  /// arithmetic and corrected readings; otherwise the paper's formulas decide the result. Operands
  /// must have passed `validate`. Throws BadInput for bad scales and arithmetics, and
  /// ("degenerate-operands") for operands without a volume; LimitExceeded if the crossings take
  /// more memory than `options` allow, UndecidedSign where "interval" cannot tell a sign. The same
  /// whatever the number of threads. Reports progress by facets. O(N^2 + k log k) for N facets and
  /// k crossings.
  static std::unique_ptr<PaperSpaceUpdate> make(const Polyhedron& P, const Polyhedron& Q,
                                                const Rational& first_scale,
                                                const std::string& arithmetic,
                                                const SpaceUpdateReadings& readings,
                                                const BuildOptions& options = {});
  virtual ~PaperSpaceUpdate() = default;

  using Step = WalkStep;
  /// Steps through the array of events up or down to a scale s > 0 (Sec. 4.2.4, 5). Throws BadInput
  /// for other scales. O(events crossed).
  virtual Step move_to(const Rational& scale) = 0;

  /// Gives each crossing on the list its place, x0 + (s - 1) sigma, at the walk's current scale
  /// ("we update all of the remaining nodes"), and returns their number. O(k).
  virtual std::size_t place_intersections() = 0;

  /// Pairs of facets: all of them, or those whose boxes meet at the scale.
  enum class Pairs : std::uint8_t { all, near };

  /// Does the work that the update saves: finds all crossings at a scale s > 0 from pairs of
  /// facets, with the same arithmetic and the system of Sec. 5.2; returns the number found. Unlike
  /// the list, the number counts common corners. Throws BadInput for a bad scale, UndecidedSign.
  /// O(N^2) for all pairs, O(N log N + k) for k near ones.
  virtual std::size_t search_intersections(const Rational& scale, Pairs pairs) const = 0;

  /// Arrangements on the facets and collision detection (Sec. 3) at the list's current scale.
  /// Reports progress by facets; throws LimitExceeded as `make` does. O(N c) for c cells, beside
  /// the collisions.
  virtual PaperSpaceSum sum(const BuildOptions& options = {}) = 0;

  /// An event of the array: a crossing of two facets begins or ends.
  struct Event {
    Rational scale;                       ///< the arithmetic's scale, exactly
    std::uint32_t first = 0, second = 0;  ///< facets, ascending
    std::uint32_t crossing = 0;  ///< of the two facets: which of their sides, one number each
    bool insertion = false;
  };
  /// Ascending. O(n).
  virtual std::vector<Event> events() const = 0;

  struct Counts {
    std::uint64_t facets = 0, pairs = 0;  ///< pairs that were looked at
    std::uint64_t crossings = 0;          ///< that exist at some scale
    std::uint64_t events = 0;
    std::uint64_t undecided = 0;  ///< pairs left out: a sign was NaN
  };
  virtual Counts counts() const = 0;

  /// A facet's plane at a scale, with the sum below. Exact.
  virtual OrientedPlane plane(std::uint32_t facet, const Rational& scale) const = 0;
};

/// The exact sum at one scale s > 0, facet by facet: the program's answer with rational numbers and
/// corrected readings, from pairs of facets with overlapping boxes. Reports progress twice, by
/// facets: crossings, arrangements. Throws as `make` does.
PaperSpaceSum facet_sum_at(const Polyhedron& P, const Polyhedron& Q, const Rational& scale,
                           const BuildOptions& options = {});

}  // namespace minkref::inline space
