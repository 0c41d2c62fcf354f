#include "reference/plane/critical/edge_directions.hpp"

#include <map>

namespace minkref::inline plane {
namespace {

using V = Vector2<Rational>;

struct Before {
  bool operator()(const V& a, const V& b) const {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  }
};

}  // namespace

EdgeDirections edge_directions(const std::vector<RationalEdge>& edges) {
  EdgeDirections result;
  std::map<V, std::uint32_t, Before> numbers;
  for (const RationalEdge& edge : edges) {
    const bool forward = edge.d.x() > 0 || (edge.d.x() == 0 && edge.d.y() > 0);
    // Divided by the sum of magnitudes, all vectors of a direction agree.
    const Rational length = (abs(edge.d.x()) + abs(edge.d.y())) * Rational(forward ? 1 : -1);
    const V along{Rational(edge.d.x() / length), Rational(edge.d.y() / length)};
    const auto [place, fresh] =
        numbers.try_emplace(along, static_cast<std::uint32_t>(numbers.size()));
    if (fresh) result.along.push_back(along);
    result.line.push_back(place->second);
    result.forward.push_back(forward ? 1 : 0);
  }
  return result;
}

}  // namespace minkref::inline plane
