// Validation whose refusals name places within the file.
#pragma once

#include <string>
#include <vector>

#include "formats/reading.hpp"
#include "reference/error.hpp"
#include "reference/plane/lines.hpp"

namespace minkref {

/// A place within the text, from a place within the set: ring and vertex indices become the file's,
/// and the line belongs to the first vertex named.
Place place_in_file(Place place, const std::vector<RingOrigin>& origins);

/// Calls `check`. A refusal names `source`; `in_file` translates its place.
template <class Check, class InFile>
void refuse_in_file(Check check, InFile in_file, const std::string& source) {
  const auto named = [&](const BadInput& e) {
    Place place = in_file(e.place());
    if (place.source.empty()) place.source = source;
    return place;
  };
  try {
    check();
  } catch (const LimitExceeded& e) {
    throw LimitExceeded(e.code(), e.problem(), e.mend(), named(e));
  } catch (const BadInput& e) {
    throw BadInput(e.code(), e.problem(), e.mend(), named(e));
  }
}

/// `validate(set, lines)`; a refusal names `source` and the place in the file.
void validate_as_read(const PolygonSet& set, const std::vector<RingOrigin>& origins,
                      const std::string& source, Lines lines = Lines::refused);

}  // namespace minkref
