// All scales at which two edges of a convolution start or stop meeting (Behar & Lien 2012, Sec.
// 4.2.3), exact and sorted.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/form.hpp"
#include "reference/plane/convolution/convolution_type.hpp"
#include "reference/plane/critical/pair_conditions.hpp"
#include "reference/plane/critical/scale_window.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

/// The change at a critical scale, as s grows.
enum class Change : std::uint8_t {
  birth,    ///< the edges start to meet
  death,    ///< the edges stop to meet
  touch,    ///< the edges meet at one point, at this scale only
  overlap,  ///< parallel edges share a segment, at this scale only
};

/// "birth", "death", "touch" or "overlap".
std::string_view name(Change change);

/// A critical scale for the edges a < b: `critical_scales(...)[rank]`.
struct PairEvent {
  double approximate = 0;  ///< the scale; for drawing and first looks
  std::uint32_t a = 0, b = 0;
  std::uint32_t rank = 0;  ///< events of equal scale have equal rank; ranks count from 0
  Change change = Change::birth;
  bool parallel = false;       ///< the edges are parallel
  std::uint8_t half_line = 0;  ///< the condition that holds with equality
};

/// The wanted kinds of events.
enum class EventKind : std::uint8_t { pair, parallel, both };

/// Edges a < b that meet within a window.
struct MeetingPair {
  std::uint32_t a = 0, b = 0;
  enum class Kind : std::uint8_t {
    crossing,            ///< not parallel
    one_line_always,     ///< parallel, on one line at every scale
    one_line_at_a_scale  ///< parallel, on one line at one scale
  } kind = Kind::crossing;
};

struct PairEvents {
  std::vector<ConvolutionEdge> edges;  ///< S-edges first
  std::vector<PairEvent> events;       ///< sorted by scale, then a, then b
  /// Only if asked for: all pairs that meet within the window, sorted by a, then b.
  std::vector<MeetingPair> meeting;
  std::size_t distinct = 0;  ///< different scales
  std::uint64_t pairs = 0;   ///< looked at: all
  /// Pairs that meet within the window: on an interval, at a single scale; parallel pairs.
  std::uint64_t intersecting_pairs = 0, touching_pairs = 0, parallel_pairs = 0;
  std::uint64_t always_meeting_pairs = 0;  ///< of the intersecting pairs: at every scale
  std::uint64_t filtered_pairs = 0;        ///< the float filter proved that pairs never meet
  Statistics statistics;                   ///< signs of the exact stage
};

/// All events of a kind within the window; the pair counts cover both kinds. `form`: applies the
/// printed rule of Sec. 4.2.3 to pairs that are not parallel; its answers are wrong
/// (docs/definitions.md, "Printed and corrected"). Exact. O(N log N + k log k) for N edges and k
/// events where few boxes of edges meet (moving_pairs.hpp), O(N^2) at worst and as printed; memory
/// O(N + k). Operands must have passed `validate`, or be cut (simply_connected.hpp).
PairEvents pair_events(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window = {},
                       EventKind kind = EventKind::both, Form form = Form::corrected,
                       bool keep_meeting = false, ConvolutionType of = ConvolutionType::reduced);

/// The printed interval against the corrected interval, on exact roots, over all pairs that are not
/// parallel.
struct FormComparison {
  std::uint64_t intersecting = 0, touching = 0;  ///< in truth: on an interval, at one scale only
  std::uint64_t printed_right = 0;               ///< of the intersecting pairs: the same interval
  std::uint64_t printed_right_by_roots = 0;      ///< of printed_right: all solves have roots
  std::uint64_t printed_empty = 0;               ///< of the intersecting pairs: none
  std::uint64_t printed_invented = 0;            ///< an interval for edges that never meet
};

/// Exact. O(N^2).
FormComparison compare_forms(const PolygonSet& P, const PolygonSet& Q);

/// The exact scales, one for each rank, ascending. Some 1 us each.
std::vector<Rational> critical_scales(const PairEvents& events, const PolygonSet& P,
                                      const PolygonSet& Q);

}  // namespace minkref::inline plane
