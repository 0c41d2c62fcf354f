// Readings for the sentences of Behar & Lien 2012, Sec. 4: each formula by itself.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/form.hpp"
#include "reference/number/rational.hpp"
#include "reference/paper/reading_name.hpp"

namespace minkref::inline plane {

/// The paper's Sec. 4 program, choice by choice. Defaults are the printed choices; where the text
/// says nothing, the kindest reading.
struct Readings {
  /// Observation 1 (Sec. 4.1): the intersection of two lines.
  Form observation = Form::printed;

  /// Sec. 4.2.1: "an overdetermined system of equations; there is no solution for s if the system
  /// is inconsistent". `printed` tests for consistency by equality, `tolerance` within a tolerance;
  /// `least_squares` solves any system; `corrected` solves the one equation along the edge.
  enum class Solve : std::uint8_t { printed, tolerance, least_squares, corrected };
  Solve solve = Solve::printed;
  /// The tolerance of Solve::tolerance, without a default: a factor of the sum of P's largest
  /// coordinate and Q's.
  Rational tolerance = 0;

  /// Sec. 4.2.3: the end points that bound the interval from below, and from above.
  Form interval = Form::printed;

  /// An end point without a solution (Sec. 4.2.1) bounds nothing, or the edges never meet. The text
  /// says neither.
  enum class NoRoot : std::uint8_t { unbounded, never };
  NoRoot no_root = NoRoot::unbounded;

  /// The intersections along an edge (Sec. 4.2.4) keep the order that events gave them, or are
  /// sorted at the scale reached ("we update all of the remaining nodes"). The first is wrong from
  /// the first triple event on.
  enum class Order : std::uint8_t { kept, sorted };
  Order order = Order::kept;

  /// Whether parallel edges take part; Sec. 4 does not mention them. Otherwise they never meet.
  bool parallel = false;

  /// Whether edges with a common vertex of the convolution are tested, too. They meet there at all
  /// scales; the text does not exclude any pair.
  bool adjacent = false;
};

/// All formulas in their right form and all events: over rational numbers the exact dynamic sum.
Readings corrected_readings();

/// Sets one reading by its name and value, as the command line spells both ("observation",
/// "printed"; "solve", "tolerance:1e-9"). Throws BadInput ("unknown-reading") with a list of all
/// choices.
void set_reading(Readings& readings, std::string_view name, std::string_view value);

/// The names and values that set_reading takes.
const std::vector<ReadingName>& reading_names();

/// Sets how to solve systems, and the tolerance if given ("printed", "tolerance:1e-9"). Throws
/// BadInput ("unknown-reading") with the choices that are `known`.
void set_solve(Readings::Solve& solve, Rational& tolerance, const std::vector<ReadingName>& known,
               std::string_view value);

}  // namespace minkref::inline plane
