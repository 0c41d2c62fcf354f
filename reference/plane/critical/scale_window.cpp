#include "reference/plane/critical/scale_window.hpp"

#include "reference/error.hpp"

namespace minkref::inline plane {

void refuse_bad_window(const ScaleWindow& window) {
  const auto refuse = [](const std::string& problem) {
    throw BadInput("bad-window", problem, "give scales with 0 < from <= to");
  };
  if (window.from && sign(*window.from) <= 0) {
    refuse("the window begins at " + to_string(*window.from) + ", which is not greater than zero");
  }
  if (window.to && sign(*window.to) <= 0) {
    refuse("the window ends at " + to_string(*window.to) + ", which is not greater than zero");
  }
  if (window.from && window.to && *window.from > *window.to) {
    refuse("the window [" + to_string(*window.from) + ", " + to_string(*window.to) + "] is empty");
  }
}

ScaleWindow opened(const ScaleWindow& closed) {
  const Rational room(1, 1024);
  ScaleWindow result;
  if (closed.from) result.from = *closed.from * (1 - room);
  if (closed.to) result.to = *closed.to * (1 + room);
  return result;
}

}  // namespace minkref::inline plane
