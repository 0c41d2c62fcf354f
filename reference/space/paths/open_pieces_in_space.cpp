#include "reference/space/paths/open_pieces_in_space.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

#include "reference/space/definition/convex_pieces.hpp"
#include "reference/space/face_triangles.hpp"
#include "reference/space/paths/convex_clip.hpp"

namespace minkref::inline space {
namespace {

using Corners = std::vector<SpacePoint>;

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

HalfSpace plane_of(const SolidPiece& piece, std::size_t face) {
  return {piece.across[face], dot(piece.across[face], piece.corners[piece.faces[face][0]])};
}

std::vector<HalfSpace> planes_of(const SolidPiece& piece) {
  std::vector<HalfSpace> planes;
  for (std::size_t f = 0; f < piece.faces.size(); ++f) planes.push_back(plane_of(piece, f));
  return planes;
}

Corners ring_of(const SolidPiece& piece, std::size_t face) {
  Corners ring;
  for (const std::uint32_t v : piece.faces[face]) ring.push_back(piece.corners[v]);
  return ring;
}

bool has_area(const Corners& ring) {
  for (std::size_t k = 2; k < ring.size(); ++k) {
    if (!is_zero(cross(ring[k - 1] - ring[0], ring[k] - ring[0]))) return true;
  }
  return false;
}

/// A convex surface of triangles from corners that go around an axis and its two ends.
SolidPiece double_cone(const Corners& around, const SpacePoint& one_end,
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
  return SolidPiece(surface);
}

/// The seams of convex pieces of a solid, and pieces that have them inside.
class SeamCovers {
 public:
  SeamCovers(const Polyhedron& solid, const std::vector<SolidPiece>& pieces) : pieces_(pieces) {
    const IntegerPoints integers = integer_points(solid.vertices);
    const VertexSigns signs(integers.points);
    for (const Face& face : solid.faces) {
      const auto triangles = face_triangles(face, signs);
      if (!triangles) throw std::logic_error("a face of a valid solid has no triangles");
      for (const TriangleCorners& t : *triangles) {
        surface_.push_back({solid.vertices[t[0]], solid.vertices[t[1]], solid.vertices[t[2]]});
        surface_pieces_.emplace_back(Polyhedron{surface_.back(), {{0, 1, 2}}});
      }
    }
  }

  std::vector<SolidPiece> run() {
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
  void cover_common_faces(const SolidPiece& a, const SolidPiece& b) {
    for (std::size_t f = 0; f < a.faces.size(); ++f) {
      const HalfSpace plane = plane_of(a, f);
      for (std::size_t g = 0; g < b.faces.size(); ++g) {
        const HalfSpace other = plane_of(b, g);
        if (!is_zero(plane.normal + other.normal) || plane.offset != -other.offset) continue;
        const Corners seam = below_all(ring_of(a, f), planes_of(b));
        if (has_area(seam)) cover(seam, a, b, g);
      }
    }
  }

  /// A seam is a convex polygon; it gets an end in each piece.
  void cover(const Corners& seam, const SolidPiece& a, const SolidPiece& b, std::size_t own) {
    Corners ring;  // without repeated and straight corners
    for (const SpacePoint& p : seam) {
      if (ring.empty() || (!(ring.back() == p) && !(ring.front() == p))) ring.push_back(p);
    }
    const SpacePoint middle = middle_of_corners(ring), end = a.middle(), way = middle - end;
    Rational room = 1;
    for (std::size_t f = 0; f < b.faces.size(); ++f) {
      const HalfSpace plane = plane_of(b, f);
      const Rational slope = dot(plane.normal, way);
      if (f == own || slope <= 0) continue;
      room = std::min(room, Rational((plane.offset - dot(plane.normal, middle)) / slope));
    }
    covers_.push_back(double_cone(ring, end, middle + room / 2 * way));
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const SpacePoint &p = ring[k], &q = ring[(k + 1) % ring.size()];
      edges_.insert(ByCoordinatesInSpace()(p, q) ? SeamEnds(p, q) : SeamEnds(q, p));
    }
  }

