// The lines of a `.poly` text that hold something, as tokens.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "formats/input.hpp"

namespace minkref {

struct PolyLine {
  std::size_t number = 0;  ///< 1-based
  std::vector<std::string_view> tokens;
};

/// Walks the lines that are not empty; `#` begins a comment. A token with two decimal points, as in
/// "7.84688.042924", is two numbers run together: it is split before its second point, with a
/// warning that names the line.
class PolyLines {
 public:
  PolyLines(std::string_view text, Input& input);

  /// The line at hand; none at the end of the text.
  const std::optional<PolyLine>& line() const { return line_; }
  void advance();
  std::size_t last_number() const { return number_; }

 private:
  std::string_view rest_;
  Input& input_;
  std::size_t number_ = 0;
  std::optional<PolyLine> line_;
};

}  // namespace minkref
