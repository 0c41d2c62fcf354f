#include "certify/plane/piece_tree.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "reference/plane/routes/simply_connected.hpp"

namespace minkref::certify {
namespace {

int turn(const Point& a, const Point& b, const Point& c) {
  return sign(Rational((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x)));
}

using Ids = std::vector<std::uint32_t>;

/// The vertices of the convex hull, counter-clockwise.
Ids hull_of(Ids ids, const std::vector<Place>& at) {
  std::sort(ids.begin(), ids.end(), [&](std::uint32_t i, std::uint32_t j) {
    const Point &a = at[i].point, &b = at[j].point;
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  ids.erase(
      std::unique(ids.begin(), ids.end(),
                  [&](std::uint32_t i, std::uint32_t j) { return at[i].point == at[j].point; }),
      ids.end());
  if (ids.size() < 3) return ids;
  Ids hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const std::uint32_t i : ids) {
      while (hull.size() > first + 1 &&
             turn(at[hull[hull.size() - 2]].point, at[hull.back()].point, at[i].point) <= 0) {
        hull.pop_back();
      }
      hull.push_back(i);
    }
    hull.pop_back();
    std::reverse(ids.begin(), ids.end());
  }
  return hull;
}

/// Merges pieces across edges while they stay convex (Hertel & Mehlhorn 1983).
std::vector<Ids> merged(std::vector<Ids> pieces, const std::vector<Place>& at) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> owner;
  for (std::uint32_t n = 0; n < pieces.size(); ++n) {
    for (std::size_t i = 0; i < pieces[n].size(); ++i) {
      owner[{pieces[n][i], pieces[n][(i + 1) % pieces[n].size()]}] = n;
    }
  }
  std::vector<std::uint32_t> parent(pieces.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto find = [&](std::uint32_t n) {
    while (parent[n] != n) n = parent[n] = parent[parent[n]];
    return n;
  };
  for (const auto& [edge, n] : owner) {
    const auto other = owner.find({edge.second, edge.first});
    if (edge.first > edge.second || other == owner.end()) continue;
    const std::uint32_t a = find(n), b = find(other->second);
    if (a == b) continue;
    // a runs ... before, u, v, after ...; b runs ... v, u ...
    Ids &x = pieces[a], &y = pieces[b];
    std::rotate(x.begin(), std::find(x.begin(), x.end(), edge.second), x.end());  // v ... u
    std::rotate(y.begin(), std::find(y.begin(), y.end(), edge.first), y.end());   // u ... v
    const auto straight_or_left = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      return turn(at[i].point, at[j].point, at[k].point) >= 0;
    };
    if (x.back() != edge.first || y.back() != edge.second) continue;
    if (!straight_or_left(x[x.size() - 2], x.back(), y[1])) continue;
    if (!straight_or_left(y[y.size() - 2], y.back(), x[1])) continue;
    x.insert(x.end(), y.begin() + 1, y.end() - 1);
    y.clear();
    parent[b] = a;
  }
  std::erase_if(pieces, [](const Ids& piece) { return piece.empty(); });
  return pieces;
}

}  // namespace

PieceTree::PieceTree(const PolygonSet& set, NormalTable& normals) : normals_(normals) {
  for (const Polygon& polygon : set.polygons) {
    for (const Point& p : polygon.outer) vertices_.emplace_back(p);
    for (const Ring& hole : polygon.holes) {
      for (const Point& p : hole) vertices_.emplace_back(p);
    }
  }
  add_pieces(set);
  pieces_ = nodes_.size();
  if (pieces_ < 2) return;
  Ids all(pieces_);
  std::iota(all.begin(), all.end(), 0U);
  group(std::move(all));
}

void PieceTree::add_pieces(const PolygonSet& set) {
  if (set.empty()) return;
  std::vector<Ids> pieces;
  if (!set.is_region()) {
    pieces.push_back(set.is_point() ? Ids{0} : Ids{0, 1});
  } else {
    const auto less = [](const Point& a, const Point& b) {
      return a.x != b.x ? a.x < b.x : a.y < b.y;
    };
    std::map<Point, std::uint32_t, decltype(less)> id(less);
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) id.try_emplace(vertices_[i].point, i);
    for (const Triangle& t : triangulate(set)) {
      pieces.push_back({id.at(t[0]), id.at(t[1]), id.at(t[2])});
    }
    pieces = merged(std::move(pieces), vertices_);
  }
  for (Ids& piece : pieces) {
    Node node;
    node.hull = std::move(piece);
    add_node(std::move(node));
  }
}

std::uint32_t PieceTree::group(Ids items) {
  if (items.size() == 1) return items.front();
  Box box;
  for (const std::uint32_t i : items) box.add(nodes_[i].box);
  const bool wide = box.xmax - box.xmin >= box.ymax - box.ymin;
  const auto middle = [&](std::uint32_t i) {
    const Box& b = nodes_[i].box;
    const double sum = wide ? b.xmin + b.xmax : b.ymin + b.ymax;
    return std::isnan(sum) ? 0 : sum;  // the sum of opposite infinities
  };
  const auto half = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
  std::sort(items.begin(), items.end(), [&](std::uint32_t i, std::uint32_t j) {
    return middle(i) != middle(j) ? middle(i) < middle(j) : i < j;
  });
  Node node;
  node.is_piece = false;
  node.children = {group(Ids(items.begin(), half)), group(Ids(half, items.end()))};
  Ids both = nodes_[node.children[0]].hull;
  both.insert(both.end(), nodes_[node.children[1]].hull.begin(),
              nodes_[node.children[1]].hull.end());
  node.hull = hull_of(std::move(both), vertices_);
  add_node(std::move(node));
  return root();
}

void PieceTree::add_node(Node node) {
  for (const std::uint32_t i : node.hull) {
    const Place& p = vertices_[i];
    node.box.add({below(p.x), below(p.y), above(p.x), above(p.y)});
  }
  node.extent = std::max(node.box.xmax - node.box.xmin, node.box.ymax - node.box.ymin);
  auto& outward = outward_.emplace_back();
  for (std::size_t i = 0; node.hull.size() > 1 && i < node.hull.size(); ++i) {
    const Point& a = vertices_[node.hull[i]].point;
    const Point& b = vertices_[node.hull[(i + 1) % node.hull.size()]].point;
    const std::uint32_t normal = normals_.add(b.y - a.y, a.x - b.x);
    if (outward.empty() || outward.back() != normal) outward.push_back(normal);
  }
  nodes_.push_back(std::move(node));
}

const Value& PieceTree::most(std::uint32_t node, std::uint32_t normal) const {
  const auto [place, fresh] = most_.try_emplace(std::uint64_t{node} << 32 | normal);
  if (!fresh) return place->second;
  const Normal& n = normals_[normal];
  std::optional<Value> best;
  for (const std::uint32_t i : nodes_[node].hull) {
    if (!best || side(n, vertices_[i], *best) > 0) best = Value(dot(n, vertices_[i].point));
  }
  return place->second = *best;
}

}  // namespace minkref::certify
