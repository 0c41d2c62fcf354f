// The arrangement of segments in the plane: nodes, sub-edges, faces, with every degeneracy.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "reference/plane/arrangement/listed_contacts.hpp"
#include "reference/plane/arrangement/segment_contacts.hpp"

namespace minkref::inline plane {

/// The subdivision of the plane by closed segments: several segments through a point, vertices on
/// segments and overlapping segments are all allowed. Half-edges h and h ^ 1 are twins; a
/// half-edge's face lies on its left. As exact as the kernel; with a kernel that rounds, the
/// structure stays sound (every cycle closes), but may be untrue.
template <class K>
class Arrangement {
 public:
  using Vector = typename K::Vector;
  using Node = typename K::Node;
  static constexpr std::uint32_t none = 0xffffffffU;

  /// A segment that runs along a sub-edge, with or against the sub-edge's direction.
  struct Cover {
    std::uint32_t segment;
    bool along;
  };
  /// The two segments whose interiors cross at a node, or none twice if the node is a vertex.
  struct Provenance {
    std::uint32_t first = none, second = none, vertex = none;
  };

  /// Ignores degenerate segments (equal ends). O((N + k) log N) on usual input.
  Arrangement(const K& kernel, std::vector<Vector> vertices, std::vector<IndexedSegment> segments)
      : kernel_(kernel), vertices_(std::move(vertices)), segments_(std::move(segments)) {
    subdivide([this](const std::vector<IndexedSegment>& proper, const std::vector<std::uint32_t>&) {
      return SegmentContacts<K>(kernel_, vertices_, proper);
    });
    link();
    find_faces();
  }

  /// Cuts the segments as the list says, whatever their coordinates: the contacts name vertices,
  /// and their positions order the contacts along a segment. Segments without a listed contact do
  /// not meet.
  Arrangement(const K& kernel, std::vector<Vector> vertices, std::vector<IndexedSegment> segments,
              const std::vector<ListedContact<K>>& contacts)
      : kernel_(kernel), vertices_(std::move(vertices)), segments_(std::move(segments)) {
    subdivide(
        [&](const std::vector<IndexedSegment>& proper, const std::vector<std::uint32_t>& name) {
          return ListedContacts<K>(vertices_, segments_.size(), proper, name, contacts);
        });
    link();
    find_faces();
  }

  // Nodes.
  std::size_t node_count() const { return nodes_.size(); }
  const Node& node(std::uint32_t n) const { return nodes_[n]; }
  const Provenance& provenance(std::uint32_t n) const { return provenance_[n]; }

  // Sub-edges and half-edges: half-edge 2e runs from the sub-edge's start to its end.
  std::size_t half_edge_count() const { return origin_.size(); }
  std::uint32_t origin(std::uint32_t h) const { return origin_[h]; }
  std::uint32_t target(std::uint32_t h) const { return origin_[h ^ 1U]; }
  std::uint32_t next(std::uint32_t h) const { return next_[h]; }
  std::uint32_t face(std::uint32_t h) const { return face_[h]; }
  /// The segments along half-edge h's sub-edge; `along` refers to half-edge 2e.
  const Cover* covers_begin(std::uint32_t h) const { return covers_.data() + first_cover_[h / 2]; }
  const Cover* covers_end(std::uint32_t h) const {
    return covers_.data() + first_cover_[h / 2 + 1];
  }
  bool runs_with(std::uint32_t h, const Cover& cover) const { return cover.along == (h % 2 == 0); }
  /// A half-edge's direction (with the length of a covering segment, not its own).
  Vector direction(std::uint32_t h) const {
    const Cover& cover = covers_[first_cover_[h / 2]];
    const Vector& d = directions_[cover.segment];
    return runs_with(h, cover) ? d : Vector(-d);
  }
  const Vector& segment_start(std::uint32_t segment) const {
    return vertices_[segments_[segment].from];
  }
  const Vector& segment_direction(std::uint32_t segment) const { return directions_[segment]; }
  const Vector& vertex(std::uint32_t v) const { return vertices_[v]; }

  // Faces: face 0 has no bound. Each boundary cycle of a face contributes one half-edge.
  std::size_t face_count() const { return face_cycles_.size(); }
  const std::vector<std::uint32_t>& cycles(std::uint32_t face) const { return face_cycles_[face]; }
  template <class Visit>
  void for_each_half_edge(std::uint32_t face, Visit&& visit) const {
    for (const std::uint32_t first : face_cycles_[face]) {
      std::uint32_t h = first;
      do {
        visit(h);
        h = next_[h];
      } while (h != first);
    }
  }
  /// Half-edges that leave a node, counter-clockwise from the angle of -180 degrees.
  const std::uint32_t* leaving_begin(std::uint32_t n) const {
    return leaving_.data() + first_leaving_[n];
  }
  const std::uint32_t* leaving_end(std::uint32_t n) const {
    return leaving_.data() + first_leaving_[n + 1];
  }

 private:
  /// `meet` finds the contacts of the nondegenerate segments, and receives each segment's index
  /// among all.
  template <class Meet>
  void subdivide(const Meet& meet);
  void link();
  void find_faces();
  /// Gives each half-edge along a boundary cycle the face.
  void mark_cycle(std::uint32_t first, std::uint32_t face);
  /// Puts each component into the face right after the nearest edge to the left. `least`: the
  /// components' least nodes, from left to right.
  void place_components(const std::vector<std::uint32_t>& component,
                        const std::vector<std::uint32_t>& least);
  std::uint32_t find(std::uint32_t point) {
    while (parent_[point] != point) point = parent_[point] = parent_[parent_[point]];
    return point;
  }
  /// Whether the sub-edge of h spans the height just above node n, strictly left of n.
  bool left_of(std::uint32_t h, std::uint32_t n) const;
  /// For two upward half-edges across a common height, not crossing: whether g runs right of h
  /// there.
  bool is_right_of(std::uint32_t g, std::uint32_t h) const;

  const K& kernel_;
  std::vector<Vector> vertices_, directions_;
  std::vector<IndexedSegment> segments_;
  std::vector<std::uint32_t> parent_;  ///< union-find over vertices and crossings
  std::vector<Node> nodes_;
  std::vector<Provenance> provenance_;
  std::vector<Cover> covers_;
  std::vector<std::uint32_t> first_cover_, origin_, next_, face_, leaving_, first_leaving_;
  std::vector<std::vector<std::uint32_t>> face_cycles_;
};

}  // namespace minkref::inline plane

#include "reference/plane/arrangement/arrangement_faces.hpp"
#include "reference/plane/arrangement/arrangement_subdivision.hpp"
