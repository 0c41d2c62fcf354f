// Shared parts of the format tables: lists of names, and the refusal of unknown names.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "formats/message_text.hpp"
#include "reference/error.hpp"

namespace minkref {

/// Lists names, each behind `before`; the last behind `last`.
template <class Entry>
std::string listed(std::span<const Entry> table, std::string_view before, std::string_view last,
                   bool Entry::* wanted = nullptr) {
  std::string text, name;
  for (const Entry& entry : table) {
    if (wanted && !(entry.*wanted)) continue;
    if (!name.empty()) text += (text.empty() ? "" : ", ") + name;
    name = std::string(before) + std::string(entry.name);
  }
  return text + std::string(last) + name;
}

/// The format with a given name. `of`: "of the plane", say. Throws BadInput ("unknown-format").
template <class Entry>
auto named(std::span<const Entry> table, std::string_view wanted, const std::string& of) {
  for (const Entry& entry : table) {
    if (entry.name == wanted) return entry.format;
  }
  throw BadInput("unknown-format", in_quotes(wanted) + " is not a format " + of,
                 "name one of " + listed(table, "", ", "));
}

/// Throws BadInput ("unknown-format") for a file whose extension names none.
template <class Entry>
[[noreturn]] void refuse_extension(std::span<const Entry> table, const std::string& path,
                                   const std::string& extension, const std::string& of,
                                   bool Entry::* wanted = nullptr) {
  Place place;
  place.source = path;
  throw BadInput("unknown-format",
                 "the extension " + in_quotes(extension) + " does not name a format " + of,
                 "give the file the extension " + listed(table, ".", " or ", wanted), place);
}

}  // namespace minkref
