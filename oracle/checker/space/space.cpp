#include "oracle/checker/space/space.hpp"

#include <algorithm>
#include <utility>

#include "oracle/checker/sha256.hpp"

namespace minkref::checker {

Whole plus(const Whole& u, const Whole& v) {
  return {mpz_class(u[0] + v[0]), mpz_class(u[1] + v[1]), mpz_class(u[2] + v[2])};
}

Whole minus(const Whole& u, const Whole& v) {
  return {mpz_class(u[0] - v[0]), mpz_class(u[1] - v[1]), mpz_class(u[2] - v[2])};
}

Whole negative(const Whole& v) { return {mpz_class(-v[0]), mpz_class(-v[1]), mpz_class(-v[2])}; }

Whole cross(const Whole& u, const Whole& v) {
  return {mpz_class(u[1] * v[2] - u[2] * v[1]), mpz_class(u[2] * v[0] - u[0] * v[2]),
          mpz_class(u[0] * v[1] - u[1] * v[0])};
}

mpz_class dot(const Whole& u, const Whole& v) {
  mpz_class value = u[0] * v[0];
  value += u[1] * v[1];
  value += u[2] * v[2];
  return value;
}

int turn(const Whole& a, const Whole& b, const Whole& c, const Whole& normal) {
  return sgn(dot(cross(minus(b, a), minus(c, b)), normal));
}

std::vector<Whole> corners_of(const Ring& ring, const std::vector<Whole>& points) {
  std::vector<Whole> corners;
  for (const std::uint32_t v : ring) corners.push_back(points[v]);
  return corners;
}

Whole area_vector(const std::vector<Whole>& ring) {
  Whole area;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Whole part = cross(ring[i], ring[(i + 1) % ring.size()]);
    for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
  }
  return area;
}

bool is_zero(const Whole& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

Whole primitive(const Whole& v) {
  if (is_zero(v)) return v;
  const mpz_class divisor = gcd(gcd(v[0], v[1]), v[2]);
  return {mpz_class(v[0] / divisor), mpz_class(v[1] / divisor), mpz_class(v[2] / divisor)};
}

bool is_ring(const Ring& ring) {
  const std::set<std::uint32_t> different(ring.begin(), ring.end());
  return different.size() == ring.size() && ring.size() >= 3;
}

bool all_used(const std::vector<Ring>& rings, std::size_t end) {
  std::vector<bool> used(end);
  for (const Ring& ring : rings) {
    for (const std::uint32_t v : ring) used[v] = true;
  }
  return std::find(used.begin(), used.end(), false) == used.end();
}

std::vector<Whole> hull_in_plane(std::vector<Whole> points, const Whole& normal) {
  std::sort(points.begin(), points.end());
  std::vector<Whole> both;
  for (int run = 0; run < 2; ++run) {
    std::vector<Whole> chain;
    for (const Whole& p : points) {
      while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), p, normal) <= 0) {
        chain.pop_back();
      }
      chain.push_back(p);
    }
    both.insert(both.end(), chain.begin(), chain.end() - 1);
    std::reverse(points.begin(), points.end());
  }
  return both;
}

Triple triple(const Value& value) {
  const auto& three = items(value, 3);
  return {number(three[0]), number(three[1]), number(three[2])};
}

Whole times(const Triple& factors, const Triple& point) {
  Whole result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = mpq_class(factors[k] * point[k]).get_num();
  return result;
}

std::string to_text(const Triple& point) {
  return point[0].get_str() + ", " + point[1].get_str() + ", " + point[2].get_str();
}

namespace {

std::string list(const Ring& ring) {
  std::string text;
  for (const std::uint32_t v : ring) text += (text.empty() ? "" : ",") + std::to_string(v);
  return "[" + text + "]";
}

}  // namespace

std::string canonical_json(const std::vector<Ring>& faces, const std::vector<Triple>& vertices) {
  std::string first, second;
  for (const Ring& face : faces) first += (first.empty() ? "" : ",") + list(face);
  for (const Triple& v : vertices) {
    second += (second.empty() ? "[\"" : ",[\"") + v[0].get_str() + "\",\"" + v[1].get_str() +
              "\",\"" + v[2].get_str() + "\"]";
  }
  return "{\"faces\":[" + first + "],\"vertices\":[" + second + "]}";
}

namespace {

Body read_body(const Value& case_value, const std::string& name) {
  static const Value nothing;
  const auto found = std::find_if(case_value.members.begin(), case_value.members.end(),
                                  [&](const Member& member) { return member.name == name; });
  const auto parts =
      members(found == case_value.members.end() ? nothing : found->value, "vertices faces");
  Body body;
  body.name = name;
  for (const Value& vertex : items(*parts[0])) body.exact.push_back(triple(vertex));
  for (const Value& face : items(*parts[1])) {
    body.faces.push_back(indices(face, body.exact.size()));
  }
  require(!body.faces.empty(), name + " has no face");
  for (const Ring& face : body.faces) {
    require(is_ring(face), name + " has a face that is no ring");
  }
  require(all_used(body.faces, body.exact.size()), name + " has a vertex in no face");
  return body;
}

std::array<Body, 2> read_case_in_space(const Value& value) {
  require(value.kind == Value::Kind::object, "this is no case");
  const bool in_space =
      std::any_of(value.members.begin(), value.members.end(), [](const Member& member) {
        return member.name == "dimension" && member.value.kind == Value::Kind::integer &&
               member.value.text == "3";
      });
  require(in_space, "this is no case in space");
  Body P = read_body(value, "P");
  return {std::move(P), read_body(value, "Q")};
}

}  // namespace

InSpace open_in_space(const Value& certificate, const std::string& form,
                      const std::string& argument,
                      const std::function<Value(const std::string&)>& read_case) {
  require(has_form(certificate, form), "this is no " + form);
  const auto parts =
      members(certificate, "certificate title? comment? producer? case " + argument + " claims");
  for (const Value* told : {parts[1], parts[2], parts[3]}) {
    require(told->is_null() || told->kind == Value::Kind::text, "what carries no truth is no text");
  }
  const auto of = members(*parts[4], "path sha256");
  InSpace opened{read_case_in_space(read_case(path(*of[0]))), parts[5], parts[6]};
  std::string plain;
  for (const Body& body : opened.bodies) {
    plain += (plain.empty() ? "{\"" : ",\"") + body.name + "\":";
    plain += canonical_json(body.faces, body.exact);
  }
  demand(of[1]->kind == Value::Kind::text && sha256(plain + "}") == of[1]->text,
         "this is not the case that is certified");
  return opened;
}

void add_denominators(const std::vector<Triple>& points, mpz_class& unit, Budget& budget) {
  for (const Triple& point : points) {
    for (const mpq_class& c : point) unit = lcm(unit, c.get_den());
    budget.spend_unit(unit, points.size());
  }
}

}  // namespace minkref::checker
