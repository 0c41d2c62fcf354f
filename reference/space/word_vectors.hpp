// Vectors of machine words: exact normals and signs without allocation, for short coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/number/int128.hpp"
#include "reference/space/integer_points.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

using WordVector = std::array<std::int64_t, 3>;
/// The cross product of two point differences, or a sum of cross products.
using WideVector = std::array<Int128, 3>;

/// The `area_vector` type for faces on such points.
template <class Point>
using AreaVector = std::conditional_t<std::is_same_v<Point, WordVector>, WideVector, IntegerVector>;

/// Point coordinates lie below 2^54 in magnitude, vector coordinates below 2^60, and faces have at
/// most 512 corners: vector areas and cross products lie below 2^122.
constexpr long most_word_bits = 54;
constexpr std::size_t most_word_corners = 512;

/// Whether words can hold these faces' vector areas.
bool fit_in_words(const std::vector<Face>& faces);
bool fit_in_words(const std::vector<WordVector>& points);
/// The points as words, if all are short enough.
std::optional<std::vector<WordVector>> in_words(const std::vector<IntegerVector>& points);

inline IntegerVector to_integers(const WordVector& v) { return {v[0], v[1], v[2]}; }
inline IntegerVector to_integers(const WideVector& v) {
  return {to_integer(v[0]), to_integer(v[1]), to_integer(v[2])};
}
inline const IntegerVector& to_integers(const IntegerVector& v) { return v; }

inline WordVector operator-(const WordVector& a, const WordVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline WideVector cross(const WordVector& a, const WordVector& b) {
  const auto times = [](std::int64_t u, std::int64_t v) { return Int128{u} * v; };
  return {times(a[1], b[2]) - times(a[2], b[1]), times(a[2], b[0]) - times(a[0], b[2]),
          times(a[0], b[1]) - times(a[1], b[0])};
}
inline WideVector operator+(const WideVector& a, const WideVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline bool is_zero(const WideVector& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

/// The sign of the scalar product of a vector area and a point difference.
int dot_sign(const WideVector& normal, const WordVector& along);
inline int dot_sign(const IntegerVector& normal, const IntegerVector& along) {
  return dot(normal, along).sign();
}

/// The sign of (a x b) · along, by doubles if they settle the sign.
int turn_sign(const WideVector& a, const WideVector& b, const WordVector& along);
int turn_sign(const IntegerVector& a, const IntegerVector& b, const IntegerVector& along);

/// The direction of a nonzero vector.
struct WordDirection {
  WideVector vector;
  Int128 longest;                 ///< of the magnitudes of its coordinates
  std::array<double, 3> rounded;  ///< the vector over it, each after three roundings
  explicit WordDirection(const WideVector& v);
};
struct IntegerDirection {
  const IntegerVector& vector;
  Integer longest;
  explicit IntegerDirection(const IntegerVector& v);
};
inline WordDirection direction(const WideVector& v) { return WordDirection(v); }
inline IntegerDirection direction(const IntegerVector& v) { return IntegerDirection(v); }

/// An order of directions: negative, 0 for the same direction, or positive. Doubles decide if they
/// can.
int compare(const WordDirection& a, const WordDirection& b);
int compare(const IntegerDirection& a, const IntegerDirection& b);

}  // namespace minkref::inline space
