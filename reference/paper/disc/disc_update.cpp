#include "reference/paper/disc/disc_update.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "reference/error.hpp"
#include "reference/number/exact_value.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/paper/disc/answer_rings.hpp"
#include "reference/paper/disc/meeting_search.hpp"
#include "reference/plane/kernel/arithmetic_name.hpp"

namespace minkref::inline disc {
namespace {

void refuse_radius(const Rational& squared_radius) {
  if (squared_radius > 0) return;
  throw BadInput("bad-radius", "the square of the radius is " + to_string(squared_radius),
                 "give a radius above 0");
}

Enclosure enclosure_of(double value) { return {value, value}; }
Enclosure enclosure_of(const Mpfr& value) { return enclose(exact(value)); }
Enclosure enclosure_of(const Surd& value) {
  return {value.enclosure().lower(), value.enclosure().upper()};
}

/// Whether a number is as near to an exact one as 2^-bits of it.
template <class T>
bool is_near(const T& value, const Surd& truth, long bits) {
  if constexpr (std::is_same_v<T, Surd>) {
    return sign(value - truth) == 0;
  } else {
    const Surd off = Surd(exact_value(value)) - truth;
    const Rational part(1, Integer(1) << static_cast<unsigned>(bits));
    const Surd most = Surd(part) * truth;
    return sign(off - most) <= 0 && sign(off + most) >= 0;
  }
}

template <class T>
class UpdateIn : public DiscUpdate {
 public:
  UpdateIn(const PolygonSet& P, const Rational& squared_radius, const Options& options,
           const Arithmetic<T>& arithmetic)
      : arithmetic_(arithmetic),
        readings_(options.readings),
        squared_unit_(options.squared_unit),
        is_connected_(P.polygons.size() == 1),
        frame_(curve_frame(P, !readings_.from_origin && !readings_.of_polygon)),
        r_(root_of(arithmetic(squared_unit_))),
        formulas_(features_, r_, squared_unit_ == 1, readings_) {
    for (const OffsetFeature& feature : frame_.features) {
      features_.push_back(moving_feature(feature, arithmetic_, r_, readings_));
      ++(feature.is_arc ? counts_.arcs : counts_.segments);
    }
    auto found = find_meetings(frame_, formulas_, options.memory);
    meetings_ = std::move(found.meetings);
    counts_.pairs = found.pairs;
    counts_.undecided = found.undecided;
    counts_.meetings = meetings_.size();
    is_active_.assign(meetings_.size(), false);
    sort_events();
    start(squared_radius);
  }

  Step move_to(const Rational& squared_radius) override {
    const FloatEnvironment standard;
    refuse_radius(squared_radius);
    const T scale = scale_of(squared_radius);
    Step step;
    while (next_ < events_.size() && is_due(events_[next_], scale)) {
      apply(events_[next_], events_[next_].insertion, step);
      ++next_;
    }
    while (next_ > 0 && !is_due(events_[next_ - 1], scale)) {
      --next_;
      apply(events_[next_], !events_[next_].insertion, step);
    }
    stand_at(squared_radius, scale);
    step.updated = active_;
    return step;
  }

  std::size_t place_intersections() override {
    const FloatEnvironment standard;
    places_.clear();
    for (std::uint32_t k = 0; k < meetings_.size(); ++k) {
      if (!is_active_[k] || meetings_[k].is_overlap) continue;
      look_for_interrupt();
      places_.push_back(formulas_.place(meetings_[k], at_));
    }
    return places_.size();
  }

  std::size_t search_intersections(const Rational& squared_radius) const override {
    const FloatEnvironment standard;
    refuse_radius(squared_radius);
    const DiscScale<T> at{scale_of(squared_radius), r_};
    std::size_t count = 0;
    const auto all = static_cast<std::uint32_t>(features_.size());
    for (std::uint32_t a = 0; a < all; ++a) {
      look_for_interrupt_now();
      for (std::uint32_t b = a + 1; b < all; ++b) {
        if (!frame_.are_joined(a, b)) count += count_common(a, b, at);
      }
    }
    return count;
  }

