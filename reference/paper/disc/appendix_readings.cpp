#include "reference/paper/disc/appendix_readings.hpp"

namespace minkref::inline disc {

const std::vector<ReadingName>& appendix_reading_names() {
  constexpr std::string_view segments = "Appendix, line segments with line segments",
                             arcs = "Appendix, arcs with arcs",
                             both = "Appendix, arcs with line segments";
  static const std::vector<ReadingName> names{
      {"rejected", {"printed", "corrected"}, "corrected", segments},
      {"number", {"printed", "corrected"}, "corrected", segments},
      {"parallel", {"left-out", "taken"}, "taken", segments},
      {"solve", {"printed", "corrected"}, "corrected", "Appendix"},
      {"radical", {"printed", "corrected"}, "corrected", arcs},
      {"middle", {"added", "left-out"}, "added", arcs},
      {"height", {"left-out", "added"}, "left-out", arcs},
      {"line", {"printed", "corrected"}, "corrected", both},
      {"normal", {"outward", "from-origin"}, "outward", segments},
      {"points", {"convolution", "polygon"}, "convolution", segments},
  };
  return names;
}

AppendixReadings corrected_appendix() {
  AppendixReadings result;
  for (const ReadingName& reading : appendix_reading_names()) {
    set_reading(result, reading.name, reading.corrected);
  }
  return result;
}

DiscReadings event_readings(const AppendixReadings& readings) {
  return {readings.rejected, readings.number, readings.radical, readings.line,
          readings.parallel ? Form::corrected : Form::printed};
}

void set_reading(AppendixReadings& readings, std::string_view name, std::string_view value) {
  const auto choose = [&]<class Value>(Value& field, Words<Value> words) {
    choose_reading(appendix_reading_names(), name, value, field, words);
  };
  const auto choose_form = [&](Form& field) {
    choose(field, {{"printed", Form::printed}, {"corrected", Form::corrected}});
  };
  if (name == "rejected") {
    choose_form(readings.rejected);
  } else if (name == "number") {
    choose_form(readings.number);
  } else if (name == "parallel") {
    choose(readings.parallel, {{"left-out", false}, {"taken", true}});
  } else if (name == "solve") {
    choose_form(readings.solve);
  } else if (name == "radical") {
    choose_form(readings.radical);
  } else if (name == "middle") {
    choose(readings.from_middle, {{"added", true}, {"left-out", false}});
  } else if (name == "height") {
    choose(readings.with_height, {{"left-out", false}, {"added", true}});
  } else if (name == "line") {
    choose_form(readings.line);
  } else if (name == "normal") {
    choose(readings.from_origin, {{"outward", false}, {"from-origin", true}});
  } else if (name == "points") {
    choose(readings.of_polygon, {{"convolution", false}, {"polygon", true}});
  } else {
    refuse_reading(appendix_reading_names(), name, value);
  }
}

}  // namespace minkref::inline disc
