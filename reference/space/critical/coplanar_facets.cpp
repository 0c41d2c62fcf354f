#include "reference/space/critical/coplanar_facets.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace minkref::inline space {
namespace {

/// x X + y Y + slope s + constant, of the point (X, Y) of a plane at the scale s: not below zero
/// inside.
template <class T>
struct FlatForm {
  T x, y, slope, constant;
};

template <class T>
T turn_of(const FlatForm<T>& f, const FlatForm<T>& g) {
  return f.x * g.y - g.x * f.y;
}

/// Three forms are zero at the scale `over / under`.
template <class T>
T under(const FlatForm<T>& f, const FlatForm<T>& g, const FlatForm<T>& h) {
  return f.slope * turn_of(g, h) + g.slope * turn_of(h, f) + h.slope * turn_of(f, g);
}
template <class T>
T over(const FlatForm<T>& f, const FlatForm<T>& g, const FlatForm<T>& h) {
  return -(f.constant * turn_of(g, h) + g.constant * turn_of(h, f) + h.constant * turn_of(f, g));
}

/// A fourth form's value where three forms vanish, times `under` for the three.
template <class T>
T value_of(const FlatForm<T>& form, const FlatForm<T>& f, const FlatForm<T>& g,
           const FlatForm<T>& h) {
  const auto minor = [](const FlatForm<T>& a, const FlatForm<T>& b) -> T {
    return a.slope * b.constant - b.slope * a.constant;
  };
  const T of_gh = minor(g, h), of_hf = minor(h, f), of_fg = minor(f, g);
  return form.constant * under(f, g, h) + form.slope * over(f, g, h) +
         form.y * (f.x * of_gh + g.x * of_hf + h.x * of_fg) -
         form.x * (f.y * of_gh + g.y * of_hf + h.y * of_fg);
}

/// A facet's plane seen along an axis, from the facet's first corner, which moves.
class MovingPlane {
 public:
  MovingPlane(const MovingConvolution& convolution, const MovingFacet& facet)
      : convolution_(convolution),
        own_(facet),
        axis_(longest_axis(facet.normal.exact)),
        i_((axis_ + 1) % 3),
        j_((axis_ + 2) % 3),
        is_seen_from_above_(is_up(facet)) {}

  /// The form for a side of a facet in the plane.
  template <class T>
  FlatForm<T> side(const MovingFacet& facet, std::size_t k) const {
    const std::array<T, 3>& along = facet.along[k].as<T>();
    T x = -along[j_], y = along[i_];
    if (!is_up(facet)) {
      x = -x;
      y = -y;
    }
    return from_here(facet.names[k], x, y,
                     [&](const std::array<T, 3>& way) -> T { return x * way[i_] + y * way[j_]; });
  }

  /// The form for the plane of a facet across, or for the plane erected on one of this facet's
  /// sides.
  template <class T>
  FlatForm<T> trace(const MovingFacet& facet, std::uint8_t side) const {
    const std::size_t corner = side == ContactRow::plane ? 0 : side;
    const std::array<T, 3>& n = own_.normal.as<T>();
    std::array<T, 3> m = facet.normal.as<T>();
    if (side != ContactRow::plane) m = cross(m, facet.along[side].as<T>());
    const T upright = is_seen_from_above_ ? n[axis_] : T(-n[axis_]);
    T x = n[axis_] * m[i_] - m[axis_] * n[i_], y = n[axis_] * m[j_] - m[axis_] * n[j_];
    if (!is_seen_from_above_) {
      x = -x;
      y = -y;
    }
    return from_here(facet.names[corner], x, y,
                     [&](const std::array<T, 3>& way) -> T { return upright * dot(m, way); });
  }

  std::array<Rational, 3> point(const Rational& s, const Rational& x, const Rational& y) const {
    const IntegerVector &p = convolution_.P.points[own_.names[0].of_P].exact,
                        &q = convolution_.Q.points[own_.names[0].of_Q].exact,
                        &n = own_.normal.exact;
    std::array<Rational, 3> way;
    way[i_] = x;
    way[j_] = y;
    way[axis_] = -(Rational(n[i_]) * x + Rational(n[j_]) * y) / Rational(n[axis_]);
    for (std::size_t k = 0; k < 3; ++k) way[k] += s * Rational(p[k]) + Rational(q[k]);
    return way;
  }

