#include "oracle/checker/unions/unions.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "oracle/checker/following.hpp"
#include "oracle/checker/sha256.hpp"
#include "oracle/checker/unions/sides.hpp"

namespace minkref::checker {
namespace {

constexpr const char* union_form = "union-certificate-v1";

const Value* member_of(const Value& value, const std::string& name) {
  for (const Member& member : value.members) {
    if (member.name == name) return &member.value;
  }
  return nullptr;
}

std::string word_of(const Value& value, const std::string& name) {
  const Value* found = member_of(value, name);
  return found != nullptr && found->kind == Value::Kind::text ? found->text : "";
}

/// Sets, and claims about them. [set, vertex] names a vertex, or the edge that begins there.
class Union {
 public:
  Union(std::vector<Operand> sets, Budget& budget) : sets_(std::move(sets)), budget_(budget) {
    for (const Operand& set : sets_) {
      sides_.push_back(sides_of(set));
      auto& ends = ends_.emplace_back(set.exact.size());
      for (const auto& ring : set.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) ends[ring[i]] = ring[(i + 1) % ring.size()];
      }
    }
  }

  std::string follow(const Value& claim) {
    require(claim.kind == Value::Kind::object, "a claim is no object");
    budget_.spend(64);
    const std::string kind = word_of(claim, "claim");
    if (kind == "union") return kind + whole(claim);
    if (kind == "point") return kind + point_of(claim);
    if (kind == "meet") return kind + meet(claim);
    if (kind == "overlap") return kind + overlap(claim);
    if (kind == "sign") return kind + sign(claim);
    throw NotVerified(Code::malformed, "there is no claim " + kind);
  }

 private:
  using Name = std::pair<std::uint32_t, std::uint32_t>;

  Name name(const Value& value) const {
    const auto& pair = items(value, 2);
    const std::uint32_t k = index(pair[0], sets_.size());
    return {k, index(pair[1], sets_[k].exact.size())};
  }
  const Point& at(const Name& vertex) const { return sets_[vertex.first].exact[vertex.second]; }
  Side side(const Name& edge) const {
    return {at(edge), sets_[edge.first].exact[ends_[edge.first][edge.second]]};
  }

  /// union: the union is the set bounded by these polygons. All edges, cut where they meet, part
  /// the plane into faces; each face has a piece of an edge at its boundary.
  std::string whole(const Value& claim) {
    const auto m = members(claim, "claim polygons");
    Value value;
    value.kind = Value::Kind::object;
    value.members.push_back({"polygons", *m[1]});
    const Sides bounds = sides_of(read_operand(value, "the union"));
    std::set<std::array<mpq_class, 4>> different;
    const auto add = [&](const Sides& sides) {
      for (const auto& [a, b] : sides) different.insert({a.x, a.y, b.x, b.y});
    };
    add(bounds);
    std::for_each(sides_.begin(), sides_.end(), add);
    Sides every;
    for (const auto& [a, b, c, d] : different) every.push_back({{a, b}, {c, d}});
    for (const Side& one : every) {
      budget_.spend(every.size());
      std::set<mpq_class> places;
      for (const Side& other : every) {
        for (const mpq_class& t : cuts(one, other)) places.insert(t);
      }
      for (auto it = places.begin(); std::next(it) != places.end(); ++it) {
        check_sides(one, (*it + *std::next(it)) / 2, bounds);
        budget_.spend(2 * every.size());
      }
    }
    return ": " + std::to_string(bounds.size()) + " edges";
  }

  void check_sides(const Side& one, const mpq_class& t, const Sides& bounds) const {
    const Point u = minus(one.to, one.from), p{one.from.x + t * u.x, one.from.y + t * u.y};
    for (const Point& beside : {Point{-u.y, u.x}, Point{u.y, -u.x}}) {
      const bool held = std::any_of(sides_.begin(), sides_.end(), [&](const Sides& sides) {
        return winding(sides, p, beside) > 0;
      });
      demand(winding(bounds, p, beside) == (held ? 1 : 0),
             "the sides differ at (" + p.x.get_str() + ", " + p.y.get_str() + ")");
    }
  }

  /// point: the sets with a point inside, and those with an edge through it.
  std::string point_of(const Value& claim) {
    const auto m = members(claim, "claim point inside on");
    const Point p = point(*m[1]);
    std::vector<mpz_class> inside, on;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      budget_.spend(2 * sides_[k].size());
      const bool passes = std::any_of(sides_[k].begin(), sides_[k].end(), [&](const Side& one) {
        return one.from == p || is_inside(one, p);
      });
      if (passes) on.emplace_back(k);
      if (!passes && winding(sides_[k], p, {0, 0}) > 0) inside.emplace_back(k);
    }
    demand(numbers(*m[3]) == on, "edges of other sets pass the point");
    demand(numbers(*m[2]) == inside, "other sets have it inside");
    return ": (" + p.x.get_str() + ", " + p.y.get_str() + ")";
  }

