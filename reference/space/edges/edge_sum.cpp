#include "reference/space/edges/edge_sum.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "reference/build/stage.hpp"
#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/edges/faces_from_edges.hpp"
#include "reference/space/edges/near_facets.hpp"

namespace minkref::inline space {
namespace {

constexpr std::size_t cells_a_facet = 64, least_cells = std::size_t{1} << 15,
                      most_cells = std::size_t{1} << 22;

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
                 const BuildOptions& options, double least_gain) {
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
  FlatPieces pieces_of_P = flat_pieces(first, least_gain),
             pieces_of_Q = flat_pieces(second, least_gain);
  put_pieces(convolution, pieces_of_P, first, second, true);
  put_pieces(convolution, pieces_of_Q, second, first, false);
  result.facets = convolution.facets.size();
  const CollisionTrees trees(first, second, InteriorCells(first, second, cells_for(result.facets)),
                             std::move(pieces_of_P), std::move(pieces_of_Q));
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
