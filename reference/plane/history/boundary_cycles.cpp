#include "reference/plane/history/boundary_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/no_entry.hpp"
#include "reference/plane/kernel/grid_kernel.hpp"

namespace minkref::inline plane {
namespace {}

CycleFinder::CycleFinder(const std::vector<RationalEdge>& edges) : edges_(edges) {
  for (const RationalEdge& e : edges) {
    x_.push_back(to_double(e.d.x()));
    y_.push_back(to_double(e.d.y()));
    const int y = sign(e.d.y());
    upper_.push_back(y > 0 || (y == 0 && sign(e.d.x()) > 0));
  }
}

int CycleFinder::turn(std::uint32_t a, std::uint32_t b) const {
  if (a == b) return 0;
  const double left = x_[a] * y_[b], right = y_[a] * x_[b];
  const double bound = (std::abs(left) + std::abs(right)) * filter_bound + 1e-300;
  if (left - right > bound) return 1;
  if (left - right < -bound) return -1;
  const auto &u = edges_[a].d, &v = edges_[b].d;
  return sign(Rational(u.x() * v.y() - u.y() * v.x()));
}

bool CycleFinder::same_direction(std::uint32_t a, std::uint32_t b) const {
  return upper(a) == upper(b) && turn(a, b) == 0;
}

int CycleFinder::half_turns(std::uint32_t a, std::uint32_t b) const {
  if (upper(a) == upper(b)) return 0;
  const int side = turn(a, b);
  if (side == 0) throw std::logic_error("boundary_cycles: a boundary that turns back");
  return side;
}

void CycleFinder::prepare(std::size_t points) {
  for (const std::uint32_t p : touched_) first_[p] = no_entry;
  touched_.clear();
  if (first_.size() < points) first_.resize(points, no_entry);
}

std::vector<std::uint32_t> CycleFinder::remove_duplicates(std::vector<BoundaryLink>& links) {
  std::size_t points = 0;
  for (const BoundaryLink& link : links) points = std::max<std::size_t>(points, link.from + 1);
  prepare(points);
  follow_.assign(links.size(), no_entry);
  std::vector<std::uint32_t> place(links.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const BoundaryLink link = links[i];
    std::uint32_t k = first_[link.from];
    while (k != no_entry && !(links[k].to == link.to && same_direction(links[k].edge, link.edge))) {
      k = follow_[k];
    }
    place[i] = k != no_entry ? k : kept;
    if (k != no_entry) continue;
    if (first_[link.from] == no_entry) touched_.push_back(link.from);
    follow_[kept] = first_[link.from];
    first_[link.from] = kept;
    links[kept++] = link;
  }
  links.resize(kept);
  return place;
}

BoundaryCycles CycleFinder::find(const std::vector<BoundaryLink>& links, bool interior) {
  std::size_t points = 0;
  for (const BoundaryLink& link : links) {
    points = std::max<std::size_t>({points, link.from + 1, link.to + 1});
  }
  prepare(points);
  pinches_.clear();
  follow_.assign(links.size(), no_entry);
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    std::uint32_t& first = first_[links[i].from];
    if (first == no_entry) {
      touched_.push_back(links[i].from);
    } else if (follow_[first] == no_entry) {
      pinches_.push_back(links[i].from);
    }
    follow_[i] = first;
    first = i;
  }

  BoundaryCycles result;
  result.next.assign(links.size(), no_entry);
  std::vector<std::uint32_t> taken(links.size(), 0);
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    const std::uint32_t out = first_[links[i].to];
    if (out == no_entry) throw std::logic_error("boundary_cycles: a boundary that does not close");
    if (follow_[out] == no_entry) {
      result.next[i] = out;
      ++taken[out];
      continue;
    }
    // The leaving link that follows the reversed arriving one clockwise (across the interior) or
    // counter-clockwise (across the exterior).
    const auto angle_less = [&](std::uint32_t a, bool a_reversed, std::uint32_t b) {
      const bool ua = upper(a) != a_reversed, ub = upper(b);
      if (ua != ub) return ub;
      return turn(a, b) * (a_reversed ? -1 : 1) > 0;
    };
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
      if (upper(a) != upper(b)) return upper(b);
      return turn(a, b) > 0;
    };
    std::uint32_t best = no_entry, extreme = no_entry;
    for (std::uint32_t k = out; k != no_entry; k = follow_[k]) {
      const bool above = angle_less(links[i].edge, true, links[k].edge);  // reversed(i) < k
      const auto better = [&](std::uint32_t other) {
        return other == no_entry || (interior ? less(links[other].edge, links[k].edge)
                                              : less(links[k].edge, links[other].edge));
      };
      if (above != interior && better(best)) best = k;
      if (better(extreme)) extreme = k;
    }
    result.next[i] = best != no_entry ? best : extreme;
    ++taken[result.next[i]];
  }
  if (std::any_of(taken.begin(), taken.end(), [](std::uint32_t n) { return n != 1; })) {
    throw std::logic_error("boundary_cycles: edges that do not alternate around a point");
  }

  result.cycle.assign(links.size(), no_entry);
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    if (result.cycle[i] != no_entry) continue;
    const auto name = static_cast<std::uint32_t>(result.cycles.size());
    int turns = 0;
    std::uint32_t k = i;
    do {
      result.cycle[k] = name;
      turns += half_turns(links[k].edge, links[result.next[k]].edge);
      k = result.next[k];
    } while (k != i);
    if (turns != 2 && turns != -2) {
      throw std::logic_error("boundary_cycles: a boundary that winds");
    }
    result.cycles.push_back({i, turns > 0});
  }
  return result;
}

}  // namespace minkref::inline plane
