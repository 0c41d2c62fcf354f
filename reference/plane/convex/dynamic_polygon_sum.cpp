#include "reference/plane/convex/dynamic_polygon_sum.hpp"

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline plane {
namespace {

/// Whether an edge points into the second half of the turn that begins at a ring's least vertex:
/// directions go there from just above -90 degrees to 270.
bool is_in_second_half(const Point& direction) {
  return sign(direction.x) < 0 || (sign(direction.x) == 0 && sign(direction.y) < 0);
}

}  // namespace

void RatioInterval::keep(const Rational& u, const Rational& w, bool positive) {
  if (sign(w) == 0) return;  // one sign at all ratios
  const int open = positive ? 1 : 0;
  const Rational root(u / w);
  if ((sign(w) > 0) == positive) {
    const RatioPlace place{root, -open};
    if (!end || place < *end) end = place;
  } else {
    const RatioPlace place{root, open};
    if (!begin || *begin < place) begin = place;
  }
}

DynamicPolygonSum::DynamicPolygonSum(const PolygonSet& P, const PolygonSet& Q,
                                     const PlaneScaling& at)
    : P_(convex_ring(P, "P")), Q_(convex_ring(Q, "Q")), scaling_(at) {
  const FloatEnvironment standard;
  require_positive(at);
  ratio_ = Rational(at.y / at.x);
  merge();
  of_P_.compatible.resize(P_.size());
  of_Q_.compatible.resize(Q_.size());
  for (std::uint32_t i = 0; i < P_.size(); ++i) insert(true, i);
  for (std::uint32_t j = 0; j < Q_.size(); ++j) insert(false, j);
}

PolygonUpdateCounts DynamicPolygonSum::update(const PlaneScaling& to) {
  const FloatEnvironment standard;
  require_positive(to);
  PolygonUpdateCounts counts;
  scaling_ = to;
  const Rational ratio(to.y / to.x);
  if (ratio == ratio_) return counts;
  ratio_ = ratio;
  mend(true, counts.ev_errors, counts.descent_steps);
  mend(false, counts.ve_errors, counts.descent_steps);
  return counts;
}

/// The turn from an edge of P, scaled, to an edge of Q.
int DynamicPolygonSum::turn(std::size_t edge_of_P, std::size_t edge_of_Q) const {
  const Point &a = P_.directions[edge_of_P], &b = Q_.directions[edge_of_Q];
  return sign(Rational(a.x * b.y - ratio_ * a.y * b.x));
}

/// Whether the edge of Q comes first along the sum's boundary; true if both have one direction.
bool DynamicPolygonSum::goes_before(std::size_t edge_of_Q, std::size_t edge_of_P) const {
  const bool late_Q = is_in_second_half(Q_.directions[edge_of_Q]);
  const bool late_P = is_in_second_half(P_.directions[edge_of_P]);
  return late_Q == late_P ? turn(edge_of_P, edge_of_Q) <= 0 : late_P;
}

void DynamicPolygonSum::merge() {
  of_P_.vertex.resize(P_.size());
  of_Q_.vertex.resize(Q_.size());
  std::size_t j = 0;
  const auto take_Q = [&](std::size_t i) {
    of_Q_.vertex[j++] = static_cast<std::uint32_t>(i == P_.size() ? 0 : i);
  };
  for (std::size_t i = 0; i < P_.size(); ++i) {
    look_for_interrupt();
    while (j < Q_.size() && goes_before(j, i)) take_Q(i);
    of_P_.vertex[i] = static_cast<std::uint32_t>(j == Q_.size() ? 0 : j);
  }
  while (j < Q_.size()) take_Q(P_.size());
}

/// Whether the vertex before lies farther along the edge's normal.
bool DynamicPolygonSum::rises_backward(bool is_P, std::size_t edge, std::size_t vertex) const {
  return is_P ? turn(edge, Q_.before(vertex)) > 0 : turn(P_.before(vertex), edge) <= 0;
}

bool DynamicPolygonSum::rises_forward(bool is_P, std::size_t edge, std::size_t vertex) const {
  return is_P ? turn(edge, vertex) <= 0 : turn(vertex, edge) > 0;
}

/// The descent has one maximum. Both ways rise at the minimum only, and an edge of the maximum in
/// the edge's own direction counts as the rule of ties has it; so each step is one of the way.
void DynamicPolygonSum::mend(bool is_P, std::uint64_t& errors, std::uint64_t& steps) {
  Pairs& pairs = is_P ? of_P_ : of_Q_;
  const ConvexRing& other = is_P ? Q_ : P_;
  const RatioPlace here{ratio_, 0};
  std::vector<std::uint32_t> wrong;
  for (auto it = pairs.by_begin.rbegin(); it != pairs.by_begin.rend() && here < it->first; ++it)
    wrong.push_back(it->second);
  for (auto it = pairs.by_end.begin(); it != pairs.by_end.end() && it->first < here; ++it)
    wrong.push_back(it->second);
  errors += wrong.size();
  for (const std::uint32_t edge : wrong) {
    look_for_interrupt();
    const RatioInterval before = std::exchange(pairs.compatible[edge], {});
    if (before.begin) pairs.by_begin.erase({*before.begin, edge});
    if (before.end) pairs.by_end.erase({*before.end, edge});
    std::uint32_t& vertex = pairs.vertex[edge];
    const bool backward = rises_backward(is_P, edge, vertex);
    do {
      vertex = static_cast<std::uint32_t>(backward ? other.before(vertex) : other.next(vertex));
      ++steps;
    } while (backward ? rises_backward(is_P, edge, vertex) : rises_forward(is_P, edge, vertex));
    insert(is_P, edge);
  }
}

/// Finds the ratios at which the pair stays compatible.
void DynamicPolygonSum::insert(bool is_P, std::uint32_t edge) {
  Pairs& pairs = is_P ? of_P_ : of_Q_;
  const std::size_t v = pairs.vertex[edge];
  RatioInterval& at = pairs.compatible[edge];
  const auto keep = [&](std::size_t i, std::size_t j, bool positive) {
    const Point &a = P_.directions[i], &b = Q_.directions[j];
    at.keep(Rational(a.x * b.y), Rational(a.y * b.x), positive);
  };
  if (is_P) {
    keep(edge, v, true);
    keep(edge, Q_.before(v), false);
  } else {
    keep(P_.before(v), edge, true);
    keep(v, edge, false);
  }
  if (at.begin) pairs.by_begin.emplace(*at.begin, edge);
  if (at.end) pairs.by_end.emplace(*at.end, edge);
}

/// For the edges of P pointing into the second half, vertex 0 comes after all edges of Q.
std::size_t DynamicPolygonSum::edges_of_Q_before(std::size_t edge_of_P) const {
  if (edge_of_P == P_.size()) return Q_.size();
  const std::size_t vertex = of_P_.vertex[edge_of_P];
  return vertex == 0 && is_in_second_half(P_.directions[edge_of_P]) ? Q_.size() : vertex;
}

bool DynamicPolygonSum::have_one_direction(std::size_t edge_of_P, std::size_t edge_of_Q) const {
  return turn(edge_of_P, edge_of_Q) == 0 &&
         is_in_second_half(P_.directions[edge_of_P]) == is_in_second_half(Q_.directions[edge_of_Q]);
}

/// Both operands begin at their least vertex, and so does the sum. Edges with one direction merge
/// into one edge.
PolygonSet DynamicPolygonSum::region() const {
  Ring ring;
  std::size_t i = 0, j = 0;
  const auto add_vertex = [&] {
    const Point &p = P_.vertices[i % P_.size()], &q = Q_.vertices[j % Q_.size()];
    ring.push_back({Rational(scaling_.x * p.x + q.x), Rational(scaling_.y * p.y + q.y)});
  };
  while (i < P_.size() || j < Q_.size()) {
    look_for_interrupt();
    if (j < edges_of_Q_before(i)) {
      add_vertex();
      ++j;
    } else {
      if (j == 0 || !have_one_direction(i, j - 1)) add_vertex();
      ++i;
    }
  }
  return PolygonSet{{Polygon{std::move(ring), {}}}};
}

}  // namespace minkref::inline plane
