#include "reference/space/definition/convex_pieces.hpp"

#include <algorithm>
#include <utility>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/space/definition/convex_cell.hpp"
#include "reference/space/definition/face_walls.hpp"
#include "reference/space/definition/merged_pieces.hpp"

namespace minkref::inline space {
namespace {

constexpr std::size_t most_cells = 10 * most_convex_pieces;
constexpr std::size_t most_cuts_tried = 48;  // of those that a cell could be cut by

[[noreturn]] void refuse_crossing_faces() {
  throw BadInput(
      "crossing-faces",
      "faces of the surface cross or cover each other: it is not the boundary of a solid",
      "give the boundary of the solid only");
}

/// Summed two by two, so that only the last sums have long denominators.
Rational sextuple_volume_of_all(const std::vector<Polyhedron>& pieces) {
  std::vector<Rational> volumes;
  for (const Polyhedron& piece : pieces) volumes.push_back(sextuple_volume(piece));
  while (volumes.size() > 1) {
    std::vector<Rational> sums;
    for (std::size_t k = 0; k < volumes.size(); k += 2) {
      look_for_interrupt();
      sums.push_back(k + 1 < volumes.size() ? volumes[k] + volumes[k + 1] : volumes[k]);
    }
    volumes = std::move(sums);
  }
  return volumes.empty() ? Rational(0) : volumes[0];
}

/// The remaining surface inside a convex cell, the part of space below the cell's cuts.
struct SurfaceCell {
  std::vector<Wall> walls;
  std::vector<std::uint32_t> cuts;
};

/// How many walls lie within a plane, and how many the plane splits.
struct CutCounts {
  std::size_t within = 0, split = 0;
  /// The cut's change to the wall count.
  std::ptrdiff_t growth() const {
    return static_cast<std::ptrdiff_t>(split) - static_cast<std::ptrdiff_t>(within);
  }
};

class SolidPartition {
 public:
  explicit SolidPartition(const Polyhedron& surface)
      : whole_(surface.vertices), walls_(face_walls(surface)) {
    cells_.push_back({std::move(walls_.walls), {}});
  }

  std::vector<Polyhedron> pieces() {
    std::size_t count = 0;
    while (!cells_.empty()) {
      if (++count > most_cells || pieces_.size() > most_convex_pieces) {
        throw LimitExceeded("too-many-pieces",
                            "the polyhedron does not fall into " +
                                std::to_string(most_convex_pieces) + " convex pieces",
                            "give a polyhedron with fewer reflex edges, or take the route edges");
      }
      SurfaceCell cell = std::move(cells_.back());
      cells_.pop_back();
      while (peel(cell)) {
      }
      if (cell.walls.empty()) {
        keep(cell.cuts);
      } else {
        split(cell);
      }
    }
    return std::move(pieces_);
  }

 private:
  static std::vector<std::uint32_t> planes_of(const SurfaceCell& cell) {
    std::vector<std::uint32_t> planes;
    for (const Wall& wall : cell.walls) planes.push_back(wall.cut);
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    return planes;
  }

  /// Whether no wall reaches above the plane, so that no part of the solid lies there.
  bool has_all_below(std::uint32_t cut, const SurfaceCell& cell) const {
    const CuttingPlane& plane = walls_.planes[cut];
    return std::all_of(cell.walls.begin(), cell.walls.end(), [&](const Wall& wall) {
      if (wall.cut / 2 == cut / 2) return wall.cut == cut;
      return std::none_of(wall.ring.begin(), wall.ring.end(),
                          [&](const SolidCorner& corner) { return plane.side(corner) > 0; });
    });
  }

  /// Cuts the cell by all planes with nothing of the solid above. Returns whether one was found.
  bool peel(SurfaceCell& cell) const {
    std::vector<std::uint32_t> done;
    for (const std::uint32_t cut : planes_of(cell)) {
      look_for_interrupt();
      if (has_all_below(cut, cell)) done.push_back(cut);
    }
    std::erase_if(cell.walls, [&](const Wall& wall) {
      return std::binary_search(done.begin(), done.end(), wall.cut);
    });
    cell.cuts.insert(cell.cuts.end(), done.begin(), done.end());
    return !done.empty();
  }

  CutCounts counts(std::uint32_t cut, const SurfaceCell& cell) const {
    CutCounts result;
    for (const Wall& wall : cell.walls) {
      if (wall.cut / 2 == cut / 2) {
        ++result.within;
        continue;
      }
      const RingSides sides = sides_of(wall.ring, walls_.planes[cut]);
      if (sides.above && sides.below) ++result.split;
    }
    return result;
  }

  std::uint32_t best_cut(const SurfaceCell& cell) const {
    const std::vector<std::uint32_t> planes = planes_of(cell);
    const std::size_t step = (planes.size() + most_cuts_tried - 1) / most_cuts_tried;
    std::uint32_t best = planes[0];
    std::ptrdiff_t least = 0;
    for (std::size_t k = 0; k < planes.size(); k += step) {
      look_for_interrupt();
      const std::ptrdiff_t growth = counts(planes[k], cell).growth();
      if (k > 0 && growth >= least) continue;
      best = planes[k];
      least = growth;
    }
    return best;
  }

  void split(SurfaceCell& cell) {
    const std::uint32_t cut = best_cut(cell) & ~1U;
    const CuttingPlane& plane = walls_.planes[cut];
    SurfaceCell below{{}, cell.cuts}, above{{}, std::move(cell.cuts)};
    below.cuts.push_back(cut);
    above.cuts.push_back(cut + 1);
    bool solid_below = false, solid_above = false;
    for (Wall& wall : cell.walls) {
      look_for_interrupt();
      if (wall.cut / 2 == cut / 2) {
        (wall.cut == cut ? solid_below : solid_above) = true;
        continue;
      }
      const RingSides sides = sides_of(wall.ring, plane);
      if (sides.above && sides.below) {
        auto [lower, upper] = halves(wall.ring, sides, plane);
        below.walls.push_back({wall.cut, std::move(lower)});
        above.walls.push_back({wall.cut, std::move(upper)});
      } else {
        (sides.above ? above : below).walls.push_back(std::move(wall));
      }
    }
    add(std::move(below), solid_below, solid_above);
    add(std::move(above), solid_above, solid_below);
  }

  /// Adds a cell; one without any surface left is inside or outside as the walls in the plane that
  /// made the cell say.
  void add(SurfaceCell cell, bool inside, bool outside) {
    if (!cell.walls.empty()) {
      cells_.push_back(std::move(cell));
      return;
    }
    if (inside && outside) {
      refuse_crossing_faces();
    }
    if (inside) keep(cell.cuts);
  }

  void keep(const std::vector<std::uint32_t>& cuts) {
    ConvexCell cell = whole_;
    for (const std::uint32_t cut : cuts) {
      look_for_interrupt();
      cell.cut(walls_.planes[cut]);
    }
    pieces_.push_back(cell.surface());
  }

  ConvexCell whole_;
  FaceWalls walls_;
  std::vector<SurfaceCell> cells_;
  std::vector<Polyhedron> pieces_;
};

}  // namespace

std::vector<Polyhedron> convex_pieces(const Polyhedron& surface) {
  if (surface.empty()) return {};
  if (!surface.is_solid()) return {surface};
  std::vector<Polyhedron> pieces = SolidPartition(surface).pieces();
  if (sextuple_volume_of_all(pieces) != sextuple_volume(surface)) refuse_crossing_faces();
  return merged_pieces(pieces);
}

}  // namespace minkref::inline space
