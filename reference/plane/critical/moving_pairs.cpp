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

MovingPairs::MovingBox MovingPairs::Way::box_along(const Spot& along) const {
  MovingBox box;
  const auto add = [&](Box& to, const Spot& p, double error) {
    // A coordinate is at most sqrt(2) times a longer one of p's.
    const double more = 2 * error;
    to.add(p[0] * along[0] + p[1] * along[1], p[1] * along[0] - p[0] * along[1], more);
  };
  for (const std::size_t end : {0, 1}) {
    add(box.at_first, at_first[end], error_at_first);
    add(box.at_last, at_last[end], error_at_last);
  }
  constexpr double most = std::numeric_limits<double>::max() / 4;
  if (box.at_first.is_within(most) && box.at_last.is_within(most)) return box;
  box.at_first.add(-most, -most, 0);
  box.at_first.add(most, most, 0);
  box.at_last = box.at_first;
  return box;
}

/// At the weights s / (1 + s) of p and 1 / (1 + s) of q.
MovingPairs::Way MovingPairs::way_of(const RoundedEdge& edge, double from, double to) {
  Way way;
  const auto put = [&](double of_p, double of_q, std::array<Spot, 2>& ends) {
    const double x = of_p * edge.px + of_q * edge.qx, y = of_p * edge.py + of_q * edge.qy;
    const double own = edge.is_s ? of_p : of_q, dx = own * edge.dx, dy = own * edge.dy;
    ends = {Spot{x, y}, Spot{x + dx, y + dy}};
    return 0x1p-48 *
               (of_p * (std::abs(edge.px) + std::abs(edge.py)) +
                of_q * (std::abs(edge.qx) + std::abs(edge.qy)) + std::abs(dx) + std::abs(dy)) +
           1e-300;
  };
  const bool is_bounded = to < infinity;
  way.error_at_first = put(from / (1 + from), 1 / (1 + from), way.at_first);
  way.error_at_last =
      put(is_bounded ? to / (1 + to) : 1, is_bounded ? 1 / (1 + to) : 0, way.at_last);
  return way;
}

/// By lengths at both ends of the window: squares of complex numbers do not tell opposite
/// directions apart.
MovingPairs::Spot MovingPairs::direction_of(const std::vector<Way>& ways,
                                            const std::uint32_t* begin, const std::uint32_t* end) {
  double real = 0, imaginary = 0;
  for (const std::uint32_t* k = begin; k != end; ++k) {
    for (const auto* ends : {&ways[*k].at_first, &ways[*k].at_last}) {
      const double dx = (*ends)[1][0] - (*ends)[0][0], dy = (*ends)[1][1] - (*ends)[0][1];
      real += (dx - dy) * (dx + dy);
      imaginary += 2 * dx * dy;
    }
  }
  const double angle = std::atan2(imaginary, real) / 2;
  return std::isfinite(angle) ? Spot{std::cos(angle), std::sin(angle)} : Spot{1, 0};
}

/// Halves across the direction with most room beside edges.
void MovingPairs::cluster(const std::vector<Way>& ways, std::uint32_t* begin, std::uint32_t* end) {
  const auto count = static_cast<std::size_t>(end - begin);
  if (count <= block_size) return;
  const Spot main = direction_of(ways, begin, end);
  std::vector<std::pair<double, std::uint32_t>> places(count), best;
  double most = -1;
  for (const Spot& along : {Spot{1, 0}, Spot{0, 1}, main, Spot{-main[1], main[0]}}) {
    for (const bool is_last : {false, true}) {
      double low = infinity, high = -infinity, extents = 0;
      for (std::size_t k = 0; k < count; ++k) {
        look_for_interrupt();
        const Way& way = ways[begin[k]];
        const auto& ends = is_last ? way.at_last : way.at_first;
        const double u = ends[0][0] * along[0] + ends[0][1] * along[1],
                     v = ends[1][0] * along[0] + ends[1][1] * along[1];
        const double place = u / 2 + v / 2;
        places[k] = {std::isfinite(place) ? place : 0, begin[k]};
        low = std::min(low, places[k].first);
        high = std::max(high, places[k].first);
        extents += std::abs(u / 2 - v / 2);
      }
      const double spread = high - low;
      const double room = spread > 0 ? spread / (extents + 1e-12 * spread) : 0;
      if (room > most) most = room, best = places;
    }
  }
  const std::size_t middle = (count / 2 + block_size - 1) / block_size * block_size;
  std::nth_element(best.begin(), best.begin() + static_cast<std::ptrdiff_t>(middle), best.end());
  for (std::size_t k = 0; k < count; ++k) begin[k] = best[k].second;
  cluster(ways, begin, begin + middle);
  cluster(ways, begin + middle, end);
}

