#include "reference/plane/dynamic/edge_sweep.hpp"

#include <algorithm>
#include <span>

#include "reference/interrupt.hpp"
#include "reference/plane/dynamic/collision_status.hpp"
#include "reference/plane/dynamic/edge_happenings.hpp"
#include "reference/plane/dynamic/passing_edges.hpp"
#include "reference/plane/dynamic/swept_edge.hpp"
#include "reference/plane/dynamic/winding_status.hpp"

namespace minkref::inline plane {
namespace {

bool in(const std::vector<std::uint32_t>& set, std::uint32_t x) {
  return std::find(set.begin(), set.end(), x) != set.end();
}

}  // namespace

struct EdgeSweep::Impl {
  const ArrangementEvents& events;
  SweptEdge edge;
  std::unique_ptr<GapStatus> decide;
  EdgeHappenings all_happenings;

  // The edge being swept; nodes by their local numbers.
  std::vector<Happening> happenings;
  std::vector<std::uint32_t> list;
  std::vector<Status> status;           ///< of the gap after each element of the list
  std::vector<std::uint32_t> sub_edge;  ///< likewise
  EdgeHistory* out = nullptr;

  Impl(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events_,
       ConvolutionType of)
      : events(events_),
        edge(P, Q, events_),
        decide(of == ConvolutionType::full ? winding_status(P, Q, events_, edge)
                                           : collision_status(P, Q, events_, edge)),
        all_happenings(events_) {}

  void change(std::uint32_t step, NodeChange::Kind kind, std::size_t index) {
    out->changes.push_back(
        {step, edge.edge(), edge.name(list[index]), static_cast<std::uint32_t>(index - 1), kind});
  }

  std::uint32_t open(std::uint32_t x, std::uint32_t y, std::uint32_t interval) {
    out->sub_edges.push_back({edge.edge(), edge.name(x), edge.name(y), interval, EdgeNode::always});
    return static_cast<std::uint32_t>(out->sub_edges.size() - 1);
  }

  void run(std::uint32_t which, EdgeHistory& history) {
    out = &history;
    edge.load(which);
    all_happenings.of(which, happenings);
    first_order();
    auto& names = history.initial.emplace_back();
    for (std::size_t i = 1; i + 1 < list.size(); ++i) names.push_back(edge.name(list[i]));

    const std::uint32_t first_group =
        happenings.empty() ? EdgeNode::always : happenings.front().group;
    status.assign(list.size() - 1, Status::interior);
    sub_edge.assign(list.size() - 1, no_sub_edge);
    decide->begin(list, first_group, status);
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
      if (status[i] == Status::boundary) sub_edge[i] = open(list[i], list[i + 1], 0);
    }
    for (std::size_t i = 0; i < happenings.size();) {
      std::size_t j = i;
      look_for_interrupt();
      while (j < happenings.size() && happenings[j].group == happenings[i].group) ++j;
      const std::uint32_t next = j < happenings.size() ? happenings[j].group : EdgeNode::always;
      pass(std::span(happenings).subspan(i, j - i), next);
      i = j;
    }
    const auto intervals = static_cast<std::uint32_t>(events.groups());
    for (const std::uint32_t s : sub_edge) {
      if (s != no_sub_edge) history.sub_edges[s].last = intervals;
    }
    decide->finish(history);
  }

  /// The order during interval 0: just above the window's beginning.
  void first_order() {
    list.clear();
    for (std::uint32_t n = 0; n < edge.count(); ++n) {
      if (edge.node(n).from == EdgeNode::always) list.push_back(n);
    }
    const Rational from = events.window().from.value_or(0);
    const double near_from = to_double(from);
    std::sort(list.begin(), list.end(), [&](std::uint32_t x, std::uint32_t y) {
      if (x == y) return false;
      const int order = edge.compare_at(x, y, from, near_from);
      return order != 0 ? order < 0 : edge.before_after_meeting(x, y);
    });
    list.insert(list.begin(), edge.start());
    list.push_back(edge.end());
  }

  /// A group of events on this edge.
  struct Group {
    std::uint32_t group, next;  ///< the next one on this edge
    std::vector<std::uint32_t> old;
    std::vector<Status> old_status;
    std::vector<std::uint32_t> old_sub_edge;
    std::vector<std::uint32_t> arriving, departing, changed, overlaps;
    std::vector<std::uint32_t> here;  ///< the list at its scale
    std::vector<bool> tied;           ///< of each element of `here`: in one place with the next
  };

