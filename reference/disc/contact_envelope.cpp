#include "reference/disc/contact_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace minkref::inline disc {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double sliver = 1e-12;  // of a patch: what roundings leave between two parts

Spot spot(const Point& p) { return {to_double(p.x), to_double(p.y)}; }
Spot operator+(const Spot& a, const Spot& b) { return {a.x + b.x, a.y + b.y}; }
Spot operator-(const Spot& a, const Spot& b) { return {a.x - b.x, a.y - b.y}; }
Spot operator*(double f, const Spot& a) { return {f * a.x, f * a.y}; }
double dot(const Spot& a, const Spot& b) { return a.x * b.x + a.y * b.y; }
Spot unit(const Spot& a) { return (1 / std::hypot(a.x, a.y)) * a; }
Spot unit(const Direction& d) { return unit(Spot{to_double(d.x), to_double(d.y)}); }

}  // namespace

/// The points of a patch: of an edge a + u along + ρ n, of an arc v + ρ d with d by the tangent u
/// of half the angle from the middle.
struct ContactEnvelopes::Frame {
  std::uint32_t patch;
  bool is_edge;
  Spot origin, along, normal;  ///< of an arc: along is across the middle, normal is the middle
  double square;               ///< of the edge
  double first, last;

  Spot direction(double u) const {
    return 1 / (1 + u * u) * ((1 - u * u) * normal + 2 * u * along);
  }
  Spot at(double u, double radius) const {
    return is_edge ? origin + u * along + radius * normal : origin + radius * direction(u);
  }
  double radius(const Quadratic& value, double u) const {
    if (is_edge) return value.at(u);
    const double inverse = -value.at(u);
    return inverse > 0 ? (1 + u * u) / inverse : infinity;
  }
};

ContactEnvelopes::ContactEnvelopes(const OffsetCurves& curves) : curves_(curves), size_(0) {
  std::vector<plane::Box> boxes;
  plane::Box all;
  for (const OffsetEdge& edge : curves.edges) {
    const Spot start = spot(edge.start), end = spot(edge.end);
    edges_.push_back({start, end - start, unit(edge.normal), dot(end - start, end - start)});
    boxes.push_back({std::min(start.x, end.x), std::min(start.y, end.y), std::max(start.x, end.x),
                     std::max(start.y, end.y)});
    all.add(boxes.back());
  }
  if (!boxes.empty()) size_ = std::max(all.xmax - all.xmin, all.ymax - all.ymin);
  tree_ = plane::BoxTree(std::move(boxes));
  find_vertices_within();
}

void ContactEnvelopes::find_vertices_within() {
  std::set<std::pair<std::uint32_t, std::uint32_t>> ends;
  for (const OffsetEdge& edge : curves_.edges) ends.insert({edge.feature, edge.end_feature});
  const double margin = 1e-9 * size_;
  for (std::uint32_t k = 0; k < curves_.edges.size(); ++k) {
    const OffsetEdge& edge = curves_.edges[k];
    const std::pair start{edge.feature, edge.start_feature};
    if (ends.contains(start)) within_.insert(start);
    const Spot& at = edges_[k].start;
    tree_.query({at.x - margin, at.y - margin, at.x + margin, at.y + margin}, [&](auto number) {
      const OffsetEdge& other = curves_.edges[number];
      const Direction way = from_to(other.start, edge.start);
      const Rational foot = disc::dot(other.along, way);
      if (cross(other.along, way) == 0 && foot > 0 && foot < other.squared_length) {
        within_.insert({other.feature, edge.start_feature});
      }
      return false;
    });
  }
}

/// Whether roundings made a part of a vertex beside that of a line that it is within: as near right
/// in front of it, and farther elsewhere.
bool ContactEnvelopes::is_noise(const Part& part, const Part& beside) const {
  return part.to - part.from < 1e-6 && is_within(beside.feature, part.feature);
}

ContactEnvelopes::Frame ContactEnvelopes::frame_of(std::uint32_t patch) const {
  const OffsetPatch& own = curves_.patches[patch];
  if (own.edge != OffsetPatch::none) {
    const Edge& edge = edges_[own.edge];
    return {patch, true, edge.start, edge.along, edge.normal, edge.square, 0, 1};
  }
  const Spot first = unit(own.first), last = unit(own.last), middle = unit(first + last);
  const Spot across{-middle.y, middle.x};
  const auto tangent = [&](const Spot& d) { return dot(d, across) / (1 + dot(d, middle)); };
  return {patch, false, spot(own.centre), across, middle, 0, tangent(first), tangent(last)};
}

