#include "reference/disc/pairs/pair_events.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

FeaturePair pair_of(const std::vector<OffsetFeature>& features, const DiscPairEvent& event,
                    std::array<FeatureNumbers<Interval>, 2>& near) {
  const OffsetFeature &a = features[event.a], &b = features[event.b];
  near = {FeatureNumbers<Interval>(a), FeatureNumbers<Interval>(b)};
  return {a, b, near[0], near[1]};
}

/// Whether a squared radius is before (-1), at (0) or after (1) a rational number.
template <class Exact>
int side_of(const Interval& square, const Rational& bound, Exact&& exact) {
  if (const auto certain = certified_sign(square - Interval(bound))) return *certain;
  return compare_squares(exact(), RootNumber(bound));
}

class DiscPairSearch {
 public:
  DiscPairSearch(DiscPairEvents& result, const DiscPairOptions& options)
      : result_(result), options_(options), has_printed_(options.readings.has_printed()) {}

  void run() {
    const std::vector<OffsetFeature>& features = result_.features;
    for (const OffsetFeature& feature : features) near_.emplace_back(feature);
    if (options_.to) make_boxes();
    const auto count = static_cast<std::uint32_t>(features.size());
    for (std::uint32_t a = 0; a < count; ++a) {
      look_for_interrupt_now();
      for (std::uint32_t b = a + 1; b < count; ++b) {
        ++result_.pairs;
        if (!boxes_.empty() && !boxes_[a].overlaps(boxes_[b])) {
          ++result_.filtered_pairs;
          continue;
        }
        look_at(a, b);
      }
    }
    keep_first();
    sort();
  }

 private:
  /// Makes boxes around all points that a feature has up to the last radius.
  void make_boxes() {
    const double reach = plane::above(std::sqrt(Interval(*options_.to).upper()));
    for (const FeatureNumbers<Interval>& feature : near_) {
      plane::Box box = box_of(feature.at[0]);
      box.add(box_of(feature.at[1]));
      boxes_.push_back(grown(box, reach));
    }
  }

  void look_at(std::uint32_t a, std::uint32_t b) {
    FeaturePair pair(result_.features[a], result_.features[b], near_[a], near_[b]);
    const auto in_window = [&](const FeatureEvent& event) {
      const Interval& square = event.squared_radius();
      const auto exact = [&] { return pair.squared_radius(event.contacts[0]); };
      return (!options_.from || side_of(square, *options_.from, exact) >= 0) &&
             (!options_.to || side_of(square, *options_.to, exact) <= 0);
    };
    std::vector<FeatureEvent> events = pair.events();
    std::erase_if(events, [&](const FeatureEvent& event) { return !in_window(event); });
    result_.true_count += events.size();
    if (has_printed_) {
      events = pair.printed_events(options_.readings, options_.has_unit_radius);
      std::erase_if(events, [&](const FeatureEvent& event) { return !in_window(event); });
    }
    for (const FeatureEvent& event : events) add(a, b, event);
    result_.exact_signs += pair.exact_signs;
  }

