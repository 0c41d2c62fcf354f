#include "reference/motion/strip_polygon.hpp"

#include <algorithm>

namespace minkref::inline motion {
namespace {

/// A corner of the polygon; `far`: the common point at infinity of all lines of constant t.
struct Corner {
  Rational t, s;
  bool far = false;
  friend bool operator==(const Corner&, const Corner&) = default;
};

Rational value_at(const StripCondition& c, const Corner& corner) {
  if (corner.far) return c.s_slope;
  return c.t_slope * corner.t + c.s_slope * corner.s + c.constant;
}

Corner crossing(const Corner& a, const Rational& at_a, const Corner& b, const Rational& at_b) {
  if (a.far) return {b.t, b.s - at_b / at_a, false};
  if (b.far) return {a.t, a.s - at_a / at_b, false};
  const Rational part = at_a / (at_a - at_b);
  return {a.t + part * (b.t - a.t), a.s + part * (b.s - a.s), false};
}

}  // namespace

std::optional<StripPolygon> strip_polygon(const std::vector<StripCondition>& conditions,
                                          bool strict, bool is_point) {
  std::vector<Corner> polygon{{0, 0, false}};
  if (!is_point) polygon.push_back({1, 0, false});
  polygon.push_back({0, 0, true});
  std::vector<Rational> values;
  for (const StripCondition& condition : conditions) {
    values.clear();
    bool some_below = false;
    for (const Corner& corner : polygon) {
      values.push_back(value_at(condition, corner));
      some_below = some_below || values.back() < 0;
    }
    // A corner strictly below proves that a part of the inside lies below; otherwise no part does.
    if (strict && !some_below) return std::nullopt;
    std::vector<Corner> rest;
    const auto add = [&](Corner corner) {
      if (rest.empty() || !(rest.back() == corner)) rest.push_back(std::move(corner));
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t j = (i + 1) % polygon.size();
      if (values[i] <= 0) add(polygon[i]);
      if (sign(values[i]) * sign(values[j]) < 0) {
        add(crossing(polygon[i], values[i], polygon[j], values[j]));
      }
    }
    if (rest.size() > 1 && rest.front() == rest.back()) rest.pop_back();
    polygon = std::move(rest);
    if (std::all_of(polygon.begin(), polygon.end(), [](const Corner& c) { return c.far; })) {
      return std::nullopt;
    }
  }
  StripPolygon result;
  for (Corner& corner : polygon) {
    if (corner.far) {
      result.endless = true;
    } else {
      result.corners.push_back({std::move(corner.t), std::move(corner.s)});
    }
  }
  return result;
}

std::optional<Rational> least_place(const std::vector<StripCondition>& conditions,
                                    const Rational& scale, bool strict, bool is_point) {
  Rational low = 0, high = is_point ? 0 : 1;
  for (const StripCondition& c : conditions) {
    const Rational rest = c.s_slope * scale + c.constant;
    const int slope = is_point ? 0 : sign(c.t_slope);
    if (slope == 0) {
      if (strict ? rest >= 0 : rest > 0) return std::nullopt;
    } else if (slope > 0) {
      high = std::min(high, Rational(-rest / c.t_slope));
    } else {
      low = std::max(low, Rational(-rest / c.t_slope));
    }
  }
  // Strict conditions hold on an open interval, which has a part between 0 and 1 or none.
  const bool some = strict && !is_point ? low < high : low <= high;
  return some ? std::optional(low) : std::nullopt;
}

StripScales scales_of(const StripPolygon& polygon) {
  const StripPoint& first = polygon.corners[0];
  StripScales result{first.s, first.s, first.t, first.t};
  for (const StripPoint& corner : polygon.corners) {
    if (corner.s < result.from || (corner.s == result.from && corner.t < result.t_at_from)) {
      result.from = corner.s;
      result.t_at_from = corner.t;
    }
    if (corner.s > *result.to || (corner.s == *result.to && corner.t < result.t_at_to)) {
      result.to = corner.s;
      result.t_at_to = corner.t;
    }
  }
  if (polygon.endless) result.to.reset();
  return result;
}

}  // namespace minkref::inline motion
