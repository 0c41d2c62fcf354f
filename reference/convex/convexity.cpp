#include "reference/convex/convexity.hpp"

#include <algorithm>
#include <numeric>

#include "reference/error.hpp"

namespace minkref {
namespace {

/// An edge of a face as that face runs along it.
struct HalfEdge {
  std::uint32_t from, to, face;
};

class Surface {
 public:
  Surface(const Polyhedron& polyhedron, const std::vector<IntegerVector>& points)
      : polyhedron_(polyhedron), points_(points) {
    for (const Face& face : polyhedron.faces) {
      normals_.push_back(primitive(area_vector(points, face)));
    }
    pair_edges();
  }

  /// Faces in one plane become one facet.
  std::vector<Face> facets() {
    merge();
    std::vector<Face> result = boundaries();
    drop_straight(result);
    return result;
  }

  void certify(const std::vector<Face>& facets) {
    check_rings(facets);
    check_ridges();
    check_winding(facets);
  }

 private:
  [[noreturn]] void refuse(const std::string& problem, std::uint32_t face,
                           const std::vector<std::uint32_t>& vertices) const {
    Place place;
    place.face = face;
    for (const std::uint32_t v : vertices) {
      place.vertices.push_back(v);
      const SpacePoint& p = polyhedron_.vertices[v];
      place.coordinates.push_back("(" + to_string(p.x) + ", " + to_string(p.y) + ", " +
                                  to_string(p.z) + ")");
    }
    throw BadInput("not-convex", problem,
                   "give a convex polyhedron, or the parts of a convex decomposition",
                   std::move(place));
  }

  /// `pairs_`: each edge once, as one of its faces runs along it, and the face on the other side.
  void pair_edges() {
    std::vector<HalfEdge> all;
    for (std::uint32_t f = 0; f < polyhedron_.faces.size(); ++f) {
      const Face& face = polyhedron_.faces[f];
      for (std::size_t k = 0; k < face.size(); ++k) {
        all.push_back({face[k], face[(k + 1) % face.size()], f});
      }
    }
    std::sort(all.begin(), all.end(), [](const HalfEdge& a, const HalfEdge& b) {
      return std::minmax(a.from, a.to) < std::minmax(b.from, b.to);
    });
    for (std::size_t k = 0; k + 1 < all.size(); k += 2) pairs_.push_back({all[k], all[k + 1]});
  }

  std::uint32_t root(std::uint32_t face) {
    while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
    return face;
  }

  void merge() {
    parent_.resize(polyhedron_.faces.size());
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const auto& [a, b] : pairs_) {
      if (normals_[a.face] != normals_[b.face]) continue;
      const auto [low, high] = std::minmax({root(a.face), root(b.face)});
      parent_[high] = low;
    }
  }

  std::vector<Face> boundaries() {
    std::vector<HalfEdge> edges;  // `face`: the first face of the facet
    for (const auto& [a, b] : pairs_) {
      const std::uint32_t left = root(a.face), right = root(b.face);
      if (left == right) continue;
      edges.push_back({a.from, a.to, left});
      edges.push_back({b.from, b.to, right});
    }
    const auto less = [](const HalfEdge& a, const HalfEdge& b) {
      return std::pair(a.face, a.from) < std::pair(b.face, b.from);
    };
    std::sort(edges.begin(), edges.end(), less);
    std::vector<Face> result;
    for (std::size_t k = 0, end = 0; k < edges.size(); k = end) {
      for (end = k; end < edges.size() && edges[end].face == edges[k].face;) ++end;
      Face ring;
      std::size_t at = k;
      do {
        ring.push_back(edges[at].from);
        at = static_cast<std::size_t>(
            std::lower_bound(edges.begin() + static_cast<std::ptrdiff_t>(k),
                             edges.begin() + static_cast<std::ptrdiff_t>(end),
                             HalfEdge{edges[at].to, 0, edges[k].face}, less) -
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

  void check_rings(const std::vector<Face>& facets) const {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const Face& ring = facets[f];
      const std::size_t n = ring.size();
      if (n < 3) refuse("the faces in a plane bound no convex polygon", faces_[f], ring);
      for (std::size_t k = 0; k < n; ++k) {
        const std::uint32_t a = ring[k], b = ring[(k + 1) % n], c = ring[(k + 2) % n];
        if (dot(cross(points_[b] - points_[a], points_[c] - points_[b]), normals_[faces_[f]]) <=
            0) {
          refuse("the faces in a plane are not convex at a vertex", faces_[f], {b});
        }
      }
    }
  }

  void check_ridges() const {
    for (const auto& [a, b] : pairs_) {
      if (normals_[a.face] == normals_[b.face]) continue;
      const IntegerVector along = points_[a.to] - points_[a.from];
      const int turn = dot(cross(normals_[a.face], normals_[b.face]), along).sign();
      if (turn > 0) continue;
      if (turn == 0) {
        refuse("the surface is not convex: two faces lie on each other", a.face, {a.from, a.to});
      }
      const Integer height = dot(normals_[a.face], points_[a.from]);
      for (const std::uint32_t v : polyhedron_.faces[b.face]) {
        if (dot(normals_[a.face], points_[v]) > height) {
          refuse("the surface is not convex: a vertex lies above the plane of a face", a.face, {v});
        }
      }
    }
  }

  void check_winding(const std::vector<Face>& facets) const {
    // Over the denominator 7 n: o the mean of all vertices of facets, x inside the first triangle.
    IntegerVector sum{0, 0, 0};
    Integer count = 0;
    for (const Face& ring : facets) {
      for (const std::uint32_t v : ring) sum = sum + points_[v];
      count += ring.size();
    }
    const auto times = [](const Integer& k, const IntegerVector& v) {
      return IntegerVector{k * v[0], k * v[1], k * v[2]};
    };
    const Integer unit = 7 * count;
    const IntegerVector o = times(7, sum);
    const Face& first = facets[0];
    const IntegerVector x =
        times(count, points_[first[0]] + times(2, points_[first[1]]) + times(4, points_[first[2]]));
    const IntegerVector ray = x - o;
    std::size_t met = 0;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const Face& ring = facets[f];
      const IntegerVector& normal = normals_[faces_[f]];
      if (dot(normal, o) >= unit * dot(normal, points_[ring[0]])) {
        refuse(
            "the surface is not convex: the mean of its vertices is not below the plane of a face",
            faces_[f], {});
      }
      if (dot(normal, ray) <= 0) continue;
      const auto side = [&](std::uint32_t a, std::uint32_t b) {
        return dot(cross(times(unit, points_[a]) - o, times(unit, points_[b]) - o), ray).sign();
      };
      for (std::size_t k = 2; k < ring.size(); ++k) {
        const auto [low, high] = std::minmax(
            {side(ring[0], ring[k - 1]), side(ring[k - 1], ring[k]), side(ring[k], ring[0])});
        if (low >= 0 || high <= 0) ++met;
      }
    }
    if (met != 1) {
      refuse("the surface is not convex: it runs around its middle more than once", faces_[0], {});
    }
  }

  const Polyhedron& polyhedron_;
  const std::vector<IntegerVector>& points_;
  std::vector<IntegerVector> normals_;
  std::vector<std::pair<HalfEdge, HalfEdge>> pairs_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> faces_;  // of each facet, the first
};

}  // namespace

std::vector<Face> certified_convex_facets(const Polyhedron& surface,
                                          const std::vector<IntegerVector>& points) {
  Surface whole(surface, points);
  std::vector<Face> facets = whole.facets();
  whole.certify(facets);
  return facets;
}

}  // namespace minkref
