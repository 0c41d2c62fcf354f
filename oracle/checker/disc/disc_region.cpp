#include <algorithm>
#include <array>

#include "oracle/checker/disc/disc_curve.hpp"

namespace minkref::checker {
namespace {

using Box = std::array<mpq_class, 4>;

/// Measures the gap between two boxes along the axis with the wider gap.
mpq_class apart(const Box& b, const Box& c) {
  return std::max({mpq_class(b[0] - c[2]), mpq_class(c[0] - b[2]), mpq_class(b[1] - c[3]),
                   mpq_class(c[1] - b[3])});
}

mpq_class doubled_area(const std::vector<Point>& ring) {
  mpq_class area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) area += cross(ring[i], ring[(i + 1) % ring.size()]);
  return area;
}

}  // namespace

DiscRegion::DiscRegion(const Operand& P, const mpq_class& square, Budget& budget)
    : DiscEdges(P, square, budget), rings_(P.rings), ring_(count()), root_(P.rings.size()) {
  std::vector<Box> boxes(count());
  std::map<std::pair<mpq_class, mpq_class>, std::vector<std::uint32_t>> arriving;
  for (std::uint32_t k = 0; k < rings_.size(); ++k) {
    root_[k] = k;
    std::set<std::pair<mpq_class, mpq_class>> different;
    for (const std::uint32_t n : rings_[k]) {
      ring_[n] = k;
      different.insert({at(n).x, at(n).y});
      const Point &a = at(n), &b = end_of(n);
      boxes[n] = {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
      arriving[{b.x, b.y}].push_back(n);
    }
    demand(different.size() == rings_[k].size(), "a ring passes a vertex twice");
  }
  const auto join = [&](std::uint32_t k, std::uint32_t j) {
    const std::uint32_t from = root_[k], to = root_[j];
    std::replace(root_.begin(), root_.end(), from, to);
  };
  const mpz_class under = 4 * square.get_num() * square.get_den();
  const mpq_class reach(sqrt(under) + 1, square.get_den());
  near_.resize(count());
  for (std::uint32_t n = 0; n < count(); ++n) {
    budget.spend(count());
    for (std::uint32_t f = 0; f < count(); ++f) {
      if (apart(boxes[n], boxes[f]) > reach) continue;
      near_[n].push_back(f);
      if (n < f && joins(n, f)) join(ring_[n], ring_[f]);
    }
  }
  for (std::uint32_t n = 0; n < count(); ++n) {
    budget.spend(count());
    const Point &a = at(n), &b = end_of(n), way = {along(n).y, -along(n).x};
    const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    demand(winds(middle, way, n) == 0,
           "P is not on the left of edge " + std::to_string(n) + " alone");
  }
  for (std::uint32_t k = 0; k < rings_.size(); ++k) {
    std::vector<Point> ring;
    for (const std::uint32_t n : rings_[k]) ring.push_back(at(n));
    if (doubled_area(ring) < 0) join(k, around(k));
  }
  after_.resize(count());
  std::set<std::uint32_t> different;
  for (std::uint32_t n = 0; n < count(); ++n) {
    before_.push_back(first_right(n, arriving.at({at(n).x, at(n).y})));
    after_[before_[n]] = n;
    different.insert(before_[n]);
  }
  demand(different.size() == count(), "rings cross at a vertex");
}

/// Whether the sums of two edges have interior points in common, or face each other. Demands that
/// the edges have nothing else in common than an end.
bool DiscRegion::joins(std::uint32_t n, std::uint32_t f) const {
  const Point &a = at(n), &b = end_of(n), &c = at(f), &d = end_of(f);
  const std::string names = "edges " + std::to_string(n) + " and " + std::to_string(f);
  const bool first = a == c || a == d, last = b == c || b == d;
  if (first || last) {
    const Point& common = first ? a : b;
    const Point u = minus(first ? b : a, common), v = minus(c == common ? d : c, common);
    demand(!(first && last) && (cross(u, v) != 0 || dot(u, v) < 0), names + " overlap");
    return true;
  }
  const mpq_class sides[] = {height(n, c), height(n, d), height(f, a), height(f, b)};
  const mpq_class gap = std::min({squared_distance(a, c, d), squared_distance(b, c, d),
                                  squared_distance(c, a, b), squared_distance(d, a, b)});
  const bool crossing = sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0;
  demand(gap > 0 && !crossing, names + " meet");
  const Point u = along(n), v = along(f);
  const mpq_class one = dot(u, minus(c, a)), other = dot(u, minus(d, a)), square = 4 * square_;
  const bool facing = cross(u, v) == 0 && dot(u, v) < 0 && sides[0] > 0;
  return gap < square ||
         (gap == square && facing && std::min(one, other) < dot(u, u) && std::max(one, other) > 0);
}

/// The ring to the left of a hole.
std::uint32_t DiscRegion::around(std::size_t k) const {
  const auto& own = rings_[k];
  const auto least = *std::min_element(own.begin(), own.end(), [&](auto i, auto j) {
    return at(i).x != at(j).x ? at(i).x < at(j).x : at(i).y < at(j).y;
  });
  const Point& p = at(least);
  std::optional<std::pair<mpq_class, std::uint32_t>> found;
  for (std::uint32_t n = 0; n < count(); ++n) {
    const Point &a = at(n), &b = end_of(n);
    if (ring_[n] == k || (a.y <= p.y) == (b.y <= p.y)) continue;
    const mpq_class x = a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y);
    if (x > p.x) continue;
    const std::pair<mpq_class, std::uint32_t> hit{x, ring_[n]};
    if (!found || *found < hit) found = hit;
  }
  demand(found.has_value(), "a hole is in nothing");
  return found->second;
}

/// The first edge clockwise of edge n, seen from where n begins.
std::uint32_t DiscRegion::first_right(std::uint32_t n,
                                      const std::vector<std::uint32_t>& arriving) const {
  const auto back = [&](std::uint32_t m) { return minus(at(m), at(n)); };
  const auto turn = [&](std::uint32_t m) { return sgn(cross(along(n), back(m))); };
  std::uint32_t first = arriving.front();
  for (const std::uint32_t m : arriving) {
    const bool is_earlier =
        turn(m) != turn(first) ? turn(m) < turn(first) : cross(back(m), back(first)) < 0;
    if (is_earlier) first = m;
  }
  return first;
}

Key DiscRegion::key_after(std::uint32_t n) const {
  const std::uint32_t next = after_[n];
  return {turns_left(next) ? Key::Kind::arc : Key::Kind::edge, next};
}

int DiscRegion::far(const RootPoint& p, std::uint32_t f) const {
  const Point &a = at(f), &b = end_of(f), u = along(f);
  const mpq_class length = dot(u, u);
  const Root over = dot(RootPoint(u), minus(p, a));
  const int first = sign(over);
  if (first > 0 && sign(over - length) < 0) {
    const Root high = cross(minus(p, a), u);
    return sign(high * high - mpq_class(square_ * length));
  }
  const RootPoint way = minus(p, first <= 0 ? a : b);
  return sign(dot(way, way) - square_);
}

std::uint32_t DiscRegion::component(std::uint32_t n) const { return root_[ring_[n]]; }

std::size_t DiscRegion::components() const {
  return std::set<std::uint32_t>(root_.begin(), root_.end()).size();
}

}  // namespace minkref::checker
