// The bytes of an index: columns, each with numbers of one kind.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "reference/plane/index/integer_column.hpp"

namespace minkref::inline plane {

/// The columns keep the file format's order (docs/formats.md, "Index").
enum class Column : std::uint32_t {
  window,      ///< integers: begin and end, each num and den; 0 / 0 for none
  counts,      ///< uint64: IndexCounts
  rings_of_P,  ///< uint32: vertices of each ring, bit 31 set for a hole
  rings_of_Q,
  coordinates_of_P,  ///< integers: x num, x den, y num, y den of each vertex
  coordinates_of_Q,
  edges,              ///< IndexEdge, of the convolution
  directions,         ///< uint32, of each edge: equal for parallel edges with the same direction
  events,             ///< integers: num, den
  events_in_doubles,  ///< double
  tracks,             ///< integers: x0, y0, x1, y1, c of ((x0, y0) + s (x1, y1)) / c, c > 0
  tracks_in_doubles,  ///< IndexTrack
  links,              ///< IndexLink
  bucket_of,          ///< uint32, of each interval
  buckets,            ///< IndexBucket
  entries,            ///< IndexEntry, the corners of the rings
  ring_ends,          ///< uint32, among the entries
  ring_features,      ///< IndexRing
  areas,              ///< IndexArea, of each interval
  feature_counts,     ///< IndexFeatureCount, sorted
  merged,             ///< uint32 pairs: track, its representative
  pieces,             ///< IndexPiece
  at_events,          ///< IndexAtEvent, of each event and one more: where its parts begin
  holes,              ///< IndexFeature
  components,         ///< IndexFeature
  topology,           ///< IndexTopologyEvent
  boundary,           ///< IndexBoundaryEvent
  lists,              ///< uint32: features before and after, edges
  places,             ///< integers: x num, x den, y num, y den; of topology, then boundary events
  last = places
};
inline constexpr std::size_t column_count = static_cast<std::size_t>(Column::last) + 1;

/// Columns behind a header; immutable. Copies share the bytes.
class IndexImage {
 public:
  class Writer;

  /// Takes a copy of a file (private_copy.hpp), which may change afterwards. Throws BadInput:
  /// "no-file", "not-an-index" (foreign), "index-version", "damaged-index" (length, directory or
  /// checksum). O(bytes).
  static IndexImage read(const std::string& path);
  /// Writes a file beside, then renames it. Throws BadInput ("cannot-write").
  void save(const std::string& path) const;

  std::size_t bytes() const { return bytes_.size(); }

  template <class T>
  std::span<const T> column(Column which) const {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 8);
    const Entry& entry = entry_of(which, sizeof(T));
    return {reinterpret_cast<const T*>(bytes_.data() + entry.offset), entry.count};
  }
  IntegerColumn integers(Column which) const;

 private:
  struct Entry {
    std::uint64_t offset = 0, count = 0;   ///< of elements
    std::uint32_t element = 0, words = 0;  ///< bytes of one; words of an integer, else 0
  };
  struct Header {
    std::array<char, 8> magic;
    std::uint32_t version, byte_order;
    std::uint64_t bytes;
    std::uint32_t checksum, columns;  ///< CRC-32 of all with this field 0
    std::array<Entry, column_count> directory;
  };
  const Entry& entry_of(Column which, std::size_t element) const;
  static std::uint32_t checksum(std::span<const std::byte> bytes);

  std::shared_ptr<const void> owner_;
  std::span<const std::byte> bytes_;
};

class IndexImage::Writer {
 public:
  template <class T>
  void add(Column which, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(which, values.data(), values.size(), sizeof(T), 0);
  }
  void add(Column which, const std::vector<Integer>& values);
  IndexImage finish();

 private:
  void add(Column which, const void* data, std::size_t count, std::size_t element,
           std::uint32_t words);
  std::array<Entry, column_count> directory_{};
  std::vector<std::byte> body_;
};

}  // namespace minkref::inline plane
