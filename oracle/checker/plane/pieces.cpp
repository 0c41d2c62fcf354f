#include "oracle/checker/plane/pieces.hpp"

#include <algorithm>
#include <set>

namespace minkref::checker {
namespace {

bool upwards(const Vector& d) { return d.y > 0 || (d.y == 0 && d.x > 0); }

mpz_class doubled_area(const std::vector<Vector>& ring) {
  mpz_class area;
  for (std::size_t i = 0; i < ring.size(); ++i) area += cross(ring[i], ring[(i + 1) % ring.size()]);
  return area;
}

std::vector<Vector> directions_of(const std::vector<Vector>& ring) {
  std::vector<Vector> directions;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    directions.push_back(minus(ring[(i + 1) % ring.size()], ring[i]));
  }
  return directions;
}

/// Returns the convex hull's vertices, counter-clockwise.
std::vector<Vector> hull_of(std::vector<Vector> points) {
  const auto less = [](const Vector& a, const Vector& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;
  std::vector<Vector> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const Vector& p : points) {
      while (hull.size() > first + 1 &&
             cross(minus(hull.back(), hull[hull.size() - 2]), minus(p, hull.back())) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// Whether some edge of A has all of B on its outer side.
bool divides(const std::vector<Vector>& A, const std::vector<Vector>& B) {
  for (std::size_t i = 0; i < A.size(); ++i) {
    const Vector d = minus(A[(i + 1) % A.size()], A[i]);
    if (std::all_of(B.begin(), B.end(),
                    [&](const Vector& p) { return cross(d, minus(p, A[i])) <= 0; })) {
      return true;
    }
  }
  return false;
}

Point rational(const Vector& v) { return {mpq_class(v.x), mpq_class(v.y)}; }

}  // namespace

bool is_convex(const std::vector<Vector>& directions) {
  int around = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vector &d = directions[i], &e = directions[(i + 1) % directions.size()];
    const int turn = sgn(cross(d, e));
    if (turn < 0 || (turn == 0 && dot(d, e) <= 0)) return false;
    around += !upwards(d) && upwards(e);
  }
  return around == 1;
}

void EdgeSum::add(const Point& from, const Point& to, int times) {
  std::vector<mpq_class> line;
  if (from.x == to.x) {
    line = {from.x};
  } else {
    const mpq_class slope = (to.y - from.y) / (to.x - from.x);
    line = {slope, from.y - slope * from.x};
  }
  for (const auto& [end, sign] : {std::pair(&from, times), std::pair(&to, -times)}) {
    std::vector<mpq_class> key = line;
    key.push_back(end->x);
    key.push_back(end->y);
    ends_[key] += sign;
  }
}

bool EdgeSum::is_nothing() const {
  return std::all_of(ends_.begin(), ends_.end(), [](const auto& end) { return end.second == 0; });
}

std::uint32_t Normals::add(const Vector& normal) {
  const auto [place, fresh] =
      known_.try_emplace({normal.x, normal.y}, static_cast<std::uint32_t>(all_.size()));
  if (fresh) all_.push_back(normal);
  return place->second;
}

Pieces::Pieces(const Value& of, const Value& pieces, const Value& groups, const Operand& set,
               Normals& normals, Budget& budget)
    : operand(set), normals_(normals), budget_(budget) {
  require(text(of) == set.name, "this is another operand");
  for (const Value& piece : items(pieces)) {
    auto& hull = hulls.emplace_back();
    for (const std::uint32_t i : indices(piece, set.points.size())) hull.push_back(set.points[i]);
  }
  count = hulls.size();
  children.resize(count);
  solid.assign(count, true);
  check_tiling(pieces);
  std::vector<std::vector<bool>> leaves;
  for (std::size_t i = 0; i < count; ++i) {
    leaves.emplace_back(count)[i] = true;
  }
  for (const Value& group : items(groups)) {
    const auto list = indices(group, hulls.size());
    require(!list.empty() && std::set(list.begin(), list.end()).size() == list.size(),
            "a group has no member, or one twice");
    budget_.spend(list.size() * count);
    auto& own = leaves.emplace_back(count);
    for (const std::uint32_t child : list) {
      for (std::size_t i = 0; i < count; ++i) own[i] = own[i] || leaves[child][i];
    }
    add_group(list);
  }
  demand(count == 0 ||
             std::find(leaves.back().begin(), leaves.back().end(), false) == leaves.back().end(),
         "the last node does not hold all pieces");
}

void Pieces::check_tiling(const Value& pieces) const {
  if (operand.thin) {
    const auto& ring = operand.rings[0];
    demand(count == 1 && indices(items(pieces)[0], operand.points.size()) == ring,
           operand.name + " is no region: it is its own only piece");
    return;
  }
  EdgeSum sum;
  for (const auto& ring : operand.rings) {
    budget_.spend(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      sum.add(rational(operand.points[ring[i]]),
              rational(operand.points[ring[(i + 1) % ring.size()]]), -1);
    }
  }
  for (std::size_t n = 0; n < count; ++n) {
    const auto& hull = hulls[n];
    budget_.spend(hull.size());
    for (std::size_t i = 0; i < hull.size(); ++i) {
      sum.add(rational(hull[i]), rational(hull[(i + 1) % hull.size()]), 1);
    }
  }
  demand(sum.is_nothing(), "the pieces do not add up to " + operand.name);
  for (std::size_t n = 0; n < count; ++n) {
    demand(is_convex(directions_of(hulls[n])), "a piece is not convex");
  }
}

void Pieces::add_group(const std::vector<std::uint32_t>& members) {
  std::vector<Vector> corners;
  mpz_class area;
  bool all_solid = members.size() == 2;
  for (const std::uint32_t child : members) {
    budget_.spend(hulls[child].size());
    corners.insert(corners.end(), hulls[child].begin(), hulls[child].end());
    area += doubled_area(hulls[child]);
    all_solid = all_solid && solid[child];
  }
  std::vector<Vector> hull = hull_of(std::move(corners));
  const bool is_solid = all_solid && doubled_area(hull) == area &&
                        (divides(hulls[members[0]], hulls[members[1]]) ||
                         divides(hulls[members[1]], hulls[members[0]]));
  hulls.push_back(std::move(hull));
  children.push_back(members);
  solid.push_back(is_solid);
}

const mpz_class& Pieces::most(std::uint32_t node, std::uint32_t normal) const {
  const auto [place, fresh] = most_.try_emplace(std::uint64_t{node} << 32 | normal);
  if (!fresh) return place->second;
  const Vector& n = normals_[normal];
  budget_.spend(hulls[node].size());
  bool first = true;
  for (const Vector& corner : hulls[node]) {
    mpz_class value = dot(n, corner);
    if (first || value > place->second) place->second = std::move(value);
    first = false;
  }
  return place->second;
}

void follow_code(const Pieces& P, const Pieces& Q, const Value* first, const Value* last,
                 const std::function<void(std::uint32_t, std::uint32_t, const Value&)>& answer) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  if (!P.hulls.empty() && !Q.hulls.empty()) pairs.emplace_back(P.last(), Q.last());
  for (; first != last; ++first) {
    demand(!pairs.empty(), "a code goes on after its end");
    const auto [A, B] = pairs.back();
    pairs.pop_back();
    const mpz_class token = integer(*first);
    if (token != -1 && token != -2) {
      answer(A, B, *first);
      continue;
    }
    const auto& children = token == -1 ? P.children[A] : Q.children[B];
    demand(!children.empty(), "a code splits a piece");
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      pairs.emplace_back(token == -1 ? *child : A, token == -1 ? B : *child);
    }
  }
  demand(pairs.empty(), "a code ends too early");
}

std::vector<std::uint32_t> read_normals(const Value& value, Normals& normals) {
  std::vector<std::uint32_t> found;
  for (const Value& entry : items(value)) {
    const auto& pair = items(entry, 2);
    const Vector normal{whole(pair[0]), whole(pair[1])};
    require(normal.x != 0 || normal.y != 0, "a normal is zero");
    found.push_back(normals.add(normal));
  }
  return found;
}

}  // namespace minkref::checker
