#include "reference/disc/features/merge_text.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/interrupt.hpp"

namespace minkref::inline disc {
namespace {

using Curve = std::tuple<bool, Rational, Rational, Rational>;  ///< lines after vertices

class TreeText {
 public:
  TreeText(const DiscIndex& index, const MergeTree& tree) : diagram_(index.diagram()), tree_(tree) {
    const OffsetCurves& curves = diagram_.curves;
    for (std::uint32_t k = 0; k < curves.features.size(); ++k) {
      const OffsetCurves::Feature& feature = curves.features[k];
      if (feature.edge == OffsetPatch::none) {
        const Point at = diagram_.vertex(k);
        curves_.emplace_back(false, at.x, at.y, 0);
        continue;
      }
      const OffsetEdge& edge = curves.edges[feature.edge];
      const auto [x, y] = primitive(edge.along);
      const Point at = diagram_.vertex(edge.start_feature);
      curves_.emplace_back(true, x, y, y * at.x - x * at.y);
    }
    std::map<Features, std::size_t> seen;
    for (const DiagramEvent& event : diagram_.events) number_.push_back(seen[event.features]++);
  }

  std::string text() {
    text_ = "{\"nodes\":[";
    std::size_t level = 0;
    for (std::uint32_t k = 0; k < tree_.nodes.size(); ++k) {
      look_for_interrupt();
      const MergeNode& node = tree_.nodes[k];
      if (k > 0 && node.radius != tree_.nodes[k - 1].radius) ++level;
      text_ += k == 0 ? "{\"children\":[" : ",{\"children\":[";
      list(node.children, [&](std::uint32_t child) { text_ += std::to_string(child); });
      text_ += "],\"kind\":\"";
      text_ += name(node.kind);
      text_ += "\",\"level\":" + std::to_string(level) + ",\"places\":[";
      if (tree_.is_reflex(k)) {
        put(tree_.ends[k]);
      } else if (node.kind != MergeNode::Kind::outside) {
        list(node.places, [&](const auto& group) {
          text_ += '[';
          list(group, [&](std::uint32_t event) { put(event); });
          text_ += ']';
        });
      }
      text_ += "]}";
    }
    return text_ + "]}";
  }

 private:
  template <class Items, class Put>
  void list(const Items& items, Put&& put) {
    for (std::size_t k = 0; k < items.size(); ++k) {
      if (k > 0) text_ += ',';
      put(items[k]);
    }
  }
  void put_numbers(const char* kind, const std::vector<Rational>& numbers) {
    text_ += "[\"";
    text_ += kind;
    text_ += '"';
    for (const Rational& number : numbers) text_ += ",\"" + to_string(number) + '"';
    text_ += ']';
  }

  void put(const ReflexEnd& end) {
    const Point at{end.vertex.x / diagram_.factor + diagram_.origin.x,
                   end.vertex.y / diagram_.factor + diagram_.origin.y};
    put_numbers("end", {at.x, at.y, end.along.x, end.along.y});
  }

  /// An event.
  void put(std::uint32_t event) {
    std::vector<Curve> near;
    for (const std::uint32_t k : diagram_.events[event].features) near.push_back(curves_[k]);
    std::sort(near.begin(), near.end());
    text_ += '[';
    for (const auto& [is_line, x, y, c] : near) {
      is_line ? put_numbers("line", {x, y, c}) : put_numbers("vertex", {x, y});
      text_ += ',';
    }
    text_ += std::to_string(number_[event]) + ']';
  }

  const DiagramEvents& diagram_;
  const MergeTree& tree_;
  std::vector<Curve> curves_;        ///< by feature
  std::vector<std::size_t> number_;  ///< by event, among those with the same features
  std::string text_;
};

}  // namespace

const char* name(MergeNode::Kind kind) {
  switch (kind) {
    case MergeNode::Kind::reflex:
      return "reflex";
    case MergeNode::Kind::minimum:
      return "minimum";
    case MergeNode::Kind::merge:
      return "merge";
    case MergeNode::Kind::hole:
      return "hole";
    case MergeNode::Kind::outside:
      return "outside";
  }
  return "";
}

std::string canonical_json(const DiscIndex& index, const MergeTree& tree) {
  return TreeText(index, tree).text();
}

}  // namespace minkref::inline disc
