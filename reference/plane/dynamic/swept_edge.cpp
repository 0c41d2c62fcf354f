#include "reference/plane/dynamic/swept_edge.hpp"

#include <cmath>

#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"
#include "reference/plane/moving/double_range.hpp"

namespace minkref::inline plane {
namespace {

/// The sign of x - y; 0 if doubles cannot tell. `terms`: the sum of all summands of both.
int sign_of_difference(double x, double y, double terms) {
  const double bound = terms * 2 * filter_bound + 1e-300;
  return x - y > bound ? 1 : x - y < -bound ? -1 : 0;
}

}  // namespace

SweptEdge::SweptEdge(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events)
    : events_(events), arithmetic_(node_arithmetic(P, Q, events)) {}

void SweptEdge::load(std::uint32_t edge) {
  edge_ = edge;
  begin_ = events_.table().begin(edge);
  count_ = events_.table().end(edge) - begin_;
  arithmetic_->columns(edge, slope_, value_);
  const bool is_s = moving().is_s();
  slope_.insert(slope_.end(), {0.0, is_s ? 1.0 : 0.0});
  value_.insert(value_.end(), {0.0, is_s ? 0.0 : 1.0});
}

PositionAlong<Rational> SweptEdge::position(std::uint32_t local) const {
  if (local == start()) return {};
  if (local == end()) {
    return moving().is_s() ? PositionAlong<Rational>{1, 0, 1} : PositionAlong<Rational>{0, 1, 1};
  }
  return node_position(PlainKernel<Rational>{}, events_.moving(), edge_, node(local));
}

Rational SweptEdge::along(std::uint32_t local, const Rational& scale) const {
  const PositionAlong<Rational> p = position(local);
  return (p.slope * scale + p.value) / p.den;
}

Point SweptEdge::middle(std::uint32_t x, std::uint32_t y, const Rational& scale) const {
  const Rational half_way = (along(x, scale) + along(y, scale)) / 2;
  const RationalEdge& e = moving();
  return {e.p.x() * scale + e.q.x() + e.d.x() * half_way,
          e.p.y() * scale + e.q.y() + e.d.y() * half_way};
}

int SweptEdge::compare_in_doubles(std::uint32_t x, std::uint32_t y, double s) const {
  return sign_of_difference(near(x, s), near(y, s), terms(x, s) + terms(y, s));
}

int SweptEdge::compare_at_group(std::uint32_t x, std::uint32_t y, std::uint32_t group) {
  if (x == y) return 0;
  const double s = events_.approximate(group);
  const int sign = in_filter_range(s) ? compare_in_doubles(x, y, s) : 0;
  if (sign != 0) return sign;
  if (exact_group_ != group) {
    exact_group_ = group;
    exact_scale_ = arithmetic_->scale(group);
  }
  return arithmetic_->compare(edge_, name(x), name(y), exact_scale_);
}

int SweptEdge::compare_at(std::uint32_t x, std::uint32_t y, const Rational& scale,
                          double near_scale) const {
  const bool filtered = in_filter_range(near_scale) || scale == 0;
  const int sign = filtered ? compare_in_doubles(x, y, near_scale) : 0;
  return sign != 0 ? sign : minkref::sign(Rational(along(x, scale) - along(y, scale)));
}

int SweptEdge::compare_slopes(std::uint32_t x, std::uint32_t y) const {
  const int sign =
      sign_of_difference(slope_[x], slope_[y], std::abs(slope_[x]) + std::abs(slope_[y]));
  return sign != 0 ? sign : arithmetic_->compare_slopes(edge_, name(x), name(y));
}

bool SweptEdge::before_after_meeting(std::uint32_t x, std::uint32_t y) const {
  if (x == y) return false;
  if (x == start() || y == end()) return true;
  if (y == start() || x == end()) return false;
  const int order = compare_slopes(x, y);
  return order != 0 ? order < 0 : x < y;
}

bool SweptEdge::same_track(std::uint32_t x, std::uint32_t y) const {
  if (sign_of_difference(slope_[x], slope_[y], std::abs(slope_[x]) + std::abs(slope_[y])) != 0 ||
      sign_of_difference(value_[x], value_[y], std::abs(value_[x]) + std::abs(value_[y])) != 0) {
    return false;
  }
  return arithmetic_->same_track(edge_, name(x), name(y));
}

}  // namespace minkref::inline plane
