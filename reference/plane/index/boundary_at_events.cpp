#include "reference/plane/index/boundary_at_events.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "reference/no_entry.hpp"

namespace minkref::inline plane {
namespace {

/// The boundary at one event.
class Event {
 public:
  Event(const MovingBoundary& boundary, const EdgeDirections& directions,
        const std::vector<std::vector<std::uint32_t>>& leaving, std::uint32_t event)
      : boundary_(boundary),
        directions_(directions),
        leaving_(leaving),
        event_(event),
        scale_(boundary.events[event]) {}

  BoundaryAtEvent run(const std::vector<std::uint32_t>& ended,
                      const std::vector<std::uint32_t>& begun,
                      const std::vector<std::uint32_t>& touching) {
    for (const auto* list : {&ended, &begun}) {
      for (const std::uint32_t link : *list) {
        add_point(boundary_.links[link].from);
        add_point(boundary_.links[link].to);
      }
    }
    for (const std::uint32_t track : touching) add_point(track);
    unite_points();
    for (const std::uint32_t link : ended) add_segment(link, true);
    for (const std::uint32_t link : begun) add_segment(link, false);
    std::sort(segments_.begin(), segments_.end(), [](const Segment& a, const Segment& b) {
      return std::tie(a.line, a.offset) < std::tie(b.line, b.offset);
    });
    for (std::size_t k = 0; k < segments_.size();) {
      const std::size_t first = k;
      while (k < segments_.size() && segments_[k].line == segments_[first].line &&
             segments_[k].offset == segments_[first].offset) {
        ++k;
      }
      line(first, k);
    }
    find_pinches();
    return std::move(result_);
  }

 private:
  struct Place {
    Point point;
    std::uint32_t track;
  };
  /// `low` and `high`: numbers of points, sorted along a line.
  struct Segment {
    std::uint32_t line;
    Rational offset;
    std::uint32_t low, high;
    bool forward, below;
    std::uint32_t link;
  };
  /// Between two points in a row on a line; links by [below, above][backward, forward].
  struct Slot {
    std::uint32_t links[2][2] = {{no_entry, no_entry}, {no_entry, no_entry}};
  };

  void add_point(std::uint32_t track) { places_.push_back({{}, track}); }

