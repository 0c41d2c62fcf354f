// Facets at one scale, with nodes and traces from the list: input for the arrangements.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/paper/space/crossings.hpp"

namespace minkref::inline space {

/// Corners and sides of the facets by number, the same at all scales: facets that share a corner or
/// a side have its number in common.
struct FacetNames {
  static constexpr std::uint32_t none = UINT32_MAX;
  struct Names {
    std::size_t size = 0;
    std::array<std::uint32_t, 4> corners{}, sides{};  ///< side k from corner k to the next
  };
  std::vector<Names> facets;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;  ///< corners, ascending
  std::size_t corners = 0;

  template <class Facets>
  explicit FacetNames(const Facets& all) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> number, side_number;
    for (const auto& facet : all) {
      Names& names = facets.emplace_back();
      names.size = facet.size();
      for (std::size_t k = 0; k < facet.size(); ++k) {
        const auto next = static_cast<std::uint32_t>(number.size());
        names.corners[k] = number.try_emplace({facet[k].of_P, facet[k].of_Q}, next).first->second;
      }
      for (std::size_t k = 0; k < facet.size(); ++k) {
        const std::pair<std::uint32_t, std::uint32_t> ends =
            std::minmax({names.corners[k], names.corners[(k + 1) % facet.size()]});
        const auto [found, fresh] =
            side_number.try_emplace(ends, static_cast<std::uint32_t>(sides.size()));
        if (fresh) sides.push_back(ends);
        names.sides[k] = found->second;
      }
    }
    corners = number.size();
  }
};

/// A segment on a facet, between two nodes: shared with a crossing facet, or a coplanar facet's
/// side.
struct Trace {
  std::uint32_t from, to;
  std::uint32_t other;  ///< the crossing facet; FacetNames::none for a coplanar side
};

template <class T>
class PlacedFacets {
 public:
  using Facet = typename TwoFacets<T>::Facet;
  using Vector = typename TwoFacets<T>::Vector;

  /// Places corners, and listed crossings by x0 + (s - 1) sigma. A side and a facet share a single
  /// node, whichever facet brings the side; a node rounded beyond the side counts as the side's
  /// end. `list` numbers `crossings`. O(n log n).
  PlacedFacets(const std::vector<Facet>& facets, const FacetNames& names,
               const std::vector<Crossing<T>>& crossings,
               const std::vector<std::pair<std::uint32_t, std::uint32_t>>& coplanar,
               std::vector<std::uint32_t> list, const T& scale)
      : traces(facets.size()), names_(names), nodes_on_(names.sides.size()) {
    points.resize(names.corners);
    for (std::size_t f = 0; f < facets.size(); ++f) {
      for (std::size_t k = 0; k < facets[f].size(); ++k) {
        points[names.facets[f].corners[k]] = facets[f][k].q + facets[f][k].p * scale;
      }
    }
    std::sort(list.begin(), list.end());
    for (std::size_t k = 0, end = 0; k < list.size(); k = end) {
      look_for_interrupt();
      const Crossing<T>& first = crossings[list[k]];
      ends_.clear();
      for (end = k; end < list.size() && crossings[list[end]].first == first.first &&
                    crossings[list[end]].second == first.second;
           ++end) {
        take(crossings[list[end]], scale);
      }
      if (!ends_.empty()) add_trace(first.first, first.second);
    }
    for (const auto& [a, b] : coplanar) add_corners_inside(a, b);
    sort_nodes();
  }

  Vector normal(std::uint32_t facet) const {
    const Vector& a = corner(facet, 0);
    return Vector(corner(facet, 1) - a).cross(Vector(corner(facet, 2) - a));
  }
  const Vector& corner(std::uint32_t facet, std::size_t k) const {
    const auto& names = names_.facets[facet];
    return points[names.corners[k % names.size]];
  }
  std::size_t size(std::uint32_t facet) const { return names_.facets[facet].size; }
  std::size_t facet_count() const { return traces.size(); }

  /// The facet's border, node by node, from its first corner on.
  std::vector<std::uint32_t> border(std::uint32_t facet) const {
    const auto& names = names_.facets[facet];
    std::vector<std::uint32_t> ring;
    for (std::size_t k = 0; k < names.size; ++k) {
      const auto& inner = nodes_on_[names.sides[k]];
      ring.push_back(names.corners[k]);
      if (names.corners[k] == names_.sides[names.sides[k]].first) {
        ring.insert(ring.end(), inner.begin(), inner.end());
      } else {
        ring.insert(ring.end(), inner.rbegin(), inner.rend());
      }
    }
    return ring;
  }