/// In the frame of either: a moving rectangle's corners move along lines.
bool MovingPairs::are_apart(const Block& a, const Block& b) {
  const auto seen_from = [](const Block& own, const Spot& along) {
    const double cosine = own.along[0] * along[0] + own.along[1] * along[1],
                 sine = own.along[1] * along[0] - own.along[0] * along[1];
    MovingBox box;
    const auto add = [&](Box& to, const Box& from) {
      double size = 0;
      for (const std::size_t k : {0, 1}) {
        size = std::max({size, std::abs(from.low[k]), std::abs(from.high[k])});
      }
      for (const double u : {from.low[0], from.high[0]}) {
        for (const double v : {from.low[1], from.high[1]}) {
          to.add(u * cosine - v * sine, u * sine + v * cosine, 0x1p-48 * size + 1e-300);
        }
      }
    };
    add(box.at_first, own.turned.at_first);
    add(box.at_last, own.turned.at_last);
    return box;
  };
  return !a.turned.overlaps(seen_from(b, a.along)) || !b.turned.overlaps(seen_from(a, b.along));
}

void MovingPairs::add_blocks(bool is_s, bool is_wanted, const std::vector<RoundedEdge>& edges,
                             const std::vector<std::uint32_t>& which, double from, double to) {
  std::vector<std::uint32_t> order;
  std::vector<Way> ways;
  for (const std::uint32_t edge : which) {
    order.push_back(static_cast<std::uint32_t>(order.size()));
    ways.push_back(way_of(edges[edge], from, to));
  }
  cluster(ways, order.data(), order.data() + order.size());
  const auto before = static_cast<std::uint32_t>(edges_[is_s].size());
  for (std::size_t first = 0; first < order.size(); first += block_size) {
    const std::size_t last = std::min(first + block_size, order.size());
    const Spot along = direction_of(ways, order.data() + first, order.data() + last);
    if (is_wanted) wanted_.push_back(static_cast<std::uint32_t>(blocks_.size()));
    Block& block = blocks_.emplace_back(Block{is_s,
                                              is_wanted,
                                              before + static_cast<std::uint32_t>(first),
                                              before + static_cast<std::uint32_t>(last),
                                              {},
                                              along,
                                              {}});
    for (std::size_t place = first; place < last; ++place) {
      const Way& way = ways[order[place]];
      block.box.add(way.box());
      block.turned.add(way.box_along(along));
      edges_[is_s].push_back(which[order[place]]);
      ways_[is_s].push_back(way);
    }
  }
}

MovingPairs::MovingPairs(const std::vector<RoundedEdge>& edges, double from, double to,
                         const std::vector<char>& wanted) {
  MovingBox around;
  for (std::uint32_t k = 0; k < wanted.size(); ++k) {
    if (wanted[k] != 0) around.add(way_of(edges[k], from, to).box());
  }
  for (const bool is_s : {true, false}) {
    for (const bool is_wanted : {true, false}) {
      std::vector<std::uint32_t> which;
      for (std::uint32_t k = 0; k < edges.size(); ++k) {
        look_for_interrupt();
        if (edges[k].is_s != is_s || (wanted.empty() || wanted[k] != 0) != is_wanted) continue;
        if (is_wanted || way_of(edges[k], from, to).box().overlaps(around)) which.push_back(k);
      }
      add_blocks(is_s, is_wanted, edges, which, from, to);
    }
  }
  std::array<EdgeColumns, 2> columns;
  for (const bool is_s : {true, false}) {
    for (const std::uint32_t k : edges_[is_s]) {
      const RoundedEdge& e = edges[k];
      columns[is_s].add(e.px, e.py, e.qx, e.qy, e.dx, e.dy);
    }
  }
  std::vector<MovingBox> of_blocks;
  for (const Block& block : blocks_) of_blocks.push_back(block.box);
  tree_ = BasicBoxTree<MovingBox>(std::move(of_blocks));
  filter_ = PairFilter(std::move(columns[1]), std::move(columns[0]));
}

}  // namespace minkref::inline plane
