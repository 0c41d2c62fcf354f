#include "reference/scene/scene_sum.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"

namespace minkref::inline scene {
namespace {

constexpr std::size_t few_edges = 32;  // so many are looked at faster one by one

Box box_around(const FilteredPoint& a, const FilteredPoint& b) {
  Box box = box_of(a);
  box.add(box_of(b));
  return box;
}

std::vector<FilteredPoint> filtered(const std::vector<Point>& points, const Point& by) {
  std::vector<FilteredPoint> result;
  result.reserve(points.size());
  for (const Point& p : points)
    result.emplace_back(Point{Rational(p.x + by.x), Rational(p.y + by.y)});
  return result;
}

std::vector<Box> edge_boxes(const SceneSum& sum, const std::vector<FilteredPoint>& points) {
  std::vector<Box> boxes;
  boxes.reserve(sum.edges.size());
  for (const SceneSum::Edge& edge : sum.edges)
    boxes.push_back(box_around(points[edge.from], points[edge.to]));
  return boxes;
}

/// Whether p lies on the line of a and b strictly between the two.
bool strictly_between(const FilteredPoint& a, const FilteredPoint& b, const FilteredPoint& p) {
  if (orientation(a, b, p) != 0) return false;
  return compare_xy(a, p) * compare_xy(p, b) > 0;
}

void add_ring(SceneSum& sum, const Ring& ring) {
  const auto first = static_cast<std::uint32_t>(sum.points.size());
  const auto size = static_cast<std::uint32_t>(ring.size());
  const auto first_edge = static_cast<std::uint32_t>(sum.edges.size());
  sum.points.insert(sum.points.end(), ring.begin(), ring.end());
  for (std::uint32_t i = 0; i < size; ++i) {
    sum.edges.push_back({first + i, first + (i + 1) % size, first_edge + (i + size - 1) % size});
  }
}

void add_passage(SceneSum& sum, const TightPassage& passage) {
  const auto first = static_cast<std::uint32_t>(sum.points.size());
  sum.points.insert(sum.points.end(), passage.points.begin(), passage.points.end());
  for (std::uint32_t i = 0; i < passage.contacts.size(); ++i) {
    const std::uint32_t to = passage.points.size() == 1 ? first : first + i + 1;
    sum.edges.push_back({first + i, to, static_cast<std::uint32_t>(sum.edges.size())});
    sum.contacts.insert(sum.contacts.end(), passage.contacts[i].begin(), passage.contacts[i].end());
    sum.first_contact.push_back(static_cast<std::uint32_t>(sum.contacts.size()));
  }
}

void find_touches(SceneSum& sum, const std::vector<FilteredPoint>& points) {
  const BoxTree tree(edge_boxes(sum, points));
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    tree.query(box_of(points[p]), [&](std::uint32_t k) {
      const SceneSum::Edge& edge = sum.edges[k];
      if (edge.from != p && edge.to != p &&
          strictly_between(points[edge.from], points[edge.to], points[p])) {
        sum.touches.emplace_back(k, p);
      }
      return false;
    });
  }
  std::sort(sum.touches.begin(), sum.touches.end());
}

}  // namespace

SceneSum scene_sum(const Sum& found, const SceneConvolution& convolution, const Rational& scale) {
  SceneSum sum;
  for (const Polygon& polygon : found.region.polygons) {
    add_ring(sum, polygon.outer);
    for (const Ring& hole : polygon.holes) add_ring(sum, hole);
  }
  sum.boundary = static_cast<std::uint32_t>(sum.edges.size());
  sum.first_contact.push_back(0);
  std::vector<FilteredPoint> points(sum.points.begin(), sum.points.end());
  ContactFinder finder(convolution, scale);
  for (const SceneSum::Edge& edge : sum.edges) {
    finder.add(points[edge.from], points[edge.to], sum.contacts);
    sum.first_contact.push_back(static_cast<std::uint32_t>(sum.contacts.size()));
  }
  if (found.tight_passages) {
    for (const TightPassage& passage : *found.tight_passages) add_passage(sum, passage);
    for (std::size_t k = points.size(); k < sum.points.size(); ++k)
      points.emplace_back(sum.points[k]);
  }
  find_touches(sum, points);
  return sum;
}

PlacedSum::PlacedSum(std::shared_ptr<const SceneSum> of, const Point& at)
    : sum(std::move(of)), place(at), points(filtered(sum->points, at)) {
  boxes = edge_boxes(*sum, points);
  for (const Box& edge : boxes) box.add(edge);
  if (boxes.size() > few_edges) tree = BoxTree(boxes);
}

}  // namespace minkref::inline scene
