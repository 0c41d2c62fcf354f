#include "reference/space/convex/sum_coordinates.hpp"

#include <algorithm>

namespace minkref::inline space {
namespace {

__extension__ using Magnitude = unsigned __int128;

/// Along an axis a sum has the numerator `of_P` p + `of_Q` q over `denominator`.
struct AxisFactors {
  Integer of_P, of_Q, denominator;
};

AxisFactors axis_factors(const Rational& factor, const Integer& under_P, const Integer& under_Q) {
  const Integer above = numerator(factor), below = denominator(factor),
                common = lcm(under_P, under_Q);
  return {above * (common / under_P), below * (common / under_Q), below * common};
}

template <class Number>
Number narrowed(const Integer& value) {
  if constexpr (std::is_same_v<Number, Integer>) {
    return value;
  } else if constexpr (std::is_same_v<Number, std::int64_t>) {
    return static_cast<std::int64_t>(value);
  } else {
    const Integer magnitude = abs(value);
    const auto high = static_cast<std::uint64_t>(Integer(magnitude >> 64)),
               low = static_cast<std::uint64_t>(Integer(magnitude & UINT64_MAX));
    const auto wide = static_cast<Int128>(static_cast<Magnitude>(high) << 64 | low);
    return value < 0 ? -wide : wide;
  }
}

template <class Number>
using Row = std::array<Number, 3>;

template <class Number>
std::vector<Row<Number>> scaled_points(const ConvexPolyhedron& body,
                                       const std::array<Integer, 3>& factors) {
  const Row<Number> factor{narrowed<Number>(factors[0]), narrowed<Number>(factors[1]),
                           narrowed<Number>(factors[2])};
  std::vector<Row<Number>> result(body.vertices());
  for (std::uint32_t v = 0; v < body.vertices(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if constexpr (std::is_same_v<Number, Integer>) {
        result[v][axis] = body.point(v)[axis] * factor[axis];
      } else {
        result[v][axis] = factor[axis] * body.words()[v][axis];
      }
    }
  }
  return result;
}

template <class Number>
void add_pairs(const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
               const std::array<AxisFactors, 3>& factors, const SumVertices& vertices,
               Numerators& numerators) {
  const auto of_P = scaled_points<Number>(P, {factors[0].of_P, factors[1].of_P, factors[2].of_P});
  const auto of_Q = scaled_points<Number>(Q, {factors[0].of_Q, factors[1].of_Q, factors[2].of_Q});
  using List = std::vector<Row<Number>>;
  if (!std::holds_alternative<List>(numerators)) numerators = List();
  List& sums = std::get<List>(numerators);
  sums.resize(vertices.size());
  auto sum = sums.begin();
  vertices.for_each([&](std::uint32_t p, std::uint32_t q) {
    const Row<Number>&a = of_P[p], &b = of_Q[q];
    *sum++ = {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  });
}

}  // namespace

void sum_coordinates(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& scaling,
                     const SumVertices& vertices, HomogeneousPoints& points) {
  std::array<AxisFactors, 3> factors;
  long width = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    factors[axis] = axis_factors(scaling[axis], P.denominator(), Q.denominator());
    points.denominators[axis] = factors[axis].denominator;
    width = std::max({width, bits(factors[axis].of_P) + P.point_bits(),
                      bits(factors[axis].of_Q) + Q.point_bits()});
  }
  // Both terms lie below 2^width.
  const bool words = P.point_bits() < 64 && Q.point_bits() < 64;
  if (words && width <= 62) {
    add_pairs<std::int64_t>(P, Q, factors, vertices, points.numerators);
  } else if (words && width <= 126) {
    add_pairs<Int128>(P, Q, factors, vertices, points.numerators);
  } else {
    add_pairs<Integer>(P, Q, factors, vertices, points.numerators);
  }
}

std::optional<std::vector<WordVector>> in_words(const HomogeneousPoints& points) {
  const auto* words = std::get_if<std::vector<WordVector>>(&points.numerators);
  if (words == nullptr || !fit_in_words(*words)) return std::nullopt;
  return *words;
}

std::vector<IntegerVector> in_integers(const HomogeneousPoints& points) {
  std::vector<IntegerVector> result;
  result.reserve(count(points));
  std::visit(
      [&](const auto& rows) {
        for (const auto& row : rows) result.push_back(to_integers(row));
      },
      points.numerators);
  return result;
}

std::size_t count(const HomogeneousPoints& points) {
  return std::visit([](const auto& rows) { return rows.size(); }, points.numerators);
}

}  // namespace minkref::inline space
