#include "reference/plane/dynamic/triple_events.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/convolution/convolution_segments.hpp"
#include "reference/plane/kernel/double_block.hpp"
#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/moving/double_range.hpp"

namespace minkref::inline plane {
namespace {

/// One edge's nodes as columns: positions slope s + value, and each node's range of scales,
/// slightly widened.
struct Columns {
  std::vector<double> slope, value, from, to;
  std::vector<std::uint32_t> node;

  void clear() {
    for (auto* column : {&slope, &value, &from, &to}) column->clear();
    node.clear();
  }
  void pad() {
    for (auto* column : {&slope, &value, &to}) column->resize(node.size() + block_width, 0.0);
    from.resize(node.size() + block_width, std::numeric_limits<double>::infinity());
  }
};

/// Finds the nodes from `first` on that may change places with node i, without nodes that certainly
/// keep their order while both exist.
MINKREF_CLONES std::size_t swap_candidates(const Columns& c, std::size_t i, std::size_t first,
                                           std::uint32_t* out) {
  // A position's error is 2^-50 of its terms.
  const Block zero = {};
  const double bound = 0x1p-48;
  const double i_slope = std::abs(c.slope[i]), i_value = std::abs(c.value[i]);
  std::size_t count = 0;
  for (std::size_t j = first; j < c.node.size(); j += block_width) {
    const Block from = load_block(&c.from[j]), to = load_block(&c.to[j]);
    const Block low = from > zero + c.from[i] ? from : zero + c.from[i];
    const Block high = to < zero + c.to[i] ? to : zero + c.to[i];
    const Block slope = load_block(&c.slope[j]), value = load_block(&c.value[j]);
    const Block abs_slope = (slope < zero ? -slope : slope) + i_slope;
    const Block abs_value = (value < zero ? -value : value) + i_value;
    const Block d_slope = slope - c.slope[i], d_value = value - c.value[i];
    const Block at_low = d_slope * low + d_value, at_high = d_slope * high + d_value;
    const Block low_error = (abs_slope * low + abs_value) * bound + 1e-300;
    const Block high_error = (abs_slope * high + abs_value) * bound + 1e-300;
    const BlockMask keeps = (low > high) | ((at_low > low_error) & (at_high > high_error)) |
                            ((at_low < -low_error) & (at_high < -high_error));
    for (std::size_t k = 0; k < block_width; ++k) {
      out[count] = static_cast<std::uint32_t>(j + k);
      count += static_cast<std::size_t>(keeps[k] == 0 && j + k < c.node.size());
    }
  }
  return count;
}

Rational exact_quotient(const Rational& num, const Rational& den) { return num / den; }
template <unsigned Bits>
Rational exact_quotient(const FixedInteger<Bits>& num, const FixedInteger<Bits>& den) {
  return Rational(grid_integer(num), grid_integer(den));
}

template <class K>
class Search {
 public:
  using W = typename K::Wide;
  using Product = WideProduct<K>;

  Search(const K& kernel, std::vector<MovingEdge<typename K::Vector>> edges,
         std::vector<IndexedSegment> ends, const NodeTable& table, const Moments& moments,
         const ScaleWindow& window)
      : kernel_(kernel),
        edges_(std::move(edges)),
        ends_(std::move(ends)),
        table_(table),
        moments_(moments),
        window_(window) {
    if (window.from) low_ = below(to_double(*window.from));
    high_ = window.to ? above(to_double(*window.to)) : std::numeric_limits<double>::infinity();
  }

  std::vector<TripleEvent> run() {
    for (std::uint32_t e = 0; e < edges_.size(); ++e) along(e);
    return merged();
  }

 private:
  void along(std::uint32_t edge) {
    columns_.clear();
    positions_.clear();
    for (std::uint32_t n = table_.begin(edge); n < table_.end(edge); ++n) {
      const EdgeNode& node = table_.nodes[n];
      if (node.from != EdgeNode::always && node.from == node.to) continue;
      positions_.push_back(node_position(kernel_, edges_, edge, node));
      const auto& position = positions_.back();
      columns_.slope.push_back(filter_quotient(position.slope, position.den));
      columns_.value.push_back(filter_quotient(position.value, position.den));
      columns_.from.push_back(node.from == EdgeNode::always
                                  ? low_
                                  : moments_.approximate(node.from) * (1 - 0x1p-40) - 1e-300);
      columns_.to.push_back(node.to == EdgeNode::always
                                ? high_
                                : moments_.approximate(node.to) * (1 + 0x1p-40) + 1e-300);
      columns_.node.push_back(n);
    }
    columns_.pad();
    found_.resize(columns_.node.size() + block_width);
    for (std::size_t i = 0; i + 1 < columns_.node.size(); ++i) {
      look_for_interrupt();
      const std::size_t count = swap_candidates(columns_, i, i + 1, found_.data());
      for (std::size_t k = 0; k < count; ++k) decide(edge, i, found_[k]);
    }
  }

  /// Whether two edges have an end in common at every scale.
  bool share_vertex(std::uint32_t e, std::uint32_t f) const {
    const IndexedSegment &x = ends_[e], &y = ends_[f];
    return x.from == y.from || x.from == y.to || x.to == y.from || x.to == y.to;
  }

