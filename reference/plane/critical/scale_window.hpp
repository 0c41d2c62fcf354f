// Windows of scales.
#pragma once

#include <optional>

#include "reference/number/rational.hpp"

namespace minkref::inline plane {

/// A closed window of scales; a missing bound leaves the window open towards 0 or infinity.
struct ScaleWindow {
  std::optional<Rational> from, to;
};

/// Throws BadInput ("bad-window") for a bound <= 0 or an empty window.
void refuse_bad_window(const ScaleWindow& window);

/// An open window around a closed one, with a little room on either side, so that events at the
/// ends have both their sides.
ScaleWindow opened(const ScaleWindow& closed);

}  // namespace minkref::inline plane
