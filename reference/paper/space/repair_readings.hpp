// How the sentences of Behar & Lien 2012, Sec. 6, are read: each by itself.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/form.hpp"
#include "reference/paper/reading_name.hpp"

namespace minkref::inline space {

/// The paper's repair of a convex sum, choice by choice. As they stand here they are the printed
/// ones.
struct RepairReadings {
  /// "IC(f, v) = max d(e, f)", the longest Euclidean distance, on whichever side of the plane
  /// through v; or max(0, max n . (w - v)), which tells above from below.
  Form degree = Form::printed;

  /// The end of the descent: no edge at the vertex above the plane ("all the edges that are
  /// incident to v must be below or on the half-plane"), or a degree that is 0.
  enum class Test : std::uint8_t { sides, degree };
  Test test = Test::sides;

  /// Which facets are tested. "Let f be a facet of P and v be a vertex of Q": facets of P. The text
  /// says elsewhere "and vice-versa". `chains_from_P` mends the facets of Q too, but starts chains
  /// of ee-errors from errors of facets of P only.
  enum class Errors : std::uint8_t { facets_of_P, chains_from_P, both };
  Errors errors = Errors::facets_of_P;

  /// Whose edges are looked for again. `ee_errors`: of "an edge from P involved in an ee-error",
  /// found along "chains of ee-errors connected to the vf-error". `beside_errors`: also of edges
  /// beside an error of a facet that have lost no pair, and on the way of a descent.
  /// `everywhere`: of all.
  enum class Search : std::uint8_t { ee_errors, beside_errors, everywhere };
  Search search = Search::ee_errors;

  /// Edges parallel to facets. "g(e) and g(e') must intersect": in one point at least (`closed`),
  /// or inside both arcs (`open`). `perturbed`: as if P were moved by an infinitesimal linear map
  /// (facet_contact.hpp), so that there are none.
  enum class Ties : std::uint8_t { closed, open, perturbed };
  Ties ties = Ties::closed;
};

/// All in their right form: over rational numbers the proven update.
RepairReadings corrected_repair_readings();

/// Sets one reading by its name and value, as the command line spells them ("degree", "printed").
/// Throws BadInput ("unknown-reading") that lists what there is.
void set_reading(RepairReadings& readings, std::string_view name, std::string_view value);

/// The names and values that set_reading takes.
const std::vector<ReadingName>& repair_reading_names();

}  // namespace minkref::inline space
