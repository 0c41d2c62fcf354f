// At which scales a part fits into a container, passes from one place in it to another, or is
// trapped: all by translations alone (Behar & Lien 2012, Section 8.1).
#pragma once

#include <string>

#include "reference/motion/valid_scales.hpp"

namespace minkref::inline paths {

/// The cause that ends a range of scales: "contact" (the part touches at a place that was asked
/// for, as `contact` says), or a change at the place `at` of a hole of the sum of the obstacles and
/// the turned part: "birth", "death", "merge", "split", "touch".
struct FreeBound {
  Rational scale;
  bool ends = true;  ///< scales of the answer lie just below; otherwise just above, or it is alone
  std::string event;
  Point at;
  std::optional<PathBound> contact;
};

/// A scale at which the answer was found again by a static sum.
struct StaticProof {
  Rational scale;
  bool holds = false;
};

struct FreeScales {
  std::vector<ScaleRange> scales;
  std::vector<FreeBound> bounds;    ///< ascending
  std::vector<StaticProof> proofs;  ///< at each bound, just below and just above it
  std::uint64_t critical_scales = 0;
};

/// How the scales are found at which the answer may change. `narrowed`: where the part has a point
/// that sees all of it (for a trap and a way between places: that is its origin), what is asked
/// holds up to some scale and no more above it. Sums at single scales bracket that scale, and the
/// index is that of the bracket alone. `all`: of all scales, whatever the part.
enum class FitSearch : std::uint8_t { narrowed, all };

/// The scales at which the part may be at `at`, and no translation along which it does not collide
/// takes it to infinity: its place lies in a bounded component of the free places (FreeSpace). A
/// rotation may still free it. Critical scales are those of holes in the index, those at which the
/// place starts or stops to be free, and where contact is allowed all at which three contacts meet
/// in a free place. Exact. Throws BadInput as valid_scales, and "touching-rings" where contact is
/// allowed and rings of a set touch.
FreeScales trapped_scales(const PolygonSet& part, const PolygonSet& assembly, const Point& at,
                          ContactRule rule = ContactRule::allowed, const ScaleWindow& window = {},
                          FitSearch search = FitSearch::narrowed);

/// The scales at which the part lies in the container (with contact forbidden in its interior): at
/// a place, at some place, or at two places and all along some way from one to the other. Throws
/// BadInput as above, and "point-part" where the part is a point.
FreeScales scales_that_fit_at(const PolygonSet& part, const PolygonSet& container, const Point& at,
                              ContactRule rule = ContactRule::allowed);
FreeScales scales_that_fit(const PolygonSet& part, const PolygonSet& container,
                           ContactRule rule = ContactRule::allowed,
                           FitSearch search = FitSearch::narrowed);
FreeScales scales_that_pass(const PolygonSet& part, const PolygonSet& container, const Point& from,
                            const Point& to, ContactRule rule = ContactRule::allowed,
                            FitSearch search = FitSearch::narrowed);

}  // namespace minkref::inline paths
