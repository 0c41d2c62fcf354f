#include "formats/message_text.hpp"

#include <algorithm>

namespace minkref {

std::string printable(std::string_view text) {
  std::string shown(text);
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7f; }, '?');
  return shown;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string shown = "\"" + printable(text.substr(0, most)) + "\"";
  if (text.size() > most) shown += " (cut)";
  return shown;
}

}  // namespace minkref
