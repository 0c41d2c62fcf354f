#include "reference/scene/obstacle_owners.hpp"

#include <stdexcept>
#include <utility>

namespace minkref::inline scene {
namespace {

const Ring& ring_of(const PolygonSet& set, std::uint32_t ring) {
  for (const Polygon& polygon : set.polygons) {
    if (ring == 0) return polygon.outer;
    --ring;
    if (ring < polygon.holes.size()) return polygon.holes[ring];
    ring -= static_cast<std::uint32_t>(polygon.holes.size());
  }
  throw std::logic_error("a shape has no such ring");
}

/// Appends the contacts of the robot's edge with a copy's vertices at `at`: ends of the owners'
/// edges, their first ones or their second.
void add_vertices(const ObstacleOwners& obstacles, const std::vector<Owner>& side, bool first,
                  const VertexId& robot_edge, const Point& at, std::vector<Owner>& owners) {
  for (const Owner& owner : side) {
    const Copy& copy = obstacles.copies[owner.copy];
    VertexId vertex = owner.edge.edge;
    const Ring& ring = ring_of(obstacles.shapes[copy.shape], vertex.ring);
    if (!first) vertex.index = static_cast<std::uint32_t>((vertex.index + 1) % ring.size());
    const Point& p = ring[vertex.index];
    if (copy.place.x + copy.scale * p.x != at.x || copy.place.y + copy.scale * p.y != at.y)
      continue;
    owners.push_back({owner.copy, {ConvolutionEdge::Kind::T, 1, robot_edge, vertex}});
  }
}

}  // namespace

ObstacleOwners obstacle_owners(const PolygonSet& region, const std::vector<RingOwners>& sides,
                               const std::vector<PolygonSet>& shapes, std::vector<Copy> copies) {
  ObstacleOwners result{region, sides, shapes, std::move(copies), {}};
  std::uint32_t rings = 0;
  for (const Polygon& polygon : region.polygons) {
    result.first_ring.push_back(rings);
    rings += static_cast<std::uint32_t>(1 + polygon.holes.size());
  }
  return result;
}

void add_owners(const ObstacleOwners& obstacles, std::uint32_t obstacle,
                const ConvolutionEdge& contact, std::vector<Owner>& owners) {
  const bool is_s = contact.kind == ConvolutionEdge::Kind::S;
  const VertexId& part = is_s ? contact.edge : contact.vertex;
  const RingOwners& sides = obstacles.sides[obstacles.first_ring[obstacle] + part.ring];
  const std::vector<Owner>& leaving = sides[part.index];
  if (is_s) {
    for (const Owner& owner : leaving) {
      owners.push_back(
          {owner.copy, {ConvolutionEdge::Kind::S, 1, owner.edge.edge, contact.vertex}});
    }
    return;
  }
  const std::vector<Owner>& arriving = sides[(part.index + sides.size() - 1) % sides.size()];
  const Polygon& polygon = obstacles.region.polygons[obstacle];
  const Point& at = (part.ring == 0 ? polygon.outer : polygon.holes[part.ring - 1])[part.index];
  const std::size_t before = owners.size();
  add_vertices(obstacles, leaving, true, contact.edge, at, owners);
  add_vertices(obstacles, arriving, false, contact.edge, at, owners);
  if (owners.size() != before) return;
  for (const std::vector<Owner>* side : {&leaving, &arriving}) {
    for (const Owner& owner : *side) {
      owners.push_back({owner.copy, {ConvolutionEdge::Kind::T, 1, contact.edge, owner.edge.edge}});
    }
  }
}

}  // namespace minkref::inline scene
