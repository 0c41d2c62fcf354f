#include "reference/scene/scene_sum.hpp"

#include <algorithm>
#include <iterator>

#include "reference/interrupt.hpp"

namespace minkref::inline scene {
namespace {

constexpr std::size_t few_edges = 32;  // so many are looked at faster one by one

std::vector<FilteredPoint> moved(const std::vector<FilteredPoint>& points, const Point& by) {
  std::vector<FilteredPoint> result;
  result.reserve(points.size());
  for (const FilteredPoint& point : points) {
    const Point& p = point.exact();
    result.emplace_back(Point{p.x + by.x, p.y + by.y});
  }
  return result;
}

std::vector<Box> edge_boxes(const std::vector<SceneSum::Edge>& edges,
                            const std::vector<FilteredPoint>& points) {
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const SceneSum::Edge& edge : edges)
    boxes.push_back(box_of(points[edge.from], points[edge.to]));
  return boxes;
}

/// Whether p lies on the line of a and b strictly between the two.
bool strictly_between(const FilteredPoint& a, const FilteredPoint& b, const FilteredPoint& p) {
  if (orientation(a, b, p) != 0) return false;
  return compare_xy(a, p) * compare_xy(p, b) > 0;
}

}  // namespace

void SceneSum::add_ring(std::vector<FilteredPoint> ring) {
  const auto first = static_cast<std::uint32_t>(points.size());
  const auto size = static_cast<std::uint32_t>(ring.size());
  const auto first_edge = static_cast<std::uint32_t>(edges.size());
  std::move(ring.begin(), ring.end(), std::back_inserter(points));
  for (std::uint32_t i = 0; i < size; ++i) {
    edges.push_back({first + i, first + (i + 1) % size, first_edge + (i + size - 1) % size});
  }
  boundary = static_cast<std::uint32_t>(edges.size());
}

void SceneSum::add_passage(const TightPassage& passage) {
  const auto first = static_cast<std::uint32_t>(points.size());
  for (const Point& point : passage.points) points.emplace_back(point);
  for (std::uint32_t i = 0; i < passage.contacts.size(); ++i) {
    const std::uint32_t to = passage.points.size() == 1 ? first : first + i + 1;
    edges.push_back({first + i, to, static_cast<std::uint32_t>(edges.size())});
    of_passages.push_back(passage.contacts[i]);
  }
}

void SceneSum::finish() {
  std::vector<Box> boxes = edge_boxes(edges, points);
  const auto look_at = [&](std::uint32_t k, std::uint32_t p) {
    const Edge& edge = edges[k];
    if (edge.from != p && edge.to != p &&
        strictly_between(points[edge.from], points[edge.to], points[p])) {
      touches.emplace_back(k, p);
    }
    return false;
  };
  if (boxes.size() > few_edges) {
    tree = BoxTree(std::move(boxes));
    for (std::uint32_t p = 0; p < points.size(); ++p)
      tree.query(box_of(points[p]), [&](std::uint32_t k) { return look_at(k, p); });
  } else {
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
      for (std::uint32_t p = 0; p < points.size(); ++p) {
        if (boxes[k].overlaps(box_of(points[p]))) look_at(k, p);
      }
    }
  }
  std::sort(touches.begin(), touches.end());
}

SumContacts SceneSum::find_contacts(const SceneConvolution& convolution) const {
  SumContacts found;
  found.first.push_back(0);
  const auto end_edge = [&] {
    found.first.push_back(static_cast<std::uint32_t>(found.contacts.size()));
  };
  ContactFinder finder(convolution, scale);
  for (std::uint32_t k = 0; k < boundary; ++k) {
    finder.add(points[edges[k].from], points[edges[k].to], found.contacts);
    end_edge();
  }
  for (const auto& contacts : of_passages) {
    found.contacts.insert(found.contacts.end(), contacts.begin(), contacts.end());
    end_edge();
  }
  return found;
}

PlacedSum::PlacedSum(std::shared_ptr<const SceneSum> of, const Point& to)
    : sum(std::move(of)), place(to), at(box_of(FilteredPoint(to))), points(moved(sum->points, to)) {
  boxes = edge_boxes(sum->edges, points);
  for (const Box& edge : boxes) box.add(edge);
}

}  // namespace minkref::inline scene
