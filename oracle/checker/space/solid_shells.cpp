#include "oracle/checker/space/solid_shells.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>

namespace minkref::checker {
namespace {

struct Part {
  OrientedPlane plane;
  ConvexPolygon polygon;
};

/// Whole numbers not above, and not below, a polygon's coordinates.
struct WholeBox {
  Whole low, high;
};

/// A direction, and its cross product with a point.
using SpaceLine = std::pair<Whole, Corner>;

/// A polygon's corners' levels above a plane, and its points there: none, one, or both ends of a
/// segment.
struct Met {
  bool rises = false, sinks = false;
  ConvexPolygon points;
};

Met met(const ConvexPolygon& polygon, const HalfSpace& plane) {
  Met found;
  std::vector<mpz_class> levels;
  for (const Corner& p : polygon) {
    levels.push_back(plane.first[0] * p[0] + plane.first[1] * p[1] + plane.first[2] * p[2] -
                     plane.second * p[3]);
    found.rises = found.rises || levels.back() > 0;
    found.sinks = found.sinks || levels.back() < 0;
  }
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t before = (k + polygon.size() - 1) % polygon.size();
    if (levels[k] == 0) found.points.push_back(polygon[k]);
    if (sgn(levels[before]) * sgn(levels[k]) >= 0) continue;
    Corner& point = found.points.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) {
      point[c] = abs(levels[k]) * polygon[before][c] + abs(levels[before]) * polygon[k][c];
    }
  }
  return found;
}

mpq_class place_along(const Whole& way, const Corner& p) {
  mpq_class place(way[0] * p[0] + way[1] * p[1] + way[2] * p[2], p[3]);
  place.canonicalize();
  return place;
}

std::pair<mpq_class, mpq_class> ends_along(const Whole& way, const ConvexPolygon& points) {
  std::vector<mpq_class> places;
  for (const Corner& p : points) places.push_back(place_along(way, p));
  const auto [low, high] = std::minmax_element(places.begin(), places.end());
  return {*low, *high};
}

bool share_a_segment(const Met& one, const Met& other, const Whole& way) {
  if (one.points.size() < 2 || other.points.size() < 2) return false;
  const auto [a, b] = ends_along(way, one.points);
  const auto [c, d] = ends_along(way, other.points);
  return std::max(a, c) < std::min(b, d);
}

WholeBox box_of(const ConvexPolygon& polygon) {
  WholeBox box;
  for (std::size_t n = 0; n < polygon.size(); ++n) {
    const Corner& p = polygon[n];
    for (std::size_t k = 0; k < 3; ++k) {
      mpz_class low, high;
      mpz_fdiv_q(low.get_mpz_t(), p[k].get_mpz_t(), p[3].get_mpz_t());
      mpz_cdiv_q(high.get_mpz_t(), p[k].get_mpz_t(), p[3].get_mpz_t());
      if (n == 0 || low < box.low[k]) box.low[k] = low;
      if (n == 0 || high > box.high[k]) box.high[k] = high;
    }
  }
  return box;
}

bool are_apart(const WholeBox& a, const WholeBox& b) {
  for (std::size_t k = 1; k < 3; ++k) {
    if (a.low[k] > b.high[k] || b.low[k] > a.high[k]) return true;
  }
  return false;
}

SpaceLine line_through(const Corner& a, const Corner& b) {
  Whole way;
  for (std::size_t k = 0; k < 3; ++k) way[k] = b[k] * a[3] - a[k] * b[3];
  way = primitive(way);
  way = std::max(way, negative(way));
  const Whole moment = cross(way, {a[0], a[1], a[2]});
  Corner at{moment[0], moment[1], moment[2], a[3]};
  mpz_class divisor;
  for (const mpz_class& c : at) divisor = gcd(divisor, c);
  for (mpz_class& c : at) c /= divisor;
  return {way, at};
}

/// Ascends from 0 with a direction's angle, counter-clockwise from x > 0, y = 0.
mpq_class turned_by(const mpz_class& x, const mpz_class& y) {
  mpq_class part(x, abs(x) + abs(y));
  part.canonicalize();
  return y >= 0 ? mpq_class(1 - part) : mpq_class(3 + part);
}

