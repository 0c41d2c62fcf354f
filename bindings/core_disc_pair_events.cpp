// Radii at which features of an offset start or stop to meet, for Python.
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/disc/pairs/pair_events.hpp"
#include "reference/error.hpp"
#include "reference/number/radicals/nearest_double.hpp"
#include "reference/number/radicals/polynomial.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

struct TimedDiscPairEvents {
  DiscPairEvents found;
  double seconds;
};

using Counts = std::map<std::string, std::uint64_t>;
/// "vertex" and its coordinates, or "edge" with the ring and the index of its first vertex.
using FeatureName = std::tuple<std::string, std::string, std::string>;
/// The condition, the feature whose end comes to the other ("a", "b", or "" at a tangent), the end
/// (0, 1), whether both features hold the place, and the rounded place.
using ContactRow = std::tuple<std::string, std::string, int, bool, std::pair<double, double>>;
/// The squared radius if rational; a polynomial with this root, the lowest coefficient first;
/// bounds of the radius.
using RadiusRow =
    std::tuple<std::optional<std::string>, std::vector<std::string>, std::pair<double, double>>;
/// Change; radius; points that the features share before, at and after it, -1 for a segment;
/// contacts.
using EventRow =
    std::tuple<std::string, RadiusRow, std::tuple<int, int, int>, std::vector<ContactRow>>;
using PairRow = std::tuple<std::uint32_t, std::string, std::vector<FeatureName>, EventRow>;
/// An edge's two points, or an arc's three points, with the centre second.
using GivenFeature = std::vector<ExactPoint>;

std::pair<double, double> radius_between(const RootNumber& square) {
  const Enclosure radius = enclose(root_of(square));
  return {radius.lower, radius.upper};
}

RadiusRow radius_row(const RootNumber& square) {
  const Polynomial polynomial = without_multiple_roots(square.polynomial());
  std::vector<std::string> coefficients;
  for (const Rational& c : polynomial) coefficients.push_back(to_string(c));
  std::optional<std::string> rational;
  if (polynomial.size() == 2) rational = to_string(Rational(-polynomial[0]));
  return {rational, coefficients, radius_between(square)};
}

int count(std::uint8_t points) { return points == FeatureEvent::segment ? -1 : points; }

EventRow event_row(const FeaturePair& pair, bool a_is_arc, bool b_is_arc,
                   const std::vector<PairContact>& contacts, const FeatureEvent& event) {
  std::vector<ContactRow> rows;
  for (const PairContact& each : contacts) {
    const bool is_tangent = each.slot == ContactSlot::tangent;
    const RootPoint place = pair.place<RootNumber>(each);
    rows.emplace_back(FeaturePair::name(each.slot, a_is_arc, b_is_arc),
                      is_tangent                         ? ""
                      : each.slot < ContactSlot::b_first ? "a"
                                                         : "b",
                      is_tangent ? 0 : static_cast<int>(each.slot) % 2, each.meets,
                      std::pair{nearest_double(place.x), nearest_double(place.y)});
  }
  return {std::string(name(event.change)),
          radius_row(pair.squared_radius(contacts[0])),
          {count(event.before), count(event.at), count(event.after)},
          rows};
}

FeatureName feature_name(const OffsetFeature& feature) {
  if (feature.is_arc) {
    return {"vertex", to_string(feature.at[0].x), to_string(feature.at[0].y)};
  }
  return {"edge", std::to_string(feature.id.ring), std::to_string(feature.id.index)};
}

PairRow pair_row(const DiscPairEvents& found, const DiscPairEvent& event) {
  const OffsetFeature &a = found.features[event.a], &b = found.features[event.b];
  const FeatureNumbers<Interval> near_a(a), near_b(b);
  const FeaturePair pair(a, b, near_a, near_b);
  FeatureEvent counted;
  counted.change = event.change;
  counted.before = event.before;
  counted.at = event.at;
  counted.after = event.after;
  return {event.rank,
          std::string(found.kind(event)),
          {feature_name(a), feature_name(b)},
          event_row(pair, a.is_arc, b.is_arc, event.all_contacts(), counted)};
}

Point point(const ExactPoint& p) { return {parse_rational(p.first), parse_rational(p.second)}; }

OffsetFeature feature(const GivenFeature& given) {
  if (given.size() == 2) return OffsetFeature::edge(point(given[0]), point(given[1]));
  if (given.size() != 3) {
    throw BadInput("bad-feature", "a feature has " + std::to_string(given.size()) + " points",
                   "give two of an edge, or three of the arc about the second");
  }
  const Point p = point(given[0]), centre = point(given[1]), q = point(given[2]);
  return OffsetFeature::arc(centre, from_to(p, centre), from_to(centre, q));
}

