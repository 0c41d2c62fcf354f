#include "reference/disc/pairs/feature_pair.hpp"

#include <algorithm>

namespace minkref::inline disc {
namespace {

constexpr std::array<ContactSlot, 5> all_contact_slots{ContactSlot::a_first, ContactSlot::a_last,
                                                       ContactSlot::b_first, ContactSlot::b_last,
                                                       ContactSlot::tangent};

template <class N>
struct AskedIn {};  // the numbers that a sign is asked in

/// The feature with an end, and the end's number.
std::size_t owner_of(ContactSlot slot) { return slot < ContactSlot::b_first ? 0 : 1; }
std::size_t own_end_of(ContactSlot slot) { return static_cast<std::size_t>(slot) % 2; }

}  // namespace

std::string_view name(PairChange change) {
  constexpr std::array<std::string_view, 6> names{"birth", "death",   "touch",
                                                  "swap",  "overlap", "none"};
  return names[static_cast<std::size_t>(change)];
}

int compare_squares(const RootNumber& a, const RootNumber& b) {
  if (a.field()->roots() + b.field()->roots() > 0) return compare(a, b);
  return a.coefficients()[0].compare(b.coefficients()[0]);
}

bool FeatureEvent::meets() const {
  return std::any_of(contacts.begin(), contacts.end(), [](const auto& c) { return c.meets; });
}

std::string_view FeaturePair::name(ContactSlot slot, bool a_is_arc, bool b_is_arc) {
  if (slot == ContactSlot::tangent) return a_is_arc && b_is_arc ? "circles" : "circle on line";
  const bool on_arc = owner_of(slot) == 0 ? b_is_arc : a_is_arc;
  return on_arc ? "end on circle" : "end on line";
}

template <class N>
Contact<N> FeaturePair::solved(ContactSlot slot, bool staying) const {
  const FeatureNumbers<N>&a = of<N>(0), &b = of<N>(1);
  if (slot == ContactSlot::tangent) {
    if (a.is_arc && b.is_arc) return circles(a, b);
    return a.is_arc ? circle_on_line(a, b) : circle_on_line(b, a);
  }
  const bool of_a = owner_of(slot) == 0;
  const FeatureNumbers<N>&own = of_a ? a : b, &other = of_a ? b : a;
  if (other.is_arc) return end_on_circle(own, own_end_of(slot), other);
  return staying ? end_on_staying_line(own, own_end_of(slot), other)
                 : end_on_line(own, own_end_of(slot), other);
}

RootNumber FeaturePair::squared_radius(const PairContact& contact) const {
  return solved<RootNumber>(contact.slot, contact.staying).squared_radius();
}

/// The sign of a number, found by intervals, or by roots if intervals leave the sign open.
template <class Value>
int FeaturePair::sign_of(Value&& value) {
  if (const auto certain = certified_sign(value(AskedIn<Interval>{}))) return *certain;
  ++exact_signs;
  return sign(value(AskedIn<RootNumber>{}));
}

void FeaturePair::find_kind() {
  if (is_arc(0) || is_arc(1)) {
    kind_ = is_arc(0) && is_arc(1) ? Kind::arcs : Kind::arc_and_edge;
    return;
  }
  turn_ = sign_of([&]<class N>(AskedIn<N>) { return cross(of<N>(0).along, of<N>(1).along); });
  kind_ = turn_ == 0 ? Kind::parallel_edges : Kind::edges;
}

/// Decides by one interval product: an end behind a line never reaches the line, and an end that
/// moves away from a centre never reaches the circle.
bool FeaturePair::certainly_never(ContactSlot slot) const {
  const FeatureNumbers<Interval>&a = *near_[0], &b = *near_[1];
  if (slot == ContactSlot::tangent) return false;
  const bool of_a = owner_of(slot) == 0;
  const FeatureNumbers<Interval>&own = of_a ? a : b, &other = of_a ? b : a;
  const Vector<Interval> way = own.at[own_end_of(slot)] - other.at[0];
  return other.is_arc ? dot(own.way[own_end_of(slot)], way).lower() >= 0
                      : dot(other.way[0], way).upper() <= 0;
}

/// Empty if the condition holds at no radius, or at every radius.
std::optional<PairContact> FeaturePair::contact(ContactSlot slot, bool staying) {
  if (certainly_never(slot)) return std::nullopt;
  PairContact found{slot, staying, true, 0, {}};
  if (sign_of([&]<class N>(AskedIn<N>) { return solved<N>(found).top; }) <= 0 ||
      sign_of([&]<class N>(AskedIn<N>) { return solved<N>(found).under; }) <= 0) {
    return std::nullopt;
  }
  found.squared_radius = solved<Interval>(found).squared_radius();
  return found;
}

/// The sign of a place's distance beyond the start of an offset edge, along the edge.
int FeaturePair::side_of_start(const PairContact& contact, std::size_t edge) {
  return sign_of([&]<class N>(AskedIn<N>) {
    const FeatureNumbers<N>& own = of<N>(edge);
    return dot(own.along, solved<N>(contact).from(own.at[0]));
  });
}
int FeaturePair::side_of_end(const PairContact& contact, std::size_t edge) {
  return sign_of([&]<class N>(AskedIn<N>) {
    const FeatureNumbers<N>& own = of<N>(edge);
    return dot(own.along, solved<N>(contact).from(own.at[1]));
  });
}

/// Whether a place on the line or circle of a feature is on the feature.
bool FeaturePair::is_on(const PairContact& contact, std::size_t which) {
  if (!is_arc(which)) return side_of_start(contact, which) >= 0 && side_of_end(contact, which) <= 0;
  const auto turn_from = [&](std::size_t end) {
    return sign_of([&]<class N>(AskedIn<N>) {
      const FeatureNumbers<N>& own = of<N>(which);
      return cross(own.way[end], solved<N>(contact).from(own.at[0]));
    });
  };
  return turn_from(0) >= 0 && turn_from(1) <= 0;
}

/// Finds the side: along the edge from the centre's foot, or on the left from one centre to the
/// other. Nonparallel edges have a single branch.
void FeaturePair::find_branch(PairContact& contact) {
  if (kind_ == Kind::edges) {
    contact.branch = 1;
  } else if (kind_ != Kind::parallel_edges && contact.slot != ContactSlot::tangent) {
    const bool are_arcs = kind_ == Kind::arcs;
    const std::size_t arc = is_arc(0) ? 0 : 1;
    contact.branch = static_cast<std::int8_t>(sign_of([&]<class N>(AskedIn<N>) {
      const Vector<N> y = solved<N>(contact).from(of<N>(arc).at[0]);
      return are_arcs ? cross(of<N>(1).at[0] - of<N>(0).at[0], y) : dot(of<N>(1 - arc).along, y);
    }));
  }
}

/// Whether a branch, as the radius grows, comes from beyond an end of a feature to its other side.
/// On an edge the branch goes away from the foot. About two circles' centres the branch turns away
/// from the way between the centres; about an arc's centre, if the arc meets an edge, away from the
/// way to the edge.
bool FeaturePair::enters(const PairContact& contact, int branch) const {
  const bool is_first = own_end_of(contact.slot) == 0, of_a = owner_of(contact.slot) == 0;
  int way = branch;
  if (kind_ == Kind::edges) way = of_a ? turn_ : -turn_;
  if (kind_ == Kind::arc_and_edge) way = is_arc(of_a ? 0 : 1) ? -branch : branch;
  if (kind_ == Kind::arcs) way = of_a ? branch : -branch;
  return is_first == (way > 0);
}

int FeaturePair::order(const PairContact& a, const PairContact& b) const {
  if (a.squared_radius.upper() < b.squared_radius.lower()) return -1;
  if (a.squared_radius.lower() > b.squared_radius.upper()) return 1;
  if (a.squared_radius.is_point() && b.squared_radius.is_point()) return 0;
  return compare_squares(squared_radius(a), squared_radius(b));
}

std::vector<FeatureEvent> FeaturePair::by_radius(std::vector<PairContact> contacts) const {
  std::stable_sort(contacts.begin(), contacts.end(),
                   [&](const auto& a, const auto& b) { return order(a, b) < 0; });
  std::vector<FeatureEvent> events;
  for (const PairContact& each : contacts) {
    if (events.empty() || order(events.back().contacts[0], each) != 0) events.emplace_back();
    events.back().contacts.push_back(each);
  }
  return events;
}

std::vector<FeatureEvent> FeaturePair::events() {
  find_kind();
  if (kind_ == Kind::arc_and_edge) {  // behind the line it is never met, and on it always
    const std::size_t arc = is_arc(0) ? 0 : 1;
    const FeatureNumbers<Interval>& edge = *near_[1 - arc];
    if (dot(edge.way[0], near_[arc]->at[0] - edge.at[0]).upper() <= 0) return {};
  }
  std::vector<PairContact> found;
  for (const ContactSlot slot : all_contact_slots) {
    const bool is_tangent = slot == ContactSlot::tangent;
    if (is_tangent && (kind_ == Kind::edges || kind_ == Kind::parallel_edges)) continue;
    auto each = contact(slot, false);
    if (!each || !is_on(*each, is_tangent ? 0 : 1 - owner_of(slot))) continue;
    if (is_tangent && !is_on(*each, 1)) continue;
    find_branch(*each);
    found.push_back(*each);
  }
  events_ = by_radius(std::move(found));
  follow_branches();
  for (std::size_t k = 0; k < events_.size(); ++k) count_points(events_[k], k, true);
  return events_;
}

void FeaturePair::follow_branches() {
  if (kind_ == Kind::parallel_edges) return;
  for (std::size_t number = 0; number < events_.size(); ++number) {
    for (std::size_t k = 0; k < (kind_ == Kind::edges ? 1U : 2U); ++k) {
      const int branch = k == 0 ? 1 : -1;
      bool is_here = false, before = true, after = true;
      for (const PairContact& each : events_[number].contacts) {
        if (each.branch == -branch) continue;
        is_here = true;
        const bool is_tangent = each.slot == ContactSlot::tangent;
        const bool comes = is_tangent || enters(each, branch);
        before &= !comes;
        after &= comes;
      }
      if (is_here) branches_[k].push_back({number, before, after});
    }
  }
}

bool FeaturePair::is_there(std::size_t branch, std::size_t after_events) const {
  const std::vector<Turn>& turns = branches_[branch];
  const auto next = std::find_if(turns.begin(), turns.end(),
                                 [&](const Turn& turn) { return turn.event >= after_events; });
  if (next != turns.begin()) return std::prev(next)->after;
  return next != turns.end() && next->before;
}

/// The number of contact places for parallel edges: 1, or FeatureEvent::segment.
std::uint8_t FeaturePair::distinct_places(const FeatureEvent& event) const {
  const auto along = [&](const PairContact& each) {
    const std::size_t of = owner_of(each.slot);
    return dot(from_to({}, features_[of]->at[own_end_of(each.slot)]),
               from_to(features_[0]->at[0], features_[0]->at[1]));
  };
  const Rational first = along(event.contacts[0]);
  const bool is_one = std::all_of(event.contacts.begin(), event.contacts.end(),
                                  [&](const auto& each) { return along(each) == first; });
  return is_one ? 1 : FeatureEvent::segment;
}

/// Counts points at a true event's radius, or right before.
void FeaturePair::count_points(FeatureEvent& event, std::size_t number, bool is_true) const {
  const auto count = [&](std::size_t after_events) {
    return static_cast<std::uint8_t>((is_there(0, after_events) ? 1 : 0) +
                                     (is_there(1, after_events) ? 1 : 0));
  };
  event.before = event.at = event.after = count(number);
  event.change = PairChange::none;
  if (!is_true) return;
  const FeatureEvent& own = events_[number];
  if (kind_ == Kind::parallel_edges) {
    event.at = distinct_places(own);
    event.change = event.at == 1 ? PairChange::touch : PairChange::overlap;
    return;
  }
  event.after = count(number + 1);
  event.at = 0;
  bool is_touch = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto here = std::find_if(branches_[k].begin(), branches_[k].end(),
                                   [&](const Turn& turn) { return turn.event == number; });
    const bool is_here = here != branches_[k].end();
    event.at += is_here || is_there(k, number) ? 1 : 0;
    is_touch &= !is_here || here->before == here->after;
  }
  const bool is_foot = std::any_of(own.contacts.begin(), own.contacts.end(),
                                   [](const auto& each) { return each.branch == 0; });
  if (is_foot) event.at = 1;
  if (event.after != event.before) {
    event.change = event.after > event.before ? PairChange::birth : PairChange::death;
  } else {
    event.change = is_touch ? PairChange::touch : PairChange::swap;
  }
}

