#include <algorithm>
#include <tuple>

#include "reference/plane/passages/tight_graph.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {
namespace {

using Contacts = std::vector<ConvolutionEdge>;

bool sequence_less(const std::vector<Point>& a, const std::vector<Point>& b) {
  return std::lexicographical_compare(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const Point& p, const Point& q) { return compare_xy(p, q) < 0; });
}

auto key(const ConvolutionEdge& e) {
  return std::tuple(e.kind, e.edge.ring, e.edge.index, e.vertex.ring, e.vertex.index);
}

void sort_contacts(Contacts& contacts) {
  std::sort(contacts.begin(), contacts.end(),
            [](const auto& a, const auto& b) { return key(a) < key(b); });
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

bool collinear(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x);
}

/// Joins the contacts of neighbouring segments on a common line. Such segments continue straight in
/// an arrangement. The first vertex stays.
TightPassage without_collinear_vertices(TightPassage chain) {
  TightPassage result;
  for (std::size_t i = 0; i < chain.points.size(); ++i) {
    const std::size_t n = result.points.size();
    if (n >= 2 && collinear(result.points[n - 2], result.points[n - 1], chain.points[i])) {
      result.points.back() = chain.points[i];
      Contacts& before = result.contacts.back();
      before.insert(before.end(), chain.contacts[i - 1].begin(), chain.contacts[i - 1].end());
    } else {
      result.points.push_back(chain.points[i]);
      if (i > 0) result.contacts.push_back(std::move(chain.contacts[i - 1]));
    }
  }
  return result;
}

class Chains {
 public:
  explicit Chains(const TightGraph& graph)
      : graph_(graph), edges_at_(graph.points.size()), used_(graph.edges.size(), false) {
    for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
      const auto& edge = graph.edges[e];
      edges_at_[edge.from].push_back(e);
      if (edge.to != edge.from) edges_at_[edge.to].push_back(e);
    }
  }

  std::vector<TightPassage> all() {
    for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
      const auto& edge = graph_.edges[e];
      if (edge.from != edge.to) continue;
      used_[e] = true;
      add({{graph_.points[edge.from]}, {edge.contacts}});
    }
    for (std::uint32_t p = 0; p < graph_.points.size(); ++p) {
      if (!passed(p)) follow_all(p);
    }
    // The remaining passages are closed, without ends: each begins at its smallest vertex, never a
    // straight vertex.
    std::vector<std::uint32_t> order;
    for (std::uint32_t p = 0; p < graph_.points.size(); ++p) order.push_back(p);
    std::sort(order.begin(), order.end(), [&](std::uint32_t p, std::uint32_t q) {
      return compare_xy(graph_.points[p], graph_.points[q]) < 0;
    });
    for (const std::uint32_t p : order) follow_all(p);
    std::sort(passages_.begin(), passages_.end(),
              [](const auto& a, const auto& b) { return sequence_less(a.points, b.points); });
    return std::move(passages_);
  }

 private:
  bool passed(std::uint32_t point) const { return edges_at_[point].size() == 2; }

  void follow_all(std::uint32_t start) {
    for (const std::uint32_t e : edges_at_[start]) {
      if (!used_[e]) add(followed(start, e));
    }
  }

  TightPassage followed(std::uint32_t start, std::uint32_t first) {
    TightPassage chain{{graph_.points[start]}, {}};
    std::uint32_t at = start;
    for (std::uint32_t e = first;;) {
      used_[e] = true;
      at = graph_.edges[e].from == at ? graph_.edges[e].to : graph_.edges[e].from;
      chain.points.push_back(graph_.points[at]);
      chain.contacts.push_back(graph_.edges[e].contacts);
      if (at == start || !passed(at)) return without_collinear_vertices(std::move(chain));
      e = edges_at_[at][0] == e ? edges_at_[at][1] : edges_at_[at][0];
    }
  }

  void add(TightPassage passage) {
    const std::vector<Point> backwards(passage.points.rbegin(), passage.points.rend());
    if (sequence_less(backwards, passage.points)) {
      passage.points = backwards;
      std::reverse(passage.contacts.begin(), passage.contacts.end());
    }
    for (Contacts& contacts : passage.contacts) sort_contacts(contacts);
    passages_.push_back(std::move(passage));
  }

  const TightGraph& graph_;
  std::vector<std::vector<std::uint32_t>> edges_at_;
  std::vector<bool> used_;
  std::vector<TightPassage> passages_;
};

}  // namespace

std::vector<TightPassage> passages_along(const TightGraph& graph) { return Chains(graph).all(); }

}  // namespace minkref::inline plane
