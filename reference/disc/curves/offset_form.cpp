#include "reference/disc/curves/offset_form.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace minkref::inline disc {
namespace {

/// The start that makes a cyclic list of numbers least.
std::size_t least_start(const std::vector<std::uint32_t>& ring) {
  const std::size_t n = ring.size();
  std::size_t i = 0, j = 1, k = 0;  // two candidates that agree in k numbers
  while (i < n && j < n && k < n) {
    const std::uint32_t a = ring[(i + k) % n], b = ring[(j + k) % n];
    if (a == b) {
      ++k;
      continue;
    }
    (a > b ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return std::min(i, j);
}

bool is_less(const OffsetCurve& a, const OffsetCurve& b) {
  if (a.is_arc != b.is_arc) return a.is_arc;
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.c < b.c;
}

template <class Visit>
void for_rings(OffsetForm& form, Visit&& visit) {
  for (FormComponent& component : form) {
    visit(component.outer);
    std::for_each(component.holes.begin(), component.holes.end(), visit);
  }
}

/// Feature numbers, ordered by curve. Each feature has its own curve.
std::vector<std::uint32_t> sorted_features(OffsetForm& form, const OffsetCurves& curves) {
  std::set<std::uint32_t> used;
  for_rings(form,
            [&](const FormRing& ring) { used.insert(ring.curves.begin(), ring.curves.end()); });
  std::vector<std::pair<OffsetCurve, std::uint32_t>> sorted;
  for (const std::uint32_t feature : used) {
    sorted.emplace_back(offset_curve(curves, feature), feature);
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return is_less(a.first, b.first); });
  std::vector<std::uint32_t> features;
  for (const auto& [curve, feature] : sorted) features.push_back(feature);
  return features;
}

void append(std::string& text, const Rational& number) {
  text += '"';
  text += to_string(number);
  text += '"';
}

void append(std::string& text, const FormRing& ring, const OffsetCurves& curves,
            const Point& origin) {
  text += '[';
  for (std::size_t k = 0; k < ring.curves.size(); ++k) {
    const OffsetCurve curve = offset_curve(curves, ring.curves[k], origin);
    text += k == 0 ? "[" : ",[";
    text += curve.is_arc ? "\"arc\"," : "\"line\",";
    append(text, curve.x);
    text += ',';
    append(text, curve.y);
    if (!curve.is_arc) {
      text += ',';
      append(text, curve.c);
    }
    text += ']';
  }
  text += ']';
}

}  // namespace

OffsetCurve offset_curve(const OffsetCurves& curves, std::uint32_t feature, const Point& origin) {
  const OffsetCurves::Feature& own = curves.features[feature];
  if (own.edge == OffsetPatch::none) {
    return {true, own.centre.x + origin.x, own.centre.y + origin.y, 0};
  }
  const OffsetEdge& edge = curves.edges[own.edge];
  const auto [dx, dy] = primitive(edge.along);
  const Rational x = edge.start.x + origin.x, y = edge.start.y + origin.y;
  return {false, dx, dy, dy * x - dx * y};
}

void make_canonical(OffsetForm& form, const OffsetCurves& curves) {
  const std::vector<std::uint32_t> features = sorted_features(form, curves);
  std::vector<std::uint32_t> numbers(curves.features.size(), 0);
  for (std::uint32_t k = 0; k < features.size(); ++k) numbers[features[k]] = k;
  for_rings(form, [&](FormRing& ring) {
    for (std::uint32_t& curve : ring.curves) curve = numbers[curve];
    const auto start = static_cast<std::ptrdiff_t>(least_start(ring.curves));
    std::rotate(ring.curves.begin(), ring.curves.begin() + start, ring.curves.end());
  });
  const auto less = [](const FormRing& a, const FormRing& b) { return a.curves < b.curves; };
  for (FormComponent& component : form) {
    std::sort(component.holes.begin(), component.holes.end(), less);
  }
  std::sort(form.begin(), form.end(),
            [&](const FormComponent& a, const FormComponent& b) { return less(a.outer, b.outer); });
  for_rings(form, [&](FormRing& ring) {
    for (std::uint32_t& curve : ring.curves) curve = features[curve];
  });
}

std::string canonical_json(const OffsetForm& form, const OffsetCurves& curves,
                           const Rational& squared_radius, const Point& origin) {
  std::string text = "{\"components\":[";
  for (std::size_t k = 0; k < form.size(); ++k) {
    text += k == 0 ? "{\"holes\":[" : ",{\"holes\":[";
    for (std::size_t h = 0; h < form[k].holes.size(); ++h) {
      if (h > 0) text += ',';
      append(text, form[k].holes[h], curves, origin);
    }
    text += "],\"outer\":";
    append(text, form[k].outer, curves, origin);
    text += '}';
  }
  text += "],\"squared_radius\":";
  append(text, squared_radius);
  text += '}';
  return text;
}

}  // namespace minkref::inline disc
