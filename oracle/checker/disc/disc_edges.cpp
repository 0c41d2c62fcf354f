#include "oracle/checker/disc/disc_edges.hpp"

#include <algorithm>
#include <utility>

#include "oracle/checker/following.hpp"
#include "oracle/checker/sha256.hpp"

namespace minkref::checker {

Point nearest(const Point& p, const Point& a, const Point& b) {
  const Point along = minus(b, a);
  const mpq_class length = dot(along, along), over = dot(along, minus(p, a));
  if (over <= 0) return a;
  if (over >= length) return b;
  const mpq_class part = over / length;
  return {a.x + part * along.x, a.y + part * along.y};
}

mpq_class squared_distance(const Point& p, const Point& a, const Point& b) {
  const Point off = minus(p, nearest(p, a, b));
  return dot(off, off);
}

DiscEdges::DiscEdges(const Operand& P, mpq_class square, Budget& budget)
    : at_(P.exact), square_(std::move(square)), budget_(budget) {
  require(!P.thin && !P.rings.empty(), "P is no region");
  next_.resize(at_.size());
  last_.resize(at_.size());
  for (const auto& ring : P.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t from = ring[i], to = ring[(i + 1) % ring.size()];
      require(!(at_[from] == at_[to]), "an edge is zero");
      next_[from] = to;
      last_[to] = from;
    }
  }
}

int DiscEdges::winds(const Point& p, const Point& way, std::uint32_t but) const {
  int winds = 0;
  for (std::uint32_t n = 0; n < count(); ++n) {
    if (n == but) continue;
    const mpq_class low = cross(way, minus(at_[n], p)), high = cross(way, minus(at_[next_[n]], p));
    if ((low <= 0) == (high <= 0)) continue;
    const int side = sgn(height(n, p));
    if (high > low && side < 0) ++winds;
    if (high < low && side > 0) --winds;
  }
  return winds;
}

std::vector<std::string> check_discs(const Value& certificate,
                                     const std::function<Value(const std::string&)>& read_case,
                                     const MakeProof& make) {
  const auto m = members(certificate, "certificate title? comment? producer? case square claims");
  for (const Value* telling : {m[1], m[2], m[3]}) {
    require(telling->is_null() || telling->kind == Value::Kind::text,
            "what carries no truth is no text");
  }
  const auto of = members(*m[4], "path sha256");
  const Value value = read_case(path(*of[0]));
  require(value.kind == Value::Kind::object, "this is no case");
  const auto given = std::find_if(value.members.begin(), value.members.end(),
                                  [](const auto& member) { return member.name == "P"; });
  require(given != value.members.end(), "this is no case");
  const Operand P = read_operand(given->value, "P");
  demand(of[1]->kind == Value::Kind::text && sha256("{\"P\":" + P.plain + "}") == of[1]->text,
         "this is not the case that is certified");
  const mpq_class square = number(*m[5]);
  require(square > 0, "the squared radius is not positive");
  const FollowClaim follow = make(P, square);
  require(!items(*m[6]).empty(), "nothing is claimed");
  require_different(*m[6]);
  std::vector<std::string> said;
  for (const Value& claim : items(*m[6])) {
    within("claim " + std::to_string(said.size()), [&] { said.push_back(follow(claim)); });
  }
  return said;
}

}  // namespace minkref::checker
