#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "reference/number/radicals/surd_node.hpp"

namespace minkref {
namespace {

namespace mp = boost::multiprecision;
using Node = Surd::Node;

/// An upper bound for the binary logarithm of a whole number > 0.
double log_of(const Integer& value) { return static_cast<double>(mp::msb(value)) + 1; }
Integer size_of(const Integer& value) { return value < 0 ? Integer(-value) : value; }

/// Logarithms of u and of l, both >= 0.
struct Bounds {
  double u = 0, l = 0;
};

class BoundSearch {
 public:
  Bounds of(const Surd::Ref& node) {
    const auto found = known_.find(node.get());
    if (found != known_.end()) return found->second;
    const Bounds own = compute(*node);
    known_.emplace(node.get(), own);
    return own;
  }

  /// The field's degree is at most 2 to this power.
  std::size_t doublings() const { return rank() + roots_; }

 private:
  Bounds compute(const Node& node) {
    if (node.kind == Node::Kind::terms) return of_terms(node);
    const Bounds a = of(node.a);
    if (node.kind == Node::Kind::root) {
      ++roots_;  // √(U/L) = √(U L)/L = U/√(U L)
      const double middle = (a.u + a.l) / 2;
      return a.u >= a.l ? Bounds{middle, a.l} : Bounds{a.u, middle};
    }
    const Bounds b = of(node.b);
    if (node.kind == Node::Kind::sum) return {std::max(a.u + b.l, b.u + a.l) + 1, a.l + b.l};
    if (node.kind == Node::Kind::product) return {a.u + b.u, a.l + b.l};
    return {a.u + b.l, a.l + b.u};
  }

  Bounds of_terms(const Node& node) {
    Integer bottom = 1;
    for (const SurdTerm& term : node.terms) bottom = mp::lcm(bottom, mp::denominator(term.factor));
    double most = 0;
    for (const SurdTerm& term : node.terms) {
      const Integer top = size_of(mp::numerator(Rational(term.factor * bottom)));
      most = std::max(most, log_of(top) + log_of(term.inside) / 2);
      if (term.inside > 1) insides_.insert(term.inside);
    }
    const auto count = static_cast<double>(std::max<std::size_t>(node.terms.size(), 1));
    return {most + std::ceil(std::log2(count)), log_of(bottom)};
  }

  /// Whole numbers without common factors whose products all insides are.
  std::vector<Integer> coprime_base() const {
    std::vector<Integer> base, open(insides_.begin(), insides_.end());
    while (!open.empty()) {
      const Integer x = open.back();
      open.pop_back();
      if (x == 1) continue;
      bool is_new = true;
      for (std::size_t k = 0; k < base.size(); ++k) {
        const Integer common = mp::gcd(x, base[k]);
        if (common == 1) continue;
        is_new = false;
        if (common == base[k]) {
          open.push_back(Integer(x / common));
        } else {
          open.push_back(Integer(base[k] / common));
          open.push_back(x);
          base[k] = common;
        }
        break;
      }
      if (is_new) base.push_back(x);
    }
    return base;
  }

  /// An upper bound for the rank modulo squares: of the parities of powers of the base.
  std::size_t rank() const {
    const std::vector<Integer> base = coprime_base();
    std::vector<std::vector<bool>> rows;
    for (Integer x : insides_) {
      std::vector<bool> row(base.size(), false);
      for (std::size_t k = 0; k < base.size(); ++k) {
        for (; x % base[k] == 0; x /= base[k]) row[k] = !row[k];
      }
      for (const std::vector<bool>& other : rows) {  // each has its first power alone
        const auto first =
            static_cast<std::size_t>(std::find(other.begin(), other.end(), true) - other.begin());
        if (!row[first]) continue;
        for (std::size_t k = 0; k < row.size(); ++k) row[k] = row[k] != other[k];
      }
      if (std::find(row.begin(), row.end(), true) != row.end()) rows.push_back(std::move(row));
    }
    return rows.size();
  }

  std::unordered_map<const Node*, Bounds> known_;
  std::set<Integer> insides_;
  std::size_t roots_ = 0;
};

class Evaluation {
 public:
  explicit Evaluation(long precision) : precision_(precision) {}

  const MpfrInterval& of(const Surd::Ref& node) {
    const auto found = known_.find(node.get());
    if (found != known_.end()) return found->second;
    return known_.emplace(node.get(), compute(*node)).first->second;
  }

 private:
  MpfrInterval compute(const Node& node) {
    if (node.kind == Node::Kind::terms) {
      MpfrInterval total(Rational(0), precision_);
      for (const SurdTerm& term : node.terms) {
        const MpfrInterval factor(term.factor, precision_);
        total = total + (term.inside == 1 ? factor : factor * root_of(term.inside));
      }
      return total;
    }
    const MpfrInterval a = of(node.a);
    switch (node.kind) {
      case Node::Kind::root:
        return sqrt(a);
      case Node::Kind::sum:
        return a + of(node.b);
      case Node::Kind::product:
        return a * of(node.b);
      default:
        return a / of(node.b);
    }
  }

  const MpfrInterval& root_of(const Integer& inside) {
    const auto found = roots_.find(inside);
    if (found != roots_.end()) return found->second;
    return roots_.emplace(inside, sqrt(MpfrInterval(Rational(inside), precision_))).first->second;
  }

  long precision_;
  std::unordered_map<const Node*, MpfrInterval> known_;
  std::map<Integer, MpfrInterval> roots_;
};

}  // namespace

double surd_bits(const Surd::Ref& node) {
  BoundSearch search;
  const Bounds bounds = search.of(node);
  return bounds.l + (std::ldexp(1.0, static_cast<int>(search.doublings())) - 1) * bounds.u + 1;
}

MpfrInterval surd_value(const Surd::Ref& node, long precision) {
  return Evaluation(precision).of(node);
}

}  // namespace minkref
