// At which scales three facets of the convolution start or stop to share a point, or four share
// one.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "reference/space/critical/crossing_line.hpp"
#include "reference/space/critical/facet_event.hpp"

namespace minkref::inline space {

/// An event of three or four facets.
struct ConcurrentEvent {
  static constexpr std::uint32_t none = UINT32_MAX;
  static constexpr std::uint8_t no_side = UINT8_MAX;
  EventScale s;
  std::array<std::uint32_t, 4> facets;  ///< ascending; of three, the last is none
  ContactChange change;                 ///< pass: where two are in one plane always
  /// For three facets: the sides that single the point out, together with the planes of the facets
  /// without such a side.
  std::array<std::uint8_t, 3> sides{no_side, no_side, no_side};

  bool is_of_four() const { return facets[3] != none; }
};

/// The events of two facets with any facets that come after them.
///
/// The pairs (s, x) with x in each of three facets at the scale s form a convex set: over the scale
/// and the first two facets' crossing line, a segment, the *track* of the three. The track's ends
/// are events of the three, unless two facets alone have an event there. Two tracks on one crossing
/// line cross where four facets share a point; the crossing is an event unless fewer facets have an
/// event there. No two facets may be parallel. Exact.
class FacetTracks {
 public:
  struct Facet {
    std::uint32_t number;
    const MovingFacet* facet;
  };
  struct Window {
    const EventScale &from, &to;
    double first, last;  ///< rounded, outwards
  };

  /// All arguments must outlive the tracks.
  FacetTracks(const MovingConvolution& convolution, const Facet& first, const Facet& second,
              const Window& window, SignCounts& signs);
  FacetTracks(const FacetTracks&) = delete;
  FacetTracks& operator=(const FacetTracks&) = delete;

  /// Adds the track of a third facet within the window, if any, and the track's events.
  void add(const Facet& third, std::vector<ConcurrentEvent>& events);

  /// Adds the crossings between all pairs of tracks whose third facets `may_meet`.
  void add_crossings(const std::function<bool(std::uint32_t, std::uint32_t)>& may_meet,
                     std::vector<ConcurrentEvent>& events);

  std::size_t tracks() const { return tracks_.size(); }

 private:
  static constexpr std::size_t most_corners = 4, most_rows = 3 * most_corners + 2;
  struct Track {
    Facet third;
    ContactRow plane;
    std::array<ContactRow, most_corners> sides;
    double low, high;  ///< its scales are between
  };
  /// A facet and a side of the facet.
  struct Side {
    std::uint8_t of, side;
  };

  std::optional<Track> track_of(const Facet& third, std::vector<ConcurrentEvent>& events);
  EventScale scale_at(Track& track, const Side& side, ContactRow& row) const;
  bool has_pair_event(const Track& track, const std::vector<Side>& zeros);
  void add_crossing(Track& a, Track& b, std::vector<ConcurrentEvent>& events);
  bool is_end_of_three(const std::array<const MovingFacet*, 4>& facets, const Side& side);
  /// The rows for the sides of both facets and a third one, and for the window.
  std::size_t rows_with(Track& track, std::array<ContactRow*, most_rows>& rows,
                        std::array<Side, most_rows>& sides);

  const MovingConvolution& convolution_;
  Facet first_, second_;
  Window window_;
  SignCounts& signs_;
  CrossingLine line_;
  std::vector<ContactRow> own_;  ///< of the sides of both
  std::array<ContactRow, 2> bounds_;
  std::vector<Track> tracks_;
};

/// The event's place, in the convolution's units. Exact.
std::array<Rational, 3> place_of(const MovingConvolution& convolution,
                                 const ConcurrentEvent& event);

}  // namespace minkref::inline space
