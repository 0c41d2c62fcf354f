// Reader of a set's plain JSON form, used by cases too.
#pragma once

#include "formats/json_text.hpp"
#include "formats/set_builder.hpp"

namespace minkref {

/// The JSON values that may give a coordinate. Strings ("3/7", "-30.7428") always do.
enum class JsonNumbers {
  any,       ///< every JSON number too, from its text
  integers,  ///< JSON integers only (cases)
};

/// Reads {"polygons":[{"outer":ring,"holes":[ring,...]},...]}, ring = [[x,y],...], the first vertex
/// not repeated. `holes` may be absent; refuses other members. Linear.
void read_json_set(Json value, SetBuilder& set, JsonNumbers numbers);

/// The text of a number given as a JSON value. Refuses other values ("not-a-number") at `place`.
std::string number_text(Json value, JsonNumbers numbers, const Input& input, const Place& place);

}  // namespace minkref
