// Laws for arrangements of segments, checked against a brute-force subdivision.
#pragma once

#include <map>
#include <set>
#include <string>

#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"
#include "tests/plane/contact_by_edges.hpp"

namespace minkref::testing {

using ExactKernel = PlainKernel<Rational>;
using ExactArrangement = Arrangement<ExactKernel>;

/// Counter-clockwise from the angle -180 degrees, the direction (-1, 0).
inline bool less_angle(const Point& a, const Point& b) {
  const auto half = [](const Point& d) {
    const int y = sign(d.y);
    return y < 0 || (y == 0 && sign(d.x) < 0) ? 0 : 1;
  };
  return half(a) != half(b) ? half(a) < half(b) : sign(cross(a, b)) > 0;
}

class ArrangementLaws {
 public:
  explicit ArrangementLaws(std::vector<Edge> segments)
      : segments_(std::move(segments)), built_(build(kernel_, segments_)) {
    for (std::uint32_t n = 0; n < built_.node_count(); ++n) {
      const auto& at = built_.node(n);
      nodes_.push_back({at.x(), at.y()});
    }
  }

  /// The first fault, or nothing.
  std::string fault() const {
    for (const auto law :
         {&ArrangementLaws::nodes, &ArrangementLaws::sub_edges, &ArrangementLaws::half_edges,
          &ArrangementLaws::order_round_nodes, &ArrangementLaws::faces, &ArrangementLaws::euler}) {
      const std::string fault = (this->*law)();
      if (!fault.empty()) return fault;
    }
    return "";
  }

  const ExactArrangement& arrangement() const { return built_; }
  const Point& at(std::uint32_t node) const { return nodes_[node]; }

 private:
  static ExactArrangement build(const ExactKernel& kernel, const std::vector<Edge>& segments) {
    std::vector<Vector2<Rational>> vertices;
    std::vector<IndexedSegment> indexed;
    for (const Edge& e : segments) {
      const auto n = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back({e.from.x, e.from.y});
      vertices.push_back({e.to.x, e.to.y});
      indexed.push_back({n, n + 1});
    }
    return ExactArrangement(kernel, vertices, indexed);
  }

  struct Less {
    bool operator()(const Point& a, const Point& b) const { return less_xy(a, b); }
  };

  /// Ends and meetings of segments, each once; and where each came from.
  std::string nodes() const {
    std::set<Point, Less> expected, actual(nodes_.begin(), nodes_.end());
    for (const Edge& a : segments_) {
      expected.insert({a.from, a.to});
      for (const Edge& b : segments_) {
        for (const Rational& t : meeting(a, b)) expected.insert(a.from + t * (a.to - a.from));
      }
    }
    if (actual.size() != nodes_.size()) return "two nodes at one point";
    if (actual != expected) return "nodes are not the ends and meetings";
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
      const auto& from = built_.provenance(n);
      if (from.vertex != ExactArrangement::none) {
        const Edge& e = segments_[from.vertex / 2];
        if ((from.vertex % 2 == 0 ? e.from : e.to) != nodes_[n]) return "not this vertex";
        continue;
      }
      for (const std::uint32_t s : {from.first, from.second}) {
        if (s >= segments_.size()) return "a crossing without its segments";
        const Edge& e = segments_[s];
        if (nodes_[n] == e.from || nodes_[n] == e.to || !on_segment(nodes_[n], e.from, e.to)) {
          return "not in the interior of its segments";
        }
      }
      const Edge &a = segments_[from.first], &b = segments_[from.second];
      if (sign(cross(a.to - a.from, b.to - b.from)) == 0) return "its segments do not cross";
    }
    return "";
  }

