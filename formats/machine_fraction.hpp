// Fractions of a few machine words, as text with lowest terms.
#pragma once

#include <cstdint>
#include <string>

#include "reference/number/int128.hpp"

namespace minkref {

/// numerator / denominator > 0, lowest terms.
struct MachineFraction {
  Int128 numerator = 0, denominator = 1;
};

/// In lowest terms; `denominator` > 0. Exact: some 0.3 us.
MachineFraction reduced(Int128 numerator, Int128 denominator);

/// The nearest double, ties to even. Some 5 ns if both numbers are doubles, else 0.5 us.
double nearest_double(const MachineFraction& value);

/// Appends "n" or "n/d".
void append(std::string& text, const MachineFraction& value);

/// Appends (scale * p + q) / unit in lowest terms. `scale` > 0 is reduced and has at most 126 bits
/// above and below the line; |p| and |q| are less than 2^62; `unit` > 0. Exact: some 0.4 us.
void append_position(std::string& text, const MachineFraction& scale, std::int64_t p,
                     std::int64_t q, std::uint64_t unit);

}  // namespace minkref
