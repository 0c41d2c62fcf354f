// Clipper2, in four ways: the argument is boundary, region, double or inflate.
//
// boundary: MinkowskiSum of Paths64 unchanged: one ring per operand, the sum of both curves,
// unfilled: the sum of a large ring and a small ring has a hole.
//
// region: the sum of regions, built from the library's functions. Clipper 1 filled by uniting the
// curves' sum with a translate of the path, and the same is advised for Clipper2
// (https://github.com/AngusJohnson/Clipper2/issues/719). With holes and several polygons:
//
//   the union of the parallelograms of MinkowskiSum(r, s) for every ring r of P and s of Q,
//   of P + q for one vertex q of the outer ring of each polygon of Q,
//   and of Q + p for one vertex p of the outer ring of each polygon of P.
//
// all in one Union: MinkowskiSum would unite the parallelograms alone, and round, and where a
// rounded edge then runs along a translate's edge, slivers narrower than a grid unit stay open.
//
// This gives the whole sum, which contains each part. Conversely, let x belong to the sum: then a
// connected polygon A of P and a connected polygon B of x - Q meet. If their boundaries meet, the
// first part contains x. If not, the outer ring b of B is a connected curve that misses the
// boundary of A, so b lies in A or outside A, and likewise the outer ring a of A. With b in A, the
// second part contains x; with a in B, the third part. Otherwise neither ring lies in a hole of the
// other polygon, for then its whole polygon would, and A and B would not meet. So a lies outside
// the curve b, and with a all of A, which is connected and misses b; but B lies inside b: A and B
// do not meet.
//
// It also unites sets, with one Union of all rings.
//
// double: MinkowskiSum of PathsD with the default of two decimals; curves, as boundary.
//
// inflate: InflatePaths of Paths64, joins and ends as asked, its arc tolerance a thousandth of the
// radius.
#include <clipper2/clipper.h>

#include <string_view>

#include "fuzz/adapters/integer_grid.hpp"

