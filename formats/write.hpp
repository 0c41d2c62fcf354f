// Writes operands and results.
#pragma once

#include <string>

#include "formats/format.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref {

/// The text of a set, ending with a line break. Rings keep their order and direction. Format::json
/// is exact for every set. WKT, GeoJSON and `.poly` know decimals only, exact if `writes_exactly`
/// holds; other coordinates are rounded to the nearest double (17 digits), and the written set may
/// then differ from the given set, rarely even lose its validity. Format::svg gives a picture.
/// Throws BadInput ("unknown-format": write_case writes cases; "not-representable": `.poly` has no
/// points and no segments) and LimitExceeded ("not-representable": a rounded coordinate leaves the
/// range of doubles).
std::string write(const PolygonSet& set, Format format);

/// Whether reading the result of `write` yields the same valid set: always for json; for WKT,
/// GeoJSON and `.poly` iff every denominator is a product of twos and fives (and, for `.poly`, the
/// set is no point and no segment); never for a picture.
bool writes_exactly(const PolygonSet& set, Format format);

/// Writes the text to a file. Throws BadInput ("cannot-write").
void write_file(const std::string& text, const std::string& path);

std::string write_wkt(const PolygonSet& set);
std::string write_geojson(const PolygonSet& set);
std::string write_poly(const PolygonSet& set);
/// {"polygons":[{"holes":[...],"outer":[...]}]} on one line, numbers as strings.
std::string write_json(const PolygonSet& set);

}  // namespace minkref
