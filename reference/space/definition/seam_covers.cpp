#include "reference/space/definition/seam_covers.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/space/area_vector.hpp"
#include "reference/space/box_tree.hpp"
#include "reference/space/definition/convex_clip.hpp"
#include "reference/space/face_triangles.hpp"

namespace minkref::inline space {
namespace {

/// A box around the corners of a polyhedron, a triangle or a segment, as doubles.
SpaceBox box_of_corners(const std::vector<SpacePoint>& corners) {
  SpaceBox box;
  for (const SpacePoint& p : corners) {
    const Enclosure x = enclose(p.x), y = enclose(p.y), z = enclose(p.z);
    SpaceBox one;
    one.low = {x.lower, y.lower, z.lower};
    one.high = {x.upper, y.upper, z.upper};
    box.add(one);
  }
  return box;
}

using Corners = std::vector<SpacePoint>;

/// A convex polyhedron with its faces' planes, their normals primitive.
struct CoveringPiece {
  Polyhedron surface;
  std::vector<HalfSpace> planes;
  SpaceBox box;

  explicit CoveringPiece(Polyhedron convex) : surface(std::move(convex)) {
    const IntegerPoints integers = integer_points(surface.vertices);
    for (const Face& face : surface.faces) {
      const IntegerVector n = primitive(area_vector(integers.points, face));
      const SpacePoint normal{Rational(n[0]), Rational(n[1]), Rational(n[2])};
      planes.push_back({normal, dot(normal, surface.vertices[face[0]])});
    }
    box = box_of_corners(surface.vertices);
  }
  Corners ring(std::size_t face) const {
    Corners corners;
    for (const std::uint32_t v : surface.faces[face]) corners.push_back(surface.vertices[v]);
    return corners;
  }
};

/// A triangle of the solid's surface: the points below all planes, two of which contain the
/// triangle.
struct SurfacePart {
  Corners corners;
  std::vector<HalfSpace> planes;
  SpaceBox box;

  explicit SurfacePart(Corners triangle) : corners(std::move(triangle)) {
    const SpacePoint n = cross(corners[1] - corners[0], corners[2] - corners[0]);
    planes = {{n, dot(n, corners[0])}, {Rational(-1) * n, -dot(n, corners[0])}};
    for (std::size_t k = 0; k < 3; ++k) {
      const SpacePoint out = cross(corners[(k + 1) % 3] - corners[k], n);
      planes.push_back({out, dot(out, corners[k])});
    }
    box = box_of_corners(corners);
  }
};

struct ByCoordinatesInSpace {
  bool operator()(const SpacePoint& a, const SpacePoint& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};
using SeamEnds = std::pair<SpacePoint, SpacePoint>;
struct BySeamEnds {
  bool operator()(const SeamEnds& a, const SeamEnds& b) const {
    const ByCoordinatesInSpace before;
    return before(a.first, b.first) || (a.first == b.first && before(a.second, b.second));
  }
};

SpacePoint middle_of_corners(const Corners& corners) {
  SpacePoint sum;
  for (const SpacePoint& p : corners) sum = sum + p;
  return Rational(1, corners.size()) * sum;
}

bool has_area(const Corners& ring) {
  for (std::size_t k = 2; k < ring.size(); ++k) {
    if (!is_zero(cross(ring[k - 1] - ring[0], ring[k] - ring[0]))) return true;
  }
  return false;
}

/// A convex surface of triangles between corners around an axis and the axis's two ends.
CoveringPiece double_cone(const Corners& around, const SpacePoint& one_end,
                          const SpacePoint& other_end) {
  Polyhedron surface{around, {}};
  const auto n = static_cast<std::uint32_t>(around.size());
  surface.vertices.push_back(one_end);
  surface.vertices.push_back(other_end);
  for (std::uint32_t k = 0; k < n; ++k) {
    surface.faces.push_back({k, (k + 1) % n, n});
    surface.faces.push_back({(k + 1) % n, k, n + 1});
  }
  if (sextuple_volume(surface) < 0) {
    for (Face& face : surface.faces) std::reverse(face.begin(), face.end());
  }
  return CoveringPiece(std::move(surface));
}

/// The seams between a solid's convex pieces, and covers with the seams inside.
class SeamCovers {
 public:
  SeamCovers(const Polyhedron& solid, const std::vector<Polyhedron>& pieces)
      : pieces_(pieces.begin(), pieces.end()) {
    const IntegerPoints integers = integer_points(solid.vertices);
    const VertexSigns signs(integers.points);
    for (const Face& face : solid.faces) {
      const auto triangles = face_triangles(face, signs);
      if (!triangles) throw std::logic_error("a face of a valid solid has no triangles");
      for (const TriangleCorners& t : *triangles) {
        surface_.emplace_back(
            Corners{solid.vertices[t[0]], solid.vertices[t[1]], solid.vertices[t[2]]});
      }
    }
  }