/// Whether the Appendix, as read, has a contact; sets whether the contact exists in truth.
bool FeaturePair::is_printed(PairContact& each, const DiscReadings& readings,
                             bool has_unit_radius) {
  if (each.slot == ContactSlot::tangent) return is_on(each, 0) && is_on(each, 1);
  const std::size_t own = owner_of(each.slot), other = 1 - own;
  if (each.staying) {
    // Along the edge; the place lies on the edge's line only if the line is just touched.
    if (side_of_start(each, other) < 0 || side_of_end(each, other) > 0) return false;
    each.meets = sign_of([&]<class N>(AskedIn<N>) {
                   return cross(of<N>(own).way[own_end_of(each.slot)], of<N>(other).way[0]);
                 }) == 0;
    return true;
  }
  if (kind_ == Kind::edges && readings.rejected == Form::printed) {
    // A first end has t = 0, and a last one t = 1.
    if (own_end_of(each.slot) == 1 || side_of_start(each, other) > 0) return false;
    each.meets = is_on(each, other);
    return true;
  }
  if (!is_on(each, other)) return false;
  // Two equations for the radius, with a root for r = 1, or where the branches coincide.
  const bool is_wrong =
      (kind_ == Kind::arcs && readings.radical == Form::printed && !has_unit_radius) ||
      (kind_ == Kind::arc_and_edge && readings.line == Form::printed);
  if (is_wrong) find_branch(each);
  return !is_wrong || each.branch == 0;
}