/// Six times the volume between the origin and a part of a face.
mpq_class cone(const Part& part) {
  const auto& [normal, height] = part.plane;
  const std::size_t axis = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  mpq_class area;
  for (std::size_t k = 0; k < part.polygon.size(); ++k) {
    const Corner &a = part.polygon[k], &b = part.polygon[(k + 1) % part.polygon.size()];
    mpq_class term(a[u] * b[v] - a[v] * b[u], a[3] * b[3]);
    term.canonicalize();
    area += term;
  }
  return area * height / normal[axis];
}

/// Adds neighbours first: long denominators come late.
mpq_class added(std::vector<mpq_class> values) {
  for (std::size_t step = 1; step < values.size(); step *= 2) {
    for (std::size_t k = 0; k + step < values.size(); k += 2 * step) values[k] += values[k + step];
  }
  return values[0];
}

class Shells {
 public:
  Shells(const Tiles& faces, Budget& budget) : budget_(budget) {
    for (const auto& [plane, polygons] : faces) {
      for (const ConvexPolygon& polygon : polygons) parts_.push_back({plane, polygon});
    }
    cut_parts();
    find_sides();
  }

  SolidNumbers numbers() const {
    SolidNumbers found;
    for (const Surface& shell : surfaces(inner_)) {
      found.components += shell.positive;
      found.tunnels += shell.genus;
    }
    for (const Surface& shell : surfaces(outer_)) found.cavities += !shell.positive;
    return found;
  }

 private:
  struct Surface {
    std::size_t genus = 0;
    bool positive = true;
  };
  struct Side {
    std::size_t number = 0;
    int sign = 1;
  };