 private:
  bool is_up(const MovingFacet& facet) const { return facet.normal.exact[axis_].sign() > 0; }

  template <class T, class Height>
  FlatForm<T> from_here(const ConvolutionFacet::Corner& corner, const T& x, const T& y,
                        Height&& height) const {
    const SpaceOperand &P = convolution_.P, &Q = convolution_.Q;
    const auto& base = own_.names[0];
    const std::array<T, 3> of_P = P.points[corner.of_P].as<T>() - P.points[base.of_P].as<T>(),
                           of_Q = Q.points[corner.of_Q].as<T>() - Q.points[base.of_Q].as<T>();
    return {x, y, T(-height(of_P)), T(-height(of_Q))};
  }

  const MovingConvolution& convolution_;
  const MovingFacet& own_;
  std::size_t axis_, i_, j_;
  bool is_seen_from_above_;
};

/// A side of one of three facets, or the plane of the facet across.
class FlatRow {
 public:
  FlatRow(const MovingPlane& plane, const CoplanarTriple& triple, std::size_t of, std::uint8_t side)
      : of(of), side(side), plane_(&plane), triple_(&triple), rounded_(form<BoundedDouble>()) {}

  std::size_t of;
  std::uint8_t side;

  template <class T>
  const FlatForm<T>& as() {
    if constexpr (std::is_same_v<T, BoundedDouble>) {
      return rounded_;
    } else {
      if (!exact_) exact_ = form<Integer>();
      return *exact_;
    }
  }

 private:
  template <class T>
  FlatForm<T> form() const {
    const MovingFacet& facet = *triple_->facets[of].facet;
    return of == triple_->across ? plane_->trace<T>(facet, side) : plane_->side<T>(facet, side);
  }

  const MovingPlane* plane_;
  const CoplanarTriple* triple_;
  FlatForm<BoundedDouble> rounded_;
  std::optional<FlatForm<Integer>> exact_;
};

template <class Evaluate, class... Rows>
int sign_of_flat(SignCounts& signs, Evaluate&& evaluate, Rows&... rows) {
  return filtered_sign(signs, [&]<class T>(std::type_identity<T>) -> T {
    return evaluate(rows.template as<T>()...);
  });
}

class CoplanarSearch {
 public:
  CoplanarSearch(const MovingConvolution& convolution, const CoplanarTriple& triple,
                 const FacetTracks::Window& window, SignCounts& signs)
      : triple_(triple),
        window_(window),
        signs_(signs),
        plane_(convolution, *triple.facets[triple.across == 0 ? 1 : 0].facet) {
    for (std::size_t of = 0; of < 3; ++of) {
      for (std::uint8_t k = 0; k < triple.facets[of].facet->size; ++k) {
        sides_[of].emplace_back(plane_, triple, of, k);
      }
    }
    if (triple.across != CoplanarTriple::none) {
      across_.emplace(plane_, triple, triple.across, ContactRow::plane);
    }
  }

  void add_to(std::vector<ConcurrentEvent>& events) {
    const std::size_t a = triple_.across == 0 ? 1 : 0, b = triple_.across <= 1 ? 2 : 1;
    for (FlatRow& f : sides_[a]) {
      for (FlatRow& g : sides_[b]) {
        if (across_) {
          look_at(f, g, *across_, events);
          continue;
        }
        for (FlatRow& h : sides_[2]) look_at(f, g, h, events);
      }
    }
  }

