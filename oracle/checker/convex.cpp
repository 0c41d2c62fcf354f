#include "oracle/checker/convex.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "oracle/checker/reading.hpp"
#include "oracle/checker/sha256.hpp"

namespace minkref::checker {
namespace {

constexpr const char* form = "convex-certificate-v1";

using Whole = std::array<mpz_class, 3>;
using Triple = std::array<mpq_class, 3>;
using Ring = std::vector<std::uint32_t>;

Whole minus(const Whole& u, const Whole& v) {
  return {mpz_class(u[0] - v[0]), mpz_class(u[1] - v[1]), mpz_class(u[2] - v[2])};
}

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

/// Positive if the way a b c turns left, seen against the normal.
int turn(const Whole& a, const Whole& b, const Whole& c, const Whole& normal) {
  return sgn(dot(cross(minus(b, a), minus(c, b)), normal));
}

std::vector<Whole> corners_of(const Ring& ring, const std::vector<Whole>& points) {
  std::vector<Whole> corners;
  for (const std::uint32_t v : ring) corners.push_back(points[v]);
  return corners;
}

/// Twice the area, to the side from which the ring runs counter-clockwise.
Whole area_vector(const std::vector<Whole>& ring) {
  Whole area;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Whole part = cross(ring[i], ring[(i + 1) % ring.size()]);
    for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
  }
  return area;
}

bool is_zero(const Whole& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

/// The shortest whole vector in this direction.
Whole primitive(const Whole& v) {
  const mpz_class divisor = gcd(gcd(v[0], v[1]), v[2]);
  return {mpz_class(v[0] / divisor), mpz_class(v[1] / divisor), mpz_class(v[2] / divisor)};
}

/// The points that are farthest along a normal, and how far they are.
struct Farthest {
  mpz_class height;
  Ring points;

  Farthest(const Whole& normal, const std::vector<Whole>& among) {
    mpz_class value;  // one for all: most of the time of a check is spent here
    for (std::uint32_t i = 0; i < among.size(); ++i) {
      mpz_mul(value.get_mpz_t(), normal[0].get_mpz_t(), among[i][0].get_mpz_t());
      mpz_addmul(value.get_mpz_t(), normal[1].get_mpz_t(), among[i][1].get_mpz_t());
      mpz_addmul(value.get_mpz_t(), normal[2].get_mpz_t(), among[i][2].get_mpz_t());
      const int higher = points.empty() ? 1 : cmp(value, height);
      if (higher < 0) continue;
      if (higher > 0) points.clear();
      height = value;
      points.push_back(i);
    }
  }
};

bool is_ring(const Ring& ring) {
  const std::set<std::uint32_t> different(ring.begin(), ring.end());
  return different.size() == ring.size() && ring.size() >= 3;
}

/// Whether each directed edge is in one ring only, and its reverse in one.
bool is_closed(const std::vector<Ring>& rings) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges, reverses;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t a = ring[i], b = ring[(i + 1) % ring.size()];
      edges.emplace_back(a, b);
      reverses.emplace_back(b, a);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(reverses.begin(), reverses.end());
  return edges == reverses && std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

/// Whether all numbers below `end` occur.
bool all_used(const std::vector<Ring>& rings, std::size_t end) {
  std::vector<bool> used(end);
  for (const Ring& ring : rings) {
    for (const std::uint32_t v : ring) used[v] = true;
  }
  return std::find(used.begin(), used.end(), false) == used.end();
}

/// The corners of the hull of points in a plane, in which lexicographic order is a sweep.
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

/// The products, which are whole numbers.
Whole times(const Triple& factors, const Triple& point) {
  Whole result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = mpq_class(factors[k] * point[k]).get_num();
  return result;
}

std::string list(const Ring& ring) {
  std::string text;
  for (const std::uint32_t v : ring) text += (text.empty() ? "" : ",") + std::to_string(v);
  return "[" + text + "]";
}

/// What is hashed.
std::string canonical_json(const std::vector<Ring>& faces, const std::vector<Triple>& vertices) {
  std::string first, second;
  for (const Ring& face : faces) first += (first.empty() ? "" : ",") + list(face);
  for (const Triple& v : vertices) {
    second += (second.empty() ? "[\"" : ",[\"") + v[0].get_str() + "\",\"" + v[1].get_str() +
              "\",\"" + v[2].get_str() + "\"]";
  }
  return "{\"faces\":[" + first + "],\"vertices\":[" + second + "]}";
}

/// A polyhedron, its vertices and faces in the order of the file.
struct Body {
  std::string name;
  std::vector<Triple> exact;
  std::vector<Whole> points;  ///< in units that make them whole
  std::vector<Ring> faces;
};

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

/// Follows an inner part; what is wrong there is said with its place.
template <class Use>
void within(const std::string& place, Use&& use) {
  try {
    use();
  } catch (const NotVerified& error) {
    throw NotVerified(error.code, place + ": " + error.what());
  }
}

/// Whether the faces go once around the convex hull of the vertices.
void check_body(const Body& body, Budget& budget) {
  const std::set<Whole> different(body.points.begin(), body.points.end());
  require(different.size() == body.points.size(), body.name + " has a point twice");
  require(is_closed(body.faces), body.name + " is not closed");
  Whole first;
  std::vector<Whole> at_top;
  mpz_class covered;
  std::size_t n = 0;
  for (const Ring& face : body.faces) {
    within(body.name + ", face " + std::to_string(n), [&] {
      const auto corners = corners_of(face, body.points);
      const Whole area = area_vector(corners);
      require(!is_zero(area), "it has no area");
      const Whole normal = primitive(area);
      budget.spend(body.points.size());
      const mpz_class height = dot(normal, corners[0]);
      for (const Whole& v : corners) require(dot(normal, v) == height, "it is not planar");
      const Farthest farthest(normal, body.points);
      require(height == farthest.height, "a vertex lies above its plane");
      if (n == 0) {
        require(farthest.points.size() < body.points.size(), "all vertices lie in its plane");
        first = normal;
        at_top = corners_of(farthest.points, body.points);
      }
      if (normal == first) covered += dot(area, first);
    });
    ++n;
  }
  require(covered == dot(area_vector(hull_in_plane(at_top, first)), first),
          body.name + " goes around its hull more than once");
}

/// The sum at a scaling: a closed surface, each vertex S p + q, each facet in a plane that P and Q,
/// where they are farthest along its normal, reach together.
class Sum {
 public:
  Sum(const Value& value, const Body& P, const Body& Q, const mpz_class& unit, Budget& budget) {
    const auto parts = members(value, "scaling vertices facets");
    scaling_ = triple(*parts[0]);
    for (const mpq_class& factor : scaling_) {
      require(factor > 0, "a factor of the scaling is not positive");
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const Value& entry : items(*parts[1])) {
      const auto& pair = items(entry, 2);
      pairs.emplace_back(index(pair[0], P.exact.size()), index(pair[1], Q.exact.size()));
    }
    read_facets(*parts[2], pairs.size(), P, Q);
    budget.spend(P.exact.size() + Q.exact.size() + pairs.size());
    move(P, Q, unit);
    for (const auto& [p, q] : pairs) {
      points_.push_back({mpz_class(P_[p][0] + Q_[q][0]), mpz_class(P_[p][1] + Q_[q][1]),
                         mpz_class(P_[p][2] + Q_[q][2])});
    }
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      demand(points_[i] < points_[i + 1], "the vertices do not ascend");
    }
    demand(is_closed(rings_), "the facets are not closed");
    for (std::size_t n = 0; n < rings_.size(); ++n) {
      within("facet " + std::to_string(n), [&] {
        budget.spend(P.exact.size() + Q.exact.size());
        check_facet(n);
      });
    }
  }

  const Triple& scaling() const { return scaling_; }

  std::string check_claim(const std::vector<const Value*>& claim) const {
    demand(triple(*claim[2]) == scaling_, "the sum is at another scaling");
    const mpz_class vertices = integer(*claim[3]), facets = integer(*claim[4]);
    demand(vertices == points_.size() && facets == rings_.size(),
           "vertices or facets are not so many");
    mpq_class volume(sextuple_, 6 * unit_ * unit_ * unit_);
    volume.canonicalize();
    demand(number(*claim[5]) == volume, "the volume is another");
    std::vector<Triple> exact;
    for (const Whole& point : points_) {
      Triple& vertex = exact.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        vertex[k] = mpq_class(point[k], unit_);
        vertex[k].canonicalize();
      }
    }
    const std::string digest = sha256(canonical_json(rings_, exact));
    demand(claim[6]->kind == Value::Kind::text && claim[6]->text == digest,
           "the digest is another");
    return "sum: at (" + scaling_[0].get_str() + ", " + scaling_[1].get_str() + ", " +
           scaling_[2].get_str() + "), " + vertices.get_str() + " vertices, " + facets.get_str() +
           " facets, volume " + volume.get_str() + ", " + digest;
  }