std::vector<FeatureEvent> FeaturePair::printed_events(const DiscReadings& readings,
                                                      bool has_unit_radius) {
  const bool are_edges = kind_ == Kind::edges || kind_ == Kind::parallel_edges;
  if (kind_ == Kind::parallel_edges && readings.parallel == Form::printed) return {};
  std::vector<PairContact> found;
  for (const ContactSlot slot : all_contact_slots) {
    const bool is_tangent = slot == ContactSlot::tangent;
    if (is_tangent && are_edges) continue;
    const bool staying = kind_ == Kind::arc_and_edge && !is_tangent &&
                         readings.line == Form::printed && is_arc(owner_of(slot));
    auto each = contact(slot, staying);
    if (each && is_printed(*each, readings, has_unit_radius)) found.push_back(*each);
  }
  std::vector<FeatureEvent> events = by_radius(std::move(found));
  if (kind_ == Kind::edges && readings.number == Form::printed && events.size() != 2) return {};
  for (FeatureEvent& event : events) {
    std::size_t number = 0;
    int way = -1;
    while (number < events_.size() &&
           (way = order(events_[number].contacts[0], event.contacts[0])) < 0) {
      ++number;
    }
    count_points(event, number, number < events_.size() && way == 0);
  }
  return events;
}

template <class N>
Vector<N> FeaturePair::place(const PairContact& contact) const {
  const Contact<N> found = solved<N>(contact.slot, contact.staying);
  return found.base + (found.top / found.under) * found.way;
}
template Vector<Interval> FeaturePair::place(const PairContact& contact) const;
template RootPoint FeaturePair::place(const PairContact& contact) const;

}  // namespace minkref::inline disc
