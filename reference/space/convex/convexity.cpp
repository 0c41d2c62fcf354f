#include "reference/space/convex/convexity.hpp"

#include <algorithm>
#include <numeric>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/space/area_vector.hpp"
#include "reference/space/face_edges.hpp"
#include "reference/space/polyhedron_place.hpp"

namespace minkref::inline space {
namespace {

template <class Point>
Point combination(int a, const Point& p, int b, const Point& q, int c, const Point& r) {
  Point result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = a * p[k] + b * q[k] + c * r[k];
  return result;
}

template <class Point>
class Surface {
 public:
  Surface(const Polyhedron& polyhedron, const std::vector<Point>& points)
      : polyhedron_(polyhedron), points_(points) {
    for (const Face& face : polyhedron.faces) normals_.push_back(area_vector(points, face));
    const std::vector<FaceEdge> edges = sorted_edges(polyhedron.faces);
    for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
      pairs_.push_back({edges[k], edges[k + 1]});
    }
    is_closed_ = edges.size() % 2 == 0 && are_edges_twice();
  }

  /// Merges coplanar faces into one facet.
  std::vector<Face> certified_facets() {
    merge();
    std::vector<Face> result = boundaries();
    drop_straight(result);
    certify(result, false);
    return result;
  }

  /// Takes each face as a facet.
  void require_strict() {
    if (!is_closed_) refuse("the surface is not closed", 0, {});
    const std::vector<Face>& faces = polyhedron_.faces;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      look_for_interrupt();
      for (const std::uint32_t v : faces[f]) {
        if (dot_sign(normals_[f], points_[v] - points_[faces[f][0]]) != 0) {
          refuse("the vertices of a face lie in no plane", f, {v});
        }
      }
    }
    faces_.resize(faces.size());
    std::iota(faces_.begin(), faces_.end(), 0U);
    certify(faces, true);
  }

 private:
  void certify(const std::vector<Face>& facets, bool is_strict) const {
    check_rings(facets);
    check_ridges(is_strict);
    check_winding(facets);
  }

  [[noreturn]] void refuse(const std::string& problem, std::uint32_t face,
                           const std::vector<std::uint32_t>& vertices) const {
    throw BadInput("not-convex", problem,
                   "give a convex polyhedron, or the parts of a convex decomposition",
                   place_in(polyhedron_, face, vertices));
  }

