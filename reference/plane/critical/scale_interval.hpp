// The scales s > 0 at which several half-lines hold.
#pragma once

#include <optional>
#include <span>

#include "reference/plane/critical/pair_conditions.hpp"

namespace minkref::inline plane {

/// A closed interval within (0, infinity), named by its bounding half-lines. Without a lower bound
/// the interval goes down to 0 (excluded), without an upper bound to infinity.
template <class K>
struct ScaleInterval {
  struct Bound {
    int half_line;  ///< index of the first half-line with this bound
    typename K::Parameter scale;
  };
  bool empty = true;
  std::optional<Bound> lower, upper;

  bool is_point(const K& kernel) const {
    return !empty && lower && upper && kernel.compare(lower->scale, upper->scale) == 0;
  }
};

/// As exact as the kernel's signs.
template <class K>
ScaleInterval<K> intersection_of_half_lines(const K& kernel,
                                            std::span<const HalfLine<typename K::Wide>> lines) {
  using W = typename K::Wide;
  ScaleInterval<K> result;
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    const auto& [slope, value] = lines[static_cast<std::size_t>(i)];
    const int rises = kernel.sign(slope);
    if (rises == 0) {
      if (kernel.sign(value) < 0) return {};
      continue;
    }
    const int at_zero = kernel.sign(value);
    if (rises > 0) {
      if (at_zero >= 0) continue;  // holds for all s > 0
      const auto root = K::parameter(W(-value), slope);
      if (!result.lower || kernel.compare(root, result.lower->scale) > 0) result.lower = {i, root};
    } else {
      if (at_zero <= 0) return {};
      const auto root = K::parameter(value, W(-slope));
      if (!result.upper || kernel.compare(root, result.upper->scale) < 0) result.upper = {i, root};
    }
  }
  result.empty =
      result.lower && result.upper && kernel.compare(result.lower->scale, result.upper->scale) > 0;
  return result;
}

/// The scale at which a half-line with a slope begins or ends.
template <class K>
typename K::Parameter root_of(const K& kernel, const HalfLine<typename K::Wide>& line) {
  using W = typename K::Wide;
  return kernel.sign(line.slope) > 0 ? K::parameter(W(-line.value), line.slope)
                                     : K::parameter(line.value, W(-line.slope));
}

/// The printed rule (Behar & Lien 2012, Sec. 4.2.3), [max{B_a0, B_b0}, min{B_a1, B_b1}], on exact
/// roots: half-lines in the order of PairEnd. An end point without a root bounds nothing; nor does
/// a lower bound that is not positive.
template <class K>
ScaleInterval<K> printed_rule(const K& kernel,
                              const std::array<HalfLine<typename K::Wide>, 4>& lines) {
  ScaleInterval<K> result;
  for (const std::size_t i : {0, 2, 1, 3}) {
    const HalfLine<typename K::Wide>& line = lines[i];
    const int rises = kernel.sign(line.slope);
    if (rises == 0) continue;
    const bool positive = kernel.sign(line.value) * rises < 0;
    const bool is_lower = i % 2 == 0;
    if (!positive) {
      if (is_lower) continue;
      return {};
    }
    auto& bound = is_lower ? result.lower : result.upper;
    const auto root = root_of(kernel, line);
    const int order = bound ? kernel.compare(root, bound->scale) : 0;
    if (!bound || (is_lower ? order > 0 : order < 0)) bound = {static_cast<int>(i), root};
  }
  result.empty =
      result.lower && result.upper && kernel.compare(result.lower->scale, result.upper->scale) > 0;
  return result;
}

/// Whether both hold the same scales.
template <class K>
bool same_scales(const K& kernel, const ScaleInterval<K>& x, const ScaleInterval<K>& y) {
  if (x.empty || y.empty) return x.empty == y.empty;
  const auto same = [&](const auto& u, const auto& v) {
    return u.has_value() == v.has_value() && (!u || kernel.compare(u->scale, v->scale) == 0);
  };
  return same(x.lower, y.lower) && same(x.upper, y.upper);
}

}  // namespace minkref::inline plane
