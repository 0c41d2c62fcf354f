#include "reference/space/integer_points.hpp"

#include "reference/error.hpp"
#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

constexpr std::size_t most_denominator_bits = 100'000'000;  // of the denominator, over all vertices

}  // namespace

IntegerVector primitive(const IntegerVector& vector) {
  const Integer divisor = gcd(gcd(vector[0], vector[1]), vector[2]);
  if (divisor.is_zero()) return vector;
  return {vector[0] / divisor, vector[1] / divisor, vector[2] / divisor};
}

IntegerPoints integer_points(const std::vector<SpacePoint>& vertices) {
  using boost::multiprecision::denominator;
  using boost::multiprecision::numerator;
  IntegerPoints result;
  for (const SpacePoint& v : vertices) {
    look_for_interrupt();
    for (const Rational* coordinate : {&v.x, &v.y, &v.z}) {
      const Integer own = denominator(*coordinate);
      if (result.denominator % own != 0) result.denominator = lcm(result.denominator, own);
      if (msb(result.denominator) > most_denominator_bits / vertices.size()) {
        throw LimitExceeded("common-denominator-too-long",
                            "the coordinates have no common denominator of moderate length",
                            "round the coordinates to decimals of the same length");
      }
    }
  }
  const auto whole = [&](const Rational& coordinate) {
    return Integer(numerator(coordinate) * (result.denominator / denominator(coordinate)));
  };
  result.points.reserve(vertices.size());
  for (const SpacePoint& v : vertices) {
    look_for_interrupt();
    result.points.push_back({whole(v.x), whole(v.y), whole(v.z)});
  }
  return result;
}

}  // namespace minkref::inline space
