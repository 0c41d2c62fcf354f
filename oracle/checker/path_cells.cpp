#include "oracle/checker/path_cells.hpp"

#include <algorithm>

namespace minkref::checker {
namespace {

/// Corners that are equal follow each other around a cell.
void add(Cell& cell, Corner corner) {
  const bool known = !cell.empty() && (cell.back() == corner || cell.front() == corner);
  if (!known) cell.push_back(std::move(corner));
}

Corner corner_of(const mpz_class& part, const std::optional<mpq_class>& scale) {
  if (!scale) return {0, 1, 0};
  return {part * scale->get_den(), scale->get_num(), scale->get_den()};
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

Cell Scales::cell() const {
  Cell cell;
  add(cell, corner_of(0, low.scale));
  add(cell, corner_of(1, low.scale));
  add(cell, corner_of(1, high.scale));
  add(cell, corner_of(0, high.scale));
  return cell;
}

std::array<Corner, 2> Scales::ends() const {
  return {corner_of(0, low.scale), corner_of(0, high.scale)};
}

mpq_class Scales::middle() const {
  if (!high.scale) return *low.scale + 1;
  return (*low.scale + *high.scale) / 2;
}

bool Scales::meet(const Cell& corners) const {
  if (corners.empty()) return false;
  const auto only_at = [&](const std::optional<mpq_class>& end) {
    const Corner at = corner_of(0, end);
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

std::vector<std::pair<Point, Point>> segments(const Path& path) {
  std::vector<std::pair<Point, Point>> found;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) found.emplace_back(path[i], path[i + 1]);
  if (found.empty()) found.emplace_back(path[0], path[0]);
  return found;
}

Way::Way(const PiecesOfBoth& by, const std::pair<Point, Point>& ends, const mpz_class& unit,
         Normals& normals)
    : by_(by), normals_(normals), parts_(1) {
  for (const Point* end : {&ends.first, &ends.second}) {
    parts_ = lcm(lcm(parts_, end->x.get_den()), end->y.get_den());
  }
  const mpq_class all(unit * parts_);
  start_ = {mpz_class(ends.first.x * all), mpz_class(ends.first.y * all)};
  end_ = {mpz_class(ends.second.x * all), mpz_class(ends.second.y * all)};
}

Gap Way::gap(const Vector& normal, std::uint32_t A, std::uint32_t B) const {
  const mpz_class first = dot(normal, start_), last = dot(normal, end_);
  const mpz_class least = -by_[0]->most(A, normals_.add({-normal.x, -normal.y}));
  const mpz_class& most = by_[1]->most(B, normals_.add(normal));
  return {last - first, parts_ * least, first - parts_ * most};
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