 private:
  void look_at(FlatRow& f, FlatRow& g, FlatRow& h, std::vector<ConcurrentEvent>& events) {
    const auto &u = f.as<BoundedDouble>(), &v = g.as<BoundedDouble>(), &w = h.as<BoundedDouble>();
    const BoundedDouble near = over(u, v, w) / under(u, v, w);
    if (near.value + near.error < window_.first || near.value - near.error > window_.last) return;
    const int turn = sign_of_flat(
        signs_, [](const auto& x, const auto& y, const auto& z) { return under(x, y, z); }, f, g,
        h);
    if (turn == 0) return;
    for (auto& sides : sides_) {
      for (FlatRow& row : sides) {
        if (&row == &f || &row == &g || &row == &h) continue;
        const int value = turn * sign_of_flat(
                                     signs_,
                                     [](const auto& d, const auto& x, const auto& y,
                                        const auto& z) { return value_of(d, x, y, z); },
                                     row, f, g, h);
        if (value < 0 || (value == 0 && !is_always_zero(row, f, g, h))) return;
      }
    }
    const auto &x = f.as<Integer>(), &y = g.as<Integer>(), &z = h.as<Integer>();
    const EventScale s(over(x, y, z), under(x, y, z));
    if (s < window_.from || s > window_.to) return;
    ConcurrentEvent event{s, {}, change_at(f, g, h, turn)};
    for (std::size_t k = 0; k < 3; ++k) event.facets[k] = triple_.facets[k].number;
    event.facets[3] = ConcurrentEvent::none;
    for (const FlatRow* row : {&f, &g, &h}) {
      if (row->side != ContactRow::plane) event.sides[row->of] = row->side;
    }
    events.push_back(std::move(event));
  }

  /// A side of the facet across that lies along the plane, with all points that the facet shares
  /// with the plane. Another vanishing side ends at a touching corner, or touches another side: an
  /// event of two facets.
  bool is_always_zero(FlatRow& row, FlatRow& f, FlatRow& g, FlatRow& h) {
    if (row.of != triple_.across) return false;
    const auto determinant = [](const auto& x, const auto& y, const auto& z) {
      return under(x, y, z);
    };
    return sign_of_flat(signs_, determinant, row, f, h) == 0 &&
           sign_of_flat(signs_, determinant, row, g, h) == 0;
  }

  /// The change of the common part of the sides' inner halves at the point: birth if s grows with
  /// the depth inside of each side, death if s falls with it.
  ContactChange change_at(FlatRow& f, FlatRow& g, FlatRow& h, int turn) {
    const auto rate = [&](FlatRow& a, FlatRow& b) {
      return turn *
             sign_of_flat(signs_, [](const auto& x, const auto& y) { return turn_of(x, y); }, a, b);
    };
    std::array<int, 3> rates{rate(g, h), rate(h, f), across_ ? 0 : rate(f, g)};
    std::sort(rates.begin(), rates.end());
    return rates[0] >= 0   ? ContactChange::birth
           : rates[2] <= 0 ? ContactChange::death
                           : ContactChange::pass;
  }

  const CoplanarTriple& triple_;
  const FacetTracks::Window& window_;
  SignCounts& signs_;
  MovingPlane plane_;
  std::array<std::vector<FlatRow>, 3> sides_;
  std::optional<FlatRow> across_;
};

}  // namespace

void add_coplanar_events(const MovingConvolution& convolution, const CoplanarTriple& triple,
                         const FacetTracks::Window& window, SignCounts& signs,
                         std::vector<ConcurrentEvent>& events) {
  CoplanarSearch(convolution, triple, window, signs).add_to(events);
}

std::array<Rational, 3> place_in_plane(const MovingConvolution& convolution,
                                       const ConcurrentEvent& event) {
  CoplanarTriple triple{{}, CoplanarTriple::none};
  for (std::size_t k = 0; k < 3; ++k) {
    triple.facets[k] = {event.facets[k], &convolution.facets[event.facets[k]]};
    if (event.sides[k] == ConcurrentEvent::no_side) triple.across = k;
  }
  const MovingPlane plane(convolution, *triple.facets[triple.across == 0 ? 1 : 0].facet);
  std::vector<FlatForm<Integer>> forms;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint8_t side = k == triple.across ? ContactRow::plane : event.sides[k];
    forms.push_back(FlatRow(plane, triple, k, side).as<Integer>());
  }
  const Rational s = event.s.exact();
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a + 1; b < 3; ++b) {
      const FlatForm<Integer>&f = forms[a], &g = forms[b];
      const Integer turn = turn_of(f, g);
      if (turn == 0) continue;
      const Rational of_f = s * Rational(f.slope) + Rational(f.constant),
                     of_g = s * Rational(g.slope) + Rational(g.constant);
      return plane.point(s, (Rational(f.y) * of_g - Rational(g.y) * of_f) / Rational(turn),
                         (Rational(g.x) * of_f - Rational(f.x) * of_g) / Rational(turn));
    }
  }
  throw std::logic_error("three facets whose sides pass through one point have no place");
}

}  // namespace minkref::inline space
