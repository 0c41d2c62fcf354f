#include "reference/plane/index/track_numbers.hpp"

#include <gmp.h>

#include <algorithm>
#include <bit>

#include "reference/number/int128.hpp"

namespace minkref::inline plane {
namespace {

__extension__ using Word2 = unsigned __int128;
__extension__ using Signed2 = __int128;

Word2 load(const std::uint64_t* words, std::uint32_t count) {
  if (count == 1)
    return static_cast<Word2>(static_cast<Signed2>(static_cast<std::int64_t>(*words)));
  return Word2{words[1]} << 64 | words[0];
}

template <std::uint32_t count>
void store(Word2 value, std::uint64_t* words) {
  words[0] = static_cast<std::uint64_t>(value);
  if constexpr (count == 2) words[1] = static_cast<std::uint64_t>(value >> 64);
}

/// Computes modulo 2^128, exactly if the result fits.
template <std::uint32_t in, std::uint32_t out>
void in_two_words(const IntegerColumn& tracks, const std::vector<std::uint32_t>& which, Word2 num,
                  Word2 den, std::uint64_t* to) {
  for (const std::uint32_t track : which) {
    const std::uint64_t* from = tracks.data.data() + std::size_t{track} * 5 * in;
    const Word2 x0 = load(from, in), y0 = load(from + in, in), x1 = load(from + 2 * in, in),
                y1 = load(from + 3 * in, in), c = load(from + 4 * in, in);
    store<out>(x0 * den + x1 * num, to);
    store<out>(y0 * den + y1 * num, to + out);
    store<out>(c * den, to + 2 * out);
    to += 3 * out;
  }
}

void in_any_length(const IntegerColumn& tracks, const std::vector<std::uint32_t>& which,
                   const Integer& num, const Integer& den, std::uint32_t words, std::uint64_t* to) {
  for (const std::uint32_t track : which) {
    const std::size_t at = std::size_t{track} * 5;
    write_words(tracks[at] * den + tracks[at + 2] * num, to, words);
    write_words(tracks[at + 1] * den + tracks[at + 3] * num, to + words, words);
    write_words(tracks[at + 4] * den, to + 2 * words, words);
    to += 3 * words;
  }
}

int trailing_zeros(Word2 value) {
  const auto low = static_cast<std::uint64_t>(value);
  return low != 0 ? std::countr_zero(low)
                  : 64 + std::countr_zero(static_cast<std::uint64_t>(value >> 64));
}

/// The greatest common divisor of positive numbers.
Word2 common_divisor(Word2 a, Word2 b) {
  const int twos_a = trailing_zeros(a), twos_b = trailing_zeros(b);
  a >>= twos_a;
  b >>= twos_b;
  mp_limb_t u[2] = {static_cast<mp_limb_t>(a), static_cast<mp_limb_t>(a >> 64)},
            v[2] = {static_cast<mp_limb_t>(b), static_cast<mp_limb_t>(b >> 64)}, g[2] = {0, 0};
  mp_size_t n = u[1] != 0 ? 2 : 1, m = v[1] != 0 ? 2 : 1;
  if (a < b) {
    std::swap(u, v);
    std::swap(n, m);
  }
  const mp_size_t length = mpn_gcd(g, u, n, v, m);
  const Word2 odd = length == 2 ? Word2{g[1]} << 64 | g[0] : Word2{g[0]};
  return odd << std::min(twos_a, twos_b);
}

template <std::uint32_t words>
void reduce_two_words(Word2 value, Word2 den, std::uint64_t* to) {
  const bool negative = (value >> 127) != 0;
  const Word2 magnitude = negative ? -value : value;
  Word2 num = 0, left = 1;
  if (magnitude != 0) {
    const Word2 divisor = common_divisor(magnitude, den);
    num = divisor == 1 ? magnitude : magnitude / divisor;
    left = divisor == 1 ? den : den / divisor;
  }
  store<words>(negative ? -num : num, to);
  store<words>(left, to + words);
}

template <std::uint32_t words>
void reduce_all(const std::vector<std::uint64_t>& from, std::vector<std::uint64_t>& to) {
  for (std::size_t k = 0, n = from.size() / (3 * words); k < n; ++k) {
    const std::uint64_t* numbers = from.data() + k * 3 * words;
    std::uint64_t* out = to.data() + k * 4 * words;
    const Word2 den = load(numbers + 2 * words, words);
    reduce_two_words<words>(load(numbers, words), den, out);
    reduce_two_words<words>(load(numbers + words, words), den, out + 2 * words);
  }
}

}  // namespace

void homogeneous_numbers(const IntegerColumn& tracks, std::uint64_t bits,
                         const std::vector<std::uint32_t>& which, const Rational& scale,
                         HomogeneousRings& result) {
  const Integer num = numerator(scale), den = denominator(scale);
  const std::size_t needed = bits + std::max(signed_bits(num), signed_bits(den)) + 1;
  result.words = static_cast<std::uint32_t>((needed + 63) / 64);
  result.numbers.resize(which.size() * 3 * result.words);
  std::uint64_t* const to = result.numbers.data();
  if (result.words > 2 || tracks.words > 2) {
    return in_any_length(tracks, which, num, den, result.words, to);
  }
  std::uint64_t words[2];
  write_words(num, words, 2);
  const Word2 n = load(words, 2);
  write_words(den, words, 2);
  const Word2 d = load(words, 2);
  if (result.words == 1) return in_two_words<1, 1>(tracks, which, n, d, to);
  if (tracks.words == 1) return in_two_words<1, 2>(tracks, which, n, d, to);
  in_two_words<2, 2>(tracks, which, n, d, to);
}

void reduced_numbers(const HomogeneousRings& from, RationalRings& result) {
  const std::uint32_t words = result.words = from.words;
  const std::size_t count = from.numbers.size() / (3 * words);
  result.numbers.resize(count * 4 * words);
  if (words == 1) return reduce_all<1>(from.numbers, result.numbers);
  if (words == 2) return reduce_all<2>(from.numbers, result.numbers);
  const IntegerColumn column = from.column();
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Rational value(column[3 * k + axis], column[3 * k + 2]);
      std::uint64_t* const to = result.numbers.data() + (4 * k + 2 * axis) * words;
      write_words(numerator(value), to, words);
      write_words(denominator(value), to + words, words);
    }
  }
}

}  // namespace minkref::inline plane