  /// Each segment is the union of the pieces between consecutive nodes; these pieces are all the
  /// sub-edges, and each is covered by exactly the segments that contain it.
  std::string sub_edges() const {
    using Covers = std::set<std::pair<std::uint32_t, bool>>;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Covers> expected;
    for (std::uint32_t s = 0; s < segments_.size(); ++s) {
      const Edge& e = segments_[s];
      std::vector<std::pair<Rational, std::uint32_t>> stops;
      for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
        if (on_segment(nodes_[n], e.from, e.to)) {
          stops.push_back({dot(nodes_[n] - e.from, e.to - e.from), n});
        }
      }
      std::sort(stops.begin(), stops.end());
      for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const std::uint32_t a = stops[i].second, b = stops[i + 1].second;
        expected[std::minmax(a, b)].insert({s, a < b});
      }
    }
    if (built_.half_edge_count() != 2 * expected.size()) return "another number of sub-edges";
    for (std::uint32_t h = 0; h < built_.half_edge_count(); ++h) {
      const std::uint32_t a = built_.origin(h), b = built_.target(h);
      const auto found = expected.find(std::minmax(a, b));
      if (found == expected.end()) return "a sub-edge that is none";
      Covers covers;
      for (const auto* c = built_.covers_begin(h); c != built_.covers_end(h); ++c) {
        if (!covers.insert({c->segment, built_.runs_with(h, *c) == (a < b)}).second) {
          return "a cover twice";
        }
      }
      if (covers != found->second) return "covers are not the segments along the sub-edge";
    }
    return "";
  }

  Point direction(std::uint32_t h) const { return at(built_.target(h)) - at(built_.origin(h)); }

  std::string half_edges() const {
    const std::uint32_t count = static_cast<std::uint32_t>(built_.half_edge_count());
    std::vector<bool> reached(count);
    for (std::uint32_t h = 0; h < count; ++h) {
      if (built_.origin(h) == built_.target(h)) return "a loop";
      if (built_.target(h ^ 1U) != built_.origin(h)) return "twins";
      if (built_.next(h) >= count || reached[built_.next(h)]) return "next is no bijection";
      reached[built_.next(h)] = true;
      if (built_.origin(built_.next(h)) != built_.target(h)) return "next does not start there";
      if (built_.face(h) != built_.face(built_.next(h))) return "a cycle with two faces";
      const auto d = built_.direction(h);
      const Point own{d.x(), d.y()};
      if (sign(cross(own, direction(h))) != 0 || sign(dot(own, direction(h))) <= 0) {
        return "another direction";
      }
    }
    return "";
  }

  std::string order_round_nodes() const {
    std::size_t leaving = 0;
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
      const std::vector<std::uint32_t> round(built_.leaving_begin(n), built_.leaving_end(n));
      leaving += round.size();
      for (std::size_t i = 0; i < round.size(); ++i) {
        if (built_.origin(round[i]) != n) return "leaves another node";
        if (i > 0 && !less_angle(direction(round[i - 1]), direction(round[i]))) {
          return "not counter-clockwise from -180 degrees";
        }
        // The face is on the left: arriving along a half-edge, the next leaves clockwise of its
        // twin.
        const std::uint32_t before = round[(i + round.size() - 1) % round.size()];
        if (built_.next(round[i] ^ 1U) != before) return "next is not the neighbour round the node";
      }
    }
    return leaving == built_.half_edge_count() ? "" : "not all half-edges leave their nodes";
  }

  std::vector<std::uint32_t> cycle(std::uint32_t first) const {
    std::vector<std::uint32_t> all;
    std::uint32_t h = first;
    do {
      all.push_back(h);
      h = built_.next(h);
    } while (h != first);
    return all;
  }

  Rational doubled(const std::vector<std::uint32_t>& cycle) const {
    Rational area = 0;
    for (const std::uint32_t h : cycle) area += cross(at(built_.origin(h)), at(built_.target(h)));
    return area;
  }

  int winding(const std::vector<std::uint32_t>& cycle, const Point& x) const {
    int number = 0;
    for (const std::uint32_t h : cycle) {
      const Point &a = at(built_.origin(h)), &b = at(built_.target(h));
      if ((a.y > x.y) == (b.y > x.y)) continue;
      const int side = sign(cross(b - a, x - a));
      if (b.y > a.y ? side > 0 : side < 0) number += b.y > a.y ? 1 : -1;
    }
    return number;
  }

  std::vector<std::uint32_t> component_of_nodes() const {
    std::vector<std::uint32_t> name(nodes_.size());
    for (std::uint32_t n = 0; n < name.size(); ++n) name[n] = n;
    for (bool again = true; again;) {
      again = false;
      for (std::uint32_t h = 0; h < built_.half_edge_count(); ++h) {
        auto &a = name[built_.origin(h)], &b = name[built_.target(h)];
        if (a != b) again = true;
        a = b = std::min(a, b);
      }
    }
    return name;
  }

  /// A positive cycle bounds a separate face; any other cycle belongs to the face of the smallest
  /// positive cycle that surrounds it in another component, or to the unbounded face.
  std::string faces() const {
    const std::vector<std::uint32_t> component = component_of_nodes();
    std::vector<int> visits(built_.half_edge_count()), positive(built_.face_count());
    std::vector<std::vector<std::uint32_t>> outer;
    for (std::uint32_t f = 0; f < built_.face_count(); ++f) {
      for (const std::uint32_t first : built_.cycles(f)) {
        if (built_.face(first) != f) return "a cycle of another face";
        if (sign(doubled(cycle(first))) > 0) {
          ++positive[f];
          outer.push_back(cycle(first));
        }
      }
      if (positive[f] != (f == 0 ? 0 : 1)) return "not one outer cycle for each bounded face";
      std::string fault;
      built_.for_each_half_edge(f, [&](std::uint32_t h) {
        ++visits[h];
        if (built_.face(h) != f) fault = "visits a half-edge of another face";
      });
      if (!fault.empty()) return fault;
    }
    for (const int count : visits) {
      if (count != 1) return "a half-edge in no face or in two";
    }
    for (std::uint32_t f = 0; f < built_.face_count(); ++f) {
      for (const std::uint32_t first : built_.cycles(f)) {
        if (sign(doubled(cycle(first))) > 0) continue;
        std::uint32_t around = 0;
        Rational least = 0;
        for (const auto& candidate : outer) {
          if (component[built_.origin(candidate[0])] == component[built_.origin(first)]) continue;
          const Rational size = doubled(candidate);
          if (winding(candidate, at(built_.origin(first))) != 0 && (around == 0 || size < least)) {
            around = built_.face(candidate[0]);
            least = size;
          }
        }
        if (around != f) return "a component in the wrong face";
      }
    }
    return "";
  }

  std::string euler() const {
    const std::vector<std::uint32_t> component = component_of_nodes();
    const std::size_t parts = std::set<std::uint32_t>(component.begin(), component.end()).size();
    return nodes_.size() + built_.face_count() == built_.half_edge_count() / 2 + 1 + parts
               ? ""
               : "V - E + F is not 1 + C";
  }

  std::vector<Edge> segments_;
  ExactKernel kernel_;
  ExactArrangement built_;
  std::vector<Point> nodes_;
};

}  // namespace minkref::testing
