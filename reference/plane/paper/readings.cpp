#include "reference/plane/paper/readings.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

namespace minkref::inline plane {
namespace {

constexpr std::string_view tolerance_prefix = "tolerance:";

double tolerance_of(std::string_view name, std::string_view value) {
  const std::string text(value.substr(tolerance_prefix.size()));
  char* end = nullptr;
  const double tolerance = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(tolerance) || tolerance < 0) {
    refuse_reading(reading_names(), name, value);
  }
  return tolerance;
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

void set_reading(Readings& readings, std::string_view name, std::string_view value) {
  const auto choose = [&](auto& field, auto&& words) {
    for (const auto& [word, meaning] : words) {
      if (value == word) {
        field = meaning;
        return;
      }
    }
    refuse_reading(reading_names(), name, value);
  };
  using Word = std::string_view;
  using Forms = std::vector<std::pair<Word, Form>>;
  using Taken = std::vector<std::pair<Word, bool>>;
  if (name == "observation") {
    choose(readings.observation, Forms{{"printed", Form::printed}, {"corrected", Form::corrected}});
  } else if (name == "interval") {
    choose(readings.interval, Forms{{"printed", Form::printed}, {"corrected", Form::corrected}});
  } else if (name == "solve") {
    using Solve = Readings::Solve;
    if (value.starts_with(tolerance_prefix)) {
      readings.tolerance = tolerance_of(name, value);
      readings.solve = Solve::tolerance;
      return;
    }
    choose(readings.solve,
           std::vector<std::pair<Word, Solve>>{{"printed", Solve::printed},
                                               {"least-squares", Solve::least_squares},
                                               {"corrected", Solve::corrected}});
  } else if (name == "no-root") {
    choose(readings.no_root,
           std::vector<std::pair<Word, Readings::NoRoot>>{
               {"unbounded", Readings::NoRoot::unbounded}, {"never", Readings::NoRoot::never}});
  } else if (name == "order") {
    choose(readings.order,
           std::vector<std::pair<Word, Readings::Order>>{{"kept", Readings::Order::kept},
                                                         {"sorted", Readings::Order::sorted}});
  } else if (name == "parallel") {
    choose(readings.parallel, Taken{{"left-out", false}, {"taken", true}});
  } else if (name == "adjacent") {
    choose(readings.adjacent, Taken{{"left-out", false}, {"taken", true}});
  } else {
    refuse_reading(reading_names(), name, value);
  }
}

}  // namespace minkref::inline plane
