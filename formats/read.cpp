#include "formats/read.hpp"

#include <filesystem>
#include <utility>

#include "formats/case.hpp"
#include "formats/file_text.hpp"
#include "formats/json_text.hpp"
#include "formats/read_geojson.hpp"
#include "formats/read_json.hpp"
#include "formats/read_poly.hpp"
#include "formats/read_wkt.hpp"
#include "formats/refusal_place.hpp"

namespace minkref {
namespace {

/// The two parts of a name like "case.json#Q".
struct OperandName {
  std::string file;
  char operand = '\0';  ///< 'P', 'Q', or none
};

OperandName split(const std::string& source) {
  if (source.ends_with("#P") || source.ends_with("#Q")) {
    return {source.substr(0, source.size() - 2), source.back()};
  }
  return {source};
}

Reading operand_of_case(std::string_view text, const std::string& source,
                        const ReadLimits& limits) {
  const OperandName name = split(source);
  CaseReading reading = read_case_text(text, name.file, limits);
  Reading chosen;
  chosen.set = std::move(name.operand == 'Q' ? reading.value.Q : reading.value.P);
  chosen.origins = std::move(name.operand == 'Q' ? reading.Q_origins : reading.P_origins);
  if (name.operand == '\0') {
    const std::string at = name.file.empty() ? "" : name.file + ": ";
    chosen.warnings.push_back(at +
                              "a case holds two operands and P is used; add #P or #Q to its name");
  }
  return chosen;
}

bool looks_like_case(Json root) {
  bool found = false;
  if (!root.is(JsonKind::object)) return false;
  root.for_each_member([&](const std::string& member, Json) {
    found = found || member == "schema" || member == "P" || member == "Q";
  });
  return found;
}

void refuse_operand_name(const std::string& source, const Input& input) {
  if (split(source).operand == '\0') return;
  input.refuse("not-a-case", "only a case holds operands P and Q",
               "leave #P or #Q out of the name");
}

FaultyReading finished(SetBuilder& set) {
  if (!set.keeps_faults()) return {set.finish(), {}};
  Reading reading = set.finish_as_read();
  return {std::move(reading), set.take_open()};
}

FaultyReading read_any_json(std::string_view text, const std::string& source,
                            const ReadLimits& limits, Faults faults) {
  Input input(source, limits);
  const JsonText document(text, input);
  SetBuilder set(input, faults);
  const bool geojson = looks_like_geojson(document.root());
  if (!geojson && looks_like_case(document.root()))
    return {operand_of_case(text, source, limits), {}};
  refuse_operand_name(source, input);
  if (geojson) {
    read_geojson(document.root(), set);
  } else {
    read_json_set(document.root(), set, JsonNumbers::any);
  }
  return finished(set);
}

FaultyReading read_in_format(std::string_view text, Format format, const std::string& source,
                             const ReadLimits& limits, Faults faults) {
  text = plain_text(text, source, limits);
  if (format == Format::case_json) return {operand_of_case(text, source, limits), {}};
  if (format == Format::json) return read_any_json(text, source, limits, faults);
  Input input(source, limits);
  refuse_operand_name(source, input);
  SetBuilder set(input, faults);
  if (format == Format::wkt) {
    read_wkt(text, set);
  } else if (format == Format::poly) {
    read_poly(text, set);
  } else if (format == Format::geojson) {
    const JsonText document(text, input);
    read_geojson(document.root(), set);
  } else {
    input.refuse("unknown-format", "a picture (" + name(format) + ") can be written, not read",
                 "give a file in wkt, geojson, json or poly");
  }
  return finished(set);
}

FaultyReading read_path(const std::string& path, const ReadLimits& limits, Faults faults) {
  // A file whose own name ends with "#P" keeps that name.
  std::error_code error;
  const std::string file = std::filesystem::exists(path, error) ? path : split(path).file;
  const std::string text = read_whole_file(file, limits);
  return read_in_format(text, format_of_file(file), path, limits, faults);
}

}  // namespace

Reading read_text(std::string_view text, Format format, const std::string& source,
                  const ReadLimits& limits) {
  return read_in_format(text, format, source, limits, Faults::refused).reading;
}

Reading read_file(const std::string& path, const ReadLimits& limits) {
  return read_path(path, limits, Faults::refused).reading;
}

FaultyReading read_faulty_text(std::string_view text, Format format, const std::string& source,
                               const ReadLimits& limits) {
  return read_in_format(text, format, source, limits, Faults::kept);
}

FaultyReading read_faulty_file(const std::string& path, const ReadLimits& limits) {
  return read_path(path, limits, Faults::kept);
}

Reading read_valid_text(std::string_view text, Format format, const std::string& source,
                        const ReadLimits& limits) {
  Reading reading = read_text(text, format, source, limits);
  validate_as_read(reading.set, reading.origins, source);
  return reading;
}

Reading read_valid_file(const std::string& path, const ReadLimits& limits) {
  Reading reading = read_file(path, limits);
  validate_as_read(reading.set, reading.origins, path);
  return reading;
}

}  // namespace minkref
