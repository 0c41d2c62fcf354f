#include "reference/paper/space/update_readings.hpp"

#include <algorithm>

namespace minkref::inline space {

SpaceUpdateReadings corrected_space_update_readings() {
  SpaceUpdateReadings result;
  for (const ReadingName& reading : space_update_reading_names()) {
    set_reading(result, reading.name, reading.corrected);
  }
  return result;
}

const std::vector<ReadingName>& space_update_reading_names() {
  static const std::vector<ReadingName> names = [] {
    std::vector<ReadingName> all = facet_reading_names();
    all.push_back({"bounds", {"checked", "joint"}, "joint", "Section 5.1"});
    all.push_back({"singular", {"determinant", "directions"}, "directions", "Section 5.2"});
    return all;
  }();
  return names;
}

void set_reading(SpaceUpdateReadings& readings, std::string_view name, std::string_view value) {
  using Bounds = SpaceUpdateReadings::Bounds;
  using Singular = SpaceUpdateReadings::Singular;
  const auto& known = facet_reading_names();
  if (name == "bounds") {
    choose_reading(space_update_reading_names(), name, value, readings.bounds,
                   Words<Bounds>{{"checked", Bounds::checked}, {"joint", Bounds::joint}});
  } else if (name == "singular") {
    choose_reading(space_update_reading_names(), name, value, readings.singular,
                   Words<Singular>{{"determinant", Singular::determinant},
                                   {"directions", Singular::directions}});
  } else if (std::any_of(known.begin(), known.end(),
                         [&](const ReadingName& reading) { return reading.name == name; })) {
    set_reading(readings.events, name, value);
  } else {
    refuse_reading(space_update_reading_names(), name, value);
  }
}

}  // namespace minkref::inline space
