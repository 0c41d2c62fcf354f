#include "certify/plane/covering.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/interrupt.hpp"

namespace minkref::certify {
namespace {

constexpr std::size_t most_candidates = 256;  // candidates examined before the best is taken
constexpr int most_points = 256;              // tried per cell, until a sum of pieces holds one

struct Flat {
  double x, y;
};

/// The doubled area that remains from a polygon where normal * x <= h for some (normal, h). Used
/// only for choices.
class Clip {
 public:
  explicit Clip(std::vector<Flat> polygon) : polygon_(std::move(polygon)) {}

  void below(double nx, double ny, double h) {
    std::vector<Flat> rest;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Flat &a = polygon_[i], &b = polygon_[(i + 1) % polygon_.size()];
      const double va = nx * a.x + ny * a.y - h, vb = nx * b.x + ny * b.y - h;
      if (va <= 0) rest.push_back(a);
      if (va * vb < 0) {
        const double t = va / (va - vb);
        rest.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
    }
    polygon_ = std::move(rest);
  }
  double doubled_area() const {
    double area = 0;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Flat &a = polygon_[i], &b = polygon_[(i + 1) % polygon_.size()];
      const Flat& o = polygon_[0];
      area += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
    }
    return area;
  }

 private:
  std::vector<Flat> polygon_;
};

}  // namespace

Covering::Covering(CellComplex& complex) : complex_(complex) {
  const double s = to_double(complex.scale());
  const PieceTree &P = complex.P(), &Q = complex.Q();
  std::vector<Box> boxes;
  for (std::uint32_t a = 0; a < P.pieces(); ++a) {
    for (std::uint32_t b = 0; b < Q.pieces(); ++b) {
      boxes.push_back(sum_of(scaled(P.nodes()[a].box, below(s), above(s)), Q.nodes()[b].box));
      pairs_.emplace_back(a, b);
    }
  }
  tree_ = BoxTree(std::move(boxes));
}

bool Covering::holds_inside(std::uint32_t A, std::uint32_t B, const Place& place) const {
  for (const PieceTree* tree : {&complex_.P(), &complex_.Q()}) {
    for (const std::uint32_t normal : tree->outward(tree == &complex_.P() ? A : B)) {
      const Normal& n = complex_.normals()[normal];
      const auto most = complex_.estimate(A, B, normal);
      const double left = n.dx * place.x, right = n.dy * place.y;
      const double value = left + right - most.value;
      const double bound = (std::abs(left) + std::abs(right)) * 0x1p-49 + most.error;
      if (value < -bound) continue;
      if (value > bound || dot(n, place.point) >= complex_.most(A, B, normal)) return false;
    }
  }
  return true;
}

std::optional<Covering::Candidate> Covering::best_for(const Cell& cell) const {
  std::vector<Flat> flat;
  for (const std::uint32_t c : cell.corners) {
    const Place& place = complex_.corners()[c].place;
    flat.push_back({place.x, place.y});
  }
  // Points inside the cell, weighting the corners with powers of a number. A line holds the points
  // of two numbers at most, since a walk around the corners crosses the line twice at most.
  for (int number = 1; number <= most_points; ++number) {
    Rational x = 0, y = 0, weights = 0, weight = 1;
    for (const std::uint32_t c : cell.corners) {
      const Point& p = complex_.corners()[c].place.point;
      x += weight * p.x;
      y += weight * p.y;
      weights += weight;
      weight *= number;
    }
    const Place inner(Point{x / weights, y / weights});
    std::optional<Candidate> best;
    double best_area = 0;
    std::size_t looked = 0;
    const Box box{below(inner.x), below(inner.y), above(inner.x), above(inner.y)};
    tree_.query(box, [&](std::uint32_t pair) {
      const std::uint32_t A = pairs_[pair].first, B = pairs_[pair].second;
      if (!holds_inside(A, B, inner)) return false;
      Candidate candidate{A, B, {}};
      Clip clip(flat);
      for (const PieceTree* tree : {&complex_.P(), &complex_.Q()}) {
        for (const std::uint32_t normal : tree->outward(tree == &complex_.P() ? A : B)) {
          const bool exceeds = std::any_of(
              cell.corners.begin(), cell.corners.end(),
              [&](std::uint32_t c) { return complex_.side_of_pair(A, B, normal, c) > 0; });
          if (!exceeds) continue;
          const Normal& n = complex_.normals()[normal];
          clip.below(n.dx, n.dy, complex_.estimate(A, B, normal).value);
          candidate.exceeded.push_back(normal);
        }
      }
      const bool whole = candidate.exceeded.empty();
      const double area = clip.doubled_area();
      if (!best || whole || area > best_area) {
        best = std::move(candidate);
        best_area = area;
      }
      return whole || ++looked >= most_candidates;
    });
    if (best) return best;
  }
  return std::nullopt;
}

std::uint32_t Covering::edge_of_pair(std::uint32_t A, std::uint32_t B, std::uint32_t normal) {
  const PieceTree &P = complex_.P(), &Q = complex_.Q();
  const auto edge =
      [&](const PieceTree& tree,
          std::uint32_t node) -> std::optional<std::pair<std::uint32_t, std::uint32_t>> {
    // A hull lists normals in the order of its edges, but merges consecutive equal normals.
    const auto& hull = tree.nodes()[node].hull;
    for (std::size_t i = 0; hull.size() > 1 && i < hull.size(); ++i) {
      const std::uint32_t a = hull[i], b = hull[(i + 1) % hull.size()];
      const Point &p = tree.vertices()[a].point, &q = tree.vertices()[b].point;
      if (complex_.normals().add(q.y - p.y, p.x - q.x) == normal) return std::pair(a, b);
    }
    return std::nullopt;
  };
  const auto furthest = [&](const PieceTree& tree, std::uint32_t node) {
    const auto& hull = tree.nodes()[node].hull;
    const Value& most = tree.most(node, normal);
    return *std::find_if(hull.begin(), hull.end(), [&](std::uint32_t i) {
      return side(complex_.normals()[normal], tree.vertices()[i], most) == 0;
    });
  };
  if (const auto of_P = edge(P, A)) {
    return complex_.line({LineSource::Kind::P, of_P->first, of_P->second, furthest(Q, B)});
  }
  const auto of_Q = edge(Q, B);
  return complex_.line({LineSource::Kind::Q, of_Q->first, of_Q->second, furthest(P, A)});
}

std::vector<CoveredCell> Covering::cover(Cell cell) {
  std::vector<CoveredCell> covered;
  std::vector<Cell> open{std::move(cell)};
  while (!open.empty()) {
    look_for_interrupt();
    Cell part = std::move(open.back());
    open.pop_back();
    const std::optional<Candidate> best = best_for(part);
    if (!best) throw std::logic_error("a cell of the sum is in no sum of pieces");
    for (const std::uint32_t normal : best->exceeded) {
      const std::uint32_t line = edge_of_pair(best->A, best->B, normal);
      CellComplex::Parts parts = complex_.cut(part, line);
      // A line's normal is turned so that x, or else y, is positive.
      if (complex_.lines()[line].normal != normal) std::swap(parts.below, parts.above);
      if (parts.above) open.push_back(std::move(*parts.above));
      if (!parts.below) throw std::logic_error("a cut leaves nothing inside");
      part = std::move(*parts.below);
    }
    covered.push_back({std::move(part), best->A, best->B});
  }
  return covered;
}

}  // namespace minkref::certify
