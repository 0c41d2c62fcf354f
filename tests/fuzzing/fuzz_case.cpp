// Cases: reading succeeds, and then the case survives being written and read, or is refused.
#include "tests/fuzzing/round_trip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace minkref;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Case value;
  try {
    value = read_case_text(text, "input", fuzzing::input_limits()).value;
  } catch (const BadInput&) {
    return fuzzing::check_reader(data, size, Format::case_json);
  }
  const std::string written = write_case(value);
  if (read_case_text(written, "", fuzzing::output_limits()).value != value) {
    fuzzing::broken("a case written and read again is the same", written);
  }
  return fuzzing::check_reader(data, size, Format::case_json);
}