  /// Whether the facet holds a point on the facet's plane. As exact as T.
  bool holds(std::uint32_t facet, const Vector& x) const {
    const Vector n = normal(facet);
    for (std::size_t k = 0; k < size(facet); ++k) {
      const Vector inwards = n.cross(Vector(corner(facet, k + 1) - corner(facet, k)));
      if (sign(T(inwards.dot(Vector(x - corner(facet, k))))) < 0) return false;
    }
    return true;
  }

  std::vector<Vector> points;              ///< by node: corners first
  std::vector<std::vector<Trace>> traces;  ///< by facet

 private:
  void take(const Crossing<T>& crossing, const T& scale) {
    using Kind = typename Crossing<T>::Kind;
    const std::uint32_t a = crossing.first, b = crossing.second;
    if (crossing.is_point()) {
      ends_.push_back(node_of(crossing, scale));
    } else if (crossing.kind == Kind::at_one_scale) {
      for (std::size_t k = 0; k < size(b); ++k) add_side(a, b, k);
      for (std::size_t k = 0; k < size(a); ++k) add_side(b, a, k);
    } else {
      add_side(a, b, crossing.other_side);
      add_side(b, a, crossing.side);
    }
  }

  std::uint32_t node_of(const Crossing<T>& crossing, const T& scale) {
    const std::uint32_t side = names_.facets[crossing.owner()].sides[crossing.side];
    const auto [found, fresh] =
        nodes_.try_emplace((std::uint64_t{side} << 32) | crossing.other(), FacetNames::none);
    if (!fresh) return found->second;
    const auto& [from, to] = names_.sides[side];
    const Vector along = points[to] - points[from];
    const Vector x = crossing.x.at(scale);
    if (sign(T(along.dot(Vector(x - points[from])))) <= 0) return found->second = from;
    if (sign(T(along.dot(Vector(points[to] - x)))) <= 0) return found->second = to;
    found->second = static_cast<std::uint32_t>(points.size());
    points.push_back(x);
    nodes_on_[side].push_back(found->second);
    return found->second;
  }

  void add_side(std::uint32_t facet, std::uint32_t other, std::size_t k) {
    const auto& names = names_.facets[other];
    traces[facet].push_back(
        {names.corners[k], names.corners[(k + 1) % names.size], FacetNames::none});
  }

  /// Joins the outermost points among crossings and common corners.
  void add_trace(std::uint32_t a, std::uint32_t b) {
    const auto& of_a = names_.facets[a];
    const auto& of_b = names_.facets[b];
    for (std::size_t k = 0; k < of_a.size; ++k) {
      const auto* end = of_b.corners.data() + of_b.size;
      if (std::find(of_b.corners.data(), end, of_a.corners[k]) != end) {
        ends_.push_back(of_a.corners[k]);
      }
    }
    const Vector along = normal(a).cross(normal(b));
    const auto before = [&](std::uint32_t u, std::uint32_t v) {
      return sign(T(along.dot(Vector(points[v] - points[u])))) > 0;
    };
    const auto [low, high] = std::minmax_element(ends_.begin(), ends_.end(), before);
    if (*low == *high) return;
    traces[a].push_back({*low, *high, b});
    traces[b].push_back({*low, *high, a});
  }

  /// Adds the sides at a corner inside a coplanar facet.
  void add_corners_inside(std::uint32_t a, std::uint32_t b) {
    look_for_interrupt();
    for (const auto& [facet, other] : {std::pair{a, b}, {b, a}}) {
      for (std::size_t k = 0; k < size(other); ++k) {
        if (!holds(facet, corner(other, k))) continue;
        add_side(facet, other, k);
        add_side(facet, other, (k + size(other) - 1) % size(other));
      }
    }
  }

  void sort_nodes() {
    for (std::size_t side = 0; side < nodes_on_.size(); ++side) {
      const auto& [from, to] = names_.sides[side];
      const Vector along = points[to] - points[from];
      std::stable_sort(nodes_on_[side].begin(), nodes_on_[side].end(),
                       [&](std::uint32_t u, std::uint32_t v) {
                         return sign(T(along.dot(Vector(points[v] - points[u])))) > 0;
                       });
    }
  }

  const FacetNames& names_;
  std::vector<std::vector<std::uint32_t>> nodes_on_;  ///< each side's inner nodes, from its start
  std::unordered_map<std::uint64_t, std::uint32_t> nodes_;
  std::vector<std::uint32_t> ends_;  ///< of the pair at hand
};

}  // namespace minkref::inline space
