// The answer from the Appendix's program at a scale: rings of curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reference/disc/curves/offset_form.hpp"

namespace minkref::inline disc {

struct DiscAnswer {
  /// A piece of a ring, with its corners as the arithmetic has them, rounded to doubles.
  struct Piece {
    bool is_arc = false;  ///< about the centre, counter-clockwise
    double centre_x = 0, centre_y = 0, from_x = 0, from_y = 0, to_x = 0, to_y = 0;
  };

  OffsetForm form;  ///< canonical
  std::vector<std::vector<Piece>> rings;
  std::size_t components = 0, holes = 0;
  std::size_t nodes = 0, faces = 0, asked = 0;  ///< of the arrangement; faces with a collision test
};

/// The largest distance between corresponding corners; none unless all rings have equal curves.
std::optional<double> corner_distance(const DiscAnswer& a, const DiscAnswer& b);

}  // namespace minkref::inline disc
