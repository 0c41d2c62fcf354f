#include "reference/plane/kernel/arithmetic_name.hpp"

#include <charconv>

namespace minkref::inline plane {

std::optional<long> mpfr_bits(const std::string& name) {
  if (name == "rational" || name == "interval" || name == "double") return std::nullopt;
  const std::string prefix = "mpfr:";
  if (name.starts_with(prefix)) {
    long bits = 0;
    const char* end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + prefix.size(), end, bits);
    if (error == std::errc{} && stop == end && bits >= 2 && bits <= 1'000'000) return bits;
  }
  throw BadInput("unknown-arithmetic", "there is no arithmetic called \"" + name + "\"",
                 "use rational, interval, double or mpfr:BITS with 2 to 1000000 bits");
}

}  // namespace minkref::inline plane
