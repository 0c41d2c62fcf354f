// Validation whose refusals name places in the file.
#pragma once

#include <string>
#include <vector>

#include "formats/reading.hpp"
#include "reference/error.hpp"

namespace minkref {

/// The place in the text of a place in the set: ring and vertex indices are those of the file, and
/// the line is that of the first vertex named.
Place place_in_file(Place place, const std::vector<RingOrigin>& origins);

/// `validate(set)`; a refusal names `source` and the place in the file.
void validate_as_read(const PolygonSet& set, const std::vector<RingOrigin>& origins,
                      const std::string& source);

}  // namespace minkref
