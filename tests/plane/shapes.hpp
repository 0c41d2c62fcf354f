// Small handwritten polygon sets, maps, and texts for failure messages.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::testing {

inline PolygonSet region(Ring outer, std::vector<Ring> holes = {}) {
  PolygonSet set{{Polygon{std::move(outer), std::move(holes)}}};
  orient(set);
  return set;
}

inline Ring rectangle(const Rational& x0, const Rational& y0, const Rational& x1,
                      const Rational& y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline PolygonSet box(const Rational& x0, const Rational& y0, const Rational& x1,
                      const Rational& y1) {
  return region(rectangle(x0, y0, x1, y1));
}

inline PolygonSet point_set(const Rational& x, const Rational& y) {
  return {{Polygon{{{x, y}}, {}}}};
}

inline PolygonSet segment_set(const Point& a, const Point& b) { return {{Polygon{{a, b}, {}}}}; }

/// All polygons of both: with `canonicalize`, the union.
inline PolygonSet together(PolygonSet a, const PolygonSet& b) {
  a.polygons.insert(a.polygons.end(), b.polygons.begin(), b.polygons.end());
  return a;
}

inline PolygonSet united(const PolygonSet& a, const PolygonSet& b) {
  return canonicalize(together(a, b)).region;
}

/// The image of every vertex. After a map that reverses orientation, `orient` turns the rings.
template <class Map>
PolygonSet mapped(PolygonSet set, Map&& map) {
  for (Polygon& polygon : set.polygons) {
    for (Point& point : polygon.outer) point = map(point);
    for (Ring& hole : polygon.holes) {
      for (Point& point : hole) point = map(point);
    }
  }
  return set;
}

inline PolygonSet shifted(const PolygonSet& set, const Point& by) {
  return mapped(set, [&](const Point& p) { return Point{p.x + by.x, p.y + by.y}; });
}

inline PolygonSet stretched(const PolygonSet& set, const Rational& factor) {
  return mapped(set, [&](const Point& p) { return Point{p.x * factor, p.y * factor}; });
}

/// Turns by 90 degrees to the left.
inline PolygonSet turned(const PolygonSet& set) {
  return mapped(set, [](const Point& p) { return Point{Rational(-p.y), p.x}; });
}

/// In the y axis.
inline PolygonSet mirrored(const PolygonSet& set) {
  PolygonSet image = mapped(set, [](const Point& p) { return Point{Rational(-p.x), p.y}; });
  for (Polygon& polygon : image.polygons) {
    std::reverse(polygon.outer.begin(), polygon.outer.end());
    for (Ring& hole : polygon.holes) std::reverse(hole.begin(), hole.end());
  }
  return image;
}

/// x - Q.
inline PolygonSet placed(const PolygonSet& Q, const Point& x) {
  return mapped(Q, [&](const Point& q) { return Point{x.x - q.x, x.y - q.y}; });
}

template <class Visit>
void for_each_ring(const PolygonSet& set, Visit&& visit) {
  for (const Polygon& polygon : set.polygons) {
    visit(polygon.outer);
    for (const Ring& hole : polygon.holes) visit(hole);
  }
}

inline std::string text(const Point& p) {
  return "[\"" + to_string(p.x) + "\",\"" + to_string(p.y) + "\"]";
}

inline std::string text(const Ring& ring) {
  std::string out = "[";
  for (const Point& p : ring) out += (out.size() > 1 ? "," : "") + text(p);
  return out + "]";
}

/// The unchanged set, in canonical JSON notation.
inline std::string text(const PolygonSet& set) {
  std::string out;
  for (const Polygon& polygon : set.polygons) {
    std::string holes;
    for (const Ring& hole : polygon.holes) holes += (holes.empty() ? "" : ",") + text(hole);
    out += (out.empty() ? "" : ",");
    out += "{\"holes\":[" + holes + "],\"outer\":" + text(polygon.outer) + "}";
  }
  return "{\"polygons\":[" + out + "]}";
}

}  // namespace minkref::testing
