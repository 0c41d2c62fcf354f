#include "reference/disc/diagram/contact_envelope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/disc/diagram/many_bits.hpp"

namespace minkref::inline disc {
namespace {

/// Rounding errors, relative to 1. They decide nothing: proposals are proven, and counted
/// (DiagramCount); a proposal too few costs another round with more bits.
template <class Real>
struct Roundings {
  Real sliver, noise, lean, infinity;
  Roundings() {
    using std::pow;
    const Real epsilon = std::numeric_limits<Real>::epsilon();
    sliver = pow(epsilon, Real(0.75));
    noise = pow(epsilon, Real(0.375));
    lean = 64 * epsilon;
    infinity = std::numeric_limits<Real>::infinity();
  }
};

template <class Real>
const Roundings<Real>& roundings() {
  static const Roundings<Real> values;
  return values;
}

template <class Real>
Vector<Real> unit(const Vector<Real>& a) {
  using std::sqrt;
  return Real(1 / sqrt(dot(a, a))) * a;
}

bool contains(const plane::Box& box, const plane::Box& other) {
  return box.xmin <= other.xmin && other.xmax <= box.xmax && box.ymin <= other.ymin &&
         other.ymax <= box.ymax;
}

template <class Real>
Vector<double> rounded(const Vector<Real>& a) {
  return {static_cast<double>(a.x), static_cast<double>(a.y)};
}

}  // namespace

/// A patch's points: on an edge a + u along + ρ n, on an arc v + ρ d, where u, the tangent of half
/// the angle from the middle, gives d.
template <class Real>
struct ContactEnvelopes<Real>::Frame {
  std::uint32_t patch;
  bool is_edge;
  Vector<Real> origin, along, normal;  ///< of an arc: along is across the middle, its normal
  Real square;                         ///< of the edge
  Real first, last;

  Vector<Real> direction(const Real& u) const {
    return Real(1 / (1 + u * u)) * (Real(1 - u * u) * normal + Real(2 * u) * along);
  }
  Vector<Real> at(const Real& u, const Real& radius) const {
    return is_edge ? origin + u * along + radius * normal : origin + radius * direction(u);
  }
  Real radius(const Quadratic& value, const Real& u) const {
    if (is_edge) return value.at(u);
    const Real inverse = -value.at(u);
    return inverse > 0 ? Real((1 + u * u) / inverse) : roundings<Real>().infinity;
  }
};

/// The half-planes ahead of a patch: a feature outside of both meets none of its points.
template <class Real>
struct ContactEnvelopes<Real>::Ahead {
  Vector<double> origin;
  std::array<Vector<double>, 2> directions;  ///< those of an arc lie between
  double slack;

