// JSON (RFC 8259) whose numbers keep their text and whose values know their line.
//
// Parsers that hand out numbers as doubles lose 0.1, and parsers that keep the text beside the
// double refuse 1e400 before anyone sees the text. Here a number keeps its text, and nothing else.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/input.hpp"

namespace minkref {

enum class JsonKind : std::uint8_t { null, boolean, number, string, array, object };

/// "null", "a boolean", "a number", ...: for messages.
std::string describe(JsonKind kind);

/// A value as a node; nodes keep the text's order, so a container's inner values follow it.
struct JsonNode {
  std::string_view text;   ///< number: its text; string: between the quotes, escapes not decoded
  std::uint32_t line = 0;  ///< 1-based
  std::uint32_t end = 0;   ///< index of the first node that is not inside
  std::uint32_t size = 0;  ///< elements of an array, members of an object
  JsonKind kind = JsonKind::null;
  bool escaped = false;  ///< string: holds a backslash
};

class JsonText;

/// A value of a JsonText; the text must outlive the value.
class Json {
 public:
  Json(const JsonText& document, std::uint32_t index) : document_(&document), index_(index) {}

  JsonKind kind() const { return node().kind; }
  bool is(JsonKind kind) const { return node().kind == kind; }
  std::size_t line() const { return node().line; }
  std::size_t size() const { return node().size; }
  std::string_view text() const { return node().text; }
  std::string string() const;  ///< decoded, UTF-8

  /// Walks an array's elements from first to last.
  class Iterator {
   public:
    Iterator(const JsonText& document, std::uint32_t index) : document_(&document), index_(index) {}
    Json operator*() const { return {*document_, index_}; }
    Iterator& operator++();
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const JsonText* document_;
    std::uint32_t index_;
  };
  /// For `for`; arrays only.
  Iterator begin() const { return {*document_, index_ + 1}; }
  Iterator end() const;

  /// Calls `visit(name, value)` for each member of an object, from first to last.
  template <class Visit>
  void for_each_member(Visit visit) const {
    for (Iterator i = begin(); i != end(); ++i) {
      const Json name_of_member = *i;
      visit(name_of_member.string(), *++i);
    }
  }

 private:
  const JsonNode& node() const;
  const JsonText* document_;
  std::uint32_t index_;
};

class JsonText {
 public:
  /// Parses a complete text, without recursion. Throws BadInput with the line ("syntax",
  /// "truncated", "trailing-text", "not-utf8", "not-a-number" for NaN and Infinity) or
  /// LimitExceeded ("too-deep", "too-many-values"). Keeps views into `text`. Linear.
  JsonText(std::string_view text, const Input& input);

  Json root() const { return {*this, 0}; }
  const JsonNode& node(std::uint32_t index) const { return nodes_[index]; }

 private:
  std::vector<JsonNode> nodes_;
};

}  // namespace minkref
