// Reader of GeoJSON (RFC 7946).
#pragma once

#include "formats/json_text.hpp"
#include "formats/set_builder.hpp"

namespace minkref {

/// Reads Polygon, MultiPolygon, Point, LineString, MultiPoint, MultiLineString, Feature,
/// FeatureCollection and GeometryCollection (flattened). Coordinates are plane coordinates, from
/// the text of the JSON numbers: 0.1 is 1/10. Ignores foreign members. Refuses a third coordinate.
/// Linear.
void read_geojson(Json root, SetBuilder& set);

/// Whether the value is an object with a `type` that GeoJSON knows.
bool looks_like_geojson(Json root);

}  // namespace minkref
