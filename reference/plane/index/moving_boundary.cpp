#include "reference/plane/index/moving_boundary.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

#include "reference/no_entry.hpp"
#include "reference/plane/index/piece_track.hpp"

namespace minkref::inline plane {
namespace {

bool is_track_before(const Track& a, const Track& b) {
  return std::tie(a.a.x, a.a.y, a.b.x, a.b.y) < std::tie(b.a.x, b.a.y, b.b.x, b.b.y);
}

/// Numbers for distinct tracks, with a shortcut for tracks asked for by the same name.
class TrackNumbers {
 public:
  TrackNumbers(const SweptBoundary& boundary, std::vector<Track>& tracks)
      : boundary_(boundary), tracks_(tracks) {}

  /// None for an absent track.
  std::optional<std::uint32_t> known(std::uint32_t edge, const NodeName& node) const {
    const auto found = by_track_.find(track_of(boundary_, edge, node));
    return found == by_track_.end() ? std::nullopt : std::optional(found->second);
  }

  std::uint32_t operator()(std::uint32_t edge, const NodeName& node) {
    if (node.kind != NodeName::Kind::crossing) return number(track_of(boundary_, edge, node));
    const auto [low, high] = std::minmax(edge, node.other);
    const auto [place, fresh] = by_crossing_.try_emplace(std::uint64_t{low} << 32 | high, 0U);
    if (fresh) place->second = number(track_of(boundary_, edge, node));
    return place->second;
  }

 private:
  struct Before {
    bool operator()(const Track& a, const Track& b) const { return is_track_before(a, b); }
  };
  std::uint32_t number(Track track) {
    const auto [place, fresh] =
        by_track_.try_emplace(track, static_cast<std::uint32_t>(tracks_.size()));
    if (fresh) tracks_.push_back(std::move(track));
    return place->second;
  }

  const SweptBoundary& boundary_;
  std::vector<Track>& tracks_;
  std::unordered_map<std::uint64_t, std::uint32_t> by_crossing_;
  std::map<Track, std::uint32_t, Before> by_track_;
};

/// An exposed piece between numbered tracks.
struct ExposedStretch {
  std::uint32_t edge = 0, from = 0, to = 0;
  Rational lower;
  std::optional<Rational> upper;

  bool holds(const Rational& scale) const { return lower <= scale && (!upper || scale <= *upper); }
};

/// Joins an edge's pieces between the same tracks, cut from each other by events elsewhere along
/// the edge. The result and its order depend on the boundary alone, not on the crossings inside the
/// sum known to the sweep.
std::vector<ExposedStretch> stretches_of(const SweptBoundary& boundary, TrackNumbers& number,
                                         const std::vector<Track>& tracks,
                                         const BuildControl& control) {
  std::vector<ExposedStretch> all;
  for (const ExposedPiece& piece : boundary.pieces) {
    control.look();
    all.push_back({piece.edge, number(piece.edge, piece.from), number(piece.edge, piece.to),
                   piece.lower, piece.upper});
  }
  std::sort(all.begin(), all.end(), [](const ExposedStretch& a, const ExposedStretch& b) {
    return std::tie(a.edge, a.from, a.to, a.lower) < std::tie(b.edge, b.from, b.to, b.lower);
  });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    control.look();
    if (kept > 0) {
      ExposedStretch& last = all[kept - 1];
      if (last.edge == all[k].edge && last.from == all[k].from && last.to == all[k].to &&
          last.upper == all[k].lower) {
        last.upper = std::move(all[k].upper);
        continue;
      }
    }
    if (kept != k) all[kept] = std::move(all[k]);
    ++kept;
  }
  all.resize(kept);
  std::sort(all.begin(), all.end(), [&](const ExposedStretch& a, const ExposedStretch& b) {
    if (a.edge != b.edge) return a.edge < b.edge;
    if (a.lower != b.lower) return a.lower < b.lower;
    if (a.from != b.from) return is_track_before(tracks[a.from], tracks[b.from]);
    return a.to != b.to && is_track_before(tracks[a.to], tracks[b.to]);
  });
  return all;
}

/// Finds corners of the boundary that touch at a contact's scale.
class ContactSearch {
 public:
  ContactSearch(const SweptBoundary& boundary, const std::vector<ExposedStretch>& stretches,
                const TrackNumbers& number, const std::vector<Track>& tracks)
      : boundary_(boundary), stretches_(stretches), number_(number), tracks_(tracks) {
    for (std::uint32_t k = 0; k < stretches.size(); ++k) {
      for (const std::uint32_t track : {stretches[k].from, stretches[k].to}) {
        ends_.emplace_back(track, k);
      }
    }
    std::sort(ends_.begin(), ends_.end());
  }