  /// Whether two crossings along an edge change places, if ever, only at an end of either: because
  /// their edges share a vertex, and change places there; or because one edge shares a vertex with
  /// the edge itself, so that its crossing stays at that end.
  bool change_places_at_ends(std::uint32_t edge, std::size_t i, std::size_t j) const {
    const EdgeNode &x = table_.nodes[columns_.node[i]], &y = table_.nodes[columns_.node[j]];
    if (x.kind != EdgeNode::Kind::crossing || y.kind != EdgeNode::Kind::crossing) return false;
    return share_vertex(x.other, y.other) || share_vertex(edge, x.other) ||
           share_vertex(edge, y.other);
  }

  void decide(std::uint32_t edge, std::size_t i, std::size_t j) {
    if (change_places_at_ends(edge, i, j)) return;
    const auto [slope, value] = position_difference<K>(positions_[i], positions_[j]);
    const int rises = wide_sign(slope);
    if (rises == 0 || wide_sign(value) * rises >= 0) return;
    const double scale = -wide_quotient(value, slope);
    const auto exact = [slope = slope, value = value] {
      return exact_quotient(Product(-value), slope);
    };
    for (const std::size_t k : {i, j}) {
      const EdgeNode& node = table_.nodes[columns_.node[k]];
      if (node.from == EdgeNode::always
              ? window_.from && !before(
                                    low_, [&] { return *window_.from; }, scale, exact)
              : !before(
                    moments_.approximate(node.from), [&] { return moments_.exact(node.from); },
                    scale, exact)) {
        return;
      }
      if (node.to == EdgeNode::always
              ? window_.to && !before(scale, exact, high_, [&] { return *window_.to; })
              : !before(scale, exact, moments_.approximate(node.to),
                        [&] { return moments_.exact(node.to); })) {
        return;
      }
    }
    const std::uint32_t first = columns_.node[i], second = columns_.node[j];
    std::array<std::uint32_t, 3> names{edge, table_.nodes[first].other, table_.nodes[second].other};
    std::sort(names.begin(), names.end());
    const auto bit = std::find(names.begin(), names.end(), edge) - names.begin();
    found_events_.push_back({scale, names[0], names[1], names[2], edge, first, second,
                             static_cast<std::uint8_t>(1U << bit)});
  }

  /// x < y, by doubles if certain.
  template <class ExactX, class ExactY>
  static bool before(double x, ExactX&& exact_x, double y, ExactY&& exact_y) {
    const double bound = (std::abs(x) + std::abs(y)) * 2 * filter_bound;
    if (y - x > bound) return true;
    if (x - y > bound) return false;
    return exact_x() < exact_y();
  }

  /// Merges the swaps of a triple along its edges into one event.
  std::vector<TripleEvent> merged() {
    auto& all = found_events_;
    std::sort(all.begin(), all.end(), [](const TripleEvent& x, const TripleEvent& y) {
      look_for_interrupt();
      return std::tie(x.a, x.b, x.c, x.first, x.second) <
             std::tie(y.a, y.b, y.c, y.first, y.second);
    });
    std::vector<TripleEvent> result;
    for (const TripleEvent& event : all) {
      look_for_interrupt();
      const auto same_triple = [&](const TripleEvent& x) {
        return x.a == event.a && x.b == event.b && x.c == event.c;
      };
      auto known = result.rbegin();
      while (known != result.rend() && same_triple(*known) && !same_scale(*known, event)) ++known;
      if (known != result.rend() && same_triple(*known)) {
        known->swaps |= event.swaps;
      } else {
        result.push_back(event);
      }
    }
    result.shrink_to_fit();
    return result;
  }

  /// Whether two swaps of a triple have the same scale. Only edges on a common line can have two
  /// scales.
  bool same_scale(const TripleEvent& x, const TripleEvent& y) const {
    const auto crossing = [&](std::uint32_t n) {
      return table_.nodes[n].kind == EdgeNode::Kind::crossing;
    };
    if (crossing(x.first) && crossing(x.second) && crossing(y.first) && crossing(y.second)) {
      return true;
    }
    return scale_of(x) == scale_of(y);
  }
  Rational scale_of(const TripleEvent& x) const {
    const auto f = node_position(kernel_, edges_, x.edge, table_.nodes[x.first]);
    const auto g = node_position(kernel_, edges_, x.edge, table_.nodes[x.second]);
    const auto difference = position_difference<K>(f, g);
    return exact_quotient(Product(-difference.value), difference.slope);
  }

  const K& kernel_;
  std::vector<MovingEdge<typename K::Vector>> edges_;
  std::vector<IndexedSegment> ends_;  ///< vertices of the convolution, by number
  const NodeTable& table_;
  const Moments& moments_;
  ScaleWindow window_;
  double low_ = 0, high_ = 0;
  Columns columns_;
  std::vector<PositionAlong<W>> positions_;
  std::vector<std::uint32_t> found_;
  std::vector<TripleEvent> found_events_;
};

}  // namespace

std::vector<TripleEvent> triple_events(const PolygonSet& P, const PolygonSet& Q,
                                       const std::vector<ConvolutionEdge>& edges,
                                       const NodeTable& table, const Moments& moments,
                                       const ScaleWindow& window) {
  const FloatEnvironment standard;
  return on_exact_frame(P, Q, [&](const auto& frame) {
    using K = typename std::decay_t<decltype(frame)>::K;
    return Search<K>(frame.kernel, moving_edges(edges, frame.P, frame.Q),
                     convolution_segments<K>(edges, frame.P, frame.Q).segments, table, moments,
                     window)
        .run();
  });
}

}  // namespace minkref::inline plane
