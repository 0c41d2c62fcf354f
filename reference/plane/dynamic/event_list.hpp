// A window's arrangement events by scale.
#pragma once

#include <vector>

#include "reference/plane/dynamic/arrangement_events.hpp"

namespace minkref::inline plane {

/// An entry of the list.
struct ListedEvent {
  enum class Kind : std::uint8_t {
    pair,     ///< an event of ArrangementEvents::pairs(), also a parallel one
    triple,   ///< an event of ArrangementEvents::triples()
    passing,  ///< a node that is an end of an edge on one line comes to an end of the other or
              ///< leaves it, where the two edges neither start nor stop meeting
  } kind = Kind::pair;
  std::uint32_t group = 0;
  std::uint32_t index = 0;  ///< of the pair event, of the triple event, of the node
  std::uint32_t edge = 0;   ///< of the node
};

/// Events within the closed window, sorted by group, pair events before triple events.
std::vector<ListedEvent> listed_events(const ArrangementEvents& events, const ScaleWindow& closed);

}  // namespace minkref::inline plane
