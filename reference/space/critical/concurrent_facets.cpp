#include "reference/space/critical/concurrent_facets.hpp"

#include <algorithm>
#include <limits>

#include "reference/space/critical/coplanar_facets.hpp"

namespace minkref::inline space {
namespace {

/// The numerator of the scale at which a row and a plane vanish together.
template <class T>
T over(const LineForm<T>& row, const LineForm<T>& plane) {
  return row.beta * plane.gamma - plane.beta * row.gamma;
}

BoundedDouble scale_of(const LineForm<BoundedDouble>& row, const LineForm<BoundedDouble>& plane) {
  return over(row, plane) / turn_of(row, plane);
}

EventScale exact_scale(const LineForm<Integer>& row, const LineForm<Integer>& plane) {
  return {over(row, plane), turn_of(row, plane)};
}

// With b-bit coordinates a height, and likewise a normal times a side, lies below 2^(3b + 6); the
// determinant of three normals lies below 2^(6b + 14).
constexpr unsigned most_bits_of_side = 18, most_bits_of_four = 11;

bool has_words(const MovingConvolution& convolution, unsigned bits) {
  return convolution.words && convolution.words->bits <= bits;
}

/// The scale at which the line along one facet's side meets two other facets' planes in one point:
/// two equations for the scale and the place on the line. Empty if no single scale results.
template <class T>
std::optional<EventScale> scale_on_side(const MovingConvolution& convolution,
                                        const MovingFacet& own, std::size_t side,
                                        const MovingFacet& f, const MovingFacet& g) {
  const ExactCorners<T> exact(convolution);
  const auto &n = exact.normal(f), &m = exact.normal(g);
  const auto along = exact.along(own, side);
  const MovingHeight<T> of_f = exact.height(n, f.names[0], own.names[side]),
                        of_g = exact.height(m, g.names[0], own.names[side]);
  const T f_along = exact.product(n, along), g_along = exact.product(m, along);
  const T slope = of_f.slope * g_along - of_g.slope * f_along;
  if (slope == 0) return std::nullopt;
  return EventScale(T(of_g.height * f_along - of_f.height * g_along), slope);
}

/// The scale at which four planes meet at one point: by their determinant, from the first facet's
/// corner on.
template <class T>
std::optional<EventScale> scale_of_four(const MovingConvolution& convolution,
                                        const std::array<const MovingFacet*, 4>& facets) {
  const ExactCorners<T> exact(convolution);
  using Normal = typename ExactCorners<T>::Normal;
  std::array<Normal, 4> n;
  for (std::size_t k = 0; k < 4; ++k) n[k] = exact.normal(*facets[k]);
  const auto determinant = [&](std::size_t i, std::size_t j) -> T {
    const Normal &a = n[0], &b = n[i], &c = n[j];
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const std::array<T, 3> weights{determinant(2, 3), T(-determinant(1, 3)), determinant(1, 2)};
  T slope(0), height(0);
  for (std::size_t k = 1; k < 4; ++k) {
    const MovingHeight<T> of = exact.height(n[k], facets[0]->names[0], facets[k]->names[0]);
    slope += of.slope * weights[k - 1];
    height += of.height * weights[k - 1];
  }
  if (slope == 0) return std::nullopt;
  return EventScale(T(-height), slope);
}

/// Walks the line on which a plane's form vanishes, towards growing s, or any way if s is constant:
/// where rows vanish, and in which order.
class Along {
 public:
  Along(ContactRow& plane, SignCounts& signs) : plane_(plane), signs_(signs) {
    slope_ = sign_of_rows(signs, [](const auto& p) { return p.beta; }, plane);
    direction_ = slope_ == 0 ? 1 : slope_;
    if (slope_ == 0) lean_ = sign_of_rows(signs, [](const auto& p) { return p.alpha; }, plane);
  }

  /// The plane meets the crossing line at one point for each scale.
  bool is_point() const { return slope_ != 0; }
  /// The plane contains the whole crossing line at one scale.
  bool is_once() const { return slope_ == 0 && lean_ != 0; }

  /// How the row changes along the line. `is_zero` may already know a zero rate.
  template <class Known>
  int rate(ContactRow& row, Known&& is_zero) {
    return direction_ * sign_unless_zero(
                            signs_, is_zero,
                            [](const auto& r, const auto& p) { return turn_of(r, p); }, row,
                            plane_);
  }

  /// The sign of a constant row. `is_zero` may already know a zero sign.
  template <class Known>
  int constant(ContactRow& row, Known&& is_zero) {
    if (slope_ != 0) {
      return slope_ *
             sign_unless_zero(
                 signs_, is_zero,
                 [](const auto& r, const auto& p) { return r.gamma * p.beta - p.gamma * r.beta; },
                 row, plane_);
    }
    return lean_ *
           sign_unless_zero(
               signs_, is_zero,
               [](const auto& r, const auto& p) { return r.gamma * p.alpha - p.gamma * r.alpha; },
               row, plane_);
  }

  /// The sign of the way from row b's zero to row a's; neither row is constant. `is_zero` may
  /// already know a zero sign.
  template <class Known>
  int order(ContactRow& a, int rate_of_a, ContactRow& b, int rate_of_b, Known&& is_zero) {
    if (is_point()) {
      const BoundedDouble way =
          scale_of(a.rounded(), plane_.rounded()) - scale_of(b.rounded(), plane_.rounded());
      const int certain = way.certain_sign();
      if (certain == 1 || certain == -1) {
        ++signs_.by_float;
        return certain;
      }
    }
    const int b_at_a =
        direction_ * rate_of_a *
        sign_unless_zero(
            signs_, is_zero,
            [](const auto& f, const auto& p, const auto& g) { return determinant_of(f, p, g); }, a,
            plane_, b);
    return b_at_a * rate_of_b;
  }

 private:
  ContactRow& plane_;
  SignCounts& signs_;
  int slope_, direction_, lean_ = 0;
};

using Name = ConvolutionFacet::Corner;

bool has_corner(const MovingFacet& facet, const Name& name) {
  return std::any_of(facet.names.begin(), facet.names.begin() + facet.size, [&](const Name& own) {
    return own.of_P == name.of_P && own.of_Q == name.of_Q;
  });
}

bool has_vertex_of_P(const MovingFacet& facet, std::uint32_t p) {
  return std::any_of(facet.names.begin(), facet.names.begin() + facet.size,
                     [&](const Name& own) { return own.of_P == p; });
}

std::array<Name, 2> ends_of(const MovingFacet& facet, std::size_t side) {
  return {facet.names[side], facet.names[(side + 1) % facet.size]};
}

/// A side and two other facets share a vertex p of P, so that everything moves with s p.
bool move_together(const MovingFacet& own, std::size_t side, const MovingFacet& f,
                   const MovingFacet& g) {
  const auto ends = ends_of(own, side);
  return std::any_of(ends.begin(), ends.end(), [&](const Name& end) {
    return has_vertex_of_P(f, end.of_P) && has_vertex_of_P(g, end.of_P);
  });
}

/// The side and both facets share a corner, where the planes meet at all scales.
bool share_a_corner(const MovingFacet& own, std::size_t side, const MovingFacet& f,
                    const MovingFacet& g) {
  const auto ends = ends_of(own, side);
  return std::any_of(ends.begin(), ends.end(),
                     [&](const Name& end) { return has_corner(f, end) && has_corner(g, end); });
}

double at_least(const BoundedDouble& s, double otherwise) {
  const double bound = s.value - s.error;
  return bound > otherwise ? bound : otherwise;
}

double at_most(const BoundedDouble& s, double otherwise) {
  const double bound = s.value + s.error;
  return bound < otherwise ? bound : otherwise;
}

}  // namespace

FacetTracks::FacetTracks(const MovingConvolution& convolution, const Facet& first,
                         const Facet& second, const Window& window, SignCounts& signs)
    : convolution_(convolution),
      first_(first),
      second_(second),
      window_(window),
      signs_(signs),
      line_(convolution, *first.facet, *second.facet, signs) {
  namespace mp = boost::multiprecision;
  const Rational from = window.from.exact(), to = window.to.exact();
  for (const Facet& own : {first_, second_}) {
    for (std::uint8_t k = 0; k < own.facet->size; ++k) own_.emplace_back(line_, *own.facet, k);
  }
  bounds_[0] = {mp::denominator(from), -mp::numerator(from)};
  bounds_[1] = {-mp::denominator(to), mp::numerator(to)};
}

std::size_t FacetTracks::rows_with(Track& track, std::array<ContactRow*, most_rows>& rows,
                                   std::array<Side, most_rows>& sides) {
  std::size_t count = 0;
  for (ContactRow& row : own_) {
    const bool is_first = count < first_.facet->size;
    sides[count] = {static_cast<std::uint8_t>(is_first ? 0 : 1), row.side()};
    rows[count++] = &row;
  }
  for (std::uint8_t k = 0; k < track.third.facet->size; ++k) {
    sides[count] = {2, k};
    rows[count++] = &track.sides[k];
  }
  for (ContactRow& row : bounds_) rows[count++] = &row;
  return count;
}

void FacetTracks::add(const Facet& third, std::vector<ConcurrentEvent>& events) {
  std::optional<Track> track = track_of(third, events);
  if (track) tracks_.push_back(std::move(*track));
}

std::optional<FacetTracks::Track> FacetTracks::track_of(const Facet& third,
                                                        std::vector<ConcurrentEvent>& events) {
  Track track{third, {line_, *third.facet, ContactRow::plane}, {}, window_.first, window_.last};
  Along along(track.plane, signs_);
  if (!along.is_point() && !along.is_once()) return std::nullopt;
  for (std::uint8_t k = 0; k < third.facet->size; ++k) {
    track.sides[k] = {line_, *third.facet, k};
  }
  std::array<ContactRow*, most_rows> rows;
  std::array<Side, most_rows> sides;
  const std::size_t count = rows_with(track, rows, sides), sides_count = count - 2;
  std::array<int, most_rows> rates;
  std::array<bool, most_rows> is_zero_along{};
  std::size_t low = count, high = count;
  const std::array<const MovingFacet*, 3> facets{first_.facet, second_.facet, third.facet};
  const auto others_of = [&](std::size_t k) {
    return std::array{facets[(sides[k].of + 1U) % 3], facets[(sides[k].of + 2U) % 3]};
  };
  // Two sides end at one corner that two facets share: on the track both rows vanish there.
  const auto end_together = [&](std::size_t k, std::size_t l) {
    if (k >= sides_count || l >= sides_count) return false;
    const MovingFacet &own = *facets[sides[k].of], &other = *facets[sides[l].of];
    for (const Name& a : ends_of(own, sides[k].side)) {
      for (const Name& b : ends_of(other, sides[l].side)) {
        if (a.of_P != b.of_P || a.of_Q != b.of_Q) continue;
        if (&own != &other) return true;
        const auto others = others_of(k);
        if (has_corner(*others[0], a) || has_corner(*others[1], a)) return true;
      }
    }
    return false;
  };
  const auto order = [&](std::size_t k, std::size_t l) {
    return along.order(*rows[k], rates[k], *rows[l], rates[l], [&] { return end_together(k, l); });
  };
  for (std::size_t k = count; k-- > 0;) {
    rates[k] = along.rate(*rows[k], [&] {
      const auto others = others_of(k);
      return k < sides_count &&
             move_together(*facets[sides[k].of], sides[k].side, *others[0], *others[1]);
    });
    if (rates[k] == 0) {
      const int value = along.constant(*rows[k], [&] {
        const auto others = others_of(k);
        return k < sides_count &&
               share_a_corner(*facets[sides[k].of], sides[k].side, *others[0], *others[1]);
      });
      if (value < 0) return std::nullopt;
      is_zero_along[k] = value == 0;
      continue;
    }
    std::size_t& end = rates[k] > 0 ? low : high;
    if (end == count || rates[k] * order(k, end) >= 0) {
      end = k;
    }
    if (low == count || high == count) continue;
    if (order(low, high) > 0) return std::nullopt;
  }
  if (low == count || high == count) return std::nullopt;  // not for facets with an area
  const bool is_single = order(low, high) == 0;
  if (along.is_point()) {
    track.low = at_least(scale_of(rows[low]->rounded(), track.plane.rounded()), track.low);
    track.high = at_most(scale_of(rows[high]->rounded(), track.plane.rounded()), track.high);
  }
  for (const std::size_t end : {low, high}) {
    std::vector<Side> zeros;
    std::size_t on = count;  // a side that singles the end out
    bool starts = false, stops = false;
    for (std::size_t k = 0; k < sides_count; ++k) {
      const bool ends = rates[k] != 0 && (k == end || order(k, end) == 0);
      if (ends || is_zero_along[k]) zeros.push_back(sides[k]);
      if (!ends) continue;
      on = k;
      (rates[k] > 0 ? starts : stops) = true;
    }
    if (on != count && (zeros.size() == 1 || !has_pair_event(track, zeros))) {
      const ContactChange change = along.is_once() || (starts && stops) ? ContactChange::touch
                                   : starts                             ? ContactChange::birth
                                                                        : ContactChange::death;
      events.push_back({scale_at(track, sides[on], *rows[on]),
                        {first_.number, second_.number, third.number, ConcurrentEvent::none},
                        change});
      events.back().sides[sides[on].of] = sides[on].side;
    }
    if (is_single) break;
  }
  return track;
}

/// The scale at the end of a track on a side.
EventScale FacetTracks::scale_at(Track& track, const Side& side, ContactRow& row) const {
  const std::array<const MovingFacet*, 3> facets{first_.facet, second_.facet, track.third.facet};
  const MovingFacet &own = *facets[side.of], &f = *facets[(side.of + 1U) % 3],
                    &g = *facets[(side.of + 2U) % 3];
  const std::optional<EventScale> found =
      has_words(convolution_, most_bits_of_side)
          ? scale_on_side<Int128>(convolution_, own, side.side, f, g)
          : scale_on_side<Integer>(convolution_, own, side.side, f, g);
  return found ? *found : exact_scale(row.exact(), track.plane.exact());
}

/// Whether two of three facets single out, by their sides alone, the sides' common point.
bool FacetTracks::has_pair_event(const Track& track, const std::vector<Side>& zeros) {
  const std::array<const MovingFacet*, 3> facets{first_.facet, second_.facet, track.third.facet};
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a + 1; b < 3; ++b) {
      CrossingLine line(convolution_, *facets[a], *facets[b], signs_);
      std::vector<ContactRow> rows;
      for (const Side& zero : zeros) {
        if (zero.of == a || zero.of == b) rows.emplace_back(line, *facets[zero.of], zero.side);
      }
      for (std::size_t k = 0; k < rows.size(); ++k) {
        for (std::size_t l = k + 1; l < rows.size(); ++l) {
          const int turn = sign_of_rows(
              signs_, [](const auto& f, const auto& g) { return turn_of(f, g); }, rows[k], rows[l]);
          if (turn != 0) return true;
        }
      }
    }
  }
  return false;
}

