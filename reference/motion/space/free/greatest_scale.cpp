#include "reference/motion/space/free/greatest_scale.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/space/definition/exact_vectors.hpp"

namespace minkref::inline space {
namespace {

constexpr std::size_t unknowns = 4;  // the place, and the scale
using Row = std::array<Rational, unknowns>;

Row row_of(const ScaleCondition& condition) {
  return {condition.normal.x, condition.normal.y, condition.normal.z, condition.reach};
}

/// Solves `rows` x = `right`. Throws for dependent rows.
Row solved(std::array<Row, unknowns> rows, Row right) {
  for (std::size_t k = 0; k < unknowns; ++k) {
    std::size_t pivot = k;
    while (pivot < unknowns && rows[pivot][k] == 0) ++pivot;
    if (pivot == unknowns) throw std::logic_error("the rows of a linear program are dependent");
    std::swap(rows[pivot], rows[k]);
    std::swap(right[pivot], right[k]);
    for (std::size_t i = 0; i < unknowns; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < unknowns; ++j) rows[i][j] -= factor * rows[k][j];
      right[i] -= factor * right[k];
    }
  }
  for (std::size_t k = 0; k < unknowns; ++k) right[k] /= rows[k][k];
  return right;
}

std::array<Row, unknowns> transposed(const std::array<Row, unknowns>& rows) {
  std::array<Row, unknowns> result;
  for (std::size_t i = 0; i < unknowns; ++i) {
    for (std::size_t j = 0; j < unknowns; ++j) result[j][i] = rows[i][j];
  }
  return result;
}

/// Four conditions, met with equality at one place and scale; the scale is the greatest under them.
class Basis {
 public:
  Basis(const std::vector<ScaleCondition>& conditions, const std::array<ScaleCondition, 4>& start)
      : conditions_(conditions), start_(start), chosen_{0, 1, 2, 3} {}

  /// Exchanges a condition for the first unmet condition, until all hold.
  GreatestScale run() {
    while (true) {
      look_for_interrupt();
      const Row corner = solved(rows(), offsets());
      const auto broken = first_broken(corner);
      if (!broken) return result(corner);
      exchange(*broken);
    }
  }

 private:
  const ScaleCondition& condition(std::size_t k) const {
    return k < unknowns ? start_[k] : conditions_[k - unknowns];
  }
  std::array<Row, unknowns> rows() const {
    std::array<Row, unknowns> result;
    for (std::size_t k = 0; k < unknowns; ++k) result[k] = row_of(condition(chosen_[k]));
    return result;
  }
  Row offsets() const {
    Row result;
    for (std::size_t k = 0; k < unknowns; ++k) result[k] = condition(chosen_[k]).offset;
    return result;
  }
  Row weights() const { return solved(transposed(rows()), {0, 0, 0, 1}); }

  std::optional<std::size_t> first_broken(const Row& corner) const {
    const SpacePoint at{corner[0], corner[1], corner[2]};
    for (std::size_t k = 0; k < unknowns + conditions_.size(); ++k) {
      const ScaleCondition& one = condition(k);
      if (dot(one.normal, at) + one.reach * corner[3] > one.offset) return k;
    }
    return std::nullopt;
  }

  /// Bland's rule: among the conditions whose weight vanishes first, the first one leaves.
  void exchange(std::size_t entering) {
    const Row weight = weights();
    const Row share = solved(transposed(rows()), row_of(condition(entering)));
    std::optional<std::size_t> leaving;
    Rational least;
    for (std::size_t k = 0; k < unknowns; ++k) {
      if (share[k] <= 0) continue;
      Rational ratio = weight[k] / share[k];
      if (leaving && (ratio > least || (ratio == least && chosen_[*leaving] < chosen_[k])))
        continue;
      leaving = k;
      least = std::move(ratio);
    }
    if (!leaving) throw std::logic_error("no place meets the conditions of a linear program");
    chosen_[*leaving] = entering;
  }

  GreatestScale result(const Row& corner) const {
    GreatestScale found{corner[3], {corner[0], corner[1], corner[2]}, {}};
    const Row weight = weights();
    Row sum{0, 0, 0, 0};
    Rational bound = 0;
    for (std::size_t k = 0; k < unknowns; ++k) {
      if (weight[k] < 0) throw std::logic_error("a negative weight in a linear program");
      if (weight[k] == 0) continue;
      const ScaleCondition& one = condition(chosen_[k]);
      const Row row = row_of(one);
      for (std::size_t j = 0; j < unknowns; ++j) sum[j] += weight[k] * row[j];
      bound += weight[k] * one.offset;
      if (chosen_[k] < unknowns) {
        found.is_by_start = true;
      } else {
        found.weights.push_back({chosen_[k] - unknowns, weight[k]});
      }
    }
    if (sum != Row{0, 0, 0, 1} || bound != found.scale) {
      throw std::logic_error("the weights of a linear program prove another scale");
    }
    std::sort(found.weights.begin(), found.weights.end(),
              [](const auto& a, const auto& b) { return a.condition < b.condition; });
    return found;
  }

  const std::vector<ScaleCondition>& conditions_;
  const std::array<ScaleCondition, 4>& start_;
  std::array<std::size_t, unknowns> chosen_;  ///< the first four numbers are those of the start
};

Rational along(const SpacePoint& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

SpacePoint unit(std::size_t axis, int direction) {
  return {axis == 0 ? direction : 0, axis == 1 ? direction : 0, axis == 2 ? direction : 0};
}

}  // namespace

GreatestScale greatest_scale(const std::vector<ScaleCondition>& conditions,
                             const std::array<ScaleCondition, 4>& start) {
  return Basis(conditions, start).run();
}

std::array<ScaleCondition, 4> box_conditions(std::size_t axis, const SpacePoint& low,
                                             const SpacePoint& high, const SpacePoint& least,
                                             const SpacePoint& greatest) {
  const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
  const auto upper = [&](std::size_t k) {
    return ScaleCondition{unit(k, 1), along(high, k), along(greatest, k) + 1};
  };
  const ScaleCondition lower{unit(axis, -1), -along(low, axis), 1 - along(least, axis)};
  return {upper(axis), lower, upper(second), upper(third)};
}

}  // namespace minkref::inline space