  void add(std::uint32_t a, std::uint32_t b, const FeatureEvent& event) {
    DiscPairEvent found{a,        b,           0,           event.squared_radius(),
                        0,        0,           0,           event.before,
                        event.at, event.after, event.change};
    for (const PairContact& each : event.contacts) {
      const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(each.slot));
      found.contacts |= bit;
      if (each.staying) found.staying |= bit;
      if (each.meets) found.meeting |= bit;
    }
    ++result_.count;
    result_.right_count += event.change != PairChange::none ? 1 : 0;
    ++result_.changes[std::string(name(event.change))];
    ++result_.kinds[std::string(result_.kind(found))];
    result_.events.push_back(found);
    if (options_.most && result_.events.size() > 2 * *options_.most + least_kept) keep_first();
  }

  int order(const DiscPairEvent& x, const DiscPairEvent& y) const {
    if (x.squared_radius.upper() < y.squared_radius.lower()) return -1;
    if (x.squared_radius.lower() > y.squared_radius.upper()) return 1;
    if (x.squared_radius.is_point() && y.squared_radius.is_point()) return 0;
    return compare_squares(result_.squared_radius(x), result_.squared_radius(y));
  }

  bool comes_before(const DiscPairEvent& x, const DiscPairEvent& y) const {
    const int order_of = order(x, y);
    return order_of != 0 ? order_of < 0 : std::tie(x.a, x.b) < std::tie(y.a, y.b);
  }

  void keep_first() {
    auto& events = result_.events;
    if (!options_.most || events.size() <= *options_.most) return;
    const auto last = events.begin() + static_cast<std::ptrdiff_t>(*options_.most);
    std::nth_element(events.begin(), last, events.end(), [&](const auto& x, const auto& y) {
      look_for_interrupt();
      return comes_before(x, y);
    });
    events.erase(last, events.end());
  }

  /// Sorts by lower bounds first; then, within runs of overlapping bounds, by exact numbers, each
  /// computed once.
  void sort() {
    auto& events = result_.events;
    std::sort(events.begin(), events.end(), [](const auto& x, const auto& y) {
      look_for_interrupt();
      return x.squared_radius.lower() < y.squared_radius.lower();
    });
    std::uint32_t rank = 0;
    for (std::size_t first = 0; first < events.size();) {
      double reach = events[first].squared_radius.upper();
      std::size_t last = first + 1;
      for (; last < events.size() && events[last].squared_radius.lower() <= reach; ++last) {
        reach = std::max(reach, events[last].squared_radius.upper());
      }
      rank = sort_run(first, last, rank);
      first = last;
    }
  }

  std::uint32_t sort_run(std::size_t first, std::size_t last, std::uint32_t rank) {
    auto& events = result_.events;
    if (last - first == 1) {
      events[first].rank = rank;
      return rank + 1;
    }
    std::vector<std::pair<RootNumber, DiscPairEvent>> run;
    run.reserve(last - first);
    for (std::size_t k = first; k < last; ++k) {
      look_for_interrupt();
      run.emplace_back(result_.squared_radius(events[k]), events[k]);
    }
    std::sort(run.begin(), run.end(), [](const auto& x, const auto& y) {
      look_for_interrupt();
      const int order_of = compare_squares(x.first, y.first);
      return order_of != 0 ? order_of < 0
                           : std::tie(x.second.a, x.second.b) < std::tie(y.second.a, y.second.b);
    });
    for (std::size_t k = 0; k < run.size(); ++k) {
      if (k > 0 && compare_squares(run[k - 1].first, run[k].first) != 0) ++rank;
      run[k].second.rank = rank;
      events[first + k] = run[k].second;
    }
    return rank + 1;
  }

  static constexpr std::size_t least_kept = 4096;

  DiscPairEvents& result_;
  const DiscPairOptions& options_;
  bool has_printed_;
  std::vector<FeatureNumbers<Interval>> near_;
  std::vector<plane::Box> boxes_;  ///< none without a last radius
};

}  // namespace

std::vector<PairContact> DiscPairEvent::all_contacts() const {
  std::vector<PairContact> found;
  for (unsigned slot = 0; slot < 5; ++slot) {
    const unsigned bit = 1U << slot;
    if ((contacts & bit) == 0) continue;
    found.push_back({static_cast<ContactSlot>(slot), (staying & bit) != 0, (meeting & bit) != 0, 0,
                     squared_radius});
  }
  return found;
}

RootNumber DiscPairEvents::squared_radius(const DiscPairEvent& event) const {
  std::array<FeatureNumbers<Interval>, 2> near;
  return pair_of(features, event, near).squared_radius(event.all_contacts()[0]);
}

std::string_view DiscPairEvents::kind(const DiscPairEvent& event) const {
  return FeaturePair::name(event.all_contacts().back().slot, features[event.a].is_arc,
                           features[event.b].is_arc);
}

DiscPairEvents disc_pair_events(const PolygonSet& P, const DiscPairOptions& options) {
  const FloatEnvironment standard;
  DiscPairEvents result;
  result.features = offset_features(offset_curves(P));
  DiscPairSearch(result, options).run();
  return result;
}

}  // namespace minkref::inline disc
