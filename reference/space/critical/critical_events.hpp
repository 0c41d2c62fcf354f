// All scales within a window at which convolution facets start, change or stop to meet (Sec. 5).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/space/critical/concurrent_facets.hpp"
#include "reference/space/critical/facet_event.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

struct SpacePairEvent {
  FacetEvent event;
  std::uint32_t first, second;  ///< numbers of facets, ascending
};

struct CriticalEvents {
  std::shared_ptr<const SpaceOperands> operands;         ///< none where one of them is empty
  std::shared_ptr<const MovingConvolution> convolution;  ///< of the operands
  std::vector<SpacePairEvent> events;                    ///< by scale, then by facets
  std::vector<ConcurrentEvent> concurrent;  ///< by scale, then by facets; none if not asked for
  std::uint64_t near_pairs = 0;             ///< of facets whose boxes meet at some scale
  std::uint64_t meeting_pairs = 0;          ///< that have an event in the window
  std::uint64_t tracks = 0;                 ///< of three facets that share points in the window
  SignCounts signs;
};

/// The events to look for: between pairs of facets, or also among three and four.
enum class EventsOf : std::uint8_t { pairs, all };

/// Limits the list: more events of pairs, or more events of three and four facets, throw
/// LimitExceeded ("too-many-events").
struct MostEvents {
  static constexpr const char* code = "too-many-events";
  std::uint64_t count = UINT64_MAX;
};

/// Finds pair events of sP ⊕ Q for s in [from, to]; P and Q are valid polyhedra that do not cross
/// themselves. Throws BadInput ("bad-window") for bounds that are not positive or not ascending.
/// Exact and complete. O(n log n + k) for k pairs of facets whose boxes meet at some scale, beside
/// the search for compatible pairs. On `options.threads`; some 150 bytes for each event. Events of
/// three and four facets cost, for each two meeting facets, as many steps as both have neighbours.
CriticalEvents critical_events_in_space(const Polyhedron& P, const Polyhedron& Q,
                                        const Rational& from, const Rational& to,
                                        const BuildOptions& options = {},
                                        EventsOf what = EventsOf::pairs, MostEvents most = {});

/// The event's place: for a vertex the corner, for an edge the sides' crossing point; for parallel
/// facets one facet's corner inside the other, if any. Exact.
std::optional<SpacePoint> place_of(const CriticalEvents& events, const SpacePairEvent& event);
SpacePoint place_of(const CriticalEvents& events, const ConcurrentEvent& event);

/// How many different scales two sorted lists have.
std::uint64_t distinct_scales(const std::vector<SpacePairEvent>& events,
                              const std::vector<ConcurrentEvent>& others);

/// The same by all pairs of facets, without boxes or filters: for small operands.
CriticalEvents critical_events_of_all_pairs(const Polyhedron& P, const Polyhedron& Q,
                                            const Rational& from, const Rational& to,
                                            EventsOf what = EventsOf::pairs);

}  // namespace minkref::inline space
