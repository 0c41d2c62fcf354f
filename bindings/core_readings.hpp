// The readings of the paper, across Python's border.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "reference/paper/reading_name.hpp"

namespace minkref::python {

/// Readings by name. Omitted readings are the printed ones.
using Words = std::map<std::string, std::string>;

template <class Readings>
Readings readings_of(const Words& words) {
  Readings readings;
  for (const auto& [name, value] : words) set_reading(readings, name, value);
  return readings;
}

template <class Readings>
void bind_reading_check(nanobind::module_& module, const char* check) {
  module.def(
      check,
      [](const std::string& name, const std::string& value) {
        Readings readings;
        set_reading(readings, name, value);
      },
      nanobind::arg("name"), nanobind::arg("value"),
      "Raises BadInput where there is no such reading.");
}

/// Name, values, the corrected value, section of the paper.
using NameRow = std::tuple<std::string, std::vector<std::string>, std::string, std::string>;

inline std::vector<NameRow> rows_of(const std::vector<ReadingName>& names) {
  std::vector<NameRow> rows;
  for (const ReadingName& reading : names) {
    rows.emplace_back(reading.name,
                      std::vector<std::string>(reading.values.begin(), reading.values.end()),
                      reading.corrected, reading.section);
  }
  return rows;
}

}  // namespace minkref::python
