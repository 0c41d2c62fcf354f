#include "oracle/checker/space/convex.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "oracle/checker/sha256.hpp"
#include "oracle/checker/space/space.hpp"

namespace minkref::checker {
namespace {

constexpr const char* form = "convex-certificate-v1";

/// The points farthest along a normal, and their height.
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

/// Whether each directed edge occurs once, and its reverse occurs once.
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

/// A sum at a scaling: a closed surface with vertices S p + q. Each facet lies in the plane reached
/// by the points of P and Q farthest along its normal.
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
    return "sum: at (" + to_text(scaling_) + "), " + vertices.get_str() + " vertices, " +
           facets.get_str() + " facets, volume " + volume.get_str() + ", " + digest;
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

  /// Scales P, and makes the vertices of both operands whole by a common unit.
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

std::vector<Sum> follow(const Value& sums, const std::array<Body, 2>& bodies, const mpz_class& unit,
                        Budget& budget) {
  std::vector<Sum> found;
  for (const Value& sum : items(sums)) {
    within("sum " + std::to_string(found.size()),
           [&] { found.emplace_back(sum, bodies[0], bodies[1], unit, budget); });
  }
  return found;
}

}  // namespace

bool is_convex_certificate(const Value& certificate) { return has_form(certificate, form); }

std::vector<std::string> check_convex(const Value& certificate,
                                      const std::function<Value(const std::string&)>& read_case,
                                      Budget& budget) {
  InSpace opened = open_in_space(certificate, form, "sums", read_case);
  mpz_class unit = 1;
  for (const Body& body : opened.bodies) add_denominators(body.exact, unit, budget);
  const mpq_class whole(unit);
  for (Body& body : opened.bodies) {
    for (const Triple& point : body.exact) {
      body.points.push_back(times({whole, whole, whole}, point));
    }
    check_body(body, budget);
  }
  const std::vector<Sum> sums = follow(*opened.argument, opened.bodies, unit, budget);
  return check_claims(*opened.claims, sums, "vertices facets volume digest", budget);
}

}  // namespace minkref::checker
