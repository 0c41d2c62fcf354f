// The line where two convolution facets' planes cross, at all scales.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "reference/space/critical/moving_facet.hpp"

namespace minkref::inline space {

/// alpha s + beta t + gamma, of the point t of a crossing line at the scale s.
template <class T>
struct LineForm {
  T alpha, beta, gamma;
};

/// The points ((s A + B) foot + t along) / weight, weight > 0, from the first corner of the first
/// facet, which moves.
class CrossingLine {
 public:
  /// The facets must not be parallel; all arguments must outlive the line.
  CrossingLine(const MovingConvolution& convolution, const MovingFacet& first,
               const MovingFacet& second, SignCounts& signs);

  /// A point's distance beyond a facet's corner along a direction, times weight.
  LineForm<BoundedDouble> form(const BoundedVector& direction,
                               const ConvolutionFacet::Corner& corner) const;
  LineForm<Integer> form(const IntegerVector& direction, const ConvolutionFacet::Corner& corner);

  /// Exact.
  std::array<Rational, 3> point(const Rational& s, const Rational& t);

 private:
  template <class T>
  struct Parts {
    T A, B, weight;
    std::array<T, 3> along, foot;
  };
  template <class T>
  Parts<T> parts() const;
  template <class T>
  LineForm<T> form_of(const Parts<T>& parts, const std::array<T, 3>& direction,
                      const ConvolutionFacet::Corner& corner) const;
  const Parts<Integer>& exact();

  const MovingConvolution& convolution_;
  const MovingFacet &first_, &second_;
  std::size_t axis_;
  bool is_negative_;  ///< the cross product of the normals, along that axis
  Parts<BoundedDouble> rounded_;
  std::optional<Parts<Integer>> exact_;
};

/// How far a crossing line's points lie inside a facet's side, or above the facet's plane, up to a
/// positive factor. Rounded, with exact numbers on demand.
class ContactRow {
 public:
  static constexpr std::uint8_t plane = UINT8_MAX;

  ContactRow() = default;
  ContactRow(CrossingLine& line, const MovingFacet& facet, std::uint8_t side);
  /// alpha s + gamma, for integers.
  ContactRow(const Integer& alpha, const Integer& gamma);

  const LineForm<BoundedDouble>& rounded() const { return rounded_; }
  const LineForm<Integer>& exact();
  std::uint8_t side() const { return side_; }

 private:
  CrossingLine* line_ = nullptr;
  const MovingFacet* facet_ = nullptr;
  std::uint8_t side_ = plane;
  LineForm<BoundedDouble> rounded_;
  std::optional<LineForm<Integer>> exact_;
};

/// The sign of `evaluate` applied to the rows' forms. If doubles leave the sign open, `is_zero`
/// comes next: it may already know a zero.
template <class Known, class Evaluate, class... Rows>
int sign_unless_zero(SignCounts& signs, Known&& is_zero, Evaluate&& evaluate, Rows&... rows) {
  const int certain = evaluate(rows.rounded()...).certain_sign();
  if (certain != BoundedDouble::undecided) {
    ++signs.by_float;
    return certain;
  }
  if (is_zero()) return 0;
  ++signs.by_integer;
  return sign(evaluate(rows.exact()...));
}

template <class Evaluate, class... Rows>
int sign_of_rows(SignCounts& signs, Evaluate&& evaluate, Rows&... rows) {
  return sign_unless_zero(signs, [] { return false; }, evaluate, rows...);
}

/// The value alpha beta' - alpha' beta of two forms.
template <class T>
T turn_of(const LineForm<T>& f, const LineForm<T>& g) {
  return f.alpha * g.beta - g.alpha * f.beta;
}

/// The determinant of three forms: its sign times the sign of turn_of(f, g) is h's sign where f and
/// g vanish.
template <class T>
T determinant_of(const LineForm<T>& f, const LineForm<T>& g, const LineForm<T>& h) {
  return h.alpha * (f.beta * g.gamma - g.beta * f.gamma) +
         h.beta * (f.gamma * g.alpha - g.gamma * f.alpha) +
         h.gamma * (f.alpha * g.beta - g.alpha * f.beta);
}

}  // namespace minkref::inline space
