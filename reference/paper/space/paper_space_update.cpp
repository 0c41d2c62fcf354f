#include "reference/paper/space/paper_space_update.hpp"

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>

#include "reference/build/build_control.hpp"
#include "reference/error.hpp"
#include "reference/number/exact_value.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/paper/space/crossing_search.hpp"
#include "reference/paper/space/exposed_cells.hpp"
#include "reference/paper/space/moving_facets_in.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/kernel/arithmetic_name.hpp"
#include "reference/space/critical/parallel_facets.hpp"

namespace minkref::inline space {
namespace {

void refuse_operands(const Polyhedron& P, const Polyhedron& Q) {
  for (const Polyhedron* body : {&P, &Q}) {
    if (body->empty() || body->faces.size() > 1) continue;
    throw BadInput("degenerate-operands",
                   std::string(body == &P ? "P" : "Q") +
                       " has no volume, and the paper's update (Sec. 5) takes faces of solids",
                   "give two solids, or leave out the route");
  }
}

/// The largest absolute value of a coordinate.
Rational largest(const Polyhedron& body) {
  Rational most = 0;
  for (const SpacePoint& v : body.vertices) {
    most = std::max({most, Rational(abs(v.x)), Rational(abs(v.y)), Rational(abs(v.z))});
  }
  return most;
}

/// The exposed parts united plane by plane; plane_of(facet) gives a facet's plane.
template <class PlaneOf>
PolyhedralSet united(const PaperSpaceSum& sum, PlaneOf&& plane_of) {
  std::map<OrientedPlane, PolygonSet> planes;
  for (const PaperSpaceSum::Exposed& part : sum.exposed) {
    PolygonSet& rings = planes[plane_of(part.facet)];
    for (Polygon& ring : rings_in_view(part, plane_of(part.facet)).polygons) {
      rings.polygons.push_back(std::move(ring));
    }
  }
  PolyhedralSet set;
  for (auto& [plane, rings] : planes) {
    look_for_interrupt();
    set.faces.push_back({plane, canonicalize(rings).region});
  }
  return set;
}

/// For each facet the later ones whose boxes meet its box at a scale.
template <class T>
std::vector<std::vector<std::uint32_t>> near_facets(
    const std::vector<typename TwoFacets<T>::Facet>& facets, const T& scale) {
  std::vector<SpaceBox> boxes;
  for (const auto& facet : facets) {
    SpaceBox& box = boxes.emplace_back();
    for (const auto& corner : facet) {
      box.add(PlacedBody<T>::box_of(corner.q + corner.p * scale));
    }
  }
  std::vector<std::vector<std::uint32_t>> near(facets.size());
  SpaceBoxTree(std::move(boxes)).pairs([&](std::uint32_t a, std::uint32_t b) {
    near[std::min(a, b)].push_back(std::max(a, b));
  });
  for (auto& list : near) std::sort(list.begin(), list.end());
  return near;
}

PairDirections pair_directions(const MovingConvolution& convolution, std::uint32_t a,
                               std::uint32_t b) {
  const MovingFacet* facets[] = {&convolution.facets[a], &convolution.facets[b]};
  PairDirections found;
  std::size_t along = 0;
  for (const std::size_t which : {0U, 1U}) {
    for (std::size_t k = 0; k < facets[which]->size; ++k) {
      found.along_plane[which][k] =
          dot(facets[1 - which]->normal.exact, facets[which]->along[k].exact).is_zero();
      along += which == 0 && found.along_plane[which][k];
    }
  }
  found.parallel = along == facets[0]->size;
  found.coplanar = found.parallel && are_coplanar(convolution, *facets[0], *facets[1]);
  return found;
}

template <class T>
class SpaceUpdateIn : public PaperSpaceUpdate {
 public:
  using Vector = typename TwoFacets<T>::Vector;

