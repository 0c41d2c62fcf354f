// Contacts of segments from a list: the other first half of the arrangement.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/arrangement/segment_contacts.hpp"

namespace minkref::inline plane {

/// A vertex that cuts a segment, with its place along the segment.
template <class K>
using ListedContact = typename SegmentContacts<K>::Contact;

/// Listed contacts with the interface of SegmentContacts.
template <class K>
class ListedContacts {
 public:
  using Vector = typename K::Vector;
  using Contact = ListedContact<K>;
  using Crossing = typename SegmentContacts<K>::Crossing;

  /// `contacts` name segments by their index among all `count`; segment i of `proper` has the index
  /// name[i]. Leaves out contacts of other segments than `proper`. O(n + k).
  ListedContacts(const std::vector<Vector>& vertices, std::size_t count,
                 const std::vector<IndexedSegment>& proper, const std::vector<std::uint32_t>& name,
                 const std::vector<Contact>& contacts) {
    constexpr std::uint32_t left_out = 0xffffffffU;
    std::vector<std::uint32_t> number(count, left_out);
    for (std::uint32_t i = 0; i < proper.size(); ++i) {
      number[name[i]] = i;
      directions_.push_back(Vector(vertices[proper[i].to] - vertices[proper[i].from]));
    }
    for (const Contact& contact : contacts) {
      if (number[contact.segment] == left_out) continue;
      contacts_.push_back({number[contact.segment], contact.point, contact.position});
    }
  }

  const std::vector<Vector>& directions() const { return directions_; }
  std::vector<Contact>& contacts() { return contacts_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }

 private:
  std::vector<Vector> directions_;
  std::vector<Contact> contacts_;
  std::vector<Crossing> crossings_;  ///< none: every contact is a vertex
};

}  // namespace minkref::inline plane
