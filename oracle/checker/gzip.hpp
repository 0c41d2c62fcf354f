// Files compressed by gzip (RFC 1951, RFC 1952).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace minkref::checker {

/// Whether a file begins as one that gzip wrote.
bool is_gzip(std::string_view data);

/// The data decompressed. Throws NotVerified: malformed for data that is not one whole member with
/// the right checksum and length and nothing after it, out of budget for more than `most` bytes.
std::string gunzip(std::string_view data, std::size_t most);

}  // namespace minkref::checker
