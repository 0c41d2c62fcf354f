#include "reference/scalespace/ring_order.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/plane/dynamic/boundary_cycles.hpp"

namespace minkref {
namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// The links that are there, and which comes next.
class Successors {
 public:
  Successors(const SweptBoundary& swept, const MovingBoundary& boundary)
      : turns_(swept.moving), boundary_(boundary), out_(boundary.tracks.size()) {}

  void add(std::uint32_t link) { out_[at(link).from].push_back(link); }
  void remove(std::uint32_t link) { std::erase(out_[at(link).from], link); }

  /// Along the component of the interior on the left.
  std::uint32_t next(std::uint32_t link) const {
    const std::vector<std::uint32_t>& leaving = out_[at(link).to];
    if (leaving.empty()) throw std::logic_error("the boundary of the swept sum is not closed");
    std::uint32_t best = leaving[0];
    for (const std::uint32_t other : leaving) {
      if (other != best && is_before(at(link).edge, at(other).edge, at(best).edge)) {
        best = other;
      }
    }
    return best;
  }

 private:
  const MovingLink& at(std::uint32_t link) const { return boundary_.links[link]; }

  /// Of edges: whether u comes before v clockwise from the way back along `arriving`.
  bool is_before(std::uint32_t arriving, std::uint32_t u, std::uint32_t v) const {
    const int side_of_u = turns_.turn(arriving, u), side_of_v = turns_.turn(arriving, v);
    // What is to the left comes first, then what goes straight on, then what is to the right.
    return side_of_u != side_of_v ? side_of_u > side_of_v : turns_.turn(u, v) < 0;
  }

  CycleFinder turns_;  // of the directions of edges
  const MovingBoundary& boundary_;
  std::vector<std::vector<std::uint32_t>> out_;
};

class Builder {
 public:
  Builder(const SweptBoundary& swept, const MovingBoundary& boundary,
          const EdgeDirections& directions)
      : boundary_(boundary),
        directions_(directions),
        successors_(swept, boundary),
        ring_of_(boundary.links.size(), none),
        place_(boundary.tracks.size(), none),
        next_corner_(boundary.tracks.size(), none),
        changes_(boundary.events.size()),
        begin_(boundary.events.size() + 1),
        end_(boundary.events.size() + 1) {
    for (std::uint32_t k = 0; k < boundary.links.size(); ++k) {
      begin_[boundary.links[k].first].push_back(k);
      end_[boundary.links[k].last].push_back(k);
    }
  }

  RingOrder run() {
    for (const std::uint32_t link : begin_[0]) insert(link);
    start_bucket(0);
    for (std::uint32_t interval = 1; interval < begin_.size(); ++interval) {
      const std::vector<std::uint32_t>&ended = end_[interval - 1], &begun = begin_[interval];
      for (const std::uint32_t link : ended) {
        successors_.remove(link);
        std::erase(live_, link);
      }
      for (const std::uint32_t link : begun) insert(link);
      if (size_ > live_.size() * 3 / 2 + 64 || !mend(interval, ended, begun)) {
        finish_bucket(interval - 1);
        start_bucket(interval);
      }
    }
    finish_bucket(static_cast<std::uint32_t>(begin_.size() - 1));
    return {std::move(buckets_), std::move(changes_)};
  }

 private:
  using Ring = std::vector<RingEntry>;

  void insert(std::uint32_t link) {
    successors_.add(link);
    live_.push_back(link);
  }

  /// All rings anew.
  void start_bucket(std::uint32_t interval) {
    rings_.clear();
    size_ = 0;
    first_ = interval;
    for (const std::uint32_t link : live_) ring_of_[link] = none;
    for (const std::uint32_t link : live_) {
      if (ring_of_[link] == none) trace(link, interval);
    }
  }

