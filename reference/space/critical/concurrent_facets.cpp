#include "reference/space/critical/concurrent_facets.hpp"

#include <algorithm>
#include <limits>

namespace minkref::inline space {
namespace {

/// Where a row and a plane are zero, in scales.
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

/// Along the line on which the form of a plane is zero, in the direction in which s grows, or else
/// any: where rows are zero, and in which order.
class Along {
 public:
  Along(ContactRow& plane, SignCounts& signs) : plane_(plane), signs_(signs) {
    slope_ = sign_of_rows(signs, [](const auto& p) { return p.beta; }, plane);
    direction_ = slope_ == 0 ? 1 : slope_;
    if (slope_ == 0) lean_ = sign_of_rows(signs, [](const auto& p) { return p.alpha; }, plane);
  }

  /// The plane meets the crossing line in one point at each scale.
  bool is_point() const { return slope_ != 0; }
  /// The plane has all of the crossing line at one scale.
  bool is_once() const { return slope_ == 0 && lean_ != 0; }

  /// How the row changes along the line.
  int rate(ContactRow& row) {
    return direction_ *
           sign_of_rows(
               signs_, [](const auto& r, const auto& p) { return turn_of(r, p); }, row, plane_);
  }

  /// Of a row that does not change.
  int constant(ContactRow& row) {
    if (slope_ != 0) {
      return slope_ *
             sign_of_rows(
                 signs_,
                 [](const auto& r, const auto& p) { return r.gamma * p.beta - p.gamma * r.beta; },
                 row, plane_);
    }
    return lean_ *
           sign_of_rows(
               signs_,
               [](const auto& r, const auto& p) { return r.gamma * p.alpha - p.gamma * r.alpha; },
               row, plane_);
  }

  /// The sign of the way from where row b is zero to where row a is; neither is constant.
  int order(ContactRow& a, int rate_of_a, ContactRow& b, int rate_of_b) {
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
        sign_of_rows(
            signs_,
            [](const auto& f, const auto& p, const auto& g) { return determinant_of(f, p, g); }, a,
            plane_, b);
    return b_at_a * rate_of_b;
  }

 private:
  ContactRow& plane_;
  SignCounts& signs_;
  int slope_, direction_, lean_ = 0;
};

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
  for (std::size_t k = count; k-- > 0;) {
    rates[k] = along.rate(*rows[k]);
    if (rates[k] == 0) {
      const int value = along.constant(*rows[k]);
      if (value < 0) return std::nullopt;
      is_zero_along[k] = value == 0;
      continue;
    }
    std::size_t& end = rates[k] > 0 ? low : high;
    if (end == count || rates[k] * along.order(*rows[k], rates[k], *rows[end], rates[end]) >= 0) {
      end = k;
    }
    if (low == count || high == count) continue;
    if (along.order(*rows[low], rates[low], *rows[high], rates[high]) > 0) return std::nullopt;
  }
  if (low == count || high == count) return std::nullopt;  // not for facets with an area
  const bool is_single = along.order(*rows[low], rates[low], *rows[high], rates[high]) == 0;
  if (along.is_point()) {
    track.low = at_least(scale_of(rows[low]->rounded(), track.plane.rounded()), track.low);
    track.high = at_most(scale_of(rows[high]->rounded(), track.plane.rounded()), track.high);
  }
  for (const std::size_t end : {low, high}) {
    std::vector<Side> zeros;
    std::size_t on = count;  // a side that singles the end out
    bool starts = false, stops = false;
    for (std::size_t k = 0; k < sides_count; ++k) {
      const bool ends = rates[k] != 0 &&
                        (k == end || along.order(*rows[k], rates[k], *rows[end], rates[end]) == 0);
      if (ends || is_zero_along[k]) zeros.push_back(sides[k]);
      if (!ends) continue;
      on = k;
      (rates[k] > 0 ? starts : stops) = true;
    }
    if (on != count && (zeros.size() == 1 || !has_pair_event(track, zeros))) {
      const ContactChange change = along.is_once() || (starts && stops) ? ContactChange::touch
                                   : starts                             ? ContactChange::birth
                                                                        : ContactChange::death;
      events.push_back({exact_scale(rows[on]->exact(), track.plane.exact()),
                        {first_.number, second_.number, third.number, ConcurrentEvent::none},
                        change,
                        sides[on].of,
                        sides[on].side});
    }
    if (is_single) break;
  }
  return track;
}

/// Whether two of three facets single out, by their sides alone, the point that these sides have.
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
  const EventScale scale = exact_scale(a.plane.exact(), b.plane.exact());
  if (scale < window_.from || scale > window_.to) return;
  events.push_back({scale,
                    {first_.number, second_.number, a.third.number, b.third.number},
                    ContactChange::touch});
}

/// Whether a side that has the point of four facets ends the track there of its own facet and two
/// others.
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
    rows.emplace_back(line, facet(event.of), event.side);
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
