// Merge trees, bars and bridges beside the index that they are read off.
#include "reference/disc/features/merge_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "reference/disc/features/feature_level.hpp"
#include "reference/disc/features/notches.hpp"
#include "reference/disc/features/tracks.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::of_merge_tree {
namespace {

struct Built {
  explicit Built(const PolygonSet& P)
      : index(P),
        tree(merge_tree(index)),
        bridges(index),
        codes(barcode(bridges, tree)),
        tracks(bridge_tracks(index)) {}

  DiscIndex index;
  MergeTree tree;
  Bridges bridges;
  Barcode codes;
  std::vector<BridgeTrack> tracks;
};

void check_tree(const Built& built) {
  const auto& nodes = built.tree.nodes;
  std::size_t leaves = 0;
  for (std::uint32_t k = 0; k < nodes.size(); ++k) {
    const MergeNode& node = nodes[k];
    leaves += built.tree.is_leaf(k) ? 1 : 0;
    EXPECT_EQ(node.parent == MergeTree::none, node.kind >= MergeNode::Kind::hole);
    if (node.kind == MergeNode::Kind::merge) {
      EXPECT_GE(node.children.size(), 2U);
    }
    for (const std::uint32_t child : node.children) {
      EXPECT_LT(child, k);
      EXPECT_EQ(nodes[child].parent, k);
      const bool ends_there = node.kind == MergeNode::Kind::hole;
      EXPECT_LT(nodes[child].radius, node.radius + (ends_there ? 1 : 0));
    }
  }
  EXPECT_EQ(built.tree.ends.size(), built.index.graph().reflex_vertices);
  EXPECT_EQ(built.codes.bars.size(), leaves);
}

/// In each gap: bars and features, bridges and corners, tracks and corners.
void check_gap(const Built& built, std::uint32_t gap) {
  const auto alive = features_at(built.index, built.tree, built.codes, {gap, false});
  const auto bars =
      std::count_if(built.codes.bars.begin(), built.codes.bars.end(),
                    [&](const FeatureBar& bar) { return bar.birth <= gap && gap < bar.death; });
  EXPECT_EQ(static_cast<std::size_t>(bars), alive.size());
  IndexBoundary boundary;
  built.index.boundary(gap, boundary);
  std::size_t bridges = 0;
  for (const LiveFeature& feature : alive) {
    bridges += feature.bridges.size();
    const FeatureBar& bar = built.codes.bars[feature.bar];
    EXPECT_TRUE(bar.birth <= gap && gap < bar.death);
  }
  EXPECT_EQ(bridges, boundary.corners.size());
  const auto tracks =
      std::count_if(built.tracks.begin(), built.tracks.end(), [&](const BridgeTrack& track) {
        return built.index.low(track.halves.front()) <= gap &&
               gap < built.index.high(track.halves.back());
      });
  EXPECT_EQ(static_cast<std::size_t>(tracks), bridges);
}

TEST(MergeTree, FitsTheIndexInEachGap) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const Built built(seed % 2 == 0 ? testing::random_region(random, 4)
                                    : testing::random_mesh_region(random, 5));
    ASSERT_NO_FATAL_FAILURE(check_tree(built));
    for (std::uint32_t gap = 0; gap <= built.index.radii(); ++gap) check_gap(built, gap);
  }
}

TEST(MergeTree, OfASlotHasATieAlongARidge) {
  const Built built(
      PolygonSet{{{{{0, 0}, {6, 0}, {6, 6}, {4, 6}, {4, 1}, {2, 1}, {2, 6}, {0, 6}}, {}}}});
  ASSERT_EQ(built.tree.nodes.size(), 4U);
  const MergeNode& merge = built.tree.nodes[2];
  EXPECT_EQ(merge.kind, MergeNode::Kind::merge);
  ASSERT_EQ(merge.places.size(), 1U);
  EXPECT_EQ(merge.places[0].size(), 2U);
  EXPECT_TRUE(built.codes.is_tie[2] != 0);
  EXPECT_TRUE(built.codes.bars[0].is_essential);  // the lesser place lives on
  EXPECT_EQ(built.codes.bars[1].death, merge.radius);
}

TEST(MergeTree, HasNoNotchBeyondItsPersistence) {
  for (unsigned seed = 0; seed < testing::repetitions(20U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const Built built(testing::random_region(random, 5));
    std::size_t before = built.tree.ends.size();
    for (const int persistence : {0, 1, 3, 9}) {
      const auto found =
          notches(built.bridges, built.tree, built.codes, {0, persistence, std::nullopt});
      EXPECT_LE(found.size(), before);
      before = found.size();
    }
  }
}

}  // namespace
}  // namespace minkref::of_merge_tree
