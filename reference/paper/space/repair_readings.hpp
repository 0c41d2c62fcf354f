// The readings of the sentences of Behar & Lien 2012, Sec. 6: each by itself.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/form.hpp"
#include "reference/paper/reading_name.hpp"

namespace minkref::inline space {

/// The paper's repair of a convex sum, choice by choice. Defaults are the printed choices.
struct RepairReadings {
  /// "IC(f, v) = max d(e, f)", the longest Euclidean distance, on whichever side of the plane
  /// through v; or max(0, max n . (w - v)), which tells above from below.
  Form degree = Form::printed;

  /// The end of the descent: no edge at the vertex above the plane ("all the edges that are
  /// incident to v must be below or on the half-plane"), or a degree that is 0.
  enum class Test : std::uint8_t { sides, degree };
  Test test = Test::sides;

  /// The facets that are tested. "Let f be a facet of P and v be a vertex of Q": facets of P. The
  /// text says elsewhere "and vice-versa". `chains_from_P` mends Q's facets too, but starts chains
  /// of ee-errors only from errors of P's facets.
  enum class Errors : std::uint8_t { facets_of_P, chains_from_P, both };
  Errors errors = Errors::facets_of_P;

  /// The edges whose partners are searched again. `ee_errors`: "an edge from P involved in an
  /// ee-error", found along "chains of ee-errors connected to the vf-error". `beside_errors`: also
  /// edges without a lost pair beside a facet's error, and along the way of a descent.
  /// `everywhere`: all edges.
  enum class Search : std::uint8_t { ee_errors, beside_errors, everywhere };
  Search search = Search::ee_errors;

  /// Edges parallel to facets. "g(e) and g(e') must intersect": at a point at least (`closed`), or
  /// inside both arcs (`open`). `perturbed`: as if an infinitesimal linear map moved P
  /// (facet_contact.hpp), so that no edge is parallel.
  enum class Ties : std::uint8_t { closed, open, perturbed };
  Ties ties = Ties::closed;
};

/// All in their right form: over rational numbers the proven update.
RepairReadings corrected_repair_readings();

/// Sets one reading by its name and value, as the command line spells both ("degree", "printed").
/// Throws BadInput ("unknown-reading") with a list of all choices.
void set_reading(RepairReadings& readings, std::string_view name, std::string_view value);

/// The names and values that set_reading takes.
const std::vector<ReadingName>& repair_reading_names();

}  // namespace minkref::inline space
