// Arrangement: cutting segments at their contacts, merging coincident pieces, ordering edges around
// nodes.
#pragma once

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/arrangement.hpp"

namespace minkref::inline plane {

/// A counting sort: `order` has the items group by group, those of group g from first[g] on; items
/// of one group keep their order.
template <class GroupOf>
void order_by_group(std::size_t items, std::size_t groups, const GroupOf& group_of,
                    std::vector<std::uint32_t>& first, std::vector<std::uint32_t>& order) {
  first.assign(groups + 1, 0);
  for (std::uint32_t i = 0; i < items; ++i) {
    look_for_interrupt();
    ++first[group_of(i) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  order.resize(items);
  std::vector<std::uint32_t> place(first.begin(), first.end());
  for (std::uint32_t i = 0; i < items; ++i) {
    look_for_interrupt();
    order[place[group_of(i)]++] = i;
  }
}

template <class K>
template <class Meet>
void Arrangement<K>::subdivide(const Meet& meet) {
  const auto representative = coincident_vertices(kernel_, vertices_);
  for (IndexedSegment& s : segments_) s = {representative[s.from], representative[s.to]};
  // Degenerate segments keep their index (callers know segments by it) but take no part.
  std::vector<IndexedSegment> proper;
  std::vector<std::uint32_t> name;
  for (std::uint32_t i = 0; i < segments_.size(); ++i) {
    if (segments_[i].from == segments_[i].to) continue;
    proper.push_back(segments_[i]);
    name.push_back(i);
  }
  auto meeting = meet(proper, name);
  auto& contacts = meeting.contacts();
  directions_.resize(segments_.size());
  for (std::uint32_t i = 0; i < proper.size(); ++i) directions_[name[i]] = meeting.directions()[i];

  // Sorts contacts by segment, then by position; contacts at one position share a point.
  std::vector<std::uint32_t> first, order;
  order_by_group(
      contacts.size(), proper.size(), [&](std::uint32_t c) { return contacts[c].segment; }, first,
      order);
  parent_.resize(vertices_.size() + meeting.crossings().size());
  std::iota(parent_.begin(), parent_.end(), 0U);
  std::copy(representative.begin(), representative.end(), parent_.begin());
  for (std::size_t i = 0; i < proper.size(); ++i) {
    look_for_interrupt_now();
    const auto begin = order.begin() + first[i], end = order.begin() + first[i + 1];
    std::stable_sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
      return kernel_.compare(contacts[a].position, contacts[b].position) < 0;
    });
    for (auto c = begin; c != end && c + 1 != end; ++c) {
      if (find(contacts[c[0]].point) == find(contacts[c[1]].point)) continue;
      if (kernel_.compare(contacts[c[0]].position, contacts[c[1]].position) != 0) continue;
      const std::uint32_t a = find(contacts[c[0]].point), b = find(contacts[c[1]].point);
      parent_[std::max(a, b)] = std::min(a, b);  // a vertex represents before a crossing does
    }
  }

  // Numbers nodes along the segments, as met.
  std::vector<std::uint32_t> number(parent_.size(), none);
  const auto node_of = [&](std::uint32_t point) {
    const std::uint32_t root = find(point);
    if (number[root] != none) return number[root];
    number[root] = static_cast<std::uint32_t>(nodes_.size());
    if (root < vertices_.size()) {
      nodes_.push_back(kernel_.node(vertices_[root]));
      provenance_.push_back({none, none, root});
    } else {
      const auto& crossing = meeting.crossings()[root - vertices_.size()];
      const std::uint32_t a = name[crossing.first], b = name[crossing.second];
      const Vector w(vertices_[segments_[b].from] - vertices_[segments_[a].from]);
      nodes_.push_back(kernel_.node(vertices_[segments_[a].from], directions_[a],
                                    kernel_.intersection(w, directions_[a], directions_[b])));
      provenance_.push_back({a, b, none});
    }
    return number[root];
  };
  struct Piece {
    std::uint32_t low, high;
    Cover cover;
  };
  std::vector<Piece> pieces;
  pieces.reserve(proper.size() + contacts.size());
  for (std::uint32_t i = 0; i < proper.size(); ++i) {
    look_for_interrupt_now();
    std::uint32_t previous = node_of(proper[i].from);
    const auto cut = [&](std::uint32_t point) {
      const std::uint32_t n = node_of(point);
      if (n == previous) return;
      pieces.push_back({std::min(previous, n), std::max(previous, n), {name[i], previous < n}});
      previous = n;
    };
    for (std::uint32_t c = first[i]; c < first[i + 1]; ++c) cut(contacts[order[c]].point);
    cut(proper[i].to);
  }
  // Pieces between the same two nodes form one sub-edge.
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    look_for_interrupt();
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  covers_.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    look_for_interrupt();
    if (i == 0 || pieces[i].low != pieces[i - 1].low || pieces[i].high != pieces[i - 1].high) {
      first_cover_.push_back(static_cast<std::uint32_t>(covers_.size()));
      origin_.push_back(pieces[i].low);
      origin_.push_back(pieces[i].high);
    }
    covers_.push_back(pieces[i].cover);
  }
  first_cover_.push_back(static_cast<std::uint32_t>(covers_.size()));
}

template <class K>
void Arrangement<K>::link() {
  order_by_group(
      origin_.size(), nodes_.size(), [&](std::uint32_t h) { return origin_[h]; }, first_leaving_,
      leaving_);
  next_.resize(origin_.size());
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    look_for_interrupt();
    const auto begin = leaving_.begin() + first_leaving_[n];
    const auto end = leaving_.begin() + first_leaving_[n + 1];
    std::stable_sort(begin, end, [&](std::uint32_t g, std::uint32_t h) {
      return angle_less(kernel_, direction(g), direction(h));
    });
    // After arriving by the twin of a leaving half-edge, the face on the left continues with its
    // clockwise neighbour.
    for (auto h = begin; h != end; ++h) next_[*h ^ 1U] = h == begin ? *(end - 1) : *(h - 1);
  }
}

}  // namespace minkref::inline plane
