#include "reference/plane/dynamic/scale_between.hpp"

#include <cmath>

#include "reference/plane/kernel/grid_kernel.hpp"

namespace minkref::inline plane {

SampleScale scale_between(const ArrangementEvents& events, std::uint32_t low, std::uint32_t high) {
  const ScaleWindow& window = events.window();
  const double from = low != EdgeNode::always ? events.approximate(low)
                      : window.from           ? to_double(*window.from)
                                              : 0.0;
  const double to = high != EdgeNode::always ? events.approximate(high)
                    : window.to              ? to_double(*window.to)
                                             : 2 * from + 1;
  const double room = to - from, error = (from + to) * 4 * filter_bound;
  if (room > 64 * error && std::isfinite(to) && room > 1e-290) {
    // As few bits as the room allows.
    const int exponent = std::ilogb(room) - 2;
    const double unit = std::ldexp(1.0, exponent);
    const double middle = std::round((from + room / 2) / unit) * unit;
    if (middle > from + error && middle < to - error) return {from_double(middle), middle};
  }
  const auto exact_end = [&](std::uint32_t group, const std::optional<Rational>& bound,
                             const Rational& otherwise) {
    return group != EdgeNode::always ? events.exact(group) : bound ? *bound : otherwise;
  };
  const Rational lower = exact_end(low, window.from, 0);
  const Rational upper = exact_end(high, window.to, 2 * lower + 1);
  const Rational middle = (lower + upper) / 2;
  return {middle, to_double(middle)};
}

}  // namespace minkref::inline plane
