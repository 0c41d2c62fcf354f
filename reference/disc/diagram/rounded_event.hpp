// Events in doubles.
#pragma once

#include "reference/disc/diagram/diagram_events.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {

struct RoundedEvent {
  Enclosure radius;  ///< the tightest
  double x, y;       ///< the nearest doubles
};

/// Rounds the event, in the place's own coordinates.
inline RoundedEvent rounded(const Equidistant<RootNumber>& event) {
  return {enclose(root_of(event.squared_radius)), nearest_double(event.at.x),
          nearest_double(event.at.y)};
}

}  // namespace minkref::inline disc
