// Windows for indexing, scales to ask about, and index sums compared with static sums.
#pragma once

#include "reference/plane/index/scale_index.hpp"
#include "reference/plane/sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing {

inline ScaleWindow some_window(const Case& c) {
  if (c.scale == 1) return {};
  if (c.scale == 2) return {Rational(1, 3), std::nullopt};
  return {c.scale / 2, c.scale * 3};
}

/// All events, a scale in each interval between two, and beyond the last ones.
inline std::vector<Rational> telling_scales(const ScaleIndex& index) {
  std::vector<Rational> events;
  const ScaleWindow& window = index.window();
  for (std::uint32_t k = 0; k < index.events(); ++k) {
    Rational s = index.event(k);
    if ((window.from && s < *window.from) || (window.to && s > *window.to)) continue;
    events.push_back(std::move(s));
  }
  std::vector<Rational> scales;
  for (std::size_t k = 0; k < events.size(); ++k) {
    scales.push_back(events[k]);
    if (k + 1 < events.size()) scales.push_back((events[k] + events[k + 1]) / 2);
  }
  const Rational first = events.empty() ? window.to.value_or(Rational(2)) : events.front(),
                 last = events.empty() ? window.from.value_or(Rational(1)) : events.back();
  scales.push_back(window.from ? (*window.from + first) / 2 : first / 2);
  scales.push_back(window.to ? (*window.to + last) / 2 : last * 2);
  if (window.from) scales.push_back(*window.from);
  if (window.to) scales.push_back(*window.to);
  return scales;
}

/// Empty iff `found` is the sum at the scale.
inline std::string fault_of_sum(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
                                const Sum& found) {
  const Sum expected = minkowski_sum(P, Q, scale);
  if (found.region == expected.region && found.components == expected.components &&
      found.holes == expected.holes) {
    return "";
  }
  return "at scale " + to_string(scale) + ": " + unequal(expected.region, found.region);
}

}  // namespace minkref::testing
