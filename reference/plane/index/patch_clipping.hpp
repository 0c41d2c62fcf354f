// The nodes of a patch, reduced to places where its edge may touch the boundary.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "reference/plane/index/patch_cells.hpp"
#include "reference/plane/index/patch_nodes.hpp"
#include "reference/plane/kernel/fraction.hpp"

namespace minkref::inline plane {

/// If many nodes pass a cell, the cell is halved as long as halving proves parts inside, by discs
/// or by pairs of convex pieces; nodes keep the scales at which they pass a remaining cell. The
/// removed parts lie inside: a face that they enlarge stays uniform.
template <class K>
class PatchClipping {
 public:
  PatchClipping(const std::vector<RationalEdge>& moving, const InteriorTracks& tracks,
                const InteriorSolids& solids)
      : moving_(moving), tracks_(tracks), solids_(solids) {}

  /// Leaves patches with few nodes unchanged.
  void clip(std::uint32_t edge, std::span<const PatchCell> cells, PatchNodes<K>& nodes) {
    if (nodes.nodes.size() < worth_it) return;
    edge_ = rounded(moving_[edge]);
    pair_ = {};
    length_ = std::hypot(edge_.dx, edge_.dy);
    nodes_ = &nodes.nodes;
    stretches_.assign(nodes.nodes.size(), {});
    std::vector<std::uint32_t> all;
    for (std::uint32_t k = own_ends; k < nodes.nodes.size(); ++k) all.push_back(k);
    const InteriorTracks::Discs discs = tracks_.all_discs();
    for (const PatchCell& cell : cells) look(cell, 0, all, discs);
    std::vector<PatchNode<K>> kept(nodes.nodes.begin(), nodes.nodes.begin() + own_ends);
    for (const std::uint32_t k : all) add_stretches(k, kept);
    nodes.nodes = std::move(kept);
  }

 private:
  using Node = PatchNode<K>;
  static constexpr std::uint32_t own_ends = 2;
  static constexpr std::size_t worth_it = 16, few = 6;
  static constexpr int most_halvings = 12, most_pairs = 120;
  static constexpr double widest = 0x1p20;  ///< scales to cut at lie between this and its inverse
  struct Stretch {
    double low, high;
  };

  void look(const PatchCell& cell, int halvings, const std::vector<std::uint32_t>& nodes,
            const InteriorTracks::Discs& discs) {
    std::vector<std::uint32_t> passing;
    for (const std::uint32_t k : nodes) {
      if (passes((*nodes_)[k], cell)) passing.push_back(k);
    }
    if (passing.empty()) return;
    if (passing.size() > few && cell.low > 0 && std::isfinite(cell.high)) {
      InteriorTracks::Discs hopeful;
      if (tracks_.some_disc_holds(middle_of(edge_, cell).first, cell.low, cell.high, discs,
                                  hopeful) ||
          solids_.some_pair_holds(swept_quad(edge_, cell), most_pairs, pair_)) {
        return;
      }
      if (halvings < most_halvings) {
        PatchCell first = cell, second = cell;
        const double along = (cell.to - cell.from) * length_ * (edge_.is_s ? cell.high : 1),
                     moved = (cell.high - cell.low) * std::hypot(edge_.px, edge_.py);
        if (moved > along) {
          first.high = second.low = cut_between(cell.low, cell.high);
        } else {
          first.to = second.from = (cell.from + cell.to) / 2;
        }
        look(first, halvings + 1, passing, hopeful);
        look(second, halvings + 1, passing, hopeful);
        return;
      }
    }
    for (const std::uint32_t k : passing) stretches_[k].push_back({cell.low, cell.high});
  }

  /// A node's place: 0 at the edge's start, 1 at its end.
  double along(const Node& node, double s) const {
    const double place = node.slope * s + node.value;
    return edge_.is_s ? place / s : place;
  }

  bool passes(const Node& node, const PatchCell& cell) const {
    double low = cell.low, high = cell.high;
    if (node.from) low = std::max(low, K::approximation(*node.from) * (1 - 0x1p-40));
    if (node.to) high = std::min(high, K::approximation(*node.to) * (1 + 0x1p-40));
    if (low > high) return false;
    if (!(low > 0) || !std::isfinite(high)) return true;
    const double doubt = 0x1p-40 * (1 + std::fabs(node.slope) * (edge_.is_s ? 1 : high) +
                                    std::fabs(node.value) / (edge_.is_s ? low : 1));
    const double u = along(node, low), v = along(node, high);  // monotone between the two
    return std::min(u, v) <= cell.to + doubt && std::max(u, v) >= cell.from - doubt;
  }

  /// Adds the node for each of its kept stretches of scales.
  void add_stretches(std::uint32_t k, std::vector<Node>& kept) const {
    std::vector<Stretch> stretches = stretches_[k];
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch& a, const Stretch& b) { return a.low < b.low; });
    for (std::size_t i = 0; i < stretches.size();) {
      Stretch own = stretches[i++];
      while (i < stretches.size() && stretches[i].low <= own.high) {
        own.high = std::max(own.high, stretches[i++].high);
      }
      Node node = (*nodes_)[k];
      if (is_cut(own.low) &&
          !(node.from && K::approximation(*node.from) * (1 + 0x1p-40) >= own.low)) {
        node.from = parameter(own.low);
      }
      if (is_cut(own.high) &&
          !(node.to && K::approximation(*node.to) * (1 - 0x1p-40) <= own.high)) {
        node.to = parameter(own.high);
      }
      if (!is_one_scale(node)) kept.push_back(std::move(node));
    }
  }

  /// Whether only a cut's scale remains, where the node begins or ends; cells beyond the cut have
  /// it, too.
  static bool is_one_scale(const Node& node) {
    if (!node.from || !node.to) return false;
    const Fraction from = fraction(*node.from), to = fraction(*node.to);
    return sign(Integer(from.num * to.den - to.num * from.den)) >= 0;
  }

  /// Whether few bits hold a scale: not the ends of the window.
  static bool is_cut(double scale) {
    if (!(scale > 1 / widest && scale < widest)) return false;
    const double whole = std::ldexp(scale, fraction_bits);
    return whole == std::nearbyint(whole);
  }
  static constexpr int fraction_bits = 32;
  static typename K::Parameter parameter(double scale) {
    using W = typename K::Wide;
    auto num = static_cast<std::int64_t>(std::ldexp(scale, fraction_bits));
    std::int64_t den = std::int64_t{1} << fraction_bits;
    while (num % 2 == 0 && den > 1) {
      num /= 2;
      den /= 2;
    }
    return K::parameter(W(num), W(den));
  }

  const std::vector<RationalEdge>& moving_;
  const InteriorTracks& tracks_;
  const InteriorSolids& solids_;
  RoundedEdge edge_;
  double length_ = 0;
  const std::vector<Node>* nodes_ = nullptr;
  std::vector<std::vector<Stretch>> stretches_;
  InteriorSolids::Pair pair_;
};

}  // namespace minkref::inline plane
