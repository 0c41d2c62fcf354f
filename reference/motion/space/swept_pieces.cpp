#include "reference/motion/space/swept_pieces.hpp"

#include <algorithm>

#include "reference/motion/space/open_pieces.hpp"

namespace minkref::inline space {
namespace {

Rational farthest_along(const SpacePoint& normal, const std::vector<SpacePoint>& corners) {
  Rational most = dot(normal, corners[0]);
  for (const SpacePoint& p : corners) most = std::max(most, dot(normal, p));
  return most;
}

/// Whether a point is below all planes, strictly or not.
bool is_below(const SpacePoint& point, const std::vector<HalfSpace>& planes, bool strict) {
  return std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
    const Rational height = dot(plane.normal, point);
    return strict ? height < plane.offset : height <= plane.offset;
  });
}

std::vector<std::vector<SpacePoint>> face_corners(const SolidPiece& piece) {
  if (piece.faces.empty()) return {piece.corners};
  std::vector<std::vector<SpacePoint>> faces;
  for (const Face& face : piece.faces) {
    std::vector<SpacePoint>& ring = faces.emplace_back();
    for (const std::uint32_t v : face) ring.push_back(piece.corners[v]);
  }
  return faces;
}

SpaceBox box_around(const std::vector<SpacePoint>& points) {
  SpaceBox box;
  for (const SpacePoint& p : points) {
    const NearVector<3> near = PathsInSpace::near(p);
    SpaceBox one;
    for (std::size_t k = 0; k < 3; ++k) {
      one.low[k] = near[k].lower();
      one.high[k] = near[k].upper();
    }
    box.add(one);
  }
  return box;
}

}  // namespace

SweptPieces::SweptPieces(const Polyhedron& part, const Polyhedron& obstacles,
                         const std::vector<SpacePoint>& path, ContactRule rule)
    : strict_(rule == ContactRule::allowed),
      part_(open_pieces(part, strict_ && is_thin(obstacles))),
      obstacles_(open_pieces(obstacles, strict_ && is_thin(part))) {
  for (const SolidPiece& piece : obstacles_) {
    auto& planes = planes_.emplace_back();
    for (std::size_t f = 0; f < piece.across.size(); ++f) {
      planes.push_back({piece.across[f], farthest_along(piece.across[f], piece.corners)});
    }
    faces_.push_back(face_corners(piece));
  }
  const std::size_t segments = std::max<std::size_t>(path.size(), 2) - 1;
  for (std::uint32_t segment = 0; segment < segments; ++segment) {
    const SpacePoint& from = path[segment];
    const SpacePoint along = path[std::min<std::size_t>(segment + 1, path.size() - 1)] - from;
    for (std::uint32_t r = 0; r < part_.size(); ++r) {
      const SolidPiece& piece = part_[r];
      Sweep sweep{segment, r, from, along, piece.across, piece.is_solid()};
      if (piece.faces.size() == 1 && dot(piece.across[0], along) != 0) sweep.is_solid = true;
      for (const SolidPiece::Edge& edge : piece.edges) {
        const SpacePoint n = cross(piece.corners[edge.to] - piece.corners[edge.from], along);
        if (is_zero(n)) continue;
        sweep.normals.push_back(n);
        sweep.normals.push_back(Rational(-1) * n);
      }
      sweeps_.push_back(std::move(sweep));
    }
  }
}

SweptPieces::Placed SweptPieces::placed(const Sweep& sweep, const Rational& scale) const {
  const SolidPiece& piece = part_[sweep.part];
  std::vector<SpacePoint> start, all;
  for (const SpacePoint& p : piece.corners) start.push_back(sweep.from + scale * p);
  all = start;
  for (const SpacePoint& p : start) all.push_back(p + sweep.along);
  Placed result;
  result.box = box_around(all);
  for (const Face& face : piece.faces) {
    std::vector<SpacePoint> at_start, at_end;
    for (const std::uint32_t v : face) {
      at_start.push_back(start[v]);
      at_end.push_back(start[v] + sweep.along);
    }
    result.faces.push_back(std::move(at_start));
    result.faces.push_back(std::move(at_end));
  }
  for (const SolidPiece::Edge& edge : piece.edges) {
    const SpacePoint &a = start[edge.from], &b = start[edge.to];
    result.faces.push_back({a, b, b + sweep.along, a + sweep.along});
  }
  if (piece.edges.empty()) result.faces.push_back({start[0], start[0] + sweep.along});
  if (sweep.is_solid) {
    for (const SpacePoint& n : sweep.normals) result.planes.push_back({n, farthest_along(n, all)});
  }
  return result;
}

bool SweptPieces::collides(const Sweep& sweep, const Placed& at, std::size_t obstacle) const {
  const SolidPiece& other = obstacles_[obstacle];
  if (!other.box.overlaps(at.box)) return false;
  const auto meets = [&](const auto& faces, const std::vector<HalfSpace>& planes) {
    return std::any_of(faces.begin(), faces.end(), [&](const std::vector<SpacePoint>& ring) {
      return strict_ ? is_strictly_below_somewhere(ring, planes) : !below_all(ring, planes).empty();
    });
  };
  if (!other.is_solid()) return meets(faces_[obstacle], at.planes);  // the sweep is solid
  if (meets(at.faces, planes_[obstacle])) return true;
  return sweep.is_solid &&
         is_below(strict_ ? other.middle() : other.corners[0], at.planes, strict_);
}

bool SweptPieces::collide(const Rational& scale) {
  for (const auto& [s, o] : likely_) {
    if (collides(sweeps_[s], placed(sweeps_[s], scale), o)) return true;
  }
  for (std::size_t s = 0; s < sweeps_.size(); ++s) {
    look_for_interrupt();
    const Placed at = placed(sweeps_[s], scale);
    for (std::size_t o = 0; o < obstacles_.size(); ++o) {
      if (!collides(sweeps_[s], at, o)) continue;
      constexpr std::size_t kept = 4;
      likely_.insert(likely_.begin(), {s, o});
      if (likely_.size() > kept) likely_.pop_back();
      return true;
    }
  }
  return false;
}

}  // namespace minkref::inline space
