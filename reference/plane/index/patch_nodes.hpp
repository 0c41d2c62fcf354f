// The cuts of a convolution edge's patch: the tracks of the nodes along the edge.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/plane/critical/parallel_pair.hpp"
#include "reference/plane/index/patch_node_name.hpp"
#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/moving/position_difference.hpp"

namespace minkref::inline plane {

/// A node between two scales.
template <class K>
struct PatchNode {
  using W = typename K::Wide;
  using Bound = typename K::Parameter;

  NodeName name;
  PositionAlong<W> position;
  double slope = 0, value = 0;  ///< of the position, each off by a few roundings
  std::optional<Bound> from, to;
  /// Whether the edge before the node, and behind it, can belong to the boundary: not on the other
  /// edge's left.
  bool open_before = true, open_after = true;
};

template <class K>
struct PatchNodes {
  std::vector<PatchNode<K>> nodes;
  /// Scales at which a parallel edge comes to lie on the edge, and leaves it again.
  std::vector<typename K::Parameter> overlaps;
  /// Edges that meet the edge at one scale only, where ends of both coincide.
  std::vector<std::pair<std::uint32_t, typename K::Parameter>> contacts;
};

template <class K>
class PatchNodeFinder {
 public:
  using W = typename K::Wide;
  using Edge = MovingEdge<typename K::Vector>;

  PatchNodeFinder(K kernel, const std::vector<Edge>& edges)
      : kernel_(std::move(kernel)), edges_(edges) {}

  /// Finds an edge's nodes with the given others. The edge's own ends come first. Exact.
  void find(std::uint32_t edge, const std::uint32_t* others, std::size_t count,
            PatchNodes<K>& result) const {
    result.nodes.clear();
    result.overlaps.clear();
    result.contacts.clear();
    const Edge& e = edges_[edge];
    PatchNode<K> end;
    end.name = {NodeName::Kind::own_start, edge};
    result.nodes.push_back(end);
    end.name.kind = NodeName::Kind::own_end;
    (e.is_s() ? end.position.slope : end.position.value) = W(1);
    (e.is_s() ? end.slope : end.value) = 1;
    result.nodes.push_back(end);
    for (std::size_t k = 0; k < count; ++k) add(edge, others[k], result);
  }

 private:
  void add(std::uint32_t edge, std::uint32_t other, PatchNodes<K>& result) const {
    const Edge &e = edges_[edge], &o = edges_[other];
    const auto conditions = pair_conditions(kernel_, e, o);
    if (conditions.turn == 0) return add_parallel(edge, other, result);
    const auto is_zero = [&](const HalfLine<W>& line) {
      return kernel_.sign(line.slope) == 0 && kernel_.sign(line.value) == 0;
    };
    const auto& lines = conditions.half_lines;
    if (is_zero(lines[0]) || is_zero(lines[1])) return;  // at an end of the edge at all scales
    const auto interval = intersection_of_half_lines<K>(kernel_, lines);
    if (interval.empty) return;
    if (interval.is_point(kernel_)) {
      result.contacts.emplace_back(other, interval.lower->scale);
      return;
    }
    PatchNode<K> node;
    node.name = {NodeName::Kind::crossing, other};
    node.position = crossing_position(kernel_, e, o);
    if (!is_zero(lines[2]) && !is_zero(lines[3])) {
      // The other edge crosses to the left: the part behind the node lies on its right.
      node.open_before = conditions.turn < 0;
      node.open_after = conditions.turn > 0;
    }
    finish(node, interval, result);
  }

  void add_parallel(std::uint32_t edge, std::uint32_t other, PatchNodes<K>& result) const {
    const Edge &e = edges_[edge], &o = edges_[other];
    const auto pair = parallel_pair(kernel_, e, o);
    if (pair.lines == ParallelPair<K>::Lines::one_line_at_one_scale) {
      if (pair.meeting == Meeting::overlapping) result.overlaps.push_back(pair.scale);
      return;
    }
    if (pair.lines == ParallelPair<K>::Lines::apart || pair.interval.empty) return;
    for (const auto kind : {NodeName::Kind::start_of_other, NodeName::Kind::end_of_other}) {
      PatchNode<K> node;
      node.name = {kind, other};
      const bool is_start = kind == NodeName::Kind::start_of_other;
      node.position = vertex_position<K>(e, is_start ? start_of(o) : end_of(o));
      const auto& [slope, value, den] = node.position;
      const HalfLine<W> behind{slope, value}, ahead = e.is_s()
                                                          ? HalfLine<W>{W(den - slope), W(-value)}
                                                          : HalfLine<W>{W(-slope), W(den - value)};
      const auto is_zero = [&](const HalfLine<W>& line) {
        return kernel_.sign(line.slope) == 0 && kernel_.sign(line.value) == 0;
      };
      if (is_zero(behind) || is_zero(ahead)) continue;
      const auto interval = intersection_of_half_lines<K>(kernel_, std::array{behind, ahead});
      if (interval.empty || interval.is_point(kernel_)) continue;
      finish(node, interval, result);
    }
  }

  static void finish(PatchNode<K>& node, const ScaleInterval<K>& interval, PatchNodes<K>& result) {
    node.slope = wide_quotient(node.position.slope, node.position.den);
    node.value = wide_quotient(node.position.value, node.position.den);
    if (interval.lower) node.from = interval.lower->scale;
    if (interval.upper) node.to = interval.upper->scale;
    result.nodes.push_back(std::move(node));
  }

  K kernel_;  // a copy: kernels count their decisions
  const std::vector<Edge>& edges_;
};

}  // namespace minkref::inline plane
