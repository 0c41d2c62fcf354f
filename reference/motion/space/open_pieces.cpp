#include "reference/motion/space/open_pieces.hpp"

#include <stdexcept>

#include "reference/space/definition/convex_pieces.hpp"
#include "reference/space/definition/seam_covers.hpp"
#include "reference/space/face_triangles.hpp"

namespace minkref::inline space {

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
  const std::vector<Polyhedron> convex = convex_pieces(operand);
  for (const Polyhedron& piece : convex) pieces.emplace_back(piece);
  if (!open) return pieces;
  for (const Polyhedron& cover : seam_covers(operand, convex)) pieces.emplace_back(cover);
  return pieces;
}

}  // namespace minkref::inline space
