#include "reference/plane/index/index_image.hpp"

#include <unistd.h>

#include <boost/crc.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "reference/error.hpp"
#include "reference/plane/index/private_copy.hpp"

namespace minkref::inline plane {
namespace {

constexpr std::array<char, 8> magic{'m', 'i', 'n', 'k', 'r', 'e', 'f', 'I'};
constexpr std::uint32_t version = 1, byte_order = 0x01020304;
constexpr std::size_t alignment = 64;

std::size_t aligned(std::size_t offset) { return (offset + alignment - 1) / alignment * alignment; }

BadInput refused(const std::string& path, const char* code, const std::string& problem,
                 const char* mend) {
  return BadInput(code, problem, mend).from(path);
}

}  // namespace

std::uint32_t IndexImage::checksum(std::span<const std::byte> bytes) {
  constexpr std::size_t field = offsetof(Header, checksum), behind = field + sizeof(std::uint32_t);
  boost::crc_32_type crc;
  constexpr std::uint32_t nothing = 0;
  crc.process_bytes(bytes.data(), field);
  crc.process_bytes(&nothing, sizeof nothing);
  crc.process_bytes(bytes.data() + behind, bytes.size() - behind);
  return crc.checksum();
}

const IndexImage::Entry& IndexImage::entry_of(Column which, std::size_t element) const {
  const Header& header = *reinterpret_cast<const Header*>(bytes_.data());
  const Entry& entry = header.directory[static_cast<std::size_t>(which)];
  if (entry.element != element) {
    throw BadInput("damaged-index", "a column of the index has elements of another size",
                   "build the index again");
  }
  return entry;
}

IntegerColumn IndexImage::integers(Column which) const {
  const Entry& entry = entry_of(which, sizeof(std::uint64_t));
  if (entry.words == 0 || entry.count % entry.words != 0) {
    throw BadInput("damaged-index", "a column of the index does not hold integers",
                   "build the index again");
  }
  return {entry.words, column<std::uint64_t>(which)};
}

IndexImage IndexImage::read(const std::string& path) {
  constexpr const char* foreign = "give a file that `minkref index` wrote";
  constexpr const char* again = "build it again with `minkref index`";
  const PrivateCopy copy = private_copy(path, {magic.data(), magic.size()});
  if (copy.bytes.size() < sizeof(Header)) {
    throw refused(path, "not-an-index", "the file is no index", foreign);
  }
  IndexImage image;
  image.bytes_ = copy.bytes;
  image.owner_ = copy.owner;
  const Header& header = *reinterpret_cast<const Header*>(copy.bytes.data());
  if (header.byte_order != byte_order) {
    throw refused(path, "not-an-index", "the index comes from a machine with another byte order",
                  again);
  }
  if (header.version != version) {
    throw refused(path, "index-version",
                  "the index has version " + std::to_string(header.version) + ", not " +
                      std::to_string(version),
                  again);
  }
  if (header.bytes != image.bytes_.size() || header.columns != column_count) {
    throw refused(path, "damaged-index", "the index is cut off", again);
  }
  if (header.checksum != checksum(image.bytes_)) {
    throw refused(path, "damaged-index", "the checksum of the index is wrong", again);
  }
  for (const Entry& entry : header.directory) {
    const bool inside = entry.offset % 8 == 0 && entry.offset <= image.bytes_.size() &&
                        entry.element != 0 &&
                        entry.count <= (image.bytes_.size() - entry.offset) / entry.element;
    if (!inside) throw refused(path, "damaged-index", "the index has a wrong directory", again);
  }
  return image;
}

void IndexImage::save(const std::string& path) const {
  std::error_code none;
  if (std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none)) {
    throw refused(path, "cannot-write", "the index cannot be written: this is no file",
                  "name a file: an index is no stream");
  }
  const std::string beside = path + "." + std::to_string(::getpid()) + ".part";
  const auto fail = [&] {
    const std::string why = std::strerror(errno);
    std::remove(beside.c_str());
    throw refused(path, "cannot-write", "the index cannot be written: " + why,
                  "name a file in a folder that exists, on a disk with room");
  };
  std::FILE* file = std::fopen(beside.c_str(), "wb");
  if (file == nullptr) fail();
  bool good = std::fwrite(bytes_.data(), 1, bytes_.size(), file) == bytes_.size();
  good = std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0 && good;
  good = std::fclose(file) == 0 && good;
  if (!good || std::rename(beside.c_str(), path.c_str()) != 0) fail();
}

void IndexImage::Writer::add(Column which, const void* data, std::size_t count, std::size_t element,
                             std::uint32_t words) {
  body_.resize(aligned(body_.size()));
  directory_[static_cast<std::size_t>(which)] = {body_.size(), count,
                                                 static_cast<std::uint32_t>(element), words};
  const auto* bytes = static_cast<const std::byte*>(data);
  body_.insert(body_.end(), bytes, bytes + count * element);
}

void IndexImage::Writer::add(Column which, const std::vector<Integer>& values) {
  const IntegerWords words = integer_words(values);
  add(which, words.data.data(), words.data.size(), sizeof(std::uint64_t), words.words);
}

IndexImage IndexImage::Writer::finish() {
  const std::size_t start = aligned(sizeof(Header));
  Header header{magic, version, byte_order, start + body_.size(), 0, column_count, directory_};
  for (Entry& entry : header.directory) entry.offset += start;
  // As words, so that the image begins where any column may.
  const auto bytes = std::make_shared<std::vector<std::uint64_t>>((header.bytes + 7) / 8);
  auto* const first = reinterpret_cast<std::byte*>(bytes->data());
  std::memcpy(first, &header, sizeof header);
  if (!body_.empty()) std::memcpy(first + start, body_.data(), body_.size());
  IndexImage image;
  image.bytes_ = {first, static_cast<std::size_t>(header.bytes)};
  image.owner_ = bytes;
  const std::uint32_t sum = checksum(image.bytes_);
  std::memcpy(first + offsetof(Header, checksum), &sum, sizeof sum);
  return image;
}

}  // namespace minkref::inline plane