  DiscAnswer answer() override {
    const FloatEnvironment standard;
    if (features_.empty()) return answer_without_edges();
    PlacedCurves<T> placed(frame_, features_, at_);
    for (std::uint32_t k = 0; k < meetings_.size(); ++k) {
      if (!is_active_[k]) continue;
      look_for_interrupt();
      const Meeting<T>& own = meetings_[k];
      if (own.is_overlap) {
        placed.overlap(own.a, own.b);
      } else {
        placed.meet(own.a, own.b, formulas_.place(own, at_));
      }
    }
    placed.finish();
    const CurveCycles<T> cycles(placed);
    const CurveFaces<T> faces(cycles, features_, is_connected_, arithmetic_);
    return AnswerRings<T>(cycles, faces).answer();
  }

  std::vector<Event> events() const override {
    const FloatEnvironment standard;
    std::vector<Event> result;
    for (const Critical& event : events_) {
      look_for_interrupt();
      const Meeting<T>& own = meetings_[event.meeting];
      const Enclosure bounds = enclosure_of(bound_of(event));
      result.push_back(
          {own.a, own.b, own.branch, own.is_overlap, event.insertion, bounds.lower, bounds.upper});
    }
    return result;
  }

  Agreement agreement(const DiscUpdate& other, long bits) const override {
    const FloatEnvironment standard;
    const auto* truth = dynamic_cast<const UpdateIn<Surd>*>(&other);
    if (truth == nullptr) throw std::logic_error("the truth is told by an exact program only");
    Agreement found;
    const auto key = [](const auto& meeting) {
      return std::tuple(meeting.a, meeting.b, meeting.is_overlap, meeting.branch);
    };
    const auto compare = [&](const std::optional<T>& own, const std::optional<Surd>& exact) {
      if (own && exact) {
        ++(is_near(*own, *exact, bits) ? found.right : found.misplaced);
      } else {
        found.invented += own ? 1 : 0;
        found.missed += exact ? 1 : 0;
      }
    };
    const auto& exact = truth->meetings();
    std::size_t i = 0, j = 0;  // both by a, then b, then branch: 1 before -1
    const auto before = [](const auto& x, const auto& y) {
      return std::tuple(std::get<0>(x), std::get<1>(x), -std::get<3>(x)) <
             std::tuple(std::get<0>(y), std::get<1>(y), -std::get<3>(y));
    };
    while (i < meetings_.size() || j < exact.size()) {
      look_for_interrupt();
      const bool only_own =
          j == exact.size() || (i < meetings_.size() && before(key(meetings_[i]), key(exact[j])));
      const bool only_exact =
          i == meetings_.size() || (j < exact.size() && before(key(exact[j]), key(meetings_[i])));
      compare(only_exact ? std::nullopt : meetings_[i].lower,
              only_own ? std::nullopt : exact[j].lower);
      compare(only_exact ? std::nullopt : meetings_[i].upper,
              only_own ? std::nullopt : exact[j].upper);
      i += only_exact ? 0 : 1;
      j += only_own ? 0 : 1;
    }
    return found;
  }

  Counts counts() const override { return counts_; }
  const OffsetCurves& curves() const override { return frame_.curves; }
  const std::vector<OffsetFeature>& features() const override { return frame_.features; }
  Rational squared_radius() const override { return squared_radius_; }
  const std::vector<Meeting<T>>& meetings() const { return meetings_; }

 private:
  struct Critical {
    std::uint32_t meeting;
    bool insertion;
  };

  T scale_of(const Rational& squared_radius) const {
    return root_of(arithmetic_(Rational(squared_radius / squared_unit_)));
  }

  const T& bound_of(const Critical& event) const {
    const Meeting<T>& own = meetings_[event.meeting];
    return event.insertion ? *own.lower : *own.upper;
  }

  /// Whether the walk upwards to a scale crosses the event: meetings are closed.
  bool is_due(const Critical& event, const T& scale) const {
    const int order = order_of(bound_of(event), scale);
    return event.insertion ? order <= 0 : order < 0;
  }

  void stand_at(const Rational& squared_radius, const T& scale) {
    squared_radius_ = squared_radius;
    at_ = {scale, r_};
  }

  /// Starts with every meeting that holds the first scale.
  void start(const Rational& squared_radius) {
    const T scale = scale_of(squared_radius);
    stand_at(squared_radius, scale);
    while (next_ < events_.size() && is_due(events_[next_], scale)) ++next_;
    for (std::uint32_t k = 0; k < meetings_.size(); ++k) {
      look_for_interrupt();
      const Meeting<T>& own = meetings_[k];
      if (own.lower && order_of(*own.lower, scale) > 0) continue;
      if (own.upper && order_of(*own.upper, scale) < 0) continue;
      is_active_[k] = true;
      ++active_;
    }
  }

