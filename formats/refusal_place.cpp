#include "formats/refusal_place.hpp"

#include <utility>

namespace minkref {
namespace {

void rename(std::optional<std::size_t>& ring, std::vector<std::size_t>& vertices,
            const std::vector<RingOrigin>& origins) {
  if (!ring || *ring >= origins.size()) return;
  const RingOrigin& origin = origins[*ring];
  ring = origin.ring;
  for (std::size_t& vertex : vertices) vertex = origin.index_in_file(vertex);
}

}  // namespace

Place place_in_file(Place place, const std::vector<RingOrigin>& origins) {
  const std::optional<std::size_t> ring_of_set = place.ring;
  rename(place.ring, place.vertices, origins);
  rename(place.other_ring, place.other_vertices, origins);
  if (!place.line && ring_of_set && *ring_of_set < origins.size()) {
    const auto& lines = origins[*ring_of_set].lines;
    const std::size_t first = place.vertices.empty() ? 0 : place.vertices.front();
    if (first < lines.size() && lines[first] > 0) place.line = lines[first];
  }
  return place;
}

void validate_as_read(const PolygonSet& set, const std::vector<RingOrigin>& origins,
                      const std::string& source, Lines lines) {
  refuse_in_file([&] { validate(set, lines); },
                 [&](const Place& place) { return place_in_file(place, origins); }, source);
}

}  // namespace minkref
