// Refuses what is no polyhedron, with the face and the vertices at fault.
#include <algorithm>
#include <optional>
#include <string>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/polygon_set.hpp"
#include "reference/space/area_vector.hpp"
#include "reference/space/face_edges.hpp"
#include "reference/space/integer_points.hpp"
#include "reference/space/polyhedron.hpp"
#include "reference/space/polyhedron_place.hpp"
#include "reference/space/self_crossing.hpp"

namespace minkref::inline space {
namespace {

class PolyhedronValidator {
 public:
  explicit PolyhedronValidator(const Polyhedron& polyhedron) : polyhedron_(polyhedron) {}

  void run() {
    run_on_mesh();
    if (!polyhedron_.is_solid()) return;
    VertexSigns signs(integers_.points);
    std::vector<SurfaceTriangle> triangles = surface_triangles(faces(), signs);
    SpaceBoxTree tree = box_tree(triangles, signs);
    const SearchedSurface surface{polyhedron_, integers_.denominator, std::move(signs),
                                  std::move(triangles), std::move(tree)};
    refuse_crossing_faces(surface);
    check_side();
    refuse_wrong_nesting(surface);
  }

  void run_on_polygon() {
    validate_faces(polyhedron_);
    check_repetitions();
    check_all_used();
    integers_ = integer_points(polyhedron_.vertices);
    check_face(0);
  }

  void run_on_mesh() {
    validate_faces(polyhedron_);
    check_repetitions();
    if (!polyhedron_.is_solid()) return check_degenerate();
    check_all_used();
    integers_ = integer_points(polyhedron_.vertices);
    for (std::uint32_t f = 0; f < faces().size(); ++f) check_face(f);
    check_edges();
    check_fans();
  }

 private:
  const std::vector<Face>& faces() const { return polyhedron_.faces; }

  Place place(std::optional<std::uint32_t> face, const std::vector<std::uint32_t>& vertices) const {
    return place_in(polyhedron_, face, vertices);
  }

  void check_repetitions() const {
    for (std::uint32_t f = 0; f < faces().size(); ++f) {
      look_for_interrupt();
      Face sorted = faces()[f];
      std::sort(sorted.begin(), sorted.end());
      const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
      if (twice != sorted.end()) {
        throw BadInput("repeated-vertex", "a face visits a vertex twice",
                       "split the face there, or remove the repetition", place(f, {*twice}));
      }
    }
  }

  /// Nothing, a point or a segment.
  void check_degenerate() const {
    const std::vector<SpacePoint>& vertices = polyhedron_.vertices;
    if (vertices.size() > 2) {
      throw BadInput("too-few-faces",
                     "there are " + std::to_string(vertices.size()) + " vertices and no face",
                     "give the faces, or a single point or segment as the whole operand");
    }
    if (vertices.size() == 2 && vertices[0] == vertices[1]) {
      throw BadInput("zero-length-edge", "the two ends of the segment are equal",
                     "give a point by one vertex", place(std::nullopt, {0, 1}));
    }
  }

  void check_all_used() const {
    std::vector<bool> used(polyhedron_.vertices.size());
    for (const Face& face : faces()) {
      for (const std::uint32_t v : face) used[v] = true;
    }
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end()) {
      throw BadInput("unused-vertex", "a vertex belongs to no face", "remove it",
                     place(std::nullopt, {static_cast<std::uint32_t>(unused - used.begin())}));
    }
  }

  void check_face(std::uint32_t f) const {
    look_for_interrupt();
    const Face& face = faces()[f];
    const std::vector<IntegerVector>& points = integers_.points;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t a = face[k], b = face[(k + 1) % face.size()];
      if (points[a] == points[b]) {
        throw BadInput("zero-length-edge", "two consecutive vertices of a face are equal",
                       "make them one vertex", place(f, {a, b}));
      }
    }
    IntegerVector normal = area_vector(points, face);
    // The parts of a self-crossing face may cancel: the face has a plane all the same.
    if (is_zero(normal)) normal = normal_of_corners(face);
    if (is_zero(normal)) {
      throw BadInput("zero-area", "all vertices of a face lie on one line",
                     "remove it, and join the faces on its two sides", place(f, face));
    }
    const Integer height = dot(normal, points[face[0]]);
    for (const std::uint32_t v : face) {
      if (dot(normal, points[v]) != height) {
        throw BadInput("non-planar-face", "the vertices of a face lie in no plane",
                       "cut the face into triangles, or move this vertex", place(f, {v}));
      }
    }
    if (face.size() > 3) check_simple(f, normal);
  }

  /// The normal from the first three consecutive vertices not on a line; zero if no such vertices
  /// exist.
  IntegerVector normal_of_corners(const Face& face) const {
    for (std::size_t a = 0; a + 2 < face.size(); ++a) {
      const IntegerVector normal =
          area_vector(integers_.points, {face[a], face[a + 1], face[a + 2]});
      if (!is_zero(normal)) return normal;
    }
    return {};
  }

