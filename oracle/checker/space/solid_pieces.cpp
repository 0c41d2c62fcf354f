#include "oracle/checker/space/solid_pieces.hpp"

#include <algorithm>
#include <tuple>

namespace minkref::checker {
namespace {

using Ends = std::pair<Whole, Whole>;

std::vector<Ends> edges_of(const std::vector<Whole>& ring) {
  std::vector<Ends> edges;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    edges.emplace_back(ring[k], ring[(k + 1) % ring.size()]);
  }
  return edges;
}

/// For each line on each plane: each point's count as an end, minus its count as a start.
class Boundary {
 public:
  void add(const Whole& normal, const std::vector<Whole>& ring, int times_, Budget& budget) {
    budget.spend(ring.size());
    const Whole plane = std::max(normal, negative(normal));
    const mpz_class offset = dot(plane, ring[0]);
    for (const auto& [a, b] : edges_of(ring)) {
      Whole way = primitive(minus(b, a));
      way = std::max(way, negative(way));
      const Whole moment = cross(way, a);
      ends_[{plane, offset, way, moment, b}] += times_;
      ends_[{plane, offset, way, moment, a}] -= times_;
    }
  }
  bool is_nothing() const {
    return std::all_of(ends_.begin(), ends_.end(), [](const auto& end) { return end.second == 0; });
  }

 private:
  std::map<std::tuple<Whole, mpz_class, Whole, Whole, Whole>, long> ends_;
};

}  // namespace

Hull::Hull(std::vector<Whole> corners, Budget& budget) : points(std::move(corners)) {
  const std::set<Whole> different(points.begin(), points.end());
  require(different.size() == points.size() && points.size() > 3,
          "a point is there twice, or there are under 4");
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        budget.spend(points.size());
        Whole n = primitive(cross(minus(points[j], points[i]), minus(points[k], points[i])));
        if (is_zero(n)) continue;
        std::vector<mpz_class> levels;
        for (const Whole& p : points) levels.push_back(dot(n, p));
        const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
        require(*low < *high, "its points lie in a plane");
        if (levels[i] != *low && levels[i] != *high) continue;
        if (levels[i] != *high) n = negative(n);
        if (facets.count(n) > 0) continue;
        std::vector<Whole> at;
        for (std::size_t m = 0; m < points.size(); ++m) {
          if (levels[m] == levels[i]) at.push_back(points[m]);
        }
        facets[n] = hull_in_plane(std::move(at), n);
      }
    }
  }
  std::set<Whole> found;
  for (const auto& [normal, ring] : facets) {
    found.insert(ring.begin(), ring.end());
    for (const auto& [a, b] : edges_of(ring)) edges.emplace(std::min(a, b), std::max(a, b));
  }
  require(found.size() == points.size(), "one of its points is no corner");
  for (const auto& [a, b] : edges) ways.insert(primitive(minus(b, a)));
}

mpz_class Hull::support(const Whole& normal) const {
  mpz_class most = dot(normal, points[0]);
  for (const Whole& p : points) most = std::max(most, dot(normal, p));
  return most;
}

bool Hull::holds(const Whole& point) const {
  return std::all_of(facets.begin(), facets.end(), [&](const auto& facet) {
    return dot(facet.first, point) <= dot(facet.first, facet.second[0]);
  });
}

PieceList read_pieces(const Value& value, const Body& body) {
  const auto parts = members(value, "points hulls");
  PieceList list{body.exact, {}};
  for (const Value& point : items(*parts[0])) list.points.push_back(triple(point));
  std::vector<bool> used(list.points.size());
  for (const Value& hull : items(*parts[1])) list.hulls.push_back(indices(hull, used.size()));
  require(!list.hulls.empty(), body.name + " has no pieces");
  for (const Ring& hull : list.hulls) {
    const bool ascends = std::is_sorted(hull.begin(), hull.end()) &&
                         std::adjacent_find(hull.begin(), hull.end()) == hull.end();
    require(ascends, "the points of a piece do not ascend");
    for (const std::uint32_t i : hull) used[i] = true;
  }
  const auto added = used.begin() + static_cast<std::ptrdiff_t>(body.exact.size());
  require(std::find(added, used.end(), false) == used.end(), "a point is in no piece");
  return list;
}

