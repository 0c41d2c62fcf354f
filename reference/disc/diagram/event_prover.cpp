#include "reference/disc/diagram/event_prover.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace minkref::inline disc {
namespace {

using Kind = DiagramEvent::Kind;

/// Whether a place is known to some nine digits.
bool is_sharp(const Equidistant<Interval>& place) {
  const auto width = [](const Interval& value) { return value.upper() - value.lower(); };
  const Interval& square = place.squared_radius;
  return square.lower() > 0 && width(square) < 1e-9 * square.upper() &&
         std::max(width(place.at.x), width(place.at.y)) < 1e-9 * std::sqrt(square.lower());
}

bool are_apart(const Vector<Interval>& a, const Vector<Interval>& b) {
  return !box_of(a).overlaps(box_of(b));
}

}  // namespace

std::vector<Equidistant<Interval>> EventProver::places(const Features& features) const {
  try {
    auto found = equidistant_places<Interval>(curves_, features);
    if (std::all_of(found.begin(), found.end(), is_sharp)) return found;
  } catch (const UndecidedSign&) {
  }
  std::vector<Equidistant<Interval>> found;
  for (const auto& place : equidistant_places<RootNumber>(curves_, features)) {
    found.push_back(tight(place));
    // A zero radius has to be known as zero.
    if (sign(place.squared_radius) <= 0) found.back().squared_radius = Interval(0);
  }
  return found;
}

std::optional<DiagramEvent> EventProver::event(const Features& features, unsigned branch,
                                               const Equidistant<Interval>& place) {
  exact_.reset();
  straight_here_.clear();
  met_inside_.clear();
  edge_of_line_.clear();
  DiagramEvent event{Kind::corner, {}, {}, place.at, place.squared_radius, features, branch};
  if (event.squared_radius.upper() <= 0) return std::nullopt;
  const double reach = plane::above(std::sqrt(event.squared_radius.upper()));
  std::set<std::uint32_t> found;
  bool is_empty = true;
  lookup_.tree().query(grown(box_of(event.at), reach), [&](std::uint32_t number) {
    is_empty &= add(number, event, found);
    return !is_empty;
  });
  if (!is_empty) return std::nullopt;
  for (const std::uint32_t vertex : straight_here_) found.erase(vertex);
  // A vertex on an edge met right there does not count either.
  std::erase_if(found, [&](std::uint32_t vertex) {
    const Site own = Site::of(curves_, vertex);
    return own.is_point && std::any_of(met_inside_.begin(), met_inside_.end(), [&](auto number) {
             const OffsetEdge& other = curves_.edges[number];
             return dot(other.normal, from_to(other.start, own.point)) == 0;
           });
  });
  std::erase_if(event.joints, [&](const auto& joint) { return !found.contains(joint.second); });
  for (const std::uint32_t feature : features) {
    if (!found.contains(feature)) return std::nullopt;
  }
  event.features.assign(found.begin(), found.end());
  for (const std::uint32_t feature : event.features) {
    const auto edge = edge_of_line_.find(feature);
    event.edges.push_back(edge == edge_of_line_.end() ? OffsetPatch::none : edge->second);
  }
  std::sort(event.joints.begin(), event.joints.end());
  event.joints.erase(std::unique(event.joints.begin(), event.joints.end()), event.joints.end());
  if (!is_outside(event)) return std::nullopt;
  event.kind = kind_of(event);
  return event;
}

/// A place that three or more features tell is among the places that any three of them tell.
bool EventProver::are_one(const DiagramEvent& a, const DiagramEvent& b) const {
  if (are_apart(a.at, b.at)) return false;
  if (a.of == b.of && a.branch == b.branch) return true;
  const bool has_three = b.of.size() == 3;
  const DiagramEvent &one = has_three ? a : b, &other = has_three ? b : a;
  if (other.of.size() == 3) {
    const auto found = places(other.of);
    bool are_far = true;
    for (unsigned k = 0; k < found.size(); ++k) {
      are_far &= k == other.branch || are_apart(one.at, found[k].at);
    }
    if (are_far) return true;
  }
  return are_same(equidistant_places<RootNumber>(curves_, a.of)[a.branch].at,
                  equidistant_places<RootNumber>(curves_, b.of)[b.branch].at);
}

const Equidistant<RootNumber>& EventProver::exact(const DiagramEvent& event) {
  if (!exact_) exact_ = equidistant_places<RootNumber>(curves_, event.of).at(event.branch);
  return *exact_;
}

template <class InIntervals, class Exact>
int EventProver::sign_of(DiagramEvent& event, InIntervals&& in_intervals, Exact&& by_roots) {
  if (const auto certain = certified_sign(in_intervals())) return *certain;
  if (!exact_) {
    const Equidistant<Interval> sharper = tight(exact(event));
    event.at = sharper.at;
    event.squared_radius = sharper.squared_radius;
    if (const auto certain = certified_sign(in_intervals())) return *certain;
  }
  ++exact_signs;
  return sign(by_roots());
}

