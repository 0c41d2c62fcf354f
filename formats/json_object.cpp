#include "formats/json_object.hpp"

#include <algorithm>

#include "formats/message_text.hpp"

namespace minkref {

void expect(Json value, JsonKind kind, const std::string& what, const Input& input) {
  if (value.is(kind)) return;
  input.refuse("wrong-type",
               what + " must be " + describe(kind) + ", not " + describe(value.kind()),
               "correct the value", value.line());
}

JsonObject::JsonObject(Json value, const Input& input, std::string what,
                       std::initializer_list<std::string_view> known, Others others)
    : input_(input), what_(std::move(what)), line_(value.line()) {
  expect(value, JsonKind::object, what_, input);
  value.for_each_member([&](const std::string& name, Json member) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      if (others == Others::ignored) return;
      std::string names;
      for (const std::string_view one : known)
        names += (names.empty() ? "" : ", ") + std::string(one);
      input_.refuse("unknown-member", what_ + " has no member " + in_quotes(name),
                    "leave it out, or correct its name; the known members are " + names,
                    member.line());
    }
    if (find(name)) {
      input_.refuse("duplicate-member", what_ + " has the member " + in_quotes(name) + " twice",
                    "keep one of them", member.line());
    }
    found_.emplace_back(name, member);
  });
}

std::optional<Json> JsonObject::find(std::string_view name) const {
  for (const auto& [found, value] : found_) {
    if (found == name) return value;
  }
  return std::nullopt;
}

Json JsonObject::require(std::string_view name) const {
  if (const auto value = find(name)) return *value;
  input_.refuse("missing-member", what_ + " lacks the member " + in_quotes(name), "add it", line_);
}

}  // namespace minkref
