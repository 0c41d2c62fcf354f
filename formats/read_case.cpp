#include <algorithm>
#include <limits>
#include <utility>

#include "formats/case.hpp"
#include "formats/file_text.hpp"
#include "formats/json_object.hpp"
#include "formats/message_text.hpp"
#include "formats/read_json.hpp"
#include "formats/refusal_place.hpp"

namespace minkref {
namespace {

class CaseReader {
 public:
  explicit CaseReader(Input& input) : input_(input) {}

  CaseReading read(Json root) {
    const JsonObject members(
        root, input_, "a case",
        {"schema", "id", "title", "comment", "dimension", "P", "Q", "scales", "interval", "tags",
         "flags", "expected", "source", "licence", "certificate", "degeneracy"},
        JsonObject::Others::refused);
    version(members);
    CaseReading reading;
    Case& value = reading.value;
    value.id = required_text(members, "id");
    value.title = optional_text(members, "title");
    value.comment = optional_text(members, "comment");
    value.source = optional_text(members, "source");
    value.licence = optional_text(members, "licence");
    value.certificate = optional_text(members, "certificate");
    if (const auto told = members.find("degeneracy")) {  // for people: not read any further
      expect(*told, JsonKind::object, "degeneracy", input_);
    }
    Reading P = operand(members.require("P"), "P");
    Reading Q = operand(members.require("Q"), "Q");
    value.P = std::move(P.set);
    value.Q = std::move(Q.set);
    reading.P_origins = std::move(P.origins);
    reading.Q_origins = std::move(Q.origins);
    scales(members, value);
    if (const auto tags = members.find("tags")) value.tags = words(*tags, "tags");
    if (const auto flags = members.find("flags")) value.flags = words(*flags, "flags");
    if (const auto list = members.find("expected")) {
      expect(*list, JsonKind::array, "expected", input_);
      for (const Json one : *list) value.expected.push_back(expected(one));
    }
    return reading;
  }

 private:
  void version(const JsonObject& members) {
    const Json schema = members.require("schema");
    expect(schema, JsonKind::string, "schema", input_);
    if (schema.string() != "case-v1") {
      input_.refuse("unsupported-version",
                    in_quotes(schema.string()) + " is not a version of a case",
                    "this reader takes \"case-v1\"", schema.line());
    }
    const Json dimension = members.require("dimension");
    if (!dimension.is(JsonKind::number) || dimension.text() != "2") {
      input_.refuse("unsupported-dimension", "the dimension of a case in the plane is 2",
                    "write \"dimension\": 2", dimension.line());
    }
  }

  std::string text_of(Json value, const std::string& what) {
    expect(value, JsonKind::string, what, input_);
    return value.string();
  }

  std::string optional_text(const JsonObject& members, const std::string& name) {
    const auto value = members.find(name);
    return value ? text_of(*value, name) : "";
  }

  std::string required_text(const JsonObject& members, const std::string& name) {
    const Json value = members.require(name);
    const std::string text = text_of(value, name);
    if (text.empty())
      input_.refuse("missing-member", name + " is empty", "fill it in", value.line());
    return text;
  }

  std::vector<std::string> words(Json list, const std::string& what) {
    expect(list, JsonKind::array, what, input_);
    std::vector<std::string> found;
    for (const Json word : list) found.push_back(text_of(word, "each of the " + what));
    return found;
  }

  /// An operand counts as a separate input: its refusals name "file#P".
  Reading operand(Json value, const std::string& name) {
    const std::string source = input_.source().empty() ? name : input_.source() + "#" + name;
    Input part(source, input_);
    SetBuilder set(part);
    read_json_set(value, set, JsonNumbers::integers);
    return set.finish_as_read();
  }

  Rational number(Json value) {
    const Place place = at_line(value.line());
    return input_.number(number_text(value, JsonNumbers::integers, input_, place), place);
  }

  Rational scale(Json value) {
    Rational s = number(value);
    if (sign(s) <= 0) {
      input_.refuse("scale-not-positive",
                    "the scale " + in_quotes(to_string(s)) + " is not positive",
                    "give a scale greater than zero", value.line());
    }
    return s;
  }

