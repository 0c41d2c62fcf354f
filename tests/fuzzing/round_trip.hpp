// The law that every reader's fuzz target checks.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <string_view>

#include "formats/case.hpp"
#include "formats/read.hpp"
#include "formats/refusal_place.hpp"
#include "formats/write.hpp"
#include "reference/error.hpp"

namespace minkref::fuzzing {

/// Limits low enough that a run stays fast, and high ones for what we wrote ourselves (a number
/// written out may be longer than the text it was read from).
inline ReadLimits input_limits() {
  ReadLimits limits;
  limits.number = {.digits = 300, .exponent = 300};
  limits.depth = 32;
  return limits;
}
inline ReadLimits output_limits() {
  ReadLimits limits;
  limits.number = {.digits = 100'000, .exponent = 100'000};
  return limits;
}

[[noreturn]] inline void broken(const char* law, const std::string& text) {
  std::fprintf(stderr, "broken law: %s\n%s\n", law, text.c_str());
  std::abort();
}

inline void check_refusal(const BadInput& refused) {
  if (refused.mend().empty() || refused.place().source.empty() ||
      std::string_view(refused.what()).size() > 2000) {
    broken("a refusal names its source and how to fix it, shortly", refused.what());
  }
}

/// Writes and reads the set again in every format that holds it exactly, and expects the same set.
/// The formats other than JSON regroup rings, and so hold valid sets only.
inline void check_round_trip(const PolygonSet& set) {
  bool valid = true;
  try {
    validate_as_read(set, {}, "");
  } catch (const BadInput&) {
    valid = false;
  }
  for (const Format format : {Format::json, Format::wkt, Format::geojson, Format::poly}) {
    if (!writes_exactly(set, format) || (format != Format::json && !valid)) continue;
    const std::string text = write(set, format);
    if (read_text(text, format, "", output_limits()).set != set) {
      broken("write, then read, gives the same set", text);
    }
  }
  if (write(set, Format::svg).empty()) broken("every set has a picture", "");
}

/// Reading succeeds, and then the round trip holds, or it throws minkref::Error; nothing else.
inline int check_reader(const std::uint8_t* data, std::size_t size, Format format) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Reading reading;
  try {
    reading = read_text(text, format, "input", input_limits());
  } catch (const BadInput& refused) {
    check_refusal(refused);
    return 0;
  }
  if (reading.origins.size() != reading.set.rings()) broken("every ring has an origin", "");
  // A case keeps its rings' orientation, which other formats would turn.
  if (format != Format::case_json) check_round_trip(reading.set);
  return 0;
}

}  // namespace minkref::fuzzing
