// Numbers: an accepted number is written and read again as the same number, in both notations.
#include "formats/decimal.hpp"
#include "tests/fuzzing/round_trip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace minkref;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Rational value;
  try {
    value = parse_rational(text, fuzzing::input_limits().number);
  } catch (const BadInput& refused) {
    if (refused.mend().empty() || std::string_view(refused.what()).size() > 2000) {
      fuzzing::broken("a refusal says how to fix it, shortly", refused.what());
    }
    return 0;
  }
  const NumberLimits wide = fuzzing::output_limits().number;
  const std::string fraction = to_string(value);
  if (parse_rational(fraction, wide) != value) fuzzing::broken("n/d is read back", fraction);
  const auto decimal = exact_decimal(value);
  if (decimal.has_value() != has_exact_decimal(value)) fuzzing::broken("decimals", fraction);
  if (decimal && parse_rational(*decimal, wide) != value) {
    fuzzing::broken("a decimal is read back", *decimal);
  }
  const double nearest = to_double(value);
  if (nearest - nearest == 0 && to_double(from_double(nearest)) != nearest) {
    fuzzing::broken("the value of a double is that double", fraction);
  }
  return 0;
}
