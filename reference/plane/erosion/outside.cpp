#include "reference/plane/erosion/outside.hpp"

#include <algorithm>
#include <optional>

#include "reference/interrupt.hpp"
#include "reference/plane/location.hpp"

namespace minkref::inline plane {
namespace {

/// A hole of P, ready for nested rings.
struct Hole {
  const Ring* ring;
  std::uint32_t number;
  ExactBox box;
  Rational area;
  std::vector<std::pair<const Ring*, std::uint32_t>> islands = {};
};

PolygonSet alone(const Ring& ring) { return {{{ring, {}}}}; }

/// Rings only touch at points, so some point along any edge decides.
bool lies_in(const Ring& ring, const FilteredRing& hole) {
  for (const Point& p : ring) {
    const Location location = locate(hole, FilteredPoint(p));
    if (location != Location::boundary) return location == Location::inside;
  }
  for (int k = 2;; ++k) {
    const Point x{ring[0].x + (ring[1].x - ring[0].x) / k, ring[0].y + (ring[1].y - ring[0].y) / k};
    const Location location = locate(hole, FilteredPoint(x));
    if (location != Location::boundary) return location == Location::inside;
  }
}

/// Finds the innermost hole around a ring, or none.
Hole* innermost(std::vector<Hole>& holes, const Ring& ring) {
  const ExactBox box(alone(ring));
  Hole* found = nullptr;
  for (Hole& hole : holes) {
    look_for_interrupt();
    const bool apart = box.low.x < hole.box.low.x || hole.box.high.x < box.high.x ||
                       box.low.y < hole.box.low.y || hole.box.high.y < box.high.y;
    if (apart || (found != nullptr && found->area < hole.area)) continue;
    if (lies_in(ring, filtered_ring(*hole.ring))) found = &hole;
  }
  return found;
}

Ring backwards(const Ring& ring) { return {ring.rbegin(), ring.rend()}; }

}  // namespace

ExactBox::ExactBox(const PolygonSet& set) : low(set.polygons.at(0).outer.at(0)), high(low) {
  for (const Polygon& polygon : set.polygons) {
    for (const Point& p : polygon.outer) add(p);
  }
}

void ExactBox::add(const Point& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

Outside::Outside(const PolygonSet& P, const Point& low, const Point& high) {
  std::vector<Hole> holes;
  std::uint32_t number = 0;
  for (const Polygon& polygon : P.polygons) {
    ++number;
    for (const Ring& hole : polygon.holes) {
      holes.push_back({&hole, number++, ExactBox(alone(hole)), -doubled_area(hole)});
    }
  }
  std::vector<std::pair<const Ring*, std::uint32_t>> outermost;
  number = 0;
  for (const Polygon& polygon : P.polygons) {
    Hole* around = innermost(holes, polygon.outer);
    (around == nullptr ? outermost : around->islands).emplace_back(&polygon.outer, number);
    number += 1 + static_cast<std::uint32_t>(polygon.holes.size());
  }
  const auto add = [&](const Ring& ring, std::uint32_t of_P) {
    rings_.push_back({of_P, static_cast<std::uint32_t>(ring.size() - 1)});
    return backwards(ring);
  };
  const auto add_polygon = [&](Ring outer, const auto& inner) {
    Polygon& polygon = set.polygons.emplace_back(Polygon{std::move(outer), {}});
    for (const auto& [ring, of_P] : inner) polygon.holes.push_back(add(*ring, of_P));
  };
  rings_.push_back({0, 3});
  add_polygon({low, {high.x, low.y}, high, {low.x, high.y}}, outermost);
  for (const Hole& hole : holes) add_polygon(add(*hole.ring, hole.number), hole.islands);
}

VertexId Outside::vertex_of_P(const VertexId& vertex) const {
  const auto [ring, last] = rings_.at(vertex.ring);
  return {ring, last - vertex.index};
}

VertexId Outside::edge_of_P(const VertexId& edge) const {
  // Backwards, the edge from i to i + 1 runs from the other's i + 1 to its i.
  const auto [ring, last] = rings_.at(edge.ring);
  return {ring, (2 * last - edge.index) % (last + 1)};
}

ConvolutionEdge Outside::in_operands(ConvolutionEdge contact) const {
  if (contact.kind == ConvolutionEdge::Kind::S) {
    contact.edge = edge_of_P(contact.edge);
  } else {
    contact.vertex = vertex_of_P(contact.vertex);
  }
  return contact;
}

Outside outside_of(const PolygonSet& P) {
  const ExactBox box(P);
  const Rational x = 3 * box.width(), y = 3 * box.height();
  return {P, {box.low.x - x, box.low.y - y}, {box.high.x + x, box.high.y + y}};
}

}  // namespace minkref::inline plane
