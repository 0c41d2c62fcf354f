// Random scenes: lattice places where sums abut, touch and coincide, and places in general
// position.
#pragma once

#include <string>
#include <vector>

#include "reference/scene/scene.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::testing {

inline Copy random_copy(Source& random, const Scene& scene, int reach, bool lattice) {
  Copy copy;
  copy.shape = static_cast<std::uint32_t>(random.below(scene.shapes.size()));
  if (random.coin()) copy.scale = Rational(random.between(1, 4), random.between(1, 3));
  copy.place = {random.between(-reach, reach), random.between(-reach, reach)};
  if (!lattice) {
    copy.place.x += Rational(random.between(0, 6), 7);
    copy.place.y += Rational(random.between(0, 100), 101);
  }
  return copy;
}

/// At most `most` copies; some are equal, some lie within others, robots and shapes have holes and
/// parts. `thin`: the robot is a point or a segment.
inline Scene random_scene(Source& random, bool thin = false, int most = 7) {
  Scene scene;
  if (thin) {
    const Point a{random.between(-1, 1), random.between(-1, 1)};
    scene.robot = random.below(3) == 0
                      ? point_set(a.x, a.y)
                      : segment_set(a, {a.x + random.between(0, 2), a.y + random.between(1, 2)});
  } else {
    scene.robot =
        random.below(3) == 0 ? box(0, 0, 1, random.between(1, 2)) : random_region(random, 2);
  }
  for (int k = random.between(1, 3); k > 0; --k) {
    const bool plain = random.below(3) == 0;
    scene.shapes.push_back(plain ? box(0, 0, random.between(1, 3), random.between(1, 3))
                                 : random_region(random, 2));
  }
  const bool lattice = random.below(4) != 0;
  const int reach = random.between(2, 20);
  for (int k = random.between(0, most); k > 0; --k) {
    const bool again = !scene.copies.empty() && random.below(8) == 0;
    scene.copies.push_back(again ? scene.copies[random.below(scene.copies.size())]
                                 : random_copy(random, scene, reach, lattice));
  }
  return scene;
}

/// Boxes, right triangles, angles and such robots on a small lattice: many sums abut.
inline Scene lattice_scene(Source& random, int most = 10) {
  const auto piece = [&](int size) {
    const int x = random.between(1, size), y = random.between(1, size);
    switch (random.below(6)) {
      case 0:
        return region({{0, 0}, {x, 0}, {0, x}});
      case 1:
        return region({{0, 0}, {x + 2, 0}, {x + 2, 1}, {1, 1}, {1, y + 1}, {0, y + 1}});
      default:
        return box(0, 0, x, y);
    }
  };
  Scene scene{piece(2), {piece(2), piece(3)}, {}};
  if (random.below(4) == 0) scene.shapes.push_back(random_mesh_region(random, 2));
  const int reach = random.between(2, 4);
  for (int k = random.between(3, most); k > 0; --k) {
    scene.copies.push_back({static_cast<std::uint32_t>(random.below(scene.shapes.size())),
                            1,
                            {random.between(-reach, reach), random.between(-reach, reach)}});
  }
  return scene;
}

inline std::string text(const Scene& scene) {
  std::string result = "robot " + canonical_json(scene.robot) + "\n";
  for (const PolygonSet& shape : scene.shapes) result += "shape " + canonical_json(shape) + "\n";
  for (const Copy& copy : scene.copies) {
    result += "copy " + std::to_string(copy.shape) + " " + to_string(copy.scale) + " " +
              to_string(copy.place.x) + " " + to_string(copy.place.y) + "\n";
  }
  return result;
}

}  // namespace minkref::testing
