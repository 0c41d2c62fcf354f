// Components, cavities and tunnels of a solid. docs/certificates-solids.md, "Components"
#pragma once

#include <cstddef>

#include "oracle/checker/space/canonical_form.hpp"

namespace minkref::checker {

struct SolidNumbers {
  std::size_t components = 0, cavities = 0, tunnels = 0;
};

/// Counts all three, from the parts of a solid's faces. Throws NotVerified.
SolidNumbers solid_numbers(const Tiles& faces, Budget& budget);

}  // namespace minkref::checker
