#include "reference/plane/dynamic/dynamic_sum.hpp"

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace minkref::inline plane {

DynamicSum::DynamicSum(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                       ConvolutionType of)
    : window_(window), of_(of) {
  const FloatEnvironment standard;
  refuse_bad_operands(P, Q, 1);
  refuse_bad_window(window);
  if (P.empty() || Q.empty()) return;
  states_ = std::make_shared<const BoundaryStates>(
      arrangement_timeline(followed_operand(P, of), followed_operand(Q, of), opened(window), of));
  arrangement_.emplace(states_);
}

StepReport DynamicSum::move_to(const Rational& scale) {
  const FloatEnvironment standard;
  if (sign(scale) <= 0 || (window_.from && scale < *window_.from) ||
      (window_.to && scale > *window_.to)) {
    throw BadInput("outside-window", "the scale " + to_string(scale) + " is outside the window",
                   "give a scale within it, or a wider window");
  }
  return empty() ? StepReport{} : arrangement_->move_to(scale);
}

Sum DynamicSum::sum() {
  const FloatEnvironment standard;
  Sum sum;
  if (empty()) return sum;
  Canonical canonical = canonical_form(arrangement_->boundary());
  sum.region = std::move(canonical.region);
  sum.components = canonical.components;
  sum.holes = canonical.holes;
  const PairEvents& pairs = states_->timeline().events->pairs();
  sum.statistics.kernel = pairs.statistics.kernel;
  sum.statistics.s_edges = pairs.statistics.s_edges;
  sum.statistics.t_edges = pairs.statistics.t_edges;
  sum.statistics.nodes = arrangement_->node_count();
  return sum;
}

}  // namespace minkref::inline plane
