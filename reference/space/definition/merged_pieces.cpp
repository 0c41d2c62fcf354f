#include "reference/space/definition/merged_pieces.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/space/definition/convex_cell.hpp"
#include "reference/space/definition/face_walls.hpp"

namespace minkref::inline space {
namespace {

/// The points below all planes: the corners' hull; some corners may lie inside faces.
struct MergedPiece {
  std::vector<CuttingPlane> planes;
  std::vector<SolidCorner> corners;
  std::size_t parts = 1;  ///< none: it is part of another one

  explicit MergedPiece(const Polyhedron& piece) {
    const FaceWalls faces = face_walls(piece);
    for (const Wall& wall : faces.walls) planes.push_back(faces.planes[wall.cut]);
    for (const SpacePoint& vertex : piece.vertices) corners.push_back(solid_corner(vertex));
  }

  /// Whether all corners lie below the other piece's planes, except plane `aside`.
  bool within(const MergedPiece& other, std::size_t aside) const {
    for (std::size_t k = 0; k < other.planes.size(); ++k) {
      if (k == aside) continue;
      for (const SolidCorner& corner : corners) {
        if (other.planes[k].side(corner) > 0) return false;
      }
    }
    return true;
  }
};

class PieceMerger {
 public:
  explicit PieceMerger(const std::vector<Polyhedron>& pieces) : given_(pieces) {
    for (const Polyhedron& piece : pieces) {
      look_for_interrupt();
      const auto number = static_cast<std::uint32_t>(pieces_.size());
      pieces_.emplace_back(piece);
      for (const CuttingPlane& plane : pieces_.back().planes) at_[plane.plane()].push_back(number);
    }
  }

  std::vector<Polyhedron> merged() {
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      while (pieces_[i].parts > 0 && grow(i)) {
      }
    }
    std::vector<Polyhedron> result;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      look_for_interrupt();
      const MergedPiece& piece = pieces_[i];
      if (piece.parts == 1) result.push_back(given_[i]);
      if (piece.parts > 1) result.push_back(surface_of_piece(piece));
    }
    return result;
  }

 private:
  /// Joins a neighbour to the piece, if one fits.
  bool grow(std::uint32_t i) {
    for (std::size_t k = 0; k < pieces_[i].planes.size(); ++k) {
      const auto beyond = at_.find(reversed(pieces_[i].planes[k].plane()));
      if (beyond == at_.end()) continue;
      for (const std::uint32_t j : beyond->second) {
        look_for_interrupt();
        if (j == i || pieces_[j].parts == 0) continue;
        const std::size_t back = place_of_plane(pieces_[j], beyond->first);
        if (back == pieces_[j].planes.size()) continue;
        if (!pieces_[i].within(pieces_[j], back)) continue;
        if (!pieces_[j].within(pieces_[i], k)) continue;
        join(i, k, j, back);
        return true;
      }
    }
    return false;
  }

  static std::size_t place_of_plane(const MergedPiece& piece, const OrientedPlane& plane) {
    std::size_t k = 0;
    while (k < piece.planes.size() && piece.planes[k].plane() != plane) ++k;
    return k;
  }

  void join(std::uint32_t i, std::size_t k, std::uint32_t j, std::size_t back) {
    MergedPiece &piece = pieces_[i], &other = pieces_[j];
    piece.planes.erase(piece.planes.begin() + static_cast<std::ptrdiff_t>(k));
    for (std::size_t m = 0; m < other.planes.size(); ++m) {
      const OrientedPlane& plane = other.planes[m].plane();
      if (m == back || place_of_plane(piece, plane) < piece.planes.size()) continue;
      piece.planes.push_back(other.planes[m]);
      at_[plane].push_back(i);
    }
    piece.corners.insert(piece.corners.end(), other.corners.begin(), other.corners.end());
    piece.parts += other.parts;
    other.parts = 0;
  }

  static Polyhedron surface_of_piece(const MergedPiece& piece) {
    std::vector<SpacePoint> points;
    for (const SolidCorner& corner : piece.corners) points.push_back(exact_point(corner));
    ConvexCell cell(points);
    for (const CuttingPlane& plane : piece.planes) cell.cut(plane);
    return cell.surface();
  }

  const std::vector<Polyhedron>& given_;
  std::vector<MergedPiece> pieces_;
  std::map<OrientedPlane, std::vector<std::uint32_t>> at_;  ///< perhaps pieces that had it once
};

}  // namespace

std::vector<Polyhedron> merged_pieces(const std::vector<Polyhedron>& pieces) {
  return PieceMerger(pieces).merged();
}

}  // namespace minkref::inline space
