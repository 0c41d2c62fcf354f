#include "reference/space/vertex_signs.hpp"

#include <algorithm>
#include <cmath>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

constexpr long most_bits_in_units = 300;
/// Above this value, losses of products below the doubles' range do not count: with a factor of
/// 2^300 less than 2^-760.
constexpr double least_settled = 0x1p-700;

using RoundedDifference = std::array<double, 3>;

double longest_difference(const RoundedDifference& a) {
  return std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
}

}  // namespace

VertexSigns::VertexSigns(const std::vector<IntegerVector>& points)
    : points_(points), words_(in_words(points)) {
  for (const IntegerVector& p : points) {
    for (const Integer& c : p) exponent_ = std::max(exponent_, bits(c) - most_bits_in_units);
  }
  double most = 0;
  boxes_.reserve(points.size());
  for (const IntegerVector& p : points) {
    look_for_interrupt();
    SpaceBox& box = boxes_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = enclosed(p[k]);
      box.low[k] = low;
      box.high[k] = high;
      most = std::max({most, std::fabs(low), std::fabs(high)});
    }
  }
  // A lower bound lies at most 2^-52 of the magnitude below its coordinate; the difference of two
  // bounds is rounded once more, by at most 2^-53 of twice the magnitude.
  doubt_ = 0x1p-50 * most;
}

std::array<double, 2> VertexSigns::enclosed(const Integer& x, const Integer& over) const {
  const Enclosure bounds = enclose(Rational(x, over << static_cast<unsigned long>(exponent_)));
  return {bounds.lower, bounds.upper};
}

int VertexSigns::orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                             std::uint32_t d) const {
  if (a == b || a == c || a == d || b == c || b == d || c == d) return 0;
  if (words_) {
    const std::vector<WordVector>& p = *words_;
    return dot_sign(cross(p[b] - p[a], p[c] - p[a]), p[d] - p[a]);
  }
  const auto difference = [&](std::uint32_t v) {
    const auto &to = boxes_[v].low, &from = boxes_[a].low;
    return RoundedDifference{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  };
  const RoundedDifference x = difference(b), y = difference(c), z = difference(d);
  const double value = (x[1] * y[2] - x[2] * y[1]) * z[0] + (x[2] * y[0] - x[0] * y[2]) * z[1] +
                       (x[0] * y[1] - x[1] * y[0]) * z[2];
  // Six products of three differences, each at most `most` long and wrong by the doubt: together
  // wrong by 6 ((most + doubt)^3 - most^3) <= 42 most^2 doubt; and each rounded at most five times.
  const double most =
      std::max({longest_difference(x), longest_difference(y), longest_difference(z), doubt_});
  const double bound = 64 * most * most * (doubt_ + 0x1p-53 * most);
  if (std::fabs(value) > bound && bound > least_settled) return value > 0 ? 1 : -1;
  const std::vector<IntegerVector>& p = points_;
  return dot_sign(cross(p[b] - p[a], p[c] - p[a]), p[d] - p[a]);
}

int VertexSigns::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t axis) const {
  if (a == b || a == c || b == c) return 0;
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  if (words_) {
    const std::vector<WordVector>& p = *words_;
    const auto times = [](std::int64_t u, std::int64_t v) { return Int128{u} * v; };
    const Int128 left = times(p[b][i] - p[a][i], p[c][j] - p[a][j]),
                 right = times(p[b][j] - p[a][j], p[c][i] - p[a][i]);
    return left == right ? 0 : left < right ? -1 : 1;
  }
  const auto &from = boxes_[a].low, &first = boxes_[b].low, &second = boxes_[c].low;
  const double x = first[i] - from[i], y = first[j] - from[j], u = second[i] - from[i],
               v = second[j] - from[j];
  const double value = x * v - y * u;
  // As above: wrong by 2 ((most + doubt)^2 - most^2) <= 6 most doubt, and rounded twice.
  const double most = std::max({std::fabs(x), std::fabs(y), std::fabs(u), std::fabs(v), doubt_});
  const double bound = 16 * most * (doubt_ + 0x1p-53 * most);
  if (std::fabs(value) > bound && bound > least_settled) return value > 0 ? 1 : -1;
  const std::vector<IntegerVector>& p = points_;
  const Integer left = (p[b][i] - p[a][i]) * (p[c][j] - p[a][j]),
                right = (p[b][j] - p[a][j]) * (p[c][i] - p[a][i]);
  return left.compare(right) == 0 ? 0 : left < right ? -1 : 1;
}

}  // namespace minkref::inline space