  /// `["SX", "SY"]`: a factor for each axis.
  PlaneScaling axes(Json value) {
    std::vector<Rational> factors;
    for (const Json factor : value) factors.push_back(scale(factor));
    if (factors.size() != 2) {
      input_.refuse(
          "wrong-type",
          "a scale of a case in the plane has " + std::to_string(factors.size()) + " factors",
          "give one number, or a list of two", value.line());
    }
    return {factors[0], factors[1]};
  }

  void scales(const JsonObject& members, Case& value) {
    const auto list = members.find("scales");
    const auto interval = members.find("interval");
    if (list.has_value() == interval.has_value()) {
      input_.refuse(list ? "duplicate-member" : "missing-member",
                    "a case has either scales or an interval", "give one of the two",
                    members.line());
    }
    if (list) {
      expect(*list, JsonKind::array, "scales", input_);
      for (const Json s : *list) {
        if (s.is(JsonKind::array)) {
          value.axes.push_back(axes(s));
        } else {
          value.scales.push_back(scale(s));
        }
      }
      if (value.scales.empty() && value.axes.empty()) {
        input_.refuse("missing-member", "scales is empty", "give at least one scale", list->line());
      }
      return;
    }
    const JsonObject ends(*interval, input_, "an interval of scales", {"from", "to"},
                          JsonObject::Others::refused);
    CaseInterval window;
    if (const auto from = ends.find("from")) window.from = scale(*from);
    if (const auto to = ends.find("to")) window.to = scale(*to);
    if (window.from && window.to && *window.from > *window.to) {
      input_.refuse("empty-interval", "the interval of scales ends before it begins",
                    "exchange its ends", interval->line());
    }
    value.interval = std::move(window);
  }

  std::optional<std::uint64_t> count(const JsonObject& members, const std::string& name) {
    const auto value = members.find(name);
    if (!value) return std::nullopt;
    const Rational number_read = value->is(JsonKind::number) ? number(*value) : Rational(-1);
    if (sign(number_read) < 0 || number_read > std::numeric_limits<std::int64_t>::max()) {
      input_.refuse("wrong-type", name + " must be a count", "write an integer, zero or more",
                    value->line());
    }
    return static_cast<std::uint64_t>(numerator(number_read));
  }

  std::string digest(Json value) {
    const std::string text = text_of(value, "digest");
    const bool hex = std::all_of(text.begin(), text.end(), [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
    });
    if (!hex || text.size() != 64) {
      input_.refuse("wrong-type", "a digest is 64 hexadecimal digits in lower case",
                    "write the SHA-256 of the canonical JSON", value.line());
    }
    return text;
  }

  Expected expected(Json value) {
    const JsonObject members(
        value, input_, "an expected result",
        {"scale", "digest", "components", "holes", "vertices", "area", "result"},
        JsonObject::Others::refused);
    Expected claim;
    const Json at = members.require("scale");
    if (at.is(JsonKind::array)) {
      claim.axes = axes(at);
    } else {
      claim.scale = scale(at);
    }
    if (const auto text = members.find("digest")) claim.digest = digest(*text);
    claim.components = count(members, "components");
    claim.holes = count(members, "holes");
    claim.vertices = count(members, "vertices");
    if (const auto area = members.find("area")) claim.area = number(*area);
    if (const auto result = members.find("result")) claim.result = operand(*result, "expected").set;
    return claim;
  }

  Input& input_;
};

}  // namespace

CaseReading read_case_text(std::string_view text, const std::string& source,
                           const ReadLimits& limits) {
  text = plain_text(text, source, limits);
  Input input(source, limits);
  const JsonText document(text, input);
  return CaseReader(input).read(document.root());
}

Case read_case(const std::string& path, const ReadLimits& limits) {
  CaseReading reading = read_case_text(read_whole_file(path, limits), path, limits);
  validate_as_read(reading.value.P, reading.P_origins, path + "#P");
  validate_as_read(reading.value.Q, reading.Q_origins, path + "#Q");
  return std::move(reading.value);
}

}  // namespace minkref
