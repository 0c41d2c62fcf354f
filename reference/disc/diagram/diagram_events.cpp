#include "reference/disc/diagram/diagram_events.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "reference/build/stage.hpp"
#include "reference/disc/curves/origin_near.hpp"
#include "reference/disc/diagram/contact_envelope.hpp"
#include "reference/disc/diagram/diagram_count.hpp"
#include "reference/disc/diagram/event_prover.hpp"
#include "reference/disc/diagram/many_bits.hpp"
#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

constexpr double same_cell = 1e-7;  // candidates in one are looked at one after the other

/// Features that seem equally near to a place, and nearest.
struct Candidate {
  Features features;
  Vector<double> near;
};

/// Candidates from the points where a patch's first contact changes.
template <class Real>
std::vector<Candidate> candidates(const EdgeLookup& lookup, const BuildControl& control) {
  const OffsetCurves& curves = lookup.curves();
  const ContactEnvelopes<Real> envelopes(lookup);
  std::vector<std::vector<FirstContact>> contacts(curves.patches.size());
  in_parallel(contacts.size(), control, BuildProgress::Stage::patches, [&](unsigned) {
    return [&](std::size_t k) { contacts[k] = envelopes.of(static_cast<std::uint32_t>(k)); };
  });
  std::vector<Candidate> found;
  const auto add = [&](Features features, const Vector<double>& near) {
    std::sort(features.begin(), features.end());
    const bool are_three = std::adjacent_find(features.begin(), features.end()) == features.end();
    if (are_three) found.push_back({std::move(features), near});
  };
  for (std::uint32_t k = 0; k < contacts.size(); ++k) {
    const std::uint32_t own = curves.patches[k].feature, next = curves.patches[k].next;
    const std::vector<FirstContact>& parts = contacts[k];
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
      add({own, parts[i].feature, parts[i + 1].feature}, parts[i].last);
    }
    if (next == OffsetPatch::none || parts.empty()) continue;
    const std::uint32_t other = curves.patches[next].feature;
    if (own != other) {
      add({own, other, parts.back().feature}, parts.back().last);
    } else if (!contacts[next].empty()) {
      add({own, parts.back().feature, contacts[next].front().feature}, parts.back().last);
    }
  }
  return found;
}

/// Collects events as found, each once.
class Collection {
 public:
  Collection(const EdgeLookup& lookup, const BuildControl& control)
      : lookup_(lookup), control_(control), prover_(lookup) {}

  /// Adds the events behind candidates.
  void add(std::vector<Candidate> candidates) {
    std::erase_if(candidates, [&](const Candidate& each) {
      return std::any_of(each.features.begin(), each.features.end(), [&](std::uint32_t feature) {
        const OffsetCurves::Feature& own = lookup_.curves().features[feature];
        return own.edge == OffsetPatch::none && !own.has_arc;
      });
    });
    const std::vector<std::vector<Candidate>> cells = by_cells(std::move(candidates));
    std::vector<std::vector<DiagramEvent>> found(cells.size());
    std::vector<std::uint64_t> exact_signs(control_.threads(), 0);
    in_parallel(cells.size(), control_, BuildProgress::Stage::pairs, [&](unsigned thread) {
      return [&, thread, prover = EventProver(lookup_)](std::size_t k) mutable {
        found[k] = events_of(cells[k], prover);
        exact_signs[thread] = prover.exact_signs;
      };
    });
    for (const std::uint64_t signs : exact_signs) exact_signs_ += signs;
    for (std::vector<DiagramEvent>& cell : found) {
      for (DiagramEvent& event : cell) keep(std::move(event), events_, of_features_);
    }
  }

  /// Adds the events at given places, of whatever kind, each proven.
  void add_places(const std::vector<FoundPlace>& places) {
    std::vector<std::optional<DiagramEvent>> found(places.size());
    std::vector<std::uint64_t> exact_signs(control_.threads(), 0);
    in_parallel(places.size(), control_, BuildProgress::Stage::pairs, [&](unsigned thread) {
      return [&, thread, prover = EventProver(lookup_)](std::size_t k) mutable {
        const auto at = prover.places(places[k].of);
        if (places[k].branch >= at.size()) return;
        found[k] = prover.event(places[k].of, places[k].branch, at[places[k].branch]);
        exact_signs[thread] = prover.exact_signs;
      };
    });
    for (const std::uint64_t signs : exact_signs) exact_signs_ += signs;
    for (std::optional<DiagramEvent>& event : found) {
      if (event) keep(std::move(*event), events_, of_features_);
    }
  }

