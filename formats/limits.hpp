// All limits of the readers.
#pragma once

#include <cstddef>

#include "reference/number/rational.hpp"

namespace minkref {

/// The most that a reader accepts. A reader refuses larger input (LimitExceeded) before any work on
/// it, so that hostile input cannot take unbounded time and memory.
struct ReadLimits {
  NumberLimits number;                        ///< digits and exponent of one number
  std::size_t depth = 128;                    ///< nesting of JSON values, of WKT collections
  std::size_t bytes = std::size_t{64} << 20;  ///< length of a file
  std::size_t vertices = 1'000'000;           ///< of a file, over all its rings
  std::size_t faces = 2'000'000;              ///< of a polyhedron
  std::size_t face_corners = 8'000'000;       ///< vertices of its faces, each counted in every face
  std::size_t json_values = 16'000'000;       ///< values and member names in a JSON text
  std::size_t number_bytes = std::size_t{256} << 20;  ///< memory of all numbers, written out
  std::size_t containment_steps = 10'000'000;  ///< edges visited to find the outer ring of a hole
};

}  // namespace minkref
