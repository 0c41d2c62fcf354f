#include "reference/space/word_vectors.hpp"

#include <algorithm>
#include <cmath>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

using Doubles = std::array<double, 3>;

/// Twice the rounding of a double to nearest.
constexpr double rounding = 0x1p-52;

Doubles rounded(const WideVector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// The greatest coordinate magnitude.
template <class Vector>
auto extent(const Vector& v) {
  const auto& longest = v[longest_axis(v)];
  return longest < 0 ? typename Vector::value_type(-longest) : longest;
}

}  // namespace

bool fit_in_words(const std::vector<Face>& faces) {
  return std::all_of(faces.begin(), faces.end(),
                     [](const Face& face) { return face.size() <= most_word_corners; });
}

bool fit_in_words(const std::vector<WordVector>& points) {
  constexpr std::int64_t limit = std::int64_t{1} << most_word_bits;
  return std::all_of(points.begin(), points.end(), [](const WordVector& p) {
    return std::all_of(p.begin(), p.end(), [](auto c) { return -limit < c && c < limit; });
  });
}

std::optional<std::vector<WordVector>> in_words(const std::vector<IntegerVector>& points) {
  const Integer limit = Integer(1) << most_word_bits;
  const auto is_short = [&](const Integer& c) { return -limit < c && c < limit; };
  std::vector<WordVector> result;
  result.reserve(points.size());
  for (const IntegerVector& p : points) {
    look_for_interrupt();
    if (!std::all_of(p.begin(), p.end(), is_short)) return std::nullopt;
    result.push_back({static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1]),
                      static_cast<std::int64_t>(p[2])});
  }
  return result;
}

int dot_sign(const WideVector& normal, const WordVector& along) {
  // A normal coordinate is high * 2^64 + low: both sums stay below 2^126.
  Int128 high = 0, low = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    high += (normal[k] >> 64) * along[k];
    low += Int128{static_cast<std::uint64_t>(normal[k])} * along[k];
  }
  high += low >> 64;
  if (high != 0) return high < 0 ? -1 : 1;
  return static_cast<std::uint64_t>(low) != 0 ? 1 : 0;
}

int turn_sign(const WideVector& a, const WideVector& b, const WordVector& along) {
  const Doubles u = rounded(a), v = rounded(b);
  double value = 0, magnitude = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double d = static_cast<double>(along[k]);
    value += (u[i] * v[j] - u[j] * v[i]) * d;
    magnitude += (std::fabs(u[i] * v[j]) + std::fabs(u[j] * v[i])) * std::fabs(d);
  }
  // Each term went through at most eight roundings: three of what was given, a product, a
  // difference, a product, two sums. A product is 0 or a whole number below 2^311.
  if (std::fabs(value) > 8 * rounding * magnitude) return value > 0 ? 1 : -1;
  return turn_sign(to_integers(a), to_integers(b), to_integers(along));
}

int turn_sign(const IntegerVector& a, const IntegerVector& b, const IntegerVector& along) {
  return dot(cross(a, b), along).sign();
}

WordDirection::WordDirection(const WideVector& v) : vector(v), longest(extent(v)) {
  const double under = static_cast<double>(longest);
  for (std::size_t k = 0; k < 3; ++k) rounded[k] = static_cast<double>(v[k]) / under;
}

IntegerDirection::IntegerDirection(const IntegerVector& v) : vector(v), longest(extent(v)) {}

int compare(const WordDirection& a, const WordDirection& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double u = a.rounded[k], v = b.rounded[k];
    if (std::fabs(u - v) > 4 * rounding * std::max(std::fabs(u), std::fabs(v))) {
      return u < v ? -1 : 1;
    }
    const Int128 &of_a = a.vector[k], &of_b = b.vector[k];
    const bool same = (of_a == 0 && of_b == 0) || (of_a == a.longest && of_b == b.longest) ||
                      (of_a == -a.longest && of_b == -b.longest) ||
                      (of_a == of_b && a.longest == b.longest);
    if (same) continue;
    const Integer left = to_integer(of_a) * to_integer(b.longest),
                  right = to_integer(of_b) * to_integer(a.longest);
    if (left != right) return left < right ? -1 : 1;
  }
  return 0;
}

int compare(const IntegerDirection& a, const IntegerDirection& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer left = a.vector[k] * b.longest, right = b.vector[k] * a.longest;
    if (left != right) return left < right ? -1 : 1;
  }
  return 0;
}

}  // namespace minkref::inline space
