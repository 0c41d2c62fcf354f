#include "reference/space/edges/edge_sum.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "reference/build/stage.hpp"
#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/edges/faces_from_edges.hpp"

namespace minkref::inline space {
namespace {

constexpr std::size_t cells_a_facet = 64, least_cells = std::size_t{1} << 15,
                      most_cells = std::size_t{1} << 22;

using NearLists = std::vector<std::vector<std::uint32_t>>;

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
        const BoundedVector &from = facet.corners[side].rounded,
                            &to = facet.corners[(side + 1) % facet.size].rounded;
        const BoundedVector out = cross(to - from, facet.normal.rounded);
        beyond_[k][side] = {out, dot(out, from)};
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
      const int side = filtered_sign(signs_, [&]<class T>(std::type_identity<T>) {
        return T(dot(flat.normal.as<T>(), other.corners[k].as<T>()) - flat.offset.as<T>());
      });
      if (side != 0) return false;
    }
    return true;
  }

  const std::vector<ConvolutionFacet>& facets_;
  SignCounts& signs_;
  std::vector<std::array<HalfSpace, 4>> beyond_;  // the sides of each facet
};

NearLists near_lists(const std::vector<ConvolutionFacet>& facets, SignCounts& signs) {
  NearLists near(facets.size());
  std::vector<SpaceBox> boxes;
  boxes.reserve(facets.size());
  for (const ConvolutionFacet& facet : facets) boxes.push_back(facet.box);
  Separation apart(facets, signs);
  SpaceBoxTree(std::move(boxes)).pairs([&](std::uint32_t a, std::uint32_t b) {
    if (apart(a, b)) return;
    near[a].push_back(b);
    near[b].push_back(a);
  });
  for (auto& list : near) std::sort(list.begin(), list.end());
  return near;
}

/// Few enough to cost less than the search for edges.
std::size_t cells_for(std::size_t facets) {
  return std::clamp(cells_a_facet * facets, least_cells, most_cells);
}

/// Marks the facets that cells prove to lie within the sum's interior.
std::vector<bool> covered_facets(const std::vector<ConvolutionFacet>& facets,
                                 const InteriorCells& cells) {
  std::vector<bool> covered(facets.size());
  for (std::size_t k = 0; k < facets.size(); ++k) {
    std::array<BoundedVector, 4> corners;
    for (std::size_t j = 0; j < facets[k].size; ++j) corners[j] = facets[k].corners[j].rounded;
    covered[k] = cells.contain({corners.data(), facets[k].size});
  }
  return covered;
}

}  // namespace

EdgeSum edge_sum(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling,
                 const BuildOptions& options) {
  const FloatEnvironment standard;
  require_positive(scaling);
  EdgeSum result;
  if (P.empty() || Q.empty()) return result;
  if (P.faces.size() < 2 && Q.faces.size() < 2) {
    throw BadInput("degenerate-operands", "neither operand has a volume",
                   "give a solid as one of them");
  }
  const SpaceOperands operands = space_operands(P, Q, scaling);
  const SpaceOperand &first = operands.P, &second = operands.Q;
  Convolution convolution = convolution_facets(first, second);
  result.facets = convolution.facets.size();
  const CollisionTrees trees(first, second, InteriorCells(first, second, cells_for(result.facets)));
  leave_out(convolution, covered_facets(convolution.facets, trees.cells));
  result.covered_facets = result.facets - convolution.facets.size();
  const NearLists near = near_lists(convolution.facets, convolution.signs);

  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t a = 0; a < near.size(); ++a) {
    for (const std::uint32_t b : near[a]) {
      if (a < b) pairs.emplace_back(a, b);
    }
  }
  const std::size_t sides = convolution.sides.size();
  const BuildControl control(options, "the sum");
  std::vector<std::unique_ptr<BoundaryEdgeSearch>> searches(control.threads());
  in_parallel(sides + pairs.size(), control, BuildProgress::Stage::patches, [&](unsigned thread) {
    searches[thread] = std::make_unique<BoundaryEdgeSearch>(convolution, near, trees);
    return [&search = *searches[thread], &pairs, sides](std::size_t k) {
      if (k < sides) {
        search.look_along_side(static_cast<std::uint32_t>(k));
      } else {
        search.look_along_crossing(pairs[k - sides].first, pairs[k - sides].second);
      }
    };
  });
  std::vector<BoundaryEdge> edges;
  result.statistics.signs = convolution.signs;
  for (const auto& search : searches) {
    if (!search) continue;
    edges.insert(edges.end(), search->edges.begin(), search->edges.end());
    const EdgeStatistics part = search->statistics();
    result.statistics.signs.add(part.signs);
    result.statistics.pieces += part.pieces;
    result.statistics.candidates += part.candidates;
    result.statistics.tests += part.tests;
    result.statistics.covered += part.covered;
    result.statistics.nanoseconds_of_tests += part.nanoseconds_of_tests;
  }
  result.near_pairs = pairs.size();
  result.edges = edges.size();
  result.set = faces_from_edges(edges, convolution.facets, operands.denominator);
  return result;
}

}  // namespace minkref::inline space
