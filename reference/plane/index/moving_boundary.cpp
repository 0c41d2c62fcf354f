#include "reference/plane/index/moving_boundary.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

#include "reference/plane/index/piece_track.hpp"

namespace minkref::inline plane {
namespace {

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
    bool operator()(const Track& a, const Track& b) const {
      return std::tie(a.a.x, a.a.y, a.b.x, a.b.y) < std::tie(b.a.x, b.a.y, b.b.x, b.b.y);
    }
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

/// Contacts of edges that both have a piece at the scale, each once.
std::vector<EndContact> contacts_of(const SweptBoundary& boundary, const BuildControl& control) {
  const auto has_piece = [&](std::uint32_t edge, const Rational& scale) {
    const auto first =
        std::partition_point(boundary.pieces.begin(), boundary.pieces.end(),
                             [&](const ExposedPiece& piece) { return piece.edge < edge; });
    for (auto piece = first; piece != boundary.pieces.end() && piece->edge == edge; ++piece) {
      if (piece->lower <= scale && (!piece->upper || scale <= *piece->upper)) return true;
    }
    return false;
  };
  std::vector<EndContact> result;
  for (const EndContact& contact : boundary.contacts) {
    control.look();
    if (contact.edge < contact.other && has_piece(contact.edge, contact.scale) &&
        has_piece(contact.other, contact.scale)) {
      result.push_back(contact);
    }
  }
  std::sort(result.begin(), result.end(), [](const EndContact& x, const EndContact& y) {
    return std::tie(x.scale, x.edge, x.other) < std::tie(y.scale, y.edge, y.other);
  });
  return result;
}

std::vector<Rational> events_of(const SweptBoundary& boundary,
                                const std::vector<EndContact>& contacts) {
  std::vector<Rational> events;
  for (const EndContact& contact : contacts) events.push_back(contact.scale);
  for (const ExposedPiece& piece : boundary.pieces) {
    events.push_back(piece.lower);
    if (piece.upper) events.push_back(*piece.upper);
  }
  std::sort(events.begin(), events.end());
  events.erase(std::unique(events.begin(), events.end()), events.end());
  const Rational from = boundary.window.from.value_or(Rational(0));
  std::erase_if(events, [&](const Rational& s) {
    return s <= from || (boundary.window.to && s >= *boundary.window.to);
  });
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
  const std::vector<EndContact> contacts = contacts_of(boundary, control);
  result.events = events_of(boundary, contacts);
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
  TrackNumbers number(boundary, result.tracks);
  std::vector<MovingLink> all;
  for (const ExposedPiece& piece : boundary.pieces) {
    control.look();
    all.push_back({number(piece.edge, piece.from), number(piece.edge, piece.to), piece.edge,
                   interval_above(piece.lower),
                   piece.upper ? interval_below(*piece.upper)
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
  for (const EndContact& contact : contacts) {
    control.look();
    const std::uint32_t event = interval_below(contact.scale);
    if (event == result.events.size() || result.events[event] != contact.scale) continue;
    using Kind = NodeName::Kind;
    for (const Kind own : {Kind::own_start, Kind::own_end}) {
      for (const Kind others : {Kind::own_start, Kind::own_end}) {
        const auto a = number.known(contact.edge, {own, contact.edge}),
                   b = number.known(contact.other, {others, contact.other});
        if (a && b && *a != *b &&
            result.tracks[*a].at(contact.scale) == result.tracks[*b].at(contact.scale)) {
          result.contacts.push_back({event, *a, *b});
        }
      }
    }
  }
  return result;
}

}  // namespace minkref::inline plane