  /// Where edges of seams end, cross each other or meet the surface they are cut.
  void cover_edges() {
    for (const SeamEnds& edge : edges_) {
      points_.insert(edge.first);
      points_.insert(edge.second);
    }
    const std::vector<SpacePoint> ends(points_.begin(), points_.end());
    std::set<SeamEnds, BySeamEnds> done;
    for (const SeamEnds& edge : edges_) {
      look_for_interrupt();
      const auto& [a, b] = edge;
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
      const SolidPiece segment(Polyhedron{{a, b}, {}});
      for (std::size_t k = 0; k < surface_.size(); ++k) {
        if (!surface_pieces_[k].box.overlaps(segment.box)) continue;
        for (const SpacePoint& p : common_ends(segment, k)) cut_at(p);
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

  /// The ends of what a segment has in common with a triangle of the surface.
  Corners common_ends(const SolidPiece& segment, std::size_t triangle) const {
    const Corners& t = surface_[triangle];
    const SpacePoint n = cross(t[1] - t[0], t[2] - t[0]);
    std::vector<HalfSpace> planes{{n, dot(n, t[0])}, {Rational(-1) * n, -dot(n, t[0])}};
    for (std::size_t k = 0; k < 3; ++k) {
      const SpacePoint out = cross(t[(k + 1) % 3] - t[k], n);
      planes.push_back({out, dot(out, t[k])});
    }
    return below_all(segment.corners, planes);
  }

  bool is_on_surface(const SpacePoint& p) const {
    return std::any_of(surface_pieces_.begin(), surface_pieces_.end(), [&](const SolidPiece& t) {
      const NearVector<3> near = PathsInSpace::near(p);
      for (std::size_t k = 0; k < 3; ++k) {
        if (near[k].upper() < t.box.low[k] || t.box.high[k] < near[k].lower()) return false;
      }
      return t.contains(p);
    });
  }

  /// Halves a piece in breadth until nothing of the surface is in its interior.
  template <class Make>
  void cover_within_solid(Rational size, const Make& make) {
    constexpr int most_halvings = 4096;
    for (int k = 0; k < most_halvings; ++k) {
      look_for_interrupt();
      SolidPiece piece = make(size);
      const std::vector<HalfSpace> planes = planes_of(piece);
      bool meets = false;
      for (std::size_t t = 0; t < surface_.size() && !meets; ++t) {
        meets = surface_pieces_[t].box.overlaps(piece.box) &&
                is_strictly_below_somewhere(surface_[t], planes);
      }
      if (!meets) {
        covers_.push_back(std::move(piece));
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

  const std::vector<SolidPiece>& pieces_;
  std::vector<Corners> surface_;  ///< triangles
  std::vector<SolidPiece> surface_pieces_;
  std::set<SeamEnds, BySeamEnds> edges_;
  std::set<SpacePoint, ByCoordinatesInSpace> points_;
  std::vector<SolidPiece> covers_;
};

}  // namespace

std::vector<SolidPiece> open_pieces(const Polyhedron& operand, bool open) {
  if (operand.empty()) return {};
  if (operand.faces.empty()) return {SolidPiece(operand)};
  std::vector<SolidPiece> pieces;
  if (operand.faces.size() == 1) {
    const IntegerPoints integers = integer_points(operand.vertices);
    const auto triangles = face_triangles(operand.faces[0], VertexSigns(integers.points));
    if (!triangles) throw std::logic_error("a plane polygon has no triangles");
    for (const TriangleCorners& t : *triangles) {
      pieces.emplace_back(Polyhedron{
          {operand.vertices[t[0]], operand.vertices[t[1]], operand.vertices[t[2]]}, {{0, 1, 2}}});
    }
    return pieces;
  }
  for (const Polyhedron& piece : convex_pieces(operand)) pieces.emplace_back(piece);
  if (!open) return pieces;
  std::vector<SolidPiece> covers = SeamCovers(operand, pieces).run();
  pieces.insert(pieces.end(), std::make_move_iterator(covers.begin()),
                std::make_move_iterator(covers.end()));
  return pieces;
}

}  // namespace minkref::inline space
