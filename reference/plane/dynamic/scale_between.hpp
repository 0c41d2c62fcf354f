// A scale between two groups of events.
#pragma once

#include "reference/plane/dynamic/arrangement_events.hpp"

namespace minkref::inline plane {

/// A scale with its nearest double.
struct SampleScale {
  Rational scale;
  double approximate = 0;
};

/// Strictly between two groups, of few bits where doubles can tell; `EdgeNode::always` stands for
/// the beginning or the end of the window. Exact.
SampleScale scale_between(const ArrangementEvents& events, std::uint32_t low, std::uint32_t high);

}  // namespace minkref::inline plane
