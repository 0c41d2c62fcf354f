#include "oracle/checker/space/solid_sum.hpp"

#include <algorithm>

#include "oracle/checker/sha256.hpp"
#include "oracle/checker/space/solid_shells.hpp"

namespace minkref::checker {
namespace {

const std::string& kind_of(const Value& entry) {
  require(!items(entry).empty(), "a list is empty");
  const Value& first = items(entry)[0];
  require(first.kind == Value::Kind::text, "there is no such entry");
  return first.text;
}

}  // namespace

struct SolidSum::Reach {
  std::map<PiecePair, mpz_class> tops, lows;
  std::vector<PiecePair> above, beneath;  // pairs with points there that also meet the plane
};

SolidSum::SolidSum(const Value& value, const std::array<PieceList, 2>& lists, const mpz_class& unit,
                   Budget& budget)
    : budget_(&budget) {
  const auto parts = members(value, "scaling planes");
  scaling_ = triple(*parts[0]);
  mpz_class common = 1;
  for (const mpq_class& factor : scaling_) {
    require(factor > 0, "a factor of the scaling is not positive");
    common = lcm(common, factor.get_den());
  }
  unit_ = unit * common;
  const mpq_class whole(unit_);
  Triple scaled;
  for (std::size_t k = 0; k < 3; ++k) scaled[k] = scaling_[k] * whole;
  const std::array<Triple, 2> factors{scaled, Triple{whole, whole, whole}};
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<Whole> points;
    for (const Triple& point : lists[k].points) points.push_back(times(factors[k], point));
    operands_.emplace_back(hulls_of(lists[k], points, budget), budget);
  }
  const std::map<OrientedPlane, std::set<Whole>> planes = find_planes();
  const auto& entries = items(*parts[1]);
  for (const Value& entry : entries) items(entry, 3);
  demand(entries.size() == planes.size(), "there are more planes, or fewer");
  std::size_t n = 0;
  for (const auto& found : planes) {
    within("plane " + std::to_string(n), [&] {
      const OrientedPlane& plane = found.first;
      const auto& [normal, level] = plane;
      const auto& of = items(entries[n], 3);
      bool same = true;
      for (std::size_t k = 0; k < 3; ++k) {
        same = integer(items(of[0], 3)[k]) == normal[k] && same;
      }
      demand(mpq_class(number(of[1]) * unit_) == level && same, "another is expected");
      ConvexPolygon plate;
      for (const Whole& p : hull_in_plane({found.second.begin(), found.second.end()}, normal)) {
        plate.push_back({p[0], p[1], p[2], 1});
      }
      follow(plane, std::move(plate), of[2]);
    });
    ++n;
  }
}

std::map<OrientedPlane, std::set<Whole>> SolidSum::find_planes() const {
  std::map<OrientedPlane, std::set<Whole>> planes;
  std::set<Whole> normals = operands_[0].normals();
  normals.merge(operands_[1].normals());
  for (const Whole& n : normals) {
    const auto theirs = operands_[1].tops(n, *budget_);
    for (const auto& [one, height] : operands_[0].tops(n, *budget_)) {
      budget_->spend(theirs.size());
      for (const auto& [other, level] : theirs) {
        if (one->size() < 3 && other->size() < 3) continue;
        budget_->spend(one->size() * other->size());
        std::set<Whole>& corners = planes[{n, mpz_class(height + level)}];
        for (const Whole& p : *one) {
          for (const Whole& q : *other) corners.insert(plus(p, q));
        }
      }
    }
  }
  add_edges(planes);
  return planes;
}

void SolidSum::add_edges(std::map<OrientedPlane, std::set<Whole>>& planes) const {
  mpz_class height, level;
  for (const SolidPieces::Edge& e : operands_[0].edges()) {
    for (const SolidPieces::Edge& f : operands_[1].edges()) {
      budget_->spend(1);
      const Feature &one = *e.ends, &other = *f.ends;
      const Whole n = primitive(cross(minus(one[1], one[0]), minus(other[1], other[0])));
      if (is_zero(n)) continue;
      for (const Whole& m : {n, negative(n)}) {
        if (!e.is_top(m, height) || !f.is_top(m, level)) continue;
        std::set<Whole>& corners = planes[{m, mpz_class(height + level)}];
        for (const Whole& p : one) {
          for (const Whole& q : other) corners.insert(plus(p, q));
        }
      }
    }
  }
}

const std::vector<HalfSpace>& SolidSum::bounds(const PiecePair& pair) {
  std::vector<HalfSpace>& found = bounds_[pair];
  if (!found.empty()) return found;
  const Hull &A = operands_[0].hulls()[pair.first], &B = operands_[1].hulls()[pair.second];
  std::vector<Whole> normals;  // the box's normals first
  for (std::size_t k = 0; k < 3; ++k) {
    Whole axis;
    axis[k] = 1;
    normals.push_back(axis);
    normals.push_back(negative(axis));
  }
  std::set<Whole> others;
  for (const Hull* hull : {&A, &B}) {
    for (const auto& [normal, ring] : hull->facets) others.insert(normal);
  }
  for (const Whole& e : A.ways) {
    for (const Whole& f : B.ways) {
      const Whole n = primitive(cross(e, f));
      if (is_zero(n)) continue;
      others.insert(n);
      others.insert(negative(n));
    }
  }
  for (const Whole& axis : normals) others.erase(axis);
  normals.insert(normals.end(), others.begin(), others.end());
  budget_->spend(normals.size() * (A.points.size() + B.points.size()));
  for (const Whole& n : normals) found.emplace_back(n, A.support(n) + B.support(n));
  return found;
}

