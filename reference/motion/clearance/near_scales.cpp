#include "reference/motion/clearance/near_scales.hpp"

#include <limits>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline motion {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Vertices of all rings with the way to the next vertex, exact and in doubles.
struct Corners {
  struct Corner {
    VertexId id;
    Pair<Rational> at, along;
    Pair<Interval> near_at, near_along;
  };
  std::vector<Corner> all;

  explicit Corners(const PolygonSet& set) {
    std::uint32_t number = 0;
    for (const Polygon& polygon : set.polygons) {
      add(polygon.outer, number++);
      for (const Ring& hole : polygon.holes) add(hole, number++);
    }
  }
  void add(const Ring& ring, std::uint32_t number) {
    for (std::uint32_t k = 0; k < ring.size(); ++k) {
      const Point &p = ring[k], &next = ring[(k + 1) % ring.size()];
      add({number, k}, {p.x, p.y}, {next.x - p.x, next.y - p.y});
    }
  }
  void add(const VertexId& id, const Pair<Rational>& at, const Pair<Rational>& along) {
    all.push_back(
        {id, at, along, {Interval(at.x), Interval(at.y)}, {Interval(along.x), Interval(along.y)}});
  }
};

bool is_zero(const Pair<Rational>& p) { return p.x == 0 && p.y == 0; }

/// A pair of features by numbers, to find the condition again.
struct Candidate {
  enum class Kind : std::uint8_t { points, edge, path_segment, part_edge };
  double low, high;              ///< outside of them is certainly no scale of the range
  double inner_low, inner_high;  ///< between them are certainly its scales, if in order
  Kind kind;
  std::uint32_t part, obstacle, place;
};

/// The range of a condition in doubles.
class RoundedRange {
 public:
  explicit RoundedRange(const NearCondition<Interval>& condition) {
    const auto& [slope, level, width, sides] = condition;
    if (width.upper() < 0) is_empty_ = true;
    if (!(width.lower() > 0)) is_certain_ = false;
    const Interval root =
        sqrt(Interval(std::max(width.lower(), 0.0), std::max(width.upper(), 0.0)));
    limit(slope, level - root);
    limit(-slope, -level - root);
    for (const auto& side : sides) limit(side.factor, side.least);
    if (low_.lower() > high_.upper() || high_.upper() <= 0) is_empty_ = true;
  }

  bool is_empty() const { return is_empty_; }
  Candidate as(Candidate::Kind kind, std::uint32_t part, std::uint32_t obstacle,
               std::uint32_t place) const {
    const double inner_high = is_bounded_ ? high_.lower() : infinity;
    return {low_.lower(),
            high_.upper(),
            is_certain_ ? low_.upper() : infinity,
            is_certain_ ? inner_high : -infinity,
            kind,
            part,
            obstacle,
            place};
  }

 private:
  /// factor s >= least
  void limit(const Interval& factor, const Interval& least) {
    if (factor.lower() > 0) {
      const Interval bound = least / factor;
      low_ = {std::max(low_.lower(), bound.lower()), std::max(low_.upper(), bound.upper())};
    } else if (factor.upper() < 0) {
      const Interval bound = least / factor;
      high_ = {std::min(high_.lower(), bound.lower()), std::min(high_.upper(), bound.upper())};
      is_bounded_ = true;
    } else if (factor.is_point() && least.lower() > 0) {
      is_empty_ = true;
    } else if (!factor.is_point() || least.upper() >= 0) {
      is_certain_ = false;
    }
  }

  Interval low_{0}, high_ = {std::numeric_limits<double>::max(), infinity};
  bool is_certain_ = true, is_empty_ = false, is_bounded_ = false;
};

struct End {
  RootNumber value;
  bool is_in;
};

/// The exact range of a condition; none if it is empty.
std::optional<RootRange> exact_range(const NearCondition<Rational>& condition, bool or_equal) {
  const auto& [slope, level, width, sides] = condition;
  if (width < 0 || (width == 0 && !or_equal)) return std::nullopt;
  std::optional<End> low = End{Rational(0), false}, high;
  const auto raise = [](std::optional<End>& end, const End& other, int way) {
    const int order = end ? way * compare(other.value, end->value) : 1;
    if (order > 0 || (order == 0 && end->is_in)) end = other;
  };
  if (slope == 0) {
    const Rational squared = level * level;
    if (squared > width || (squared == width && !or_equal)) return std::nullopt;
  } else {
    const RootNumber middle(Rational(level / slope)),
        half = sqrt(RootNumber(Rational(width / (slope * slope))));
    raise(low, {middle - half, or_equal}, 1);
    raise(high, {middle + half, or_equal}, -1);
  }
  for (const auto& side : sides) {
    if (side.factor == 0) {
      if (side.least > 0) return std::nullopt;
      continue;
    }
    raise(side.factor > 0 ? low : high, {RootNumber(Rational(side.least / side.factor)), true},
          side.factor > 0 ? 1 : -1);
  }
  if (high) {
    const int order = compare(low->value, high->value);
    if (order > 0 || (order == 0 && !(low->is_in && high->is_in))) return std::nullopt;
    return RootRange{low->value, low->is_in, high->value, high->is_in};
  }
  return RootRange{low->value, low->is_in, std::nullopt, false};
}