  /// Cuts parts along the planes of others that share a segment with their insides.
  void cut_parts() {
    std::vector<WholeBox> boxes;
    for (const Part& part : parts_) boxes.push_back(box_of(part.polygon));
    std::vector<std::size_t> order(parts_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return boxes[i].low[0] < boxes[j].low[0]; });
    std::vector<std::set<HalfSpace>> cuts(parts_.size());
    for (std::size_t n = 0; n < order.size(); ++n) {
      for (std::size_t m = n + 1; m < order.size(); ++m) {
        const std::size_t i = order[n], j = order[m];
        if (boxes[j].low[0] > boxes[i].high[0]) break;
        budget_.spend(1);
        if (!are_apart(boxes[i], boxes[j])) add_cuts(i, j, cuts);
      }
    }
    std::vector<Part> whole;
    whole.swap(parts_);
    for (std::size_t n = 0; n < whole.size(); ++n) cut(whole[n], cuts[n]);
  }

  void add_cuts(std::size_t i, std::size_t j, std::vector<std::set<HalfSpace>>& cuts) {
    const Part &one = parts_[i], &other = parts_[j];
    const Whole way = cross(one.plane.first, other.plane.first);
    if (is_zero(way)) return;
    budget_.spend(one.polygon.size() + other.polygon.size());
    const Met of_one = met(one.polygon, other.plane), of_other = met(other.polygon, one.plane);
    if (!share_a_segment(of_one, of_other, way)) return;
    const auto add = [&](std::size_t k, const Met& reach, const HalfSpace& plane) {
      const HalfSpace turned{negative(plane.first), mpz_class(-plane.second)};
      if (reach.rises && reach.sinks) cuts[k].insert(std::max(plane, turned));
    };
    add(i, of_one, other.plane);
    add(j, of_other, one.plane);
  }

  void cut(const Part& part, const std::set<HalfSpace>& planes) {
    std::vector<ConvexPolygon> polygons{part.polygon};
    for (const HalfSpace& half : planes) {
      const HalfSpace turned{negative(half.first), mpz_class(-half.second)};
      std::vector<ConvexPolygon> kept;
      for (const ConvexPolygon& polygon : polygons) {
        for (const HalfSpace* side : {&half, &turned}) {
          auto found = below(polygon, *side, budget_);
          if (!found) {
            kept.push_back(polygon);
          } else if (!found->empty()) {
            kept.push_back(std::move(*found));
          }
        }
      }
      polygons = std::move(kept);
    }
    for (ConvexPolygon& polygon : polygons) parts_.push_back({part.plane, std::move(polygon)});
  }

  /// Numbers all sides, cut where others end along the same line.
  void find_sides() {
    std::map<SpaceLine, std::map<mpq_class, std::size_t>> stops;
    for (const Part& part : parts_) {
      for (std::size_t k = 0; k < part.polygon.size(); ++k) {
        const Corner &a = part.polygon[k], &b = part.polygon[(k + 1) % part.polygon.size()];
        const SpaceLine line = line_through(a, b);
        for (const Corner* p : {&a, &b}) stops[line][place_along(line.first, *p)] = 0;
      }
    }
    for (auto& [line, places] : stops) {
      std::size_t count = 0;
      for (auto& [place, number] : places) number = count++;
    }
    std::map<std::pair<SpaceLine, std::size_t>, std::vector<Side>> around;
    for (std::size_t n = 0; n < parts_.size(); ++n) {
      const ConvexPolygon& polygon = parts_[n].polygon;
      const std::size_t first = of_.size();
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Corner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const SpaceLine line = line_through(a, b);
        const auto& places = stops.at(line);
        const std::size_t i = places.at(place_along(line.first, a));
        const std::size_t j = places.at(place_along(line.first, b));
        const std::size_t count = std::max(i, j) - std::min(i, j);
        budget_.spend(count);
        for (std::size_t step = 0; step < count; ++step) {
          around[{line, i < j ? i + step : i - step - 1}].push_back({of_.size(), i < j ? 1 : -1});
          of_.push_back(n);
          next_.push_back(of_.size());
        }
      }
      next_.back() = first;
    }
    inner_.resize(of_.size());
    outer_.resize(of_.size());
    for (const auto& [segment, sides] : around) join(segment.first.first, sides);
  }

  /// Joins the parts around a segment. Seen against its direction the outside is to the left of a
  /// part that runs along it, and the inside to the left of one that runs back.
  void join(const Whole& way, const std::vector<Side>& sides) {
    std::vector<std::pair<mpq_class, Side>> order;
    Whole along, across;
    for (const Side& side : sides) {
      Whole inward = cross(parts_[of_[side.number]].plane.first, way);
      if (side.sign < 0) inward = negative(inward);
      if (order.empty()) {
        along = inward;
        across = cross(way, along);
      }
      order.emplace_back(turned_by(dot(inward, along), dot(inward, across)), side);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < order.size(); ++k) {
      const Side &one = order[k].second, &other = order[(k + 1) % order.size()].second;
      demand(one.sign != other.sign, "faces do not bound the sum");
      std::vector<std::size_t>& mates = one.sign > 0 ? outer_ : inner_;
      mates[one.number] = other.number;
      mates[other.number] = one.number;
    }
  }

  std::vector<Surface> surfaces(const std::vector<std::size_t>& mates) const {
    std::vector<std::size_t> root(parts_.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const std::function<std::size_t(std::size_t)> find = [&](std::size_t n) {
      while (root[n] != n) n = root[n] = root[root[n]];
      return n;
    };
    for (std::size_t h = 0; h < mates.size(); ++h) root[find(of_[h])] = find(of_[mates[h]]);
    std::map<std::size_t, long> doubled;  // Euler characteristics
    std::map<std::size_t, std::vector<mpq_class>> volumes;
    for (std::size_t n = 0; n < parts_.size(); ++n) {
      doubled[find(n)] += 2;
      volumes[find(n)].push_back(cone(parts_[n]));
    }
    std::vector<bool> done(mates.size(), false);
    for (std::size_t start = 0; start < mates.size(); ++start) {
      long& twice = doubled[find(of_[start])];
      twice -= 1;
      if (!done[start]) twice += 2;
      for (std::size_t h = start; !done[h]; h = next_[mates[h]]) done[h] = true;
    }
    std::vector<Surface> found;
    for (auto& [shell, twice] : doubled) {
      demand(twice % 4 == 0 && twice <= 4, "faces do not bound the sum");
      found.push_back(
          {static_cast<std::size_t>((4 - twice) / 4), added(std::move(volumes[shell])) > 0});
    }
    return found;
  }

  Budget& budget_;
  std::vector<Part> parts_;
  std::vector<std::size_t> of_, next_;      // the part of each side; the next side along the part
  std::vector<std::size_t> inner_, outer_;  // across the solid's inside, and across its outside
};

}  // namespace

SolidNumbers solid_numbers(const Tiles& faces, Budget& budget) {
  return Shells(faces, budget).numbers();
}

}  // namespace minkref::checker
