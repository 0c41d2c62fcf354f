#include "formats/decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "formats/message_text.hpp"
#include "reference/error.hpp"

namespace minkref {

std::string decimal(const Rational& value) {
  if (auto exact = exact_decimal(value)) return *std::move(exact);
  const double nearest = to_double(value);
  if (nearest == 0 || !std::isfinite(nearest)) {
    throw LimitExceeded("not-representable",
                        in_quotes(to_string(value)) +
                            " has no finite decimal expansion and is beyond the range of doubles",
                        "write the set as JSON, which is exact");
  }
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), nearest,
                                 std::chars_format::general, 17);
  return {text.data(), end.ptr};
}

}  // namespace minkref
