#include "reference/paper/trials/space_sum_trial.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/paper/trials/misplaced.hpp"
#include "reference/space/surface/lifted_regions.hpp"

namespace minkref {
namespace {

using Rings = std::vector<PaperSpaceSum::Ring>;

Rational distance(const SpacePoint& a, const SpacePoint& b) {
  return std::max({Rational(abs(a.x - b.x)), Rational(abs(a.y - b.y)), Rational(abs(a.z - b.z))});
}

/// The largest error of a corner if the rings match, turned to fit; nothing beyond `most`.
std::optional<Rational> distance(const PaperSpaceSum::Ring& ring, const PaperSpaceSum::Ring& other,
                                 const Rational& most) {
  if (ring.size() != other.size()) return std::nullopt;
  for (std::size_t shift = 0; shift < other.size(); ++shift) {
    Rational off = 0;
    for (std::size_t k = 0; k < ring.size() && off <= most; ++k) {
      off = std::max(off, distance(ring[k], other[(k + shift) % other.size()]));
    }
    if (off <= most) return off;
  }
  return std::nullopt;
}

std::optional<Rational> distance(const Rings& wanted, Rings offered, const Rational& most) {
  if (wanted.size() != offered.size()) return std::nullopt;
  Rational off = 0;
  for (const auto& ring : wanted) {
    std::optional<Rational> found;
    for (std::size_t k = 0; !found && k < offered.size(); ++k) {
      found = distance(ring, offered[k], most);
      if (found) offered.erase(offered.begin() + static_cast<std::ptrdiff_t>(k));
    }
    if (!found) return std::nullopt;
    off = std::max(off, *found);
  }
  return off;
}

std::optional<Rational> distance(const PaperSpaceSum& wanted, const PaperSpaceSum& answer,
                                 const Rational& most) {
  if (wanted.exposed.size() != answer.exposed.size()) return std::nullopt;
  Rational off = 0;
  for (std::size_t k = 0; k < wanted.exposed.size(); ++k) {
    look_for_interrupt();
    if (wanted.exposed[k].facet != answer.exposed[k].facet) return std::nullopt;
    const auto found = distance(wanted.exposed[k].rings, answer.exposed[k].rings, most);
    if (!found) return std::nullopt;
    off = std::max(off, *found);
  }
  return off;
}

Rational largest(const PaperSpaceSum& sum) {
  Rational most = 0;
  for (const auto& part : sum.exposed) {
    for (const auto& ring : part.rings) {
      for (const SpacePoint& corner : ring) most = std::max(most, distance(corner, {0, 0, 0}));
    }
  }
  return most;
}

/// An answer beside the exact set, for a plane.
struct PlaneAnswers {
  const PolygonSet* exact = nullptr;
  PolygonSet answered;
};

}  // namespace

SpaceSumTrial space_sum_trial(const PaperSpaceUpdate& update, const Rational& scale,
                              const PaperSpaceSum& answer, const PaperSpaceSum& truth,
                              const PolyhedralSet& exact, const Rational& limit) {
  SpaceSumTrial trial;
  trial.coordinate = largest(truth);
  if (const auto off = distance(truth, answer, Rational(limit * trial.coordinate))) {
    trial.same_structure = true;
    trial.error = *off;
    return trial;
  }
  std::map<OrientedPlane, PlaneAnswers> planes;
  for (const PlaneRegion& face : exact.faces) planes[face.plane].exact = &face.region;
  for (const auto& part : answer.exposed) {
    const OrientedPlane plane = update.plane(part.facet, scale);
    for (Polygon& ring : rings_in_view(part, plane).polygons) {
      planes[plane].answered.polygons.push_back(std::move(ring));
    }
  }
  for (const auto& cell : answer.cells) {
    look_for_interrupt();
    const OrientedPlane plane = update.plane(cell.facet, scale);
    const PlaneAnswers& known = planes[plane];
    const Point at = seen(cell.inside, viewing_axis(plane.normal));
    const Location is = known.exact ? locate(*known.exact, at) : Location::outside;
    const bool said = cell.exposed || locate(known.answered, at) == Location::inside;
    if (said ? is != Location::outside : is != Location::inside) continue;
    trial.witness = {lifted(at, plane), plane, is == Location::inside};
    return trial;
  }
  return trial;
}

SpaceEventTrial space_event_trial(std::vector<PaperSpaceUpdate::Event> truth,
                                  std::vector<PaperSpaceUpdate::Event> answer, long bits) {
  using Event = PaperSpaceUpdate::Event;
  const auto key = [](const Event& event) {
    return std::tuple(event.first, event.second, event.crossing, event.insertion);
  };
  const auto before = [&](const Event& a, const Event& b) { return key(a) < key(b); };
  std::sort(truth.begin(), truth.end(), before);
  std::sort(answer.begin(), answer.end(), before);
  SpaceEventTrial trial;
  trial.events = truth.size();
  auto at = answer.begin();
  for (const Event& event : truth) {
    look_for_interrupt();
    for (; at != answer.end() && before(*at, event); ++at) ++trial.invented;
    if (at == answer.end() || before(event, *at)) {
      ++trial.missed;
      continue;
    }
    const Rational off = abs(Rational(at->scale - event.scale));
    const bool is_right = bits == 0 ? sign(off) == 0 : off <= ulp(event.scale, bits);
    ++(is_right ? trial.right : trial.misplaced);
    ++at;
  }
  trial.invented += static_cast<std::uint64_t>(answer.end() - at);
  return trial;
}

}  // namespace minkref
