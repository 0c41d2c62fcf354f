#include "tests/fuzzing/round_trip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minkref::fuzzing::check_reader(data, size, minkref::Format::poly);
}
