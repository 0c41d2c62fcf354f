#include "oracle/checker/plane/predicate.hpp"

#include <array>

namespace minkref::checker {
namespace {

/// A form in t and u for s = from t + to u: the highest power of t first.
using Form = std::vector<mpq_class>;
using Row = std::array<Form, 3>;

Form product(const Form& f, const Form& g) {
  Form result(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) result[i + j] += f[i] * g[j];
  }
  return result;
}

Row cross(const Row& u, const Row& v) {
  Row result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result[i] = product(u[j], v[k]);
    const Form other = product(u[k], v[j]);
    for (std::size_t c = 0; c < other.size(); ++c) result[i][c] -= other[c];
  }
  return result;
}

Row row_of(const Value& value, const Operand& P, const Operand& Q, const mpq_class& from,
           const mpq_class& to) {
  const auto& pair = items(value, 2);
  Point p{0, 0}, q{0, 0};
  if (!pair[0].is_null()) p = P.exact[index(pair[0], P.exact.size())];
  if (!pair[1].is_null()) q = Q.exact[index(pair[1], Q.exact.size())];
  return {Form{from * p.x + q.x, to * p.x + q.x}, Form{from * p.y + q.y, to * p.y + q.y},
          Form{1, 1}};
}

}  // namespace

std::set<int> signs_of(const Value& predicate, const Operand& P, const Operand& Q,
                       const mpq_class& from, const mpq_class& to) {
  const auto& parts = items(predicate, 2);
  const std::string name = parts[0].kind == Value::Kind::text ? parts[0].text : "";
  require(name == "orientation" || name == "concurrent", "there is no such predicate");
  std::vector<Row> rows;
  for (const Value& entry : items(parts[1], 3)) {
    if (name == "orientation") {
      rows.push_back(row_of(entry, P, Q, from, to));
    } else {
      const auto& line = items(entry, 2);
      const Row u = row_of(line[0], P, Q, from, to), v = row_of(line[1], P, Q, from, to);
      require(u != v, "a line has one point given twice");
      rows.push_back(cross(u, v));
    }
  }
  const Row last = cross(rows[1], rows[2]);
  Form sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Form term = product(rows[0][i], last[i]);
    sum.resize(term.size());
    for (std::size_t c = 0; c < term.size(); ++c) sum[c] += term[c];
  }
  std::set<int> signs;
  for (const mpq_class& c : sum) signs.insert(sgn(c));
  return signs;
}

}  // namespace minkref::checker
