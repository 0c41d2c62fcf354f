// Contacts of an edge with a placed sum: where the sum's boundary meets it, and on which side.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "reference/scene/scene_sum.hpp"

namespace minkref::inline scene {

/// A point inside of the edge at which something changes. `right`: by so much the winding number of
/// the sum grows at a point beside the edge, infinitely near on its right; `along`: by so much the
/// number of the sum's edges that run along the edge, either way, tight passages among them.
struct EdgeContact {
  double t = 0, error = 0;      ///< the share of the edge before it, a number within `error` of t
  std::uint32_t neighbour = 0;  ///< the caller's name for the sum
  std::uint32_t edge = 0;       ///< of the sum
  std::uint32_t vertex = 0;     ///< of the sum, unless the edges cross: no_entry
  std::int8_t right = 0, along = 0;
  mutable std::int32_t exact = -1;  ///< where t is kept exactly, once somebody has asked for it
};

/// How a sum meets an edge's ends: a start that is touched has to be located, see winding_beside.
struct EndContacts {
  bool start = false, end = false;  ///< some edge of the sum contains it
  std::uint32_t along = 0;          ///< edges of the sum that run along the edge from its start on
};

/// An edge with its line, ready to meet sums. Keep no contacts of an older edge.
class ContactEdge {
 public:
  void set(const FilteredPoint& from, const FilteredPoint& to, const Box& box);

  /// Appends the contacts with a sum, unsorted. Exact. Linear in the sum's edges near the edge.
  EndContacts meet(const PlacedSum& sum, std::uint32_t neighbour,
                   std::vector<EdgeContact>& contacts) const;
  /// Appends the contact with a sum's vertex, which lies inside of the edge.
  void touch(const PlacedSum& sum, std::uint32_t vertex, EdgeContact contact,
             std::vector<EdgeContact>& contacts) const;

  /// The winding number of the sum at a point beside the edge, infinitely near to its start, on its
  /// right. Exact. Linear in the sum's edges level with the start, to its right.
  int winding_beside(const PlacedSum& sum) const;

  /// Along the edge. Exact. `sums(neighbour)` gives the sum by the caller's name.
  template <class Sums>
  bool before(const EdgeContact& a, const EdgeContact& b, Sums&& sums) {
    const int order = certain_order(a, b);
    return (order != 0 ? order : exact_order(a, sums(a.neighbour), b, sums(b.neighbour))) < 0;
  }

  /// The point of a contact.
  FilteredPoint point(const EdgeContact& contact, const PlacedSum& sum);

 private:
  struct SumEdge;

  /// Where a point of the line lies: before the edge, at its start, inside, at its end, behind.
  enum Part : std::int8_t { ahead = -2, at_start = -1, inside = 0, at_end = 1, behind = 2 };
  Part part(const FilteredPoint& on_line) const;
  /// The order of two points of the line.
  int order(const FilteredPoint& a, const FilteredPoint& b) const;
  void meet_along(const SumEdge& other, EndContacts& ends,
                  std::vector<EdgeContact>& contacts) const;
  void meet_at_vertex(const SumEdge& other, bool starts, int side, EndContacts& ends,
                      std::vector<EdgeContact>& contacts) const;
  void meet_across(const SumEdge& other, int side, EndContacts& ends,
                   std::vector<EdgeContact>& contacts) const;
  void touch_end(const SumEdge& other, bool starts, int right, int along,
                 std::vector<EdgeContact>& contacts) const;

  static int certain_order(const EdgeContact& a, const EdgeContact& b);
  int exact_order(const EdgeContact& a, const PlacedSum& sum_a, const EdgeContact& b,
                  const PlacedSum& sum_b);
  const Rational& exact(const EdgeContact& contact, const PlacedSum& sum);

  const FilteredPoint *from_ = nullptr, *to_ = nullptr;
  Box box_;
  bool by_x_ = true;  ///< the line is measured along x
  int way_ = 1;       ///< the edge's direction along that axis
  std::deque<Rational> exact_;
};

}  // namespace minkref::inline scene
