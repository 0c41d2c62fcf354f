#include "reference/plane/index/ring_order.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/no_entry.hpp"
#include "reference/plane/history/boundary_cycles.hpp"

namespace minkref::inline plane {
namespace {

/// The current links, and each link's successor.
class Successors {
 public:
  Successors(const SweptBoundary& swept, const MovingBoundary& boundary)
      : turns_(swept.moving), boundary_(boundary), out_(boundary.tracks.size()) {}

  void add(std::uint32_t link) { out_[at(link).from].push_back(link); }
  void remove(std::uint32_t link) { std::erase(out_[at(link).from], link); }
  bool leaves_alone(std::uint32_t link) const { return out_[at(link).from].size() == 1; }

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

  /// Whether edge u comes before edge v clockwise from the way back along `arriving`.
  bool is_before(std::uint32_t arriving, std::uint32_t u, std::uint32_t v) const {
    const int side_of_u = turns_.turn(arriving, u), side_of_v = turns_.turn(arriving, v);
    // Edges to the left come first, then edges straight on, then edges to the right.
    return side_of_u != side_of_v ? side_of_u > side_of_v : turns_.turn(u, v) < 0;
  }

  CycleFinder turns_;  // of the directions of edges
  const MovingBoundary& boundary_;
  std::vector<std::vector<std::uint32_t>> out_;
};

/// Links as circles, each link on at most one.
class Circles {
 public:
  explicit Circles(std::size_t links) : next_(links, no_entry), before_(links, no_entry) {}

  std::uint32_t next(std::uint32_t link) const { return next_[link]; }
  std::uint32_t before(std::uint32_t link) const { return before_[link]; }

  void add(const std::vector<std::uint32_t>& links) {
    for (std::size_t k = 0; k < links.size(); ++k) {
      join(links[k], links[k + 1 == links.size() ? 0 : k + 1]);
    }
  }

  /// The way replaces everything between the two.
  void put_between(std::uint32_t from, const std::vector<std::uint32_t>& way, std::uint32_t to) {
    std::uint32_t last = from;
    for (const std::uint32_t link : way) {
      join(last, link);
      last = link;
    }
    join(last, to);
  }

 private:
  void join(std::uint32_t link, std::uint32_t other) {
    next_[link] = other;
    before_[other] = link;
  }

  std::vector<std::uint32_t> next_, before_;
};

class Builder {
 public:
  Builder(const SweptBoundary& swept, const MovingBoundary& boundary,
          const EdgeDirections& directions, const BuildControl& control)
      : boundary_(boundary),
        directions_(directions),
        control_(control),
        successors_(swept, boundary),
        place_(boundary.tracks.size(), no_entry),
        changes_(boundary.events.size()),
        begin_(boundary.events.size() + 1),
        end_(boundary.events.size() + 1),
        there_(boundary.links.size()),
        entries_(boundary.links.size()),
        is_traced_(boundary.links.size()) {
    for (std::uint32_t k = 0; k < boundary.links.size(); ++k) {
      begin_[boundary.links[k].first].push_back(k);
      end_[boundary.links[k].last].push_back(k);
    }
  }

  RingOrder run() {
    for (const std::uint32_t link : begin_[0]) insert(link);
    start_bucket(0);
    for (std::uint32_t interval = 1; interval < begin_.size(); ++interval) {
      control_.look();
      const std::vector<std::uint32_t>&ended = end_[interval - 1], &begun = begin_[interval];
      for (const std::uint32_t link : ended) successors_.remove(link);
      for (const std::uint32_t link : begun) insert(link);
      live_ -= ended.size();
      if (size_ > live_ * 3 / 2 + 64 || !mend(interval, ended, begun)) {
        finish_bucket(interval - 1);
        start_bucket(interval);
      }
    }
    finish_bucket(static_cast<std::uint32_t>(begin_.size() - 1));
    return {std::move(buckets_), std::move(changes_)};
  }

