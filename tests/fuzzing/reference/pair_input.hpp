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

/// Limits that let a target see many pairs a second: vertices of an operand, and vertices of one
/// operand times those of the other. The mutator keeps to these limits.
struct Bounds {
  std::size_t vertices, product;
};
extern const Bounds bounds;
/// Digits of a coordinate or a scale. Longer ones make a check slow and nothing new.
inline constexpr std::size_t most_digits = 48;
inline constexpr std::size_t most_scales = 6;

/// Reads a case; none where the text is no case. Text after its last brace is left out: libFuzzer
/// minimises with rests of longer texts behind a shorter one.
std::optional<Case> read_pair(std::string_view text);

/// Whether a target takes a case on: few vertices, short numbers.
bool is_small(const Case& pair);
/// Throws BadInput where an operand or the pair is none: `validate` and minkowski_sum's refusals.
void refuse_bad_pair(const Case& pair);

/// The scale that is looked at: the first one, or an end of the interval, or 1.
Rational scale_of(const Case& pair);

/// Prints the law, what breaks it and the case as a file, and ends the process.
[[noreturn]] void broken(const std::string& law, const Case& pair, const std::string& what = "");

/// One input. `check` is called for a valid small pair, with dice that hang on the pair alone; what
/// it throws is a finding, and so is anything but BadInput on an invalid one. Counts of inputs are
/// printed when the process ends.
int check_pair(const std::uint8_t* data, std::size_t size,
               const std::function<void(const Case&, Dice&)>& check);

}  // namespace minkref::fuzzing
