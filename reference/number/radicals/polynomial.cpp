#include "reference/number/radicals/polynomial.hpp"

#include <utility>

namespace minkref {
namespace {

void trim(Polynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

void make_monic(Polynomial& p) {
  if (p.empty()) return;
  const Rational lead = p.back();
  for (Rational& c : p) c /= lead;
}

/// The remainder of a by b; requires b != 0.
Polynomial remainder(Polynomial a, const Polynomial& b) {
  trim(a);
  while (a.size() >= b.size()) {
    const Rational factor = a.back() / b.back();
    const std::size_t shift = a.size() - b.size();
    for (std::size_t k = 0; k < b.size(); ++k) a[k + shift] -= factor * b[k];
    trim(a);
  }
  return a;
}

Polynomial quotient(Polynomial a, const Polynomial& b) {
  Polynomial found(a.size() < b.size() ? 0 : a.size() - b.size() + 1);
  while (a.size() >= b.size()) {
    const Rational factor = a.back() / b.back();
    const std::size_t shift = a.size() - b.size();
    found[shift] = factor;
    for (std::size_t k = 0; k < b.size(); ++k) a[k + shift] -= factor * b[k];
    a.pop_back();
    trim(a);
  }
  return found;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial found;
  for (std::size_t k = 1; k < p.size(); ++k) found.push_back(p[k] * static_cast<unsigned>(k));
  return found;
}

std::size_t sign_changes(const std::vector<Polynomial>& chain, const Rational& x) {
  std::size_t changes = 0;
  int last = 0;
  for (const Polynomial& p : chain) {
    const int here = value_at(p, x).sign();
    if (here != 0 && last != 0 && here != last) ++changes;
    if (here != 0) last = here;
  }
  return changes;
}

}  // namespace

Polynomial common_divisor(Polynomial a, Polynomial b) {
  trim(a);
  trim(b);
  while (!b.empty()) {
    make_monic(b);
    Polynomial rest = remainder(std::move(a), b);
    a = std::move(b);
    b = std::move(rest);
  }
  make_monic(a);
  return a;
}

Polynomial without_multiple_roots(const Polynomial& p) {
  Polynomial a = p;
  trim(a);
  make_monic(a);
  return a.size() < 3 ? a : quotient(a, common_divisor(a, derivative(a)));
}

std::size_t count_roots(const Polynomial& p, const Rational& low, const Rational& high) {
  std::vector<Polynomial> chain{without_multiple_roots(p)};
  if (chain[0].size() < 2) return 0;
  for (Polynomial next = derivative(chain[0]); !next.empty();) {
    chain.push_back(next);
    next = remainder(chain[chain.size() - 2], chain.back());
    for (Rational& c : next) c = -c;
  }
  return sign_changes(chain, low) - sign_changes(chain, high);
}

}  // namespace minkref
