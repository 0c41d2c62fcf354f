#include "reference/disc/features/tracks.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline disc {

std::vector<BridgeTrack> bridge_tracks(const DiscIndex& index) {
  const std::vector<DiagramHalf>& halves = index.graph().halves;
  const DiagramGraph& graph = index.graph();
  struct Node {
    unsigned below = 0, flat = 0, above = 0;
    std::uint32_t rising = DiagramGraph::none;
    bool is_passed() const { return below == 1 && flat == 0 && above == 1; }
  };
  std::vector<Node> nodes(graph.events + graph.gaps + graph.reflex_vertices);
  for (std::uint32_t k = 0; k < halves.size(); ++k) {
    Node& node = nodes[halves[k].from];
    if (index.low(k) == index.high(k)) {
      ++node.flat;
    } else if (index.rises(k)) {
      ++node.above;
      node.rising = k;
    } else {
      ++node.below;
    }
  }
  std::vector<BridgeTrack> tracks;
  for (std::uint32_t k = 0; k < halves.size(); ++k) {
    look_for_interrupt();
    if (!index.rises(k) || nodes[halves[k].from].is_passed()) continue;
    BridgeTrack track{{k}};
    while (nodes[halves[track.halves.back()].to].is_passed()) {
      track.halves.push_back(nodes[halves[track.halves.back()].to].rising);
    }
    tracks.push_back(std::move(track));
  }
  const auto key = [&](const BridgeTrack& track) {
    const std::uint32_t first = track.halves.front();
    return std::tuple(index.low(first), halves[first].from, first);
  };
  std::sort(tracks.begin(), tracks.end(),
            [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return tracks;
}

}  // namespace minkref::inline disc