  /// Adds the places where two features are nearest to each other: on the diagram's part between
  /// them, which starts at an event, or at infinity.
  void add_saddles(const DiagramCount& count) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const HullGap& gap : count.gaps) pairs.insert(std::minmax(gap.from, gap.to));
    for (const DiagramEvent& event : events_) {
      for (std::size_t i = 0; i < event.features.size(); ++i) {
        for (std::size_t k = i + 1; k < event.features.size(); ++k) {
          pairs.insert({event.features[i], event.features[k]});
        }
      }
    }
    std::vector<Candidate> found;
    for (const auto& [a, b] : pairs) {
      const Site one = Site::of(lookup_.curves(), a), other = Site::of(lookup_.curves(), b);
      if (!one.is_point && !other.is_point) continue;
      for (const auto& place : EquidistantPoints<double>::between(one, other)) {
        found.push_back({{a, b}, place.at});
      }
    }
    add(std::move(found));
  }

  bool is_complete(const DiagramCount& count) const {
    std::int64_t excess = 0;
    std::set<std::pair<std::uint32_t, std::uint32_t>> joints;
    for (const DiagramEvent& event : events_) {
      const auto nearest = static_cast<std::int64_t>(event.nearest_points());
      if (nearest > 2) excess += nearest - 2;
      for (const auto& joint : event.joints) {
        if (!joints.insert(joint).second) {
          throw std::logic_error("two events are in front of one end of an edge");
        }
      }
    }
    if (excess > count.excess) throw std::logic_error("a diagram has too many corners");
    return excess == count.excess && joints == count.joints;
  }

  std::uint64_t exact_signs() const { return exact_signs_; }
  std::vector<DiagramEvent> events() && { return std::move(events_); }

 private:
  using OfFeatures = std::map<Features, std::vector<std::size_t>>;

  /// Groups candidates near each other.
  static std::vector<std::vector<Candidate>> by_cells(std::vector<Candidate> candidates) {
    std::map<std::pair<double, double>, std::vector<Candidate>> cells;
    for (Candidate& each : candidates) {
      const bool is_finite = std::isfinite(each.near.x) && std::isfinite(each.near.y);
      const auto cell = [&](double x) { return is_finite ? std::round(x / same_cell) : 0.0; };
      cells[{cell(each.near.x), cell(each.near.y)}].push_back(std::move(each));
    }
    std::vector<std::vector<Candidate>> found;
    for (auto& [cell, all] : cells) found.push_back(std::move(all));
    return found;
  }

  static std::vector<DiagramEvent> events_of(const std::vector<Candidate>& cell,
                                             EventProver& prover) {
    std::vector<DiagramEvent> found;
    OfFeatures of_features;
    std::set<std::pair<Features, unsigned>> looked_at;
    for (const Candidate& each : cell) {
      const auto places = prover.places(each.features);
      std::vector<double> far;
      for (const auto& place : places) {
        const double way = std::hypot(approximate(place.at.x) - each.near.x,
                                      approximate(place.at.y) - each.near.y);
        far.push_back(std::isfinite(way) ? way : 0);
      }
      for (unsigned branch = 0; branch < places.size(); ++branch) {
        // The nearer place, or both if roundings may exchange them.
        if (places.size() == 2 && far[branch] > 4 * far[1 - branch] && far[branch] > same_cell) {
          continue;
        }
        if (!looked_at.insert({each.features, branch}).second) continue;
        if (is_known(each.features, branch, places, found)) continue;
        auto event = prover.event(each.features, branch, places[branch]);
        if (event) keep(std::move(*event), found, of_features, prover);
      }
    }
    return found;
  }

  /// Whether an event lies equally far from all these features, and not at their other place.
  static bool is_known(const Features& features, unsigned branch,
                       const std::vector<Equidistant<Interval>>& places,
                       const std::vector<DiagramEvent>& events) {
    if (features.size() < 3) return false;
    return std::any_of(events.begin(), events.end(), [&](const DiagramEvent& event) {
      return std::includes(event.features.begin(), event.features.end(), features.begin(),
                           features.end()) &&
             (places.size() == 1 || !box_of(event.at).overlaps(box_of(places[1 - branch].at)));
    });
  }

  static void keep(DiagramEvent event, std::vector<DiagramEvent>& events, OfFeatures& of_features,
                   const EventProver& prover) {
    std::vector<std::size_t>& same = of_features[event.features];
    for (const std::size_t number : same) {
      if (prover.are_one(events[number], event)) return;
    }
    same.push_back(events.size());
    events.push_back(std::move(event));
  }
  void keep(DiagramEvent event, std::vector<DiagramEvent>& events, OfFeatures& of_features) {
    keep(std::move(event), events, of_features, prover_);
  }

  const EdgeLookup& lookup_;
  const BuildControl& control_;
  EventProver prover_;
  std::vector<DiagramEvent> events_;
  OfFeatures of_features_;
  std::uint64_t exact_signs_ = 0;
};

