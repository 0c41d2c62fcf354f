#include "reference/plane/passages/bare_segments.hpp"

#include <algorithm>

#include "reference/plane/location.hpp"
#include "reference/plane/passages/tight_graph.hpp"

namespace minkref::inline plane {
namespace {

bool before(const Point& a, const Point& b) { return compare_xy(a, b) < 0; }

Rational cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Adds crossings with an edge; a parallel edge's neighbours add its ends.
void add_cut(const BareSegment& line, const Point& a, const Point& b, std::vector<Point>& cuts) {
  const Rational at_a = cross(line.from, line.to, a), at_b = cross(line.from, line.to, b);
  if (at_a == 0) cuts.push_back(a);
  if (sign(at_a) * sign(at_b) >= 0) return;
  const Rational t = at_a / (at_a - at_b);
  cuts.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}

std::vector<Point> cuts_of(const BareSegment& line, const PolygonSet& region) {
  std::vector<Point> cuts{line.from, line.to};
  const auto along = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      look_for_interrupt();
      add_cut(line, ring[i], ring[(i + 1) % ring.size()], cuts);
    }
  };
  for (const Polygon& polygon : region.polygons) {
    along(polygon.outer);
    for (const Ring& hole : polygon.holes) along(hole);
  }
  std::erase_if(cuts, [&](const Point& p) { return before(p, line.from) || before(line.to, p); });
  std::sort(cuts.begin(), cuts.end(), before);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

}  // namespace

std::vector<TightPassage> segments_beside(const PolygonSet& region,
                                          std::vector<BareSegment> segments) {
  TightGraph graph;
  const auto number_of = [&](const Point& p) {
    const auto found = std::find(graph.points.begin(), graph.points.end(), p);
    const auto number = static_cast<std::uint32_t>(found - graph.points.begin());
    if (found == graph.points.end()) graph.points.push_back(p);
    return number;
  };
  for (const BareSegment& line : cut_at_contacts(joined(std::move(segments)))) {
    const std::vector<Point> cuts = cuts_of(line, region);
    for (std::size_t i = 0; i + 1 < std::max<std::size_t>(cuts.size(), 2); ++i) {
      const Point& a = cuts[i];
      const Point& b = cuts[std::min(i + 1, cuts.size() - 1)];
      const Point middle{Rational((a.x + b.x) / 2), Rational((a.y + b.y) / 2)};
      if (locate(region, middle) != Location::outside) continue;
      const std::uint32_t from = number_of(a);
      graph.edges.push_back({from, number_of(b), {}});
    }
  }
  return passages_along(graph);
}

}  // namespace minkref::inline plane
