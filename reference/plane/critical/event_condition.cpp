#include "reference/plane/critical/event_condition.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace minkref::inline plane {

bool NumberRange::holds(const Rational& value) const {
  if (low && (with_low ? value < *low : value <= *low)) return false;
  if (high && (with_high ? value > *high : value >= *high)) return false;
  return true;
}

EnclosedNumbers::EnclosedNumbers(const NumberRange& range) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  low_ = range.low ? enclose(*range.low) : Enclosure{-infinity, -infinity};
  high_ = range.high ? enclose(*range.high) : Enclosure{infinity, infinity};
}

std::optional<bool> EnclosedNumbers::in_range(double least, double greatest) const {
  if (greatest < low_.lower || least > high_.upper) return false;
  const bool above = least > low_.upper, below = greatest < high_.lower;
  if (above && below && least <= greatest) return true;
  return std::nullopt;
}

bool EdgePattern::matches(const ConvolutionEdge& e) const {
  return (!kind || *kind == e.kind) && (!edge || *edge == e.edge) &&
         (!vertex || *vertex == e.vertex);
}

bool EventCondition::has_word(std::string_view word) const {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool EventCondition::asks_place() const {
  return (test == Test::in_range && (field == "x" || field == "y")) ||
         std::any_of(conditions.begin(), conditions.end(),
                     [](const EventCondition& each) { return each.asks_place(); });
}

EventTest event_test(const EventCondition& condition,
                     const std::function<EventTest(const EventCondition&)>& of_field) {
  using Test = EventCondition::Test;
  if (condition.test != Test::all && condition.test != Test::any && condition.test != Test::none) {
    return of_field(condition);
  }
  std::vector<EventTest> tests;
  for (const bool places : {false, true}) {
    for (const EventCondition& each : condition.conditions) {
      if (each.asks_place() == places) tests.push_back(event_test(each, of_field));
    }
  }
  const bool all = condition.test == Test::all, none = condition.test == Test::none;
  return [tests = std::move(tests), all, none](std::size_t i) {
    for (const EventTest& test : tests) {
      if (test(i) != all) return !all && !none;
    }
    return all || none;
  };
}

std::vector<bool> matching_edges(const std::vector<ConvolutionEdge>& edges,
                                 const EdgePattern& pattern) {
  std::vector<bool> result;
  result.reserve(edges.size());
  for (const ConvolutionEdge& edge : edges) result.push_back(pattern.matches(edge));
  return result;
}

}  // namespace minkref::inline plane
