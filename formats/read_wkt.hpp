// Reader of well-known text.
#pragma once

#include <string_view>

#include "formats/set_builder.hpp"

namespace minkref {

/// Reads one geometry: POLYGON, MULTIPOLYGON, POINT, LINESTRING, MULTIPOINT, MULTILINESTRING, each
/// possibly EMPTY, and GEOMETRYCOLLECTION of these; words may have any case. Numbers are exact;
/// accepts a fraction `3/7` beside decimals. Refuses Z and M and everything else with its line.
/// Linear.
void read_wkt(std::string_view text, SetBuilder& set);

}  // namespace minkref