/// All readings corrected, except for the named sentences.
DiscReadings readings_as_printed(const std::vector<std::string>& printed) {
  DiscReadings readings;
  const std::vector<std::pair<std::string, Form*>> known{{"rejected", &readings.rejected},
                                                         {"number", &readings.number},
                                                         {"radical", &readings.radical},
                                                         {"line", &readings.line},
                                                         {"parallel", &readings.parallel}};
  for (const std::string& sentence : printed) {
    bool is_known = false;
    for (const auto& [name, form] : known) {
      if (name != sentence) continue;
      *form = Form::printed;
      is_known = true;
    }
    if (!is_known) {
      throw BadInput("unknown-reading", "there is no sentence " + sentence,
                     "choose rejected, number, radical, line or parallel");
    }
  }
  return readings;
}

std::vector<EventRow> events_of_two(const GivenFeature& first, const GivenFeature& second,
                                    const std::vector<std::string>& printed, bool unit_radius) {
  const OffsetFeature a = feature(first), b = feature(second);
  const FeatureNumbers<Interval> near_a(a), near_b(b);
  FeaturePair pair(a, b, near_a, near_b);
  std::vector<FeatureEvent> events = pair.events();
  if (!printed.empty()) events = pair.printed_events(readings_as_printed(printed), unit_radius);
  std::vector<EventRow> rows;
  for (const FeatureEvent& event : events) {
    rows.push_back(event_row(pair, a.is_arc, b.is_arc, event.contacts, event));
  }
  return rows;
}

TimedDiscPairEvents timed_events(const Set& P, const std::vector<std::string>& printed,
                                 bool unit_radius, const std::optional<std::string>& from,
                                 const std::optional<std::string>& to,
                                 std::optional<std::size_t> most) {
  const Stopwatch watch;
  DiscPairOptions options;
  options.readings = readings_as_printed(printed);
  options.has_unit_radius = unit_radius;
  if (from) options.from = parse_rational(*from);
  if (to) options.to = parse_rational(*to);
  options.most = most;
  DiscPairEvents found = disc_pair_events(P.value, options);
  return {std::move(found), watch.seconds()};
}

Fields counts(const TimedDiscPairEvents& self) {
  const DiscPairEvents& found = self.found;
  Fields fields;
  fields["features"] = found.features.size();
  fields["pairs"] = found.pairs;
  fields["filtered_pairs"] = found.filtered_pairs;
  fields["exact_signs"] = found.exact_signs;
  fields["count"] = found.count;
  fields["true_count"] = found.true_count;
  fields["right_count"] = found.right_count;
  fields["changes"] = Counts(found.changes.begin(), found.changes.end());
  fields["kinds"] = Counts(found.kinds.begin(), found.kinds.end());
  return fields;
}

}  // namespace

void bind_disc_pair_events(nb::module_& module) {
  nb::class_<TimedDiscPairEvents>(
      module, "DiscPairEvents",
      "The radii at which two offset features start or stop to share points, ascending.")
      .def("__len__", [](const TimedDiscPairEvents& self) { return self.found.events.size(); })
      .def_ro("seconds", &TimedDiscPairEvents::seconds)
      .def("counts", counts, "Of features, pairs, signs and events, also of those not kept.")
      .def(
          "rows",
          [](const TimedDiscPairEvents& self, std::size_t first, std::size_t most) {
            const auto& all = self.found.events;
            std::vector<PairRow> rows;
            for (std::size_t k = first; k < all.size() && k - first < most; ++k) {
              rows.push_back(pair_row(self.found, all[k]));
            }
            return rows;
          },
          "first"_a, "count"_a, Released(), "(rank, kind, features, event as of disc_pair).");
  module.def("disc_pair_events", timed_events, "P"_a, "printed"_a = std::vector<std::string>(),
             "unit_radius"_a = true, "from_squared"_a = nb::none(), "to_squared"_a = nb::none(),
             "most"_a = nb::none(), Released(),
             "Events of all pairs of features, perhaps in a window of squared radii; the first "
             "`most` are kept. `printed`: sentences of the Appendix that are taken as they stand "
             "(rejected, number, radical, line, parallel), for a disc whose radius at the scale 1 "
             "is 1 or not. Raises BadInput.");
  module.def("disc_pair", events_of_two, "a"_a, "b"_a, "printed"_a = std::vector<std::string>(),
             "unit_radius"_a = true, Released(),
             "Events of two features: edges of two points with P on the left, arcs of three about "
             "the second. (change, (squared radius or None, polynomial, bounds of the radius), "
             "points shared before, at and after, -1 for a segment, contacts); a contact is "
             "(condition, whose end, which, whether it is on both, place). Raises BadInput.");
}

}  // namespace minkref::python
