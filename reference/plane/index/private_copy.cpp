#include "reference/plane/index/private_copy.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"

namespace minkref::inline plane {
namespace {

constexpr std::size_t copied_at_once = std::size_t{1} << 22;

class File {
 public:
  explicit File(int number) : number_(number) {}
  ~File() {
    if (number_ >= 0) ::close(number_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  explicit operator bool() const { return number_ >= 0; }
  int number() const { return number_; }

  /// Reads these bytes, fewer at the file's end; returns the count.
  std::size_t read(std::byte* to, std::size_t count, std::uint64_t from) const {
    std::size_t done = 0;
    while (done < count) {
      look_for_interrupt_now();
      const auto got = ::pread(number_, to + done, std::min(count - done, copied_at_once),
                               static_cast<off_t>(from + done));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return fail();
      if (got == 0) break;
      done += static_cast<std::size_t>(got);
    }
    return done;
  }
  void write(const std::byte* from, std::size_t count, std::uint64_t to) const {
    for (std::size_t done = 0; done < count;) {
      const auto put = ::pwrite(number_, from + done, count - done, static_cast<off_t>(to + done));
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) fail();
      done += static_cast<std::size_t>(put);
    }
  }
  [[noreturn]] static std::size_t fail() {
    throw BadInput("no-file", std::string("the index cannot be read: ") + std::strerror(errno),
                   "give a file that `minkref index` wrote, and room for a copy of a large one");
  }

 private:
  int number_;
};

PrivateCopy in_memory(const File& file, std::uint64_t size) {
  auto words = std::make_shared<std::vector<std::uint64_t>>((size + 7) / 8);
  auto* const first = reinterpret_cast<std::byte*>(words->data());
  const std::size_t length = file.read(first, size, 0);
  return {std::move(words), {first, length}};
}

File nameless(const std::string& path) {
  std::error_code none;
  for (const auto& folder : {std::filesystem::absolute(path, none).parent_path(),
                             std::filesystem::temp_directory_path(none)}) {
    const int number = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_EXCL | O_CLOEXEC, 0600);
    if (number >= 0) return File(number);
  }
  return File(-1);
}

PrivateCopy in_file(const File& file, std::uint64_t size, const std::string& path) {
  const File copy = nameless(path);
  if (!copy) return in_memory(file, size);
  std::vector<std::byte> buffer(copied_at_once);
  std::uint64_t length = 0;
  while (length < size) {
    const std::size_t got =
        file.read(buffer.data(), std::min<std::uint64_t>(copied_at_once, size - length), length);
    copy.write(buffer.data(), got, length);
    length += got;
    if (got < copied_at_once) break;
  }
  if (length == 0) return {};
  void* const first = ::mmap(nullptr, length, PROT_READ, MAP_PRIVATE, copy.number(), 0);
  if (first == MAP_FAILED) File::fail();
  const std::shared_ptr<const void> owner(first,
                                          [length](void* address) { ::munmap(address, length); });
  return {owner, {static_cast<const std::byte*>(first), length}};
}

}  // namespace

PrivateCopy private_copy(const std::string& path, std::string_view beginning,
                         std::uint64_t most_in_memory) {
  try {
    const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat about{};
    if (!file || ::fstat(file.number(), &about) != 0) File::fail();
    if (S_ISDIR(about.st_mode)) {
      errno = EISDIR;
      File::fail();
    }
    if (!S_ISREG(about.st_mode)) {
      throw BadInput("no-file", "the index cannot be read: this is no regular file",
                     "give a file that `minkref index` wrote");
    }
    std::string found(beginning.size(), '\0');
    const auto length = file.read(reinterpret_cast<std::byte*>(found.data()), found.size(), 0);
    if (length < found.size() || found != beginning) return {};
    const auto size = static_cast<std::uint64_t>(about.st_size);
    return size <= most_in_memory ? in_memory(file, size) : in_file(file, size, path);
  } catch (const BadInput& error) {
    throw error.from(path);
  }
}

}  // namespace minkref::inline plane
