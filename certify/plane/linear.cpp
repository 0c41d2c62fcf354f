#include "certify/plane/linear.hpp"

#include <boost/multiprecision/integer.hpp>

namespace minkref::certify {

std::uint32_t NormalTable::add(const Rational& x, const Rational& y) {
  const Integer common = lcm(denominator(x), denominator(y));
  Integer nx = numerator(x) * (common / denominator(x));
  Integer ny = numerator(y) * (common / denominator(y));
  const Integer divisor = gcd(nx, ny);
  nx /= divisor;
  ny /= divisor;
  const auto [place, fresh] =
      ids_.try_emplace({nx, ny}, static_cast<std::uint32_t>(normals_.size()));
  if (fresh) {
    normals_.push_back({nx, ny, to_double(Rational(nx)), to_double(Rational(ny))});
  }
  return place->second;
}

}  // namespace minkref::certify
