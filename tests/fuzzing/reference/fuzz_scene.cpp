// Scenes with copies from P and the robot Q: unions against placed sums and the definition at
// points, changes against scenes made anew.
#include <algorithm>

#include "reference/plane/boundary/set_operations.hpp"
#include "reference/plane/scaling.hpp"
#include "reference/plane/sum.hpp"
#include "reference/plane/witness.hpp"
#include "reference/scene/scene_union.hpp"
#include "tests/fuzzing/reference/pair_change.hpp"
#include "tests/fuzzing/reference/pair_input.hpp"

namespace minkref::fuzzing {

const Bounds bounds{.vertices = 9, .product = 36};

namespace {

constexpr std::size_t most_copies = 4, most_sides = 24;

Sum sum_of(const Scene& scene, const Copy& copy) {
  return minkowski_sum(scene.shapes[copy.shape], scaled(scene.robot, -1), copy.scale);
}

/// Places at which sums touch: differences between vertices from the first copy's sum; sometimes
/// halves.
Copy drawn_copy(const std::vector<Point>& corners, const Rational& scale, Dice& dice) {
  Copy copy{0, scale, {}};
  if (dice.one_in(3)) copy.scale = scale * Rational(dice.between(1, 4), dice.between(1, 4));
  if (dice.one_in(6)) return copy;
  const Rational share = dice.one_in(3) ? Rational(1, 2) : Rational(1);
  copy.place = share * (dice.of(corners) - dice.of(corners));
  return copy;
}

Scene drawn_scene(const Case& pair, Dice& dice) {
  Scene scene{pair.Q, {pair.P}, {{0, scale_of(pair), {}}}};
  std::vector<Point> corners;
  for (const Polygon& polygon : sum_of(scene, scene.copies[0]).region.polygons) {
    corners.insert(corners.end(), polygon.outer.begin(), polygon.outer.end());
    for (const Ring& hole : polygon.holes) corners.insert(corners.end(), hole.begin(), hole.end());
  }
  const auto copies = static_cast<std::size_t>(dice.between(2, most_copies));
  while (scene.copies.size() < copies)
    scene.copies.push_back(drawn_copy(corners, scene.copies[0].scale, dice));
  return scene;
}

/// At ends and middles on sides, some copy touches and none overlaps.
void check_sides(const Case& pair, const Scene& scene, const SceneUnion& found, Dice& dice) {
  const PolygonSet turned = scaled(scene.robot, -1);
  std::vector<Membership> members;
  for (const Copy& copy : scene.copies)
    members.emplace_back(scene.shapes[copy.shape], turned, copy.scale);
  const auto check_point = [&](const Point& x, const std::vector<Owner>& owners) {
    bool touches = false;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Contact contact = members[k].contact(x - scene.copies[k].place);
      if (contact == Contact::overlapping) broken("no copy overlaps on the boundary", pair);
      touches = touches || contact == Contact::touching;
    }
    if (!touches || owners.empty()) broken("each side has a copy that touches", pair);
  };
  std::vector<const Ring*> rings;
  for (const Polygon& polygon : found.region().region.polygons) {
    rings.push_back(&polygon.outer);
    for (const Ring& hole : polygon.holes) rings.push_back(&hole);
  }
  if (rings.size() != found.owners().size()) broken("each ring has owners", pair);
  for (std::size_t side = 0; side < most_sides && !rings.empty(); ++side) {
    const std::size_t r = dice.below(rings.size()), k = dice.below(rings[r]->size());
    const Point &a = (*rings[r])[k], &b = (*rings[r])[(k + 1) % rings[r]->size()];
    check_point(a, found.owners()[r][k]);
    check_point(Rational(1, 2) * (a + b), found.owners()[r][k]);
  }
}

void check_change(const Case& pair, Scene scene, const SceneUnion& found, Dice& dice) {
  const auto at = static_cast<std::uint32_t>(dice.below(scene.copies.size()));
  const Copy other = dice.of(scene.copies);
  const bool goes = dice.one_in(4);
  const SceneUnion changed = goes ? found.removed(at) : found.changed(at, other.scale, other.place);
  if (goes) {
    scene.copies.erase(scene.copies.begin() + at);
  } else {
    scene.copies[at] = other;
  }
  const SceneUnion anew(scene, true);
  if (changed.region().region != anew.region().region) broken("a change is the set anew", pair);
  if (changed.owners() != anew.owners()) broken("a change has the owners anew", pair);
  if (changed.passages() != anew.passages()) broken("a change has the passages anew", pair);
}

void check(const Case& pair, Dice& dice) {
  if (pair.P.empty() || pair.Q.empty()) return;
  const Scene scene = drawn_scene(pair, dice);
  const SceneUnion found(scene, true);
  std::vector<PolygonSet> sums;
  for (const Copy& copy : scene.copies)
    sums.push_back(translated(sum_of(scene, copy).region, copy.place));
  const Canonical united = combined(SetOperation::unite, sums);
  if (found.region().region != united.region || found.region().holes != united.holes ||
      found.region().components != united.components) {
    broken("a scene's union is that of its sums", pair);
  }
  if (scene.robot.is_region()) check_sides(pair, scene, found, dice);
  check_change(pair, scene, found, dice);
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minkref::fuzzing::check_pair(data, size, minkref::fuzzing::check);
}