  void pass(std::span<const Happening> happening, std::uint32_t next) {
    Group g{happening.front().group, next, list, status, sub_edge, {}, {}, {}, {}, {}, {}};
    sort_out(happening, g);
    at_the_scale(g);
    above_the_scale(g);
    carry_status(g);
  }

  void sort_out(std::span<const Happening> happening, Group& g) const {
    for (const Happening& h : happening) {
      switch (h.kind) {
        case Happening::Kind::arrival:
          g.arriving.push_back(h.first);
          g.changed.push_back(h.first);
          break;
        case Happening::Kind::departure:
          g.departing.push_back(h.first);
          g.changed.push_back(h.first);
          break;
        case Happening::Kind::swap:
          for (std::size_t i = 1; i + 1 < g.old.size(); ++i) {
            const std::uint32_t other = edge.node(g.old[i]).other;
            if (other == h.first || other == h.second) g.changed.push_back(g.old[i]);
          }
          break;
        case Happening::Kind::overlap:
          g.overlaps.push_back(h.first);
          break;
      }
    }
  }

  /// Inserts arriving nodes, and finds coincident nodes.
  void at_the_scale(Group& g) {
    for (const std::uint32_t x : g.arriving) {
      const auto place = std::lower_bound(list.begin() + 1, list.end() - 1, x,
                                          [&](std::uint32_t y, std::uint32_t z) {
                                            return edge.compare_at_group(y, z, g.group) < 0;
                                          });
      const auto index = static_cast<std::size_t>(place - list.begin());
      list.insert(place, x);
      change(2 * g.group, NodeChange::Kind::insertion, index);
    }
    g.here = list;
    g.tied.assign(list.size(), false);
    for (std::size_t i = 1; i + 1 < list.size(); ++i) {
      if (!in(g.changed, list[i])) continue;
      for (std::size_t k = i; k > 0 && !g.tied[k - 1]; --k) {
        if (edge.compare_at_group(list[k - 1], list[k], g.group) != 0) break;
        g.tied[k - 1] = true;
      }
      for (std::size_t k = i; k + 1 < list.size() && !g.tied[k]; ++k) {
        if (edge.compare_at_group(list[k], list[k + 1], g.group) != 0) break;
        g.tied[k] = true;
      }
    }
  }

  /// Deletes departing nodes, then orders the remaining coincident nodes.
  void above_the_scale(const Group& g) {
    for (std::size_t i = list.size() - 1; i-- > 1;) {
      if (!in(g.departing, list[i])) continue;
      change(2 * g.group + 1, NodeChange::Kind::deletion, i);
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    }
    for (std::size_t i = 0, first = 0; i < g.here.size();) {
      std::size_t j = i, kept = 0;
      for (;; ++j) {
        kept += !in(g.departing, g.here[j]);
        if (!g.tied[j]) break;
      }
      for (std::size_t k = first + 1; k < first + kept; ++k) {
        for (std::size_t m = k; m > first && edge.before_after_meeting(list[m], list[m - 1]); --m) {
          const bool settles = in(g.arriving, list[m]) || in(g.arriving, list[m - 1]);
          change(2 * g.group + 1, settles ? NodeChange::Kind::settling : NodeChange::Kind::swap,
                 m - 1);
          std::swap(list[m - 1], list[m]);
        }
      }
      first += kept;
      i = j + 1;
    }
  }

  std::vector<Stretch> stretches_of(const Group& g) const {
    std::vector<Stretch> stretches;
    std::size_t before = 0, after = 0;
    for (std::size_t i = 0; i + 1 < g.here.size(); ++i) {
      const std::uint32_t from = g.here[i], to = g.here[i + 1];
      before += !in(g.arriving, from);
      after += !in(g.departing, from);
      if (!g.tied[i] && !edge.same_track(from, to)) {
        stretches.push_back({from, to, before - 1, after - 1, false, i});
      }
    }
    if (g.overlaps.empty()) return stretches;
    const Rational scale = events.exact(g.group);
    for (Stretch& stretch : stretches) {
      const Point point = edge.middle(stretch.from, stretch.to, scale);
      stretch.overlapped = std::any_of(g.overlaps.begin(), g.overlaps.end(), [&](std::uint32_t f) {
        return runs_along(edge.moving(), events.moving()[f], point, scale);
      });
    }
    return stretches;
  }