  std::vector<Polyhedron> run() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (std::size_t k = i + 1; k < pieces_.size(); ++k) {
        look_for_interrupt();
        if (pieces_[i].box.overlaps(pieces_[k].box)) cover_common_faces(pieces_[i], pieces_[k]);
      }
    }
    cover_edges();
    for (const SpacePoint& p : points_) {
      look_for_interrupt();
      if (!is_on_surface(p)) cover(p);
    }
    return std::move(covers_);
  }

 private:
  void cover_common_faces(const CoveringPiece& a, const CoveringPiece& b) {
    for (std::size_t f = 0; f < a.planes.size(); ++f) {
      const HalfSpace& plane = a.planes[f];
      for (std::size_t g = 0; g < b.planes.size(); ++g) {
        const HalfSpace& other = b.planes[g];
        if (plane.offset != -other.offset || !is_zero(plane.normal + other.normal)) continue;
        const Corners seam = below_all(a.ring(f), b.planes);
        if (has_area(seam)) cover(seam, a, b, g);
      }
    }
  }

  /// Covers a seam, a convex polygon, by a double cone with an end inside each piece.
  void cover(const Corners& seam, const CoveringPiece& a, const CoveringPiece& b, std::size_t own) {
    Corners ring;  // without repeated and straight corners
    for (const SpacePoint& p : seam) {
      if (ring.empty() || (!(ring.back() == p) && !(ring.front() == p))) ring.push_back(p);
    }
    const SpacePoint middle = middle_of_corners(ring), end = middle_of_corners(a.surface.vertices),
                     way = middle - end;
    Rational room = 1;
    for (std::size_t f = 0; f < b.planes.size(); ++f) {
      const HalfSpace& plane = b.planes[f];
      const Rational slope = dot(plane.normal, way);
      if (f == own || slope <= 0) continue;
      room = std::min(room, Rational((plane.offset - dot(plane.normal, middle)) / slope));
    }
    covers_.push_back(double_cone(ring, end, middle + room / 2 * way).surface);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const SpacePoint &p = ring[k], &q = ring[(k + 1) % ring.size()];
      edges_.insert(ByCoordinatesInSpace()(p, q) ? SeamEnds(p, q) : SeamEnds(q, p));
    }
  }

