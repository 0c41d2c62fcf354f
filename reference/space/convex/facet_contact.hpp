// The predicate of Sec. 6: does an edge of one polyhedron rise above the other polyhedron's facet?
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "reference/space/convex/convex_polyhedron.hpp"

namespace minkref::inline space {

/// A scaling, and the nearest doubles if all three lie well within their range.
struct RoundedScaling {
  Scaling exact{1, 1, 1};
  std::optional<DoubleVector> factors = DoubleVector{1, 1, 1};

  RoundedScaling() = default;
  explicit RoundedScaling(const Scaling& scaling);
};

/// The signs of n' · d for one polyhedron's facet normals n and the other's edge vectors d, where
/// n' is n with every coordinate times a positive weight. With the weights 1/s_i the normals belong
/// to S P and the edges to Q; with the weights s_i the normals belong to Q, and n' · d is the
/// product with an edge of S P (docs/convex-polyhedra.md).
///
/// `rises` never ties: for n' · d = 0 the answer moves P by the linear map I + E, where E is a
/// matrix of nine infinitesimals, each far smaller than the one before and all of one order: S P is
/// then generic for every S, and all signs belong to one and the same P. To first order n' · d
/// changes by ± the sum of n_i E_ij d_j.
class FacetContact {
 public:
  enum class Operand : std::uint8_t { normals_of_P, normals_of_Q };

  FacetContact(const ConvexPolyhedron& normals, const ConvexPolyhedron& edges, Operand whose)
      : normals_(&normals), edges_(&edges), whose_(whose) {}

  void rescale(const RoundedScaling& scaling);

  /// A facet whose normal is weighted once for several edges.
  struct Weighted {
    std::uint32_t facet;
    DoubleVector normal;
  };
  Weighted weighted(std::uint32_t facet) const {
    const DoubleVector& n = normals_->rounded_normal(facet);
    return {facet, {n[0] * weights_[0], n[1] * weights_[1], n[2] * weights_[2]}};
  }

  bool rises(const Weighted& facet, std::uint32_t half_edge) const {
    return rises(facet, half_edge, approximate(facet, half_edge));
  }
  bool rises(std::uint32_t facet, std::uint32_t half_edge) const {
    return rises(weighted(facet), half_edge);
  }

  /// n' · d in doubles, and the sum of its terms' three magnitudes. The value's error stays below
  /// 16 roundings of the sum and, if terms underflow, below 2^-1000.
  struct Product {
    double value, magnitude;
    bool certain() const {
      return std::fabs(value) >
             magnitude * (16 * std::numeric_limits<double>::epsilon()) + 0x1p-1000;
    }
  };
  /// The least of the ratios |value| / magnitude of some products: how far the weights may change
  /// with all their signs kept.
  class Slack {
   public:
    explicit Slack(const FacetContact& contact) : zeros_stay_(contact.no_underflow_) {}
    void include(const Product& product) {
      // A zero sum of magnitudes means that every term vanishes for all weights.
      const bool stays = product.magnitude == 0 && zeros_stay_;
      // From this magnitude on, the products below do not underflow, but for ratios below 2^-200.
      const bool tiny = product.magnitude < 0x1p-400;
      const double value = tiny ? 0 : std::fabs(product.value);
      const double magnitude = tiny ? 1 : product.magnitude;
      const bool less = !stays && value * magnitude_ <= value_ * magnitude;
      value_ = less ? value : value_;
      magnitude_ = less ? magnitude : magnitude_;
    }
    /// How far the scaling may drift (see `drift`) with all signs certainly kept.
    double drift() const {
      const double ratio = value_ / (magnitude_ + 0x1p-900) * (1 - 0x1p-40) - 0x1p-40;
      return ratio > 0 ? ratio * (1 - ratio / 2) : 0;  // below log(1 + ratio)
    }

   private:
    double value_ = 1, magnitude_ = 1;  // no ratio is greater
    bool zeros_stay_;
  };
  Product approximate(const Weighted& facet, std::uint32_t half_edge) const {
    ++evaluations_;
    const DoubleVector& d = edges_->rounded_vector(half_edge);
    const double x = facet.normal[0] * d[0], y = facet.normal[1] * d[1], z = facet.normal[2] * d[2];
    return {x + y + z, std::fabs(x) + std::fabs(y) + std::fabs(z)};
  }

  /// The same for a product already computed.
  bool rises(const Weighted& facet, std::uint32_t half_edge, const Product& product) const {
    if (product.certain()) return product.value > 0;
    if (product.magnitude == 0 && no_underflow_) {
      return tie_rises(facet.normal, edges_->rounded_vector(half_edge));
    }
    return exact_rises(facet.facet, half_edge);
  }

  const ConvexPolyhedron& normals() const { return *normals_; }
  const ConvexPolyhedron& edges() const { return *edges_; }

  /// Signs requested since construction, and how many doubles left open.
  std::uint64_t evaluations() const { return evaluations_; }
  std::uint64_t exact_evaluations() const { return exact_evaluations_; }

 private:
  /// The sign to first order for n' · d = 0: from the first nonzero n_i d_j.
  template <class Vector>
  bool tie_rises(const Vector& normal, const Vector& edge) const {
    for (const auto& across : normal) {
      for (const auto& along : edge) {
        if (across == 0 || along == 0) continue;
        return ((across > 0) == (along > 0)) == (whose_ == Operand::normals_of_Q);
      }
    }
    return false;  // neither vector is zero
  }
  const IntegerVector& exact_weights() const;
  int exact_sign(std::uint32_t facet, std::uint32_t half_edge) const;
  bool exact_rises(std::uint32_t facet, std::uint32_t half_edge) const;

  const ConvexPolyhedron* normals_;
  const ConvexPolyhedron* edges_;
  Operand whose_;
  Scaling scaling_{1, 1, 1};
  mutable IntegerVector exact_weights_{1, 1, 1};
  bool no_underflow_ = true;  // a term of a product in doubles is zero only where the exact one is
  mutable bool exact_weights_known_ = true;  // made when a sign first asks for them
  DoubleVector weights_{1, 1, 1};
  mutable std::uint64_t evaluations_ = 0, exact_evaluations_ = 0;
};

/// Half the spread of the logarithms of the factors by which weights changed, rounded up: a factor
/// common to all axes changes no sign. The same for the weights s_i and 1/s_i. Infinite if a factor
/// lies beyond 2^±100.
double drift(const RoundedScaling& from, const RoundedScaling& to);

}  // namespace minkref::inline space
