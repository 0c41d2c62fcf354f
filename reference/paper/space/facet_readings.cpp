#include "reference/paper/space/facet_readings.hpp"

#include <string>

namespace minkref::inline space {
namespace {

constexpr std::string_view of_plane = "plane-";

std::vector<ReadingName> all_names() {
  std::vector<ReadingName> names{
      {"corner", {"lines", "itself"}, "itself", "Section 5.1"},
      {"crossing", {"points", "determinant"}, "determinant", "Section 5.2"},
      {"solve",
       {"printed", "tolerance:EPS", "least-squares", "corrected"},
       "corrected",
       "Sections 5.1 and 5.2"},
      {"ends", {"sides", "lines"}, "sides", "Section 5.2"},
      {"parallel", {"followed", "left-out"}, "followed", "Section 5.2, parallel faces"},
      {"coplanar", {"turned", "dropped", "left-out"}, "dropped", "Section 5.2, coplanar faces"},
  };
  static const std::vector<std::string> prefixed = [] {
    std::vector<std::string> result;
    for (const ReadingName& reading : reading_names()) {
      result.push_back(std::string(of_plane) + std::string(reading.name));
    }
    return result;
  }();
  for (std::size_t i = 0; i < prefixed.size(); ++i) {
    if (prefixed[i] == "plane-order") continue;  // no list of intersections is kept
    ReadingName reading = reading_names()[i];
    reading.name = prefixed[i];
    names.push_back(std::move(reading));
  }
  return names;
}

}  // namespace

FacetReadings corrected_facet_readings() {
  FacetReadings result;
  for (const ReadingName& reading : facet_reading_names()) {
    set_reading(result, reading.name, reading.corrected);
  }
  return result;
}

FacetReadings facet_readings(Form form) {
  return form == Form::printed ? FacetReadings{} : corrected_facet_readings();
}

const std::vector<ReadingName>& facet_reading_names() {
  static const std::vector<ReadingName> names = all_names();
  return names;
}

void set_reading(FacetReadings& readings, std::string_view name, std::string_view value) {
  const auto choose = [&]<class Value>(Value& field, Words<Value> words) {
    choose_reading(facet_reading_names(), name, value, field, words);
  };
  using Corner = FacetReadings::Corner;
  using Crossing = FacetReadings::Crossing;
  using Ends = FacetReadings::Ends;
  using Parallel = FacetReadings::Parallel;
  using Coplanar = FacetReadings::Coplanar;
  if (name == "corner") {
    choose(readings.corner, {{"lines", Corner::lines}, {"itself", Corner::itself}});
  } else if (name == "crossing") {
    choose(readings.crossing,
           {{"points", Crossing::points}, {"determinant", Crossing::determinant}});
  } else if (name == "solve") {
    set_solve(readings.solve, readings.tolerance, facet_reading_names(), value);
  } else if (name == "ends") {
    choose(readings.ends, {{"sides", Ends::sides}, {"lines", Ends::lines}});
  } else if (name == "parallel") {
    choose(readings.parallel, {{"followed", Parallel::followed}, {"left-out", Parallel::left_out}});
  } else if (name == "coplanar") {
    choose(readings.coplanar, {{"turned", Coplanar::turned},
                               {"dropped", Coplanar::dropped},
                               {"left-out", Coplanar::left_out}});
  } else if (name.starts_with(of_plane) && name != "plane-order") {
    set_reading(readings.plane, name.substr(of_plane.size()), value);
  } else {
    refuse_reading(facet_reading_names(), name, value);
  }
}

}  // namespace minkref::inline space