/// The parts where a quadratic is not below 0.
void ContactEnvelopes::keep_where(const Quadratic& value, Parts& parts) {
  Parts kept;
  for (const Part& part : parts) {
    std::vector<double> cuts{part.from};
    const double square = value.b * value.b - 4 * value.a * value.c;
    const auto cut = [&](double u) {
      if (u > part.from && u < part.to) cuts.push_back(u);
    };
    if (square >= 0) {
      const double q = -0.5 * (value.b + std::copysign(std::sqrt(square), value.b));
      if (value.a != 0) cut(q / value.a);
      if (q != 0) cut(value.c / q);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.push_back(part.to);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      if (value.at((cuts[k] + cuts[k + 1]) / 2) < 0) continue;
      if (!kept.empty() && kept.back().to == cuts[k]) {
        kept.back().to = cuts[k + 1];
      } else {
        kept.push_back({cuts[k], cuts[k + 1], part.value, part.feature});
      }
    }
  }
  parts = std::move(kept);
}

void ContactEnvelopes::add_point(const Frame& frame, std::uint32_t feature, const Spot& q,
                                 Parts& parts) const {
  const Spot w = frame.origin - q;
  if (frame.is_edge) {
    const double height = dot(w, frame.normal);
    if (!(height < 0)) return;
    const double f = -1 / (2 * height);
    parts.push_back({frame.first,
                     frame.last,
                     {f * frame.square, 2 * f * dot(w, frame.along), f * dot(w, w)},
                     feature});
    return;
  }
  const double square = dot(w, w);
  if (square == 0) return;
  const double e = dot(w, frame.normal) * 2 / square, f = dot(w, frame.along) * 2 / square;
  const Quadratic value{-e, 2 * f, e};
  Parts own{{frame.first, frame.last, value, feature}};
  keep_where({-value.a, -value.b, -value.c}, own);
  parts.insert(parts.end(), own.begin(), own.end());
}

void ContactEnvelopes::add_line(const Frame& frame, std::uint32_t number, Parts& parts) const {
  const Edge& edge = edges_[number];
  const std::uint32_t feature = curves_.edges[number].feature;
  const Spot w = frame.origin - edge.start;
  const double height = dot(edge.normal, w), foot = dot(edge.along, w);
  Parts own;
  if (frame.is_edge) {
    const double lean = 1 - dot(edge.normal, frame.normal);
    if (!(lean > 1e-14)) return;
    const Quadratic value{0, dot(edge.normal, frame.along) / lean, height / lean};
    own = {{frame.first, frame.last, value, feature}};
    keep_where(value, own);
    const double out = dot(edge.along, frame.normal);
    const Quadratic at{0, dot(edge.along, frame.along) + value.b * out, foot + value.c * out};
    keep_where(at, own);
    keep_where({0, -at.b, edge.square - at.c}, own);
  } else {
    // P touches itself at the vertex: an edge passes through it, and nothing is outside.
    const bool is_on_edge = std::abs(height) <= sliver * size_ && foot > 0 && foot < edge.square;
    if (is_on_edge) {
      parts.push_back({frame.first, frame.last, {0, 0, -infinity}, feature});
      return;
    }
    if (!(height > 0)) return;
    const double e = dot(edge.normal, frame.normal), f = dot(edge.normal, frame.along);
    const Quadratic inverse{(1 + e) / height, -2 * f / height, (1 - e) / height};
    own = {{frame.first, frame.last, {-inverse.a, -inverse.b, -inverse.c}, feature}};
    // Of the foot, times the inverse radius and 1 + t².
    const double c = dot(edge.along, frame.normal), s = dot(edge.along, frame.along);
    const auto times = [&](double far) -> Quadratic {
      return {far * inverse.a - c, far * inverse.b + 2 * s, far * inverse.c + c};
    };
    const Quadratic start = times(foot), end = times(foot - edge.square);
    keep_where(start, own);
    keep_where({-end.a, -end.b, -end.c}, own);
  }
  parts.insert(parts.end(), own.begin(), own.end());
}