  Ahead(const Frame& frame, double size)
      : origin(rounded(frame.origin)),
        directions(frame.is_edge ? std::array{rounded(frame.normal), rounded(frame.normal)}
                                 : std::array{rounded(frame.direction(frame.first)),
                                              rounded(frame.direction(frame.last))}),
        slack(0x1p-32 * size) {}
  bool meets(const plane::Box& box) const {
    return std::any_of(directions.begin(), directions.end(), [&](const Vector<double>& d) {
      const double across = (d.x > 0 ? box.xmax : box.xmin) - origin.x,
                   up = (d.y > 0 ? box.ymax : box.ymin) - origin.y;
      return across * d.x + up * d.y > -slack;
    });
  }
};

/// The envelope over everything within some reach of a patch.
template <class Real>
struct ContactEnvelopes<Real>::Reach {
  Parts lowest;
  bool is_all;      ///< nothing is farther away
  bool is_covered;  ///< each point meets something
  Real most;        ///< the largest radius at which one does
};

template <class Real>
ContactEnvelopes<Real>::ContactEnvelopes(const EdgeLookup& lookup)
    : lookup_(lookup), curves_(lookup.curves()) {
  for (const OffsetEdge& edge : curves_.edges) {
    const Vector<Real> along = numbers<Real>(edge.along);
    edges_.push_back(
        {numbers<Real>(edge.start), along, unit(numbers<Real>(edge.normal)), dot(along, along)});
  }
}

/// Whether roundings made a vertex's part beside the part of a line that contains the vertex: as
/// near right in front of the vertex, and farther elsewhere.
template <class Real>
bool ContactEnvelopes<Real>::is_noise(const Part& part, const Part& beside) const {
  return part.to - part.from < roundings<Real>().noise &&
         lookup_.is_within(beside.feature, part.feature);
}

template <class Real>
typename ContactEnvelopes<Real>::Frame ContactEnvelopes<Real>::frame_of(std::uint32_t patch) const {
  const OffsetPatch& own = curves_.patches[patch];
  if (own.edge != OffsetPatch::none) {
    const Edge& edge = edges_[own.edge];
    return {patch, true, edge.start, edge.along, edge.normal, edge.square, 0, 1};
  }
  const Vector<Real> first = unit(numbers<Real>(own.first)), last = unit(numbers<Real>(own.last)),
                     middle = unit(first + last), across = turned(middle);
  const auto tangent = [&](const Vector<Real>& d) {
    return Real(dot(d, across) / (1 + dot(d, middle)));
  };
  return {patch,          false,        numbers<Real>(own.centre), across, middle, 0,
          tangent(first), tangent(last)};
}

/// Keeps the parts where a quadratic is not negative.
template <class Real>
void ContactEnvelopes<Real>::keep_where(const Quadratic& value, Parts& parts) {
  using std::sqrt;
  thread_local Parts kept;
  kept.clear();
  std::array<Real, 4> cuts;
  for (const Part& part : parts) {
    std::size_t count = 1;
    cuts[0] = part.from;
    const auto cut = [&](const Real& u) {
      if (u > part.from && u < part.to) cuts[count++] = u;
    };
    const Real square = value.b * value.b - 4 * value.a * value.c;
    if (square >= 0) {
      const Real root = sqrt(square);
      const Real q = value.b < 0 ? Real((root - value.b) / 2) : Real(-(root + value.b) / 2);
      if (value.a != 0) cut(q / value.a);
      if (q != 0) cut(value.c / q);
    }
    if (count == 3 && cuts[2] < cuts[1]) std::swap(cuts[1], cuts[2]);
    cuts[count++] = part.to;
    for (std::size_t k = 0; k + 1 < count; ++k) {
      if (value.at((cuts[k] + cuts[k + 1]) / 2) < 0) continue;
      if (k > 0 && !kept.empty() && kept.back().to == cuts[k]) {
        kept.back().to = cuts[k + 1];
      } else {
        kept.push_back({cuts[k], cuts[k + 1], part.value, part.feature});
      }
    }
  }
  parts.swap(kept);
}

template <class Real>
void ContactEnvelopes<Real>::add_point(const Frame& frame, std::uint32_t feature,
                                       const Vector<Real>& q, Parts& parts) const {
  const Vector<Real> w = frame.origin - q;
  if (frame.is_edge) {
    const Real height = dot(w, frame.normal);
    if (!(height < 0)) return;
    const Real f = -1 / (2 * height);
    parts.push_back({frame.first,
                     frame.last,
                     {f * frame.square, 2 * f * dot(w, frame.along), f * dot(w, w)},
                     feature});
    return;
  }
  const Real square = dot(w, w);
  if (square == 0) return;
  const Real e = dot(w, frame.normal) * 2 / square, f = dot(w, frame.along) * 2 / square;
  const Quadratic value{-e, 2 * f, e};
  thread_local Parts own;
  own.assign(1, {frame.first, frame.last, value, feature});
  keep_where({-value.a, -value.b, -value.c}, own);
  parts.insert(parts.end(), own.begin(), own.end());
}

template <class Real>
void ContactEnvelopes<Real>::add_line(const Frame& frame, std::uint32_t number,
                                      Parts& parts) const {
  const Edge& edge = edges_[number];
  const std::uint32_t feature = curves_.edges[number].feature;
  const Vector<Real> w = frame.origin - edge.start;
  const Real height = dot(edge.normal, w), foot = dot(edge.along, w);
  thread_local Parts own;
  if (frame.is_edge) {
    const Real lean = 1 - dot(edge.normal, frame.normal);
    if (!(lean > roundings<Real>().lean)) return;
    const Quadratic value{0, dot(edge.normal, frame.along) / lean, height / lean};
    own.assign(1, {frame.first, frame.last, value, feature});
    keep_where(value, own);
    const Real out = dot(edge.along, frame.normal);
    const Quadratic at{0, dot(edge.along, frame.along) + value.b * out, foot + value.c * out};
    keep_where(at, own);
    keep_where({0, -at.b, edge.square - at.c}, own);
  } else {
    // P touches itself at the vertex: an edge passes through it, and nothing is outside.
    if (lookup_.is_within(feature, curves_.patches[frame.patch].feature) && foot > 0 &&
        foot < edge.square) {
      parts.push_back({frame.first, frame.last, {0, 0, -roundings<Real>().infinity}, feature});
      return;
    }
    if (!(height > 0)) return;
    const Real e = dot(edge.normal, frame.normal), f = dot(edge.normal, frame.along);
    const Quadratic inverse{(1 + e) / height, -2 * f / height, (1 - e) / height};
    own.assign(1, {frame.first, frame.last, {-inverse.a, -inverse.b, -inverse.c}, feature});
    // How far the foot lies beyond the start and the end, times the inverse radius and 1 + t².
    const Real c = dot(edge.along, frame.normal), s = dot(edge.along, frame.along);
    const auto times = [&](const Real& far) -> Quadratic {
      return {far * inverse.a - c, far * inverse.b + 2 * s, far * inverse.c + c};
    };
    const Quadratic start = times(foot), end = times(foot - edge.square);
    keep_where(start, own);
    keep_where({-end.a, -end.b, -end.c}, own);
  }
  parts.insert(parts.end(), own.begin(), own.end());
}

/// The pointwise minimum of two envelopes.
template <class Real>
typename ContactEnvelopes<Real>::Parts ContactEnvelopes<Real>::lowest(const Parts& a,
                                                                      const Parts& b) {
  thread_local std::vector<Real> cuts;
  cuts.clear();
  for (const Parts* parts : {&a, &b}) {
    for (const Part& part : *parts) {
      cuts.push_back(part.from);
      cuts.push_back(part.to);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  Parts found;
  found.reserve(cuts.size());
  const auto add = [&](const Real& from, const Real& to, const Part& part) {
    if (!found.empty() && found.back().to == from && found.back().feature == part.feature) {
      found.back().to = to;
    } else {
      found.push_back({from, to, part.value, part.feature});
    }
  };
  thread_local Parts own;
  std::size_t i = 0, j = 0;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Real &from = cuts[k], &to = cuts[k + 1];
    while (i < a.size() && a[i].to <= from) ++i;
    while (j < b.size() && b[j].to <= from) ++j;
    const Part* f = i < a.size() && a[i].from <= from ? &a[i] : nullptr;
    const Part* g = j < b.size() && b[j].from <= from ? &b[j] : nullptr;
    if (f == nullptr || g == nullptr) {
      if (f != nullptr) add(from, to, *f);
      if (g != nullptr) add(from, to, *g);
      continue;
    }
    own.assign(1, {from, to, f->value, f->feature});
    const Quadratic difference{g->value.a - f->value.a, g->value.b - f->value.b,
                               g->value.c - f->value.c};
    keep_where(difference, own);
    Real reach = from;
    for (const Part& part : own) {
      if (part.from > reach) add(reach, part.from, *g);
      add(part.from, part.to, *f);
      reach = part.to;
    }
    if (reach < to) add(reach, to, *g);
  }
  return found;
}

template <class Real>
typename ContactEnvelopes<Real>::Parts ContactEnvelopes<Real>::envelope(
    const Parts& all, std::span<const std::size_t> starts) {
  if (starts.size() < 2) return {};
  if (starts.size() == 2) {
    const auto at = [&](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
    return {at(starts[0]), at(starts[1])};
  }
  const std::size_t middle = starts.size() / 2;
  return lowest(envelope(all, starts.first(middle + 1)), envelope(all, starts.subspan(middle)));
}

template <class Real>
std::vector<FirstContact> ContactEnvelopes<Real>::found(const Frame& frame, Parts parts) const {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (const std::size_t beside : {k - 1, k + 1}) {  // the first is far beyond the end of none
      if (beside >= parts.size() || !is_noise(parts[k], parts[beside])) continue;
      parts[k].feature = parts[beside].feature;
      parts[k].value = parts[beside].value;
      break;
    }
  }
  std::vector<FirstContact> found;
  for (const Part& part : parts) {
    const auto at = [&](const Real& u) {
      return rounded(frame.at(u, frame.radius(part.value, u)));
    };
    if (!found.empty() && found.back().feature == part.feature) {
      found.back().last = at(part.to);
    } else if (part.to - part.from >= roundings<Real>().sliver * (frame.last - frame.first)) {
      found.push_back({part.feature, at(part.from), at(part.to)});
    }
  }
  return found;
}

template <class Real>
typename ContactEnvelopes<Real>::Reach ContactEnvelopes<Real>::within(const Frame& frame,
                                                                      const Real& reach) const {
  plane::Box box;
  for (const Real& u : {frame.first, frame.last}) {
    for (const Real& radius : {Real(0), reach}) {
      const Vector<double> x = rounded(frame.at(u, radius));
      box.add({x.x, x.y, x.x, x.y});
    }
  }
  const OffsetPatch& own = curves_.patches[frame.patch];
  Parts all;
  std::vector<std::size_t> starts{0};
  thread_local std::vector<std::uint32_t> near, seen;  // seen: the round in which a vertex was
  thread_local std::uint32_t round = 0;
  near.clear();
  if (seen.size() < curves_.features.size()) seen.resize(curves_.features.size(), 0);
  ++round;
  // A feature that meets a point is no farther from the point than P; an arc adds its sagitta.
  const double margin = (frame.is_edge ? 1.0 : 1.3) * static_cast<double>(reach);
  const plane::Box around = grown(box, margin);
  const Ahead ahead(frame, lookup_.size());
  lookup_.tree().pairs_with(
      plane::BoxTree({around}),
      [&](const plane::Box& of_edges, const plane::Box& reached) {
        return of_edges.overlaps(reached) && ahead.meets(of_edges);
      },
      [&](std::uint32_t number, std::uint32_t) {
        near.push_back(number);
        return false;
      });
  seen[own.feature] = round;
  if (own.edge != OffsetPatch::none) {
    seen[curves_.edges[own.edge].start_feature] = round;
    seen[curves_.edges[own.edge].end_feature] = round;
  }
  const auto end_part = [&] {
    if (all.size() > starts.back()) starts.push_back(all.size());
  };
  for (const std::uint32_t number : near) {
    if (number == own.edge) continue;
    const OffsetEdge& edge = curves_.edges[number];
    if (edge.start_feature != own.feature && edge.end_feature != own.feature) {
      add_line(frame, number, all);
      end_part();
    }
    for (const bool at_end : {false, true}) {
      const std::uint32_t feature = at_end ? edge.end_feature : edge.start_feature;
      if (seen[feature] == round || !curves_.features[feature].has_arc) continue;
      seen[feature] = round;
      const Edge& near_edge = edges_[number];
      add_point(frame, feature, at_end ? near_edge.start + near_edge.along : near_edge.start, all);
      end_part();
    }
  }
  Reach result{envelope(all, starts), contains(around, lookup_.around()), false, 0};
  Real covered = 0;
  for (const Part& part : result.lowest) {
    covered += part.to - part.from;
    for (const Real& u : {part.from, Real((part.from + part.to) / 2), part.to}) {
      result.most = std::max(result.most, frame.radius(part.value, u));
    }
  }
  result.is_covered = covered >= (frame.last - frame.first) * (1 - roundings<Real>().sliver);
  return result;
}

template <class Real>
std::vector<FirstContact> ContactEnvelopes<Real>::of(std::uint32_t patch) const {
  using std::isfinite;
  using std::sqrt;
  const Frame frame = frame_of(patch);
  Real reach = frame.is_edge ? Real(sqrt(frame.square)) : Real(lookup_.size() / 64);
  for (;;) {
    Reach near = within(frame, reach);
    const bool is_near = near.is_covered && isfinite(near.most);
    if (near.is_all || (near.is_covered && near.most <= reach)) {
      return found(frame, std::move(near.lowest));
    }
    reach = is_near ? std::max(Real(near.most * 1.01), Real(reach * 1.01)) : Real(reach * 4);
  }
}

template class ContactEnvelopes<double>;
template class ContactEnvelopes<ManyBits<256>>;
template class ContactEnvelopes<ManyBits<1024>>;

}  // namespace minkref::inline disc
