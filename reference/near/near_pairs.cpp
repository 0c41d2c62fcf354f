#include "reference/near/near_pairs.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t least_fan = 16;

}  // namespace

NearPairs::NearPairs(std::vector<NearPoint> points, std::vector<NearItem> items)
    : points_(std::move(points)), items_(std::move(items)), order_(items_.size()) {
  scale_to_unit();
  std::iota(order_.begin(), order_.end(), 0U);
  find_fans();
  if (!items_.empty()) build(0, static_cast<std::uint32_t>(items_.size()));
}

/// By a power of two, which is exact: squares and cubes of lengths stay in the range of doubles.
void NearPairs::scale_to_unit() {
  double most = 0;
  for (NearPoint& p : points_) {
    const bool is_far =
        std::any_of(p.low.begin(), p.low.end(), [](double c) { return !std::isfinite(c); });
    if (is_far) p = {{}, infinity};  // anywhere
    for (const double c : p.low) most = std::max(most, std::fabs(c));
  }
  if (!(most > 0)) return;
  const int exponent = -std::ilogb(most);
  for (NearPoint& p : points_) {
    for (double& c : p.low) c = std::ldexp(c, exponent);
    p.width = std::ldexp(p.width, exponent);
  }
}

/// Where groups are many, most use the fan of their point; a large group stands alone.
void NearPairs::find_fans() {
  std::vector<std::uint32_t> degree(points_.size()), last(points_.size(), UINT32_MAX);
  std::vector<std::uint32_t> first_of_group;
  for (std::uint32_t i = 0; i < items_.size(); ++i) {
    look_for_interrupt();
    if (i == 0 || items_[i].group != items_[i - 1].group) first_of_group.push_back(i);
    for (const std::uint32_t p : items_[i].corners) {
      if (std::exchange(last[p], items_[i].group) != items_[i].group) ++degree[p];
    }
  }
  first_of_group.push_back(static_cast<std::uint32_t>(items_.size()));
  const auto count = static_cast<std::uint32_t>(points_.size());
  for (std::uint32_t g = 0; g + 1 < first_of_group.size(); ++g) {
    const std::uint32_t begin = first_of_group[g], end = first_of_group[g + 1];
    std::uint32_t middle = items_[begin].corners[0];
    for (std::uint32_t i = begin; i < end; ++i) {
      for (const std::uint32_t p : items_[i].corners) {
        if (degree[p] > degree[middle]) middle = p;
      }
    }
    const bool in_fan = degree[middle] >= least_fan && end - begin < least_fan;
    fan_.insert(fan_.end(), end - begin, in_fan ? middle : count + g);
  }
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return fan_[a] < fan_[b]; });
}

void NearPairs::build(std::uint32_t begin, std::uint32_t end) {
  look_for_interrupt_now();
  const std::size_t at = nodes_.size();
  Node& node = nodes_.emplace_back();
  node.begin = begin;
  node.end = end;
  const auto group = [&](std::uint32_t k) { return items_[order_[k]].group; };
  bool is_one_group = true;
  for (std::uint32_t k = begin + 1; k < end && is_one_group; ++k) {
    is_one_group = group(k) == group(begin);
  }
  if (is_one_group) node.group = group(begin);
  enclose(node);
  if (end - begin <= leaf_size) return;
  const std::uint32_t middle = split(begin, end);
  build(begin, middle);
  nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

void NearPairs::enclose(Node& node) const {
  for (std::uint32_t k = node.begin; k < node.end; ++k) {
    const auto& corners = items_[order_[k]].corners;
    node.points.insert(node.points.end(), corners.begin(), corners.end());
  }
  std::sort(node.points.begin(), node.points.end());
  node.points.erase(std::unique(node.points.begin(), node.points.end()), node.points.end());
  node.box = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const std::uint32_t p : node.points) {
    const auto& [low, width] = points_[p];
    for (std::size_t k = 0; k < 3; ++k) {
      node.box.low[k] = std::min(node.box.low[k], std::nextafter(low[k] - width, -infinity));
      node.box.high[k] = std::max(node.box.high[k], std::nextafter(low[k] + width, infinity));
    }
  }
}

double NearPairs::position(std::uint32_t item, const NearVector& along) const {
  double sum = 0;
  for (const std::uint32_t p : items_[item].corners) sum += dot(points_[p].low, along);
  return sum;
}

