#include "reference/space/edges/near_facets.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/near/near_pairs.hpp"
#include "reference/space/edges/near_points.hpp"

namespace minkref::inline space {
namespace {

/// Whether a plane separates facets: one facet's plane, or a plane through a facet's side at right
/// angles to the facet. Coplanar facets that share at most a point count as apart: along a line
/// within their plane nothing changes where the other facet touches at a point.
class Separation {
 public:
  Separation(const std::vector<ConvolutionFacet>& facets, SignCounts& signs)
      : facets_(facets), signs_(signs), beyond_(facets.size()) {
    for (std::size_t k = 0; k < facets.size(); ++k) {
      look_for_interrupt();
      const ConvolutionFacet& facet = facets[k];
      for (std::size_t side = 0; side < facet.size; ++side) {
        const BoundedVector out = cross(facet.along<BoundedDouble>(side), facet.normal.rounded);
        beyond_[k][side] = {out, dot(out, facet.start<BoundedDouble>(side))};
      }
    }
  }

  /// Decides from doubles and corner names; if unsure, answers not apart.
  bool operator()(std::uint32_t a, std::uint32_t b) {
    return by_plane(facets_[a], facets_[b]) || by_plane(facets_[b], facets_[a]) ||
           by_a_side(a, facets_[b]) || by_a_side(b, facets_[a]);
  }

 private:
  struct HalfSpace {
    BoundedVector out;
    BoundedDouble offset;
  };

  static bool by_plane(const ConvolutionFacet& flat, const ConvolutionFacet& other) {
    int side = 0;
    for (std::size_t k = 0; k < other.size; ++k) {
      const int at =
          (dot(flat.normal.rounded, other.corners[k].rounded) - flat.offset.rounded).certain_sign();
      if (at == 0 || at == BoundedDouble::undecided || (side != 0 && at != side)) return false;
      side = at;
    }
    return true;
  }

  bool by_a_side(std::uint32_t number, const ConvolutionFacet& other) {
    const ConvolutionFacet& facet = facets_[number];
    for (std::size_t side = 0; side < facet.size; ++side) {
      const auto &from = facet.names[side], &to = facet.names[(side + 1) % facet.size];
      const HalfSpace& beyond = beyond_[number][side];
      int on = 0;
      bool keeps_off = true;
      for (std::size_t k = 0; k < other.size && keeps_off; ++k) {
        const bool shared = other.names[k] == from || other.names[k] == to;
        const int at =
            shared ? 0 : (dot(beyond.out, other.corners[k].rounded) - beyond.offset).certain_sign();
        on += at == 0;
        keeps_off = at == 1 || (at == 0 && on == 1);
      }
      if (keeps_off && (on == 0 || in_one_plane(facet, other))) return true;
    }
    return false;
  }

  bool in_one_plane(const ConvolutionFacet& flat, const ConvolutionFacet& other) {
    for (std::size_t k = 0; k < other.size; ++k) {
      if (flat.has_corner(other.names[k])) continue;
      const int side = filtered_sign(
          signs_, [&]<class T>(std::type_identity<T>) { return flat.height<T>(other, k); });
      if (side != 0) return false;
    }
    return true;
  }

  const std::vector<ConvolutionFacet>& facets_;
  SignCounts& signs_;
  std::vector<std::array<HalfSpace, 4>> beyond_;  // the sides of each facet
};

/// The corners of all facets, four to each; equal corners share a number.
struct NearCorners {
  std::vector<NearPoint> points;
  std::vector<std::uint32_t> number;

  explicit NearCorners(const std::vector<ConvolutionFacet>& facets) : number(4 * facets.size()) {
    const auto place = [&](std::uint32_t k) {
      return std::min<std::size_t>(k % 4, facets[k / 4].size - 1U);
    };
    const auto at = [&](std::uint32_t k) -> const FilteredVector& {
      return facets[k / 4].corners[place(k)];
    };
    const auto weight = [&](std::uint32_t k) { return facets[k / 4].weight<Integer>(place(k)); };
    std::vector<std::uint32_t> order(number.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      look_for_interrupt();
      return at(a).exact != at(b).exact ? at(a).exact < at(b).exact : weight(a) < weight(b);
    });
    std::vector<BoundedVector> distinct;
    for (std::size_t j = 0; j < order.size(); ++j) {
      const FilteredVector& corner = at(order[j]);
      if (j == 0 || at(order[j - 1]).exact != corner.exact ||
          weight(order[j - 1]) != weight(order[j])) {
        distinct.push_back(corner.rounded);
      }
      number[order[j]] = static_cast<std::uint32_t>(distinct.size() - 1);
    }
    points = near_points(distinct);
  }
};

bool share_a_corner(const ConvolutionFacet& a, const ConvolutionFacet& b) {
  for (std::size_t k = 0; k < a.size; ++k) {
    if (b.has_corner(a.names[k])) return true;
  }
  return false;
}

/// For each facet: more near facets at common corners form fans, where boxes and single planes
/// separate little.
constexpr std::size_t most_joined = 12;

}  // namespace

NearLists near_lists(const std::vector<ConvolutionFacet>& facets, SignCounts& signs) {
  NearLists near(facets.size());
  std::vector<SpaceBox> boxes;
  boxes.reserve(facets.size());
  for (const ConvolutionFacet& facet : facets) boxes.push_back(facet.box);
  Separation apart(facets, signs);
  std::size_t joined = 0;
  const auto look_at = [&](std::uint32_t a, std::uint32_t b) {
    if (apart(a, b)) return;
    joined += share_a_corner(facets[a], facets[b]) ? 1 : 0;
    near[a].push_back(b);
    near[b].push_back(a);
  };
  const bool are_fans = SpaceBoxTree(std::move(boxes)).pairs([&](std::uint32_t a, std::uint32_t b) {
    look_at(a, b);
    return joined > most_joined * facets.size();
  });
  if (are_fans) {
    for (auto& list : near) list.clear();
    NearCorners corners(facets);
    std::vector<NearItem> items;
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      const std::uint32_t* c = &corners.number[4 * f];
      items.push_back({{c[0], c[1], c[2]}, f});
      if (facets[f].size == 4) items.push_back({{c[0], c[2], c[3]}, f});
    }
    std::vector<std::uint32_t> facet_of;
    for (const NearItem& item : items) facet_of.push_back(item.group);
    NearPairs(std::move(corners.points), std::move(items))
        .pairs([&](std::uint32_t i, std::uint32_t j) { look_at(facet_of[i], facet_of[j]); });
  }
  for (auto& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return near;
}

}  // namespace minkref::inline space
