#include "reference/paper/plane/paper_update.hpp"

#include <algorithm>
#include <utility>

#include "reference/number/exact_value.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/paper/plane/intersection_lists.hpp"
#include "reference/paper/plane/intersections_afresh.hpp"
#include "reference/paper/plane/listed_intersections.hpp"
#include "reference/paper/plane/region_search.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/kernel/arithmetic_name.hpp"
#include "reference/plane/routes/boundary_rings.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/paper_route.hpp"

namespace minkref::inline plane {
namespace {

Rational value_of(const Rational& number) { return number; }
Rational value_of(const Interval& number) { return exact_value(approximate(number)); }
template <class T>
Rational value_of(const T& number) {
  return exact_value(number);
}

void refuse_scale(const Rational& scale) {
  if (sign(scale) <= 0) {
    throw BadInput("bad-scale", "the scale " + to_string(scale) + " is not greater than zero",
                   "give a scale above zero");
  }
}

/// The largest absolute value of a coordinate.
Rational largest(const PolygonSet& set) {
  Rational most = 0;
  for (const Polygon& polygon : set.polygons) {  // holes lie within
    for (const Point& point : polygon.outer) {
      most = std::max({most, Rational(abs(point.x)), Rational(abs(point.y))});
    }
  }
  return most;
}

template <class T>
class UpdateIn : public PaperUpdate {
 public:
  using K = PlainKernel<T>;
  using Vector = Vector2<T>;

  UpdateIn(const PolygonSet& P, const PolygonSet& Q, const Rational& first_scale,
           const Arithmetic<T>& arithmetic, const Readings& readings, unsigned threads,
           std::uint64_t memory)
      : arithmetic_(arithmetic),
        readings_(readings),
        connected_(connected(P) && connected(Q)),
        P_(scalar_operand<T>(P, arithmetic)),
        Q_(scalar_operand<T>(Q, arithmetic)),
        convolution_(convolution_segments<K>(reduced_convolution(P, Q), P_, Q_)),
        edges_(moving_edges(convolution_.edges, P_, Q_)),
        lists_(edges_, regions_, readings.order) {
    const T zero = arithmetic(readings.tolerance * (largest(P) + largest(Q)));
    auto found = find_regions<T>(edges_, convolution_.segments, readings_, zero, threads, memory);
    regions_ = std::move(found.regions);
    counts_ = {edges_.size(), found.pairs, regions_.size(), found.undecided};
    sort_events();
    start(arithmetic_(first_scale));
  }

  Step move_to(const Rational& to) override {
    const FloatEnvironment standard;
    refuse_scale(to);
    const T scale = arithmetic_(to);
    Step step;
    while (next_ < events_.size() && is_due(events_[next_], scale)) {
      apply(events_[next_], events_[next_].insertion, step);
      ++next_;
    }
    while (next_ > 0 && !is_due(events_[next_ - 1], scale)) {
      --next_;
      apply(events_[next_], !events_[next_].insertion, step);
    }
    scale_ = scale;
    step.updated = active_;
    return step;
  }

  std::size_t place_intersections() override {
    const FloatEnvironment standard;
    places_.clear();
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      for (const std::uint32_t i : lists_.along(edge)) {
        if (regions_[i].a == edge && !regions_[i].parallel) {
          places_.push_back(regions_[i].x.at(scale_));
        }
      }
    }
    return places_.size();
  }

  std::size_t search_intersections(const Rational& scale) const override {
    const FloatEnvironment standard;
    refuse_scale(scale);
    return intersections_afresh<T>(edges_, arithmetic_(scale)).size();
  }

  Sum sum() override {
    const FloatEnvironment standard;
    Sum sum;
    sum.statistics.kernel = arithmetic_.name();
    if (edges_.empty()) return sum;
    const K kernel;
    Operand<Vector> scaled = P_;
    for (auto& ring : scaled.rings) {
      for (auto& v : ring) v = Vector(T(v.x() * scale_), T(v.y() * scale_));
    }
    auto at_scale = convolution_segments<K>(convolution_.edges, scaled, Q_);
    const ListedIntersections<T> listed(kernel, edges_, regions_, lists_, readings_.order, scale_,
                                        at_scale);
    const Arrangement<K> arrangement(kernel, listed.vertices, at_scale.segments, listed.contacts);
    const auto inside =
        faces_of_sum(arrangement, connected_, PlainFaceCollision<T>(kernel, scaled, Q_),
                     sum.statistics.orientable_faces);
    Canonical form =
        canonicalize(boundary_rings(arrangement, inside, [&](std::uint32_t n) -> Point {
          const Vector& v = arrangement.node(n);
          return {value_of(v.x()), value_of(v.y())};
        }));
    for (const auto& edge : edges_)
      ++(edge.is_s() ? sum.statistics.s_edges : sum.statistics.t_edges);
    sum.statistics.nodes = arrangement.node_count();
    sum.statistics.faces = arrangement.face_count();
    sum.region = std::move(form.region);
    sum.components = form.components;
    sum.holes = form.holes;
    return sum;
  }

