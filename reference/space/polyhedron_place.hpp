// The place at which a refusal applies to a polyhedron.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reference/error.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// Writes "(x, y, z)"; shortens a coordinate with thousands of digits, which would drown a message.
std::string short_text(const SpacePoint& point);

/// Names a face and vertices, with the coordinates of existing vertices, shortened.
Place place_in(const Polyhedron& polyhedron, std::optional<std::uint32_t> face,
               const std::vector<std::uint32_t>& vertices);

}  // namespace minkref::inline space
