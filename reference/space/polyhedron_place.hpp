// Where in a polyhedron a refusal applies.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/error.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// Names a face and vertices, with the coordinates of those that exist; a coordinate of thousands
/// of digits, which would drown the message, is shortened.
Place place_in(const Polyhedron& polyhedron, std::optional<std::uint32_t> face,
               const std::vector<std::uint32_t>& vertices);

}  // namespace minkref::inline space