 private:
  void read_facets(const Value& value, std::size_t vertices, const Body& P, const Body& Q) {
    for (const Value& facet : items(value)) {
      const auto& parts = items(facet, 3);
      rings_.push_back(indices(parts[0], vertices));
      of_P_.push_back(indices(parts[1], P.exact.size()));
      of_Q_.push_back(indices(parts[2], Q.exact.size()));
    }
    require(!rings_.empty(), "there is no facet");
    for (const Ring& ring : rings_) {
      require(is_ring(ring), "a facet is no ring");
      require(ring[0] == *std::min_element(ring.begin(), ring.end()),
              "a facet does not begin with its least vertex");
    }
    require(std::is_sorted(rings_.begin(), rings_.end()), "the facets do not ascend");
    require(all_used(rings_, vertices), "a vertex is in no facet");
  }

  /// The vertices of both operands, P scaled, in units that make them whole.
  void move(const Body& P, const Body& Q, const mpz_class& unit) {
    mpz_class common = 1;
    for (const mpq_class& factor : scaling_) common = lcm(common, factor.get_den());
    unit_ = unit * common;
    const mpq_class whole(unit_);
    const Triple same{whole, whole, whole};
    Triple scaled;
    for (std::size_t k = 0; k < 3; ++k) scaled[k] = scaling_[k] * whole;
    for (const Triple& p : P.exact) P_.push_back(times(scaled, p));
    for (const Triple& q : Q.exact) Q_.push_back(times(same, q));
  }

