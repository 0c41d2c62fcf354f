#include "reference/number/radicals/root_text.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace minkref {
namespace {

using RootCoefficients = std::vector<Rational>;

struct PlainRoot {
  Rational outside;
  Integer inside;
};

/// √square as a product: small square factors stand before the root.
PlainRoot plain_root(const Rational& square) {
  namespace mp = boost::multiprecision;
  const Integer bottom = mp::denominator(square);
  Integer inside = mp::numerator(square) * bottom, outside = 1;
  const Integer whole = mp::sqrt(inside);
  if (whole * whole == inside) return {Rational(whole, bottom), 1};
  for (unsigned factor = 2; factor < 1000; ++factor) {
    const Integer twice = Integer(factor) * factor;
    if (twice > inside) break;
    while (inside % twice == 0) {
      inside /= twice;
      outside *= factor;
    }
  }
  return {Rational(outside, bottom), inside};
}

/// Adds each product of the number's roots, times a factor and a root. Bit k of a product's index
/// says whether the product contains the k-th root.
void add_products(std::map<std::string, Rational>& terms,
                  const std::vector<RootCoefficients>& radicands,
                  const RootCoefficients& coefficients, const Rational& factor,
                  const Rational& square);

std::string text_of(const std::map<std::string, Rational>& terms) {
  std::string text;
  for (const auto& [product, c] : terms) {
    const Rational size = c < 0 ? Rational(-c) : c;
    if (text.empty()) {
      text += c < 0 ? "-" : "";
    } else {
      text += c < 0 ? " - " : " + ";
    }
    if (product.empty() || size != 1) text += to_string(size);
    if (!product.empty() && size != 1) text += '*';
    text += product;
  }
  return text.empty() ? "0" : text;
}

void add_products(std::map<std::string, Rational>& terms,
                  const std::vector<RootCoefficients>& radicands,
                  const RootCoefficients& coefficients, const Rational& factor,
                  const Rational& square) {
  for (std::size_t product = 0; product < coefficients.size(); ++product) {
    Rational c = coefficients[product] * factor;
    if (c == 0) continue;
    Rational under_one_root = square;
    std::vector<std::string> roots;
    for (std::size_t k = 0; (product >> k) != 0; ++k) {
      if (((product >> k) & 1U) == 0) continue;
      std::map<std::string, Rational> inner;
      add_products(inner, radicands, radicands[k], 1, 1);
      if (inner.empty()) {
        under_one_root = 0;
      } else if (inner.size() == 1 && inner.begin()->first.empty()) {
        under_one_root *= inner.begin()->second;
      } else {
        roots.push_back("sqrt(" + text_of(inner) + ")");
      }
    }
    if (under_one_root == 0) continue;
    const PlainRoot root = plain_root(under_one_root);
    c *= root.outside;
    if (root.inside != 1) roots.push_back("sqrt(" + root.inside.str() + ")");
    std::sort(roots.begin(), roots.end());
    std::string name;
    for (const std::string& each : roots) name += (name.empty() ? "" : "*") + each;
    const auto found = terms.try_emplace(name, 0).first;
    found->second += c;
    if (found->second == 0) terms.erase(found);
  }
}

}  // namespace

void RootTerms::add(const RootNumber& value, const Rational& factor, const Rational& square) {
  add_products(terms_, value.field()->radicands(), value.coefficients(), factor, square);
}

std::string RootTerms::text() const { return text_of(terms_); }

std::string expression(const RootNumber& value) {
  RootTerms terms;
  terms.add(value);
  return terms.text();
}

}  // namespace minkref
