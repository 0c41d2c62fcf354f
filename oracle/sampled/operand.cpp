#include "oracle/sampled/operand.hpp"

#include "oracle/sampled/tiling.hpp"

namespace minkref::sampled {
namespace {

template <class Int>
using Ring = std::vector<Vec<Int>>;

template <class Int>
Vec<Int> primitive(const Vec<Int>& d) {
  const Int common = gcd_of<Int>(d.x, d.y);
  return {Int(d.x / common), Int(d.y / common)};
}

template <class Int>
Ring<Int> without_straight_vertices(const Ring<Int>& ring) {
  Ring<Int> kept;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto &before = ring[(k + ring.size() - 1) % ring.size()],
               &after = ring[(k + 1) % ring.size()];
    const Vec<Int> in = ring[k] - before, out = after - ring[k];
    if (cross(in, out) == 0 && dot(in, out) <= 0) throw BadOperand("a ring turns back on itself");
    if (cross(in, out) != 0) kept.push_back(ring[k]);
  }
  return kept;
}

template <class Int>
bool lies_within(const Edge<Int>& e, const Vec<Int>& x) {
  return cross<Int>(e.to - e.from, x - e.from) == 0 && dot<Int>(e.from - x, e.to - x) < 0;
}

/// Cuts edges at vertices inside them.
template <class Int>
std::vector<Edge<Int>> cut(const std::vector<Edge<Int>>& edges,
                           const std::set<Vec<Int>>& vertices) {
  std::vector<Edge<Int>> parts;
  for (const Edge<Int>& e : edges) {
    std::vector<Vec<Int>> stops;
    for (const Vec<Int>& x : vertices) {
      if (lies_within(e, x)) stops.push_back(x);
    }
    const Vec<Int> d = e.to - e.from;
    std::sort(stops.begin(), stops.end(),
              [&](const auto& a, const auto& b) { return dot(d, a) < dot(d, b); });
    stops.push_back(e.to);
    Vec<Int> from = e.from;
    for (const Vec<Int>& to : stops) {
      parts.push_back({from, to});
      from = to;
    }
  }
  return parts;
}

/// Finds the corner at a vertex from the set's wedges, each between a leaving edge and the next
/// edge counter-clockwise. False if a wedge exceeds half a turn, or if the vertex just lies in the
/// middle of an edge.
template <class Int>
bool corner_at(const Vec<Int>& at, const std::vector<Edge<Int>>& parts, Corner<Int>& corner) {
  std::vector<Vec<Int>> leaving, arriving;
  for (const Edge<Int>& e : parts) {
    if (e.from == at) leaving.push_back(e.to - at);
    if (e.to == at) arriving.push_back(e.from - at);
  }
  if (leaving.empty() || leaving.size() != arriving.size()) {
    throw BadOperand("the rings do not bound a set");
  }
  corner = {at, {}};
  for (const Vec<Int>& u : leaving) {
    const Vec<Int>* end = &arriving.front();
    for (const Vec<Int>& w : arriving) {
      if (end != &w && within_turn(u, w, *end)) end = &w;
    }
    const int turn = sign(cross(u, *end));
    if (turn < 0) return false;
    if (turn == 0 && leaving.size() == 1) return false;
    corner.rays.push_back(primitive(u));
    corner.rays.push_back(primitive(*end));
    if (turn == 0) corner.rays.push_back({Int(-u.y), Int(u.x)});
  }
  return true;
}

template <class Int>
Int doubled_area(const Ring<Int>& ring) {
  Int total = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    total += cross<Int>(ring[k] - ring[0], ring[(k + 1) % ring.size()] - ring[0]);
  }
  return total;
}

template <class Int>
Operand<Int> region_of(const std::vector<Ring<Int>>& given) {
  Operand<Int> operand;
  operand.is_region = true;
  std::set<Vec<Int>> vertices;
  Int area = 0;
  for (const Ring<Int>& as_given : given) {
    const Ring<Int> ring = without_straight_vertices(as_given);
    if (ring.size() < 3) throw BadOperand("a ring has no area");
    area += doubled_area(ring);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      vertices.insert(ring[k]);
      operand.edges.push_back({ring[k], ring[(k + 1) % ring.size()]});
    }
  }
  const std::vector<Edge<Int>> parts = cut(operand.edges, vertices);
  const std::vector<Vec<Int>> points(vertices.begin(), vertices.end());
  std::vector<std::pair<int, int>> sides;
  const auto number = [&](const Vec<Int>& x) {
    return static_cast<int>(std::lower_bound(points.begin(), points.end(), x) - points.begin());
  };
  for (const Edge<Int>& e : parts) sides.emplace_back(number(e.from), number(e.to));
  operand.pieces = Tiling<Int>(points, sides).pieces();
  for (const auto& piece : operand.pieces) {
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const auto &b = piece[(k + 1) % piece.size()], &c = piece[(k + 2) % piece.size()];
      if (cross<Int>(b - piece[k], c - b) < 0) throw BadOperand("the rings do not bound a set");
    }
    area -= doubled_area(piece);
  }
  if (area != 0) throw BadOperand("the rings do not bound a set");
  for (const Vec<Int>& x : points) {
    Corner<Int> corner;
    if (corner_at(x, parts, corner)) operand.corners.push_back(std::move(corner));
  }
  return operand;
}

template <class Int>
Operand<Int> thin(const Ring<Int>& points) {
  Operand<Int> operand;
  operand.pieces = {points};
  if (points.size() == 1) {
    operand.corners = {{points[0], {}}};
    return operand;
  }
  const Vec<Int> d = primitive<Int>(points[1] - points[0]);
  operand.edges = {{points[0], points[1]}, {points[1], points[0]}};
  operand.corners = {{points[0], {d}}, {points[1], {-d}}};
  return operand;
}

}  // namespace

template <class Int>
Operand<Int> operand_of(const Rings& rings) {
  if (rings.empty()) {
    Operand<Int> operand;
    operand.is_empty = true;
    return operand;
  }
  std::vector<Ring<Int>> converted;
  long double most = 0;
  for (const auto& ring : rings) {
    Ring<Int>& last = converted.emplace_back();
    for (const auto& v : ring) last.push_back({from_integer<Int>(v.x), from_integer<Int>(v.y)});
    for (const auto& v : last) most = std::max({most, size_of(v.x), size_of(v.y)});
  }
  demand_room<Int>(64 * most * most * static_cast<long double>(rings.size() + 1000));
  if (converted.size() == 1 && converted[0].size() < 3) return thin(converted[0]);
  return region_of(converted);
}

template Operand<Narrow> operand_of<Narrow>(const Rings&);
template Operand<Wide> operand_of<Wide>(const Rings&);
template Operand<mpz_class> operand_of<mpz_class>(const Rings&);

}  // namespace minkref::sampled
