// How the sentences of Behar & Lien 2012, Sec. 4, are read: each formula by itself.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/form.hpp"
#include "reference/number/rational.hpp"
#include "reference/paper/reading_name.hpp"

namespace minkref::inline plane {

/// The paper's program of Sec. 4, choice by choice. As they stand here they are the printed ones;
/// where the text is silent, the kindest reading.
struct Readings {
  /// Observation 1 (Sec. 4.1): the intersection of two lines.
  Form observation = Form::printed;

  /// Sec. 4.2.1: "an overdetermined system of equations; there is no solution for s if the system
  /// is inconsistent". `printed` tests for consistency by equality, `tolerance` within a tolerance;
  /// `least_squares` solves any system; `corrected` solves the one equation along the edge.
  enum class Solve : std::uint8_t { printed, tolerance, least_squares, corrected };
  Solve solve = Solve::printed;
  /// The tolerance of Solve::tolerance, which has no default: times the largest coordinate of P plus
  /// that of Q.
  Rational tolerance = 0;

  /// Sec. 4.2.3: which end points bound the interval from below, and which from above.
  Form interval = Form::printed;

  /// An end point for which there is no solution (Sec. 4.2.1) bounds nothing, or the edges never
  /// meet. The text says neither.
  enum class NoRoot : std::uint8_t { unbounded, never };
  NoRoot no_root = NoRoot::unbounded;

  /// The intersections along an edge (Sec. 4.2.4) keep the order in which events put them, or are
  /// sorted at the scale that is reached ("we update all of the remaining nodes"). The first is
  /// wrong from the first triple event on.
  enum class Order : std::uint8_t { kept, sorted };
  Order order = Order::kept;

  /// Whether edges that are parallel take part, of which Sec. 4 says nothing. Without, they never
  /// meet.
  bool parallel = false;

  /// Whether edges that share a vertex of the convolution are asked where they meet. They meet
  /// there at all scales; the text says of no pair that it is left out.
  bool adjacent = false;
};

/// All formulas in their right form and all events: over rational numbers the exact dynamic sum.
Readings corrected_readings();

/// Sets one reading by its name and value, as the command line spells them ("observation",
/// "printed"; "solve", "tolerance:1e-9"). Throws BadInput ("unknown-reading") that lists what there
/// is.
void set_reading(Readings& readings, std::string_view name, std::string_view value);

/// The names and values that set_reading takes.
const std::vector<ReadingName>& reading_names();

}  // namespace minkref::inline plane