void SolidSum::follow(const OrientedPlane& plane, ConvexPolygon whole, const Value& tree) {
  const auto& [normal, level] = plane;
  const Whole down = negative(normal);
  std::array<std::vector<mpz_class>, 2> tops, lows;
  for (std::size_t k = 0; k < 2; ++k) {
    tops[k] = operands_[k].supports(normal);
    lows[k] = operands_[k].supports(down);
  }
  budget_->spend(tops[0].size() * tops[1].size());
  Reach reach;
  for (std::size_t i = 0; i < tops[0].size(); ++i) {
    for (std::size_t j = 0; j < tops[1].size(); ++j) {
      const mpz_class top = tops[0][i] + tops[1][j], low = -lows[0][i] - lows[1][j];
      if (low <= level && level < top) reach.above.emplace_back(i, j);
      if (low < level && level <= top) reach.beneath.emplace_back(i, j);
      reach.tops[{i, j}] = top;
      reach.lows[{i, j}] = low;
    }
  }
  std::vector<ConvexPolygon> stack{std::move(whole)};
  std::size_t n = 0;
  for (const Value& entry : items(tree)) {
    within("entry " + std::to_string(n), [&] {
      const std::string& kind = kind_of(entry);
      require(!stack.empty(), "nothing is left to be cut");
      const ConvexPolygon polygon = std::move(stack.back());
      stack.pop_back();
      if (kind != "cut") return follow_end(plane, polygon, entry, reach);
      const auto& of = items(entry, 5);
      HalfSpace half{{integer(of[1]), integer(of[2]), integer(of[3])}, integer(of[4]) * unit_};
      auto part = below(polygon, half, *budget_);
      half = {negative(half.first), mpz_class(-half.second)};
      auto other = below(polygon, half, *budget_);
      demand(part && other && !part->empty() && !other->empty(), "it does not cut");
      stack.push_back(std::move(*other));
      stack.push_back(std::move(*part));
    });
    ++n;
  }
  require(stack.empty(), "entries are missing");
}

void SolidSum::follow_end(const OrientedPlane& plane, const ConvexPolygon& polygon,
                          const Value& entry, const Reach& reach) {
  const std::string& kind = kind_of(entry);
  if (kind == "none") {
    items(entry, 1);
    demand(is_free(polygon, reach.beneath), "a sum of two pieces is below it");
    return;
  }
  require(kind == "above" || kind == "face", "there is no such entry");
  const auto& of = items(entry, 3);
  const std::size_t i = index(of[1], operands_[0].hulls().size());
  const PiecePair pair{i, index(of[2], operands_[1].hulls().size())};
  for (const HalfSpace& half : bounds(pair)) {
    demand(!below(polygon, half, *budget_), "it does not lie in the sum of these pieces");
  }
  if (kind == "above") {
    demand(reach.tops.at(pair) > plane.second, "the sum of these pieces is not above it");
    return;
  }
  demand(reach.lows.at(pair) < plane.second, "the sum of these pieces is not below it");
  demand(is_free(polygon, reach.above), "a sum of two pieces is above it");
  faces_[plane].push_back(polygon);
}

bool SolidSum::is_free(const ConvexPolygon& polygon, const std::vector<PiecePair>& pairs) {
  return std::none_of(pairs.begin(), pairs.end(), [&](const PiecePair& pair) {
    ConvexPolygon left = polygon;
    for (const HalfSpace& half : bounds(pair)) {
      auto part = below(left, half, *budget_);
      if (!part) continue;
      if (part->empty()) return false;
      left = std::move(*part);
    }
    return true;
  });
}

std::string SolidSum::check_numbers(const std::array<const Value*, 3>& claimed) const {
  if (std::all_of(claimed.begin(), claimed.end(), [](auto* value) { return value->is_null(); })) {
    return "";
  }
  const SolidNumbers found = solid_numbers(faces_, *budget_);
  std::array<mpz_class, 3> given;
  for (std::size_t k = 0; k < 3; ++k) given[k] = integer(*claimed[k]);
  demand(given[0] == found.components && given[1] == found.cavities && given[2] == found.tunnels,
         "components, cavities or tunnels are not so many");
  return given[0].get_str() + " components, " + given[1].get_str() + " cavities, " +
         given[2].get_str() + " tunnels, ";
}

std::string SolidSum::check_claim(const std::vector<const Value*>& claim) const {
  demand(triple(*claim[2]) == scaling_, "the sum is at another scaling");
  const CanonicalForm form = canonical_form(faces_, unit_, *budget_);
  const mpz_class planes = integer(*claim[3]), polygons = integer(*claim[4]);
  demand(planes == form.planes && polygons == form.polygons, "planes or polygons are not so many");
  demand(number(*claim[5]) == form.volume, "the volume is another");
  const std::string digest = sha256(form.text);
  demand(claim[6]->kind == Value::Kind::text && claim[6]->text == digest, "the digest is another");
  return "sum: at (" + to_text(scaling_) + "), " + planes.get_str() + " planes, " +
         check_numbers({claim[7], claim[8], claim[9]}) + "volume " + form.volume.get_str() + ", " +
         digest;
}

}  // namespace minkref::checker
