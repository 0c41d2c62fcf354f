#include "reference/space/critical/meeting_facets.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "reference/build/stage.hpp"
#include "reference/error.hpp"
#include "reference/space/critical/coplanar_facets.hpp"

namespace minkref::inline space {

double below(const EventScale& number) {
  return number.rounded() - std::abs(number.rounded()) * 0x1p-50;
}

double above(const EventScale& number) {
  return number.rounded() + std::abs(number.rounded()) * 0x1p-50;
}

bool share_a_side(const MovingFacet& a, const MovingFacet& b) {
  const auto has = [&](const ConvolutionFacet::Corner& corner, std::size_t& at) {
    for (at = 0; at < b.size; ++at) {
      if (b.names[at].of_P == corner.of_P && b.names[at].of_Q == corner.of_Q) return true;
    }
    return false;
  };
  for (std::size_t k = 0; k < a.size; ++k) {
    std::size_t first = 0, second = 0;
    if (!has(a.names[k], first) || !has(a.names[(k + 1) % a.size], second)) continue;
    const std::size_t way = (first + b.size - second) % b.size;
    if (way == 1 || way == std::size_t{b.size} - 1U) return true;
  }
  return false;
}

void refuse_long_list(MostEvents most) {
  throw LimitExceeded(MostEvents::code,
                      "the list has more than " + std::to_string(most.count) + " events",
                      "take a smaller window of scales");
}

namespace {

/// A facet with a larger number that a facet meets, and when.
struct Neighbour {
  std::uint32_t number : 31, is_coplanar : 1;
  double low, high;
};

class MeetingFacets {
 public:
  MeetingFacets(std::size_t count, std::vector<MeetingPair> meeting)
      : starts_(count + 1), neighbours_(meeting.size()) {
    std::sort(meeting.begin(), meeting.end(), [](const MeetingPair& a, const MeetingPair& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    });
    for (const MeetingPair& pair : meeting) ++starts_[pair.first + 1];
    for (std::size_t k = 0; k < count; ++k) starts_[k + 1] += starts_[k];
    for (std::size_t k = 0; k < meeting.size(); ++k) {
      neighbours_[k] = {meeting[k].second, meeting[k].are_coplanar, meeting[k].low,
                        meeting[k].high};
    }
  }

  const Neighbour* begin(std::uint32_t facet) const { return neighbours_.data() + starts_[facet]; }
  const Neighbour* end(std::uint32_t facet) const {
    return neighbours_.data() + starts_[facet + 1];
  }
  /// In planes that cross.
  bool meet(std::uint32_t facet, std::uint32_t larger) const {
    const auto found = std::lower_bound(
        begin(facet), end(facet), larger,
        [](const Neighbour& each, std::uint32_t number) { return each.number < number; });
    return found != end(facet) && found->number == larger && !found->is_coplanar;
  }

 private:
  std::vector<std::size_t> starts_;
  std::vector<Neighbour> neighbours_;
};

class ConcurrentSearch {
 public:
  ConcurrentSearch(const MovingConvolution& convolution, const MeetingFacets& meeting,
                   const FacetTracks::Window& window)
      : convolution_(convolution),
        meeting_(meeting),
        window_(window),
        with_first_(convolution.facets.size(), nullptr) {}

  /// Looks at all triples whose first facet is i.
  void look_at(std::uint32_t i, const BuildControl& control, MostEvents most) {
    const Neighbour *begin = meeting_.begin(i), *end = meeting_.end(i);
    for (const Neighbour* k = begin; k != end; ++k) with_first_[k->number] = k;
    for (const Neighbour* j = begin; j != end; ++j) {
      control.look();
      look_at(i, *j);
      if (events.size() > most.count) refuse_long_list(most);
    }
    for (const Neighbour* k = begin; k != end; ++k) with_first_[k->number] = nullptr;
  }

  std::vector<ConcurrentEvent> events;
  std::uint64_t tracks = 0;
  SignCounts signs;

 private:
  void look_at(std::uint32_t i, const Neighbour& pair) {
    const std::uint32_t j = pair.number;
    std::optional<FacetTracks> found;
    for (const Neighbour* of_j = meeting_.begin(j); of_j != meeting_.end(j); ++of_j) {
      const Neighbour* of_i = with_first_[of_j->number];
      if (of_i == nullptr || std::max({pair.low, of_i->low, of_j->low}) >
                                 std::min({pair.high, of_i->high, of_j->high})) {
        continue;
      }
      const CoplanarTriple triple{{named(i), named(j), named(of_j->number)},
                                  across(pair, *of_i, *of_j)};
      if (pair.is_coplanar || of_i->is_coplanar || of_j->is_coplanar) {
        add_coplanar_events(convolution_, triple, window_, signs, events);
        continue;
      }
      if (!found) found.emplace(convolution_, named(i), named(j), window_, signs);
      found->add(triple.facets[2], events);
    }
    if (!found) return;
    tracks += found->tracks();
    found->add_crossings([&](std::uint32_t k, std::uint32_t l) { return meeting_.meet(k, l); },
                         events);
  }

  /// The facet among three that crosses the others' common plane, if they share one.
  static std::size_t across(const Neighbour& j_of_i, const Neighbour& k_of_i,
                            const Neighbour& k_of_j) {
    if (!k_of_i.is_coplanar && !k_of_j.is_coplanar) return 2;
    if (!j_of_i.is_coplanar && !k_of_j.is_coplanar) return 1;
    if (!j_of_i.is_coplanar && !k_of_i.is_coplanar) return 0;
    return CoplanarTriple::none;
  }

  FacetTracks::Facet named(std::uint32_t number) const {
    return {number, &convolution_.facets[number]};
  }

  const MovingConvolution& convolution_;
  const MeetingFacets& meeting_;
  const FacetTracks::Window& window_;
  std::vector<const Neighbour*> with_first_;  ///< of the facet that is the first one now
};

}  // namespace

void add_concurrent_events(const MovingConvolution& convolution, std::vector<MeetingPair> meeting,
                           const EventScale& from, const EventScale& to,
                           const BuildControl& control, MostEvents most, CriticalEvents& result) {
  const std::size_t count = convolution.facets.size();
  const MeetingFacets facets(count, std::move(meeting));
  const FacetTracks::Window window{from, to, below(from), above(to)};
  std::vector<std::unique_ptr<ConcurrentSearch>> searches(control.threads());
  in_parallel(count, control, BuildProgress::Stage::pairs, [&](unsigned thread) {
    searches[thread] = std::make_unique<ConcurrentSearch>(convolution, facets, window);
    return [&, search = searches[thread].get()](std::size_t i) {
      search->look_at(static_cast<std::uint32_t>(i), control, most);
    };
  });
  std::size_t all = 0;
  for (const auto& search : searches) all += search ? search->events.size() : 0;
  result.concurrent.reserve(all);
  for (auto& search : searches) {
    if (!search) continue;
    std::move(search->events.begin(), search->events.end(), std::back_inserter(result.concurrent));
    result.tracks += search->tracks;
    result.signs.add(search->signs);
    search.reset();
  }
  std::sort(result.concurrent.begin(), result.concurrent.end(),
            [](const ConcurrentEvent& a, const ConcurrentEvent& b) {
              const int order = a.s.compare(b.s);
              return order != 0 ? order < 0
                                : std::tie(a.facets, a.sides) < std::tie(b.facets, b.sides);
            });
}

}  // namespace minkref::inline space