  /// The walk of a link, split where it comes to a track again.
  void trace(std::uint32_t start, std::uint32_t interval) {
    std::vector<std::uint32_t> path;
    std::uint32_t link = start;
    do {
      place_[boundary_.links[link].from] = static_cast<std::uint32_t>(path.size());
      path.push_back(link);
      ring_of_[link] = 0;
      const std::uint32_t again = place_[boundary_.links[link].to];
      link = successors_.next(link);
      if (again == none) continue;
      const std::vector<std::uint32_t> ring(path.begin() + again, path.end());
      path.resize(again);
      for (const std::uint32_t other : ring) place_[boundary_.links[other].from] = none;
      add_ring(ring, interval);
    } while (link != start);
    if (!path.empty()) throw std::logic_error("a ring of the swept sum is not closed");
  }

  void add_ring(const std::vector<std::uint32_t>& links, std::uint32_t interval) {
    Ring& ring = rings_.emplace_back();
    for (const std::uint32_t link : links) {
      ring.push_back({link, interval, boundary_.links[link].last});
      ring_of_[link] = static_cast<std::uint32_t>(rings_.size() - 1);
    }
    size_ += links.size();
  }

  /// Puts links that begin in the place of those that end. False where rings merge, split or touch.
  bool mend(std::uint32_t interval, const std::vector<std::uint32_t>& ended,
            const std::vector<std::uint32_t>& begun) {
    std::vector<std::uint32_t> rings;
    for (const std::uint32_t link : ended) rings.push_back(ring_of_[link]);
    std::sort(rings.begin(), rings.end());
    rings.erase(std::unique(rings.begin(), rings.end()), rings.end());
    unplaced_ = begun;
    for (const std::uint32_t link : begun) ring_of_[link] = none;
    RingChange change{true, true, 0};
    for (const std::uint32_t ring : rings) {
      if (!mend_ring(ring, interval, change)) return false;
    }
    change.same_rings = change.same_rings && unplaced_.empty();
    while (!unplaced_.empty()) {
      if (!new_ring(interval)) return false;
    }
    changes_[interval - 1] = change;
    return true;
  }

  /// Where a ring turns in an interval, by tracks.
  void find_corners(const Ring& ring, std::uint32_t interval, std::vector<std::uint32_t>& corners) {
    corners.clear();
    std::uint32_t first = none, direction = none, first_track = none;
    for (const RingEntry& entry : ring) {
      if (entry.first > interval || entry.last < interval) continue;
      const MovingLink& link = boundary_.links[entry.link];
      const std::uint32_t own = directions_.number(link.edge);
      if (first == none) {
        first = own;
        first_track = link.from;
      } else if (own != direction) {
        corners.push_back(link.from);
      }
      direction = own;
    }
    if (first != none && first != direction) corners.push_back(first_track);
  }

  void compare_corners(const Ring& ring, std::uint32_t interval, RingChange& change) {
    find_corners(ring, interval - 1, corners_below_);
    find_corners(ring, interval, corners_);
    change.more_vertices += static_cast<std::int64_t>(corners_.size()) -
                            static_cast<std::int64_t>(corners_below_.size());
    change.same_vertices = change.same_vertices && corners_.size() == corners_below_.size();
    if (!change.same_vertices) return;
    const auto next = [](const std::vector<std::uint32_t>& corners, std::size_t k) {
      return corners[k + 1 == corners.size() ? 0 : k + 1];
    };
    for (std::size_t k = 0; k < corners_below_.size(); ++k) {
      next_corner_[corners_below_[k]] = next(corners_below_, k);
    }
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      change.same_vertices = change.same_vertices && next_corner_[corners_[k]] == next(corners_, k);
    }
    for (const std::uint32_t corner : corners_below_) next_corner_[corner] = none;
  }