  /// Cuts seam edges where they end, cross each other or meet the surface.
  void cover_edges() {
    for (const SeamEnds& edge : edges_) {
      points_.insert(edge.first);
      points_.insert(edge.second);
    }
    const std::vector<SpacePoint> ends(points_.begin(), points_.end());
    std::set<SeamEnds, BySeamEnds> done;
    for (const SeamEnds& edge : edges_) {
      look_for_interrupt();
      const SpacePoint &a = edge.first, &b = edge.second;
      const SpacePoint along = b - a;
      const Rational length = dot(along, along);
      std::vector<Rational> cuts{0, 1};
      const auto cut_at = [&](const SpacePoint& p) { cuts.push_back(dot(p - a, along) / length); };
      for (const SpacePoint& p : ends) {
        if (is_zero(cross(p - a, along))) cut_at(p);
      }
      for (const SeamEnds& other : edges_) {
        if (const auto p = crossing_of(edge, other)) cut_at(*p);
      }
      const SpaceBox box = box_of_corners({a, b});
      for (const SurfacePart& part : surface_) {
        if (!part.box.overlaps(box)) continue;
        for (const SpacePoint& p : below_all({a, b}, part.planes)) cut_at(p);
      }
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        if (cuts[k] == cuts[k + 1] || cuts[k] < 0 || cuts[k + 1] > 1) continue;
        const SpacePoint from = a + cuts[k] * along, to = a + cuts[k + 1] * along;
        points_.insert(from);
        points_.insert(to);
        if (!is_on_surface(Rational(1, 2) * (from + to)) && done.insert({from, to}).second) {
          cover(from, to);
        }
      }
    }
  }

  static std::optional<SpacePoint> crossing_of(const SeamEnds& edge, const SeamEnds& other) {
    const SpacePoint u = edge.second - edge.first, v = other.second - other.first;
    const SpacePoint n = cross(u, v), w = other.first - edge.first;
    if (is_zero(n) || dot(n, w) != 0) return std::nullopt;
    const Rational part = dot(cross(w, v), n) / dot(n, n);
    if (part < 0 || part > 1) return std::nullopt;
    return edge.first + part * u;
  }

  bool is_on_surface(const SpacePoint& p) const {
    const SpaceBox box = box_of_corners({p});
    return std::any_of(surface_.begin(), surface_.end(), [&](const SurfacePart& part) {
      return part.box.overlaps(box) && !below_all({p}, part.planes).empty();
    });
  }

  /// Halves a piece's breadth until no surface lies in the piece's interior.
  template <class Make>
  void cover_within_solid(Rational size, const Make& make) {
    constexpr int most_halvings = 4096;
    for (int k = 0; k < most_halvings; ++k) {
      look_for_interrupt();
      CoveringPiece piece = make(size);
      const bool meets =
          std::any_of(surface_.begin(), surface_.end(), [&](const SurfacePart& part) {
            return part.box.overlaps(piece.box) &&
                   is_strictly_below_somewhere(part.corners, piece.planes);
          });
      if (!meets) {
        covers_.push_back(std::move(piece.surface));
        return;
      }
      size = size / 2;
    }
    throw std::logic_error("a seam of convex pieces has no room around it");
  }

  void cover(const SpacePoint& from, const SpacePoint& to) {
    const SpacePoint along = to - from, middle = Rational(1, 2) * (from + to);
    const SpacePoint axis = along.x != 0 ? SpacePoint{0, 1, 0} : SpacePoint{1, 0, 0};
    const SpacePoint u = cross(along, axis);
    SpacePoint v = cross(along, u);  // as long as the square of the edge: brought to its length
    const Rational most = std::max({abs(v.x), abs(v.y), abs(v.z)});
    v = std::max({abs(u.x), abs(u.y), abs(u.z)}) / most * v;
    cover_within_solid(1, [&](const Rational& size) {
      return double_cone(
          {middle + size * u, middle + size * v, middle - size * u, middle - size * v}, from, to);
    });
  }

  void cover(const SpacePoint& p) {
    const SpacePoint u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};
    cover_within_solid(1, [&](const Rational& size) {
      return double_cone({p + size * u, p + size * v, p - size * u, p - size * v}, p + size * w,
                         p - size * w);
    });
  }

  std::vector<CoveringPiece> pieces_;
  std::vector<SurfacePart> surface_;
  std::set<SeamEnds, BySeamEnds> edges_;
  std::set<SpacePoint, ByCoordinatesInSpace> points_;
  std::vector<Polyhedron> covers_;
};

}  // namespace

std::vector<Polyhedron> seam_covers(const Polyhedron& solid,
                                    const std::vector<Polyhedron>& pieces) {
  return SeamCovers(solid, pieces).run();
}

}  // namespace minkref::inline space
