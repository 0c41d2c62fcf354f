// Readings for the sentences of Behar & Lien 2012, Appendix: each by itself.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/disc/pairs/feature_pair.hpp"
#include "reference/form.hpp"
#include "reference/paper/reading_name.hpp"

namespace minkref::inline disc {

/// The Appendix's program, choice by choice. Defaults are the printed choices; the kinder choice
/// for ambiguous text.
struct AppendixReadings {
  /// "rejecting solutions for which 0 < t or t > 1, or similarly for k": printed, t <= 0 is kept.
  Form rejected = Form::printed;

  /// "they must have exactly two events [...] or else the line segments do not intersect at all".
  /// Corrected: also segments with a single event meet, at a reflex vertex or touching.
  Form number = Form::printed;

  /// The text never mentions parallel segments: left out, or taken if they come to coincide.
  bool parallel = false;

  /// "set the formula equal to p1(s) [...] in turn", "assigning I(s) to the end-points": two
  /// equations for a single unknown. Printed: both must hold in the arithmetic; corrected: the
  /// program solves the first where the second follows.
  Form solve = Form::printed;

  /// "M(s) = √(s² - s0²) r", printed with r under the root. Corrected: r √(s² - s0²).
  Form radical = Form::printed;

  /// "I(s) = M(s) (± ⊥ (c1, c2))": a displacement from the centres' midpoint ("the intersections
  /// simply move in the direction"), or, to the letter, a place.
  bool from_middle = true;

  /// "y = √(s² - s0²) r + yc1": whether M(s) contains c1's height in the derivation's frame.
  bool with_height = false;

  /// "Consider the tangent line x0 = xc - s0 r": printed, the line stays where the disc touched it.
  /// Corrected: the segment moves with s, and is crossed at √(g (2 s r - g)) from the foot.
  Form line = Form::printed;

  /// "the unit vector in the direction from the center c, perpendicular to line segment l": c is
  /// the centre with the disc placed at the edge's end, hence outwards, or sQ's centre, the origin.
  bool from_origin = false;

  /// "updated reference points are computed as p(s) = p + (s - 1) r (⊥ l)": p ends the
  /// convolution's segment at s = 1, or, since "segments are always contributed by P", P's edge.
  bool of_polygon = false;
};

/// All sentences in their right form: over exact numbers the sum itself.
AppendixReadings corrected_appendix();

/// The readings of the Appendix's events alone, for the exact search (pair_events.hpp).
DiscReadings event_readings(const AppendixReadings& readings);

/// Sets one reading by its name and value, as the command line spells both. Throws BadInput
/// ("unknown-reading") with a list of all choices.
void set_reading(AppendixReadings& readings, std::string_view name, std::string_view value);

/// The names and values that set_reading takes.
const std::vector<ReadingName>& appendix_reading_names();

}  // namespace minkref::inline disc
