#include "reference/scene/copy_contacts.hpp"

#include "reference/interrupt.hpp"

namespace minkref::inline scene {
namespace {

Box box_around(const PolygonSet& set) {
  Box box;
  for (const Polygon& polygon : set.polygons) {
    for (const Point& p : polygon.outer) box.add(box_of(FilteredPoint(p)));
  }
  return box;
}

}  // namespace

CopyContacts::CopyContacts(const std::vector<PolygonSet>& shapes, const PolygonSet& reflected_robot,
                           std::vector<Copy> copies)
    : shapes_(shapes), reflected_(reflected_robot), copies_(std::move(copies)) {
  std::vector<Box> of_shapes, of_sums;
  for (const PolygonSet& shape : shapes_) of_shapes.push_back(box_around(shape));
  const Box robot = box_around(reflected_);
  for (const Copy& copy : copies_) {
    if (shapes_[copy.shape].empty()) {
      of_sums.emplace_back();
      continue;
    }
    const Enclosure s = enclose(copy.scale);
    const Box shape = plane::scaled(of_shapes[copy.shape], s.lower, s.upper);
    const Box place = box_of(FilteredPoint(copy.place));
    of_sums.push_back(plane::sum_of(plane::sum_of(shape, robot), place));
  }
  tree_ = BasicBoxTree<Box>(std::move(of_sums));
}

ContactFinder& CopyContacts::finder(const Copy& copy) {
  const auto convolution =
      convolutions_.try_emplace(copy.shape, shapes_[copy.shape], reflected_, true);
  return finders_.try_emplace({copy.shape, copy.scale}, convolution.first->second, copy.scale)
      .first->second;
}

void CopyContacts::add(const Point& from, const Point& to, std::vector<Owner>& owners) {
  Box box = box_of(FilteredPoint(from));
  box.add(box_of(FilteredPoint(to)));
  std::vector<ConvolutionEdge> contacts;
  tree_.query(box, [&](std::uint32_t k) {
    look_for_interrupt();
    const Copy& copy = copies_[k];
    const auto at_origin = [&](const Point& p) {
      return FilteredPoint({p.x - copy.place.x, p.y - copy.place.y});
    };
    contacts.clear();
    finder(copy).add_sharing(at_origin(from), at_origin(to), contacts);
    for (const ConvolutionEdge& contact : contacts) owners.push_back({k, contact});
    return false;
  });
}

}  // namespace minkref::inline scene
