// Contacts of a set's segments: crossings, vertices on segments, overlaps. First half of the
// arrangement.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/near/edge_tree.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/kernel/direction_order.hpp"

namespace minkref::inline plane {

/// A segment between two vertices, given by index.
struct IndexedSegment {
  std::uint32_t from = 0, to = 0;
};

/// Gives coincident vertices their least index.
template <class K>
std::vector<std::uint32_t> coincident_vertices(const K& kernel,
                                               const std::vector<typename K::Vector>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), representative(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::iota(representative.begin(), representative.end(), 0U);
  const auto compare = [&](std::uint32_t i, std::uint32_t j) {
    look_for_interrupt();
    const int x = kernel.compare(vertices[i].x(), vertices[j].x());
    return x != 0 ? x : kernel.compare(vertices[i].y(), vertices[j].y());
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return compare(i, j) < 0; });
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (compare(order[k - 1], order[k]) == 0)
      representative[order[k]] = representative[order[k - 1]];
  }
  return representative;
}

/// The points that cut segments, each with its position along the segment.
template <class K>
class SegmentContacts {
 public:
  using Vector = typename K::Vector;
  struct Contact {
    std::uint32_t segment;
    std::uint32_t point;  ///< a vertex, or vertices() + index of a crossing
    typename K::Parameter position;
  };
  /// A crossing between two segments' interiors.
  struct Crossing {
    std::uint32_t first, second;
  };

  /// `segments` name representatives (see coincident_vertices), and none may be degenerate. As
  /// exact as the kernel. O((n + k) log n) on usual input, k the number of overlapping boxes.
  SegmentContacts(const K& kernel, const std::vector<Vector>& vertices,
                  const std::vector<IndexedSegment>& segments)
      : kernel_(kernel), vertices_(vertices), segments_(segments) {
    directions_.reserve(segments.size());
    std::vector<Box> boxes;
    boxes.reserve(segments.size());
    for (const IndexedSegment& s : segments) {
      directions_.push_back(Vector(vertices[s.to] - vertices[s.from]));
      boxes.push_back(kernel.box(vertices[s.from], vertices[s.to]));
    }
    std::size_t apart = 0;
    const bool are_too_many = BoxTree(boxes).pairs([&](std::uint32_t i, std::uint32_t j) {
      const std::size_t before = contacts_.size();
      meet(i, j);
      apart += contacts_.size() == before ? 1 : 0;
      return apart > most_apart * segments_.size() + contacts_.size();
    });
    if (are_too_many) find_near_contacts();
  }

  const std::vector<Vector>& directions() const { return directions_; }
  std::vector<Contact>& contacts() { return contacts_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }

 private:
  /// Pairs per segment whose boxes overlap in vain. Beyond it boxes do not help.
  static constexpr std::size_t most_apart = 48;

  /// All contacts anew, for segments whose boxes overlap far more often than the segments meet, as
  /// in slanted combs. Leaves out only pairs that lie apart.
  void find_near_contacts() {
    contacts_.clear();
    crossings_.clear();
    std::vector<NearPoint> points;
    points.reserve(vertices_.size());
    for (const Vector& vertex : vertices_) {
      look_for_interrupt();
      const Box box = kernel_.box(vertex, vertex);
      points.push_back(
          {{box.xmin, box.ymin, 0}, above(std::max(box.xmax - box.xmin, box.ymax - box.ymin))});
    }
    std::vector<EdgeTree::Edge> edges;
    edges.reserve(segments_.size());
    for (const IndexedSegment& s : segments_) edges.push_back({s.from, s.to});
    EdgeTree(std::move(points), edges).pairs([this](std::uint32_t i, std::uint32_t j) {
      meet(i, j);
    });
  }

  void meet(std::uint32_t i, std::uint32_t j) {
    const IndexedSegment a = segments_[i], b = segments_[j];
    const bool shared = a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
    if (shared) {
      // Segments with a common end meet nowhere else unless parallel.
      if (kernel_.turn(directions_[i], directions_[j]) == 0) collinear(i, j);
      return;
    }
    const int b0 = side(i, b.from), b1 = side(i, b.to);
    if (b0 == b1) {
      if (b0 == 0) collinear(i, j);
      return;
    }
    const int a0 = side(j, a.from), a1 = side(j, a.to);
    if (a0 == a1) return;
    if (a0 * a1 < 0 && b0 * b1 < 0) {
      cross(i, j);
      return;
    }
    // One end lies on the other segment's line, and the lines differ.
    if (b0 == 0 && a0 * a1 < 0) on_segment(b.from, i);
    if (b1 == 0 && a0 * a1 < 0) on_segment(b.to, i);
    if (a0 == 0 && b0 * b1 < 0) on_segment(a.from, j);
    if (a1 == 0 && b0 * b1 < 0) on_segment(a.to, j);
  }

  int side(std::uint32_t segment, std::uint32_t vertex) const {
    return kernel_.turn(directions_[segment],
                        Vector(vertices_[vertex] - vertices_[segments_[segment].from]));
  }

  void on_segment(std::uint32_t vertex, std::uint32_t segment) {
    contacts_.push_back(
        {segment, vertex,
         kernel_.projection(Vector(vertices_[vertex] - vertices_[segments_[segment].from]),
                            directions_[segment])});
  }

  void cross(std::uint32_t i, std::uint32_t j) {
    const auto point = static_cast<std::uint32_t>(vertices_.size() + crossings_.size());
    const Vector w(vertices_[segments_[j].from] - vertices_[segments_[i].from]);
    const Vector back(vertices_[segments_[i].from] - vertices_[segments_[j].from]);
    contacts_.push_back({i, point, kernel_.intersection(w, directions_[i], directions_[j])});
    contacts_.push_back({j, point, kernel_.intersection(back, directions_[j], directions_[i])});
    crossings_.push_back({i, j});
  }

  void collinear(std::uint32_t i, std::uint32_t j) {
    for (const std::uint32_t end : {segments_[j].from, segments_[j].to}) {
      if (strictly_inside(end, i)) on_segment(end, i);
    }
    for (const std::uint32_t end : {segments_[i].from, segments_[i].to}) {
      if (strictly_inside(end, j)) on_segment(end, j);
    }
  }

  /// For a vertex on the line of the segment.
  bool strictly_inside(std::uint32_t vertex, std::uint32_t segment) const {
    const IndexedSegment s = segments_[segment];
    if (vertex == s.from || vertex == s.to) return false;
    const Vector from_start(vertices_[vertex] - vertices_[s.from]);
    const Vector to_end(vertices_[s.to] - vertices_[vertex]);
    return same_way(kernel_, directions_[segment], from_start) &&
           same_way(kernel_, directions_[segment], to_end);
  }

  const K& kernel_;
  const std::vector<Vector>& vertices_;
  const std::vector<IndexedSegment>& segments_;
  std::vector<Vector> directions_;
  std::vector<Contact> contacts_;
  std::vector<Crossing> crossings_;
};

}  // namespace minkref::inline plane
