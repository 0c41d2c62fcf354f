// SPDX-License-Identifier: GPL-3.0-or-later
// The Voronoi diagram of segments by CGAL's segment Delaunay graph.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

struct Segment {
  Point start, end;
};

/// A segment's end, or an open segment.
struct DiagramSite {
  Point start;
  std::optional<Point> end;
};

/// A place equally far from three sites, with no other site nearer. The doubles are nearest to the
/// exact numbers, or next to the nearest.
struct DiagramVertex {
  std::array<DiagramSite, 3> sites;
  double x, y, squared_radius;
};

/// A Voronoi edge between two sites. Each end is the number of a vertex, or -1: a segment's end, or
/// infinity.
struct DiagramEdge {
  std::array<DiagramSite, 2> sites;
  std::array<int, 2> ends;
  bool is_infinite;
};

struct Diagram {
  std::vector<DiagramVertex> vertices;
  std::vector<DiagramEdge> edges;
};

/// Computes the Voronoi vertices of segments that meet only at their ends. A vertex equally far
/// from k sites comes k - 2 times; vertices at segments' ends, where the distance is zero, are left
/// out; edges join these parts, and may have no length. All decisions are exact: the filtered
/// traits decide where doubles hold all coordinates, rationals alone otherwise.
Diagram diagram_of(const std::vector<Segment>& segments);

}  // namespace minkref::cgal_oracle
