#include "bindings/core_timeline.hpp"

#include "reference/error.hpp"

namespace minkref::python {

ConvolutionType convolution_followed(const std::string& route) {
  if (route == "dynamic") return ConvolutionType::reduced;
  if (route == "winding") return ConvolutionType::full;
  throw BadInput("unknown-route", "no way through the scales is called \"" + route + "\"",
                 "choose dynamic or winding");
}

ScaleWindow window_of(const std::optional<std::string>& from,
                      const std::optional<std::string>& to) {
  ScaleWindow window;
  if (from) window.from = parse_rational(*from);
  if (to) window.to = parse_rational(*to);
  return window;
}

bool TimelineRows::within(std::uint32_t group) const {
  const Rational scale = scale_(group);
  return !(window_.from && scale < *window_.from) && !(window_.to && scale > *window_.to);
}

const std::vector<Feature>& TimelineRows::of_kind(const std::string& kind) const {
  if (kind == "hole") return timeline_.holes;
  if (kind == "component") return timeline_.components;
  throw BadInput("unknown-feature", "there is no feature \"" + kind + "\"",
                 "choose hole or component");
}

std::vector<TimelineRows::LifeRow> TimelineRows::lives(const std::string& kind) const {
  const std::vector<Feature>& features = of_kind(kind);
  std::vector<LifeRow> rows;
  for (std::uint32_t i = kind == "hole" ? 1 : 0; i < features.size(); ++i) {
    std::optional<Rational> born, died;
    if (features[i].born) born = scale_(*features[i].born);
    if (features[i].died) died = scale_(*features[i].died);
    if (born && window_.to && *born > *window_.to) continue;
    if (died && window_.from && *died < *window_.from) continue;
    if (born && window_.from && *born < *window_.from) born.reset();
    if (died && window_.to && *died > *window_.to) died.reset();
    rows.emplace_back(i, exact_number(born), exact_number(died));
  }
  return rows;
}

std::vector<TimelineRows::BoundaryRow> TimelineRows::boundary_events() const {
  std::vector<BoundaryRow> rows;
  static constexpr std::array<const char*, 4> changes{"birth", "death", "swap", "touch"};
  for (const BoundaryEvent& event : timeline_.boundary) {
    if (!within(event.group)) continue;
    rows.emplace_back(text(event.group), changes.at(static_cast<std::size_t>(event.change)),
                      event.edges, to_strings(event.place));
  }
  return rows;
}

std::vector<TimelineRows::TopologyRow> TimelineRows::topology_events() const {
  std::vector<TopologyRow> rows;
  static constexpr std::array<const char*, 5> changes{"birth", "death", "merge", "split", "touch"};
  for (const TopologyEvent& event : timeline_.topology) {
    if (!within(event.group)) continue;
    rows.emplace_back(text(event.group), event.kind == FeatureKind::hole ? "hole" : "component",
                      changes.at(static_cast<std::size_t>(event.change)), event.before, event.after,
                      event.at, to_strings(event.place));
  }
  return rows;
}

std::vector<TimelineRows::FeatureRow> TimelineRows::features(const std::string& kind) const {
  std::vector<FeatureRow> rows;
  for (const Feature& feature : of_kind(kind)) {
    const auto scale = [&](const std::optional<std::uint32_t>& group) {
      return group ? std::optional(text(*group)) : std::nullopt;
    };
    rows.emplace_back(scale(feature.born), scale(feature.died));
  }
  return rows;
}

std::vector<TimelineRows::CountRow> TimelineRows::state_counts() const {
  std::vector<CountRow> rows;
  bool first = true;
  for (const auto& c : timeline_.counts) {
    rows.emplace_back(first ? std::nullopt : std::optional(text(c.interval - 1)),
                      std::array{c.holes, c.components, c.vertices, c.holes_at, c.components_at});
    first = false;
  }
  return rows;
}

}  // namespace minkref::python
