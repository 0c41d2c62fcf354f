// Readings for the update of a sum in space (Behar & Lien 2012, Sec. 5): the events', and how
// events bound a crossing.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/paper/space/facet_readings.hpp"

namespace minkref::inline space {

/// The paper's update in space, choice by choice. Defaults are the printed choices; where the text
/// says nothing, the kindest reading.
struct SpaceUpdateReadings {
  /// The events of two facets.
  FacetReadings events;

  /// Sec. 5.1: which solutions for s bound the scales of a crossing, the point of one facet's side
  /// on the other facet. `checked` keeps "candidate events" alone whose point, after the check,
  /// "also lay in the face"; without any, the check is made at s = 1. `joint` keeps all, and takes
  /// the scales that lie between all of them, as Sec. 4.2.3 does in the plane.
  enum class Bounds : std::uint8_t { checked, joint };
  Bounds bounds = Bounds::checked;

  /// Sec. 5.2: when faces are parallel, and a side runs along a plane. The matrix "will be
  /// singular": its determinant is zero in the arithmetic, which rounding seldom leaves zero; or
  /// the directions of the operands' edges and faces, the same at all scales, tell so exactly.
  enum class Singular : std::uint8_t { determinant, directions };
  Singular singular = Singular::determinant;
};

/// All formulas in their right form: over rational numbers the exact sum.
SpaceUpdateReadings corrected_space_update_readings();

/// Sets one reading by its name and value, as the command line spells both: those of FacetReadings,
/// "bounds" and "singular". Throws BadInput ("unknown-reading") with a list of all choices.
void set_reading(SpaceUpdateReadings& readings, std::string_view name, std::string_view value);

/// The names and values that set_reading takes.
const std::vector<ReadingName>& space_update_reading_names();

}  // namespace minkref::inline space
