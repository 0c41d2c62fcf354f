#include "reference/motion/fits_and_traps.hpp"

#include <algorithm>
#include <map>

#include "reference/error.hpp"
#include "reference/motion/container_frame.hpp"
#include "reference/motion/free_space.hpp"
#include "reference/motion/routes.hpp"
#include "reference/motion/star_centre.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/critical/event_places.hpp"
#include "reference/plane/dynamic/node_track.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "reference/plane/moving/interior_test.hpp"
#include "reference/plane/passages/wedge_walks.hpp"
#include "reference/plane/witness.hpp"

namespace minkref::inline motion {
namespace {

const char* word(TopologyEvent::Change change) {
  switch (change) {
    case TopologyEvent::Change::birth:
      return "birth";
    case TopologyEvent::Change::death:
      return "death";
    case TopologyEvent::Change::merge:
      return "merge";
    case TopologyEvent::Change::split:
      return "split";
    case TopologyEvent::Change::touch:
      return "touch";
  }
  return "";
}

/// A question about the free places at one scale, asked at all.
class FreePlaces {
 public:
  using Question = std::function<bool(const FreeSpace&)>;

  FreePlaces(const PolygonSet& part, const PolygonSet& obstacles, std::vector<Point> places,
             ContactRule rule, const ScaleWindow& window)
      : part_(part),
        obstacles_(obstacles),
        places_(std::move(places)),
        rule_(rule),
        window_(window),
        turned_(half_turned(part)),
        index_(turned_, obstacles, window) {
    const TopologyTimeline timeline = index_.timeline();
    for (const TopologyEvent& event : timeline.topology) {
      if (event.kind != FeatureKind::hole) continue;
      add({index_.event(event.group), true, word(event.change), event.place, {}});
    }
    for (const Point& x : places_) {
      ValidScales found = valid_scales(part, obstacles, {x}, rule, window);
      free_.push_back(std::move(found.valid));
      for (PathBound& bound : found.bounds) {
        FreeBound cause{bound.scale, true, "contact", bound.touching, std::move(bound)};
        causes_.insert_or_assign(cause.scale, cause);
      }
    }
    if (rule == ContactRule::allowed) add_free_vertices();
  }

  FreeScales answer(const Question& question) const {
    std::vector<Rational> critical;
    for (const auto& [scale, cause] : causes_) critical.push_back(scale);
    FreeScales result;
    const ScaleSet found = decided_at(critical, window_, [&](const Rational& scale) {
      ++result.critical_scales;
      if (const auto known = without_boundary(scale)) return *known;
      return question(free_space(index_.sum(scale, passages())));
    });
    result.scales = found.ranges();
    add_bounds(found, question, result);
    return result;
  }

 private:
  Passages passages() const {
    return rule_ == ContactRule::allowed ? Passages::find : Passages::leave;
  }
  /// The answer, if the list of events or a place without freedom tells it: every place asked for
  /// has to be free; without places, a hole of the sum is enough.
  std::optional<bool> without_boundary(const Rational& scale) const {
    for (const std::vector<ScaleRange>& free : free_) {
      if (std::none_of(free.begin(), free.end(),
                       [&](const ScaleRange& range) { return range.holds(scale); })) {
        return false;
      }
    }
    if (!places_.empty()) return std::nullopt;
    if (index_.features(scale).holes > 0) return true;
    if (rule_ == ContactRule::forbidden) return false;
    return std::nullopt;
  }
  FreeSpace free_space(const Sum& sum) const { return {sum, rule_, places_}; }
  void add(FreeBound cause) { causes_.try_emplace(cause.scale, cause); }

  /// Adds the corners of the free places over space and scale: free places where contacts meet.
  /// Places free only at one scale, or only along tight passages, show at these corners alone.
  void add_free_vertices() {
    for (const PolygonSet* set : {&part_, &obstacles_}) {
      if (wedge_walks(*set)) {
        throw BadInput("touching-rings",
                       "rings touch, and then a part may pass with contact where no scale of the "
                       "list of events shows it",
                       "forbid contact, or part the rings by a little");
      }
    }
    const ArrangementEvents events(turned_, obstacles_, opened(window_));
    const InteriorTest inside(turned_, obstacles_);
    const auto offer = [&](const Rational& scale, const Point& at) {
      if (causes_.contains(scale) || inside.inside(at, scale)) return;
      add({scale, true, "touch", at, {}});
    };
    const std::size_t pairs = events.pairs().events.size();
    constexpr std::size_t some = 1024;
    for (std::size_t first = 0; first < pairs; first += some) {
      for (const EventPlace& place :
           event_places(events.pairs(), first, std::min(first + some, pairs), events.moving())) {
        offer(place.scale, place.at);
        if (place.to) offer(place.scale, *place.to);
      }
    }
    for (const TripleEvent& triple : events.triples()) {
      const Rational scale = triple_scale(triple, events.moving(), events.table());
      offer(scale, node_track(events, triple.edge, triple.first).at(scale));
    }
  }

