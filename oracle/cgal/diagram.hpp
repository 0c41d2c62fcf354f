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

/// An end of segments, or an open segment.
struct DiagramSite {
  Point start;
  std::optional<Point> end;
};

/// A place that is as far from three sites, and no other is nearer. Its numbers are the nearest
/// doubles, or next to these, of exact ones.
struct DiagramVertex {
  std::array<DiagramSite, 3> sites;
  double x, y, squared_radius;
};

/// The diagram vertices of segments that meet in ends only. A vertex that is as far from k sites
/// comes k - 2 times; vertices at ends of segments, whose distance is zero, are left out. All
/// decisions are exact: by the filtered traits where doubles hold all coordinates, else over
/// rationals alone.
std::vector<DiagramVertex> diagram_of(const std::vector<Segment>& segments);

}  // namespace minkref::cgal_oracle
