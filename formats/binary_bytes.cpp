#include "formats/binary_bytes.hpp"

#include <bit>
#include <limits>

namespace minkref {

static_assert(std::numeric_limits<float>::is_iec559 && sizeof(float) == 4);
static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

void BinaryBytes::require(std::uint64_t size) const {
  if (size <= left()) return;
  input_.refuse("truncated",
                "at byte " + std::to_string(at_) + ", " + std::to_string(size) +
                    " bytes are due and " + std::to_string(left()) + " are left",
                "complete the file, or correct the counts in its header");
}

std::uint64_t BinaryBytes::bits(std::size_t size) {
  require(size);
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t index = order_ == ByteOrder::big ? k : size - 1 - k;
    value = value << 8 | static_cast<unsigned char>(file_[at_ + index]);
  }
  at_ += size;
  return value;
}

float BinaryBytes::float32() { return std::bit_cast<float>(static_cast<std::uint32_t>(bits(4))); }

double BinaryBytes::float64() { return std::bit_cast<double>(bits(8)); }

void BinaryBytes::skip(std::uint64_t size) {
  require(size);
  at_ += static_cast<std::size_t>(size);
}

void BinaryBytes::require_end(const std::string& last) const {
  if (left() == 0) return;
  input_.refuse("trailing-text",
                "at byte " + std::to_string(at_) + ", after " + last + ", " +
                    std::to_string(left()) + " bytes are left",
                "correct the counts in the header, or cut the file there");
}

}  // namespace minkref
