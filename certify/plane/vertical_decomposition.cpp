#include "certify/plane/vertical_decomposition.hpp"

#include <algorithm>

namespace minkref::certify {
namespace {

class Sweep {
 public:
  Sweep(CellComplex& complex, const std::vector<DecomposingEdge>& edges) : complex_(complex) {
    edges_ = edges;
    const auto count = static_cast<std::uint32_t>(edges.size());
    edges_.push_back({nothing, nothing, 1, false});  // the box's bottom and top
    edges_.push_back({nothing, nothing, 3, false});
    active_ = {count, count + 1};
    left_ = {0};
  }

  Decomposition run(const std::vector<std::uint32_t>& corners) {
    std::vector<std::uint32_t> order = corners;
    const auto x_of = [&](std::uint32_t c) -> const Rational& {
      return complex_.corners()[c].place.point.x;
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const Point &p = complex_.corners()[a].place.point, &q = complex_.corners()[b].place.point;
      return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    order.erase(std::unique(order.begin(), order.end()), order.end());
    std::vector<std::vector<std::uint32_t>> starting(complex_.corners().size());
    for (std::uint32_t e = 0; e + 2 < edges_.size(); ++e) starting[edges_[e].from].push_back(e);
    for (std::size_t i = 0; i < order.size();) {
      std::size_t end = i;
      while (end < order.size() && x_of(order[end]) == x_of(order[i])) ++end;
      std::vector<std::uint32_t> fresh;
      for (std::size_t k = i; k < end; ++k) {
        const auto& here = starting[order[k]];
        fresh.insert(fresh.end(), here.begin(), here.end());
      }
      pass({order.begin() + static_cast<std::ptrdiff_t>(i),
            order.begin() + static_cast<std::ptrdiff_t>(end)},
           fresh);
      i = end;
    }
    for (std::size_t g = 0; g < left_.size(); ++g) close(g, 2);
    return std::move(result_);
  }

 private:
  /// A corner's side with respect to an active edge: 1 if the corner lies above.
  int above(std::uint32_t corner, std::uint32_t edge) const {
    const std::uint32_t line = edges_[edge].line;
    const Normal& n = complex_.normals()[complex_.lines()[line].normal];
    return complex_.side_of(line, corner) * sign(n.y);
  }

  /// Whether edge e leaves below edge f, both through one corner.
  bool lower(std::uint32_t e, std::uint32_t f) const {
    const Normal& n = complex_.normals()[complex_.lines()[edges_[e].line].normal];
    const Normal& m = complex_.normals()[complex_.lines()[edges_[f].line].normal];
    // Slopes -nx / ny and -mx / my.
    return Rational(-n.x, n.y) < Rational(-m.x, m.y);
  }

  void pass(const std::vector<std::uint32_t>& corners, const std::vector<std::uint32_t>& fresh) {
    const std::uint32_t wall = complex_.vertical_through(corners.front());
    // Gap g lies between active edges g and g + 1; those that a corner touches end here.
    std::vector<char> ends(left_.size());
    for (const std::uint32_t corner : corners) {
      const auto first = std::partition_point(
          active_.begin(), active_.end(), [&](std::uint32_t e) { return above(corner, e) > 0; });
      const auto last = std::partition_point(
          first, active_.end(), [&](std::uint32_t e) { return above(corner, e) == 0; });
      for (auto g = first - active_.begin() - 1; g < last - active_.begin(); ++g) {
        ends[static_cast<std::size_t>(g)] = 1;
      }
    }
    for (std::size_t g = 0; g < ends.size(); ++g) {
      if (ends[g]) close(g, wall);
    }
    struct Entry {
      std::uint32_t edge, left;
    };
    std::vector<Entry> next;  // with the wall on the left of the gap above it
    const auto done = [&](std::uint32_t e) {
      return edges_[e].to != nothing &&
             std::find(corners.begin(), corners.end(), edges_[e].to) != corners.end();
    };
    for (std::size_t i = 0; i < active_.size(); ++i) {
      if (done(active_[i])) continue;
      const bool goes_on = i < left_.size() && !ends[i];
      next.push_back({active_[i], goes_on ? left_[i] : wall});
    }
    for (const std::uint32_t e : fresh) {
      const auto place = std::partition_point(next.begin(), next.end(), [&](const Entry& other) {
        const int side = above(edges_[e].from, other.edge);
        return side != 0 ? side > 0 : lower(other.edge, e);
      });
      next.insert(place, {e, wall});
    }
    active_.clear();
    left_.clear();
    for (const Entry& entry : next) {
      active_.push_back(entry.edge);
      left_.push_back(entry.left);
    }
    left_.pop_back();  // nothing is above the top
  }

  void close(std::size_t gap, std::uint32_t wall) {
    const DecomposingEdge &low = edges_[active_[gap]], &high = edges_[active_[gap + 1]];
    Cell cell;
    const std::array<std::uint32_t, 4> around{low.line, wall, high.line, left_[gap]};
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i] = complex_.meet(around[(i + 3) % 4], around[i]);
    for (std::size_t i = 0; i < 4; ++i) {
      if (corners[i] == corners[(i + 1) % 4]) continue;
      cell.corners.push_back(corners[i]);
      cell.lines.push_back(around[i]);
    }
    (low.inside_above ? result_.inside : result_.outside).push_back(std::move(cell));
  }

  CellComplex& complex_;
  std::vector<DecomposingEdge> edges_;
  std::vector<std::uint32_t> active_;  ///< edges, from the bottom to the top
  std::vector<std::uint32_t> left_;    ///< the wall on the left of each gap
  Decomposition result_;
};

}  // namespace

Decomposition vertical_decomposition(CellComplex& complex,
                                     const std::vector<DecomposingEdge>& edges,
                                     const std::vector<std::uint32_t>& corners) {
  return Sweep(complex, edges).run(corners);
}

}  // namespace minkref::certify
