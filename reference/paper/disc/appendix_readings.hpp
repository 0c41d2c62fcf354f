// Readings for the sentences of Behar & Lien 2012, Appendix: each by itself.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/disc/pairs/feature_pair.hpp"
#include "reference/form.hpp"
#include "reference/paper/reading_name.hpp"

namespace minkref::inline disc {

/// The Appendix's program, choice by choice. Defaults are the printed choices; where the text may
/// be read in two ways, the kinder one.
struct AppendixReadings {
  /// "rejecting solutions for which 0 < t or t > 1, or similarly for k": printed, t <= 0 is kept.
  Form rejected = Form::printed;

  /// "they must have exactly two events [...] or else the line segments do not intersect at all".
  /// Corrected: none, one where a reflex vertex joins them or where they only touch, or two.
  Form number = Form::printed;

  /// Parallel segments are not spoken of: left out, or taken where they come to face each other.
  bool parallel = false;

  /// "set the formula equal to p1(s) [...] in turn" is two equations with one unknown, and so is
  /// "assigning I(s) to the end-points": printed, both must hold in the arithmetic; corrected, one
  /// is solved where the other follows.
  Form solve = Form::printed;

  /// "M(s) = √(s² - s0²) r" as the text has it, with r under the root. Corrected: r √(s² - s0²).
  Form radical = Form::printed;

  /// "I(s) = M(s) (± ⊥ (c1, c2))" is the way from the middle of both centres ("the intersections
  /// simply move in the direction"), or, to the letter, the place itself.
  bool from_middle = true;

  /// "y = √(s² - s0²) r + yc1": whether M(s) contains the height of c1, which belongs to the frame
  /// of the derivation.
  bool with_height = false;

  /// "Consider the tangent line x0 = xc - s0 r": printed, the line stays where the disc touched it.
  /// Corrected: the segment moves with s, and is crossed at √(g (2 s r - g)) from the foot.
  Form line = Form::printed;

  /// "the unit vector in the direction from the center c, perpendicular to line segment l": from
  /// the centre of the disc at an end of the edge, hence outwards, or from the centre of sQ, the
  /// origin.
  bool from_origin = false;

  /// "updated reference points are computed as p(s) = p + (s - 1) r (⊥ l)": p is an end of the
  /// convolution's segment at s = 1, or, as "segments are always contributed by P", an end of P's
  /// edge.
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
