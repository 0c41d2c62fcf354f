#include "reference/paper/plane/readings.hpp"

#include "reference/error.hpp"

namespace minkref::inline plane {
namespace {

constexpr std::string_view tolerance_prefix = "tolerance:";

Rational tolerance_of(const std::vector<ReadingName>& known, std::string_view value) {
  try {
    Rational tolerance = parse_rational(value.substr(tolerance_prefix.size()));
    if (sign(tolerance) >= 0) return tolerance;
  } catch (const BadInput&) {  // no number: refused as a reading
  }
  refuse_reading(known, "solve", value);
}

}  // namespace

Readings corrected_readings() {
  Readings result;
  for (const ReadingName& reading : reading_names()) {
    set_reading(result, reading.name, reading.corrected);
  }
  return result;
}

const std::vector<ReadingName>& reading_names() {
  static const std::vector<ReadingName> names{
      {"observation", {"printed", "corrected"}, "corrected", "Section 4.1, Observation 1"},
      {"solve",
       {"printed", "tolerance:EPS", "least-squares", "corrected"},
       "corrected",
       "Sections 4.2.1 and 4.2.2"},
      {"interval", {"printed", "corrected"}, "corrected", "Section 4.2.3"},
      {"no-root", {"unbounded", "never"}, "unbounded", "Section 4.2.1"},
      {"order", {"kept", "sorted"}, "sorted", "Section 4.2.4"},
      {"parallel", {"left-out", "taken"}, "taken", "Section 4.2"},
      {"adjacent", {"left-out", "taken"}, "left-out", "Section 4.2.3"},
  };
  return names;
}

void set_solve(Readings::Solve& solve, Rational& tolerance, const std::vector<ReadingName>& known,
               std::string_view value) {
  using Solve = Readings::Solve;
  if (value.starts_with(tolerance_prefix)) {
    tolerance = tolerance_of(known, value);
    solve = Solve::tolerance;
    return;
  }
  choose_reading(known, "solve", value, solve,
                 {{"printed", Solve::printed},
                  {"least-squares", Solve::least_squares},
                  {"corrected", Solve::corrected}});
}

void set_reading(Readings& readings, std::string_view name, std::string_view value) {
  using NoRoot = Readings::NoRoot;
  using Order = Readings::Order;
  const auto choose = [&]<class Value>(Value& field, Words<Value> words) {
    choose_reading(reading_names(), name, value, field, words);
  };
  if (name == "observation") {
    choose(readings.observation, {{"printed", Form::printed}, {"corrected", Form::corrected}});
  } else if (name == "interval") {
    choose(readings.interval, {{"printed", Form::printed}, {"corrected", Form::corrected}});
  } else if (name == "solve") {
    set_solve(readings.solve, readings.tolerance, reading_names(), value);
  } else if (name == "no-root") {
    choose(readings.no_root, {{"unbounded", NoRoot::unbounded}, {"never", NoRoot::never}});
  } else if (name == "order") {
    choose(readings.order, {{"kept", Order::kept}, {"sorted", Order::sorted}});
  } else if (name == "parallel") {
    choose(readings.parallel, {{"left-out", false}, {"taken", true}});
  } else if (name == "adjacent") {
    choose(readings.adjacent, {{"left-out", false}, {"taken", true}});
  } else {
    refuse_reading(reading_names(), name, value);
  }
}

}  // namespace minkref::inline plane