  std::vector<Event> events() const override {
    const FloatEnvironment standard;
    std::vector<Event> result;
    result.reserve(events_.size());
    for (const Critical& event : events_) {
      look_for_interrupt();
      const CriticalRegion<T>& region = regions_[event.region];
      result.push_back({value_of(scale_of(event)), region.a, region.b, event.insertion});
    }
    return result;
  }

  Counts counts() const override { return counts_; }

 private:
  struct Critical {
    std::uint32_t region;
    bool insertion;
  };

  const T& scale_of(const Critical& event) const {
    const CriticalRegion<T>& region = regions_[event.region];
    return event.insertion ? *region.lower : *region.upper;
  }

  /// Whether the walk upwards to a scale crosses the event: regions are closed.
  bool is_due(const Critical& event, const T& scale) const {
    const int order = sign(T(scale_of(event) - scale));
    return event.insertion ? order <= 0 : order < 0;
  }

  /// Starts the arrangement at the first scale with every region that holds the scale.
  void start(const T& scale) {
    scale_ = scale;
    while (next_ < events_.size() && is_due(events_[next_], scale)) ++next_;
    for (std::uint32_t i = 0; i < regions_.size(); ++i) {
      look_for_interrupt();
      const CriticalRegion<T>& region = regions_[i];
      if (region.lower && sign(T(*region.lower - scale)) > 0) continue;
      if (region.upper && sign(T(*region.upper - scale)) < 0) continue;
      lists_.insert(i, scale);
      ++active_;
    }
  }

  void apply(const Critical& event, bool insertion, Step& step) {
    if (insertion) {
      lists_.insert(event.region, scale_of(event));
      ++step.insertions;
      ++active_;
    } else {
      lists_.erase(event.region);
      ++step.deletions;
      --active_;
    }
  }

  /// Sorts ascending; at equal scales insertions come first, for regions are closed.
  void sort_events() {
    for (std::uint32_t i = 0; i < regions_.size(); ++i) {
      if (regions_[i].lower) events_.push_back({i, true});
      if (regions_[i].upper) events_.push_back({i, false});
    }
    std::stable_sort(events_.begin(), events_.end(), [&](const Critical& x, const Critical& y) {
      look_for_interrupt();
      const int order = sign(T(scale_of(x) - scale_of(y)));
      return order != 0 ? order < 0 : x.insertion && !y.insertion;
    });
  }

  const Arithmetic<T> arithmetic_;
  const Readings readings_;
  const bool connected_;
  const Operand<Vector> P_, Q_;
  const ConvolutionSegments<K> convolution_;
  const std::vector<MovingEdge<Vector>> edges_;
  std::vector<CriticalRegion<T>> regions_;
  std::vector<Critical> events_;
  IntersectionLists<T> lists_;
  std::size_t next_ = 0;
  std::uint64_t active_ = 0;
  T scale_{};
  std::vector<Vector> places_;
  Counts counts_;
};

}  // namespace

std::unique_ptr<PaperUpdate> PaperUpdate::make(const PolygonSet& P, const PolygonSet& Q,
                                               const Rational& first_scale,
                                               const std::string& arithmetic,
                                               const Readings& readings, std::uint64_t memory,
                                               unsigned threads) {
  const FloatEnvironment standard;
  refuse_bad_operands(P, Q, first_scale);
  return with_arithmetic(arithmetic,
                         [&]<class T>(const Arithmetic<T>& in) -> std::unique_ptr<PaperUpdate> {
                           return std::make_unique<UpdateIn<T>>(P, Q, first_scale, in, readings,
                                                                std::max(threads, 1U), memory);
                         });
}

}  // namespace minkref::inline plane
