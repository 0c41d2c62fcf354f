#include "formats/file_text.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "reference/error.hpp"

namespace minkref {
namespace {

Place in(const std::string& source) {
  Place place;
  place.source = source;
  return place;
}

[[noreturn]] void too_large(const std::string& source, const ReadLimits& limits) {
  throw LimitExceeded("file-too-large",
                      "the text is longer than " + std::to_string(limits.bytes) + " bytes",
                      "split the input, or raise the limit on bytes", in(source));
}

[[noreturn]] void cannot_read(const std::string& path, const std::string& reason) {
  throw BadInput("cannot-read", "the file cannot be read: " + reason,
                 "name an existing file that you may read", in(path));
}

bool starts_with(std::string_view text, std::string_view mark) {
  return text.substr(0, mark.size()) == mark;
}

}  // namespace

std::string read_whole_file(const std::string& path, const ReadLimits& limits) {
  std::error_code error;
  if (path.find('\0') != std::string::npos) cannot_read("", "its name contains a NUL byte");
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) cannot_read(path, "there is no such file");
  if (std::filesystem::is_directory(status)) cannot_read(path, "it is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) cannot_read(path, std::strerror(errno));
  std::string text;
  constexpr std::size_t block = std::size_t{1} << 20;
  while (file) {
    const std::size_t before = text.size();
    text.resize(before + block);
    file.read(text.data() + before, static_cast<std::streamsize>(block));
    text.resize(before + static_cast<std::size_t>(file.gcount()));
    if (text.size() > limits.bytes) too_large(path, limits);
  }
  if (!file.eof()) cannot_read(path, "reading stopped with an error");
  return text;
}

void require_size(std::string_view text, const std::string& source, const ReadLimits& limits) {
  // Positions have 32 bits.
  if (text.size() > limits.bytes || text.size() >= std::numeric_limits<std::uint32_t>::max()) {
    too_large(source, limits);
  }
}

std::string_view plain_text(std::string_view text, const std::string& source,
                            const ReadLimits& limits, std::string_view empty_set) {
  using namespace std::literals;
  require_size(text, source, limits);
  if (starts_with(text, "\xEF\xBB\xBF"sv)) text.remove_prefix(3);
  if (starts_with(text, "\xFE\xFF"sv) || starts_with(text, "\xFF\xFE"sv) ||
      starts_with(text, "\0\0\xFE\xFF"sv)) {
    throw BadInput("not-utf8", "the text starts with the byte order mark of UTF-16 or UTF-32",
                   "save the file as UTF-8", in(source));
  }
  if (const auto nul = text.find('\0'); nul != std::string_view::npos) {
    Place place = in(source);
    place.line = 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + nul, '\n'));
    throw BadInput("nul-byte", "byte " + std::to_string(nul) + " of the text is NUL",
                   "give a text file in UTF-8, not binary data", place);
  }
  if (text.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos) {
    throw BadInput(
        "empty-file", "the text is empty",
        "write the empty set in the words of the format, for example " + std::string(empty_set),
        in(source));
  }
  return text;
}

}  // namespace minkref
