#include "oracle/checker/disc/bridges.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "oracle/checker/disc/disc_edges.hpp"

namespace minkref::checker {
namespace {

constexpr const char* feature_form = "feature-certificate-v1";

struct Feature {
  bool is_edge = false;
  std::uint32_t number = 0;
  friend auto operator<=>(const Feature&, const Feature&) = default;
  std::string name() const { return (is_edge ? "edge " : "vertex ") + std::to_string(number); }
};

using Edges = std::set<std::uint32_t>;

/// Discs outside P that share a squared radius. An edge has the number of its first vertex.
class Discs : DiscEdges {
 public:
  Discs(const Operand& P, const mpq_class& square, Budget& budget) : DiscEdges(P, square, budget) {
    for (const Point& p : at_) ++times_[{p.x, p.y}];
  }

  std::string claim(const Value& claim) {
    budget_.spend(64);
    require(claim.kind == Value::Kind::object, "a claim is no object");
    for (const auto& [name, value] : claim.members) {
      if (name != "claim" || value.kind != Value::Kind::text) continue;
      if (value.text == "bridge") return bridge(claim);
      if (value.text == "touch") return touch(claim);
    }
    throw NotVerified(Code::malformed, "there is no such claim");
  }

 private:
  Feature feature(const Value& value) const {
    const auto& pair = items(value, 2);
    const std::string& kind = text(pair[0]);
    require(kind == "vertex" || kind == "edge", "a feature is a vertex or an edge");
    return {kind == "edge", index(pair[1], at_.size())};
  }

  /// Demands that a feature is in P, and that all centres lie in front of it: their nearest point
  /// of the edges returned is inside the edge (`closed`: or one of its ends), or the vertex.
  Edges touched(const Feature& feature, const std::vector<Point>& centres, bool closed) const {
    const std::uint32_t n = feature.number;
    if (feature.is_edge) {
      for (const Point& p : centres) {
        const mpq_class over = dot(minus(p, at_[n]), along(n));
        const mpq_class length = dot(along(n), along(n));
        const bool is_inside = closed ? over >= 0 && over <= length : over > 0 && over < length;
        demand(is_inside, "a centre is not in front of its edge");
        demand(height(n, p) > 0, "a centre is not right of its edge");
      }
      return {n};
    }
    const Point& v = at_[n];
    const std::uint32_t before = last_[n];
    demand(times_.at({v.x, v.y}) == 1, "rings touch at a vertex");
    const int turn = sgn(cross(along(before), along(n)));
    const bool goes_on = turn == 0 && dot(along(before), along(n)) > 0;
    for (const Point& p : centres) {
      demand(turn > 0 || (goes_on && height(n, p) > 0), "P is not convex at a vertex");
      const bool is_ahead = dot(minus(p, v), along(n)) > 0 || dot(minus(p, v), along(before)) < 0;
      demand(!is_ahead, "a centre is nearer to an edge than to its vertex");
    }
    return {before, n};
  }

  /// Whether all points between two are nearer to the feature than the radius, or farther.
  bool lies(const Feature& feature, const Point& a, const Point& b, bool nearer) const {
    const std::uint32_t n = feature.number;
    const auto is_good = [&](const mpq_class& far, const mpq_class& square) {
      return nearer ? far < square : far > square;
    };
    if (feature.is_edge) {
      const mpq_class square = square_ * dot(along(n), along(n));
      const mpq_class at_a = height(n, a), at_b = height(n, b);
      return is_good(at_a * at_a, square) && is_good(at_b * at_b, square);
    }
    const Point& v = at_[n];
    if (!nearer) return squared_distance(v, a, b) > square_;
    return dot(minus(a, v), minus(a, v)) < square_ && dot(minus(b, v), minus(b, v)) < square_;
  }

  std::string bridge(const Value& claim) {
    const auto m = members(claim, "claim left right box");
    const Feature one = feature(*m[1]), other = feature(*m[2]);
    require(one != other, "a bridge has one feature twice");
    const auto& box = items(*m[3], 3);
    const Point p = point(box[0]), u = point(box[1]), w = point(box[2]);
    const Point q = plus(p, u), s = plus(p, w), t = plus(q, w);
    require(cross(u, w) != 0, "a box is flat");
    for (const Point& across : {minus(t, p), minus(s, q)}) {
      demand(dot(across, across) < square_, "a box is wider than the radius");
    }
    const std::vector<Point> corners{p, q, t, s};
    Edges own = touched(one, corners, false);
    own.merge(touched(other, corners, false));
    demand(lies(one, p, s, true) && lies(one, q, t, false) && lies(other, p, q, true) &&
               lies(other, s, t, false),
           "no centre in the box is as far from both features as the radius");
    for (std::uint32_t n = 0; n < at_.size(); ++n) {
      if (own.contains(n)) continue;
      budget_.spend(8);
      const Point &a = at_[n], &b = at_[next_[n]];
      bool is_far = true;
      for (std::size_t i = 0; i < 4; ++i) {
        const Point &c = corners[i], &d = corners[(i + 1) % 4];
        is_far = is_far && squared_distance(c, a, b) > square_ &&
                 squared_distance(a, c, d) > square_ && squared_distance(b, c, d) > square_;
      }
      demand(is_far, "edge " + std::to_string(n) + " may be in the disc");
    }
    demand(winds(p) == 0, "a centre is not outside of P");
    return "bridge from " + one.name() + " to " + other.name() + of_radius();
  }

  /// A disc that touches P at these features, and no other.
  std::string touch(const Value& claim) {
    const auto m = members(claim, "claim centre features");
    const Point c = point(*m[1]);
    std::set<Feature> named;
    Edges own;
    for (const Value& value : items(*m[2])) {
      const Feature one = feature(value);
      require(named.insert(one).second, "a feature is named twice");
    }
    require(named.size() >= 2, "a disc touches two features or more");
    for (const Feature& one : named) own.merge(touched(one, {c}, true));
    for (std::uint32_t n = 0; n < at_.size(); ++n) {
      budget_.spend(1);
      const mpq_class far = squared_distance(c, at_[n], at_[next_[n]]);
      demand(own.contains(n) ? far == square_ : far > square_,
             "edge " + std::to_string(n) + " is not as far from the centre as it should be");
    }
    demand(winds(c) == 0, "a centre is not outside of P");
    return "disc about (" + c.x.get_str() + ", " + c.y.get_str() + ") that touches " +
           std::to_string(named.size()) + " features" + of_radius();
  }

  std::map<std::pair<mpq_class, mpq_class>, int> times_;
};

}  // namespace

bool is_feature_certificate(const Value& certificate) {
  return has_form(certificate, feature_form);
}

std::vector<std::string> check_features(const Value& certificate,
                                        const std::function<Value(const std::string&)>& read_case,
                                        Budget& budget) {
  return check_discs(certificate, read_case, [&](const Operand& P, const mpq_class& square) {
    const auto discs = std::make_shared<Discs>(P, square, budget);
    return [discs](const Value& claim) { return discs->claim(claim); };
  });
}

}  // namespace minkref::checker
