#include "reference/plane/dynamic/collision_status.hpp"

#include "reference/plane/dynamic/sub_edge_status.hpp"

namespace minkref::inline plane {
namespace {

class CollisionStatus : public GapStatus {
 public:
  CollisionStatus(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events,
                  const SweptEdge& swept)
      : events_(events), swept_(swept), decide_(P, Q, events, swept) {}

  void begin(std::span<const std::uint32_t> list, std::uint32_t next,
             std::vector<Status>& status) override {
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
      if (swept_.same_track(list[i], list[i + 1])) continue;
      status[i] = decide_.between(list[i], list[i + 1], EdgeNode::always, next);
    }
  }

  /// A gap takes the status common to the gaps below that form it at the group's scale; without
  /// one, collision detection decides anew.
  void pass(const EdgePassage& g, std::vector<Status>& status) override {
    const auto& stretches = g.stretches;
    for (std::size_t j = 0, k = 0; j + 1 < g.list.size(); ++j) {
      const std::size_t first = k;
      bool same = true, overlapped = false;
      for (; k < stretches.size() && stretches[k].after == j; ++k) {
        overlapped = overlapped || stretches[k].overlapped;
        same = same && g.old_status[stretches[k].before] == g.old_status[stretches[first].before];
      }
      if (first == k && swept_.same_track(g.list[j], g.list[j + 1])) continue;
      const bool anew = first == k || !same || overlapped;
      status[j] = anew ? decide_.between(g.list[j], g.list[j + 1], g.group, g.next)
                       : g.old_status[stretches[first].before];
    }
  }

  bool on_boundary_at(const Stretch& stretch, const EdgePassage& g) override {
    return decide_.at(stretch.from, stretch.to,
                      {events_.exact(g.group), events_.approximate(g.group)},
                      g.overlapping) == Status::boundary;
  }

  void finish(EdgeHistory& history) override {
    history.decided_by_doubles = decide_.decided_by_doubles;
    history.decided_exactly = decide_.decided_exactly;
  }

 private:
  const ArrangementEvents& events_;
  const SweptEdge& swept_;
  SubEdgeStatus decide_;
};

}  // namespace

std::unique_ptr<GapStatus> collision_status(const PolygonSet& P, const PolygonSet& Q,
                                            const ArrangementEvents& events,
                                            const SweptEdge& swept) {
  return std::make_unique<CollisionStatus>(P, Q, events, swept);
}

}  // namespace minkref::inline plane