  /// Sets each gap's status above the group, and continues sub-edges or opens new ones.
  void carry_status(const Group& g) {
    std::vector<Stretch> stretches = stretches_of(g);
    status.assign(list.size() - 1, Status::interior);
    sub_edge.assign(list.size() - 1, no_sub_edge);
    const EdgePassage passage{g.group, g.next, list, stretches, g.old_status, g.overlaps};
    decide->pass(passage, status);
    for (std::size_t j = 0, k = 0; j + 1 < list.size(); ++j) {
      const std::size_t first = k;
      bool overlapped = false;
      for (; k < stretches.size() && stretches[k].after == j; ++k) {
        overlapped = overlapped || stretches[k].overlapped;
      }
      if (status[j] != Status::boundary) continue;
      sub_edge[j] = continued(g, stretches, first, k, j);
      if (sub_edge[j] == no_sub_edge) {
        sub_edge[j] = open(list[j], list[j + 1], g.group + 1);
      } else if (k - first == 1 && !overlapped) {
        stretches[first].goes_on = true;
      } else {
        out->interrupted.emplace_back(g.group, sub_edge[j]);
      }
    }
    for (const std::uint32_t s : g.old_sub_edge) {
      if (s != no_sub_edge && !in(sub_edge, s)) out->sub_edges[s].last = g.group;
    }
    pieces_at_the_scale(g, stretches, passage);
    coincident(g, stretches);
  }

  /// The sub-edge continuing as gap j, formed by stretches `first` to `end`, if its ends and whole
  /// length remain.
  std::uint32_t continued(const Group& g, const std::vector<Stretch>& stretches, std::size_t first,
                          std::size_t end, std::size_t j) const {
    if (first == end) return no_sub_edge;
    const std::size_t gap = stretches[first].before;
    const bool whole = (first == 0 || stretches[first - 1].before != gap) &&
                       stretches[end - 1].before == gap &&
                       (end == stretches.size() || stretches[end].before != gap);
    const bool same_ends = g.old[gap] == list[j] && g.old[gap + 1] == list[j + 1];
    return whole && same_ends ? g.old_sub_edge[gap] : no_sub_edge;
  }

  void pieces_at_the_scale(const Group& g, const std::vector<Stretch>& stretches,
                           const EdgePassage& passage) {
    for (const Stretch& stretch : stretches) {
      const bool was = g.old_status[stretch.before] == Status::boundary;
      const bool is = status[stretch.after] == Status::boundary;
      if (stretch.goes_on || !(was || is)) continue;
      const bool now = stretch.overlapped ? decide->on_boundary_at(stretch, passage) : was && is;
      if (!now) continue;
      out->at_groups.push_back({g.group, edge.edge(), edge.name(stretch.from),
                                edge.name(stretch.to), g.old_sub_edge[stretch.before],
                                sub_edge[stretch.after]});
    }
  }

  /// Blocks of coincident nodes that the boundary touches, before or after.
  void coincident(const Group& g, const std::vector<Stretch>& stretches) {
    const auto touches = [&](std::size_t first, std::size_t last) {
      return std::any_of(stretches.begin(), stretches.end(), [&](const Stretch& stretch) {
        return (stretch.from_index + 1 == first || stretch.from_index == last) &&
               (g.old_status[stretch.before] == Status::boundary ||
                status[stretch.after] == Status::boundary);
      });
    };
    for (std::size_t i = 0; i < g.here.size(); ++i) {
      if (!g.tied[i]) continue;
      std::size_t j = i;
      while (g.tied[j]) ++j;
      if (touches(i, j)) {
        CoincidentNodes block{g.group, edge.edge(), {}};
        for (std::size_t k = i; k <= j; ++k) block.nodes.push_back(edge.name(g.here[k]));
        out->coincident.push_back(std::move(block));
      }
      i = j;
    }
  }
};

EdgeSweep::EdgeSweep(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events,
                     ConvolutionType of)
    : impl_(std::make_unique<Impl>(P, Q, events, of)) {}
EdgeSweep::~EdgeSweep() = default;

void EdgeSweep::sweep(std::uint32_t edge, EdgeHistory& history) { impl_->run(edge, history); }

}  // namespace minkref::inline plane
