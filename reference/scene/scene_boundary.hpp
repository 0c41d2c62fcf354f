// From stretches to the union: its boundary with owners, and tight passages.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/passages/tight_graph.hpp"
#include "reference/scene/edge_stretches.hpp"
#include "reference/scene/point_numbers.hpp"
#include "reference/scene/scene.hpp"

namespace minkref::inline scene {

/// An edge of a placed sum that has a stretch from a point to another.
struct OwnedStretch {
  std::uint32_t from = 0, to = 0;  ///< point numbers
  std::uint32_t sum = 0, edge = 0;
};

/// The boundary of the union: each stretch once for each edge that has it. Sums and stretches must
/// outlive it.
struct SceneBoundary {
  PointNumbers numbers;
  std::vector<OwnedStretch> stretches;    ///< sorted
  std::vector<std::uint32_t> first_from;  ///< the first stretch from each point, and the end

  FilteredBoundary graph() const;
  BoundaryGraph exact_graph() const;
};
SceneBoundary scene_boundary(const PlacedSums& sums, const SceneStretches& stretches);

/// Appends the owners of a stretch of a placed sum's edge, given by its ends.
using AddOwners = std::function<void(std::uint32_t sum, std::uint32_t edge, const Point& from,
                                     const Point& to, std::vector<Owner>& owners)>;

/// Owners of the sides of a region in canonical form, ring by ring: side i runs from vertex i to
/// the next.
using RingOwners = std::vector<std::vector<Owner>>;
std::vector<RingOwners> side_owners(const PolygonSet& region, const SceneBoundary& boundary,
                                    const AddOwners& add_owners);

/// A maximal piece, as TightPassage.
struct ScenePassage {
  std::vector<Point> points;
  std::vector<std::vector<Owner>> owners;  ///< as TightPassage::contacts
  friend bool operator==(const ScenePassage&, const ScenePassage&) = default;
};

/// The tight passages, cut wherever they touch each other or the boundary. A contact of the graph
/// names an owner: number_of_owner(contact) within `owners`.
struct SceneTightGraph {
  TightGraph graph;
  std::vector<Owner> owners;
  std::vector<std::uint32_t> edge_of_owner;  ///< each owner has one edge of the graph

  static std::uint32_t number_of_owner(const ConvolutionEdge& contact) {
    return contact.edge.index;
  }
};
SceneTightGraph scene_tight_graph(const PlacedSums& sums, const SceneStretches& stretches,
                                  const SceneBoundary& boundary, const AddOwners& add_owners);

/// The graph's maximal pieces, and an edge of the graph for each.
struct ScenePassages {
  std::vector<ScenePassage> pieces;
  std::vector<std::uint32_t> edges;
};
ScenePassages scene_passages(const SceneTightGraph& tight);

}  // namespace minkref::inline scene
