// Conditions on single events, for searches through long lists.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/number/rational.hpp"
#include "reference/plane/convolution/convolution.hpp"

namespace minkref::inline plane {

/// The numbers between two bounds; a missing bound leaves the range endless.
struct NumberRange {
  std::optional<Rational> low, high;
  bool with_low = true, with_high = true;  ///< the bounds belong to it

  bool holds(const Rational& value) const;
};

/// A range for numbers that doubles enclose.
class EnclosedNumbers {
 public:
  explicit EnclosedNumbers(const NumberRange& range);

  /// True if the range holds every number of [least, greatest], false if none; empty if only some,
  /// if a bound is too near for doubles to tell, and for NaN.
  std::optional<bool> in_range(double least, double greatest) const;

 private:
  Enclosure low_, high_;
};

/// A pattern for convolution edges, from known parts of their parents.
struct EdgePattern {
  std::optional<ConvolutionEdge::Kind> kind;
  std::optional<VertexId> edge, vertex;

  bool matches(const ConvolutionEdge& e) const;
};

/// A condition: all, any or none of some conditions, or a condition on a field of the event.
struct EventCondition {
  enum class Test : std::uint8_t {
    all,
    any,
    none,
    in_range,     ///< the number of a field is in `range`: "s", "rank", "x", "y", "parts"
    one_of,       ///< the word of a field is one of `words`: "kind", "change", "feature"
    has_edge,     ///< one of the parents matches `edge`
    has_feature,  ///< the list "before" or "after" has `feature`
  } test = Test::all;
  std::vector<EventCondition> conditions = {};
  std::string field = {};
  NumberRange range = {};
  std::vector<std::string> words = {};
  EdgePattern edge = {};
  std::uint32_t feature = 0;

  bool has_word(std::string_view word) const;
  /// Whether the condition asks for an event's place, the slowest field.
  bool asks_place() const;
};

/// A test of the event at a list position.
using EventTest = std::function<bool(std::size_t)>;

/// The test of a condition; `of_field` gives the tests for conditions on a field. Tests of places
/// come last.
EventTest event_test(const EventCondition& condition,
                     const std::function<EventTest(const EventCondition&)>& of_field);

/// Tells each edge whether it matches.
std::vector<bool> matching_edges(const std::vector<ConvolutionEdge>& edges,
                                 const EdgePattern& pattern);

}  // namespace minkref::inline plane
