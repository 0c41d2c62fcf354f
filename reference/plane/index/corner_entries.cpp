#include "reference/plane/index/corner_entries.hpp"

#include <algorithm>

namespace minkref::inline plane {
namespace {

class RingCorners {
 public:
  RingCorners(const RingEntry* begin, const RingEntry* end, const MovingBoundary& boundary,
              const EdgeDirections& directions)
      : entries_(begin), count_(static_cast<std::size_t>(end - begin)) {
    for (std::size_t k = 0; k < count_; ++k) {
      direction_.push_back(directions.number(boundary.links[begin[k].link].edge));
    }
  }

  void append(std::vector<RingEntry>& corners) {
    struct Change {
      std::uint32_t interval;
      std::uint32_t entry;
      bool begins;
    };
    std::vector<Change> changes;
    for (std::uint32_t k = 0; k < count_; ++k) {
      changes.push_back({entries_[k].first, k, true});
      changes.push_back({entries_[k].last + 1, k, false});
    }
    std::sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
      return a.interval != b.interval ? a.interval < b.interval : a.entry < b.entry;
    });
    there_.assign(count_, 0);
    since_.assign(count_, 0);
    is_corner_.assign(count_, 0);
    std::vector<std::uint32_t> doubtful;
    std::size_t there = 0;
    for (std::size_t k = 0; k < changes.size();) {
      const std::uint32_t interval = changes[k].interval;
      const std::size_t first = k;
      for (; k < changes.size() && changes[k].interval == interval; ++k) {
        const auto& [at, entry, begins] = changes[k];
        if (!begins) close(entry, interval);
        there_[entry] = begins ? 1 : 0;
        begins ? ++there : --there;
      }
      if (there == 0) continue;
      doubtful.clear();
      for (std::size_t c = first; c < k; ++c) {
        const std::uint32_t entry = changes[c].entry;
        if (there_[entry] != 0) doubtful.push_back(entry);
        const std::uint32_t next = neighbour(entry, 1);
        if (there_[next] != 0) doubtful.push_back(next);
      }
      for (const std::uint32_t entry : doubtful) {
        const bool corner = direction_[neighbour(entry, count_ - 1)] != direction_[entry];
        if (corner == (is_corner_[entry] != 0)) continue;
        close(entry, interval);
        is_corner_[entry] = corner ? 1 : 0;
        since_[entry] = interval;
      }
    }
    std::sort(found_.begin(), found_.end());
    for (const auto& [entry, interval, last] : found_) {
      corners.push_back({entries_[entry].link, interval, last});
    }
  }

 private:
  /// The next existing entry by steps of `step`; the entry itself if no other exists.
  std::uint32_t neighbour(std::uint32_t entry, std::size_t step) const {
    std::size_t k = entry;
    do {
      k = (k + step) % count_;
    } while (there_[k] == 0 && k != entry);
    return static_cast<std::uint32_t>(k);
  }

  void close(std::uint32_t entry, std::uint32_t interval) {
    if (is_corner_[entry] != 0 && since_[entry] < interval) {
      found_.push_back({entry, since_[entry], interval - 1});
    }
    is_corner_[entry] = 0;
  }

  const RingEntry* entries_;
  std::size_t count_;
  std::vector<std::uint32_t> direction_, since_;
  std::vector<char> there_, is_corner_;
  struct Found {
    std::uint32_t entry, first, last;
    auto operator<=>(const Found&) const = default;
  };
  std::vector<Found> found_;
};

}  // namespace

void append_corners(const RingEntry* begin, const RingEntry* end, const MovingBoundary& boundary,
                    const EdgeDirections& directions, std::vector<RingEntry>& corners) {
  RingCorners(begin, end, boundary, directions).append(corners);
}

}  // namespace minkref::inline plane