void FacetTracks::add_crossings(const std::function<bool(std::uint32_t, std::uint32_t)>& may_meet,
                                std::vector<ConcurrentEvent>& events) {
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    for (std::size_t l = k + 1; l < tracks_.size(); ++l) {
      Track &a = tracks_[k], &b = tracks_[l];
      if (a.high < b.low || b.high < a.low) continue;
      if (may_meet(a.third.number, b.third.number)) add_crossing(a, b, events);
    }
  }
}

void FacetTracks::add_crossing(Track& a, Track& b, std::vector<ConcurrentEvent>& events) {
  const BoundedDouble s = scale_of(a.plane.rounded(), b.plane.rounded());
  if (s.value + s.error < std::max(a.low, b.low) || s.value - s.error > std::min(a.high, b.high)) {
    return;
  }
  const int turn = sign_of_rows(
      signs_, [](const auto& f, const auto& g) { return turn_of(f, g); }, a.plane, b.plane);
  if (turn == 0) return;
  std::vector<Side> zeros;
  const auto is_inside = [&](ContactRow& row, std::uint8_t of) {
    const int at = turn * sign_of_rows(
                              signs_,
                              [](const auto& f, const auto& g, const auto& h) {
                                return determinant_of(f, g, h);
                              },
                              a.plane, b.plane, row);
    if (at == 0) zeros.push_back({of, row.side()});
    return at >= 0;
  };
  for (std::size_t k = 0; k < own_.size(); ++k) {
    if (!is_inside(own_[k], k < first_.facet->size ? 0 : 1)) return;
  }
  for (std::uint8_t k = 0; k < a.third.facet->size; ++k) {
    if (!is_inside(a.sides[k], 2)) return;
  }
  for (std::uint8_t k = 0; k < b.third.facet->size; ++k) {
    if (!is_inside(b.sides[k], 3)) return;
  }
  const std::array<const MovingFacet*, 4> facets{first_.facet, second_.facet, a.third.facet,
                                                 b.third.facet};
  for (const Side& zero : zeros) {
    if (is_end_of_three(facets, zero)) return;
  }
  const std::optional<EventScale> short_scale = has_words(convolution_, most_bits_of_four)
                                                    ? scale_of_four<Int128>(convolution_, facets)
                                                    : scale_of_four<Integer>(convolution_, facets);
  const EventScale scale =
      short_scale ? *short_scale : exact_scale(a.plane.exact(), b.plane.exact());
  if (scale < window_.from || scale > window_.to) return;
  events.push_back({scale,
                    {first_.number, second_.number, a.third.number, b.third.number},
                    ContactChange::touch});
}

