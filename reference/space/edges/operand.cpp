#include "reference/space/edges/operand.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "reference/interrupt.hpp"
#include "reference/space/face_edges.hpp"
#include "reference/space/face_triangles.hpp"

namespace minkref::inline space {
namespace {

std::vector<Face> cut_faces(const Polyhedron& body, const std::vector<IntegerVector>& points) {
  const VertexSigns signs(points);
  std::vector<Face> triangles;
  for (const Face& face : body.faces) {
    look_for_interrupt();
    const auto cut = face_triangles(face, signs);
    if (!cut) throw std::logic_error("a face that is not simple");
    for (const TriangleCorners& t : *cut) triangles.push_back({t[0], t[1], t[2]});
  }
  return triangles;
}

/// The shift that shortens the longest coordinate to `most_bits`, or 0.
long shift_of(const std::vector<IntegerVector>& points) {
  constexpr long most_bits = 50;
  long longest = 0;
  for (const IntegerVector& point : points) {
    for (const Integer& coordinate : point) longest = std::max(longest, bits(coordinate));
  }
  return std::max(0L, longest - most_bits);
}

class OperandBuild {
 public:
  explicit OperandBuild(SpaceOperand& operand) : operand_(operand) {}

  void add_triangle(const Face& face) {
    const auto at = [&](std::size_t k) { return operand_.points[face[k]].exact; };
    operand_.triangles.push_back(
        {{face[0], face[1], face[2]},
         {none, none, none},
         FilteredVector(cross(at(1) - at(0), at(2) - at(0)), 2 * operand_.shift)});
  }

  void add_edge(std::uint32_t from, std::uint32_t to, std::uint32_t left, std::uint32_t right,
                bool convex) {
    const auto number = static_cast<std::uint32_t>(operand_.edges.size());
    operand_.edges.push_back(
        {from, to, left, right, convex,
         FilteredVector(operand_.points[to].exact - operand_.points[from].exact, operand_.shift)});
    operand_.edges_at[from].push_back(number);
    operand_.edges_at[to].push_back(number);
  }

  void join(const std::vector<Face>& triangles) {
    const std::vector<FaceEdge> edges = sorted_edges(triangles);
    for (std::size_t k = 0, end = 0; k < edges.size(); k = end) {
      look_for_interrupt();
      for (end = k; end < edges.size() && edges[end].ends() == edges[k].ends();) ++end;
      const auto number = static_cast<std::uint32_t>(operand_.edges.size());
      const bool inside_polygon = end - k == 4;  // of both its sides
      const std::uint32_t left = edges[k].face, right = edges[k + 1].face;
      add_edge(edges[k].from, edges[k].to, left, right,
               !inside_polygon && is_convex(edges[k], left, right));
      for (std::size_t j = k; j < end; ++j) set_edge(edges[j], number);
    }
  }

  void find_shells() {
    std::vector<std::uint32_t> root(operand_.points.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](std::uint32_t v) {
      while (root[v] != v) v = root[v] = root[root[v]];
      return v;
    };
    for (const SpaceOperand::Edge& edge : operand_.edges) root[find(edge.from)] = find(edge.to);
    for (std::uint32_t v = 0; v < root.size(); ++v) {
      if (find(v) == v) operand_.shell_vertices.push_back(v);
    }
  }

 private:
  void set_edge(const FaceEdge& side, std::uint32_t number) {
    SpaceOperand::Triangle& triangle = operand_.triangles[side.face];
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle.corners[k] == side.from) triangle.edges[k] = number;
    }
  }

  bool is_convex(const FaceEdge& side, std::uint32_t left, std::uint32_t right) const {
    const SpaceOperand::Triangle& other = operand_.triangles[right];
    const IntegerVector& normal = operand_.triangles[left].normal.exact;
    const auto apex = std::find_if(other.corners.begin(), other.corners.end(),
                                   [&](auto v) { return v != side.from && v != side.to; });
    const int height =
        dot(normal, operand_.points[*apex].exact - operand_.points[side.from].exact).sign();
    if (height != 0) return height < 0;
    return dot(normal, other.normal.exact) < 0;  // the two sides of a polygon
  }

  SpaceOperand& operand_;
};

}  // namespace

SpaceOperand::SpaceOperand(const Polyhedron& body, const std::vector<IntegerVector>& at,
                           long shift_)
    : shift(shift_), edges_at(at.size()) {
  for (const IntegerVector& point : at) points.emplace_back(point, shift);
  OperandBuild build(*this);
  std::vector<Face> cut = cut_faces(body, at);
  if (body.faces.size() == 1) {
    for (std::size_t k = 0, count = cut.size(); k < count; ++k) {
      cut.push_back({cut[k][0], cut[k][2], cut[k][1]});
    }
  }
  for (const Face& triangle : cut) build.add_triangle(triangle);
  build.join(cut);
  if (body.is_segment()) build.add_edge(0, 1, none, none, true);
  build.find_shells();
}

SpaceOperands space_operands(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling) {
  require_positive(scaling);
  std::vector<SpacePoint> vertices = scaled(P, scaling).vertices;
  vertices.insert(vertices.end(), Q.vertices.begin(), Q.vertices.end());
  const IntegerPoints integers = integer_points(vertices);
  const auto split = integers.points.begin() + static_cast<std::ptrdiff_t>(P.vertices.size());
  const long shift = shift_of(integers.points);
  return {SpaceOperand(P, {integers.points.begin(), split}, shift),
          SpaceOperand(Q, {split, integers.points.end()}, shift), integers.denominator};
}

SpaceBox SpaceOperand::box_of(std::uint32_t triangle) const {
  SpaceBox box;
  for (const std::uint32_t v : triangles[triangle].corners) box.add(box_around(points[v].rounded));
  return box;
}

}  // namespace minkref::inline space
