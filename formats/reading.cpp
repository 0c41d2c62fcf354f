#include "formats/reading.hpp"

namespace minkref {

std::size_t RingOrigin::index_in_file(std::size_t index) const {
  const std::size_t n = lines.size();
  if (index >= n || order == Order::as_read) return index;
  if (order == Order::reversed) return n - 1 - index;
  return (n - index) % n;
}

}  // namespace minkref
