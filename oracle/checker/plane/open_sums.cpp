// Points and sides inside the sums of the insides of two solids: what lists of passages leave out.
#include <algorithm>

#include "oracle/checker/plane/region.hpp"

namespace minkref::checker {

std::map<Region::Contact, std::set<Region::NodePair>> Region::places_between() const {
  std::map<Contact, std::set<NodePair>> found;
  std::set<Contact> outer;
  for (const auto& [edge, cell] : owner_) {
    const auto other = owner_.find({edge.second, edge.first});
    const bool inner = other != owner_.end() && inside_[cell] && inside_[other->second];
    const Contact side{std::min(edge.first, edge.second), std::max(edge.first, edge.second)};
    for (const Contact& place : {side, Contact{edge.first}, Contact{edge.second}}) {
      if (inner) {
        found[place].insert(covers_.at(cell));
      } else {
        outer.insert(place);
      }
    }
  }
  for (const Contact& place : outer) found.erase(place);
  return found;
}

Region::NodePair Region::solid_pair(const Value& value) const {
  const auto& pair = items(value, 2);
  const std::uint32_t A = index(pair[0], P_.hulls.size()), B = index(pair[1], Q_.hulls.size());
  demand(P_.solid[A] && Q_.solid[B], "a node is not convex");
  return {A, B};
}

bool Region::is_in_open_sums(const Contact& place, const std::set<NodePair>& nodes) const {
  std::vector<std::pair<mpq_class, mpq_class>> parts;
  for (const auto& [A, B] : nodes) {
    mpq_class low = 0, high = 1;
    for (const auto* hull : {&P_.hulls[A], &Q_.hulls[B]}) {
      for (std::size_t i = 0; i < hull->size(); ++i) {
        budget_.spend(place.size());
        const Vector d = minus((*hull)[(i + 1) % hull->size()], (*hull)[i]);
        const std::uint32_t normal = normals_.add({d.y, -d.x});
        const mpq_class s = room(place.front(), A, B, normal);
        const mpq_class t = room(place.back(), A, B, normal);
        if (s <= 0 && t <= 0) {
          low = high;
        } else if (s < 0) {
          low = std::max(low, mpq_class(s / (s - t)));
        } else if (t < 0) {
          high = std::min(high, mpq_class(s / (s - t)));
        }
      }
    }
    if (low < high) parts.emplace_back(low, high);
  }
  std::sort(parts.begin(), parts.end());
  mpq_class reach = 0;
  for (const auto& [low, high] : parts) {
    if (low < reach || low == 0) reach = std::max(reach, high);
  }
  return reach == 1;
}

/// How far a point is below the plane that bounds the sum of two nodes along a normal, in some
/// unit.
mpq_class Region::room(std::uint32_t point, std::uint32_t A, std::uint32_t B,
                       std::uint32_t normal) const {
  const Triple& p = elements_[point][0];
  const Vector& n = normals_[normal];
  mpq_class level(scales_[0].get_den() * (n.x * p.a + n.y * p.b), p.c);
  level.canonicalize();
  return most(0, A, B, normal) - level;
}

}  // namespace minkref::checker
