#include "reference/plane/dynamic/node_arithmetic.hpp"

#include "reference/plane/critical/event_scale.hpp"
#include "reference/plane/dynamic/edge_history.hpp"
#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/moving/double_range.hpp"

namespace minkref::inline plane {
namespace {

template <class K>
class FrameArithmetic : public NodeArithmetic {
 public:
  using W = typename K::Wide;

  FrameArithmetic(const K& kernel, std::vector<MovingEdge<typename K::Vector>> edges,
                  const ArrangementEvents& events)
      : kernel_(kernel), edges_(std::move(edges)), events_(events) {}

  void columns(std::uint32_t edge, std::vector<double>& slope,
               std::vector<double>& value) const override {
    slope.clear();
    value.clear();
    const NodeTable& table = events_.table();
    for (std::uint32_t n = table.begin(edge); n < table.end(edge); ++n) {
      const auto position = node_position(kernel_, edges_, edge, table.nodes[n]);
      slope.push_back(filter_quotient(position.slope, position.den));
      value.push_back(filter_quotient(position.value, position.den));
    }
  }

  Fraction scale(std::uint32_t group) const override {
    if (const PairEvent* event = events_.pair_event_at(group)) {
      return fraction(event_scale(kernel_, edges_[event->a], edges_[event->b], *event));
    }
    if (const TripleEvent* event = events_.triple_event_at(group)) {
      const auto difference = position_difference<K>(position(event->edge, event->first),
                                                     position(event->edge, event->second));
      return fraction(decltype(difference.value)(-difference.value), difference.slope);
    }
    return fraction(events_.exact(group));
  }

  int compare(std::uint32_t edge, std::uint32_t x, std::uint32_t y,
              const Fraction& scale) const override {
    const auto difference = position_difference<K>(position(edge, x), position(edge, y));
    return sign_at(difference.slope, difference.value, scale);
  }

  int compare_slopes(std::uint32_t edge, std::uint32_t x, std::uint32_t y) const override {
    return wide_sign(position_difference<K>(position(edge, x), position(edge, y)).slope);
  }

  bool same_track(std::uint32_t edge, std::uint32_t x, std::uint32_t y) const override {
    const auto difference = position_difference<K>(position(edge, x), position(edge, y));
    return wide_sign(difference.slope) == 0 && wide_sign(difference.value) == 0;
  }

  EdgeCrossing crossing(std::uint32_t edge, std::uint32_t node) const override {
    const auto &a = edges_[edge], &b = edges_[events_.table().nodes[node].other];
    return {kernel_.turn(a.d, b.d), on_line(a, start_of(b)), on_line(a, end_of(b))};
  }

 private:
  using V = typename K::Vector;

  /// Whether a vertex lies on the line of an edge at every scale.
  static bool on_line(const MovingEdge<V>& edge, const MovingVertex<V>& vertex) {
    return wide_sign(K::cross(V(vertex.p - edge.p), edge.d)) == 0 &&
           wide_sign(K::cross(V(vertex.q - edge.q), edge.d)) == 0;
  }

  PositionAlong<W> position(std::uint32_t edge, std::uint32_t node) const {
    if (node == start_of_edge) return {};
    if (node == end_of_edge) {
      return edges_[edge].is_s() ? PositionAlong<W>{W(1), W(0), W(1)}
                                 : PositionAlong<W>{W(0), W(1), W(1)};
    }
    return node_position(kernel_, edges_, edge, events_.table().nodes[node]);
  }

  K kernel_;
  std::vector<MovingEdge<typename K::Vector>> edges_;
  const ArrangementEvents& events_;
};

}  // namespace

std::unique_ptr<NodeArithmetic> node_arithmetic(const PolygonSet& P, const PolygonSet& Q,
                                                const ArrangementEvents& events) {
  return on_exact_frame(P, Q, [&](const auto& frame) -> std::unique_ptr<NodeArithmetic> {
    using K = typename std::decay_t<decltype(frame)>::K;
    return std::make_unique<FrameArithmetic<K>>(
        frame.kernel, moving_edges(events.edges(), frame.P, frame.Q), events);
  });
}

}  // namespace minkref::inline plane
