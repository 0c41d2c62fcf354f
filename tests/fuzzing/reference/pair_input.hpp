// The input of the targets on the reference: a case file with two small operands.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "formats/case.hpp"
#include "tests/fuzzing/reference/dice.hpp"

namespace minkref::fuzzing {

/// Limits that let a target see many pairs each second: an operand's vertices, and the product of
/// both operands' vertex counts. The mutator keeps to these limits.
struct Bounds {
  std::size_t vertices, product;
};
extern const Bounds bounds;
/// Digits of a coordinate or a scale. Longer ones make a check slow and nothing new.
inline constexpr std::size_t most_digits = 48;
inline constexpr std::size_t most_scales = 6;

/// Reads a case; none if the text is no case. Ignores text after the last closing brace: libFuzzer
/// minimises with rests of longer texts behind a shorter text.
std::optional<Case> read_pair(std::string_view text);

/// Whether a target takes a case on: few vertices, short numbers.
bool is_small(const Case& pair);
/// Throws BadInput for an invalid operand or pair: `validate` and minkowski_sum's refusals.
void refuse_bad_pair(const Case& pair);

/// The scale to test: the first one, or an end of the interval, or 1.
Rational scale_of(const Case& pair);

/// Prints the law, what breaks it and the case as a file, and ends the process.
[[noreturn]] void broken(const std::string& law, const Case& pair, const std::string& what = "");

/// Checks one input. Calls `check` for a valid small pair, with dice that depend only on the pair;
/// its exceptions are findings, and so is anything but BadInput for an invalid pair. Prints input
/// counts when the process ends.
int check_pair(const std::uint8_t* data, std::size_t size,
               const std::function<void(const Case&, Dice&)>& check);

}  // namespace minkref::fuzzing
