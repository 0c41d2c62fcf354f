#include "reference/number/radicals/surd.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "reference/error.hpp"
#include "reference/number/radicals/surd_node.hpp"

namespace minkref {
namespace {

namespace mp = boost::multiprecision;
using Node = Surd::Node;
using Terms = std::vector<SurdTerm>;

constexpr std::size_t most_terms = 32;

Surd::Ref made(Terms terms) {
  auto node = std::make_shared<Node>();
  Interval near(0.0);
  for (const SurdTerm& term : terms) {
    const Interval factor(term.factor);
    near += term.inside == 1 ? factor : factor * sqrt(Interval(Rational(term.inside)));
  }
  node->near = near;
  node->terms = std::move(terms);
  return node;
}

Surd::Ref made(Node::Kind kind, const Surd::Ref& a, const Surd::Ref& b, const Interval& near) {
  auto node = std::make_shared<Node>();
  node->kind = kind;
  node->a = a;
  node->b = b;
  node->near = near;
  return node;
}

/// √square for square > 0, with small square factors before the root.
SurdTerm root_term(const Rational& square) {
  const Integer bottom = mp::denominator(square);
  Integer inside = mp::numerator(square) * bottom, outside = 1;
  for (unsigned factor = 2; factor < 100; ++factor) {
    const Integer twice = Integer(factor) * factor;
    if (twice > inside) break;
    while (inside % twice == 0) {
      inside /= twice;
      outside *= factor;
    }
  }
  const Integer whole = mp::sqrt(inside);
  if (whole * whole == inside) {
    outside *= whole;
    inside = 1;
  }
  return {inside, Rational(outside, bottom)};
}

Terms sum_of(const Terms& a, const Terms& b) {
  Terms all;
  auto x = a.begin(), y = b.begin();
  while (x != a.end() || y != b.end()) {
    if (y == b.end() || (x != a.end() && x->inside < y->inside)) {
      all.push_back(*x++);
    } else if (x == a.end() || y->inside < x->inside) {
      all.push_back(*y++);
    } else {
      const Rational factor = x->factor + y->factor;
      if (factor != 0) all.push_back({x->inside, factor});
      ++x;
      ++y;
    }
  }
  return all;
}

SurdTerm product_of(const SurdTerm& a, const SurdTerm& b) {
  if (a.inside == 1) return {b.inside, a.factor * b.factor};
  if (b.inside == 1) return {a.inside, a.factor * b.factor};
  const Integer common = mp::gcd(a.inside, b.inside);
  return {Integer((a.inside / common) * (b.inside / common)),
          a.factor * b.factor * Rational(common)};
}

Terms product_of(const Terms& a, const Terms& b) {
  Terms all;
  for (const SurdTerm& x : a) {
    Terms row;
    for (const SurdTerm& y : b) row.push_back(product_of(x, y));
    std::sort(row.begin(), row.end(),
              [](const SurdTerm& p, const SurdTerm& q) { return p.inside < q.inside; });
    Terms joined;  // different terms may have one product
    for (const SurdTerm& term : row) joined = sum_of(joined, {term});
    all = sum_of(all, joined);
  }
  return all;
}

SurdTerm inverse_of(const SurdTerm& a) {
  return {a.inside, Rational(1) / (a.factor * Rational(a.inside))};
}

bool is_terms(const Surd::Ref& node) { return node->kind == Node::Kind::terms; }

}  // namespace

Surd::Surd(const Rational& value)
    : node_(value == 0 ? made(Terms{}) : made(Terms{{Integer(1), value}})) {}

Surd::Ref Surd::sum(const Ref& a, const Ref& b) {
  if (a->is_zero()) return b;
  if (b->is_zero()) return a;
  if (is_terms(a) && is_terms(b)) return made(sum_of(a->terms, b->terms));
  return made(Node::Kind::sum, a, b, a->near + b->near);
}

Surd::Ref Surd::product(const Ref& a, const Ref& b) {
  if (a->is_zero()) return a;
  if (b->is_zero()) return b;
  if (is_terms(a) && is_terms(b) && a->terms.size() * b->terms.size() <= most_terms) {
    return made(product_of(a->terms, b->terms));
  }
  const auto is_one = [](const Ref& x) { return x->is_rational() && x->terms[0].factor == 1; };
  if (is_one(a)) return b;
  if (is_one(b)) return a;
  if (a->kind == Node::Kind::root && b->kind == Node::Kind::root && a->a == b->a) return a->a;
  return made(Node::Kind::product, a, b, a->near * b->near);
}

Surd::Ref Surd::quotient(const Ref& a, const Ref& b) {
  if (b->is_zero()) throw std::domain_error("division by zero");
  if (a->is_zero()) return a;
  if (is_terms(b) && b->terms.size() == 1) return product(a, made(Terms{inverse_of(b->terms[0])}));
  if (is_terms(b) && b->terms.size() == 2) {  // 1 / (x + y) = (x - y) / (x² - y²)
    const SurdTerm &x = b->terms[0], &y = b->terms[1];
    const Rational square =
        x.factor * x.factor * Rational(x.inside) - y.factor * y.factor * Rational(y.inside);
    if (square != 0) {
      const Rational i = 1 / square;
      return product(a, made(Terms{{x.inside, x.factor * i}, {y.inside, -(y.factor * i)}}));
    }
  }
  return made(Node::Kind::quotient, a, b, a->near / b->near);
}

Surd operator-(const Surd& a) {
  static const Surd minus_one(-1);
  return Surd(Surd::product(minus_one.node_, a.node_));
}
Surd operator+(const Surd& a, const Surd& b) { return Surd(Surd::sum(a.node_, b.node_)); }
Surd operator*(const Surd& a, const Surd& b) { return Surd(Surd::product(a.node_, b.node_)); }
Surd operator/(const Surd& a, const Surd& b) { return Surd(Surd::quotient(a.node_, b.node_)); }

Surd sqrt(const Surd& a) {
  if (!(a.node_->near.lower() > 0)) {
    const int own = sign(a);
    if (own == 0) return Surd(0);
    if (own < 0) throw std::domain_error("the square root of a negative number");
  }
  if (a.node_->is_rational()) return Surd(made(Terms{root_term(a.node_->terms[0].factor)}));
  return Surd(made(Node::Kind::root, a.node_, nullptr, sqrt(a.node_->near)));
}

int sign(const Surd& a) {
  if (const auto certain = certified_sign(a.node_->near)) return *certain;
  if (is_terms(a.node_) && a.node_->terms.size() <= 1) {
    return a.node_->terms.empty() ? 0 : a.node_->terms[0].factor.sign();
  }
  constexpr long first_bits = 192, longest_trial = 1L << 16;
  constexpr double most_bits = 0x1p24;
  if (const int certain = a.enclosure(first_bits).certain_sign(); certain != 0) return certain;
  const double bits = surd_bits(a.node_);
  for (long precision = 4 * first_bits;; precision *= 4) {
    if (bits > most_bits && precision > longest_trial) {
      throw LimitExceeded("too-many-roots",
                          "a sign takes more than " + std::to_string(1 << 24) + " bits",
                          "give operands with fewer digits");
    }
    const MpfrInterval value = a.enclosure(precision);
    if (const int certain = value.certain_sign(); certain != 0) return certain;
    if (bits <= most_bits && value.is_within(-static_cast<long>(bits))) return 0;
  }
}

Interval Surd::enclosure() const { return node_->near; }
MpfrInterval Surd::enclosure(long precision) const { return surd_value(node_, precision); }

std::optional<Rational> Surd::rational() const {
  if (!node_->is_rational()) return std::nullopt;
  return node_->terms.empty() ? Rational(0) : node_->terms[0].factor;
}

}  // namespace minkref
