#include "reference/plane/dynamic/node_lists.hpp"

#include <algorithm>
#include <array>

#include "reference/interrupt.hpp"

namespace minkref::inline plane {

NodeLists::NodeLists(const ArrangementTimeline& timeline)
    : timeline_(timeline), length_(timeline.initial.size()) {
  allot();
  for (std::size_t e = 0; e < length_.size(); ++e) {
    const auto& nodes = timeline_.initial[e];
    length_[e] = static_cast<std::uint32_t>(nodes.size());
    std::copy(nodes.begin(), nodes.end(), slots_.begin() + first_slot_[e]);
    initial_size_ += nodes.size();
  }
  take_snapshots();
  load(snapshots_.front());
}

void NodeLists::allot() {
  std::vector<std::uint32_t> now(length_.size()), most;
  for (std::size_t e = 0; e < now.size(); ++e) {
    now[e] = static_cast<std::uint32_t>(timeline_.initial[e].size());
  }
  most = now;
  for (const PackedChange& change : timeline_.changes) {
    look_for_interrupt();
    const std::uint32_t e = timeline_.edge_of_node[change.node];
    if (change.kind() == NodeChange::Kind::insertion) most[e] = std::max(most[e], ++now[e]);
    if (change.kind() == NodeChange::Kind::deletion) --now[e];
  }
  std::uint32_t total = 0;
  for (const std::uint32_t count : most) {
    first_slot_.push_back(total);
    total += count;
  }
  slots_.resize(total);
}

/// Changes between two snapshots.
std::size_t NodeLists::spacing() const {
  constexpr std::size_t room = std::size_t{64} << 20;
  const std::size_t bytes = (slots_.size() + length_.size()) * sizeof(std::uint32_t);
  const std::size_t changes = timeline_.changes.size();
  const std::size_t most = std::max(room, changes * sizeof(PackedChange)) / (bytes + 1) + 1;
  return std::max(changes / most, (slots_.size() + length_.size()) / 32) + 16;
}

/// The cost of loading a snapshot, counted as changes: copying is fast.
std::size_t NodeLists::load_cost() const { return (slots_.size() + length_.size()) / 64 + 8; }

void NodeLists::take_snapshots() {
  const auto take = [&] { snapshots_.push_back({place_, counts_, length_, slots_}); };
  const std::size_t changes_between = spacing();
  take();
  const auto steps = static_cast<std::uint32_t>(timeline_.first_change.size() - 1);
  for (std::uint32_t p = 0; p < steps; ++p) {
    walk(p + 1);
    for (std::size_t i = timeline_.first_change[p]; i < timeline_.first_change[p + 1]; ++i) {
      const auto kind = timeline_.changes[i].kind();
      counts_.insertions += kind == NodeChange::Kind::insertion;
      counts_.deletions += kind == NodeChange::Kind::deletion;
      counts_.swaps += kind == NodeChange::Kind::swap;
    }
    if (distance(snapshots_.back().place, p + 1) >= changes_between) take();
  }
}

ChangeCounts NodeLists::move_to(std::uint32_t place) {
  const ChangeCounts here = counts_, there = counts_at(place);
  const bool up = there.insertions + there.deletions + there.swaps >=
                  here.insertions + here.deletions + here.swaps;
  const std::uint32_t from = place_;
  const Snapshot& snapshot = nearest(place);
  try {
    if (load_cost() + distance(snapshot.place, place) < distance(from, place)) load(snapshot);
    walk(place);
  } catch (...) {
    const Interruptible deaf([] {});
    if (place_ != from) load(nearest(from));
    walk(from);
    counts_ = here;
    throw;
  }
  counts_ = there;
  if (up) {
    return {there.insertions - here.insertions, there.deletions - here.deletions,
            there.swaps - here.swaps};
  }
  return {here.deletions - there.deletions, here.insertions - there.insertions,
          here.swaps - there.swaps};
}

const NodeLists::Snapshot& NodeLists::nearest(std::uint32_t place) const {
  auto after = std::upper_bound(snapshots_.begin(), snapshots_.end(), place,
                                [](std::uint32_t p, const Snapshot& s) { return p < s.place; });
  const auto before = after - 1;
  if (after == snapshots_.end()) return *before;
  return distance(before->place, place) <= distance(place, after->place) ? *before : *after;
}

ChangeCounts NodeLists::counts_at(std::uint32_t place) const {
  const auto after =
      std::upper_bound(snapshots_.begin(), snapshots_.end(), place,
                       [](std::uint32_t p, const Snapshot& s) { return p < s.place; });
  const Snapshot& from = *(after - 1);
  std::array<std::uint64_t, 4> counts{};
  const std::size_t end = timeline_.first_change[place];
  for (std::size_t i = timeline_.first_change[from.place]; i < end; ++i) {
    if (i % 64 == 0) look_for_interrupt();
    ++counts[timeline_.changes[i].rank_and_kind & 3];
  }
  return {from.before.insertions + counts[0], from.before.deletions + counts[1],
          from.before.swaps + counts[2]};
}

std::size_t NodeLists::distance(std::uint32_t a, std::uint32_t b) const {
  const std::size_t x = timeline_.first_change[a], y = timeline_.first_change[b];
  return x < y ? y - x : x - y;
}

void NodeLists::load(const Snapshot& snapshot) {
  length_ = snapshot.length;
  slots_ = snapshot.slots;
  place_ = snapshot.place;
  counts_ = snapshot.before;
}

/// An interrupt leaves the lists as they were.
void NodeLists::walk(std::uint32_t place) {
  using Kind = NodeChange::Kind;
  bool up = place_ < place;
  const auto apply = [&](const PackedChange& change) {
    const Kind kind = change.kind();
    if (kind == Kind::swap || kind == Kind::settling) {
      std::uint32_t* at =
          slots_.data() + first_slot_[timeline_.edge_of_node[change.node]] + change.rank();
      std::swap(at[0], at[1]);
    } else if ((kind == Kind::insertion) == up) {
      insert(change.node, change.rank());
    } else {
      erase(change.node, change.rank());
    }
  };
  const std::size_t begin = timeline_.first_change[place_], end = timeline_.first_change[place];
  std::size_t i = begin;
  try {
    for (; i < end; ++i) {
      look_for_interrupt();
      apply(timeline_.changes[i]);
    }
    for (; i > end; --i) {
      look_for_interrupt();
      apply(timeline_.changes[i - 1]);
    }
  } catch (...) {
    up = !up;
    while (i > begin) apply(timeline_.changes[--i]);
    while (i < begin) apply(timeline_.changes[i++]);
    throw;
  }
  place_ = place;
}

void NodeLists::insert(std::uint32_t node, std::uint32_t rank) {
  const std::uint32_t e = timeline_.edge_of_node[node];
  std::uint32_t* list = slots_.data() + first_slot_[e];
  std::copy_backward(list + rank, list + length_[e], list + length_[e] + 1);
  list[rank] = node;
  ++length_[e];
}

void NodeLists::erase(std::uint32_t node, std::uint32_t rank) {
  const std::uint32_t e = timeline_.edge_of_node[node];
  std::uint32_t* list = slots_.data() + first_slot_[e];
  std::copy(list + rank + 1, list + length_[e], list + rank);
  --length_[e];
}

}  // namespace minkref::inline plane
