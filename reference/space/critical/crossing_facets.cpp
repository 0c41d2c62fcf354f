#include "reference/space/critical/crossing_facets.hpp"

#include <algorithm>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/critical/moving_box.hpp"
#include "reference/space/critical/parallel_facets.hpp"

namespace minkref::inline space {
namespace {

SpaceBox box_at(const MovingConvolution& convolution, const MovingFacet& facet,
                const BoundedDouble& s) {
  SpaceBox box;
  for (std::size_t k = 0; k < facet.size; ++k) {
    const auto& corner = facet.names[k];
    const BoundedVector &p = convolution.P.points[corner.of_P].rounded,
                        &q = convolution.Q.points[corner.of_Q].rounded;
    box.add(box_around(s * p + q));
  }
  return box;
}

}  // namespace

std::vector<FacetPair> meeting_pairs_at(const MovingConvolution& convolution, const Rational& s) {
  const FloatEnvironment standard;
  const EventScale scale(s);
  const BoundedDouble rounded(scale.rounded(), scale.rounded() * 0x1p-49);
  std::vector<SpaceBox> boxes;
  for (const MovingFacet& facet : convolution.facets) {
    boxes.push_back(box_at(convolution, facet, rounded));
  }
  const BasicBoxTree<SpaceBox> tree(boxes);
  std::vector<FacetPair> found;
  SignCounts signs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    look_for_interrupt();
    tree.query(boxes[i], [&](std::uint32_t j) {
      if (j <= i) return false;
      const MovingFacet &a = convolution.facets[i], &b = convolution.facets[j];
      if (stays_aside(convolution, a, b, rounded, rounded) ||
          stays_aside(convolution, b, a, rounded, rounded)) {
        return false;
      }
      const bool meet = is_zero(cross(a.normal.exact, b.normal.exact))
                            ? parallel_facets_meet(convolution, a, b, s)
                            : ContactRegion(convolution, a, b, signs).meet_at(s);
      if (meet) found.emplace_back(i, j);
      return false;
    });
  }
  std::sort(found.begin(), found.end());
  return found;
}

CrossingFacets::CrossingFacets(std::shared_ptr<const CriticalEvents> events, const Rational& start)
    : events_(std::move(events)), place_(place_of(start)) {
  const FloatEnvironment standard;
  const std::vector<FacetPair> here = meeting_pairs_at(*events_->convolution, start);
  all_ = here;
  for (const SpacePairEvent& e : events_->events) all_.emplace_back(e.first, e.second);
  std::sort(all_.begin(), all_.end());
  all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
  const auto number_of = [&](const FacetPair& pair) {
    return static_cast<std::uint32_t>(std::lower_bound(all_.begin(), all_.end(), pair) -
                                      all_.begin());
  };
  numbers_.reserve(events_->events.size());
  for (const SpacePairEvent& e : events_->events)
    numbers_.push_back(number_of({e.first, e.second}));
  meets_.assign(all_.size(), 0);
  for (const FacetPair& pair : here) meets_[number_of(pair)] = 1;
  count_ = here.size();
}

std::size_t CrossingFacets::place_of(const Rational& s) const {
  const EventScale scale(s);
  const auto& list = events_->events;
  const auto found = std::lower_bound(
      list.begin(), list.end(), scale,
      [](const SpacePairEvent& e, const EventScale& value) { return e.event.s < value; });
  if (found != list.end() && found->event.s == scale) {
    throw BadInput("at-an-event", "there is an event at " + to_string(s), "take a scale beside it");
  }
  return static_cast<std::size_t>(found - list.begin());
}

std::uint64_t CrossingFacets::move_to(const Rational& s) {
  const FloatEnvironment standard;
  const std::size_t from = place_, to = place_of(s);
  const auto set = [&](std::size_t k, bool meets) {
    std::uint8_t& now = meets_[numbers_[k]];
    count_ += static_cast<std::uint64_t>(meets) - now;
    now = meets ? 1 : 0;
  };
  for (std::size_t k = from; k < to; ++k) {
    const ContactChange change = events_->events[k].event.change;
    if (change == ContactChange::birth) set(k, true);
    if (change == ContactChange::death) set(k, false);
  }
  for (std::size_t k = from; k > to; --k) {
    const ContactChange change = events_->events[k - 1].event.change;
    if (change == ContactChange::birth) set(k - 1, false);
    if (change == ContactChange::death) set(k - 1, true);
  }
  place_ = to;
  return from < to ? to - from : from - to;
}

std::vector<FacetPair> CrossingFacets::pairs() const {
  std::vector<FacetPair> found;
  for (std::size_t k = 0; k < all_.size(); ++k) {
    if (meets_[k] != 0) found.push_back(all_[k]);
  }
  return found;
}

}  // namespace minkref::inline space