/// Whether no point of an edge is nearer than the event's features. Adds the edge's equally near
/// features.
bool EventProver::add(std::uint32_t number, DiagramEvent& event, std::set<std::uint32_t>& found) {
  const OffsetEdge& edge = curves_.edges[number];
  const auto is_of = [&](std::uint32_t feature) {
    return std::find(event.of.begin(), event.of.end(), feature) != event.of.end();
  };
  // A line and an end of the line single out the place in front of the end.
  const auto foot_from = [&](const Point& from, std::uint32_t feature) {
    if (event.of.size() == 3 && is_of(edge.feature) && is_of(feature)) return 0;
    return sign_of(
        event, [&] { return dot(lookup_.edge(number).along, event.at - numbers<Interval>(from)); },
        [&] {
          return dot(numbers<RootNumber>(edge.along), exact(event).at - numbers<RootNumber>(from));
        });
  };
  const int after_start = foot_from(edge.start, edge.start_feature);
  const int after_end = after_start < 0 ? -1 : foot_from(edge.end, edge.end_feature);
  int order = 0;
  if (after_start > 0 && after_end < 0) {
    if (!is_of(edge.feature)) order = height_order(number, event);
    if (order == 0) {
      found.insert(edge.feature);
      met_inside_.push_back(number);
      edge_of_line_[edge.feature] = number;
    }
  } else {
    const bool at_start = after_start <= 0;
    const std::uint32_t feature = at_start ? edge.start_feature : edge.end_feature;
    if (!is_of(feature)) order = distance_order(at_start ? edge.start : edge.end, event);
    if (order == 0) found.insert(feature);
    if (order == 0 && (after_start == 0 || after_end == 0) && is_in_front(number, event)) {
      found.insert(edge.feature);
      if (after_end == 0) edge_of_line_[edge.feature] = number;
      edge_of_line_.try_emplace(edge.feature, number);
      if (lookup_.is_within(edge.feature, feature)) {
        straight_here_.insert(feature);
      } else {
        event.joints.emplace_back(edge.feature, feature);
      }
    }
  }
  return order >= 0;
}

int EventProver::distance_order(const Point& from, DiagramEvent& event) {
  return sign_of(
      event,
      [&] {
        const auto w = event.at - numbers<Interval>(from);
        return dot(w, w) - event.squared_radius;
      },
      [&] {
        const RootPoint w = exact(event).at - numbers<RootNumber>(from);
        return dot(w, w) - exact(event).squared_radius;
      });
}

int EventProver::height_order(std::uint32_t number, DiagramEvent& event) {
  const OffsetEdge& edge = curves_.edges[number];
  return sign_of(
      event,
      [&] {
        const EdgeNumbers<Interval>& own = lookup_.edge(number);
        const Interval height = dot(own.normal, event.at - own.start);
        return height * height - event.squared_radius * own.squared_length;
      },
      [&] {
        const RootNumber height = dot(numbers<RootNumber>(edge.normal),
                                      exact(event).at - numbers<RootNumber>(edge.start));
        return height * height - exact(event).squared_radius * RootNumber(edge.squared_length);
      });
}

/// Not behind the line of an edge.
bool EventProver::is_in_front(std::uint32_t number, DiagramEvent& event) {
  const OffsetEdge& edge = curves_.edges[number];
  return sign_of(
             event,
             [&] {
               const EdgeNumbers<Interval>& own = lookup_.edge(number);
               return dot(own.normal, event.at - own.start);
             },
             [&] {
               return dot(numbers<RootNumber>(edge.normal),
                          exact(event).at - numbers<RootNumber>(edge.start));
             }) > 0;
}

/// Whether no boundary point lies between the place and a feature. The nearest vertex to a point
/// outside P has an arc, and then this vertex is nearest to no point inside.
bool EventProver::is_outside(DiagramEvent& event) {
  for (const std::uint32_t number : met_inside_) return is_in_front(number, event);
  return std::all_of(event.features.begin(), event.features.end(), [&](std::uint32_t feature) {
    return curves_.features[feature].edge != OffsetPatch::none || curves_.features[feature].has_arc;
  });
}

/// Judges by the features' directions; in front of an edge's end, the edge's line shares the end's
/// direction.
DiagramEvent::Kind EventProver::kind_of(DiagramEvent& event) {
  Features ways;
  std::copy_if(event.features.begin(), event.features.end(), std::back_inserter(ways),
               [&](std::uint32_t feature) {
                 return std::none_of(event.joints.begin(), event.joints.end(),
                                     [&](const auto& joint) { return joint.second == feature; });
               });
  bool is_inside = true, has_opposite = false;
  for (const std::uint32_t a : ways) {
    bool has_left = false, has_right = false;
    for (const std::uint32_t b : ways) {
      if (a == b) continue;
      const int turn =
          event.of.size() == 2 && event.features.size() == 2
              ? 0
              : sign_of(
                    event,
                    [&] { return cross(way<Interval>(a, event.at), way<Interval>(b, event.at)); },
                    [&] {
                      return cross(way<RootNumber>(a, exact(event).at),
                                   way<RootNumber>(b, exact(event).at));
                    });
      has_left |= turn > 0;
      has_right |= turn < 0;
      has_opposite |= turn == 0;
    }
    is_inside &= has_left && has_right;
  }
  if (is_inside && ways.size() > 2) return Kind::maximum;
  // Opposite lines are as near all along.
  const bool has_point = std::any_of(ways.begin(), ways.end(), [&](std::uint32_t feature) {
    return Site::of(curves_, feature).is_point;
  });
  if (has_opposite) return ways.size() == 2 && has_point ? Kind::saddle : Kind::ridge;
  return !event.joints.empty() && event.features.size() == 3 ? Kind::joint : Kind::corner;
}

template <class N>
Vector<N> EventProver::way(std::uint32_t feature, const Vector<N>& from) const {
  const Site own = Site::of(curves_, feature);
  if (own.is_point) return numbers<N>(own.point) - from;
  return N(-1) * numbers<N>(own.normal);
}

}  // namespace minkref::inline disc