 private:
  /// A gap left by ending links of a ring: beginning links replace them between the two remaining
  /// links.
  struct Gap {
    std::uint32_t from, to;
    std::vector<std::uint32_t> way;
  };

  void insert(std::uint32_t link) {
    successors_.add(link);
    in_order_.push_back(link);
    ++live_;
  }

  /// All rings anew.
  void start_bucket(std::uint32_t interval) {
    heads_.clear();
    size_ = 0;
    first_ = interval;
    std::erase_if(in_order_, [&](std::uint32_t k) { return boundary_.links[k].last < interval; });
    for (const std::uint32_t link : in_order_) is_traced_[link] = 0;
    for (const std::uint32_t link : in_order_) {
      if (is_traced_[link] == 0) trace(link);
    }
  }

  /// Traces a link's walk, split wherever it returns to a track.
  void trace(std::uint32_t start) {
    std::vector<std::uint32_t> path;
    std::uint32_t link = start;
    do {
      control_.look();
      if (is_traced_[link] != 0) throw std::logic_error("rings of the swept sum run together");
      place_[boundary_.links[link].from] = static_cast<std::uint32_t>(path.size());
      path.push_back(link);
      is_traced_[link] = 1;
      const std::uint32_t again = place_[boundary_.links[link].to];
      link = successors_.next(link);
      if (again == no_entry) continue;
      const std::vector<std::uint32_t> ring(path.begin() + again, path.end());
      path.resize(again);
      for (const std::uint32_t other : ring) place_[boundary_.links[other].from] = no_entry;
      add_ring(ring);
    } while (link != start);
    if (!path.empty()) throw std::logic_error("a ring of the swept sum is not closed");
  }

  void add_ring(const std::vector<std::uint32_t>& links) {
    heads_.push_back(links.front());
    there_.add(links);
    entries_.add(links);
    size_ += links.size();
  }

  /// Replaces ending links by beginning links. False if rings merge, split or touch.
  bool mend(std::uint32_t interval, const std::vector<std::uint32_t>& ended,
            const std::vector<std::uint32_t>& begun) {
    for (const std::uint32_t link : begun) {
      if (!successors_.leaves_alone(link)) return false;
    }
    const auto goes_on = [&](std::uint32_t link) { return boundary_.links[link].last >= interval; };
    unplaced_ = begun;
    std::vector<Gap> gaps;
    std::size_t in_gaps = 0;
    for (const std::uint32_t link : ended) {
      if (!goes_on(there_.before(link))) continue;  // not the first of its gap, or no link goes on
      Gap gap{there_.before(link), link, {}};
      for (; !goes_on(gap.to); ++in_gaps) {
        if (in_gaps == ended.size()) throw std::logic_error("a gap in a ring has no end");
        gap.to = there_.next(gap.to);
      }
      if (!find_way(gap)) return false;
      gaps.push_back(std::move(gap));
    }
    RingChange change;
    change.same_rings = in_gaps == ended.size() && unplaced_.empty();
    if (!compare_corners(gaps, change)) return false;
    for (const Gap& gap : gaps) fill(gap);
    while (!unplaced_.empty()) {
      if (!new_ring()) return false;
    }
    changes_[interval - 1] = change;
    return true;
  }

  bool find_way(Gap& gap) {
    for (std::uint32_t link = gap.from;;) {
      link = successors_.next(link);
      if (link == gap.to) return true;
      if (!take(link)) return false;
      gap.way.push_back(link);
    }
  }

  /// Takes a beginning link; false for any other link.
  bool take(std::uint32_t link) {
    const auto found = std::find(unplaced_.begin(), unplaced_.end(), link);
    if (found == unplaced_.end()) return false;
    unplaced_.erase(found);
    return true;
  }

  void fill(const Gap& gap) {
    const std::uint32_t last_ended = there_.before(gap.to);
    there_.put_between(gap.from, gap.way, gap.to);
    entries_.put_between(last_ended, gap.way, entries_.next(last_ended));
    size_ += gap.way.size();
  }

