// sP + Q over a window of scales: built once, then any scale, and every event.
#pragma once

#include <optional>

#include "reference/plane/dynamic/dynamic_arrangement.hpp"
#include "reference/plane/history/topology_timeline.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

/// The dynamic sum of Behar & Lien 2012, Sec. 4.2.4.
class DynamicSum {
 public:
  /// Finds all events of a closed window of scales (open towards 0 or infinity without a bound).
  /// `of`: the convolution to follow. Collision detection tells the sum in the reduced
  /// convolution's arrangement, winding numbers in the full convolution's, whose operands with
  /// holes are cut (simply_connected.hpp). Throws BadInput for a bad window or operands. Cost:
  /// arrangement_timeline.
  DynamicSum(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
             ConvolutionType of = ConvolutionType::reduced);

  /// Whether an operand, and thus every sum, is empty.
  bool empty() const { return states_ == nullptr; }
  ConvolutionType followed() const { return of_; }
  const ScaleWindow& window() const { return window_; }
  const BoundaryStates& states() const { return *states_; }
  DynamicArrangement& arrangement() { return *arrangement_; }

  /// Moves to a scale of the window; throws BadInput ("outside-window") otherwise. Exact. O(events
  /// crossed).
  StepReport move_to(const Rational& scale);
  /// The sum at the current scale, as canonical form. Exact. O(b log b) for a boundary of b edges.
  Sum sum();

 private:
  ScaleWindow window_;
  ConvolutionType of_;
  std::shared_ptr<const BoundaryStates> states_;
  std::optional<DynamicArrangement> arrangement_;
};

}  // namespace minkref::inline plane