  void check_facet(std::size_t n) {
    const Ring& ring = rings_[n];
    const auto corners = corners_of(ring, points_);
    const Whole area = area_vector(corners);
    demand(!is_zero(area), "it has no area");
    const Whole normal = primitive(area);
    demand(normals_.insert(normal).second, "another facet has its normal");
    const mpz_class level = dot(normal, corners[0]);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      demand(dot(normal, corners[i]) == level, "it is not planar");
      demand(turn(corners[i], corners[(i + 1) % ring.size()], corners[(i + 2) % ring.size()],
                  normal) > 0,
             "it does not turn left");
    }
    const Farthest of_P(normal, P_), of_Q(normal, Q_);
    demand(of_P.height + of_Q.height == level, "the sum reaches beyond its plane");
    demand(of_P.points == of_P_[n] && of_Q.points == of_Q_[n],
           "other vertices of P or Q are farthest");
    sextuple_ += dot(area, corners[0]);
  }

  Triple scaling_;
  std::vector<Ring> rings_, of_P_, of_Q_;
  std::vector<Whole> P_, Q_, points_;
  mpz_class unit_, sextuple_;
  std::set<Whole> normals_;
};

/// What makes all coordinates whole.
mpz_class common_unit(const std::array<Body, 2>& bodies, Budget& budget) {
  mpz_class unit = 1;
  for (const Body& body : bodies) {
    for (const Triple& point : body.exact) {
      for (const mpq_class& c : point) unit = lcm(unit, c.get_den());
      budget.spend(1 + mpz_sizeinbase(unit.get_mpz_t(), 2) / 64);
    }
  }
  return unit;
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

std::vector<Sum> follow(const Value& sums, const std::array<Body, 2>& bodies, const mpz_class& unit,
                        Budget& budget) {
  std::vector<Sum> found;
  std::set<Triple> scalings;
  for (const Value& sum : items(sums)) {
    within("sum " + std::to_string(found.size()),
           [&] { found.emplace_back(sum, bodies[0], bodies[1], unit, budget); });
    scalings.insert(found.back().scaling());
  }
  require(scalings.size() == found.size(), "two sums are at one scaling");
  return found;
}

std::vector<std::string> check_claims(const Value& claims, const std::vector<Sum>& sums,
                                      Budget& budget) {
  std::set<std::string> different;
  for (const Value& claim : items(claims)) {
    require(different.insert(written_out(claim)).second, "a claim is made twice");
  }
  std::vector<std::string> said;
  std::set<std::uint32_t> used;
  for (const Value& claim : items(claims)) {
    within("claim " + std::to_string(said.size()), [&] {
      budget.spend(64);
      const auto parts = members(claim, "claim sum scaling vertices facets volume digest");
      require(parts[0]->kind == Value::Kind::text && parts[0]->text == "sum",
              "there is no such claim");
      const std::uint32_t of = index(*parts[1], sums.size());
      used.insert(of);
      said.push_back(sums[of].check_claim(parts));
    });
  }
  require(!said.empty() && used.size() == sums.size(), "nothing is claimed, or a sum is not used");
  return said;
}

}  // namespace

bool is_convex_certificate(const Value& certificate) {
  return std::any_of(certificate.members.begin(), certificate.members.end(), [](const Member& m) {
    return m.name == "certificate" && m.value.kind == Value::Kind::text && m.value.text == form;
  });
}

std::vector<std::string> check_convex(const Value& certificate,
                                      const std::function<Value(const std::string&)>& read_case,
                                      Budget& budget) {
  require(is_convex_certificate(certificate), std::string("this is no ") + form);
  const auto parts = members(certificate, "certificate title? comment? producer? case sums claims");
  for (const Value* told : {parts[1], parts[2], parts[3]}) {
    require(told->is_null() || told->kind == Value::Kind::text, "what carries no truth is no text");
  }
  const auto of = members(*parts[4], "path sha256");
  std::array<Body, 2> bodies = read_case_in_space(read_case(path(*of[0])));
  std::string plain;
  for (const Body& body : bodies) {
    plain += (plain.empty() ? "{\"" : ",\"") + body.name + "\":";
    plain += canonical_json(body.faces, body.exact);
  }
  demand(of[1]->kind == Value::Kind::text && sha256(plain + "}") == of[1]->text,
         "this is not the case that is certified");
  const mpz_class unit = common_unit(bodies, budget);
  const mpq_class whole(unit);
  for (Body& body : bodies) {
    for (const Triple& point : body.exact) {
      body.points.push_back(times({whole, whole, whole}, point));
    }
    check_body(body, budget);
  }
  const std::vector<Sum> sums = follow(*parts[5], bodies, unit, budget);
  return check_claims(*parts[6], sums, budget);
}

}  // namespace minkref::checker
