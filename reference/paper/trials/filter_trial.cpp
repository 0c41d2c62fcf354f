#include "reference/paper/trials/filter_trial.hpp"

#include <random>

#include "reference/plane/kernel/grid_kernel.hpp"

namespace minkref {

FilterTrial filter_trial(std::uint64_t seed, std::uint64_t count) {
  using K = GridKernel<Grid64>;
  std::mt19937_64 random(
      seed);  // its sequence is fixed by the language; distributions are not, and are not used
  const auto integer = [&](unsigned bits) {
    const auto magnitude = static_cast<std::int64_t>(random() >> (64 - bits));
    return random() % 2 == 0 ? magnitude : -magnitude;
  };
  FilterTrial trial;
  const K kernel;
  for (; trial.trials < count; ++trial.trials) {
    const unsigned bits = 8 + static_cast<unsigned>(random() % 22);
    K::Vector u(integer(bits), integer(bits)), v(integer(bits), integer(bits));
    if (trial.trials % 4 != 0) {
      // Both are near multiples of a common direction; the last bits differ by chance.
      const K::Vector d(integer(bits), integer(bits));
      const std::int64_t a = integer(29), b = integer(29);
      u = K::Vector(a * d.x() + integer(2), a * d.y() + integer(2));
      v = K::Vector(b * d.x() + integer(2), b * d.y() + integer(2));
    }
    const std::uint64_t before = kernel.counts.by_float;
    const int answer = kernel.turn(u, v);
    const int truth = sign(Integer(Integer(u.x()) * v.y() - Integer(u.y()) * v.x()));
    if (kernel.counts.by_float > before) {
      ++trial.by_filter;
      trial.filter_wrong += answer != truth;
      continue;
    }
    ++trial.handed_on;
    const double plain = static_cast<double>(u.x()) * static_cast<double>(v.y()) -
                         static_cast<double>(u.y()) * static_cast<double>(v.x());
    trial.doubles_wrong += (plain > 0) - (plain < 0) != truth;
  }
  return trial;
}

}  // namespace minkref