/// Whether a side through the four facets' common point ends the track of its own facet and two
/// others there.
bool FacetTracks::is_end_of_three(const std::array<const MovingFacet*, 4>& facets,
                                  const Side& side) {
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a + 1; b < 4; ++b) {
      if (a == side.of || b == side.of) continue;
      CrossingLine line(convolution_, *facets[side.of], *facets[a], signs_);
      ContactRow plane(line, *facets[b], ContactRow::plane), row(line, *facets[side.of], side.side);
      const int turn = sign_of_rows(
          signs_, [](const auto& f, const auto& g) { return turn_of(f, g); }, row, plane);
      if (turn != 0) return true;
    }
  }
  return false;
}

std::array<Rational, 3> place_of(const MovingConvolution& convolution,
                                 const ConcurrentEvent& event) {
  const auto has_side = [](std::uint8_t side) { return side != ConcurrentEvent::no_side; };
  if (std::count_if(event.sides.begin(), event.sides.end(), has_side) > 1) {
    return place_in_plane(convolution, event);
  }
  SignCounts signs;
  const auto facet = [&](std::size_t k) -> const MovingFacet& {
    return convolution.facets[event.facets[k]];
  };
  CrossingLine line(convolution, facet(0), facet(1), signs);
  std::vector<ContactRow> rows;
  rows.emplace_back(line, facet(2), ContactRow::plane);
  if (event.is_of_four()) {
    rows.emplace_back(line, facet(3), ContactRow::plane);
  } else {
    const auto of = static_cast<std::size_t>(
        std::find_if(event.sides.begin(), event.sides.end(), has_side) - event.sides.begin());
    rows.emplace_back(line, facet(of), event.sides[of]);
  }
  const Rational s = event.s.exact();
  for (ContactRow& row : rows) {
    const LineForm<Integer>& form = row.exact();
    if (form.beta == 0) continue;
    const Rational height = s * Rational(form.alpha) + Rational(form.gamma);
    return line.point(s, -height / Rational(form.beta));
  }
  throw std::logic_error("three facets that share a point have no place");
}

}  // namespace minkref::inline space
