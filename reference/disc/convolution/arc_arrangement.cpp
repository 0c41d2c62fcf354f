#include "reference/disc/convolution/arc_arrangement.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline disc {
namespace {

/// A half-edge as it leaves its source.
struct LeavingArc {
  std::uint32_t half_edge;
  Vector<Interval> way;
  int bend;  ///< to the left (1), to the right (-1) or not
};

class LeavingOrder {
 public:
  LeavingOrder(const ArcArrangement& arrangement, OffsetCounts& counts)
      : arrangement_(arrangement), counts_(counts) {}

  LeavingArc leaving(std::uint32_t half_edge) const {
    const bool is_circle = carrier(half_edge).is_circle;
    return {half_edge, way<Interval>(half_edge), !is_circle ? 0 : half_edge % 2 == 0 ? 1 : -1};
  }

  /// Sorts counter-clockwise, starting with the first half-edge's direction.
  void sort(std::vector<LeavingArc>& all) const {
    const LeavingArc from = all[0];
    const auto part = [&](const LeavingArc& each) {
      if (each.half_edge == from.half_edge) return 0;
      const int turn = turn_sign(from, each);
      if (turn != 0) return turn > 0 ? 1 : 3;
      return is_same_way(from, each) ? 0 : 2;
    };
    std::vector<std::pair<int, LeavingArc>> parted;
    for (const LeavingArc& each : all) parted.emplace_back(part(each), each);
    std::sort(parted.begin(), parted.end(), [&](const auto& a, const auto& b) {
      if (a.first != b.first) return a.first < b.first;
      if (a.second.half_edge == b.second.half_edge) return false;
      const int turn = a.first % 2 == 0 ? 0 : turn_sign(a.second, b.second);
      return turn != 0 ? turn > 0 : a.second.bend < b.second.bend;
    });
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = parted[k].second;
  }

 private:
  const ArcCarrier& carrier(std::uint32_t half_edge) const {
    return arrangement_.curves().carriers[arrangement_.span(half_edge).carrier];
  }

  template <class N>
  Vector<N> at_node(std::uint32_t node) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return arrangement_.nodes().position(node);
    } else {
      return arrangement_.nodes().exact(node);
    }
  }

  /// A half-edge's direction as it leaves its source, times some number.
  template <class N>
  Vector<N> way(std::uint32_t half_edge) const {
    const ArcCarrier& own = carrier(half_edge);
    const bool is_forward = half_edge % 2 == 0;
    Vector<N> ahead;
    if (!own.is_circle) {
      ahead = numbers<N>(own.way);
    } else {
      const ArcPiece& piece = arrangement_.pieces()[half_edge / 2];
      const ArcSpan& span = arrangement_.span(half_edge);
      if (is_forward ? piece.has_first : piece.has_last) {
        ahead = turned(numbers<N>(is_forward ? span.first : span.last));
      } else {
        ahead = turned(at_node<N>(arrangement_.source(half_edge)) - numbers<N>(own.centre));
      }
    }
    return is_forward ? ahead : Vector<N>{-ahead.x, -ahead.y};
  }

  int turn_sign(const LeavingArc& a, const LeavingArc& b) const {
    if (const std::optional<int> certain = certified_sign(cross(a.way, b.way))) return *certain;
    ++counts_.exact_orders;
    return sign(cross(way<RootNumber>(a.half_edge), way<RootNumber>(b.half_edge)));
  }
  /// Whether parallel directions are equal, not opposite.
  bool is_same_way(const LeavingArc& a, const LeavingArc& b) const {
    if (const std::optional<int> certain = certified_sign(dot(a.way, b.way))) return *certain > 0;
    return sign(dot(way<RootNumber>(a.half_edge), way<RootNumber>(b.half_edge))) > 0;
  }

  const ArcArrangement& arrangement_;
  OffsetCounts& counts_;
};

}  // namespace

ArcArrangement::ArcArrangement(const ArcCurves& curves, OffsetCounts& counts)
    : curves_(curves), arcs_(cut_arcs(curves, counts)) {
  sort_about_nodes(counts);
  find_cycles();
}

void ArcArrangement::sort_about_nodes(OffsetCounts& counts) {
  const LeavingOrder order(*this, counts);
  std::vector<std::vector<std::uint32_t>> leaving(arcs_.nodes.size());
  for (std::uint32_t h = 0; h < half_edges(); ++h) leaving[source(h)].push_back(h);
  clockwise_.resize(half_edges());
  std::vector<LeavingArc> around;
  for (const std::vector<std::uint32_t>& some : leaving) {
    look_for_interrupt();
    if (some.empty()) continue;
    around.clear();
    for (const std::uint32_t h : some) around.push_back(order.leaving(h));
    if (around.size() > 2) order.sort(around);
    for (std::size_t k = 0; k < around.size(); ++k) {
      clockwise_[around[(k + 1) % around.size()].half_edge] = around[k].half_edge;
    }
  }
}

void ArcArrangement::find_cycles() {
  cycles_.assign(half_edges(), OffsetPatch::none);
  for (std::uint32_t first = 0; first < half_edges(); ++first) {
    if (cycles_[first] != OffsetPatch::none) continue;
    for (std::uint32_t h = first; cycles_[h] == OffsetPatch::none; h = next(h)) {
      cycles_[h] = cycle_count_;
    }
    ++cycle_count_;
  }
}

}  // namespace minkref::inline disc
