#include "reference/plane/dynamic/winding_status.hpp"

#include <stdexcept>

#include "reference/plane/dynamic/passing_edges.hpp"
#include "reference/plane/dynamic/scale_between.hpp"

namespace minkref::inline plane {
namespace {

class WindingStatus : public GapStatus {
 public:
  WindingStatus(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events,
                const SweptEdge& swept)
      : events_(events), swept_(swept) {
    const std::uint32_t first = events.groups() > 0 ? 0 : EdgeNode::always;
    first_ = first_numbers(P, Q, scale_between(events, EdgeNode::always, first).scale);
  }

  void begin(std::span<const std::uint32_t> list, std::uint32_t,
             std::vector<Status>& status) override {
    steps_.clear();
    bases_.clear();
    for (std::uint32_t n = 0; n < swept_.count(); ++n) steps_.push_back(step(n));
    std::size_t gap = 0;
    while (swept_.same_track(list[gap], list[gap + 1])) ++gap;
    spread(list, gap, first_[swept_.edge()], 0);
    tell(list, status);
  }

  void pass(const EdgePassage& g, std::vector<Status>& status) override {
    old_ = numbers_;
    const Stretch& anchor = g.stretches.front();
    spread(g.list, anchor.after, numbers_after(anchor, g), g.group + 1);
    for (const Stretch& stretch : g.stretches) {
      if (numbers_[stretch.after] == numbers_after(stretch, g)) continue;
      throw std::logic_error("winding numbers: two ways to a face give two numbers");
    }
    tell(g.list, status);
  }

  bool on_boundary_at(const Stretch& stretch, const EdgePassage& g) override {
    return on_boundary(old_[stretch.before] + passing(stretch, g).first);
  }

  void finish(EdgeHistory& history) override {
    WindingHistory& winding = history.winding;
    winding.first_base.push_back(winding.bases.size());
    winding.bases.insert(winding.bases.end(), bases_.begin(), bases_.end());
    winding.steps.insert(winding.steps.end(), steps_.begin(), steps_.end());
  }

 private:
  /// Edges of reflex vertices bound nothing: where one runs along the boundary, another edge does.
  bool on_boundary(SideNumbers n) const {
    return n.left > 0 && n.right == 0 && events_.edges()[swept_.edge()].sign > 0;
  }

  /// The change across a node: only sides where the crossing edge runs go from its left to its
  /// right, or back.
  SideStep step(std::uint32_t local) const {
    const EdgeNode& node = swept_.node(local);
    if (node.kind != EdgeNode::Kind::crossing) return {};
    const EdgeCrossing crossing = swept_.crossing(local);
    const auto change = static_cast<std::int8_t>(-crossing.turn * events_.edges()[node.other].sign);
    const bool comes = !crossing.starts_here, goes = !crossing.ends_here;
    const bool on_left = crossing.turn > 0 ? goes : comes;
    const bool on_right = crossing.turn > 0 ? comes : goes;
    return {on_left ? change : std::int8_t{0}, on_right ? change : std::int8_t{0}};
  }

  /// All numbers along the edge, from one gap's numbers.
  void spread(std::span<const std::uint32_t> list, std::size_t gap, SideNumbers known,
              std::uint32_t interval) {
    numbers_.assign(list.size() - 1, {});
    for (std::size_t i = 1; i < numbers_.size(); ++i) {
      numbers_[i] = numbers_[i - 1] + steps_[list[i]];
    }
    const SideNumbers shift = known - numbers_[gap];
    for (SideNumbers& numbers : numbers_) numbers = numbers + shift;
    if (bases_.empty() || !(bases_.back().numbers == shift)) bases_.push_back({interval, shift});
  }

  void tell(std::span<const std::uint32_t> list, std::vector<Status>& status) const {
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const SideNumbers n = numbers_[i];
      const bool negative = n.left < 0 || n.right < 0;
      if (!negative && !on_boundary(n)) continue;
      if (swept_.same_track(list[i], list[i + 1])) continue;
      if (negative) throw std::logic_error("winding numbers: one is negative");
      status[i] = Status::boundary;
    }
  }

  /// The changes by parallel edges that pass over a stretch: to the scale, and from there to above.
  std::pair<SideNumbers, SideNumbers> passing(const Stretch& stretch, const EdgePassage& g) const {
    std::pair<SideNumbers, SideNumbers> added;
    if (!stretch.overlapped) return added;
    const Rational scale = events_.exact(g.group);
    const Point middle = swept_.middle(stretch.from, stretch.to, scale);
    for (const std::uint32_t other : g.overlapping) {
      const RationalEdge& f = events_.moving()[other];
      if (!runs_along(swept_.moving(), f, middle, scale)) continue;
      const auto [at, above] = change_by_passing(swept_.moving(), f, events_.edges()[other].sign);
      added = {added.first + at, added.second + above};
    }
    return added;
  }

  SideNumbers numbers_after(const Stretch& stretch, const EdgePassage& g) const {
    const auto [at, above] = passing(stretch, g);
    return old_[stretch.before] + at + above;
  }

  const ArrangementEvents& events_;
  const SweptEdge& swept_;
  std::vector<SideNumbers> first_;  ///< of each edge
  // The edge being swept.
  std::vector<SideStep> steps_;             ///< of its nodes
  std::vector<SideNumbers> numbers_, old_;  ///< of the gaps above and below the last group
  std::vector<WindingHistory::Base> bases_;
};

}  // namespace

std::unique_ptr<GapStatus> winding_status(const PolygonSet& P, const PolygonSet& Q,
                                          const ArrangementEvents& events, const SweptEdge& swept) {
  return std::make_unique<WindingStatus>(P, Q, events, swept);
}

}  // namespace minkref::inline plane