/// Moves P into a box of size about 1, so that every double stays within range.
DiagramEvents in_unit_box(const PolygonSet& P) {
  namespace mp = boost::multiprecision;
  DiagramEvents result{{}, {0, 0}, 1, {}, {}, {}, 0};
  std::optional<std::pair<Point, Point>> box;
  const auto for_points = [](PolygonSet& set, auto&& look) {
    for (Polygon& polygon : set.polygons) {
      std::for_each(polygon.outer.begin(), polygon.outer.end(), look);
      for (Ring& hole : polygon.holes) std::for_each(hole.begin(), hole.end(), look);
    }
  };
  PolygonSet moved = P;
  for_points(moved, [&](const Point& p) {
    if (!box) box = {p, p};
    box->first = {std::min(box->first.x, p.x), std::min(box->first.y, p.y)};
    box->second = {std::max(box->second.x, p.x), std::max(box->second.y, p.y)};
  });
  if (box) {
    result.origin = origin_near(P, 0, 0);
    const Rational size =
        std::max(Rational(box->second.x - box->first.x), Rational(box->second.y - box->first.y));
    if (size > 0) {
      const auto bits = [](const Integer& number) { return static_cast<long>(mp::msb(number)); };
      const long exponent = bits(mp::denominator(size)) - bits(mp::numerator(size));
      const Rational power(Integer(1) << static_cast<unsigned>(std::abs(exponent)));
      result.factor = exponent < 0 ? Rational(1 / power) : power;
    }
  }
  for_points(moved, [&](Point& p) {
    p = {(p.x - result.origin.x) * result.factor, (p.y - result.origin.y) * result.factor};
  });
  result.curves = offset_curves(moved);
  return result;
}

/// Numbers that were found equal, by events: each two are compared once, however often a sort asks.
class Ties {
 public:
  explicit Ties(std::size_t count) : first_(count) {
    std::iota(first_.begin(), first_.end(), std::size_t{0});
  }
  /// An event for all those that are known to be equal to this one.
  std::size_t of(std::size_t k) {
    while (first_[k] != k) k = first_[k] = first_[first_[k]];
    return k;
  }
  void join(std::size_t a, std::size_t b) { first_[std::max(a, b)] = std::min(a, b); }

 private:
  std::vector<std::size_t> first_;
};