std::vector<Hull> hulls_of(const PieceList& list, const std::vector<Whole>& points,
                           Budget& budget) {
  std::vector<Hull> hulls;
  for (const Ring& hull : list.hulls) hulls.emplace_back(corners_of(hull, points), budget);
  return hulls;
}

void check_tiling(const Body& body, const std::vector<Hull>& pieces, Budget& budget) {
  Boundary boundary;
  for (const Hull& piece : pieces) {
    for (const auto& [normal, ring] : piece.facets) boundary.add(normal, ring, 1, budget);
  }
  for (std::size_t i = 0; i < body.faces.size(); ++i) {
    within(body.name + ", face " + std::to_string(i), [&] {
      const std::vector<Whole> ring = corners_of(body.faces[i], body.points);
      const Whole normal = primitive(area_vector(ring));
      require(!is_zero(normal), "it has no area");
      for (const Whole& p : ring) {
        require(dot(normal, p) == dot(normal, ring[0]), "it is not planar");
      }
      boundary.add(normal, ring, -1, budget);
    });
  }
  demand(boundary.is_nothing(), "the pieces of " + body.name + " do not tile it");
}

SolidPieces::SolidPieces(std::vector<Hull> hulls, Budget& budget) : hulls_(std::move(hulls)) {
  std::map<Whole, std::vector<std::uint32_t>> at;  // of each corner: the pieces that have it
  for (const Hull& hull : hulls_) {
    for (const Whole& p : hull.points) {
      if (at.count(p) > 0) continue;
      budget.spend(hulls_.size());
      std::vector<std::uint32_t>& holders = at[p];
      for (std::uint32_t k = 0; k < hulls_.size(); ++k) {
        if (hulls_[k].holds(p)) holders.push_back(k);
      }
    }
  }
  const auto add = [&](Feature feature) {
    std::sort(feature.begin(), feature.end());
    if (holders_.count(feature) > 0) return;
    std::vector<std::uint32_t> common = at[feature[0]];
    for (const Whole& p : feature) {
      const std::vector<std::uint32_t>& other = at[p];
      std::erase_if(common, [&](std::uint32_t k) {
        return !std::binary_search(other.begin(), other.end(), k);
      });
    }
    holders_.emplace(std::move(feature), std::move(common));
  };
  for (const Hull& hull : hulls_) {
    for (const Whole& p : hull.points) add({p});
    for (const auto& [a, b] : hull.edges) add({a, b});
    for (const auto& [normal, ring] : hull.facets) add(ring);
  }
  for (const auto& [feature, holders] : holders_) {
    if (feature.size() != 2) continue;
    Edge& edge = edges_.emplace_back(Edge{&feature, {}});
    for (const std::uint32_t k : holders) {
      edge.around.insert(hulls_[k].points.begin(), hulls_[k].points.end());
    }
  }
}

std::vector<mpz_class> SolidPieces::supports(const Whole& normal) const {
  std::vector<mpz_class> found;
  for (const Hull& hull : hulls_) found.push_back(hull.support(normal));
  return found;
}

std::vector<std::pair<const Feature*, mpz_class>> SolidPieces::tops(const Whole& normal,
                                                                    Budget& budget) const {
  budget.spend(holders_.size());
  const std::vector<mpz_class> most = supports(normal);
  std::vector<std::pair<const Feature*, mpz_class>> found;
  for (const auto& [feature, holders] : holders_) {
    const mpz_class level = dot(normal, feature[0]);
    const bool top = std::all_of(feature.begin(), feature.end(),
                                 [&](const Whole& p) { return dot(normal, p) == level; }) &&
                     std::all_of(holders.begin(), holders.end(),
                                 [&](std::uint32_t k) { return most[k] <= level; });
    if (top) found.emplace_back(&feature, level);
  }
  return found;
}

bool SolidPieces::Edge::is_top(const Whole& normal, mpz_class& height) const {
  height = dot(normal, (*ends)[0]);
  return std::all_of(around.begin(), around.end(),
                     [&](const Whole& p) { return dot(normal, p) <= height; });
}

std::set<Whole> SolidPieces::normals() const {
  std::set<Whole> found;
  for (const Hull& hull : hulls_) {
    for (const auto& [normal, ring] : hull.facets) found.insert(normal);
  }
  return found;
}

}  // namespace minkref::checker