  void apply(const Critical& event, bool insertion, Step& step) {
    is_active_[event.meeting] = insertion;
    ++(insertion ? step.insertions : step.deletions);
    active_ += insertion ? 1 : -1;
  }

  /// Sorts ascending; at equal scales insertions come first, for meetings are closed.
  void sort_events() {
    for (std::uint32_t k = 0; k < meetings_.size(); ++k) {
      if (meetings_[k].lower) events_.push_back({k, true});
      if (meetings_[k].upper) events_.push_back({k, false});
    }
    std::stable_sort(events_.begin(), events_.end(), [&](const Critical& x, const Critical& y) {
      look_for_interrupt();
      const int order = order_of(bound_of(x), bound_of(y));
      return order != 0 ? order < 0 : x.insertion && !y.insertion;
    });
  }

  std::size_t count_common(std::uint32_t a, std::uint32_t b, const DiscScale<T>& at) const {
    static const AppendixReadings right = corrected_appendix();
    const MovingFeature<T>&one = features_[a], &other = features_[b];
    const auto count_on_both = [&](const Vector<T>& x) -> std::size_t {
      return detail::is_on(one, x) && detail::is_on(other, x) ? 1 : 0;
    };
    if (!one.is_arc && !other.is_arc) {
      if (sign(T(cross(one.along, other.along))) == 0) return 0;
      return count_on_both(TwoSegments<T>(one, other, r_).place(at));
    }
    if (one.is_arc && other.is_arc) {
      const Vector<T> between = other.centre() - one.centre();
      const T square(dot(between, between)), radius(at.s * at.r);
      if (sign(square) == 0 || order_of(T(T(4) * radius * radius), square) < 0) return 0;
      const TwoArcs<T> pair(one, other, r_, true, right);
      return count_on_both(pair.place(at, 1)) + count_on_both(pair.place(at, -1));
    }
    const ArcAndSegment<T> pair(one.is_arc ? one : other, one.is_arc ? other : one, r_, right);
    if (!pair.is_met(at)) return 0;
    return count_on_both(pair.place(at, 1)) + count_on_both(pair.place(at, -1));
  }

  DiscAnswer answer_without_edges() const {
    DiscAnswer result;
    if (frame_.curves.features.empty()) return result;  // of nothing
    result.form.push_back({{{0}, 0}, {}});
    result.components = 1;
    return result;
  }

  const Arithmetic<T> arithmetic_;
  const AppendixReadings readings_;
  const Rational squared_unit_;
  const bool is_connected_;
  const CurveFrame frame_;
  const T r_;
  std::vector<MovingFeature<T>> features_;
  const PairFormulas<T> formulas_;
  std::vector<Meeting<T>> meetings_;
  std::vector<Critical> events_;
  std::vector<bool> is_active_;  ///< by meeting
  std::size_t next_ = 0;
  std::uint64_t active_ = 0;
  Rational squared_radius_;
  DiscScale<T> at_{};
  std::vector<Vector<T>> places_;
  Counts counts_;
};

}  // namespace

std::unique_ptr<DiscUpdate> DiscUpdate::make(const PolygonSet& P, const Rational& squared_radius,
                                             const Options& options) {
  const FloatEnvironment standard;
  refuse_radius(squared_radius);
  refuse_radius(options.squared_unit);
  const auto made = [&]<class T>(const Arithmetic<T>& in) -> std::unique_ptr<DiscUpdate> {
    return std::make_unique<UpdateIn<T>>(P, squared_radius, options, in);
  };
  const std::string& name = options.arithmetic;
  if (name == "rational") return made(Arithmetic<Surd>());
  if (name == "double") return made(Arithmetic<double>());
  if (const auto bits = plane::mpfr_bits(name)) return made(Arithmetic<Mpfr>(*bits));
  throw BadInput("unknown-arithmetic", "with a disc there is no arithmetic \"" + name + "\"",
                 "choose rational, double or mpfr:BITS");
}

std::string canonical_json(const DiscAnswer& answer, const DiscUpdate& update) {
  return canonical_json(answer.form, update.curves(), update.squared_radius());
}

}  // namespace minkref::inline disc
