// P ⊕ ρD for all ρ: the parts of the outer Voronoi diagram that carry the corners, between any two
// consecutive events.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/diagram/diagram_graph.hpp"
#include "reference/disc/index/corner_motion.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {

/// The sum's boundary at one radius: rings, with the sum on the left, as sides of P.
struct IndexRing {
  /// Corners, named by the diagram halves that carry them: the ring joins the boundary there. A
  /// ring without corners is the whole walk.
  std::uint32_t first_corner, last_corner;  ///< of IndexBoundary::corners, last excluded
  std::uint32_t walk;
};

/// From one corner to the next: so many sides of a walk, from the first corner's side on.
struct IndexCorner {
  std::uint32_t half;
  std::uint32_t walk, first_side, sides;
};

struct IndexBoundary {
  std::vector<IndexRing> rings;
  std::vector<IndexCorner> corners;

  void clear() {
    rings.clear();
    corners.clear();
  }
};

/// A radius within the curves' frame: the square, and the sum of two doubles, off by at most `off`.
struct FrameRadius {
  Rational squared;
  TwoDoubles near;
  double off;

  /// The most that a corner in doubles may err; one that errs more is found from roots.
  double widest_error() const { return 0x1p-43 * (1 + near.high); }
};

/// Built once. Each decision of a query compares the radius with event radii: exact.
class DiscIndex {
 public:
  /// The index of a valid polygon set, a point or a segment. Errors and cost as for diagram_events.
  explicit DiscIndex(const PolygonSet& P, const BuildOptions& options = {})
      : DiscIndex(diagram_events(P, options)) {}
  /// Builds the index from a complete event list.
  explicit DiscIndex(DiagramEvents diagram);

  const DiagramEvents& diagram() const { return diagram_; }
  const DiagramGraph& graph() const { return graph_; }
  /// The number of different radii at which something changes.
  std::uint32_t radii() const { return static_cast<std::uint32_t>(radii_.size()); }
  /// An event at the k-th radius, from 0 on.
  std::uint32_t event_at(std::uint32_t radius) const { return radii_[radius].event; }

  /// The number of a node's radius, from 1 on: 0 for a reflex vertex, and infinity comes last.
  /// `low(half)`, `high(half)`: radius numbers at the half's lower and upper end.
  std::uint32_t radius_number(std::uint32_t node) const {
    if (graph_.is_event(node)) return numbers_[node];
    return graph_.is_infinite(node) ? radii() + 1 : 0;
  }
  std::uint32_t low(std::uint32_t half) const { return low_[half]; }
  std::uint32_t high(std::uint32_t half) const { return high_[half]; }
  bool rises(std::uint32_t half) const { return is_rising_[half] != 0; }
  /// At an event's radius: numbers the places that the disc just fits into with smaller radii, so
  /// that the state just below holds {d > ρ}, closed, in place of {d >= ρ}. Nodes without a half to
  /// larger distances go below, and so does each flat ridge between two nodes, cut in its middle,
  /// for which the graph gets a node with the number 0. Nothing else changes, at other radii the
  /// flat ridges too. Tells whether there was such a place. Exact. O(n) for
  /// each half in a chain of halves without length.
  bool fill_fits(const Rational& squared_radius);

  struct Place {
    std::uint32_t gap;  ///< how many radii of events are not above
    bool at_event;      ///< the last of them is this one
  };
  /// Finds a radius among the event radii, by squares. Exact. O(log n).
  Place place(const Rational& squared_radius) const;

  /// The boundary at the radii of a gap. O(n) for n halves of the diagram with a corner near it.
  void boundary(std::uint32_t gap, IndexBoundary& found) const;

  /// All vertices of the boundary at a radius within the gap, ring by ring: corners, and joints,
  /// where lines go on as arcs. `starts` holds the rings' starts. Each vertex errs by at most 2^-42
  /// of the size of P and of the radius, and 2^-50 of the vertex's coordinates. Each corner takes
  /// one rounded square root; a corner that doubles do not know so well is found from roots.
  void vertices(const IndexBoundary& boundary, double radius, std::vector<BoundedPoint>& found,
                std::vector<std::uint32_t>& starts) const;

  /// Converts a squared radius from coordinates of P to the frame.
  FrameRadius in_frame(const Rational& squared_radius) const;
  /// The same from the radius itself.
  FrameRadius frame_radius(const Rational& radius) const;
  /// The corner on a half that has one, within the frame; error as above.
  BoundedPoint corner(std::uint32_t half, const FrameRadius& radius) const;
  /// The same from doubles alone, with whatever error; of a radius known up to `off`.
  BoundedPoint rounded_corner(std::uint32_t half, const TwoDoubles& radius, double off) const;
  /// The same from roots, as near as a double can be.
  BoundedPoint corner_from_roots(std::uint32_t half, const FrameRadius& radius) const;
  const CornerMotion& motion(std::uint32_t half) const { return motions_[half]; }
  /// A point within the frame as one of P's plane; the error grows by what is rounded.
  BoundedPoint as_given(const BoundedPoint& in_frame) const;

 private:
  struct Radius {
    std::uint32_t event;
    Interval squared;  ///< in the frame of the curves
  };
  /// Consecutive gaps, and the halves with a corner within any of these gaps, ordered along the
  /// walks.
  struct Span {
    struct Half {
      std::uint32_t number, low, high;
    };
    std::vector<Half> halves;
    std::vector<std::uint32_t> bounds;  ///< of walks
  };
  void number_radii();
  void order_ends();
  void cut_flats(const std::vector<char>& is_to_cut);
  void part_gaps();
  void count_sides();
  void place_joints();
  template <class Do>
  void for_joints(std::uint32_t walk, std::uint32_t side, std::uint32_t sides, Do&& act) const;
  std::uint32_t sides_between(std::uint32_t walk, std::uint32_t entry, std::uint32_t exit) const;

  DiagramEvents diagram_;
  DiagramGraph graph_;
  std::vector<Radius> radii_;
  std::vector<std::uint32_t> numbers_;  ///< of the radii of events
  std::vector<std::uint32_t> low_, high_;
  std::vector<char> is_rising_;
  std::uint32_t gaps_of_span_ = 1;
  std::vector<Span> spans_;
  /// Links from corners to rings, by half.
  struct Way {
    std::uint32_t twin, to_side;
    std::uint32_t start, end;  ///< sides of the walk that are passed
  };
  std::vector<Way> ways_;
  std::vector<CornerMotion> motions_;         ///< by half
  std::vector<JointMotion> joints_;           ///< in the order of the sides that they end
  std::vector<std::uint32_t> joints_before_;  ///< by side
  double scale_ = 1, x_ = 0, y_ = 0;          ///< from the frame of the curves to that of P
  double origin_error_ = 0;
};

}  // namespace minkref::inline disc
