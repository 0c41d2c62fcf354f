#include "oracle/checker/space/canonical_form.hpp"

#include <algorithm>
#include <set>

#include "oracle/checker/space/plane_region.hpp"

namespace minkref::checker {
namespace {

struct FacePlane {
  Whole normal;
  mpq_class offset;
  std::vector<PlanePolygon> region;
};

std::size_t seen_along(const Whole& normal) { return normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2; }

/// Whether rings counter-clockwise from outside appear clockwise in the projection.
bool is_mirrored(const Whole& normal) {
  const std::size_t axis = seen_along(normal);
  return (normal[axis] > 0) == (axis == 1);
}

/// Returns the two other axes, ascending.
std::pair<std::size_t, std::size_t> beside(std::size_t axis) {
  return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

PlaneRing seen(const ConvexPolygon& polygon, const Whole& normal, const mpz_class& unit) {
  const auto [u, v] = beside(seen_along(normal));
  PlaneRing ring;
  for (const Corner& corner : polygon) {
    const mpz_class below = corner[3] * unit;
    mpq_class first(corner[u], below), second(corner[v], below);
    first.canonicalize();
    second.canonicalize();
    ring.emplace_back(first, second);
  }
  if (is_mirrored(normal)) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// Returns the plane's point above a projected point.
Triple lifted(const PlanePoint& point, const FacePlane& plane) {
  const std::size_t axis = seen_along(plane.normal);
  const auto [u, v] = beside(axis);
  Triple place;
  place[u] = point.first;
  place[v] = point.second;
  place[axis] = (plane.offset - plane.normal[u] * point.first - plane.normal[v] * point.second) /
                plane.normal[axis];
  return place;
}

bool is_below(const Triple& p, const FacePlane& plane) {
  const Whole& n = plane.normal;
  return mpq_class(n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) <= plane.offset;
}

std::string to_text(const PlaneRing& ring) {
  std::string text;
  for (const auto& [x, y] : ring) {
    text += (text.empty() ? "[\"" : ",[\"") + x.get_str() + "\",\"" + y.get_str() + "\"]";
  }
  return "[" + text + "]";
}

std::string to_text(const PlanePolygon& polygon) {
  std::string holes;
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    holes += (k > 1 ? "," : "") + to_text(polygon[k]);
  }
  return "{\"holes\":[" + holes + "],\"outer\":" + to_text(polygon[0]) + "}";
}

std::string to_text(const std::vector<FacePlane>& planes) {
  std::string rows;
  for (const FacePlane& plane : planes) {
    std::string polygons;
    for (const PlanePolygon& polygon : plane.region) {
      polygons += (polygons.empty() ? "" : ",") + to_text(polygon);
    }
    const Whole& n = plane.normal;
    rows += std::string(rows.empty() ? "" : ",") + "{\"normal\":[\"" + n[0].get_str() + "\",\"" +
            n[1].get_str() + "\",\"" + n[2].get_str() + "\"],\"offset\":\"" +
            plane.offset.get_str() + "\",\"region\":{\"polygons\":[" + polygons + "]}}";
  }
  return "{\"planes\":[" + rows + "]}";
}

/// Writes a convex set: each plane has one polygon, without holes.
std::string convex_text(const std::vector<FacePlane>& planes, const std::set<Triple>& corners) {
  const std::vector<Triple> vertices(corners.begin(), corners.end());
  std::vector<Ring> faces;
  for (const FacePlane& plane : planes) {
    Ring face;
    for (const PlanePoint& point : plane.region.at(0).at(0)) {
      const auto at = std::lower_bound(vertices.begin(), vertices.end(), lifted(point, plane));
      face.push_back(static_cast<std::uint32_t>(at - vertices.begin()));
    }
    if (is_mirrored(plane.normal)) std::reverse(face.begin(), face.end());
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(std::move(face));
  }
  std::sort(faces.begin(), faces.end());
  return canonical_json(faces, vertices);
}

}  // namespace

CanonicalForm canonical_form(const Tiles& tiles, const mpz_class& unit, Budget& budget) {
  CanonicalForm form;
  std::vector<FacePlane> planes;
  mpq_class sextuple;
  for (const auto& [plane, polygons] : tiles) {
    FacePlane& face = planes.emplace_back();
    face.normal = plane.first;
    face.offset = mpq_class(plane.second, unit);
    face.offset.canonicalize();
    std::vector<PlaneRing> rings;
    mpq_class doubled;
    for (const ConvexPolygon& polygon : polygons) {
      rings.push_back(seen(polygon, face.normal, unit));
      doubled += doubled_area(rings.back());
    }
    face.region = united(rings, budget);
    form.polygons += face.region.size();
    sextuple += face.offset * doubled / abs(face.normal[seen_along(face.normal)]);
  }
  form.planes = planes.size();
  form.volume = sextuple / 6;
  std::set<Triple> corners;
  for (const FacePlane& plane : planes) {
    for (const PlanePolygon& polygon : plane.region) {
      for (const PlaneRing& ring : polygon) {
        for (const PlanePoint& point : ring) corners.insert(lifted(point, plane));
      }
    }
  }
  const bool convex = std::all_of(planes.begin(), planes.end(), [&](const FacePlane& plane) {
    budget.spend(corners.size());
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Triple& p) { return is_below(p, plane); });
  });
  form.text = convex ? convex_text(planes, corners) : to_text(planes);
  return form;
}

}  // namespace minkref::checker
