// Windows of scales.
#pragma once

#include <optional>

#include "reference/number/rational.hpp"

namespace minkref::inline plane {

/// A closed window of scales; without a bound it is open towards 0 or infinity.
struct ScaleWindow {
  std::optional<Rational> from, to;
};

/// Throws BadInput ("bad-window") where a bound is not positive or the window is empty.
void refuse_bad_window(const ScaleWindow& window);

/// The open window that holds a closed one with a little room on either side, so that events at its
/// ends have both their sides.
ScaleWindow opened(const ScaleWindow& closed);

}  // namespace minkref::inline plane
