// Node lists after a jump through a timeline equal the lists after walking.
#include "reference/plane/dynamic/node_lists.hpp"

#include <gtest/gtest.h>

#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_node_lists {
namespace {

using Lists = std::vector<std::vector<std::uint32_t>>;

/// The lists after each number of steps, change by change.
std::vector<Lists> walked(const ArrangementTimeline& timeline) {
  std::vector<Lists> all{timeline.initial};
  for (std::size_t step = 0; step + 1 < timeline.first_change.size(); ++step) {
    Lists now = all.back();
    for (std::size_t i = timeline.first_change[step]; i < timeline.first_change[step + 1]; ++i) {
      const PackedChange& change = timeline.changes[i];
      auto& list = now[timeline.edge_of_node[change.node]];
      const auto at = list.begin() + change.rank();
      switch (change.kind()) {
        case NodeChange::Kind::insertion:
          list.insert(at, change.node);
          break;
        case NodeChange::Kind::deletion:
          EXPECT_EQ(*at, change.node);
          list.erase(at);
          break;
        case NodeChange::Kind::swap:
        case NodeChange::Kind::settling:
          EXPECT_EQ(*at, change.node);
          std::swap(at[0], at[1]);
          break;
      }
    }
    all.push_back(std::move(now));
  }
  return all;
}

ChangeCounts counted(const ArrangementTimeline& timeline, std::uint32_t from, std::uint32_t to) {
  ChangeCounts counts;
  const auto [low, high] = std::minmax(from, to);
  for (std::size_t i = timeline.first_change[low]; i < timeline.first_change[high]; ++i) {
    const auto kind = timeline.changes[i].kind();
    const bool comes = (kind == NodeChange::Kind::insertion) == (from < to);
    if (kind == NodeChange::Kind::swap) {
      ++counts.swaps;
    } else if (kind != NodeChange::Kind::settling) {
      ++(comes ? counts.insertions : counts.deletions);
    }
  }
  return counts;
}

std::string jumps(const ArrangementTimeline& timeline, Source& random) {
  const std::vector<Lists> expected = walked(timeline);
  NodeLists lists(timeline);
  for (int i = 0; i < 60; ++i) {
    const auto from = lists.place();
    const auto place = static_cast<std::uint32_t>(random.below(expected.size()));
    const ChangeCounts got = lists.move_to(place), wanted = counted(timeline, from, place);
    if (got.insertions != wanted.insertions || got.deletions != wanted.deletions ||
        got.swaps != wanted.swaps) {
      return "wrong counts of changes";
    }
    std::size_t size = 0;
    for (std::uint32_t e = 0; e < lists.edges(); ++e) {
      const auto along = lists.along(e);
      if (!std::equal(along.begin(), along.end(), expected[place][e].begin(),
                      expected[place][e].end())) {
        return "other nodes along edge " + std::to_string(e);
      }
      size += along.size();
    }
    if (size != lists.size() || lists.place() != place) return "wrong size or place";
  }
  return "";
}

TEST(NodeLists, JumpsGiveTheListsAndCountsOfWalking) {
  MINKREF_SEEDED(random, 4200);
  std::size_t changes = 0;
  expect_law(random, 40, [&](const Case& c) -> std::string {
    const auto timeline = arrangement_timeline(c.P, c.Q, {Rational(1, 100), Rational(100)});
    changes = std::max(changes, timeline->changes.size());
    return jumps(*timeline, random);
  });
  EXPECT_GT(changes, 300U);  // enough for lists that stand ready
}

}  // namespace
}  // namespace minkref::testing::of_node_lists
