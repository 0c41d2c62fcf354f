#include "oracle/checker/motion/path_cells.hpp"

#include <algorithm>

namespace minkref::checker {
namespace {

/// Adds a corner unless equal to a neighbour around the cell.
void add(Cell& cell, Corner corner) {
  const bool known = !cell.empty() && (cell.back() == corner || cell.front() == corner);
  if (!known) cell.push_back(std::move(corner));
}

Corner corner_of(const std::optional<mpq_class>& scale) {
  if (!scale) return {0, 1, 0};
  return {0, scale->get_num(), scale->get_den()};
}

Corner between(const Corner& p, const mpz_class& of_p, const Corner& q, const mpz_class& of_q) {
  const mpz_class u = abs(of_q), v = abs(of_p);
  Corner found{u * p.t + v * q.t, u * p.s + v * q.s, u * p.w + v * q.w};
  const mpz_class divisor = gcd(gcd(found.t, found.s), found.w);
  found.t /= divisor;
  found.s /= divisor;
  found.w /= divisor;
  return found;
}

bool truth(const Value& value) {
  require(value.kind == Value::Kind::boolean, "this is not true or false");
  return value.truth;
}

}  // namespace

Cell not_above(const Gap& gap, const Cell& cell) {
  std::vector<mpz_class> levels;
  for (const Corner& corner : cell) levels.push_back(gap.at(corner));
  Cell kept;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const std::size_t before = (i + cell.size() - 1) % cell.size();
    if (sgn(levels[i]) * sgn(levels[before]) < 0) {
      add(kept, between(cell[i], levels[i], cell[before], levels[before]));
    }
    if (levels[i] <= 0) add(kept, cell[i]);
  }
  return kept;
}

std::array<Cell, 2> halves(const Cell& cell) {
  std::optional<mpq_class> least, most;
  for (const Corner& corner : cell) {
    if (corner.w == 0) continue;
    mpq_class at(corner.t, corner.w);
    at.canonicalize();
    if (!least || at < *least) least = at;
    if (!most || at > *most) most = at;
  }
  require(least.has_value(), "a cell has no place");
  const mpq_class middle = (*least + *most) / 2;
  const mpz_class &u = middle.get_num(), &v = middle.get_den();
  return {not_above({-v, 0, u}, cell), not_above({v, 0, -u}, cell)};
}

Scales::Scales(const Value& value) {
  const auto m = members(value, "from to from_in to_in");
  const bool from_in = truth(*m[2]), to_in = truth(*m[3]);
  low = {number(*m[0]), !from_in};
  if (!m[1]->is_null()) high.scale = number(*m[1]);
  high.above = to_in;
  require(*low.scale >= 0 && (*low.scale > 0 || !from_in) && (high.scale || !to_in) && low < high,
          "these are no scales");
}

std::array<Corner, 2> Scales::ends() const { return {corner_of(low.scale), corner_of(high.scale)}; }

mpq_class Scales::middle() const {
  if (!high.scale) return *low.scale + 1;
  return (*low.scale + *high.scale) / 2;
}

bool Scales::meet(const Cell& corners) const {
  if (corners.empty()) return false;
  const auto only_at = [&](const std::optional<mpq_class>& end) {
    const Corner at = corner_of(end);
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Corner& c) { return c.s * at.w == at.s * c.w; });
  };
  return !(low.above && only_at(low.scale)) && !(!high.above && only_at(high.scale));
}

std::string Scales::said() const {
  return (low.above ? "(" : "[") + low.scale->get_str() + ", " +
         (high.scale ? high.scale->get_str() : "inf") + (high.above ? "]" : ")");
}

Path read_path(const Value& value) {
  Path path;
  for (const Value& place : items(value)) path.push_back(point(place));
  require(!path.empty(), "a path has no place");
  return path;
}

MovingPlace moving(const Value& value) {
  const auto& parts = items(value, 4);
  return {{number(parts[0]), number(parts[2])}, {number(parts[1]), number(parts[3])}};
}

MovingPath read_moving_path(const Value& value) {
  MovingPath path;
  for (const Value& place : items(value)) {
    path.push_back(items(place).size() == 2 ? MovingPlace{point(place), {}} : moving(place));
  }
  require(!path.empty(), "a path has no place");
  return path;
}

MovingPath staying(const Path& path) {
  MovingPath found;
  for (const Point& place : path) found.push_back({place, {}});
  return found;
}

Way::Way(const PiecesOfBoth& by, const std::pair<MovingPlace, MovingPlace>& ends,
         const Scales& scales, const mpz_class& unit, Normals& normals)
    : by_(by), normals_(normals), parts_(1) {
  for (const MovingPlace* end : {&ends.first, &ends.second}) {
    for (const Point* p : {&end->at, &end->slope}) {
      parts_ = lcm(lcm(parts_, p->x.get_den()), p->y.get_den());
    }
  }
  const mpq_class all(unit * parts_);
  const auto in_units = [&](const Point& p) {
    return Vector{mpz_class(p.x * all), mpz_class(p.y * all)};
  };
  start_ = in_units(ends.first.at);
  slope_ = in_units(ends.first.slope);
  const Vector off = minus(in_units(ends.second.at), start_);
  const Vector grows = minus(in_units(ends.second.slope), slope_);
  const auto corners = scales.ends();
  std::array<Vector, 2> ways;
  for (std::size_t k = 0; k < 2; ++k) {
    const Corner& at = corners[k];
    ways[k] = {mpz_class(at.w * off.x + at.s * grows.x), mpz_class(at.w * off.y + at.s * grows.y)};
  }
  demand(cross(ways[0], ways[1]) == 0 && dot(ways[0], ways[1]) >= 0,
         "a segment turns as the scale changes");
  along_ = {mpz_class(ways[0].x + ways[1].x), mpz_class(ways[0].y + ways[1].y)};
  square_ = dot(along_, along_);
  if (square_ == 0) square_ = 1;
  for (const auto& [k, is_end] : {std::pair{0, false}, {0, true}, {1, true}, {1, false}}) {
    Corner corner = corners[static_cast<std::size_t>(k)];
    if (is_end) corner.t = dot(ways[static_cast<std::size_t>(k)], along_);
    add(cell_, std::move(corner));
  }
}

Gap Way::gap(const Vector& normal, std::uint32_t A, std::uint32_t B) const {
  const mpz_class least = -by_[0]->most(A, normals_.add({-normal.x, -normal.y}));
  const mpz_class& most = by_[1]->most(B, normals_.add(normal));
  return {dot(normal, along_), square_ * (dot(normal, slope_) + parts_ * least),
          square_ * (dot(normal, start_) - parts_ * most)};
}

std::vector<Vector> sides(const std::vector<Vector>& ring) {
  std::vector<Vector> found;
  if (ring.size() > 2) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector d = minus(ring[(i + 1) % ring.size()], ring[i]);
      found.push_back({d.y, -d.x});
    }
    return found;
  }
  Vector d = ring.size() == 2 ? minus(ring[1], ring[0]) : Vector{1, 0};
  if (d == Vector{0, 0}) d = {1, 0};  // a segment without length is a point
  return {d, {-d.x, -d.y}, {d.y, -d.x}, {-d.y, d.x}};
}

}  // namespace minkref::checker
