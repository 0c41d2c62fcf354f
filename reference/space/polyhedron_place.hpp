// Where in a polyhedron a refusal applies.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reference/error.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// "(x, y, z)"; a coordinate of thousands of digits, which would drown a message, is shortened.
std::string short_text(const SpacePoint& point);

/// Names a face and vertices, with the coordinates of those that exist, shortened.
Place place_in(const Polyhedron& polyhedron, std::optional<std::uint32_t> face,
               const std::vector<std::uint32_t>& vertices);

}  // namespace minkref::inline space
