#include "reference/paper/space/repair_readings.hpp"

namespace minkref::inline space {

RepairReadings corrected_repair_readings() {
  RepairReadings result;
  for (const ReadingName& reading : repair_reading_names()) {
    set_reading(result, reading.name, reading.corrected);
  }
  return result;
}

const std::vector<ReadingName>& repair_reading_names() {
  static const std::vector<ReadingName> names{
      {"degree", {"printed", "corrected"}, "corrected", "Section 6, IC(f, v)"},
      {"test", {"sides", "degree"}, "sides", "Section 6, fv-errors"},
      {"errors", {"facets-of-P", "chains-from-P", "both"}, "both", "Section 6, Theorem 1"},
      {"search",
       {"ee-errors", "beside-errors", "everywhere"},
       "everywhere",
       "Section 6, chains of ee-errors"},
      {"ties", {"closed", "open", "perturbed"}, "perturbed", "Section 6, Gaussian maps"},
  };
  return names;
}

void set_reading(RepairReadings& readings, std::string_view name, std::string_view value) {
  const auto choose = [&]<class Value>(Value& field, Words<Value> words) {
    choose_reading(repair_reading_names(), name, value, field, words);
  };
  using Test = RepairReadings::Test;
  using Errors = RepairReadings::Errors;
  using Search = RepairReadings::Search;
  using Ties = RepairReadings::Ties;
  if (name == "degree") {
    choose(readings.degree, {{"printed", Form::printed}, {"corrected", Form::corrected}});
  } else if (name == "test") {
    choose(readings.test, {{"sides", Test::sides}, {"degree", Test::degree}});
  } else if (name == "errors") {
    choose(readings.errors, {{"facets-of-P", Errors::facets_of_P},
                             {"chains-from-P", Errors::chains_from_P},
                             {"both", Errors::both}});
  } else if (name == "search") {
    choose(readings.search, {{"ee-errors", Search::ee_errors},
                             {"beside-errors", Search::beside_errors},
                             {"everywhere", Search::everywhere}});
  } else if (name == "ties") {
    choose(readings.ties,
           {{"closed", Ties::closed}, {"open", Ties::open}, {"perturbed", Ties::perturbed}});
  } else {
    refuse_reading(repair_reading_names(), name, value);
  }
}

}  // namespace minkref::inline space