  /// Adds the causes at the ends, and static sums there and on either side.
  void add_bounds(const ScaleSet& found, const Question& question, FreeScales& result) const {
    const auto prove = [&](const Rational& scale) {
      const Sum sum =
          minkowski_sum(turned_, obstacles_, scale, Route::paper, "rational", passages());
      const bool holds = question(free_space(sum));
      if (holds != found.holds(scale)) {
        throw std::logic_error("the static sum at " + to_string(scale) + " gives another answer");
      }
      result.proofs.push_back({scale, holds});
    };
    const ScaleRange all = range_of(window_);
    Rational proven = 0;  // the last bound
    const auto add_bound = [&](const ScaleCut& cut, bool ends) {
      const auto cause = causes_.find(cut.scale);
      if (cause == causes_.end()) throw std::logic_error("a scale without a cause");
      FreeBound bound = cause->second;
      bound.ends = ends;
      result.bounds.push_back(std::move(bound));
      if (proven == cut.scale) return;  // a single scale
      proven = cut.scale;
      const Rational before =
          cause == causes_.begin() ? window_.from.value_or(Rational(0)) : std::prev(cause)->first;
      const Rational hair = cut.scale / (1 << 20);
      const Rational room = (cut.scale - before) / 2;
      if (room > 0) prove(cut.scale - std::min(hair, room));
      prove(cut.scale);
      const auto next = std::next(cause);
      Rational above = cut.scale + hair;
      if (next != causes_.end()) above = std::min(above, Rational((cut.scale + next->first) / 2));
      if (!window_.to || above <= *window_.to) prove(above);
    };
    for (const ScaleRange& range : found.ranges()) {
      if (range.from != all.from) add_bound(range.from, false);
      if (range.to != all.to) add_bound(*range.to, true);
    }
  }

  const PolygonSet &part_, &obstacles_;
  std::vector<Point> places_;
  ContactRule rule_;
  ScaleWindow window_;
  PolygonSet turned_;
  ScaleIndex index_;
  std::vector<std::vector<ScaleRange>> free_;  ///< scales at which each place is free
  std::map<Rational, FreeBound> causes_;       ///< by their scales, all critical ones
};

using Question = FreePlaces::Question;

/// The problem as it was asked, with answers of static sums at single scales.
struct FreeProblem {
  const PolygonSet &part, &obstacles;
  std::vector<Point> places;
  ContactRule rule;
  PolygonSet turned;

  FreeProblem(const PolygonSet& part_, const PolygonSet& obstacles_, std::vector<Point> places_,
              ContactRule rule_)
      : part(part_),
        obstacles(obstacles_),
        places(std::move(places_)),
        rule(rule_),
        turned(half_turned(part_)) {}

  bool holds(const Question& question, const Rational& scale) const {
    const Passages passages = rule == ContactRule::allowed ? Passages::find : Passages::leave;
    const Sum sum = minkowski_sum(turned, obstacles, scale, Route::paper, "rational", passages);
    return question(FreeSpace(sum, rule, places));
  }
  FreeScales answer(const Question& question, const ScaleWindow& window) const {
    return FreePlaces(part, obstacles, places, rule, window).answer(question);
  }
};

/// Two close scales: a question holds up to the first and no longer from the second on. None if the
/// question fails at a small scale, or holds at `to`. For a question that holds up to some scale
/// and never above.
std::optional<std::pair<Rational, Rational>> bracket(
    const std::function<bool(const Rational&)>& holds, const std::optional<Rational>& from,
    const Rational& to) {
  constexpr int most_halvings = 24, steps = 10;
  if (holds(to)) return std::nullopt;
  Rational low = to, high = to;
  for (int k = 0; low == high; ++k) {
    const Rational next = low / 2;
    if (k == most_halvings || (from && next <= *from)) {
      if (!from || !holds(*from)) return std::nullopt;
      low = *from;
    } else if (holds(next)) {
      low = next;
    } else {
      low = high = next;
    }
  }
  for (int k = 0; k < steps; ++k) {
    Rational middle = (low + high) / 2;
    (holds(middle) ? low : high) = std::move(middle);
  }
  // The scale sought may be an end of the searched window only if the whole window ends there.
  const Rational wider = (high - low) / 3;
  const Rational least = low - wider, most = high + wider;
  return std::pair{from ? std::max(least, *from) : least, std::min(most, to)};
}

/// Rooms of the obstacles: the parts of their complement. A part that holds its origin never leaves
/// the origin's room, however small, other than through a point at which rings touch.
class Rooms {
 public:
  explicit Rooms(const FreeProblem& problem)
      : space_(of(problem.obstacles), ContactRule::forbidden, problem.places),
        are_apart_(problem.rule == ContactRule::forbidden ||
                   !(wedge_walks(problem.part) || wedge_walks(problem.obstacles))) {}

