#include "tests/fuzzing/reference/scale_changes.hpp"

#include <algorithm>
#include <exception>

#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "tests/fuzzing/reference/pair_input.hpp"

namespace minkref::fuzzing {
namespace {

/// The most vertex pairs, from P and Q, for which all events are computed.
constexpr std::size_t most_pairs = 64;

Rational plain_scale(Dice& dice) {
  if (dice.one_in(8)) return power_of_two(dice.between(-40, 40));
  return Rational(dice.between(1, 12), dice.between(1, 8));
}

/// A scale at which the sum's boundary changes, or any event scale of the pair.
std::optional<Rational> event_of(Dice& dice, const Case& pair) {
  if (pair.P.empty() || pair.Q.empty()) return std::nullopt;
  if (dice.one_in(2) && pair.P.vertices() * pair.Q.vertices() <= most_pairs) {
    const DynamicSum dynamic(pair.P, pair.Q, {});
    const auto& groups = dynamic.states().groups();
    if (groups.empty()) return std::nullopt;
    return dynamic.states().timeline().events->exact(dice.of(groups));
  }
  const PairEvents events = pair_events(pair.P, pair.Q);
  const std::vector<Rational> scales = critical_scales(events, pair.P, pair.Q);
  if (scales.empty()) return std::nullopt;
  return dice.of(scales);
}

/// At an event, or a little beside it.
Rational scale_near_event(Dice& dice, const Case& pair) {
  std::optional<Rational> event;
  try {
    event = event_of(dice, pair);
  } catch (const std::exception&) {
    // A finding for the targets, which come to this pair themselves.
  }
  if (!event) return plain_scale(dice);
  const long bits[] = {4, 10, 40, 60, 70};
  switch (dice.below(4)) {
    case 0:
      return *event * (1 + power_of_two(-dice.of(bits)));
    case 1:
      return *event * (1 - power_of_two(-dice.of(bits)));
    default:
      return *event;
  }
}

void set_scale(Case& pair, const Rational& scale) {
  pair.interval.reset();
  pair.scales.assign(1, scale);
}

/// An interval with ends at events, or open.
void set_window(Dice& dice, Case& pair) {
  Rational from = scale_near_event(dice, pair), to = scale_near_event(dice, pair);
  if (to < from) std::swap(from, to);
  CaseInterval window;
  if (!dice.one_in(5)) window.from = from;
  if (!dice.one_in(5)) window.to = to;
  pair.scales.clear();
  pair.interval = window;
}

}  // namespace

void change_scale(Dice& dice, Case& pair) {
  switch (dice.below(8)) {
    case 0:
      return set_scale(pair, plain_scale(dice));
    case 1:
      return set_window(dice, pair);
    case 2:  // the scale becomes part of P
      pair.P = scaled(pair.P, scale_of(pair));
      return set_scale(pair, 1);
    case 3:
      return exchange_operands(pair);
    case 4:
      if (pair.interval || pair.scales.size() >= most_scales) return set_scale(pair, 1);
      return pair.scales.push_back(scale_near_event(dice, pair));
    default:
      return set_scale(pair, scale_near_event(dice, pair));
  }
}

void exchange_operands(Case& pair) {
  std::swap(pair.P, pair.Q);
  for (Rational& s : pair.scales) s = 1 / s;
  if (!pair.interval) return;
  CaseInterval inverse;
  if (pair.interval->to) inverse.from = 1 / *pair.interval->to;
  if (pair.interval->from) inverse.to = 1 / *pair.interval->from;
  pair.interval = inverse;
}

}  // namespace minkref::fuzzing
