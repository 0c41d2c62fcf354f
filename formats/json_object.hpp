// The members of one JSON object that a reader knows.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/json_text.hpp"

namespace minkref {

class JsonObject {
 public:
  enum class Others { refused, ignored };

  /// `what` names the object for messages ("a polygon"). Refuses other values than objects
  /// ("wrong-type"), a known member given twice ("duplicate-member") and, if asked, an unknown
  /// member ("unknown-member": a misspelt "holes" must not lose a hole).
  JsonObject(Json value, const Input& input, std::string what,
             std::initializer_list<std::string_view> known, Others others);

  std::optional<Json> find(std::string_view name) const;
  /// The member; refuses its absence ("missing-member").
  Json require(std::string_view name) const;
  std::size_t line() const { return line_; }

 private:
  const Input& input_;
  std::string what_;
  std::size_t line_;
  std::vector<std::pair<std::string, Json>> found_;
};

/// Refuses a value of another kind ("wrong-type"); `what` like "the coordinates of a point".
void expect(Json value, JsonKind kind, const std::string& what, const Input& input);

}  // namespace minkref
