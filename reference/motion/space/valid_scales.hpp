// For which scales a polyhedron passes along a path in space (Behar & Lien 2012, Section 8.1).
#pragma once

#include "reference/motion/valid_scales.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

using SpacePathPlace = PathPlaceOf<SpacePoint>;

/// A polyhedron's touching feature: a vertex (`first`), the edge between two vertices (`first`
/// below `second`), or the inside of a face (`first` is the face's index).
struct SpaceFeature {
  enum class Kind : std::uint8_t { vertex, edge, face };
  Kind kind = Kind::vertex;
  std::uint32_t first = 0, second = 0;
  friend bool operator==(const SpaceFeature&, const SpaceFeature&) = default;
};

using SpacePathBound = PathBoundOf<SpacePoint, SpaceFeature>;
using SpaceValidScales = ValidScalesOf<SpacePathBound>;

/// As for the plane: the scales s of the window at which the part s R, carried along the polyline
/// with its origin on it and never turned, does not meet the obstacles; with contact allowed only
/// interiors count. Polyhedra of any shape; either operand may be a point, a segment or a plane
/// polygon, which counts without its border. Exact: a union of intervals, single scales included.
/// Both must have passed `validate_summand`. Throws BadInput ("bad-path", "bad-window",
/// "degenerate-operands" if both lack volume; "no-route" for `index`, a route of the plane only),
/// and as convex_pieces does. For a and b convex pieces and k segments O(k a b) doubles, memory O(k
/// (a + b)); beside them some ten planes for each piece.
SpaceValidScales valid_scales(const Polyhedron& part, const Polyhedron& obstacles,
                              const std::vector<SpacePoint>& path,
                              ContactRule rule = ContactRule::allowed,
                              const ScaleWindow& window = {}, PathRoute route = PathRoute::pieces);

/// The first place along the path where the part collides at each scale, or the limit of such
/// places, and the contact there. Requires operands as above, not empty, a path that is not valid
/// at any of the scales, and a free first place. Exact.
std::vector<SpacePathBound> stops_of(const Polyhedron& part, const Polyhedron& obstacles,
                                     const std::vector<SpacePoint>& path, ContactRule rule,
                                     const std::vector<Rational>& scales);

/// The most pairs of pieces, or of a piece and a path vertex; some 300 bytes each.
constexpr std::size_t most_pairs_on_a_path = std::size_t{1} << 22;

/// Whether the segment from each point of the part to the origin lies inside the part. Exact.
/// Linear.
bool star_shaped(const Polyhedron& part);

/// A scale at which the sweeps of the pieces confirmed the answer (swept_pieces.hpp).
struct SweptProof {
  Rational scale;
  bool holds = false;
};

struct SpaceFit {
  SpaceValidScales scales;         ///< `obstacle` is of the container
  std::vector<SweptProof> proofs;  ///< at each bound, just below and just above it
};

/// The scales at which the part, with its origin at a place, lies inside the container, a solid
/// (with contact forbidden: its interior). Exact. Throws BadInput as valid_scales, and "point-part"
/// if the part is a point, "degenerate-operands" if the container has no volume.
SpaceFit scales_that_fit_at(const Polyhedron& part, const Polyhedron& container,
                            const SpacePoint& at, ContactRule rule = ContactRule::allowed);

}  // namespace minkref::inline space
