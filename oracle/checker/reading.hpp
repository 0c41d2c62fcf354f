// Reads a certificate's members, and the case's.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <string>
#include <vector>

#include "oracle/checker/json_value.hpp"

namespace minkref::checker {

/// Finds an object's members in the order of `names`; `name?` may be missing, and is then null. Any
/// other member is an error.
std::vector<const Value*> members(const Value& value, const std::string& names);

/// Whether a certificate claims to have this form.
bool has_form(const Value& certificate, const std::string& form);

const std::vector<Value>& items(const Value& value);
const std::vector<Value>& items(const Value& value, std::size_t length);

/// A JSON integer of any size.
mpz_class integer(const Value& value);
/// Reads a JSON integer below `end`: references point backwards.
std::uint32_t index(const Value& value, std::size_t end);
std::vector<std::uint32_t> indices(const Value& value, std::size_t end);
/// Reads a JSON integer, or a text: "7", "-3/7", "0.25", "1e-3".
mpq_class number(const Value& value);
mpz_class whole(const Value& value);
mpq_class scale(const Value& value);
const std::string& text(const Value& value);
/// Reads a case's path: text without U+0000, whose part behind the last slash is neither empty nor
/// a dot.
const std::string& path(const Value& value);

struct Vector {
  mpz_class x, y;
  friend bool operator==(const Vector&, const Vector&) = default;
};
struct Point {
  mpq_class x, y;
  friend bool operator==(const Point&, const Point&) = default;
};
Point point(const Value& value);

/// An operand's vertices in file order, and rings of vertex numbers.
struct Operand {
  std::string name;
  std::vector<Point> exact;
  std::vector<Vector> points;  ///< in the proof's units
  std::vector<std::vector<std::uint32_t>> rings;
  std::vector<bool> outer;  ///< of each ring: whether it is an outer ring
  std::string plain;        ///< the hashed text
  bool thin = false;        ///< a point or a segment
};
Operand read_operand(const Value& value, const std::string& name);

}  // namespace minkref::checker
