// The faces' winding numbers about closed curves of signed segments.
#pragma once

#include <vector>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/arrangement.hpp"

namespace minkref::inline plane {

/// Each face's winding number: the signed count of segments crossed on the way from the unbounded
/// face. `sign_of_segment(i)` gives segment i's multiplicity. Exact. O(size of the arrangement).
template <class K, class Sign>
std::vector<int> winding_numbers(const Arrangement<K>& arrangement, Sign&& sign_of_segment) {
  std::vector<int> winding(arrangement.face_count(), 0);
  std::vector<bool> known(arrangement.face_count(), false);
  std::vector<std::uint32_t> queue{0};
  known[0] = true;
  while (!queue.empty()) {
    look_for_interrupt();
    const std::uint32_t face = queue.back();
    queue.pop_back();
    arrangement.for_each_half_edge(face, [&](std::uint32_t h) {
      const std::uint32_t other = arrangement.face(h ^ 1U);
      if (known[other]) return;
      int step = 0;  // from the left of h to its right
      for (auto cover = arrangement.covers_begin(h); cover != arrangement.covers_end(h); ++cover) {
        step += arrangement.runs_with(h, *cover) ? -sign_of_segment(cover->segment)
                                                 : sign_of_segment(cover->segment);
      }
      known[other] = true;
      winding[other] = winding[face] + step;
      queue.push_back(other);
    });
  }
  return winding;
}

}  // namespace minkref::inline plane
