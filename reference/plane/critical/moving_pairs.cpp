#include "reference/plane/critical/moving_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace minkref::inline plane {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// slope s + value >= 0 somewhere in [low, high], both coefficients shifted by the error.
void restrict_to(double slope, double value, double error, PairRange& range) {
  if (slope > error) {
    range.low = std::max(range.low, (-value - error) / (slope + error));
  } else if (slope < -error) {
    range.high = std::min(range.high, (value + error) / (-slope - error));
  }
}

}  // namespace

PairRange pair_range(const RoundedEdge& a, const RoundedEdge& b, double from, double to,
                     double error) {
  const double turn = a.dx * b.dy - a.dy * b.dx, right = turn < 0 ? -1 : 1;
  PairRange range{};
  range.c = right * turn;
  range.is_parallel = !(range.c > 64 * error);
  if (range.is_parallel) return range;
  const double px = b.px - a.px, py = b.py - a.py, qx = b.qx - a.qx, qy = b.qy - a.qy;
  range.a_slope = right * (px * b.dy - py * b.dx);
  range.a_value = right * (qx * b.dy - qy * b.dx);
  range.b_slope = right * (px * a.dy - py * a.dx);
  range.b_value = right * (qx * a.dy - qy * a.dx);
  range.low = from;
  range.high = to;
  const auto between = [&](bool is_s, double slope, double value) {
    restrict_to(slope, value, error, range);
    restrict_to(is_s ? range.c - slope : -slope, is_s ? -value : range.c - value, error, range);
  };
  between(a.is_s, range.a_slope, range.a_value);
  between(b.is_s, range.b_slope, range.b_value);
  range.low *= 1 - 0x1p-45;
  range.high *= 1 + 0x1p-45;
  return range;
}

MovingPairs::Box::Box() : low{infinity, infinity}, high{-infinity, -infinity} {}

void MovingPairs::Box::add(const Box& other) {
  for (std::size_t k = 0; k < 2; ++k) {
    low[k] = std::min(low[k], other.low[k]);
    high[k] = std::max(high[k], other.high[k]);
  }
}

void MovingPairs::Box::add(double x, double y, double error) {
  low = {std::min(low[0], x - error), std::min(low[1], y - error)};
  high = {std::max(high[0], x + error), std::max(high[1], y + error)};
}

bool MovingPairs::Box::is_within(double most) const {
  return low[0] > -most && low[1] > -most && high[0] < most && high[1] < most;
}

/// At the weights s / (1 + s) of p and 1 / (1 + s) of q.
MovingPairs::Box MovingPairs::box_at(const RoundedEdge& edge, double of_p, double of_q) {
  const double x = of_p * edge.px + of_q * edge.qx, y = of_p * edge.py + of_q * edge.qy;
  const double own = edge.is_s ? of_p : of_q, dx = own * edge.dx, dy = own * edge.dy;
  const double error =
      0x1p-48 * (of_p * (std::abs(edge.px) + std::abs(edge.py)) +
                 of_q * (std::abs(edge.qx) + std::abs(edge.qy)) + std::abs(dx) + std::abs(dy)) +
      1e-300;
  Box box;
  box.add(x, y, error);
  box.add(x + dx, y + dy, error);
  return box;
}

MovingPairs::MovingBox MovingPairs::box_of(const RoundedEdge& edge, double from, double to) {
  constexpr double most = std::numeric_limits<double>::max() / 4;
  const bool is_bounded = to < infinity;
  MovingBox box{box_at(edge, from / (1 + from), 1 / (1 + from)),
                box_at(edge, is_bounded ? to / (1 + to) : 1, is_bounded ? 1 / (1 + to) : 0)};
  if (box.at_first.is_within(most) && box.at_last.is_within(most)) return box;
  box.at_first.add(-most, -most, 0);
  box.at_first.add(most, most, 0);
  box.at_last = box.at_first;
  return box;
}

MovingPairs::MovingPairs(const std::vector<RoundedEdge>& edges, double from, double to) {
  std::array<EdgeColumns, 2> columns;
  for (const bool is_s : {true, false}) {
    std::vector<std::uint32_t> of_kind;
    std::vector<MovingBox> boxes;
    for (std::uint32_t k = 0; k < edges.size(); ++k) {
      if (edges[k].is_s != is_s) continue;
      of_kind.push_back(k);
      boxes.push_back(box_of(edges[k], from, to));
    }
    const BasicBoxTree<MovingBox> nearby(boxes);
    for (const std::uint32_t k : nearby.order()) {
      const RoundedEdge& e = edges[of_kind[k]];
      columns[is_s].add(e.px, e.py, e.qx, e.qy, e.dx, e.dy);
      const auto place = static_cast<std::uint32_t>(edges_[is_s].size());
      if (place % block_size == 0) blocks_.push_back({is_s, place, place, {}});
      ++blocks_.back().last;
      blocks_.back().box.add(boxes[k]);
      edges_[is_s].push_back(of_kind[k]);
      boxes_[is_s].push_back(boxes[k]);
    }
  }
  std::vector<MovingBox> of_blocks;
  for (const Block& block : blocks_) of_blocks.push_back(block.box);
  tree_ = BasicBoxTree<MovingBox>(std::move(of_blocks));
  filter_ = PairFilter(std::move(columns[1]), std::move(columns[0]));
}

}  // namespace minkref::inline plane
