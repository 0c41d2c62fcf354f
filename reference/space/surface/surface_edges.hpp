// A set's boundary in space as half-edges: faces, and how they go on across edges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/space/surface/conforming_edges.hpp"

namespace minkref::inline space {

/// Pairs faces about an edge across the interior's sectors, or across the outside's sectors. The
/// two pairings differ where more than two faces meet.
enum class Pairing : std::uint8_t { interior, outside };

/// A side of a face along an edge: seen from outside the face is to the left.
struct HalfEdge {
  std::uint32_t from, to;
  std::uint32_t face;
  std::uint32_t next;                  ///< around the face
  std::array<std::uint32_t, 2> mates;  ///< by Pairing; they run the other way
  std::uint32_t mate(Pairing pairing) const { return mates[static_cast<std::size_t>(pairing)]; }
};

/// A connected part of a plane region less its slits: a disc with holes, open.
struct SurfaceFace {
  std::uint32_t plane;
  std::vector<std::uint32_t>
      walks;                        ///< a half-edge of each part of its border, the outer one first
  std::vector<std::uint32_t> tips;  ///< points in the inside, where a tip touches the face
};

struct SurfaceEdges {
  std::vector<OrientedPlane> planes;  ///< those of the set
  std::vector<SpaceVertex> points;    ///< distinct, ascending
  std::vector<SurfaceFace> faces;
  std::vector<HalfEdge> half_edges;

  /// A walk's half-edges, in order.
  std::vector<std::uint32_t> walk(std::uint32_t first) const;
};

/// Builds the boundary's faces and half-edges. Every edge bears at least two half-edges, as many
/// one way as the other: a slit bears two from its own plane. Sorts faces about an edge exactly,
/// and throws std::logic_error if they do not bound interior and outside in turn. Exact. Costs as
/// much as conforming_edges.
SurfaceEdges surface_edges(const PolyhedralSet& set);

}  // namespace minkref::inline space
