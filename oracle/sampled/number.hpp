// Integers with three widths behind one set of names. Narrow integers serve only where a bound
// computed beforehand rules out overflow; otherwise the next width serves.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace minkref::sampled {

using Narrow = std::int64_t;
__extension__ typedef __int128 Wide;

/// A narrow integer may overflow: repeat with a wider integer.
struct TooLarge : std::exception {};

/// The size below which nothing overflows; half of the overflowing size.
template <class Int>
constexpr long double room() {
  if constexpr (std::is_same_v<Int, Narrow>) return 0x1p62L;
  if constexpr (std::is_same_v<Int, Wide>) return 0x1p126L;
  return 0;
}

/// Throws TooLarge where numbers up to this size have no room.
template <class Int>
void demand_room(long double size) {
  if constexpr (!std::is_same_v<Int, mpz_class>) {
    if (!(size < room<Int>())) throw TooLarge();
  }
}

template <class Int>
long double size_of(const Int& n) {
  if constexpr (std::is_same_v<Int, mpz_class>) {
    return 0;  // never used: GMP always has room
  } else {
    return n < 0 ? -static_cast<long double>(n) : static_cast<long double>(n);
  }
}

template <class Int>
int sign(const Int& n) {
  return n > 0 ? 1 : n < 0 ? -1 : 0;
}

template <class Int>
Int gcd_of(Int a, Int b) {
  if constexpr (std::is_same_v<Int, mpz_class>) {
    return gcd(a, b);
  } else {
    if (a < 0) a = -a;
    if (b < 0) b = -b;
    while (b != 0) a = std::exchange(b, a % b);
    return a;
  }
}

template <class Int>
Int from_integer(const mpz_class& n) {
  if constexpr (std::is_same_v<Int, mpz_class>) {
    return n;
  } else {
    constexpr unsigned bits = std::is_same_v<Int, Narrow> ? 62 : 126;
    if (mpz_sizeinbase(n.get_mpz_t(), 2) > bits) throw TooLarge();
    Int value = 0;
    const mpz_class size = abs(n);
    for (int part = 3; part >= 0; --part) {
      const mpz_class shifted = size >> static_cast<unsigned>(32 * part);
      const mpz_class word = shifted & 0xffffffffUL;
      if constexpr (sizeof(Int) == 16) {
        value = (value << 32) | static_cast<Int>(word.get_ui());
      } else if (part < 2) {
        value = (value << 32) | static_cast<Int>(word.get_ui());
      }
    }
    return n < 0 ? Int(-value) : value;
  }
}

template <class Int>
mpz_class to_integer(const Int& n) {
  if constexpr (std::is_same_v<Int, mpz_class>) {
    return n;
  } else if constexpr (std::is_same_v<Int, Narrow>) {
    return mpz_class(static_cast<long>(n));
  } else {
    const Wide size = n < 0 ? -n : n;
    mpz_class value = static_cast<unsigned long>(size >> 64);
    value <<= 64;
    value += static_cast<unsigned long>(size);
    return n < 0 ? mpz_class(-value) : value;
  }
}

template <class Int>
struct Vec {
  Int x, y;
  friend bool operator==(const Vec& a, const Vec& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator<(const Vec& a, const Vec& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {Int(a.x - b.x), Int(a.y - b.y)}; }
  friend Vec operator-(const Vec& a) { return {Int(-a.x), Int(-a.y)}; }
};

template <class Int>
Int cross(const Vec<Int>& u, const Vec<Int>& v) {
  return Int(u.x * v.y - u.y * v.x);
}
template <class Int>
Int dot(const Vec<Int>& u, const Vec<Int>& v) {
  return Int(u.x * v.x + u.y * v.y);
}

/// p / q with q > 0; 1 / 0 is infinity.
template <class Int>
struct Fraction {
  Int p, q;
  friend bool operator<(const Fraction& a, const Fraction& b) { return a.p * b.q < b.p * a.q; }
  friend bool operator==(const Fraction& a, const Fraction& b) { return a.p * b.q == b.p * a.q; }
  friend bool operator<=(const Fraction& a, const Fraction& b) { return !(b < a); }
};

/// Makes a fraction in lowest terms; q != 0.
template <class Int>
Fraction<Int> fraction(Int p, Int q) {
  const Int common = gcd_of<Int>(p, q);
  if (q < 0) return {Int(-p / common), Int(-q / common)};
  return {Int(p / common), Int(q / common)};
}

template <class Int>
mpq_class to_rational(const Fraction<Int>& s) {
  return mpq_class(to_integer(s.p), to_integer(s.q));
}

/// The linear function a + b s.
template <class Int>
struct Linear {
  Int a, b;
  Int at(const Fraction<Int>& s) const { return Int(a * s.q + b * s.p); }  ///< times s.q
  friend bool operator==(const Linear& f, const Linear& g) { return f.a == g.a && f.b == g.b; }
};

}  // namespace minkref::sampled
