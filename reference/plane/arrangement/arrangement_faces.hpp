// Arrangement: cycles of half-edges, and the faces that hold them.
#pragma once

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/arrangement/ray_tree.hpp"

namespace minkref::inline plane {

template <class K>
bool Arrangement<K>::left_of(std::uint32_t h, std::uint32_t n) const {
  const Node& low = nodes_[origin_[h]];
  const Node& high = nodes_[target(h)];
  const Node& point = nodes_[n];
  return kernel_.compare_y(low, point) <= 0 && kernel_.compare_y(point, high) < 0 &&
         kernel_.orientation(low, high, point) < 0;
}

template <class K>
bool Arrangement<K>::is_right_of(std::uint32_t g, std::uint32_t h) const {
  const Node &g0 = nodes_[origin_[g]], &h0 = nodes_[origin_[h]];
  if (origin_[g] == origin_[h]) return kernel_.turn(direction(h), direction(g)) < 0;
  // The higher start lies within the other's range of heights.
  if (kernel_.compare_y(g0, h0) >= 0) return kernel_.orientation(h0, nodes_[target(h)], g0) < 0;
  return kernel_.orientation(g0, nodes_[target(g)], h0) > 0;
}

template <class K>
void Arrangement<K>::find_faces() {
  // Connected components of the graph, each with its lexicographically least node.
  std::vector<std::uint32_t> component(nodes_.size(), none), least, stack;
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const int x = kernel_.compare_x(nodes_[a], nodes_[b]);
    return x != 0 ? x < 0 : kernel_.compare_y(nodes_[a], nodes_[b]) < 0;
  };
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    if (component[n] != none || leaving_begin(n) == leaving_end(n)) continue;
    const auto c = static_cast<std::uint32_t>(least.size());
    least.push_back(n);
    component[n] = c;
    stack.push_back(n);
    while (!stack.empty()) {
      look_for_interrupt();
      const std::uint32_t at = stack.back();
      stack.pop_back();
      if (at != least[c] && before(at, least[c])) least[c] = at;
      for (auto h = leaving_begin(at); h != leaving_end(at); ++h) {
        const std::uint32_t to = target(*h);
        if (component[to] != none) continue;
        component[to] = c;
        stack.push_back(to);
      }
    }
  }

  // All edges of a component's least node point to the right, so the last edge by angle has the
  // component's outside on its left. Every other cycle is the outer boundary of a bounded face.
  std::vector<bool> outside(origin_.size(), false);
  for (const std::uint32_t n : least) {
    const std::uint32_t first = *(leaving_end(n) - 1);
    std::uint32_t h = first;
    do {
      outside[h] = true;
      h = next_[h];
    } while (h != first);
  }
  face_.assign(origin_.size(), none);
  face_cycles_.emplace_back();  // the unbounded face
  for (std::uint32_t h = 0; h < origin_.size(); ++h) {
    look_for_interrupt();
    if (outside[h] || face_[h] != none) continue;
    face_cycles_.emplace_back();
    mark_cycle(h, static_cast<std::uint32_t>(face_cycles_.size() - 1));
  }

  // From left to right: all cycles farther left already have a face.
  std::stable_sort(least.begin(), least.end(), before);
  place_components(component, least);
}

template <class K>
void Arrangement<K>::mark_cycle(std::uint32_t first, std::uint32_t face) {
  face_cycles_[face].push_back(first);
  std::uint32_t h = first;
  do {
    face_[h] = face;
    h = next_[h];
  } while (h != first);
}

template <class K>
void Arrangement<K>::place_components(const std::vector<std::uint32_t>& component,
                                      const std::vector<std::uint32_t>& least) {
  std::vector<std::uint32_t> upward;
  std::vector<Box> boxes;
  if (least.size() > 1) {
    for (std::uint32_t h = 0; h < origin_.size(); h += 2) {
      look_for_interrupt();
      const int y = kernel_.compare_y(nodes_[origin_[h]], nodes_[target(h)]);
      if (y == 0) continue;
      upward.push_back(y < 0 ? h : h ^ 1U);
      boxes.push_back(kernel_.box(nodes_[origin_[h]]));
      boxes.back().add(kernel_.box(nodes_[target(h)]));
    }
  }
  const RayTree rays(std::move(boxes));
  for (const std::uint32_t n : least) {
    const std::uint32_t nearest = rays.first(
        kernel_.box(nodes_[n]),
        [&](std::uint32_t e) {
          look_for_interrupt();
          const std::uint32_t h = upward[e];
          return component[origin_[h]] != component[n] && left_of(h, n);
        },
        [&](std::uint32_t e, std::uint32_t other) {
          return is_right_of(upward[e], upward[other]);
        });
    const std::uint32_t face = nearest == no_entry ? 0 : face_[upward[nearest] ^ 1U];
    mark_cycle(*(leaving_end(n) - 1), face == none ? 0 : face);
  }
}

}  // namespace minkref::inline plane