  struct Found {
    Rational scale;
    std::uint32_t a, b;
  };
  /// Each pair of tracks once at a scale, by scale.
  std::vector<Found> find(const BuildControl& control) const {
    std::vector<Found> result;
    for (const EndContact& contact : boundary_.contacts) {
      control.look();
      using Kind = NodeName::Kind;
      for (const Kind own : {Kind::own_start, Kind::own_end}) {
        const auto a = end(contact.edge, own, contact.scale);
        if (!a) continue;
        for (const Kind others : {Kind::own_start, Kind::own_end}) {
          const auto b = end(contact.other, others, contact.scale);
          if (b && *a != *b && tracks_[*a].at(contact.scale) == tracks_[*b].at(contact.scale)) {
            result.push_back({contact.scale, std::min(*a, *b), std::max(*a, *b)});
          }
        }
      }
    }
    std::sort(result.begin(), result.end(), [](const Found& x, const Found& y) {
      return std::tie(x.scale, x.a, x.b) < std::tie(y.scale, y.a, y.b);
    });
    result.erase(std::unique(result.begin(), result.end(),
                             [](const Found& x, const Found& y) {
                               return std::tie(x.scale, x.a, x.b) == std::tie(y.scale, y.a, y.b);
                             }),
                 result.end());
    return result;
  }

 private:
  /// The track of an edge's end, if the boundary has a corner there at the scale.
  std::optional<std::uint32_t> end(std::uint32_t edge, NodeName::Kind kind,
                                   const Rational& scale) const {
    const auto track = number_.known(edge, {kind, edge});
    if (!track) return std::nullopt;
    const auto first = std::lower_bound(ends_.begin(), ends_.end(), std::pair(*track, 0U));
    for (auto k = first; k != ends_.end() && k->first == *track; ++k) {
      if (stretches_[k->second].holds(scale)) return track;
    }
    return std::nullopt;
  }

  const SweptBoundary& boundary_;
  const std::vector<ExposedStretch>& stretches_;
  const TrackNumbers& number_;
  const std::vector<Track>& tracks_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;  // tracks, with their stretches
};

std::vector<Rational> events_of(const ScaleWindow& window,
                                const std::vector<ExposedStretch>& stretches,
                                const std::vector<ContactSearch::Found>& contacts) {
  std::vector<Rational> events;
  for (const auto& contact : contacts) events.push_back(contact.scale);
  for (const ExposedStretch& stretch : stretches) {
    events.push_back(stretch.lower);
    if (stretch.upper) events.push_back(*stretch.upper);
  }
  std::sort(events.begin(), events.end());
  events.erase(std::unique(events.begin(), events.end()), events.end());
  const Rational from = window.from.value_or(Rational(0));
  std::erase_if(events,
                [&](const Rational& s) { return s <= from || (window.to && s >= *window.to); });
  return events;
}

/// Links between the same two tracks: keeps each direction once, and neither if both occur.
class PairOfTracks {
 public:
  explicit PairOfTracks(MovingBoundary& result) : result_(result) {}

