// A box tree finds the same overlaps as comparing all boxes.
#include "reference/space/box_tree.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

namespace minkref::of_box_tree {
namespace {

std::vector<SpaceBox> random_boxes(std::mt19937& dice, std::size_t count) {
  std::uniform_int_distribution<int> corner(0, 30), side(0, 4);
  std::vector<SpaceBox> boxes(count);
  for (SpaceBox& box : boxes) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = corner(dice);
      box.high[k] = box.low[k] + side(dice);
    }
  }
  return boxes;
}

TEST(SpaceBoxTree, FindsThePairsAndThoseAtABox) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(seed);
    const std::vector<SpaceBox> boxes = random_boxes(dice, 20 * seed);
    const SpaceBoxTree tree(boxes);
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> found, wanted;
    tree.pairs([&](std::uint32_t i, std::uint32_t j) {
      found.insert(std::minmax(i, j));
      return false;
    });
    std::multiset<std::uint32_t> at_box, wanted_at_box;
    const SpaceBox probe = random_boxes(dice, 1)[0];
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].overlaps(probe)) wanted_at_box.insert(i);
      for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
        if (boxes[i].overlaps(boxes[j])) wanted.insert({i, j});
      }
    }
    tree.query(probe, [&](std::uint32_t i) {
      at_box.insert(i);
      return false;
    });
    EXPECT_EQ(found, wanted);
    EXPECT_EQ(at_box, wanted_at_box);
  }
}

TEST(SpaceBoxTree, StopsWhereToldTo) {
  std::mt19937 dice(7);
  const SpaceBoxTree tree(random_boxes(dice, 500));
  int calls = 0;
  EXPECT_TRUE(tree.pairs([&](std::uint32_t, std::uint32_t) { return ++calls == 3; }));
  EXPECT_EQ(calls, 3);
  SpaceBox all;
  all.low = {-100, -100, -100};
  all.high = {100, 100, SpaceBox::infinity};
  calls = 0;
  EXPECT_TRUE(tree.query(all, [&](std::uint32_t) { return ++calls == 5; }));
  EXPECT_EQ(calls, 5);
  EXPECT_FALSE(tree.query(SpaceBox{}, [](std::uint32_t) { return true; }));
  EXPECT_FALSE(SpaceBoxTree().pairs([](std::uint32_t, std::uint32_t) { return true; }));
}

}  // namespace
}  // namespace minkref::of_box_tree