  /// Adds a ring of beginning links only.
  bool new_ring() {
    const std::uint32_t start = unplaced_.front();
    std::vector<std::uint32_t> links;
    std::uint32_t link = start;
    do {
      if (!take(link)) return false;
      links.push_back(link);
      link = successors_.next(link);
    } while (link != start);
    add_ring(links);
    return true;
  }

  /// Compares the corners of a ring, by tracks, which change inside its gaps only. False if the
  /// same corners come in another order, or in other gaps: then only the whole rings tell.
  bool compare_corners(const std::vector<Gap>& gaps, RingChange& change) const {
    std::vector<std::uint32_t> below, here;
    bool is_same_in_each = true;
    for (const Gap& gap : gaps) {
      const std::size_t first_below = below.size(), first = here.size();
      std::uint32_t before = gap.from;
      const auto pass = [&](std::uint32_t link, std::vector<std::uint32_t>& corners) {
        if (is_corner(before, link)) corners.push_back(boundary_.links[link].from);
        before = link;
      };
      std::uint32_t link = gap.from;
      do {
        link = there_.next(link);
        pass(link, below);
      } while (link != gap.to);
      before = gap.from;
      for (const std::uint32_t begun : gap.way) pass(begun, here);
      pass(gap.to, here);
      is_same_in_each =
          is_same_in_each &&
          std::equal(below.begin() + static_cast<std::ptrdiff_t>(first_below), below.end(),
                     here.begin() + static_cast<std::ptrdiff_t>(first), here.end());
    }
    change.same_vertices = is_same_in_each;
    if (is_same_in_each) return true;
    change.more_vertices =
        static_cast<std::int64_t>(here.size()) - static_cast<std::int64_t>(below.size());
    std::sort(below.begin(), below.end());
    std::sort(here.begin(), here.end());
    return below != here;
  }

  bool is_corner(std::uint32_t before, std::uint32_t link) const {
    return directions_.number(boundary_.links[before].edge) !=
           directions_.number(boundary_.links[link].edge);
  }

  void finish_bucket(std::uint32_t last) {
    RingBucket& bucket = buckets_.emplace_back();
    bucket.first = first_;
    bucket.last = last;
    std::size_t passed = 0;
    for (const std::uint32_t head : heads_) {
      std::uint32_t link = head;
      do {
        control_.look();
        if (passed++ == size_) throw std::logic_error("entries of rings run together");
        const MovingLink& of = boundary_.links[link];
        if (of.first <= last) {
          bucket.entries.push_back({link, std::max(of.first, first_), std::min(of.last, last)});
        }
        link = entries_.next(link);
      } while (link != head);
      const auto end = static_cast<std::uint32_t>(bucket.entries.size());
      if (bucket.ring_ends.empty() ? end > 0 : bucket.ring_ends.back() < end) {
        bucket.ring_ends.push_back(end);
      }
    }
  }

  const MovingBoundary& boundary_;
  const EdgeDirections& directions_;
  const BuildControl& control_;
  Successors successors_;
  std::vector<std::uint32_t> place_;  // of a track in the path that is being traced
  std::vector<RingChange> changes_;
  std::vector<std::vector<std::uint32_t>> begin_, end_;  // links by their intervals
  std::vector<RingBucket> buckets_;
  std::vector<std::uint32_t> in_order_;  // links that are there, and some that ended
  std::size_t live_ = 0;
  // The bucket under construction:
  std::uint32_t first_ = 0;
  std::size_t size_ = 0;              // of its entries
  std::vector<std::uint32_t> heads_;  // the first entry of each ring
  Circles there_, entries_;           // the current rings; with ended links
  std::vector<char> is_traced_;
  std::vector<std::uint32_t> unplaced_;
};

}  // namespace

RingOrder ring_order(const SweptBoundary& swept, const MovingBoundary& boundary,
                     const EdgeDirections& directions, const BuildControl& control) {
  return Builder(swept, boundary, directions, control).run();
}

}  // namespace minkref::inline plane
