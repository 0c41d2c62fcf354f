// The scales at which a polyhedron fits somewhere in a container, or is trapped among obstacles:
// all by translations alone (Behar & Lien 2012, Section 8.1).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reference/motion/space/valid_scales.hpp"

namespace minkref::inline space {

/// A contact keeping the part from growing, with its weight for the proof: the weighted face
/// normals sum to zero.
struct FitSupport {
  std::uint32_t vertex = 0;  ///< of the part
  std::uint32_t face = 0;    ///< of the container; its plane is touched
  Rational weight;           ///< of the plane n · x = d, n twice the area vector of the face
};

/// The cause that ends a range of scales. "contact": the part touches at a place, as `contact`
/// says; "death": the last free places vanish; "split": a way closes, and `at` is a place of the
/// part's origin on it, in contact on both sides.
struct SpaceFreeBound {
  Rational scale;
  bool ends = true;  ///< answers lie just below; otherwise just above
  std::string event;
  SpacePoint at;
  std::optional<SpacePathBound> contact;
};

struct SpaceFreeScales {
  std::vector<ScaleRange> scales;
  std::vector<SpaceFreeBound> bounds;  ///< ascending
  std::vector<FitSupport> supports;    ///< of a convex container
  std::vector<SweptProof> proofs;      ///< at, just below and just above bounds, found otherwise
  std::uint64_t critical_scales = 0;   ///< of events in the bracket
};

/// The scales at which the part lies inside the container (with contact forbidden: its interior) at
/// some place. A convex container takes parts of any shape, by a linear program: x + sR lies below
/// the plane n · y = d iff n · x + s h ≤ d, h being the greatest n · r, r in R. Any other container
/// takes a part whose every point is seen from some point strictly inside (`has_inner_centre`): its
/// smaller copies need strictly less room, so that the scales run from 0 to the event at which the
/// last cavity of the sum of the outside and -sR vanishes. Sums by definition bracket that event,
/// `critical_events_in_space` lists the bracket's events, and sums built from edges find the same
/// event again.
///
/// Exact. Throws BadInput as `refuse_bad_fit`, and "not-star-shaped" for other parts.
/// Linear program: O(f v) products for f faces and v vertices, and O(f) for each exchange. Else
/// some thirty sums, and the events of a bracket 2^-10 wide.
SpaceFreeScales scales_that_fit(const Polyhedron& part, const Polyhedron& container,
                                ContactRule rule = ContactRule::allowed);

/// The scales of the window at which the part may be at `at`, and no translation without collision
/// takes it to infinity. For a part that is strictly star-shaped about its origin: each face's
/// plane has the origin strictly below. Then a smaller part has strictly more room, a way with
/// contact at one scale is a way without contact at all smaller scales, and the part is trapped
/// from the event on at which the last way closes until it fits no more. At that event a part that
/// may touch still gets out. Exact. Throws BadInput: "bad-window", "not-star-shaped",
/// "degenerate-operands" for obstacles without volume. Cost as above.
SpaceFreeScales trapped_scales(const Polyhedron& part, const Polyhedron& obstacles,
                               const SpacePoint& at, ContactRule rule = ContactRule::allowed,
                               const ScaleWindow& window = {});

/// Whether some point strictly below all face planes exists, so that a smaller copy about this
/// point lies in the interior. Exact. A linear program.
bool has_inner_centre(const Polyhedron& part);

/// Whether a valid polyhedron is convex: no vertex is above a face's plane. Then each face supports
/// the hull, whose boundary holds the whole surface. Exact. O(f v).
bool is_convex(const Polyhedron& polyhedron);

}  // namespace minkref::inline space
