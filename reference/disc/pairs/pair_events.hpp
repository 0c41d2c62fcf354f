// All radii at which two offset features of P start or stop to share points (Behar & Lien 2012,
// Appendix): events of the convolution of P with a disc, on the sum's boundary or not.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "reference/disc/pairs/feature_pair.hpp"

namespace minkref::inline disc {

/// One radius for the pair of features a < b.
struct DiscPairEvent {
  std::uint32_t a = 0, b = 0;
  std::uint32_t rank = 0;     ///< events of one radius have one rank
  Interval squared_radius;    ///< it holds it
  std::uint8_t contacts = 0;  ///< a bit for each slot
  std::uint8_t staying = 0;   ///< of these: the line is taken to stay, as printed
  std::uint8_t meeting = 0;   ///< of these: the place is on both features
  std::uint8_t before = 0, at = 0, after = 0;
  PairChange change = PairChange::none;

  /// The slots, ascending.
  std::vector<PairContact> all_contacts() const;
};

struct DiscPairOptions {
  DiscReadings readings;             ///< all corrected: what is
  bool has_unit_radius = true;       ///< of the disc at the scale 1; for readings as printed
  std::optional<Rational> from, to;  ///< squared radii, included
  std::optional<std::size_t> most;   ///< keep the first only, in memory O(most)
};

struct DiscPairEvents {
  std::vector<OffsetFeature> features;  ///< edges first
  std::vector<DiscPairEvent> events;    ///< by radius, then a, then b
  std::uint64_t count = 0;              ///< of all events, kept or not
  /// Counts over all events: by change, and by the first contact's name.
  std::map<std::string, std::uint64_t, std::less<>> changes, kinds;
  std::uint64_t true_count = 0;   ///< events in truth: as many if all readings are corrected
  std::uint64_t right_count = 0;  ///< of the events: something changes there
  std::uint64_t pairs = 0, filtered_pairs = 0;  ///< looked at; told apart by boxes
  std::uint64_t exact_signs = 0;

  /// The squared radius of an event; exact.
  RootNumber squared_radius(const DiscPairEvent& event) const;
  std::string_view kind(const DiscPairEvent& event) const;
};

/// Finds the events of a valid polygon set, a point or a segment. Complete and exact: looks at all
/// feature pairs except pairs that boxes tell apart up to the radius `to`; by intervals first, then
/// by roots. O(n² + k log k) for n features and k events.
DiscPairEvents disc_pair_events(const PolygonSet& P, const DiscPairOptions& options = {});

}  // namespace minkref::inline disc
