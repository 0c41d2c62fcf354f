#include "bindings/core_disc_paths.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_build.hpp"
#include "bindings/diagram_row.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/disc/clearance/clear_radius.hpp"
#include "reference/disc/clearance/disc_passage.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// The place's segment, t and point; whether an edge is touched, its ring and index; where.
using DiscContactRow = std::tuple<std::uint32_t, std::string, ExactPoint, bool, std::uint32_t,
                                  std::uint32_t, ExactPoint>;
/// The squared distance, if known as rational, and a polynomial with this root; doubles around the
/// distance less the clearance; how this compares with the radius that was asked for, 0 without.
using RadiusRow = std::tuple<std::optional<std::string>, std::vector<std::string>,
                             std::pair<double, double>, int>;
/// The radius, the contact.
using LargestDiscRow = std::pair<RadiusRow, std::optional<DiscContactRow>>;
/// The radius's limit, the largest discs at the two places, the radius of a neck, the necks.
using PassageRow =
    std::tuple<std::string, std::optional<LargestDiscRow>, std::optional<LargestDiscRow>,
               std::optional<RadiusRow>, std::vector<DiagramRow>>;

Point point_of(const ExactPoint& text) {
  return {parse_rational(text.first), parse_rational(text.second)};
}

/// A question about radii: the clearance to keep, and perhaps a disc to compare.
struct Asked {
  Rational clearance;
  std::optional<Rational> squared_radius;

  Asked(const std::string& clearance_text, const std::optional<std::string>& squared)
      : clearance(parse_rational(clearance_text)) {
    if (squared) squared_radius = parse_rational(*squared);
  }

  RadiusRow radius(const RootNumber& squared) const {
    const SquareRow square = square_row(squared);
    const Enclosure near = enclose(clear_radius(squared, clearance));
    const int order = squared_radius ? compare_radius(squared, clearance, *squared_radius) : 0;
    return {square.rational, square.polynomial, {near.lower, near.upper}, order};
  }

  std::optional<LargestDiscRow> row(const std::optional<DiscOnPath>& found) const {
    if (!found) return std::nullopt;
    LargestDiscRow made{radius(RootNumber(found->squared_radius)), std::nullopt};
    if (const auto& contact = found->contact) {
      made.second.emplace(contact->at.segment, to_string(contact->at.t),
                          to_strings(contact->at.point), contact->is_edge, contact->feature.ring,
                          contact->feature.index, to_strings(contact->touching));
    }
    return made;
  }
};

const char* name(DiscPassage::Limit limit) {
  switch (limit) {
    case DiscPassage::Limit::apart:
      return "apart";
    case DiscPassage::Limit::start:
      return "start";
    case DiscPassage::Limit::end:
      return "end";
    case DiscPassage::Limit::neck:
      return "neck";
  }
  return "";
}

}  // namespace

void bind_disc_paths(nb::module_& module) {
  module.def(
      "disc_on_path",
      [](const Set& obstacles, const std::vector<ExactPoint>& path, const std::string& clearance,
         const std::optional<std::string>& squared_radius) {
        std::vector<Point> points;
        for (const ExactPoint& p : path) points.push_back(point_of(p));
        return Asked(clearance, squared_radius).row(largest_disc_on_path(obstacles.value, points));
      },
      "obstacles"_a, "path"_a, "clearance"_a = "0", "squared_radius"_a = nb::none(), Released(),
      "(radius, contact) of the largest disc on a polyline past a set; None for the empty set. A "
      "radius is (squared distance or None, polynomial, doubles around the distance less the "
      "clearance, its order to the radius asked for); a contact (segment, t, place, whether an "
      "edge "
      "is touched, ring, index, where), None if the path starts inside. Raises BadInput.");
  module.def(
      "disc_passage",
      [](const Set& obstacles, const ExactPoint& from, const std::optional<ExactPoint>& to,
         const std::string& clearance, const std::optional<std::string>& squared_radius,
         unsigned threads) -> PassageRow {
        const Asked asked(clearance, squared_radius);
        std::optional<Point> end;
        if (to) end = point_of(*to);
        const DiscRooms rooms(obstacles.value, build_on(threads));
        const DiscPassage found = rooms.passage(point_of(from), end);
        const DiagramEvents& diagram = rooms.index().diagram();
        std::optional<RadiusRow> radius;
        std::vector<DiagramRow> necks;
        for (const std::uint32_t neck : found.necks) {
          const DiagramEvent& event = diagram.events[neck];
          if (!radius) radius = asked.radius(diagram.exact(event).squared_radius);
          necks.push_back(diagram_row(diagram, event));
        }
        return {name(found.limit), asked.row(found.at_start), asked.row(found.at_end),
                std::move(radius), std::move(necks)};
      },
      "obstacles"_a, "start"_a, "end"_a = nb::none(), "clearance"_a = "0",
      "squared_radius"_a = nb::none(), "threads"_a = 1, Released(),
      "(limit, largest disc at the start, at the end, radius of the necks, necks) of the largest "
      "disc from a place to another, or away without an end. Raises BadInput, LimitExceeded.");
  module.def(
      "disc_anywhere",
      [](const Set& obstacles, const std::string& clearance,
         const std::optional<std::string>& squared_radius, unsigned threads) {
        const Asked asked(clearance, squared_radius);
        const DiscIndex index(obstacles.value, build_on(threads));
        const DiagramEvents& diagram = index.diagram();
        const auto radius = static_cast<std::uint32_t>(index.radii());
        std::vector<DiagramRow> places;
        for (std::uint32_t k = 0; k < diagram.events.size(); ++k) {
          if (index.radius_number(k) == radius) {
            places.push_back(diagram_row(diagram, diagram.events[k]));
          }
        }
        const DiagramEvent& event = diagram.events[index.event_at(radius - 1)];
        return std::pair(asked.radius(diagram.exact(event).squared_radius), std::move(places));
      },
      "obstacles"_a, "clearance"_a = "0", "squared_radius"_a = nb::none(), "threads"_a = 1,
      Released(),
      "(radius, places) of the largest discs among obstacles that leave bounded rooms alone: the "
      "outside of a container. Raises BadInput, LimitExceeded.");
}

}  // namespace minkref::python