  void unite_points() {
    std::sort(places_.begin(), places_.end(),
              [](const Place& a, const Place& b) { return a.track < b.track; });
    places_.erase(std::unique(places_.begin(), places_.end(),
                              [](const Place& a, const Place& b) { return a.track == b.track; }),
                  places_.end());
    for (Place& place : places_) place.point = boundary_.tracks[place.track].at(scale_);
    std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
      return std::tie(a.point.x, a.point.y, a.track) < std::tie(b.point.x, b.point.y, b.track);
    });
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const bool fresh = k == 0 || places_[k].point != places_[k - 1].point;
      if (fresh) {
        points_.push_back(k);
      } else {
        result_.merged.emplace_back(places_[k].track, places_[points_.back()].track);
      }
      number_.emplace_back(places_[k].track, static_cast<std::uint32_t>(points_.size() - 1));
    }
    std::sort(result_.merged.begin(), result_.merged.end());
    std::sort(number_.begin(), number_.end());
  }

  std::uint32_t number(std::uint32_t track) const {
    return std::lower_bound(number_.begin(), number_.end(), std::pair(track, 0U))->second;
  }
  std::uint32_t track(std::uint32_t point) const { return places_[points_[point]].track; }

  void add_segment(std::uint32_t index, bool below) {
    const MovingLink& link = boundary_.links[index];
    const std::uint32_t from = number(link.from), to = number(link.to);
    if (from == to) return;
    const std::uint32_t line = directions_.line[link.edge];
    const bool forward = directions_.forward[link.edge] != 0;
    if (forward != (from < to)) {
      throw std::logic_error("a link of the swept sum runs backwards at an event");
    }
    const auto& along = directions_.along[line];
    const Point& p = places_[points_[from]].point;
    segments_.push_back({line, along.x() * p.y - along.y() * p.x, std::min(from, to),
                         std::max(from, to), forward, below, index});
  }

  /// Compares all segments on one line.
  void line(std::size_t first, std::size_t last) {
    std::vector<std::uint32_t> ends;
    for (std::size_t k = first; k < last; ++k) {
      ends.push_back(segments_[k].low);
      ends.push_back(segments_[k].high);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<Slot> slots(ends.size() - 1);
    const auto place = [&](std::uint32_t point) {
      return static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), point) -
                                      ends.begin());
    };
    for (std::size_t k = first; k < last; ++k) {
      const Segment& segment = segments_[k];
      const std::size_t end = place(segment.high);
      for (std::size_t slot = place(segment.low); slot < end; ++slot) {
        std::uint32_t& link = slots[slot].links[segment.below ? 0 : 1][segment.forward ? 1 : 0];
        link = std::min(link, segment.link);
      }
    }
    for (std::size_t k = 0; k < slots.size(); ++k)
      piece(slots[k], track(ends[k]), track(ends[k + 1]));
  }

  void piece(const Slot& slot, std::uint32_t low, std::uint32_t high) {
    const auto& [below, above] = slot.links;
    const auto is_folded = [](const auto& links) {
      return links[0] != no_entry && links[1] != no_entry;
    };
    if (is_folded(below) || is_folded(above)) result_.folded.emplace_back(low, high);
    const auto direction = [&](const auto& links) {
      return is_folded(links) || (links[0] == no_entry && links[1] == no_entry) ? 0
             : links[1] != no_entry                                             ? 1
                                                                                : -1;
    };
    if (direction(below) != direction(above)) {
      throw std::logic_error("the boundary of the swept sum jumps at the scale " +
                             to_string(scale_));
    }
    if (direction(below) == 0) return;
    const int way = direction(below) > 0 ? 1 : 0;
    result_.pieces.push_back({way != 0 ? low : high, way != 0 ? high : low,
                              boundary_.links[below[way]].edge, below[way], above[way]});
  }

  void find_pinches() {
    std::vector<std::uint32_t> leaving(points_.size());
    for (const auto& [track, point] : number_) {
      for (const std::uint32_t link : leaving_[track]) {
        const MovingLink& l = boundary_.links[link];
        leaving[point] += l.first <= event_ && l.last > event_ ? 1 : 0;
      }
    }
    for (const BoundaryLink& piece : result_.pieces) ++leaving[number(piece.from)];
    result_.pinched =
        std::any_of(leaving.begin(), leaving.end(), [](std::uint32_t n) { return n > 1; });
  }

  const MovingBoundary& boundary_;
  const EdgeDirections& directions_;
  const std::vector<std::vector<std::uint32_t>>& leaving_;
  std::uint32_t event_;
  const Rational& scale_;
  std::vector<Place> places_;
  std::vector<std::size_t> points_;                              // the first place of each
  std::vector<std::pair<std::uint32_t, std::uint32_t>> number_;  // of tracks, among the points
  std::vector<Segment> segments_;
  BoundaryAtEvent result_;
};

}  // namespace

std::vector<BoundaryAtEvent> boundary_at_events(const MovingBoundary& boundary,
                                                const EdgeDirections& directions,
                                                const BuildControl& control) {
  const std::size_t count = boundary.events.size();
  std::vector<std::vector<std::uint32_t>> ended(count), begun(count), touching(count),
      leaving(boundary.tracks.size());
  for (std::uint32_t k = 0; k < boundary.links.size(); ++k) {
    const MovingLink& link = boundary.links[k];
    if (link.last < count) ended[link.last].push_back(k);
    if (link.first > 0) begun[link.first - 1].push_back(k);
    leaving[link.from].push_back(k);
  }
  for (const TrackContact& contact : boundary.contacts) {
    touching[contact.event].push_back(contact.a);
    touching[contact.event].push_back(contact.b);
  }
  std::vector<BoundaryAtEvent> result;
  for (std::uint32_t k = 0; k < count; ++k) {
    control.look();
    result.push_back(Event(boundary, directions, leaving, k).run(ended[k], begun[k], touching[k]));
  }
  return result;
}

}  // namespace minkref::inline plane
