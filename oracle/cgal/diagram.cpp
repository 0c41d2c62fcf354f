// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/diagram.hpp"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Segment_Delaunay_graph_hierarchy_2.h>
#include <CGAL/Segment_Delaunay_graph_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace minkref::cgal_oracle {
namespace {

using Doubles = CGAL::Simple_cartesian<double>;
using Rationals = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Filtered = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<
    Doubles, CGAL::Field_with_sqrt_tag, Rationals, CGAL::Integral_domain_without_division_tag>;
using Exact = CGAL::Segment_Delaunay_graph_traits_without_intersections_2<
    Rationals, CGAL::Integral_domain_without_division_tag>;
// Places have square roots.
using Roots = CGAL::Simple_cartesian<CORE::Expr>;
using OfRoots =
    CGAL::Segment_Delaunay_graph_traits_without_intersections_2<Roots, CGAL::Field_with_sqrt_tag>;

double number(const mpq_class& value, double*) { return value.get_d(); }
CGAL::Gmpq number(const mpq_class& value, CGAL::Gmpq*) { return CGAL::Gmpq(value.get_mpq_t()); }
CORE::Expr number(const mpq_class& value, CORE::Expr*) {
  return CORE::Expr(CORE::BigRat(CORE::BigInt(value.get_num().get_str()),
                                 CORE::BigInt(value.get_den().get_str())));
}

mpq_class rational(double value) { return mpq_class(value); }
mpq_class rational(const CGAL::Gmpq& value) { return mpq_class(value.mpq()); }

template <class Kernel>  // or traits
typename Kernel::Point_2 given(const Point& p) {
  typename Kernel::FT* const type = nullptr;
  return {number(p.x, type), number(p.y, type)};
}

template <class Kernel>
Point taken(const CGAL::Point_2<Kernel>& p) {
  return {rational(p.x()), rational(p.y())};
}

OfRoots::Site_2 with_roots(const DiagramSite& site) {
  if (!site.end) return OfRoots::Site_2::construct_site_2(given<Roots>(site.start));
  return OfRoots::Site_2::construct_site_2(given<Roots>(site.start), given<Roots>(*site.end));
}

CORE::Expr squared_distance(const Roots::Point_2& from, const DiagramSite& site) {
  const Roots::Point_2 start = given<Roots>(site.start);
  if (!site.end) return CGAL::squared_distance(from, start);
  const Roots::Vector_2 along = given<Roots>(*site.end) - start, way = from - start;
  const CORE::Expr twice = along.x() * way.y() - along.y() * way.x();
  return twice * twice / along.squared_length();
}

/// Asks for 200 bits first. Asked for a double at once, CORE of CGAL 5.5.1 may give only 23 bits
/// (7271383040 for 7271383925.69..., the height of (7000000049, 6847061340), (10000000070,
/// 6847061340) and the segment from (5000000035, 10270592010) to (11000000077, 7988238230)).
double rounded(const CORE::Expr& value) {
  value.approx(200, CORE::extLong::getPosInfty());
  return value.BigFloatValue().doubleValue();
}

/// Whether the sites are a point and two segments that end there: equally far only at this point,
/// with distance zero.
bool is_at_end(const std::array<DiagramSite, 3>& sites) {
  const auto point = std::find_if(sites.begin(), sites.end(), [](auto& s) { return !s.end; });
  return point != sites.end() && std::all_of(sites.begin(), sites.end(), [&](auto& s) {
           return &s == &*point || (s.end && (s.start == point->start || *s.end == point->start));
         });
}

template <class Vertex>
DiagramSite site_of(const Vertex& vertex) {
  const auto site = vertex->site();
  if (site.is_point()) return {taken(site.point()), {}};
  return {taken(site.source()), taken(site.target())};
}

/// Each edge once, from the face found first; `number` has -1 for vertices left out.
template <class Graph>
std::vector<DiagramEdge> edges_of(const Graph& graph,
                                  const std::map<typename Graph::Face_handle, int>& number) {
  std::vector<DiagramEdge> found;
  for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face) {
    const typename Graph::Face_handle own = face;
    for (int k = 0; k < 3; ++k) {
      const auto other = face->neighbor(k);
      const bool is_infinite = graph.is_infinite(other);
      if (!is_infinite && other < own) continue;
      found.push_back({{site_of(face->vertex(graph.cw(k))), site_of(face->vertex(graph.ccw(k)))},
                       {number.at(own), is_infinite ? -1 : number.at(other)},
                       is_infinite});
    }
  }
  return found;
}

template <class Traits>
Diagram found_by(const std::vector<Segment>& segments) {
  using Graph = CGAL::Segment_Delaunay_graph_hierarchy_2<Traits>;
  Graph graph;
  for (const Segment& segment : segments) {
    graph.insert(given<Traits>(segment.start), given<Traits>(segment.end));
  }
  Diagram found;
  std::map<typename Graph::Face_handle, int> number;
  for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face) {
    DiagramVertex vertex;
    for (int k = 0; k < 3; ++k) {
      vertex.sites[static_cast<std::size_t>(k)] = site_of(face->vertex(k));
    }
    number[face] = -1;
    if (is_at_end(vertex.sites)) continue;
    number[face] = static_cast<int>(found.vertices.size());
    const Roots::Point_2 at = OfRoots().construct_svd_vertex_2_object()(
        with_roots(vertex.sites[0]), with_roots(vertex.sites[1]), with_roots(vertex.sites[2]));
    vertex.x = rounded(at.x());
    vertex.y = rounded(at.y());
    vertex.squared_radius = rounded(squared_distance(at, vertex.sites[0]));
    found.vertices.push_back(std::move(vertex));
  }
  found.edges = edges_of(graph, number);
  return found;
}

bool is_double(const mpq_class& value) {
  const double rounded = value.get_d();
  return std::isfinite(rounded) && value == rounded;
}

bool are_doubles(const Point& p) { return is_double(p.x) && is_double(p.y); }

}  // namespace

Diagram diagram_of(const std::vector<Segment>& segments) {
  const bool in_doubles = std::all_of(segments.begin(), segments.end(), [](const Segment& s) {
    return are_doubles(s.start) && are_doubles(s.end);
  });
  return in_doubles ? found_by<Filtered>(segments) : found_by<Exact>(segments);
}

}  // namespace minkref::cgal_oracle
