// Index files: any change to a file is refused; if the checksum is corrected too, as a forger
// would, the file is refused, or every question is answered or refused.
//
// An input is one index from below and changes to its file: of each eight bytes, the first two are
// a place in words of four bytes, the next chooses the word's change (`Change`), one is unused, and
// four are a number. The first byte's lowest bit says whether the checksum follows.
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <boost/crc.hpp>
#include <cstring>

#include "reference/plane/index/scale_index.hpp"
#include "tests/fuzzing/round_trip.hpp"

namespace minkref::fuzzing {
namespace {

constexpr std::size_t checksum_at = 24, record = 8, most_changes = 32;

/// A memory file and the path that opens it.
class MemoryFile {
 public:
  MemoryFile()
      : file_(::memfd_create("index", 0)), path_("/proc/self/fd/" + std::to_string(file_)) {}
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }
  void write(const std::string& bytes) const {
    if (::ftruncate(file_, 0) != 0 ||
        ::pwrite(file_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
      std::abort();
    }
  }

 private:
  int file_;
  std::string path_;
};

PolygonSet polygon(Ring outer, std::vector<Ring> holes = {}) {
  return {{Polygon{std::move(outer), std::move(holes)}}};
}

std::string bytes_of(const ScaleIndex& index) {
  char path[] = "/tmp/minkref_fuzz_index_XXXXXX";
  ::close(::mkstemp(path));
  index.save(path);
  std::string bytes(index.bytes(), 0);
  std::FILE* file = std::fopen(path, "rb");
  if (std::fread(bytes.data(), 1, bytes.size(), file) != bytes.size()) std::abort();
  std::fclose(file);
  std::remove(path);
  return bytes;
}

/// Indices that are convex, have a closing hole, have touching rings, and have fractions in all
/// scales.
const std::array<std::string, 4>& files() {
  static const std::array<std::string, 4> made = [] {
    const PolygonSet triangle = polygon({{0, 0}, {2, 0}, {0, 2}});
    const PolygonSet frame = polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{{1, 1}, {1, 4}, {4, 1}}});
    const PolygonSet bar = polygon({{0, 0}, {3, 0}, {3, 1}, {0, 1}});
    const PolygonSet hook =
        polygon({{0, 0}, {5, 0}, {5, 5}, {3, 5}, {3, 2}, {2, 2}, {2, 5}, {0, 5}});
    const PolygonSet thirds = polygon({{0, 0}, {Rational(1, 3), 0}, {0, Rational(1, 7)}});
    const ScaleWindow window{Rational(1, 4), Rational(4)};
    return std::array{bytes_of({triangle, bar, window}), bytes_of({triangle, frame, window}),
                      bytes_of({bar, hook, window}), bytes_of({thirds, hook, {}})};
  }();
  return made;
}

enum class Change : std::uint8_t { set, add, bits, copy, kinds };

void make_change(std::string& bytes, const std::uint8_t* from) {
  std::uint16_t place = 0;
  std::uint32_t number = 0, word = 0;
  std::memcpy(&place, from, sizeof place);
  std::memcpy(&number, from + 4, sizeof number);
  const std::size_t words = bytes.size() / 4;
  char* const at = bytes.data() + 4 * (place % words);
  std::memcpy(&word, at, sizeof word);
  switch (static_cast<Change>(from[2] % static_cast<std::uint8_t>(Change::kinds))) {
    case Change::add:
      word += number;
      break;
    case Change::bits:
      word ^= std::uint32_t{1} << number % 32;
      break;
    case Change::copy:
      std::memcpy(&word, bytes.data() + 4 * (number % words), sizeof word);
      break;
    default:
      word = number;
  }
  std::memcpy(at, &word, sizeof word);
}

void make_checksum_right(std::string& bytes) {
  const std::uint32_t nothing = 0;
  std::memcpy(bytes.data() + checksum_at, &nothing, sizeof nothing);
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  const std::uint32_t sum = crc.checksum();
  std::memcpy(bytes.data() + checksum_at, &sum, sizeof sum);
}

/// Accepts any answer, or a refusal.
template <class Question>
void ask(Question&& question) {
  try {
    question();
  } catch (const BadInput& refused) {
    if (refused.mend().empty()) broken("a refusal says how to fix it", refused.what());
  }
}

void ask_at(const ScaleIndex& index, const Rational& scale) {
  const auto rings = [&](auto kind) { ask([&] { index.rings(scale, kind); }); };
  rings(TrackRings{});
  rings(RoundedRings{});
  rings(HomogeneousRings{});
  rings(RationalRings{});
  ask([&] { index.sum(scale, Passages::find); });
  ask([&] { index.features(scale); });
  ask([&] { index.area(scale); });
  ask([&] { index.area_polynomial(index.place(scale).interval); });
}

void ask_all(const ScaleIndex& index) {
  ask([&] { index.P(); });
  ask([&] { index.Q(); });
  ask([&] { index.edges(); });
  ask([&] { index.timeline(); });
  for (std::uint32_t k = 0; k < index.tracks(); ++k) ask([&] { index.track(k); });
  const auto count = static_cast<std::uint32_t>(index.events());
  for (std::uint32_t k = 0; k < count; k += 1 + count / 4) {
    const Rational scale = index.event(k);
    ask_at(index, scale);
    if (k + 1 < count) ask_at(index, (scale + index.event(k + 1)) / 2);
  }
  ask_at(index, 1);
  const auto [first, last] = index.events_within();
  if (first > last || last > count) broken("events of the window are events", "");
}

/// Whether it was opened.
bool opens(const MemoryFile& file) {
  try {
    ask_all(ScaleIndex::open(file.path()));
    return true;
  } catch (const BadInput& refused) {
    check_refusal(refused);
    return false;
  }
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace minkref::fuzzing;
  if (size == 0) return 0;
  static const MemoryFile file;
  const bool forged = (data[0] & 1U) != 0;
  const std::string& whole = files()[data[0] / 2U % files().size()];
  std::string bytes = whole;
  for (std::size_t k = 0; k < most_changes && 1 + (k + 1) * record <= size; ++k) {
    make_change(bytes, data + 1 + k * record);
  }
  const bool changed = bytes != whole;
  if (forged) make_checksum_right(bytes);
  file.write(bytes);
  const bool opened = opens(file);
  if (!changed && !opened) broken("an index is opened as it was written", "");
  if (changed && !forged && opened) broken("a change is refused", "");
  return 0;
}