  /// Looks along the normal's longest axis, which shows the face faithfully.
  void check_simple(std::uint32_t f, const IntegerVector& normal) const {
    const std::size_t axis = longest_axis(normal);
    Ring ring;
    for (const std::uint32_t v : faces()[f]) {
      const IntegerVector& p = integers_.points[v];
      ring.push_back({Rational(p[(axis + 1) % 3]), Rational(p[(axis + 2) % 3])});
    }
    PolygonSet flat{{Polygon{std::move(ring), {}}}};
    orient(flat);
    try {
      validate(flat);
    } catch (const BadInput& fault) {
      std::vector<std::uint32_t> at;
      const std::size_t count = faces()[f].size();
      // A ring with zero area has not been turned.
      const bool turned = normal[axis] < 0 && !is_zero(area_vector(integers_.points, faces()[f]));
      for (const std::size_t k : fault.place().vertices) {
        at.push_back(faces()[f][turned && k > 0 ? count - k : k]);
      }
      throw BadInput("face-not-simple", "the edges of a face meet each other",
                     "split the face where it meets itself, or move a vertex", place(f, at));
    }
  }

  void check_edges() const {
    const std::vector<FaceEdge> edges = sorted_edges(faces());
    for (std::size_t k = 0, end = 0; k < edges.size(); k = end) {
      look_for_interrupt();
      for (end = k; end < edges.size() && edges[end].ends() == edges[k].ends();) ++end;
      if (end - k == 2 && edges[k].from != edges[k + 1].from) continue;
      Place at = place(edges[k].face, {edges[k].from, edges[k].to});
      if (end - k == 1) {
        throw BadInput("open-mesh",
                       "an edge of a face belongs to no other face: the surface is open",
                       "add the face that is missing, or make equal vertices one", std::move(at));
      }
      at.other_face = edges[k + 1].face;
      if (end - k > 2) {
        throw BadInput("non-manifold-edge",
                       "an edge belongs to " + std::to_string(end - k) + " faces",
                       "an edge belongs to two faces: split the surface there", std::move(at));
      }
      throw BadInput("wrong-orientation", "two faces run along their common edge the same way",
                     "turn one of them: seen from outside every face runs counter-clockwise",
                     std::move(at));
    }
  }

  /// Requires a single fan of faces around every vertex.
  void check_fans() const {
    struct Corner {
      std::uint32_t vertex, after, before, face;
    };
    std::vector<Corner> corners;
    for (std::uint32_t f = 0; f < faces().size(); ++f) {
      look_for_interrupt();
      const Face& face = faces()[f];
      for (std::size_t k = 0, n = face.size(); k < n; ++k) {
        corners.push_back({face[k], face[(k + 1) % n], face[(k + n - 1) % n], f});
      }
    }
    const auto less = [](const Corner& a, const Corner& b) {
      look_for_interrupt();
      return std::pair(a.vertex, a.after) < std::pair(b.vertex, b.after);
    };
    std::sort(corners.begin(), corners.end(), less);
    for (std::size_t k = 0, end = 0; k < corners.size(); k = end) {
      look_for_interrupt();
      for (end = k; end < corners.size() && corners[end].vertex == corners[k].vertex;) ++end;
      std::size_t seen = 0, at = k;
      do {
        const Corner wanted{corners[k].vertex, corners[at].before, 0, 0};
        at = static_cast<std::size_t>(
            std::lower_bound(corners.begin() + static_cast<std::ptrdiff_t>(k),
                             corners.begin() + static_cast<std::ptrdiff_t>(end), wanted, less) -
            corners.begin());
        ++seen;
      } while (at != k);
      if (seen != end - k) {
        throw BadInput("non-manifold-vertex", "the faces at a vertex are more than one fan",
                       "give each fan a vertex of its own",
                       place(corners[k].face, {corners[k].vertex}));
      }
    }
  }

  void check_side() const {
    if (sextuple_volume(polyhedron_) < 0) {
      throw BadInput("wrong-orientation", "the surface is inside out: its volume is negative",
                     "turn all faces: seen from outside every face runs counter-clockwise",
                     place(0, {}));
    }
  }

  const Polyhedron& polyhedron_;
  IntegerPoints integers_;
};

}  // namespace

void validate_faces(const Polyhedron& polyhedron) {
  const FloatEnvironment standard;
  const std::vector<Face>& faces = polyhedron.faces;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (const std::uint32_t v : faces[f]) {
      if (v >= polyhedron.vertices.size()) {
        throw BadInput("index-out-of-range",
                       "a face names vertex " + std::to_string(v) + ", and there are " +
                           std::to_string(polyhedron.vertices.size()) + " vertices",
                       "number the vertices from 0", place_in(polyhedron, f, {}));
      }
    }
    if (faces[f].size() < 3) {
      throw BadInput("too-few-vertices",
                     "a face has " + std::to_string(faces[f].size()) + " vertices",
                     "give at least three, or remove the face", place_in(polyhedron, f, faces[f]));
    }
  }
}

void validate_mesh(const Polyhedron& polyhedron) {
  const FloatEnvironment standard;
  PolyhedronValidator(polyhedron).run_on_mesh();
}

void validate(const Polyhedron& polyhedron) {
  const FloatEnvironment standard;
  PolyhedronValidator(polyhedron).run();
}

void validate_summand(const Polyhedron& polyhedron) {
  const FloatEnvironment standard;
  PolyhedronValidator validator(polyhedron);
  if (polyhedron.faces.size() == 1) return validator.run_on_polygon();
  validator.run();
}

}  // namespace minkref::inline space