namespace minkref::adapter {
namespace {

using namespace Clipper2Lib;

// Far within what Clipper2 takes (62 bits).
constexpr int bits = 30;

Path64 to_path(const Ring& ring, const IntegerGrid& grid) {
  Path64 path;
  for (const Point& p : ring) path.emplace_back(grid.to_grid(p.x), grid.to_grid(p.y));
  return path;
}

Paths64 to_paths(const Polygon& polygon, const IntegerGrid& grid) {
  Paths64 paths{to_path(polygon.outer, grid)};
  for (const Ring& hole : polygon.holes) paths.push_back(to_path(hole, grid));
  return paths;
}

json result_of(const Paths64& paths, const IntegerGrid& grid) {
  json rings = json::array();
  for (const Path64& path : paths) {
    json& ring = rings.emplace_back(json::array());
    for (const auto& p : path) ring.push_back({grid.from_grid(p.x), grid.from_grid(p.y)});
  }
  return {{"rings", rings}};
}

const Ring& only_ring(const Polygons& polygons) {
  if (polygons.size() != 1 || !polygons[0].holes.empty()) throw Skipped("one ring each only");
  return polygons[0].outer;
}

json boundary_sum(const Polygons& sP, const Polygons& Q) {
  const IntegerGrid grid(sP, Q, bits);
  const Path64 p = to_path(only_ring(sP), grid), q = to_path(only_ring(Q), grid);
  return result_of(MinkowskiSum(p, q, true), grid);
}

json region_sum(const Polygons& sP, const Polygons& Q) {
  const IntegerGrid grid(sP, Q, bits);
  Paths64 parts;
  const auto add = [&](const Paths64& paths) {
    parts.insert(parts.end(), paths.begin(), paths.end());
  };
  for (const Polygon& a : sP) {
    for (const Polygon& b : Q) {
      const Paths64 p = to_paths(a, grid), q = to_paths(b, grid);
      if (p[0].size() < 3 || q[0].size() < 3) throw Skipped("no points or segments");
      for (const Path64& r : p) {
        for (const Path64& s : q) add(detail::Minkowski(r, s, true, true));
      }
      add(TranslatePaths(p, q[0][0].x, q[0][0].y));
      add(TranslatePaths(q, p[0][0].x, p[0][0].y));
    }
  }
  // Outer rings run counter-clockwise and holes clockwise: no part has a negative winding number.
  return result_of(Union(parts, FillRule::NonZero), grid);
}

json unite(const std::vector<Polygons>& sets) {
  double size = 0;
  for (const Polygons& set : sets) size = std::max(size, largest_coordinate(set));
  const IntegerGrid grid(size, bits);
  Paths64 paths;
  for (const Polygons& set : sets) {
    for (const Ring& ring : rings_of(set)) paths.push_back(to_path(ring, grid));
  }
  return result_of(Union(paths, FillRule::NonZero), grid);
}

JoinType join_type(const std::string& join) {
  if (join == "mitre") return JoinType::Miter;
  if (join == "bevel") return JoinType::Bevel;
  return join == "square" ? JoinType::Square : JoinType::Round;
}

EndType end_type(const std::string& cap) {
  if (cap == "flat") return EndType::Butt;
  return cap == "square" ? EndType::Square : EndType::Round;
}

json grow(const Growth& asked) {
  const bool open = !asked.lines.empty();
  const std::vector<Ring> rings = open ? asked.lines : rings_of(asked.polygons);
  double size = 0;
  for (const Ring& ring : rings) size = std::max(size, largest_coordinate({{ring, {}}}));
  const IntegerGrid grid(size + std::abs(asked.radius), bits);
  Paths64 paths;
  for (const Ring& ring : rings) paths.push_back(to_path(ring, grid));
  const double delta = grid.scaled(asked.radius);
  const EndType end = open ? end_type(asked.cap) : EndType::Polygon;
  return result_of(
      InflatePaths(paths, delta, join_type(asked.join), end, asked.limit, std::abs(delta) / 1000),
      grid);
}

json double_sum(const Polygons& sP, const Polygons& Q) {
  const auto path_of = [](const Ring& ring) {
    PathD path;
    for (const Point& p : ring) path.emplace_back(p.x, p.y);
    return path;
  };
  json rings = json::array();
  for (const PathD& path : MinkowskiSum(path_of(only_ring(sP)), path_of(only_ring(Q)), true)) {
    json& ring = rings.emplace_back(json::array());
    for (const auto& p : path) ring.push_back({p.x, p.y});
  }
  return {{"rings", rings}};
}

json hello(const char* name, const char* sum) {
  return {{"name", name},
          {"version", CLIPPER2_VERSION},
          {"language", "C++"},
          {"sum", sum},
          {"numbers", "double"},
          {"arithmetic", "integer-grid"},
          {"capabilities", {"plane", "non-convex"}}};
}

// Only operands on the grid are taken. A union moves a vertex by the rounding of its coordinates,
// which truncates: a unit at most, and another unit if an intersection moves into its scanbeam.
// Together with omitted triangles smaller than two units: four units.
int run(std::string_view mode) {
  if (mode == "boundary") {
    json value = hello("clipper2", "boundary");
    value["grid"] = {{"bits", bits - 2}};
    value["tolerance"] = {{"absolute", "0"}, {"relative", "1/134217728"}};  // 4 units of 2^-29
    return serve(value, {boundary_sum});
  }
  if (mode == "region") {
    json value = hello("clipper2-region", "region");
    value["grid"] = {{"bits", bits - 2}};
    value["tolerance"] = {{"absolute", "0"}, {"relative", "1/134217728"}};
    for (const char* more : {"holes", "components", "touching", "union"}) {
      value["capabilities"].push_back(more);
    }
    return serve(value, {region_sum, unite});
  }
  if (mode == "double") {
    json value = hello("clipper2-double", "boundary");
    value["grid"] = {{"unit", "1/100"}, {"largest", "1e15"}};  // 62 bits, a hundred times that
    // Four units of two decimals, and the division by a hundred.
    value["tolerance"] = {{"absolute", "0.04"}, {"relative", "1e-15"}};
    return serve(value, {double_sum});
  }
  if (mode == "inflate") {
    json value = hello("clipper2-inflate", "none");
    value["grid"] = {{"bits", bits - 2}};
    value["tolerance"] = {{"absolute", "0"}, {"relative", "1/134217728"}, {"radius", "0.001"}};
    for (const char* more :
         {"holes", "components", "touching", "empty", "point", "segment", "offset", "inset",
          "line-offset", "join-mitre", "join-bevel", "join-square", "cap-flat", "cap-square"}) {
      value["capabilities"].push_back(more);
    }
    return serve(value, {nullptr, nullptr, nullptr, grow});
  }
  std::cerr << "usage: clipper2_adapter boundary|region|double|inflate\n";
  return 2;
}

}  // namespace
}  // namespace minkref::adapter

int main(int count, char** arguments) {
  return minkref::adapter::run(count > 1 ? arguments[1] : "");
}