  bool encloses(const Point& at) const {
    const auto room = space_.part_of(at);
    return are_apart_ && room && *room != 0;
  }
  bool parts(const Point& a, const Point& b) const {
    const auto first = space_.part_of(a), second = space_.part_of(b);
    return are_apart_ && first && second && *first != *second;
  }

 private:
  static Sum of(const PolygonSet& obstacles) {
    Sum sum;
    if (obstacles.is_region()) sum.region = canonicalize(obstacles).region;
    return sum;
  }
  FreeSpace space_;
  bool are_apart_;
};

/// Adds the contact at a place's greatest free scale, where a trap ends, after the other bounds.
void add_last_contact(const FreeProblem& problem, const Question& trapped,
                      const ScaleWindow& window, const PathBound& last, const Rational& before,
                      FreeScales& result) {
  result.bounds.push_back({last.scale, true, "contact", last.touching, last});
  Rational hair = last.scale / (1 << 20);
  if (before < last.scale) hair = std::min(hair, Rational((last.scale - before) / 2));
  for (const Rational& one :
       {Rational(last.scale - hair), last.scale, Rational(last.scale + hair)}) {
    if ((window.from && one < *window.from) || (window.to && one > *window.to)) continue;
    const bool holds = problem.holds(trapped, one);
    if (holds != result.scales.back().holds(one)) {
      throw std::logic_error("the static sum at " + to_string(one) + " gives another answer");
    }
    result.proofs.push_back({one, holds});
  }
}

/// For a question that holds up to some scale and no more above it: down to 0.
FreeScales up_to_a_scale(const FreeProblem& problem, const Question& question,
                         const ScaleWindow& window) {
  const auto found = bracket([&](const Rational& s) { return problem.holds(question, s); },
                             std::nullopt, *window.to);
  if (!found) return problem.answer(question, window);
  FreeScales result = problem.answer(question, {found->first, found->second});
  if (result.scales.size() != 1 || result.scales[0].from != ScaleCut{found->first, false}) {
    throw std::logic_error("a smaller part has less room");
  }
  result.scales[0].from = {0, true};
  return result;
}

/// The scales of a trap, for a part that is star-shaped about its origin: at a place, it is free up
/// to some scale, and gets away up to another; between the two it is trapped. None if no bracket is
/// found.
std::optional<FreeScales> narrowed_trap(const FreeProblem& problem, const Question& trapped,
                                        const ScaleWindow& window) {
  const Point& at = problem.places[0];
  const ValidScales free =
      valid_scales(problem.part, problem.obstacles, {at}, problem.rule, window);
  if (free.valid.empty()) return FreeScales{};
  if (Rooms(problem).encloses(at)) {
    FreeScales result;
    result.scales = free.valid;
    if (!free.bounds.empty()) {
      const Rational from = window.from ? *window.from : Rational(0);
      add_last_contact(problem, trapped, window, free.bounds[0], from, result);
    }
    return result;
  }
  if (free.bounds.empty() && !window.to) return std::nullopt;
  const Rational to = window.to ? *window.to : Rational(2 * free.bounds[0].scale);
  const auto escapes = [&](const FreeSpace& space) {
    const auto place = space.part_of(at);
    return place && *place == 0;
  };
  const auto found =
      bracket([&](const Rational& s) { return problem.holds(escapes, s); }, window.from, to);
  if (!found) return std::nullopt;
  FreeScales result = problem.answer(trapped, {found->first, found->second});
  const ScaleCut end{found->second, true};
  if (result.scales.empty() || result.scales.back().to != end) return result;
  result.scales.back().to = free.valid[0].to;
  if (free.bounds.empty()) return result;
  const PathBound& last = free.bounds[0];
  const Rational before = result.bounds.empty() ? found->first : result.bounds.back().scale;
  add_last_contact(problem, trapped, window, last, before, result);
  return result;
}

}  // namespace

FreeScales trapped_scales(const PolygonSet& part, const PolygonSet& obstacles, const Point& at,
                          ContactRule rule, const ScaleWindow& window, FitSearch search) {
  const FloatEnvironment standard;
  refuse_bad_window(window);
  if (part.empty() || obstacles.empty()) return {};
  refuse_bad_operands(part, obstacles, 1);
  const FreeProblem problem(part, obstacles, {at}, rule);
  const auto trapped = [&](const FreeSpace& free) {
    const auto place = free.part_of(at);
    return place && *place != 0;
  };
  if (search == FitSearch::narrowed && star_shaped(part)) {
    if (auto found = narrowed_trap(problem, trapped, window)) return *std::move(found);
  }
  return problem.answer(trapped, window);
}

FreeScales scales_that_fit_at(const PolygonSet& part, const PolygonSet& container, const Point& at,
                              ContactRule rule) {
  const FloatEnvironment standard;
  const ContainerFrame frame(part, container, {at});
  const PolygonSet turned = half_turned(part);
  ValidScales found = valid_scales(part, frame.set(), {at}, rule, frame.window);
  FreeScales result;
  const auto prove = [&](const Rational& scale) {
    const Contact contact = Membership(turned, frame.set(), scale).contact(at);
    const bool holds =
        rule == ContactRule::allowed ? contact != Contact::overlapping : contact == Contact::empty;
    if (holds != std::any_of(found.valid.begin(), found.valid.end(),
                             [&](const ScaleRange& range) { return range.holds(scale); })) {
      throw std::logic_error("the place at " + to_string(scale) + " gives another answer");
    }
    result.proofs.push_back({scale, holds});
  };
  for (std::size_t k = 0; k < found.bounds.size(); ++k) {
    PathBound& bound = found.bounds[k];
    const Rational scale = bound.scale;
    bound.obstacle = frame.in_container(bound.obstacle);
    result.bounds.push_back({scale, bound.blocks, "contact", bound.touching, bound});
    if (k > 0 && found.bounds[k - 1].scale == scale) continue;  // a single scale
    const auto next = std::find_if(found.bounds.begin(), found.bounds.end(),
                                   [&](const PathBound& other) { return other.scale > scale; });
    Rational hair = scale / (1 << 20);
    if (k > 0) hair = std::min(hair, Rational((scale - found.bounds[k - 1].scale) / 2));
    if (next != found.bounds.end()) hair = std::min(hair, Rational((next->scale - scale) / 2));
    for (const Rational& one : {Rational(scale - hair), scale, Rational(scale + hair)}) prove(one);
  }
  result.scales = std::move(found.valid);
  return result;
}

FreeScales scales_that_fit(const PolygonSet& part, const PolygonSet& container, ContactRule rule,
                           FitSearch search) {
  const FloatEnvironment standard;
  const ContainerFrame frame(part, container, {});
  const FreeProblem problem(part, frame.set(), {}, rule);
  const auto fits = [](const FreeSpace& free) { return free.parts() > 1; };
  return search == FitSearch::narrowed && star_centre(part).has_value()
             ? up_to_a_scale(problem, fits, frame.window)
             : problem.answer(fits, frame.window);
}

FreeScales scales_that_pass(const PolygonSet& part, const PolygonSet& container, const Point& from,
                            const Point& to, ContactRule rule, FitSearch search) {
  const FloatEnvironment standard;
  const ContainerFrame frame(part, container, {from, to});
  const FreeProblem problem(part, frame.set(), {from, to}, rule);
  const auto passes = [&](const FreeSpace& free) {
    const auto a = free.part_of(from), b = free.part_of(to);
    return a && b && *a == *b;
  };
  const bool narrowed = search == FitSearch::narrowed && star_shaped(part);
  if (narrowed) {
    for (const Point& place : {from, to}) {
      if (valid_scales(part, frame.set(), {place}, rule, frame.window).valid.empty()) return {};
    }
    if (Rooms(problem).parts(from, to)) return {};
  }
  FreeScales result = narrowed ? up_to_a_scale(problem, passes, frame.window)
                               : problem.answer(passes, frame.window);
  for (FreeBound& bound : result.bounds) {
    if (bound.contact) bound.contact->obstacle = frame.in_container(bound.contact->obstacle);
  }
  return result;
}

}  // namespace minkref::inline motion
