// The whole text of a file, and the text that a reader may be given.
#pragma once

#include <string>
#include <string_view>

#include "formats/limits.hpp"

namespace minkref {

/// Reads a file to its end before any parsing. Throws BadInput ("cannot-read": missing, a
/// directory, not readable) or LimitExceeded ("file-too-large").
std::string read_whole_file(const std::string& path, const ReadLimits& limits = {});

/// Throws LimitExceeded ("file-too-large").
void require_size(std::string_view text, const std::string& source, const ReadLimits& limits = {});

/// `text` without a UTF-8 byte order mark. Throws BadInput with the line: "empty-file" (nothing but
/// white space), "nul-byte" (binary data, UTF-16 without mark), "not-utf8" (a UTF-16 or UTF-32 byte
/// order mark); LimitExceeded ("file-too-large"). `empty_set`: the format's words for the empty
/// set, for the refusal of an empty text.
std::string_view plain_text(std::string_view text, const std::string& source,
                            const ReadLimits& limits = {},
                            std::string_view empty_set = "POLYGON EMPTY");

}  // namespace minkref
