#include "reference/near/edge_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Coordinates are below 2: a place along a unit vector is wrong by less than 2^-49, and a
/// rectangle encloses its items but for as much.
constexpr double unit_slack = 0x1p-44;

double along(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return a[0] * b[0] + a[1] * b[1];
}
double across(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

}  // namespace

EdgeTree::EdgeTree(std::vector<NearPoint> points, const std::vector<Edge>& edges)
    : order_(edges.size()) {
  double most = 0;
  for (const NearPoint& p : points) {
    for (const std::size_t k : {0, 1}) {
      if (std::isfinite(p.low[k])) most = std::max(most, std::fabs(p.low[k]));
    }
  }
  if (most > 0) exponent_ = -std::ilogb(most);
  for (NearPoint& p : points) p = scaled(p);
  items_.reserve(edges.size());
  for (const auto& [from, to] : edges) items_.push_back(item(points[from], points[to]));
  std::iota(order_.begin(), order_.end(), 0U);
  if (!items_.empty()) build(0, static_cast<std::uint32_t>(items_.size()));
  boxes_.reserve(items_.size());
  for (const std::uint32_t k : order_) {
    look_for_interrupt();
    boxes_.push_back(enclosing(std::span(&items_[k], 1), 0));
  }
}

/// A point beyond the doubles may be anywhere.
NearPoint EdgeTree::scaled(const NearPoint& point) const {
  if (!std::isfinite(point.low[0]) || !std::isfinite(point.low[1])) return {{}, infinite};
  return {{std::ldexp(point.low[0], exponent_), std::ldexp(point.low[1], exponent_), 0},
          std::ldexp(point.width, exponent_)};
}

EdgeTree::Item EdgeTree::item(const NearPoint& a, const NearPoint& b) {
  return {{a.low[0] / 2 + b.low[0] / 2, a.low[1] / 2 + b.low[1] / 2},
          {b.low[0] / 2 - a.low[0] / 2, b.low[1] / 2 - a.low[1] / 2},
          std::max(a.width, b.width)};
}

/// The rectangle lies along the direction of most items by their lengths: squares of complex
/// numbers do not tell opposite directions apart.
template <class Items>
EdgeTree::TurnedBox EdgeTree::enclosing(const Items& items, double reach) {
  double real = 0, imaginary = 0;
  for (const Item& e : items) {
    real += (e.half[0] - e.half[1]) * (e.half[0] + e.half[1]);
    imaginary += 2 * e.half[0] * e.half[1];
  }
  const double angle = std::atan2(imaginary, real) / 2;
  TurnedBox box{{infinite, infinite}, {-infinite, -infinite}, {}, {1, 0}, 0, 0};
  if (std::isfinite(angle)) box.along = {std::cos(angle), std::sin(angle)};
  Spot least{infinite, infinite}, most{-infinite, -infinite};  // along the rectangle, and across
  for (const Item& e : items) {
    const double far = reach + 2 * e.width;  // a diagonal of the doubt is shorter
    for (const std::size_t k : {0, 1}) {
      const double out = std::fabs(e.half[k]) + far;
      box.low[k] = std::min(box.low[k], e.middle[k] - out);
      box.high[k] = std::max(box.high[k], e.middle[k] + out);
    }
    const Spot at{along(box.along, e.middle), across(box.along, e.middle)};
    const Spot out{std::fabs(along(box.along, e.half)) + far,
                   std::fabs(across(box.along, e.half)) + far};
    for (const std::size_t k : {0, 1}) {
      least[k] = std::min(least[k], at[k] - out[k]);
      most[k] = std::max(most[k], at[k] + out[k]);
    }
  }
  const double length = (least[0] + most[0]) / 2, width = (least[1] + most[1]) / 2;
  box.middle = {length * box.along[0] - width * box.along[1],
                length * box.along[1] + width * box.along[0]};
  box.half_length = (most[0] - least[0]) / 2;
  box.half_width = (most[1] - least[1]) / 2;
  return box;
}

/// Tries lines along sides of both rectangles. NaN proves nothing.
bool EdgeTree::are_apart(const TurnedBox& a, const TurnedBox& b, double slack) {
  for (const std::size_t k : {0, 1}) {
    if (a.low[k] - b.high[k] > slack || b.low[k] - a.high[k] > slack) return true;
  }
  const Spot way{b.middle[0] - a.middle[0], b.middle[1] - a.middle[1]};
  const double cosine = std::fabs(along(a.along, b.along)),
               sine = std::fabs(across(a.along, b.along));
  const auto is_beyond = [&](double distance, double own, double other_length, double other_width) {
    return std::fabs(distance) > own + other_length + other_width + slack;
  };
  return is_beyond(across(a.along, way), a.half_width, b.half_length * sine,
                   b.half_width * cosine) ||
         is_beyond(across(b.along, way), b.half_width, a.half_length * sine,
                   a.half_width * cosine) ||
         is_beyond(along(a.along, way), a.half_length, b.half_length * cosine,
                   b.half_width * sine) ||
         is_beyond(along(b.along, way), b.half_length, a.half_length * cosine, a.half_width * sine);
}

void EdgeTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t at = nodes_.size();
  std::vector<Item> items;
  items.reserve(end - begin);
  for (std::uint32_t k = begin; k < end; ++k) {
    look_for_interrupt();
    items.push_back(items_[order_[k]]);
  }
  nodes_.push_back({enclosing(items, 0), begin, end, 0});
  if (end - begin <= leaf_size) return;
  const Spot direction = best_direction(begin, end, nodes_[at].box.along);
  std::vector<std::pair<double, std::uint32_t>> places;
  places.reserve(end - begin);
  for (std::uint32_t k = begin; k < end; ++k) {
    places.emplace_back(along(items_[order_[k]].middle, direction), order_[k]);
  }
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(places.begin(), places.begin() + (middle - begin), places.end());
  for (std::uint32_t k = begin; k < end; ++k) order_[k] = places[k - begin].second;
  build(begin, middle);
  nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

EdgeTree::Spot EdgeTree::best_direction(std::uint32_t begin, std::uint32_t end,
                                        const Spot& main) const {
  Spot best{1, 0};
  double most = -1;
  for (const Spot& direction : {Spot{1, 0}, Spot{0, 1}, main, Spot{-main[1], main[0]}}) {
    double least_place = infinite, greatest_place = -infinite, extents = 0;
    for (std::uint32_t k = begin; k < end; ++k) {
      const Item& e = items_[order_[k]];
      const double place = along(e.middle, direction);
      least_place = std::min(least_place, place);
      greatest_place = std::max(greatest_place, place);
      extents += std::fabs(along(e.half, direction));
    }
    const double spread = greatest_place - least_place;
    const double room = spread > 0 ? spread / (extents + 1e-12 * spread) : 0;
    if (room > most) most = room, best = direction;
  }
  return best;
}

void EdgeTree::pairs(const PairReport& report) const {
  if (!nodes_.empty()) within(0, report);
}

void EdgeTree::report_pair(std::uint32_t i, std::uint32_t j, const PairReport& report) const {
  look_for_interrupt();
  if (are_apart(boxes_[i], boxes_[j], unit_slack)) return;
  const auto [a, b] = std::minmax(order_[i], order_[j]);
  report(a, b);
}

void EdgeTree::within(std::uint32_t at, const PairReport& report) const {
  const Node& node = nodes_[at];
  if (!is_leaf(node)) {
    within(at + 1, report);
    within(node.right, report);
    return between(at + 1, node.right, report);
  }
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    for (std::uint32_t j = i + 1; j < node.end; ++j) report_pair(i, j, report);
  }
}

void EdgeTree::between(std::uint32_t first, std::uint32_t second, const PairReport& report) const {
  look_for_interrupt();
  const Node &a = nodes_[first], &b = nodes_[second];
  if (are_apart(a.box, b.box, unit_slack)) return;
  if (is_leaf(a) && is_leaf(b)) {
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
      for (std::uint32_t j = b.begin; j < b.end; ++j) report_pair(i, j, report);
    }
    return;
  }
  if (is_leaf(b) || (!is_leaf(a) && a.end - a.begin >= b.end - b.begin)) {
    between(first + 1, second, report);
    return between(a.right, second, report);
  }
  between(first, second + 1, report);
  between(first, b.right, report);
}

bool EdgeTree::near(const NearPoint& a, const NearPoint& b, double reach,
                    const std::function<bool(std::uint32_t)>& report) const {
  if (nodes_.empty()) return false;
  const Item about = item(scaled(a), scaled(b));
  const double far = std::ldexp(reach, exponent_);
  const TurnedBox box = enclosing(std::span(&about, 1), far);
  double size = 1 + far;
  for (const std::size_t k : {0, 1}) {
    size = std::max(size, std::fabs(about.middle[k]) + std::fabs(about.half[k]) + far);
  }
  const double slack = unit_slack * size;
  const auto look_at = [&](const auto& self, std::uint32_t at) -> bool {
    look_for_interrupt();
    const Node& node = nodes_[at];
    if (are_apart(node.box, box, slack)) return false;
    if (!is_leaf(node)) return self(self, at + 1) || self(self, node.right);
    for (std::uint32_t k = node.begin; k < node.end; ++k) {
      if (!are_apart(boxes_[k], box, slack) && report(order_[k])) return true;
    }
    return false;
  };
  return look_at(look_at, 0);
}

}  // namespace minkref