  bool mend_ring(std::uint32_t number, std::uint32_t interval, RingChange& change) {
    Ring& ring = rings_[number];
    std::vector<std::size_t> there;  // entries just below
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (ring[k].first < interval && ring[k].last + 1 >= interval) there.push_back(k);
    }
    const auto goes_on = [&](std::size_t k) { return ring[k].last >= interval; };
    const auto anchor = std::find_if(there.begin(), there.end(), goes_on);
    if (anchor == there.end()) {  // the ring vanishes, or is made of new links
      change.same_rings = false;
      return true;
    }
    std::rotate(there.begin(), anchor, there.end());
    std::vector<std::pair<std::size_t, std::vector<std::uint32_t>>> insertions;
    for (std::size_t k = 0; k < there.size();) {
      std::size_t next = k + 1;
      while (next < there.size() && !goes_on(there[next])) ++next;
      const std::uint32_t before = ring[there[k]].link,
                          behind = ring[there[next % there.size()]].link;
      std::vector<std::uint32_t> way;
      for (std::uint32_t link = before;;) {
        link = successors_.next(link);
        if (link == behind) break;
        const auto found = std::find(unplaced_.begin(), unplaced_.end(), link);
        if (found == unplaced_.end()) return false;
        unplaced_.erase(found);
        way.push_back(link);
      }
      if (!way.empty()) insertions.emplace_back(there[next - 1] + 1, std::move(way));
      k = next;
    }
    std::sort(insertions.begin(), insertions.end(),
              [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [place, links] : insertions) {
      std::vector<RingEntry> entries;
      for (const std::uint32_t link : links) {
        entries.push_back({link, interval, boundary_.links[link].last});
        ring_of_[link] = number;
      }
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(place), entries.begin(),
                  entries.end());
      size_ += entries.size();
    }
    compare_corners(ring, interval, change);
    return !touches_itself(ring, interval);
  }

  bool touches_itself(const Ring& ring, std::uint32_t interval) {
    bool result = false;
    passed_.clear();
    for (const RingEntry& entry : ring) {
      if (entry.first > interval || entry.last < interval) continue;
      const std::uint32_t track = boundary_.links[entry.link].from;
      result = result || place_[track] != none;
      place_[track] = 0;
      passed_.push_back(track);
    }
    for (const std::uint32_t track : passed_) place_[track] = none;
    return result;
  }

  /// Of links that begin, and nothing else.
  bool new_ring(std::uint32_t interval) {
    const std::uint32_t start = unplaced_.front();
    std::vector<std::uint32_t> links;
    std::uint32_t link = start;
    do {
      const auto found = std::find(unplaced_.begin(), unplaced_.end(), link);
      if (found == unplaced_.end()) return false;
      unplaced_.erase(found);
      links.push_back(link);
      link = successors_.next(link);
    } while (link != start);
    add_ring(links, interval);
    return !touches_itself(rings_.back(), interval);
  }

  void finish_bucket(std::uint32_t last) {
    RingBucket& bucket = buckets_.emplace_back();
    bucket.first = first_;
    bucket.last = last;
    for (const Ring& ring : rings_) {
      for (RingEntry entry : ring) {
        if (entry.first > last) continue;
        entry.last = std::min(entry.last, last);
        bucket.entries.push_back(entry);
      }
      const auto end = static_cast<std::uint32_t>(bucket.entries.size());
      if (bucket.ring_ends.empty() ? end > 0 : bucket.ring_ends.back() < end) {
        bucket.ring_ends.push_back(end);
      }
    }
  }

  const MovingBoundary& boundary_;
  const EdgeDirections& directions_;
  Successors successors_;
  std::vector<std::uint32_t> live_;
  std::vector<std::uint32_t> ring_of_;
  std::vector<std::uint32_t> place_;        // of a track in the path that is being traced
  std::vector<std::uint32_t> next_corner_;  // of a track, in the ring that is being compared
  std::vector<std::uint32_t> corners_below_, corners_, passed_;
  std::vector<RingChange> changes_;
  std::vector<std::vector<std::uint32_t>> begin_, end_;  // links by their intervals
  std::vector<RingBucket> buckets_;
  // Of the bucket that is being made:
  std::uint32_t first_ = 0;
  std::size_t size_ = 0;
  std::vector<Ring> rings_;
  std::vector<std::uint32_t> unplaced_;
};

}  // namespace

RingOrder ring_order(const SweptBoundary& swept, const MovingBoundary& boundary,
                     const EdgeDirections& directions) {
  return Builder(swept, boundary, directions).run();
}

}  // namespace minkref
