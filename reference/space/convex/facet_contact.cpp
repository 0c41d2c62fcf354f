#include "reference/space/convex/facet_contact.hpp"

#include <algorithm>

namespace minkref::inline space {
namespace {

/// Positive integers proportional to the weights, without a common divisor.
IntegerVector in_lowest_terms(const Scaling& weights) {
  using boost::multiprecision::denominator;
  using boost::multiprecision::numerator;
  Integer common = 1;
  for (const Rational& w : weights) common = lcm(common, Integer(denominator(w)));
  IntegerVector result;
  Integer divisor = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result[axis] = numerator(weights[axis]) * (common / denominator(weights[axis]));
    divisor = gcd(divisor, result[axis]);
  }
  for (Integer& w : result) w /= divisor;
  return result;
}

}  // namespace

RoundedScaling::RoundedScaling(const Scaling& scaling) : exact(scaling) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double factor = to_double(scaling[axis]);
    if (!(factor > 0x1p-100 && factor < 0x1p100)) {
      factors.reset();
      return;
    }
    (*factors)[axis] = factor;
  }
}

/// Only ratios matter: with the largest weight at 1 nothing overflows.
void FacetContact::rescale(const RoundedScaling& scaling) {
  scaling_ = scaling.exact;
  exact_weights_known_ = false;
  const std::optional<DoubleVector>& factors = scaling.factors;
  // Weight ratios exceed 2^-200 and coordinates 2^-201: terms exceed 2^-602.
  no_underflow_ = factors && normals_->moderate() && edges_->moderate();
  if (!factors) {
    const IntegerVector& exact = exact_weights();
    const Integer largest = *std::max_element(exact.begin(), exact.end());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      weights_[axis] = to_double(Rational(exact[axis], largest));
    }
    return;
  }
  const auto [least, most] = std::minmax_element(factors->begin(), factors->end());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double factor = (*factors)[axis];
    weights_[axis] = whose_ == Operand::normals_of_P ? *least / factor : factor / *most;
  }
}

const IntegerVector& FacetContact::exact_weights() const {
  if (!exact_weights_known_) {
    Scaling weights = scaling_;
    if (whose_ == Operand::normals_of_P) {
      for (Rational& w : weights) w = 1 / w;
    }
    exact_weights_ = in_lowest_terms(weights);
    exact_weights_known_ = true;
  }
  return exact_weights_;
}

int FacetContact::exact_sign(std::uint32_t facet, std::uint32_t half_edge) const {
  const IntegerVector& n = normals_->normal(facet);
  const IntegerVector& a = edges_->point(edges_->origin(half_edge));
  const IntegerVector& b = edges_->point(edges_->target(half_edge));
  Integer sum = 0;
  bool evaluated = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Edges that lie along a facet's plane for every scaling occur often; this test settles them.
    if (n[axis].is_zero() || a[axis] == b[axis]) continue;
    sum += n[axis] * exact_weights()[axis] * (b[axis] - a[axis]);
    evaluated = true;
  }
  exact_evaluations_ += evaluated ? 1 : 0;
  return sum.sign();
}

bool FacetContact::exact_rises(std::uint32_t facet, std::uint32_t half_edge) const {
  const int exact = exact_sign(facet, half_edge);
  if (exact != 0) return exact > 0;
  return tie_rises(normals_->normal(facet), edges_->vector(half_edge));
}

double drift(const RoundedScaling& from, const RoundedScaling& to) {
  if (!from.factors || !to.factors) return std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double change = std::log((*to.factors)[axis] / (*from.factors)[axis]);
    least = std::min(least, change);
    most = std::max(most, change);
  }
  // The logarithms lie within 2^8, and the ratios are off by 2^-51: an error below 2^-43.
  return (most - least) / 2 * (1 + 0x1p-40) + 0x1p-40;
}

}  // namespace minkref::inline space
