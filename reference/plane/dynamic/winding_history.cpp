#include "reference/plane/dynamic/winding_history.hpp"

#include <algorithm>

namespace minkref::inline plane {

SideNumbers WindingHistory::base(std::uint32_t edge, std::uint32_t interval) const {
  const auto at = [&](std::size_t e) {
    return bases.begin() +
           static_cast<std::ptrdiff_t>(e < first_base.size() ? first_base[e] : bases.size());
  };
  const auto later = std::upper_bound(
      at(edge), at(edge + 1), interval,
      [](std::uint32_t wanted, const Base& base) { return wanted < base.interval; });
  return (later - 1)->numbers;
}

}  // namespace minkref::inline plane
