// Scales at which convex pieces collide while moving along a path, for plane and space.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/motion/moving_pieces_of.hpp"

namespace minkref::inline motion {

/// Ranges in doubles, rounded to the outside.
std::vector<ScaleGap> gaps_of(const std::vector<ScaleRange>& ranges);

/// The window's scales where some triple collides. Exact.
template <class Geometry>
ScaleSet collisions_of(const MovingPiecesOf<Geometry>& pieces, const ScaleWindow& window,
                       PathStatistics& statistics) {
  const bool strict = pieces.is_strict();
  ScaleSet collisions;
  std::vector<ScaleGap> gaps = gaps_of(collisions.left_of(window));
  pieces.each(gaps, false, [&](const PieceTriple& triple) {
    ++statistics.exact_triples;
    const auto found = pieces.scales(triple);
    if (!found) return;
    const ScaleCut from{found->from, strict || found->from == 0};
    std::optional<ScaleCut> to;
    if (found->to) to = ScaleCut{*found->to, !strict};
    collisions.add(from, to);
    gaps = gaps_of(collisions.left_of(window));
  });
  statistics.pieces_of_part = pieces.part().size();
  statistics.pieces_of_obstacles = pieces.obstacles().size();
  statistics.triples = pieces.triples();
  return collisions;
}

/// A triple whose collisions begin (`blocks`) or end at a scale, with their place on the path.
template <class Point>
struct CollisionEnd {
  Rational scale;
  bool blocks = true;
  PathPlaceOf<Point> at;
  PieceTriple triple;
};

/// For each end of the valid scales within the window, the first triple along the path. Ascending.
/// Exact.
template <class Geometry>
std::vector<CollisionEnd<typename Geometry::Point>> ends_of_collisions(
    const MovingPiecesOf<Geometry>& pieces, const ScaleWindow& window,
    const std::vector<ScaleRange>& valid) {
  using Place = PathPlaceOf<typename Geometry::Point>;
  struct End {
    std::optional<Place> at;
    PieceTriple triple;
  };
  std::map<std::pair<Rational, bool>, End> ends;  // scale, whether it blocks
  const ScaleRange all = range_of(window);
  std::vector<ScaleGap> gaps;
  const auto want = [&](const ScaleCut& cut, bool blocks) {
    if (!ends.try_emplace({cut.scale, blocks}).second) return;
    const Enclosure about = enclose(cut.scale);
    gaps.push_back({about.lower, about.upper});
  };
  for (const ScaleRange& range : valid) {
    if (range.from != all.from) want(range.from, false);
    if (range.to != all.to) want(*range.to, true);
  }
  if (ends.empty()) return {};
  pieces.each(gaps, true, [&](const PieceTriple& triple) {
    const auto found = pieces.scales(triple);
    if (!found) return;
    const auto offer = [&](const Rational& scale, bool blocks, const Rational& t) {
      const auto end = ends.find({scale, blocks});
      if (end == ends.end()) return;
      const Place place = pieces.place(triple.segment, t);
      const auto order = [](const Place& at, const PieceTriple& of) {
        return std::tie(at.segment, at.t, of.part, of.obstacle);
      };
      if (end->second.at && order(*end->second.at, end->second.triple) <= order(place, triple)) {
        return;
      }
      end->second = {place, triple};
    };
    offer(found->from, true, found->t_at_from);
    if (found->to) offer(*found->to, false, found->t_at_to);
  });
  std::vector<CollisionEnd<typename Geometry::Point>> result;
  for (const auto& [name, end] : ends) {
    if (!end.at) throw std::logic_error("no pair of pieces ends at a bound of the valid scales");
    result.push_back({name.first, name.second, *end.at, end.triple});
  }
  return result;
}

/// The first place along the path where some triple collides at a scale, or the limit of such
/// places, with that triple. Throws std::logic_error if nothing collides. Exact.
template <class Geometry>
CollisionEnd<typename Geometry::Point> first_collision(const MovingPiecesOf<Geometry>& pieces,
                                                       const Rational& scale) {
  std::optional<CollisionEnd<typename Geometry::Point>> first;
  const Enclosure about = enclose(scale);
  pieces.each({{about.lower, about.upper}}, false, [&](const PieceTriple& triple) {
    const auto t = pieces.first_place(triple, scale);
    if (!t) return;
    const auto is_first = [&](const PieceTriple& of, const Rational& at) {
      return std::tie(of.segment, at, of.part, of.obstacle) <=
             std::tie(triple.segment, *t, triple.part, triple.obstacle);
    };
    if (first && is_first(first->triple, first->at.t)) return;
    first = {scale, true, pieces.place(triple.segment, *t), triple};
  });
  if (!first) throw std::logic_error("nothing collides on the path at a scale that is not valid");
  return *first;
}

}  // namespace minkref::inline motion
