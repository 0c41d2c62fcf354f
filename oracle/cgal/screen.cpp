// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/screen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace minkref::cgal_oracle {
namespace {

int turn(const Point& a, const Point& b, const Point& c) {
  return sgn(mpq_class((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}

/// Returns +1 for counter-clockwise, -1 for clockwise. A simple ring has a hull corner as its
/// smallest vertex.
int orientation(const Ring& ring) {
  const auto smallest = std::min_element(ring.begin(), ring.end());
  const auto before = smallest == ring.begin() ? ring.end() - 1 : smallest - 1;
  const auto after = smallest + 1 == ring.end() ? ring.begin() : smallest + 1;
  return turn(*before, *smallest, *after);
}

bool repeats_a_vertex(const Ring& ring) {
  std::vector<const Point*> sorted;
  sorted.reserve(ring.size());
  for (const auto& vertex : ring) sorted.push_back(&vertex);
  std::sort(sorted.begin(), sorted.end(), [](auto a, auto b) { return *a < *b; });
  return std::adjacent_find(sorted.begin(), sorted.end(),
                            [](auto a, auto b) { return *a == *b; }) != sorted.end();
}

/// An edge, and a box of doubles that surely contains this edge.
struct Edge {
  const Point *from, *to;
  std::size_t ring;
  double xmin, xmax, ymin, ymax;
};

double below(const mpq_class& value) {  // get_d() is off by less than one step
  return std::nextafter(value.get_d(), -std::numeric_limits<double>::infinity());
}

double above(const mpq_class& value) {
  return std::nextafter(value.get_d(), std::numeric_limits<double>::infinity());
}

void append_edges(const Ring& ring, std::size_t number, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    edges.push_back({&a, &b, number, std::min(below(a.x), below(b.x)),
                     std::max(above(a.x), above(b.x)), std::min(below(a.y), below(b.y)),
                     std::max(above(a.y), above(b.y))});
  }
}

bool in_box(const Point& p, const Edge& e) {
  return std::min(e.from->x, e.to->x) <= p.x && p.x <= std::max(e.from->x, e.to->x) &&
         std::min(e.from->y, e.to->y) <= p.y && p.y <= std::max(e.from->y, e.to->y);
}

/// Tests whether two closed segments share a point. Exact.
bool meet(const Edge& e, const Edge& f) {
  const int f_from = turn(*e.from, *e.to, *f.from);
  const int f_to = turn(*e.from, *e.to, *f.to);
  const int e_from = turn(*f.from, *f.to, *e.from);
  const int e_to = turn(*f.from, *f.to, *e.to);
  if (f_from * f_to < 0 && e_from * e_to < 0) return true;
  return (f_from == 0 && in_box(*f.from, e)) || (f_to == 0 && in_box(*f.to, e)) ||
         (e_from == 0 && in_box(*e.from, f)) || (e_to == 0 && in_box(*e.to, f));
}

/// Finds two different rings that share a point. Sweeps the edges by their left ends, and compares
/// each edge with the earlier edges that reach it.
std::optional<std::string> rings_that_meet(const Polygon& polygon) {
  std::vector<Edge> edges;
  append_edges(polygon.outer, 0, edges);
  for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
    append_edges(polygon.holes[i], i + 1, edges);
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.xmin < b.xmin; });
  std::vector<const Edge*> active;
  for (const Edge& e : edges) {
    std::erase_if(active, [&](const Edge* f) { return f->xmax < e.xmin; });
    for (const Edge* f : active) {
      if (f->ring == e.ring || f->ymax < e.ymin || e.ymax < f->ymin || !meet(e, *f)) continue;
      return "rings " + std::to_string(std::min(e.ring, f->ring)) + " and " +
             std::to_string(std::max(e.ring, f->ring)) + " meet";
    }
    active.push_back(&e);
  }
  return std::nullopt;
}

std::optional<std::string> degenerate_ring(const Ring& ring, std::size_t number) {
  const auto ring_name = "ring " + std::to_string(number);
  if (ring.size() == 1) return "a point is no polygon of CGAL's";
  if (ring.size() == 2) return "a segment is no polygon of CGAL's";
  if (ring.empty()) return ring_name + " has no vertex";
  if (repeats_a_vertex(ring)) return ring_name + " repeats a vertex: it is not simple";
  const int turned = orientation(ring);
  if (turned != (number == 0 ? 1 : -1)) {
    throw BadOperand(ring_name + (turned == 0 ? " has no area"
                                  : number == 0
                                      ? " is clockwise; an outer ring is counter-clockwise"
                                      : " is counter-clockwise; a hole is clockwise"));
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> outside_of_cgal(const std::vector<Polygon>& operand, bool holes,
                                           const std::string& name) {
  const auto reason = [&]() -> std::optional<std::string> {
    if (operand.empty()) return "the empty set is no operand of CGAL's";
    if (operand.size() > 1) return std::to_string(operand.size()) + " polygons, CGAL takes one";
    const Polygon& polygon = operand.front();
    if (auto found = degenerate_ring(polygon.outer, 0)) return found;
    for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
      if (auto found = degenerate_ring(polygon.holes[i], i + 1)) return found;
    }
    if (polygon.holes.empty()) return std::nullopt;
    if (!holes) return "has holes, and this method takes none";
    return rings_that_meet(polygon);
  };
  try {
    if (const auto found = reason()) return name + ": " + *found;
  } catch (const BadOperand& fault) {
    throw BadOperand(name + ": " + fault.what());
  }
  return std::nullopt;
}

}  // namespace minkref::cgal_oracle