  SpaceUpdateIn(const Polyhedron& P, const Polyhedron& Q, const Rational& first_scale,
                const Arithmetic<T>& arithmetic, const SpaceUpdateReadings& readings, Pairs pairs,
                const BuildOptions& options)
      : arithmetic_(arithmetic),
        operands_(space_operands(P, Q, {1, 1, 1})),
        convolution_(operands_.P, operands_.Q),
        facets_(facets_in(convolution_, arithmetic)),
        names_(facets_),
        P_(points_in(operands_.P)),
        Q_(operands_.Q, points_in(operands_.Q)),
        coplanar_with_(facets_.size()) {
    const T zero = arithmetic(readings.events.tolerance * (largest(P) + largest(Q)) *
                              Rational(operands_.denominator));
    const BuildControl control(options, "the list of crossings");
    const auto directions = [&](std::uint32_t a, std::uint32_t b) {
      return pair_directions(convolution_, a, b);
    };
    auto found = find_crossings<T>(facets_, later_of(pairs, arithmetic(first_scale)), directions,
                                   readings, zero, control);
    crossings_ = std::move(found.crossings);
    coplanar_ = std::move(found.coplanar);
    for (const auto& [a, b] : coplanar_) {
      coplanar_with_[a].push_back(b);
      coplanar_with_[b].push_back(a);
    }
    for (auto& list : coplanar_with_) std::sort(list.begin(), list.end());
    if (readings.events.coplanar == FacetReadings::Coplanar::left_out) coplanar_.clear();
    walk_.emplace(crossings_);
    counts_ = {facets_.size(), found.pairs, crossings_.size(), walk_->events().size(),
               found.undecided};
    place_on_list_.resize(crossings_.size());
    walk_->start(arithmetic_(first_scale), [&](std::uint32_t i, const T&) { insert(i); });
  }

  Step move_to(const Rational& to) override {
    const FloatEnvironment standard;
    require_positive({to, 1, 1});
    return walk_->move_to(
        arithmetic_(to), [&](std::uint32_t i, const T&) { insert(i); },
        [&](std::uint32_t i) { erase(i); });
  }

  std::size_t place_intersections() override {
    const FloatEnvironment standard;
    places_.clear();
    for (const std::uint32_t i : list_) {
      if (crossings_[i].is_point()) places_.push_back(crossings_[i].x.at(walk_->scale()));
    }
    return places_.size();
  }

  std::size_t search_intersections(const Rational& scale, Pairs pairs) const override {
    const FloatEnvironment standard;
    require_positive({scale, 1, 1});
    const T at = arithmetic_(scale);
    return crossings_afresh<T>(facets_, later_of(pairs, at), at);
  }

  PaperSpaceSum sum(const BuildOptions& options) override {
    const FloatEnvironment standard;
    const BuildControl control(options, "the sum");
    PaperSpaceSum sum;
    sum.arithmetic = arithmetic_.name();
    const T& scale = walk_->scale();
    const PlacedFacets<T> placed(facets_, names_, crossings_, coplanar_, list_, scale);
    std::vector<Vector> scaled = P_;
    for (Vector& v : scaled) v *= scale;
    const PlacedBody<T> P(operands_.P, std::move(scaled));
    const BodyContact<T> contact(P, Q_);
    const ExposedCells<T> cells(placed, coplanar_with_, contact, operands_.denominator);
    const std::size_t step = std::max<std::size_t>(facets_.size() / 100, 1);
    for (std::uint32_t facet = 0; facet < facets_.size(); ++facet) {
      control.look();
      if (facet % step == 0) control.report(BuildProgress::Stage::patches, facet, facets_.size());
      cells.add(facet, sum);
    }
    control.report(BuildProgress::Stage::patches, facets_.size(), facets_.size());
    if constexpr (std::is_same_v<T, Rational>) {
      sum.set = united(sum, [&](std::uint32_t facet) { return plane(facet, scale); });
    }
    return sum;
  }

  std::vector<Event> events() const override {
    const FloatEnvironment standard;
    std::vector<Event> result;
    result.reserve(walk_->events().size());
    for (const auto& event : walk_->events()) {
      look_for_interrupt();
      const Crossing<T>& crossing = crossings_[event.region];
      const std::uint32_t number =
          (static_cast<std::uint32_t>(crossing.kind) * 4 + crossing.side) * 4 + crossing.other_side;
      result.push_back({exact_value(walk_->scale_of(event)), crossing.first, crossing.second,
                        number, event.insertion});
    }
    return result;
  }

  Counts counts() const override { return counts_; }

