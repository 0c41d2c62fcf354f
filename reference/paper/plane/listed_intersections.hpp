// The intersection lists as contacts of the arrangement at one scale.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/paper/plane/intersection_lists.hpp"
#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/convolution/convolution_segments.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {

/// The vertices of the convolution at a scale, then the intersections x0 + (s - 1) sigma, with
/// their places along their edges.
template <class T>
class ListedIntersections {
 public:
  using K = PlainKernel<T>;

  /// An intersection that the list puts on an edge, but rounding puts before or beyond it, counts
  /// as the edge's end. Along an edge that another edge overlaps, intersections are sorted. O(k).
  ListedIntersections(const K& kernel, const std::vector<MovingEdge<Vector2<T>>>& edges,
                      const std::vector<CriticalRegion<T>>& regions,
                      const IntersectionLists<T>& lists, Readings::Order order, const T& scale,
                      const ConvolutionSegments<K>& convolution)
      : vertices(convolution.vertices), kernel_(kernel), convolution_(convolution) {
    for (std::uint32_t edge = 0; edge < edges.size(); ++edge) {
      look_for_interrupt();
      for (const std::uint32_t i : lists.along(edge)) {
        const CriticalRegion<T>& region = regions[i];
        if (region.a != edge) continue;
        if (region.parallel) {
          overlap(region.a, region.b);
          overlap(region.b, region.a);
        } else {
          meet(region, i, scale);
        }
      }
    }
    std::vector<bool> overlapped(edges.size(), false);
    for (const auto& contact : contacts) overlapped[contact.segment] = true;
    for (std::uint32_t edge = 0; edge < edges.size(); ++edge) {
      const bool kept = order == Readings::Order::kept && !overlapped[edge];
      int rank = 0;
      for (const std::uint32_t i : lists.along(edge)) {
        if (regions[i].parallel) continue;
        const std::uint32_t point = point_of_[i];
        const T place = position(edge, point);
        if (is_end(edge, point, place)) continue;
        contacts.push_back({edge, point, kept ? T(++rank) : place});
      }
    }
  }

  std::vector<Vector2<T>> vertices;
  std::vector<ListedContact<K>> contacts;

 private:
  /// The position along the edge: 0 at its start, 1 at its end.
  T position(std::uint32_t edge, std::uint32_t point) const {
    const IndexedSegment& s = convolution_.segments[edge];
    const Vector2<T> d(vertices[s.to] - vertices[s.from]);
    return T(T(d.dot(Vector2<T>(vertices[point] - vertices[s.from]))) / d.dot(d));
  }

  bool is_end(std::uint32_t edge, std::uint32_t point, const T& place) const {
    const IndexedSegment& s = convolution_.segments[edge];
    return point == s.from || point == s.to || kernel_.sign(place) <= 0 ||
           kernel_.sign(T(place - T(1))) >= 0;
  }

  void meet(const CriticalRegion<T>& region, std::uint32_t i, const T& scale) {
    if (point_of_.size() <= i) point_of_.resize(i + 1);
    vertices.push_back(region.x.at(scale));
    point_of_[i] = static_cast<std::uint32_t>(vertices.size() - 1);
    for (const std::uint32_t edge : {region.a, region.b}) {
      const IndexedSegment& s = convolution_.segments[edge];
      const T place = position(edge, point_of_[i]);
      const bool before = kernel_.sign(place) <= 0;
      if (!before && kernel_.sign(T(place - T(1))) < 0) continue;
      vertices.pop_back();
      point_of_[i] = before ? s.from : s.to;
      return;
    }
  }

  /// Adds the ends of `other`, which shares the line of `edge`, that lie within `edge`.
  void overlap(std::uint32_t edge, std::uint32_t other) {
    for (const std::uint32_t end :
         {convolution_.segments[other].from, convolution_.segments[other].to}) {
      const T place = position(edge, end);
      if (!is_end(edge, end, place)) contacts.push_back({edge, end, place});
    }
  }

  const K& kernel_;
  const ConvolutionSegments<K>& convolution_;
  std::vector<std::uint32_t> point_of_;  ///< of each region in the lists
};

}  // namespace minkref::inline plane
