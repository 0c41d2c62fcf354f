// The scales at which a part fits into a container, passes from one of its places to another, or is
// trapped: all by translations alone (Behar & Lien 2012, Section 8.1).
#pragma once

#include <string>

#include "reference/motion/valid_scales.hpp"

namespace minkref::inline motion {

/// The cause that ends a range of scales: "contact" (the part touches at a place that was asked
/// for, as `contact` says), or a change at the place `at` of a hole of the sum of the obstacles and
/// the turned part: "birth", "death", "merge", "split", "touch".
struct FreeBound {
  Rational scale;
  bool ends = true;  ///< answers lie just below; otherwise just above, or only at this scale
  std::string event;
  Point at;
  std::optional<PathBound> contact;
};

/// A scale at which a static sum confirmed the answer.
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

/// The search for the scales at which the answer may change. `narrowed`: if some point of the part
/// sees the whole part (for a trap and a way between places: the origin has to), the question holds
/// up to some scale and never above. Sums at single scales bracket this scale, and the index covers
/// the bracket alone. `all`: the index covers all scales, whatever the part.
enum class FitSearch : std::uint8_t { narrowed, all };

/// The scales at which the part may be at `at`, and no translation without collision takes it to
/// infinity: its place lies within a bounded component of the free places (FreeSpace). A rotation
/// may still free it. Critical scales come from holes of the index, from the start or stop of the
/// place's freedom, and, if contact is allowed, from three contacts that meet at a free place.
/// Exact. Throws BadInput as valid_scales, and "touching-rings" if contact is allowed and rings of
/// a set touch.
FreeScales trapped_scales(const PolygonSet& part, const PolygonSet& obstacles, const Point& at,
                          ContactRule rule = ContactRule::allowed, const ScaleWindow& window = {},
                          FitSearch search = FitSearch::narrowed);

/// The scales at which the part lies inside the container (with contact forbidden: its interior):
/// at a place, at some place, or at two places and along some whole way between the two. Throws
/// BadInput as above, and "point-part" if the part is a point.
FreeScales scales_that_fit_at(const PolygonSet& part, const PolygonSet& container, const Point& at,
                              ContactRule rule = ContactRule::allowed);
FreeScales scales_that_fit(const PolygonSet& part, const PolygonSet& container,
                           ContactRule rule = ContactRule::allowed,
                           FitSearch search = FitSearch::narrowed);
FreeScales scales_that_pass(const PolygonSet& part, const PolygonSet& container, const Point& from,
                            const Point& to, ContactRule rule = ContactRule::allowed,
                            FitSearch search = FitSearch::narrowed);

}  // namespace minkref::inline motion
