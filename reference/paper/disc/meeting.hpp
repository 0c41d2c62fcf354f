// Scales at which two convolution features meet (Behar & Lien 2012, Appendix): common to all three
// kinds of pairs.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "reference/paper/disc/moving_feature.hpp"

namespace minkref::inline disc {

/// Two features, a crossing point (branch) of their lines or circles, and the closed range of
/// scales s > 0 with this point on both features; no bound: down to 0 or up to infinity.
template <class T>
struct Meeting {
  std::uint32_t a = 0, b = 0;
  std::int8_t branch = 0;   ///< on which side of the middle, or of the foot: 1, -1; 0 of two lines
  bool is_overlap = false;  ///< facing segments on one line
  std::optional<T> lower, upper;
};

namespace detail {

/// An event: an end of a feature comes to the other, or circles touch.
template <class T>
struct MeetingEvent {
  T scale;
  int branch = 0;  ///< 0: of both
  /// With the branch's sign, above 0 if the branch is on both features after the event, not before.
  int sense = 0;
  bool is_tangent = false;

  bool begins(int of_branch) const { return is_tangent || sense * of_branch > 0; }
};

/// Throws UndecidedSign for NaN and infinity, which cannot be compared.
template <class T>
void require_number(const T& scale) {
  if constexpr (!std::is_same_v<T, Surd>) sign(T(scale - scale));
}

/// A branch's scales from its events; none if the branch never begins. `from_zero`: a branch with
/// an end only exists from scale 0 on.
template <class T>
std::optional<Meeting<T>> meeting_of(const std::vector<MeetingEvent<T>>& events, int branch,
                                     bool from_zero) {
  Meeting<T> found;
  found.branch = static_cast<std::int8_t>(branch);
  for (const MeetingEvent<T>& event : events) {
    require_number(event.scale);
    if (event.branch == -branch && branch != 0) continue;
    const bool begins = event.begins(branch == 0 ? 1 : branch);
    auto& bound = begins ? found.lower : found.upper;
    const int order = bound ? order_of(event.scale, *bound) : 0;
    if (!bound || (begins ? order > 0 : order < 0)) bound = event.scale;
  }
  if (!found.lower && !(from_zero && found.upper)) return std::nullopt;
  if (found.lower && found.upper && order_of(*found.lower, *found.upper) > 0) return std::nullopt;
  return found;
}

/// Whether a point on a feature's line or circle lies on the feature.
template <class T>
bool is_on(const MovingFeature<T>& feature, const Vector<T>& x) {
  if (feature.is_arc) return is_in_arc(feature, Vector<T>(x - feature.centre()));
  const T part = part_along(feature, x);
  return sign(part) >= 0 && sign(T(part - T(1))) <= 0;
}

template <class T>
bool are_equal(const Vector<T>& x, const Vector<T>& y) {
  return order_of(x.x, y.x) == 0 && order_of(x.y, y.y) == 0;
}

/// The root; 0 if rounding made the number negative.
template <class T>
T root_or_zero(const T& value) {
  return sign(value) <= 0 ? T(0) : root_of(value);
}

}  // namespace detail
}  // namespace minkref::inline disc