  bool are_edges_twice() const {
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      look_for_interrupt();
      const auto& [a, b] = pairs_[k];
      if (a.from != b.to || a.to != b.from) return false;
      if (k > 0 && a.ends() == pairs_[k - 1].first.ends()) return false;
    }
    return true;
  }

  bool in_one_plane(const FaceEdge& a, const FaceEdge& b) const {
    return compare(direction(normals_[a.face]), direction(normals_[b.face])) == 0;
  }

  std::uint32_t root(std::uint32_t face) {
    while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
    return face;
  }

  void merge() {
    parent_.resize(polyhedron_.faces.size());
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const auto& [a, b] : pairs_) {
      look_for_interrupt();
      if (!in_one_plane(a, b)) continue;
      const auto [low, high] = std::minmax({root(a.face), root(b.face)});
      parent_[high] = low;
    }
  }

  std::vector<Face> boundaries() {
    std::vector<FaceEdge> edges;  // `face`: the first face of the facet
    for (const auto& [a, b] : pairs_) {
      const std::uint32_t left = root(a.face), right = root(b.face);
      if (left == right) continue;
      edges.push_back({a.from, a.to, left});
      edges.push_back({b.from, b.to, right});
    }
    const auto less = [](const FaceEdge& a, const FaceEdge& b) {
      return std::pair(a.face, a.from) < std::pair(b.face, b.from);
    };
    std::sort(edges.begin(), edges.end(), less);
    std::vector<Face> result;
    for (std::size_t k = 0, end = 0; k < edges.size(); k = end) {
      look_for_interrupt();
      for (end = k; end < edges.size() && edges[end].face == edges[k].face;) ++end;
      Face ring;
      std::size_t at = k;
      do {
        ring.push_back(edges[at].from);
        at = static_cast<std::size_t>(
            std::lower_bound(edges.begin() + static_cast<std::ptrdiff_t>(k),
                             edges.begin() + static_cast<std::ptrdiff_t>(end),
                             FaceEdge{edges[at].to, 0, edges[k].face}, less) -
            edges.begin());
      } while (at != k && ring.size() <= end - k);
      if (ring.size() != end - k) {
        refuse("the faces in a plane bound no single convex polygon", edges[k].face, {ring[0]});
      }
      result.push_back(std::move(ring));
      faces_.push_back(edges[k].face);
    }
    return result;
  }

  /// A vertex of two facets only lies inside their common edge.
  void drop_straight(std::vector<Face>& facets) const {
    std::vector<std::uint32_t> count(points_.size());
    for (const Face& facet : facets) {
      for (const std::uint32_t v : facet) ++count[v];
    }
    for (Face& facet : facets) {
      std::erase_if(facet, [&](std::uint32_t v) { return count[v] < 3; });
    }
  }

  /// Each turns left at every vertex, and runs around once: from one vertex to the next it goes
  /// down, and then up, once.
  void check_rings(const std::vector<Face>& facets) const {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      look_for_interrupt();
      const Face& ring = facets[f];
      const std::size_t n = ring.size();
      if (n < 3) refuse("the faces in a plane bound no convex polygon", faces_[f], ring);
      const auto& normal = normals_[faces_[f]];
      const std::size_t axis = longest_axis(normal), u = (axis + 1) % 3, v = (axis + 2) % 3;
      const int side = normal[axis] < 0 ? -1 : 1;
      const auto is_down = [&](const Point& d) { return d[u] < 0 || (d[u] == 0 && d[v] < 0); };
      std::size_t lowest = 0;
      Point before = points_[ring[0]] - points_[ring[n - 1]];
      for (std::size_t k = 0; k < n; ++k) {
        const Point after = points_[ring[(k + 1) % n]] - points_[ring[k]];
        const auto turn = cross(before, after)[axis];
        if (side < 0 ? turn >= 0 : turn <= 0) {
          refuse("the faces in a plane are not convex at a vertex", faces_[f], {ring[k]});
        }
        lowest += is_down(before) && !is_down(after) ? 1 : 0;
        before = after;
      }
      if (lowest != 1) refuse("the faces in a plane bound no convex polygon", faces_[f], ring);
    }
  }

  /// Without `is_strict`, coplanar faces may meet at an edge.
  void check_ridges(bool is_strict) const {
    for (const auto& [a, b] : pairs_) {
      look_for_interrupt();
      const auto &left = normals_[a.face], &right = normals_[b.face];
      const int turn = turn_sign(left, right, points_[a.to] - points_[a.from]);
      if (turn > 0) continue;
      if (in_one_plane(a, b)) {
        if (!is_strict) continue;
        refuse("two facets lie in one plane", a.face, {a.from, a.to});
      }
      if (turn == 0) {
        refuse("the surface is not convex: two faces lie on each other", a.face, {a.from, a.to});
      }
      for (const std::uint32_t v : polyhedron_.faces[b.face]) {
        if (dot_sign(left, points_[v] - points_[a.from]) > 0) {
          refuse("the surface is not convex: a vertex lies above the plane of a face", a.face, {v});
        }
      }
      refuse("the surface is not convex at an edge", a.face, {a.from, a.to});
    }
  }

  void check_winding(const std::vector<Face>& facets) const {
    // Scaled by 28: o is the mean of the first triangle and a point below, and x lies inside the
    // triangle.
    const Point &a = points_[facets[0][0]], &b = points_[facets[0][1]], &c = points_[facets[0][2]];
    const Point o = combination(7, combination(1, a, 1, b, 1, c), 7, below(facets[0], a), 0, a);
    const Point ray = combination(4, a, 8, b, 16, c) - o;
    const auto seen = [&](std::uint32_t v) { return combination(28, points_[v], -1, o, 0, o); };
    std::size_t met = 0;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      look_for_interrupt();
      const Face& ring = facets[f];
      const auto& normal = normals_[faces_[f]];
      Point before = seen(ring[1]);
      if (dot_sign(normal, before) <= 0) {
        refuse(
            "the surface is not convex: a point between its vertices is not below the plane of a "
            "face",
            faces_[f], {});
      }
      if (dot_sign(normal, ray) <= 0) continue;
      const Point first = seen(ring[0]);
      const auto side = [&](const Point& p, const Point& q) { return dot_sign(cross(p, q), ray); };
      int to_before = side(first, before);
      for (std::size_t k = 2; k < ring.size(); ++k) {
        const Point next = seen(ring[k]);
        const int to_next = side(first, next);
        const auto [low, high] = std::minmax({to_before, side(before, next), -to_next});
        if (low >= 0 || high <= 0) ++met;
        before = next;
        to_before = to_next;
      }
    }
    if (met != 1) {
      refuse("the surface is not convex: it runs around its middle more than once", faces_[0], {});
    }
  }

  /// A vertex below the plane of the first facet.
  const Point& below(const Face& ring, const Point& in_plane) const {
    const auto& normal = normals_[faces_[0]];
    const auto found = std::find_if(points_.begin(), points_.end(), [&](const Point& p) {
      return dot_sign(normal, p - in_plane) < 0;
    });
    if (found == points_.end()) {
      refuse("the surface is not convex: no vertex is below the plane of a face", faces_[0], ring);
    }
    return *found;
  }

  const Polyhedron& polyhedron_;
  const std::vector<Point>& points_;
  std::vector<AreaVector<Point>> normals_;
  std::vector<std::pair<FaceEdge, FaceEdge>> pairs_;  // of a closed surface both sides of each edge
  bool is_closed_ = false;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> faces_;  // of each facet, the first
};

}  // namespace

std::vector<Face> certified_convex_facets(const Polyhedron& surface,
                                          const std::vector<IntegerVector>& points) {
  const auto words = in_words(points);
  if (words && fit_in_words(surface.faces)) return Surface(surface, *words).certified_facets();
  return Surface(surface, points).certified_facets();
}

void require_strictly_convex(const Polyhedron& surface, const std::vector<IntegerVector>& points) {
  Surface(surface, points).require_strict();
}

void require_strictly_convex(const Polyhedron& surface, const std::vector<WordVector>& points) {
  Surface(surface, points).require_strict();
}

}  // namespace minkref::inline space
