// Reader of well-known text.
#pragma once

#include <string_view>

#include "formats/set_builder.hpp"

namespace minkref {

/// Reads one geometry: POLYGON, MULTIPOLYGON, POINT, LINESTRING of two points (a segment), each
/// possibly EMPTY, and GEOMETRYCOLLECTION of these; words in any case. Numbers are exact; a
/// fraction `3/7` is accepted beside decimals. Refuses Z and M and everything else with its line.
/// Linear.
void read_wkt(std::string_view text, SetBuilder& set);

}  // namespace minkref