/// Sorts by radius, then by x, then by y: an order independent of how P is written. Computes exact
/// places only if intervals do not tell, once each.
void sort_by_place(DiagramEvents& result) {
  std::vector<std::optional<Equidistant<RootNumber>>> exact(result.events.size());
  const auto exact_of = [&](std::size_t k) -> const Equidistant<RootNumber>& {
    const DiagramEvent& event = result.events[k];
    if (!exact[k]) {
      exact[k] = equidistant_places<RootNumber>(result.curves, event.of).at(event.branch);
    }
    return *exact[k];
  };
  const auto order = [&](std::size_t a, std::size_t b, Ties& ties, auto&& of) {
    const Interval &x = of(result.events[a]), &y = of(result.events[b]);
    if (x.upper() < y.lower()) return -1;
    if (x.lower() > y.upper()) return 1;
    const std::size_t first = ties.of(a), second = ties.of(b);
    if (first == second) return 0;
    const int found = compare(of(exact_of(first)), of(exact_of(second)));
    if (found == 0) ties.join(first, second);
    return found;
  };
  Ties radii(result.events.size()), xs(result.events.size()), ys(result.events.size());
  const auto is_before = [&](std::size_t a, std::size_t b) {
    if (a == b) return false;
    const auto radius = [](const auto& each) -> const auto& { return each.squared_radius; };
    const auto x = [](const auto& each) -> const auto& { return each.at.x; };
    const auto y = [](const auto& each) -> const auto& { return each.at.y; };
    if (const int by_radius = order(a, b, radii, radius)) return by_radius < 0;
    if (const int by_x = order(a, b, xs, x)) return by_x < 0;
    return order(a, b, ys, y) < 0;
  };
  std::vector<std::size_t> numbers(result.events.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::sort(numbers.begin(), numbers.end(), is_before);
  std::vector<DiagramEvent> sorted;
  sorted.reserve(numbers.size());
  for (const std::size_t k : numbers) sorted.push_back(std::move(result.events[k]));
  result.events = std::move(sorted);
}

struct Search {
  const EdgeLookup& lookup;
  const BuildControl& control;
  const DiagramCount& count;
};

/// `find_corners(search, found)` adds all events with three features or more, or throws.
template <class FindCorners>
DiagramEvents complete_events(const PolygonSet& P, const BuildOptions& options,
                              FindCorners&& find_corners) {
  DiagramEvents result = in_unit_box(P);
  const EdgeLookup lookup(result.curves);
  const BuildControl control(options, "the events");
  result.walks = boundary_walks(lookup);
  const DiagramCount count = diagram_count(result.curves, result.walks);
  result.gaps = count.gaps;
  Collection found(lookup, control);
  find_corners(Search{lookup, control, count}, found);
  found.add_saddles(count);
  result.exact_signs = found.exact_signs();
  result.events = std::move(found).events();
  sort_by_place(result);
  return result;
}

/// Whether each place has three features, ascending, all with a part of the offset.
bool are_possible(const std::vector<FoundPlace>& places, const OffsetCurves& curves) {
  return std::all_of(places.begin(), places.end(), [&](const FoundPlace& place) {
    return place.of.size() == 3 &&
           std::adjacent_find(place.of.begin(), place.of.end(), std::greater_equal<>()) ==
               place.of.end() &&
           place.of.back() < curves.features.size() &&
           std::all_of(
               place.of.begin(), place.of.end(),
               [&](std::uint32_t feature) {
                 return curves.features[feature].edge != OffsetPatch::none ||
                        curves.features[feature].has_arc;
               });
  });
}

}  // namespace

Equidistant<RootNumber> DiagramEvents::exact(const DiagramEvent& event) const {
  const auto found = equidistant_places<RootNumber>(curves, event.of).at(event.branch);
  const RootNumber inverse(Rational(1 / factor));
  return {inverse * found.at + numbers<RootNumber>(origin),
          inverse * inverse * found.squared_radius};
}

Vector<Interval> DiagramEvents::place(const DiagramEvent& event) const {
  return Interval(Rational(1 / factor)) * event.at + numbers<Interval>(origin);
}

Interval DiagramEvents::radius(const DiagramEvent& event) const {
  return Interval(Rational(1 / factor)) * sqrt(event.squared_radius);
}

Point DiagramEvents::vertex(std::uint32_t feature) const {
  const Point& p = curves.features[feature].centre;
  return {p.x / factor + origin.x, p.y / factor + origin.y};
}

std::vector<FoundPlace> DiagramEvents::places() const {
  std::vector<FoundPlace> found;
  for (const DiagramEvent& event : events) {
    if (event.of.size() == 3) found.push_back({event.of, event.branch});
  }
  return found;
}

DiagramEvents diagram_events(const PolygonSet& P, const BuildOptions& options) {
  const FloatEnvironment standard;
  return complete_events(P, options, [](const Search& search, Collection& found) {
    found.add(candidates<double>(search.lookup, search.control));
    const auto is_complete = [&] { return found.is_complete(search.count); };
    if (!is_complete()) found.add(candidates<ManyBits<256>>(search.lookup, search.control));
    if (!is_complete()) found.add(candidates<ManyBits<1024>>(search.lookup, search.control));
    if (is_complete()) return;
    throw LimitExceeded("too-near",
                        "two places of events are nearer to each other than 1,024 bits tell",
                        "move vertices that are almost, but not quite, as far from some place");
  });
}

DiagramEvents diagram_events(const PolygonSet& P, const std::vector<FoundPlace>& places,
                             const BuildOptions& options) {
  const FloatEnvironment standard;
  return complete_events(P, options, [&](const Search& search, Collection& found) {
    if (are_possible(places, search.lookup.curves())) {
      found.add_places(places);
      if (found.is_complete(search.count)) return;
    }
    throw BadInput("other-places", "the places of events are not those of this set",
                   "give the set that they were found for");
  });
}

}  // namespace minkref::inline disc