/// The lower of two envelopes.
ContactEnvelopes::Parts ContactEnvelopes::lowest(const Parts& a, const Parts& b) {
  std::vector<double> cuts;
  for (const Parts* parts : {&a, &b}) {
    for (const Part& part : *parts) {
      cuts.push_back(part.from);
      cuts.push_back(part.to);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  Parts found;
  const auto add = [&](double from, double to, const Part& part) {
    if (!found.empty() && found.back().to == from && found.back().feature == part.feature) {
      found.back().to = to;
    } else {
      found.push_back({from, to, part.value, part.feature});
    }
  };
  std::size_t i = 0, j = 0;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double from = cuts[k], to = cuts[k + 1];
    while (i < a.size() && a[i].to <= from) ++i;
    while (j < b.size() && b[j].to <= from) ++j;
    const Part* f = i < a.size() && a[i].from <= from ? &a[i] : nullptr;
    const Part* g = j < b.size() && b[j].from <= from ? &b[j] : nullptr;
    if (f == nullptr || g == nullptr) {
      if (f != nullptr) add(from, to, *f);
      if (g != nullptr) add(from, to, *g);
      continue;
    }
    Parts own{{from, to, f->value, f->feature}};
    const Quadratic difference{g->value.a - f->value.a, g->value.b - f->value.b,
                               g->value.c - f->value.c};
    keep_where(difference, own);
    double reach = from;
    for (const Part& part : own) {
      if (part.from > reach) add(reach, part.from, *g);
      add(part.from, part.to, *f);
      reach = part.to;
    }
    if (reach < to) add(reach, to, *g);
  }
  return found;
}

ContactEnvelopes::Parts ContactEnvelopes::envelope(const std::vector<Parts>& all, std::size_t from,
                                                   std::size_t to) {
  if (to - from == 0) return {};
  if (to - from == 1) return all[from];
  const std::size_t middle = from + (to - from) / 2;
  return lowest(envelope(all, from, middle), envelope(all, middle, to));
}

std::vector<FirstContact> ContactEnvelopes::found(const Frame& frame, const Parts& all) const {
  std::vector<FirstContact> found;
  Parts parts = all;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (const std::size_t beside : {k - 1, k + 1}) {  // the first is far beyond the end of none
      if (beside >= parts.size() || !is_noise(parts[k], parts[beside])) continue;
      parts[k].feature = parts[beside].feature;
      parts[k].value = parts[beside].value;
      break;
    }
  }
  for (const Part& part : parts) {
    if (part.to - part.from < sliver * (frame.last - frame.first)) continue;
    const auto radius = [&](double u) { return frame.radius(part.value, u); };
    const auto at = [&](double u) { return frame.at(u, radius(u)); };
    FirstContact contact{part.feature,
                         part.from,
                         part.to,
                         at(part.from),
                         at(part.to),
                         radius(part.from),
                         radius(part.to),
                         false,
                         {},
                         0};
    double least = infinity;
    if (frame.is_edge) {
      if (part.value.a != 0) least = -part.value.b / (2 * part.value.a);
    } else {
      // Where a cosine and sine have their greatest value: half of its angle.
      const double c = (part.value.a - part.value.c) / 2, s = -part.value.b / 2;
      least = std::tan(std::atan2(s, c) / 2);
    }
    const double near = 1e-9 * (1 + std::abs(least));
    contact.has_least = least > part.from - near && least < part.to + near;
    if (contact.has_least) {
      contact.least = at(least);
      contact.least_radius = radius(least);
    }
    const bool goes_on = !found.empty() && found.back().feature == part.feature &&
                         part.from - found.back().to < sliver * (frame.last - frame.first);
    if (goes_on) {
      found.back().to = contact.to;
      found.back().last = contact.last;
      found.back().last_radius = contact.last_radius;
    } else {
      found.push_back(contact);
    }
  }
  return found;
}

std::vector<FirstContact> ContactEnvelopes::of(std::uint32_t patch) const {
  const Frame frame = frame_of(patch);
  const OffsetPatch& own = curves_.patches[patch];
  double reach = frame.is_edge ? std::sqrt(frame.square) : size_ / 64;
  for (;;) {
    plane::Box box;
    for (const double u : {frame.first, frame.last}) {
      for (const double radius : {0.0, reach}) {
        const Spot x = frame.at(u, radius);
        box.add({x.x, x.y, x.x, x.y});
      }
    }
    const double margin = reach * 1.5;  // the sagitta of an arc, too
    box = {box.xmin - margin, box.ymin - margin, box.xmax + margin, box.ymax + margin};
    std::vector<Parts> all;
    std::set<std::uint32_t> points;
    std::size_t count = 0;
    tree_.query(box, [&](std::uint32_t number) {
      ++count;
      const OffsetEdge& edge = curves_.edges[number];
      if (number == own.edge) return false;
      if (edge.start_feature != own.feature && edge.end_feature != own.feature) {
        Parts parts;
        add_line(frame, number, parts);
        if (!parts.empty()) all.push_back(std::move(parts));
      }
      for (const bool at_end : {false, true}) {
        const std::uint32_t feature = at_end ? edge.end_feature : edge.start_feature;
        const bool is_own_end =
            own.edge != OffsetPatch::none && (curves_.edges[own.edge].start_feature == feature ||
                                              curves_.edges[own.edge].end_feature == feature);
        if (feature == own.feature || is_own_end || !points.insert(feature).second) continue;
        Parts parts;
        add_point(frame, feature, spot(at_end ? edge.end : edge.start), parts);
        if (!parts.empty()) all.push_back(std::move(parts));
      }
      return false;
    });
    const Parts lowest = envelope(all, 0, all.size());
    const bool is_all = count == curves_.edges.size();
    double most = 0, covered = 0;
    for (const Part& part : lowest) {
      covered += part.to - part.from;
      for (const double u : {part.from, (part.from + part.to) / 2, part.to}) {
        most = std::max(most, frame.radius(part.value, u));
      }
    }
    const bool is_covered = covered >= (frame.last - frame.first) * (1 - 1e-12);
    if (is_all || (is_covered && most <= reach)) return found(frame, lowest);
    reach = is_covered && std::isfinite(most) ? std::max(most * 1.01, reach * 1.01) : reach * 4;
  }
}

}  // namespace minkref::inline disc