  OrientedPlane plane(std::uint32_t facet, const Rational& scale) const override {
    const MovingFacet& found = convolution_.facets[facet];
    const IntegerVector normal = primitive(found.normal.exact);
    const auto& [of_P, of_Q] = found.names[0];
    const Rational height = scale * Rational(dot(normal, operands_.P.points[of_P].exact)) +
                            Rational(dot(normal, operands_.Q.points[of_Q].exact));
    return {normal, height / Rational(operands_.denominator)};
  }

 private:
  /// For each facet the later ones with which it makes a pair.
  auto later_of(Pairs pairs, const T& scale) const {
    std::vector<std::vector<std::uint32_t>> near;
    if (pairs == Pairs::near) near = near_facets<T>(facets_, scale);
    return [pairs, near = std::move(near), count = facets_.size()](std::uint32_t a) {
      return pairs == Pairs::all ? all_later(a, count) : near[a];
    };
  }

  std::vector<Vector> points_in(const SpaceOperand& body) const {
    std::vector<Vector> points;
    for (const auto& point : body.points) {
      points.push_back(vector_in(point.exact, arithmetic_));
    }
    return points;
  }

  void insert(std::uint32_t crossing) {
    place_on_list_[crossing] = static_cast<std::uint32_t>(list_.size());
    list_.push_back(crossing);
  }
  void erase(std::uint32_t crossing) {
    const std::uint32_t place = place_on_list_[crossing], last = list_.back();
    list_[place] = last;
    place_on_list_[last] = place;
    list_.pop_back();
  }

  const Arithmetic<T> arithmetic_;
  const SpaceOperands operands_;
  const MovingConvolution convolution_;
  const std::vector<typename TwoFacets<T>::Facet> facets_;
  const FacetNames names_;
  const std::vector<Vector> P_;
  const PlacedBody<T> Q_;
  std::vector<Crossing<T>> crossings_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> coplanar_;
  std::vector<std::vector<std::uint32_t>> coplanar_with_;
  std::optional<EventWalk<T, Crossing<T>>> walk_;
  std::vector<std::uint32_t> list_;           ///< crossings at the scale, in no order
  std::vector<std::uint32_t> place_on_list_;  ///< of those
  std::vector<Vector> places_;
  Counts counts_;
};

}  // namespace

std::unique_ptr<PaperSpaceUpdate> PaperSpaceUpdate::make(const Polyhedron& P, const Polyhedron& Q,
                                                         const Rational& first_scale,
                                                         const std::string& arithmetic,
                                                         const SpaceUpdateReadings& readings,
                                                         const BuildOptions& options) {
  const FloatEnvironment standard;
  require_positive({first_scale, 1, 1});
  refuse_operands(P, Q);
  return with_arithmetic(
      arithmetic, [&]<class T>(const Arithmetic<T>& in) -> std::unique_ptr<PaperSpaceUpdate> {
        return std::make_unique<SpaceUpdateIn<T>>(P, Q, first_scale, in, readings, Pairs::all,
                                                  options);
      });
}

PolygonSet rings_in_view(const PaperSpaceSum::Exposed& part, const OrientedPlane& plane) {
  const std::size_t axis = viewing_axis(plane.normal);
  PolygonSet rings;
  Rational area = 0;  // twice
  for (const PaperSpaceSum::Ring& corners : part.rings) {
    Ring& ring = rings.polygons.emplace_back().outer;
    for (const SpacePoint& corner : corners) ring.push_back(seen(corner, axis));
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
      area += a.x * b.y - a.y * b.x;
    }
  }
  if (sign(area) < 0) {  // the other view was mirrored
    for (Polygon& ring : rings.polygons) std::reverse(ring.outer.begin(), ring.outer.end());
  }
  return rings;
}

PaperSpaceSum facet_sum_at(const Polyhedron& P, const Polyhedron& Q, const Rational& scale,
                           const BuildOptions& options) {
  const FloatEnvironment standard;
  require_positive({scale, 1, 1});
  refuse_operands(P, Q);
  return SpaceUpdateIn<Rational>(P, Q, scale, {}, corrected_space_update_readings(),
                                 PaperSpaceUpdate::Pairs::near, options)
      .sum(options);
}

}  // namespace minkref::inline space