NearPairs::Units NearPairs::units_in(std::uint32_t begin, std::uint32_t end) const {
  const std::uint32_t first = order_[begin], last = order_[end - 1];
  const bool by_fan = fan_[first] != fan_[last],
             by_group = items_[first].group != items_[last].group;
  Units units;
  for (std::uint32_t k = begin; k < end; ++k) {
    const std::uint32_t item = order_[k], before = order_[k > begin ? k - 1 : k];
    const bool same = by_fan     ? fan_[item] == fan_[before]
                      : by_group ? items_[item].group == items_[before].group
                                 : false;
    if (k == begin || !same) units.emplace_back();
    units.back().push_back(item);
  }
  return units;
}

std::uint32_t NearPairs::split(std::uint32_t begin, std::uint32_t end) {
  const Units units = units_in(begin, end);
  const NearVector along = best_direction(units);
  std::vector<std::pair<double, std::size_t>> places;
  for (std::size_t u = 0; u < units.size(); ++u) {
    double sum = 0;
    for (const std::uint32_t item : units[u]) sum += position(item, along);
    places.emplace_back(sum / static_cast<double>(units[u].size()), u);
  }
  std::sort(places.begin(), places.end());
  // Half of the items, but at least one unit on each side.
  std::uint32_t at = begin, middle = begin;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (k > 0 && (middle == begin || at - begin <= (end - begin) / 2)) middle = at;
    for (const std::uint32_t item : units[places[k].second]) order_[at++] = item;
  }
  return middle;
}

NearVector NearPairs::best_direction(const Units& units) const {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const auto& unit : units) {
    for (const std::uint32_t item : unit) {
      const auto& corners = items_[item].corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const NearVector &a = points_[corners[k]].low, &b = points_[corners[(k + 1) % 3]].low;
        const Eigen::Vector3d edge(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        moments += edge * edge.transpose();
      }
    }
  }
  std::vector<NearVector> directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = solver.eigenvectors().col(k);
    directions.push_back({axis[0], axis[1], axis[2]});
  }
  NearVector best = directions[0];
  double most = -1;
  for (const NearVector& along : directions) {
    double least_place = infinity, greatest_place = -infinity, extents = 0;
    for (const auto& unit : units) {
      double low = infinity, high = -infinity, place = 0;
      for (const std::uint32_t item : unit) {
        for (const std::uint32_t p : items_[item].corners) {
          const double height = dot(points_[p].low, along);
          low = std::min(low, height);
          high = std::max(high, height);
          place += height / (3.0 * static_cast<double>(unit.size()));
        }
      }
      least_place = std::min(least_place, place);
      greatest_place = std::max(greatest_place, place);
      extents += high - low;
    }
    const double spread = greatest_place - least_place;
    const double room = spread > 0 ? spread / (extents + 1e-12 * spread) : 0;
    if (room > most) most = room, best = along;
  }
  return best;
}

void NearPairs::pairs(const Report& report) const {
  if (!nodes_.empty()) within(0, report);
}

void NearPairs::report_pair(std::uint32_t i, std::uint32_t j, const Report& report) const {
  look_for_interrupt();
  const std::uint32_t a = order_[i], b = order_[j];
  if (items_[a].group != items_[b].group) report(std::min(a, b), std::max(a, b));
}

void NearPairs::within(std::uint32_t at, const Report& report) const {
  const Node& node = nodes_[at];
  if (node.group) return;
  if (!is_leaf(node)) {
    within(at + 1, report);
    within(node.right, report);
    return between(at + 1, node.right, report);
  }
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    for (std::uint32_t j = i + 1; j < node.end; ++j) report_pair(i, j, report);
  }
}

void NearPairs::between(std::uint32_t first, std::uint32_t second, const Report& report) const {
  look_for_interrupt_now();
  const Node &a = nodes_[first], &b = nodes_[second];
  if (a.group && a.group == b.group) return;
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.box.low[k] > b.box.high[k] || b.box.low[k] > a.box.high[k]) return;
  }
  const std::uint32_t a_size = a.end - a.begin, b_size = b.end - b.begin;
  if (are_apart_but_for_a_common_point(points_, a.points, b.points)) return;
  if (is_leaf(a) && is_leaf(b)) {
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
      for (std::uint32_t j = b.begin; j < b.end; ++j) report_pair(i, j, report);
    }
    return;
  }
  if (is_leaf(b) || (!is_leaf(a) && a_size >= b_size)) {
    between(first + 1, second, report);
    return between(a.right, second, report);
  }
  between(first, second + 1, report);
  between(first, b.right, report);
}

}  // namespace minkref
