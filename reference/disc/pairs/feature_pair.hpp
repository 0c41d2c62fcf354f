// Two offset features: the radii at which they start or stop to share points (Behar & Lien 2012,
// Appendix), both true and as printed.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "reference/disc/pairs/pair_contact.hpp"
#include "reference/form.hpp"

namespace minkref::inline disc {

/// Readings of sentences from the Appendix (docs/disc.md, "Pair events").
struct DiscReadings {
  Form rejected = Form::corrected;  ///< "rejecting solutions for which 0 < t or t > 1"
  Form number = Form::corrected;    ///< two segments have "exactly two events", or never meet
  Form radical = Form::corrected;   ///< circles cross at √((s² - s0²) r) from the middle
  Form line = Form::corrected;      ///< the line that a circle touched stays at x0 = xc - s0 r
  Form parallel = Form::corrected;  ///< parallel segments are not spoken of

  static DiscReadings all(Form form) { return {form, form, form, form, form}; }
  bool has_printed() const {
    return rejected == Form::printed || number == Form::printed || radical == Form::printed ||
           line == Form::printed || parallel == Form::printed;
  }
};

/// A condition that holds at a radius.
struct PairContact {
  ContactSlot slot;
  bool staying = false;     ///< the line is taken to stay, as printed
  bool meets = true;        ///< its place is on both features
  std::int8_t branch = 0;   ///< on which side of the foot, or of the line of the centres
  Interval squared_radius;  ///< it holds it
};

/// The change of the points that two features share, as the radius grows.
enum class PairChange : std::uint8_t {
  birth,    ///< there are more from now on
  death,    ///< there are fewer
  touch,    ///< one more at this radius only
  swap,     ///< one ends where another, elsewhere, begins
  overlap,  ///< parallel edges share a segment, at this radius only
  none      ///< nothing changes: only as printed
};
std::string_view name(PairChange change);

/// Orders squared radii. Exact.
int compare_squares(const RootNumber& a, const RootNumber& b);

/// All contacts for a radius.
struct FeatureEvent {
  static constexpr std::uint8_t segment = 255;  ///< so many points: all of a segment

  std::vector<PairContact> contacts;  ///< one or more
  PairChange change = PairChange::none;
  std::uint8_t before = 0, at = 0, after = 0;  ///< points that the features share, in truth

  bool meets() const;
  const Interval& squared_radius() const { return contacts[0].squared_radius; }
};

/// Two features that differ. Features that share a line or circle at every radius, or an end, share
/// the same points at every radius: nothing becomes of these.
///
/// Law: the lines or circles of two features that are not parallel meet at one or two points, the
/// pair's *branches*. On a branch each condition holds on one side of one radius, so that the
/// branch exists for an interval of radii, which ends where a feature's end reaches the branch, or
/// where both branches coincide, at a tangent.
class FeaturePair {
 public:
  FeaturePair(const OffsetFeature& a, const OffsetFeature& b,
              const FeatureNumbers<Interval>& near_a, const FeatureNumbers<Interval>& near_b)
      : features_{&a, &b}, near_{&near_a, &near_b} {}

  /// Ascending. Exact: intervals, then roots.
  std::vector<FeatureEvent> events();
  /// The events of the Appendix as it stands. `has_unit_radius`: whether the disc at scale 1, whose
  /// radius r the formulas use, has radius 1. Call after events().
  std::vector<FeatureEvent> printed_events(const DiscReadings& readings, bool has_unit_radius);

  RootNumber squared_radius(const PairContact& contact) const;
  /// "end on line", "end on circle", "circle on line" or "circles".
  static std::string_view name(ContactSlot slot, bool a_is_arc, bool b_is_arc);
  /// The place as intervals or as roots.
  template <class N>
  Vector<N> place(const PairContact& contact) const;

  std::uint64_t exact_signs = 0;

 private:
  enum class Kind : std::uint8_t { edges, parallel_edges, arc_and_edge, arcs };
  /// A branch at one radius, with a contact there.
  struct Turn {
    std::size_t event;
    bool before, after;
  };

  template <class N>
  decltype(auto) of(std::size_t which) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return static_cast<const FeatureNumbers<Interval>&>(*near_[which]);
    } else {
      return FeatureNumbers<N>(*features_[which]);
    }
  }
  template <class N>
  Contact<N> solved(ContactSlot slot, bool staying) const;
  /// The solution for a contact. Keeps the last interval solution for the next call.
  template <class N>
  decltype(auto) solved(const PairContact& contact) const {
    if constexpr (std::is_same_v<N, Interval>) {
      if (!known_ || known_slot_ != contact.slot || known_staying_ != contact.staying) {
        known_ = solved<Interval>(contact.slot, contact.staying);
        known_slot_ = contact.slot;
        known_staying_ = contact.staying;
      }
      return static_cast<const Contact<Interval>&>(*known_);
    } else {
      return solved<N>(contact.slot, contact.staying);
    }
  }
  bool certainly_never(ContactSlot slot) const;
  template <class Value>
  int sign_of(Value&& value);
  bool is_arc(std::size_t which) const { return features_[which]->is_arc; }

  void find_kind();
  std::optional<PairContact> contact(ContactSlot slot, bool staying);
  bool is_on(const PairContact& contact, std::size_t which);
  int side_of_start(const PairContact& contact, std::size_t edge);
  int side_of_end(const PairContact& contact, std::size_t edge);
  void find_branch(PairContact& contact);
  bool enters(const PairContact& contact, int branch) const;
  int order(const PairContact& a, const PairContact& b) const;
  std::vector<FeatureEvent> by_radius(std::vector<PairContact> contacts) const;
  void follow_branches();
  void count_points(FeatureEvent& event, std::size_t number, bool is_true) const;
  bool is_there(std::size_t branch, std::size_t after_events) const;
  std::uint8_t distinct_places(const FeatureEvent& event) const;
  bool is_printed(PairContact& contact, const DiscReadings& readings, bool has_unit_radius);

  std::array<const OffsetFeature*, 2> features_;
  mutable std::optional<Contact<Interval>> known_;
  mutable ContactSlot known_slot_ = ContactSlot::tangent;
  mutable bool known_staying_ = false;
  std::array<const FeatureNumbers<Interval>*, 2> near_;
  Kind kind_ = Kind::edges;
  int turn_ = 0;                               ///< of two edges
  std::vector<FeatureEvent> events_;           ///< in truth
  std::array<std::vector<Turn>, 2> branches_;  ///< of the branch +1 and -1
};

}  // namespace minkref::inline disc
