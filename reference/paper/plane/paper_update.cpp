#include "reference/paper/plane/paper_update.hpp"

#include <algorithm>
#include <optional>
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
    walk_.emplace(regions_);
    walk_->start(arithmetic_(first_scale),
                 [&](std::uint32_t region, const T& scale) { lists_.insert(region, scale); });
  }

  Step move_to(const Rational& to) override {
    const FloatEnvironment standard;
    refuse_scale(to);
    const T scale = arithmetic_(to);
    return walk_->move_to(
        scale, [&](std::uint32_t region, const T& at) { lists_.insert(region, at); },
        [&](std::uint32_t region) { lists_.erase(region); });
  }

  std::size_t place_intersections() override {
    const FloatEnvironment standard;
    places_.clear();
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      for (const std::uint32_t i : lists_.along(edge)) {
        if (regions_[i].a == edge && !regions_[i].parallel) {
          places_.push_back(regions_[i].x.at(walk_->scale()));
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
      for (auto& v : ring) v = Vector(T(v.x() * walk_->scale()), T(v.y() * walk_->scale()));
    }
    auto at_scale = convolution_segments<K>(convolution_.edges, scaled, Q_);
    const ListedIntersections<T> listed(kernel, edges_, regions_, lists_, readings_.order,
                                        walk_->scale(), at_scale);
    const Arrangement<K> arrangement(kernel, listed.vertices, at_scale.segments, listed.contacts);
    const auto inside =
        faces_of_sum(arrangement, connected_, PlainFaceCollision<T>(kernel, scaled, Q_),
                     sum.statistics.orientable_faces);
    Canonical form =
        canonicalize(boundary_rings(arrangement, inside, [&](std::uint32_t n) -> Point {
          const Vector& v = arrangement.node(n);
          return {exact_value(v.x()), exact_value(v.y())};
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
    result.reserve(walk_->events().size());
    for (const auto& event : walk_->events()) {
      look_for_interrupt();
      const CriticalRegion<T>& region = regions_[event.region];
      result.push_back({exact_value(walk_->scale_of(event)), region.a, region.b, event.insertion});
    }
    return result;
  }

  Counts counts() const override { return counts_; }

 private:
  const Arithmetic<T> arithmetic_;
  const Readings readings_;
  const bool connected_;
  const Operand<Vector> P_, Q_;
  const ConvolutionSegments<K> convolution_;
  const std::vector<MovingEdge<Vector>> edges_;
  std::vector<CriticalRegion<T>> regions_;
  std::optional<EventWalk<T, CriticalRegion<T>>> walk_;
  IntersectionLists<T> lists_;
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
