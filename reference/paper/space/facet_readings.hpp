// Readings for the sentences of Behar & Lien 2012, Sec. 5: each by itself.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/paper/plane/readings.hpp"
#include "reference/paper/reading_name.hpp"

namespace minkref::inline space {

/// The paper's way to the events of two facets, choice by choice. Defaults are the printed choices;
/// where the text says nothing, the kindest reading.
struct FacetReadings {
  /// Sec. 5.1: a corner's contact with a plane is where x(s), "the intersection point" of a line
  /// "underlying e" with the plane, is an end of the side e; or where the corner itself is on the
  /// plane, which also tells the scale of parallel faces.
  enum class Corner : std::uint8_t { lines, itself };
  Corner corner = Corner::lines;

  /// Sec. 5.2: two lines meet "precisely when x1 = x2", each of which is a line's point on the
  /// other face's plane, by the system with a matrix; or where their determinant is zero.
  enum class Crossing : std::uint8_t { points, determinant };
  Crossing crossing = Crossing::points;

  /// Sec. 5.1: three equations with "only one free variable", as Readings::solve in the plane.
  Readings::Solve solve = Readings::Solve::printed;
  Rational tolerance = 0;  ///< of Solve::tolerance, as in the plane

  /// Sec. 5.2: whether an edge event must lie within both sides. The text asks for this in Sec. 5.1
  /// alone, of vertex events.
  enum class Ends : std::uint8_t { sides, lines };
  Ends ends = Ends::sides;

  /// Sec. 5.2, parallel faces: "the scale value when the faces are coplanar", by a vertex "as
  /// though we were detecting a vertex event"; edges are checked at that scale "if there are no
  /// vertex events". Or skips such faces.
  enum class Parallel : std::uint8_t { followed, left_out };
  Parallel parallel = Parallel::followed;

  /// Sec. 5.2, coplanar faces: "transforming f1 and f2 into the xy-plane" by a rotation (up to a
  /// factor, so that rational numbers take part), or by dropping a coordinate. Or left out.
  enum class Coplanar : std::uint8_t { turned, dropped, left_out };
  Coplanar coplanar = Coplanar::turned;

  /// "The logic from the 2D scaling" (Sec. 4), for sides of coplanar faces; its order of
  /// intersections is not used.
  Readings plane;
};

/// All formulas in their right form: over rational numbers the exact events of two facets.
FacetReadings corrected_facet_readings();

/// All readings as printed, or all corrected.
FacetReadings facet_readings(Form form);

/// Sets one reading by its name and value, as the command line spells both ("corner", "lines"); the
/// names of the plane's readings begin with "plane-". Throws BadInput ("unknown-reading") with a
/// list of all choices.
void set_reading(FacetReadings& readings, std::string_view name, std::string_view value);

/// The names and values that set_reading takes.
const std::vector<ReadingName>& facet_reading_names();

}  // namespace minkref::inline space