  /// `links`: all links between two tracks, in any order.
  void sort_out(const std::vector<MovingLink>& links) {
    if (links.size() == 1) {
      result_.links.push_back(links[0]);
      return;
    }
    std::vector<std::uint32_t> cuts;  // intervals with changes
    for (const MovingLink& link : links) {
      cuts.push_back(link.first);
      cuts.push_back(link.last + 1);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const MovingLink *up = nullptr, *down = nullptr;
      for (const MovingLink& link : links) {
        if (link.first > cuts[k] || link.last < cuts[k]) continue;
        const MovingLink*& known = link.from < link.to ? up : down;
        if (known == nullptr || link.edge < known->edge) known = &link;
      }
      auto& list = up != nullptr && down != nullptr ? result_.passages : result_.links;
      for (const MovingLink* link : {up, down}) {
        if (link != nullptr) add(list, *link, cuts[k], cuts[k + 1] - 1);
      }
    }
  }

 private:
  static void add(std::vector<MovingLink>& list, MovingLink link, std::uint32_t first,
                  std::uint32_t last) {
    if (!list.empty()) {
      MovingLink& before = list.back();
      if (before.from == link.from && before.to == link.to && before.edge == link.edge &&
          before.last + 1 == first) {
        before.last = last;
        return;
      }
    }
    link.first = first;
    link.last = last;
    list.push_back(link);
  }

  MovingBoundary& result_;
};

}  // namespace

MovingBoundary moving_boundary(const SweptBoundary& boundary, const BuildControl& control) {
  MovingBoundary result;
  std::vector<Track> tracks;
  TrackNumbers number(boundary, tracks);
  const std::vector<ExposedStretch> stretches = stretches_of(boundary, number, tracks, control);
  const auto contacts = ContactSearch(boundary, stretches, number, tracks).find(control);
  result.pieces = stretches.size();
  result.events = events_of(boundary.window, stretches, contacts);
  const auto interval_above = [&](const Rational& scale) {
    return static_cast<std::uint32_t>(
        std::upper_bound(result.events.begin(), result.events.end(), scale) -
        result.events.begin());
  };
  const auto interval_below = [&](const Rational& scale) {
    return static_cast<std::uint32_t>(
        std::lower_bound(result.events.begin(), result.events.end(), scale) -
        result.events.begin());
  };
  // Numbers tracks along the stretches.
  std::vector<std::uint32_t> numbers(tracks.size(), no_entry);
  const auto place = [&](std::uint32_t track) {
    if (numbers[track] == no_entry) {
      numbers[track] = static_cast<std::uint32_t>(result.tracks.size());
      result.tracks.push_back(tracks[track]);
    }
    return numbers[track];
  };
  std::vector<MovingLink> all;
  for (const ExposedStretch& stretch : stretches) {
    control.look();
    const std::uint32_t from = place(stretch.from), to = place(stretch.to);
    all.push_back({from, to, stretch.edge, interval_above(stretch.lower),
                   stretch.upper ? interval_below(*stretch.upper)
                                 : static_cast<std::uint32_t>(result.events.size())});
  }
  const auto ends = [](const MovingLink& link) { return std::minmax(link.from, link.to); };
  std::sort(all.begin(), all.end(), [&](const MovingLink& a, const MovingLink& b) {
    return ends(a) != ends(b) ? ends(a) < ends(b) : a.first < b.first;
  });
  PairOfTracks pair(result);
  std::vector<MovingLink> same;
  for (std::size_t k = 0; k < all.size();) {
    control.look();
    same.clear();
    const std::size_t first = k;
    while (k < all.size() && ends(all[k]) == ends(all[first])) same.push_back(all[k++]);
    pair.sort_out(same);
  }
  for (const auto& [scale, a, b] : contacts) {
    const std::uint32_t event = interval_below(scale);
    if (event == result.events.size() || result.events[event] != scale) continue;
    result.contacts.push_back({event, numbers[a], numbers[b]});
  }
  return result;
}

}  // namespace minkref::inline plane
