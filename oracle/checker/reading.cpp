#include "oracle/checker/reading.hpp"

#include <algorithm>
#include <sstream>

namespace minkref::checker {
namespace {

mpz_class from_digits(std::string digits) {
  if (!digits.empty() && digits.front() == '+') digits.erase(0, 1);
  return mpz_class(digits, 10);
}

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

std::string_view without_sign(std::string_view text) {
  return text.substr(!text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0);
}

/// Whether an exponent has at most three digits, or is 1000.
bool is_exponent(std::string_view text) {
  const std::string_view digits = without_sign(text);
  return is_digits(digits) && (digits.size() <= 3 || digits == "1000");
}

/// Digits, perhaps a point, perhaps an exponent.
mpq_class decimal(const std::string& text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  std::string digits = text.substr(0, e);
  const std::string exponent = e < text.size() ? text.substr(e + 1) : "";
  const std::size_t point = digits.find('.');
  std::size_t after_point = 0;
  if (point != digits.npos) {
    after_point = digits.size() - point - 1;
    digits.erase(point, 1);
  }
  require(is_digits(without_sign(digits)) && (e == text.size() || is_exponent(exponent)),
          text.substr(0, 60) + " is no number");
  const long shift = (exponent.empty() ? 0 : std::stol(exponent)) - static_cast<long>(after_point);
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(shift)));
  mpq_class value =
      shift < 0 ? mpq_class(from_digits(digits), power) : mpq_class(from_digits(digits) * power);
  value.canonicalize();
  return value;
}

mpq_class parse_number(const std::string& text) {
  require(text.size() <= most_digits, "a number has too many digits");
  const std::size_t bar = text.find('/');
  if (bar == text.npos) return decimal(text);
  const std::string above = text.substr(0, bar), below = text.substr(bar + 1);
  require(is_digits(without_sign(above)) && is_digits(below) &&
              below.find_first_not_of('0') != below.npos,
          text.substr(0, 60) + " is no number");
  mpq_class value(from_digits(above), mpz_class(below, 10));
  value.canonicalize();
  return value;
}

std::string ring_text(const Value& value, bool outer, Operand& operand) {
  std::vector<std::uint32_t> ring;
  std::string plain;
  for (const Value& entry : items(value)) {
    const Point p = point(entry);
    ring.push_back(static_cast<std::uint32_t>(operand.exact.size()));
    operand.exact.push_back(p);
    plain += (plain.empty() ? "[\"" : ",[\"") + p.x.get_str() + "\",\"" + p.y.get_str() + "\"]";
  }
  require(!ring.empty(), operand.name + " has an empty ring");
  operand.outer.push_back(outer);
  operand.thin = operand.thin || ring.size() < 3;
  operand.rings.push_back(std::move(ring));
  return "[" + plain + "]";
}

}  // namespace

std::vector<const Value*> members(const Value& value, const std::string& names) {
  static const Value nothing;
  require(value.kind == Value::Kind::object, "an object with " + names + " is missing");
  std::vector<const Value*> found;
  std::size_t there = 0;
  std::istringstream words(names);
  for (std::string name; words >> name;) {
    const bool may_lack = name.back() == '?';
    if (may_lack) name.pop_back();
    const auto member = std::find_if(value.members.begin(), value.members.end(),
                                     [&](const auto& m) { return m.name == name; });
    require(may_lack || member != value.members.end(), "a member is missing: " + name);
    there += member != value.members.end();
    found.push_back(member != value.members.end() ? &member->value : &nothing);
  }
  require(there == value.members.size(), "there are more members than " + names);
  return found;
}

bool has_form(const Value& certificate, const std::string& form) {
  return std::any_of(certificate.members.begin(), certificate.members.end(), [&](const Member& m) {
    return m.name == "certificate" && m.value.kind == Value::Kind::text && m.value.text == form;
  });
}

const std::vector<Value>& items(const Value& value) {
  require(value.kind == Value::Kind::list, "a list is missing");
  return value.items;
}

const std::vector<Value>& items(const Value& value, std::size_t length) {
  require(items(value).size() == length, "a list has not " + std::to_string(length) + " entries");
  return value.items;
}

mpz_class integer(const Value& value) {
  require(value.kind == Value::Kind::integer, "an integer is missing");
  return mpz_class(value.text, 10);
}

std::uint32_t index(const Value& value, std::size_t end) {
  const mpz_class found = integer(value);
  require(found >= 0 && found < end, "there is no number " + found.get_str() + " before this");
  return static_cast<std::uint32_t>(found.get_ui());
}

std::vector<std::uint32_t> indices(const Value& value, std::size_t end) {
  std::vector<std::uint32_t> found;
  for (const Value& entry : items(value)) found.push_back(index(entry, end));
  return found;
}

mpq_class number(const Value& value) {
  if (value.kind == Value::Kind::text || value.kind == Value::Kind::real) {
    return parse_number(value.text);
  }
  return mpq_class(integer(value));
}

mpz_class whole(const Value& value) {
  const mpq_class found = number(value);
  require(found.get_den() == 1, found.get_str() + " is no whole number");
  return found.get_num();
}

mpq_class scale(const Value& value) {
  const mpq_class found = number(value);
  require(found > 0, "the scale " + found.get_str() + " is not positive");
  return found;
}

const std::string& text(const Value& value) {
  require(value.kind == Value::Kind::text, "a text is missing");
  return value.text;
}

const std::string& path(const Value& value) {
  const std::string& all = text(value);
  const std::string last = all.substr(all.rfind('/') + 1);  // npos + 1 is 0
  require(all.find('\0') == std::string::npos && !last.empty() && last != ".",
          "the path of the case is none");
  return all;
}

Point point(const Value& value) {
  const auto& pair = items(value, 2);
  return {number(pair[0]), number(pair[1])};
}

Operand read_operand(const Value& value, const std::string& name) {
  Operand operand;
  operand.name = name;
  for (const Value& polygon : items(*members(value, "polygons")[0])) {
    const auto rings = members(polygon, "outer holes?");
    const std::string outer = ring_text(*rings[0], true, operand);
    std::string holes;
    if (!rings[1]->is_null()) {
      for (const Value& hole : items(*rings[1])) {
        holes += (holes.empty() ? "" : ",") + ring_text(hole, false, operand);
      }
    }
    operand.plain += operand.plain.empty() ? "" : ",";
    operand.plain += "{\"holes\":[" + holes + "],\"outer\":" + outer + "}";
  }
  operand.plain = "[" + operand.plain + "]";
  require(!operand.thin || operand.rings.size() == 1, name + " has a ring of too few vertices");
  return operand;
}

}  // namespace minkref::checker
