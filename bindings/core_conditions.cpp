// Conditions on events for Python, and a search among rows.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "bindings/core.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/error.hpp"
#include "reference/plane/critical/event_condition.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using Test = EventCondition::Test;
using OptionalText = std::optional<std::string>;
using Vertex = std::optional<std::pair<std::uint32_t, std::uint32_t>>;

EventCondition joined(Test test, std::vector<EventCondition> conditions) {
  EventCondition result{test};
  result.conditions = std::move(conditions);
  return result;
}

EventCondition number(const std::string& field, const OptionalText& low, const OptionalText& high,
                      bool with_low, bool with_high) {
  EventCondition result{Test::in_range};
  result.field = field;
  if (low) result.range.low = parse_rational(*low);
  if (high) result.range.high = parse_rational(*high);
  result.range.with_low = with_low;
  result.range.with_high = with_high;
  return result;
}

EventCondition word(const std::string& field, const std::vector<std::string>& words) {
  EventCondition result{Test::one_of};
  result.field = field;
  result.words = words;
  return result;
}

EventCondition parent(const OptionalText& kind, const Vertex& edge, const Vertex& vertex) {
  const auto id = [](const Vertex& at) {
    return at ? std::optional(VertexId{at->first, at->second}) : std::nullopt;
  };
  EventCondition result{Test::has_edge};
  result.field = "parents";
  result.edge = {{}, id(edge), id(vertex)};
  if (kind) {
    result.edge.kind = *kind == "S" ? ConvolutionEdge::Kind::S : ConvolutionEdge::Kind::T;
  }
  return result;
}

EventCondition feature(const std::string& field, std::uint32_t number) {
  EventCondition result{Test::has_feature};
  result.field = field;
  result.feature = number;
  return result;
}

/// scale, rank, kind, change, parents, place; feature (or ""), before, after, parts.
using Row = std::tuple<std::string, std::uint32_t, std::string, std::string, std::vector<EdgeRow>,
                       ExactPoint, std::string, std::vector<std::uint32_t>,
                       std::vector<std::uint32_t>, std::uint32_t>;

ConvolutionEdge edge_of(const EdgeRow& row) {
  const auto& [kind, sign, edge_ring, edge, vertex_ring, vertex] = row;
  return {kind == "S" ? ConvolutionEdge::Kind::S : ConvolutionEdge::Kind::T,
          static_cast<std::int8_t>(sign),
          {edge_ring, edge},
          {vertex_ring, vertex}};
}

EventTest row_test(const std::vector<Row>& rows, const EventCondition& c) {
  const auto numbers = [&](const auto& number) -> EventTest {
    return [number, c](std::size_t i) { return c.range.holds(number(i)); };
  };
  const auto words = [&](const auto& word) -> EventTest {
    return [word, c](std::size_t i) { return c.has_word(word(i)); };
  };
  const auto features = [&](const auto& list) -> EventTest {
    return [list, c](std::size_t i) {
      const auto& all = list(i);
      return std::find(all.begin(), all.end(), c.feature) != all.end();
    };
  };
  if (c.field == "s") {
    return numbers([&](std::size_t i) { return parse_rational(std::get<0>(rows[i])); });
  }
  if (c.field == "rank")
    return numbers([&](std::size_t i) { return Rational(std::get<1>(rows[i])); });
  if (c.field == "x") {
    return numbers([&](std::size_t i) { return parse_rational(std::get<5>(rows[i]).first); });
  }
  if (c.field == "y") {
    return numbers([&](std::size_t i) { return parse_rational(std::get<5>(rows[i]).second); });
  }
  if (c.field == "parts") {
    return numbers([&](std::size_t i) { return Rational(std::get<9>(rows[i])); });
  }
  if (c.field == "kind") return words([&](std::size_t i) -> auto& { return std::get<2>(rows[i]); });
  if (c.field == "change")
    return words([&](std::size_t i) -> auto& { return std::get<3>(rows[i]); });
  if (c.field == "feature")
    return words([&](std::size_t i) -> auto& { return std::get<6>(rows[i]); });
  if (c.field == "before")
    return features([&](std::size_t i) -> auto& { return std::get<7>(rows[i]); });
  if (c.field == "after")
    return features([&](std::size_t i) -> auto& { return std::get<8>(rows[i]); });
  if (c.test == Test::has_edge) {
    return [&rows, c](std::size_t i) {
      const auto& edges = std::get<4>(rows[i]);
      return std::any_of(edges.begin(), edges.end(),
                         [&](const EdgeRow& row) { return c.edge.matches(edge_of(row)); });
    };
  }
  throw BadInput("unknown-field", "events have no \"" + c.field + "\"", "ask for another");
}

/// Whether each row meets the condition.
std::vector<bool> matching_rows(const std::vector<Row>& rows, const EventCondition& condition) {
  const EventTest test =
      event_test(condition, [&](const EventCondition& field) { return row_test(rows, field); });
  std::vector<bool> result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    look_for_interrupt();
    result.push_back(test(i));
  }
  return result;
}

}  // namespace

void bind_conditions(nb::module_& module) {
  nb::class_<EventCondition>(module, "EventCondition", "Which events are wanted; exact.")
      .def_static(
          "all", [](std::vector<EventCondition> c) { return joined(Test::all, std::move(c)); },
          "conditions"_a)
      .def_static(
          "any", [](std::vector<EventCondition> c) { return joined(Test::any, std::move(c)); },
          "conditions"_a)
      .def_static(
          "none", [](std::vector<EventCondition> c) { return joined(Test::none, std::move(c)); },
          "conditions"_a)
      .def_static("number", number, "field"_a, "low"_a, "high"_a, "with_low"_a, "with_high"_a,
                  "`s`, `rank`, `x`, `y` or `parts` lies between two bounds.")
      .def_static("word", word, "field"_a, "words"_a,
                  "`kind`, `change` or `feature` is one of these words.")
      .def_static("parent", parent, "kind"_a, "edge"_a, "vertex"_a,
                  "One of the parents is of this kind (S or T), edge and vertex (ring and index).")
      .def_static("feature", feature, "field"_a, "number"_a,
                  "`before` or `after` has this hole or component.");
  module.def(
      "matching_rows", matching_rows, "rows"_a, "condition"_a, Released(),
      "Which rows (scale, rank, kind, change, parents, place, feature or \"\", before, after, "
      "parts) meet a condition. Exact.");
}

}  // namespace minkref::python