  static std::vector<mpz_class> numbers(const Value& value) {
    std::vector<mpz_class> found;
    for (const Value& entry : items(value)) found.push_back(integer(entry));
    return found;
  }

  /// meet: a point is each of some vertices, and inside each of some edges.
  std::string meet(const Value& claim) {
    const auto m = members(claim, "claim point vertices edges");
    const Point p = point(*m[1]);
    std::set<Name> names;
    std::set<std::uint32_t> of_sets;
    for (const Value* list : {m[2], m[3]}) {
      for (const Value& entry : items(*list)) {
        const Name named = name(entry);
        demand(list == m[2] ? at(named) == p : is_inside(side(named), p), "it is elsewhere");
        require(names.insert(named).second, "one is named twice");
        of_sets.insert(named.first);
      }
    }
    require(of_sets.size() > 1, "one set, or none, is named");
    return ": at (" + p.x.get_str() + ", " + p.y.get_str() + ")";
  }

  /// overlap: edges of two sets have a stretch in common.
  std::string overlap(const Value& claim) {
    const auto m = members(claim, "claim edges way");
    const auto& edges = items(*m[1], 2);
    const Name first = name(edges[0]), second = name(edges[1]);
    require(first.first != second.first, "one set is named");
    const Side one = side(first), other = side(second);
    const Point u = minus(one.to, one.from), v = minus(other.to, other.from);
    demand(cross(u, v) == 0 && cross(u, minus(other.from, one.from)) == 0, "they lie on two lines");
    const mpq_class a = dot(u, minus(other.from, one.from)), b = dot(u, minus(other.to, one.from));
    demand(std::min(a, b) < dot(u, u) && std::max(a, b) > 0, "they have no stretch in common");
    demand(integer(*m[2]) == sgn(dot(u, v)), "they run the other way");
    return "";
  }

  /// sign: of a predicate on vertices.
  std::string sign(const Value& claim) {
    const auto m = members(claim, "claim of sign");
    const auto& parts = items(*m[1], 2);
    const std::string kind = parts[0].kind == Value::Kind::text ? parts[0].text : "";
    require(kind == "orientation" || kind == "concurrent", "there is no such predicate");
    std::vector<Row> rows;
    for (const Value& entry : items(parts[1], 3)) {
      if (kind == "orientation") {
        rows.push_back(row(entry));
      } else {
        const auto& line = items(entry, 2);
        const Row u = row(line[0]), v = row(line[1]);
        require(u != v, "a line has one point given twice");
        rows.push_back(across(u, v));
      }
    }
    const Row last = across(rows[1], rows[2]);
    const mpq_class value = rows[0][0] * last[0] + rows[0][1] * last[1] + rows[0][2] * last[2];
    demand(integer(*m[2]) == sgn(value), "it has another sign");
    return "";
  }

  using Row = std::array<mpq_class, 3>;
  Row row(const Value& value) const {
    const Point& p = at(name(value));
    return {p.x, p.y, 1};
  }
  static Row across(const Row& u, const Row& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }

  std::vector<Operand> sets_;
  Budget& budget_;
  std::vector<Sides> sides_;
  std::vector<std::vector<std::uint32_t>> ends_;
};

}  // namespace

bool is_union_certificate(const Value& certificate) {
  return word_of(certificate, "certificate") == union_form;
}

std::vector<std::string> check_unions(const Value& certificate,
                                      const std::function<Value(const std::string&)>& read_case,
                                      Budget& budget) {
  const auto m = members(certificate, "certificate title? comment? producer? case claims");
  for (const Value* telling : {m[1], m[2], m[3]}) {
    require(telling->is_null() || telling->kind == Value::Kind::text,
            "what carries no truth is no text");
  }
  const auto of = members(*m[4], "path sha256");
  const Value value = read_case(path(*of[0]));
  const Value* found = member_of(value, "sets");
  require(found != nullptr, "this is no case");
  std::vector<Operand> sets;
  std::string plain;
  for (const Value& entry : items(*found)) {
    sets.push_back(read_operand(entry, "set " + std::to_string(sets.size())));
    plain += (plain.empty() ? "" : ",") + sets.back().plain;
  }
  demand(of[1]->kind == Value::Kind::text && sha256("{\"sets\":[" + plain + "]}") == of[1]->text,
         "this is not the case that is certified");
  Union proof(std::move(sets), budget);
  require_different(*m[5]);
  std::vector<std::string> said;
  for (const Value& claim : items(*m[5])) {
    within("claim " + std::to_string(said.size()), [&] { said.push_back(proof.follow(claim)); });
  }
  require(!said.empty(), "nothing is claimed");
  return said;
}

}  // namespace minkref::checker