class Search {
 public:
  Search(const PolygonSet& part, const PolygonSet& obstacles, const std::vector<Point>& path,
         const Rational& clearance, bool or_equal)
      : part_(part),
        obstacles_(obstacles),
        path_(PolygonSet{}),
        squared_(clearance * clearance),
        near_squared_(squared_),
        or_equal_(or_equal) {
    for (std::uint32_t k = 0; k < path.size(); ++k) {
      const Point &p = path[k], &next = path[std::min<std::size_t>(k + 1, path.size() - 1)];
      path_.add({0, k}, {p.x, p.y}, {next.x - p.x, next.y - p.y});
    }
  }

  std::vector<NearRange> find() {
    std::size_t limit = first_limit;
    for (std::uint32_t place = 0; place < path_.all.size(); ++place) {
      for (std::uint32_t obstacle = 0; obstacle < obstacles_.all.size(); ++obstacle) {
        look_for_interrupt();
        look_at(place, obstacle);
        if (candidates_.size() < limit) continue;
        join_certain();
        limit = std::max(first_limit, 2 * candidates_.size());
      }
    }
    join_certain();
    std::vector<NearRange> found;
    for (const auto& [low, high] : joined_) {
      RootRange range{Rational(low), false, std::nullopt, false};
      if (high < infinity) range.to = RootNumber(Rational(high));
      found.push_back({std::move(range), std::nullopt});
    }
    for (const Candidate& one : candidates_) {
      look_for_interrupt();
      auto range = exact_range(exact_condition(one), or_equal_);
      if (range) found.push_back({*std::move(range), features(one)});
    }
    return found;
  }

 private:
  static constexpr std::size_t first_limit = 1U << 18;  ///< of candidates kept
  using Kind = Candidate::Kind;

  void look_at(std::uint32_t place, std::uint32_t obstacle) {
    const auto &x = path_.all[place], &o = obstacles_.all[obstacle];
    const Pair<Interval> v = o.near_at - x.near_at;
    const Pair<Interval> back{-x.near_along.x, -x.near_along.y};
    const bool is_edge = !is_zero(o.along), is_segment = !is_zero(x.along);
    for (std::uint32_t k = 0; k < part_.all.size(); ++k) {
      const auto& a = part_.all[k];
      const auto add = [&](Kind kind, const NearCondition<Interval>& condition) {
        const RoundedRange range(condition);
        if (!range.is_empty()) candidates_.push_back(range.as(kind, k, obstacle, place));
      };
      add(Kind::points, near_point(a.near_at, v, near_squared_, is_zero(a.at)));
      if (is_edge) add(Kind::edge, near_segment(a.near_at, v, o.near_along, near_squared_));
      if (is_segment) add(Kind::path_segment, near_segment(a.near_at, v, back, near_squared_));
      if (!is_zero(a.along)) {
        add(Kind::part_edge, near_moving_segment(v, a.near_at, a.near_along, near_squared_));
      }
    }
  }

  NearCondition<Rational> exact_condition(const Candidate& one) const {
    const auto &a = part_.all[one.part], &o = obstacles_.all[one.obstacle],
               &x = path_.all[one.place];
    const Pair<Rational> v = o.at - x.at;
    switch (one.kind) {
      case Kind::points:
        return near_point(a.at, v, squared_, is_zero(a.at));
      case Kind::edge:
        return near_segment(a.at, v, o.along, squared_);
      case Kind::path_segment:
        return near_segment(a.at, v, {-x.along.x, -x.along.y}, squared_);
      case Kind::part_edge:
        break;
    }
    return near_moving_segment(v, a.at, a.along, squared_);
  }

  NearFeatures features(const Candidate& one) const {
    return {{one.kind == Kind::part_edge, part_.all[one.part].id},
            {one.kind == Kind::edge, obstacles_.all[one.obstacle].id},
            one.place,
            one.kind == Kind::path_segment};
  }

  /// Joins what certainly overlaps, and leaves out candidates inside.
  void join_certain() {
    std::vector<std::pair<double, double>> inner = std::move(joined_);
    for (const Candidate& one : candidates_) {
      if (one.inner_low < one.inner_high) inner.emplace_back(one.inner_low, one.inner_high);
    }
    std::sort(inner.begin(), inner.end());
    joined_.clear();
    for (const auto& [low, high] : inner) {
      if (!joined_.empty() && low < joined_.back().second) {
        joined_.back().second = std::max(joined_.back().second, high);
      } else {
        joined_.emplace_back(low, high);
      }
    }
    std::erase_if(candidates_, [&](const Candidate& one) {
      const auto after = std::partition_point(
          joined_.begin(), joined_.end(),
          [&](const auto& each) { return each.first < one.low || each.first == 0; });
      if (after == joined_.begin()) return false;
      const double end = std::prev(after)->second;
      return one.high < end || end == infinity;
    });
  }

  Corners part_, obstacles_, path_;
  Rational squared_;
  Interval near_squared_;
  bool or_equal_;
  std::vector<Candidate> candidates_;
  std::vector<std::pair<double, double>> joined_;
};

}  // namespace

std::vector<NearRange> near_scales(const PolygonSet& part, const PolygonSet& obstacles,
                                   const std::vector<Point>& path, const Rational& clearance,
                                   bool or_equal) {
  const FloatEnvironment standard;
  return Search(part, obstacles, path, clearance, or_equal).find();
}

}  // namespace minkref::inline motion
