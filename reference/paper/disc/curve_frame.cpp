#include "reference/paper/disc/curve_frame.hpp"

#include <map>
#include <tuple>

namespace minkref::inline disc {
namespace {

class FrameBuilder {
 public:
  FrameBuilder(CurveFrame& frame, bool are_joined) : frame_(frame), are_joined_(are_joined) {}

  void run() {
    const auto count = static_cast<std::uint32_t>(frame_.features.size());
    for (std::uint32_t k = 0; k < count; ++k) frame_.ends.push_back({end(k, 0), end(k, 1)});
    for (std::uint32_t k = 0; k < count; ++k) {
      frame_.first_part.push_back(static_cast<std::uint32_t>(frame_.parts.size()));
      if (frame_.features[k].is_arc) {
        add_quadrants(k);
      } else {
        frame_.parts.push_back({k, -1, frame_.ends[k][0], frame_.ends[k][1]});
      }
    }
    frame_.first_part.push_back(static_cast<std::uint32_t>(frame_.parts.size()));
  }

 private:
  std::uint32_t added(const FrameNode& node) {
    frame_.nodes.push_back(node);
    return static_cast<std::uint32_t>(frame_.nodes.size() - 1);
  }

  std::uint32_t end(std::uint32_t feature, int which) {
    const OffsetFeature& own = frame_.features[feature];
    const auto k = static_cast<std::size_t>(which);
    if (!are_joined_) return added({feature, which, {}});
    const Direction way = primitive(own.way[k]);
    const auto [found, is_new] =
        joints_.try_emplace({own.at[k].x, own.at[k].y, way.x, way.y}, frame_.nodes.size());
    if (is_new) added({feature, which, {}});
    return static_cast<std::uint32_t>(found->second);
  }

  /// Cuts an arc at normals along the axes.
  void add_quadrants(std::uint32_t feature) {
    const OffsetFeature& arc = frame_.features[feature];
    Direction from = arc.way[0];
    std::uint32_t node = frame_.ends[feature][0];
    for (;;) {
      const int quadrant = quadrant_from(from);
      const Direction axis = axis_after(quadrant);
      if (!comes_before(from, axis, arc.way[1])) {
        frame_.parts.push_back({feature, quadrant, node, frame_.ends[feature][1]});
        return;
      }
      const std::uint32_t next = added({feature, -1, axis});
      frame_.parts.push_back({feature, quadrant, node, next});
      node = next;
      from = axis;
    }
  }

  static Direction axis_after(int quadrant) {
    switch (quadrant) {
      case 0:
        return {0, 1};
      case 1:
        return {-1, 0};
      case 2:
        return {0, -1};
      default:
        return {1, 0};
    }
  }

  CurveFrame& frame_;
  bool are_joined_;
  std::map<std::tuple<Rational, Rational, Rational, Rational>, std::size_t> joints_;
};

}  // namespace

int quadrant_from(const Direction& normal) {
  if (normal.x > 0 && normal.y >= 0) return 0;
  if (normal.x <= 0 && normal.y > 0) return 1;
  return normal.x < 0 && normal.y <= 0 ? 2 : 3;
}

CurveFrame curve_frame(const PolygonSet& P, bool are_joined) {
  CurveFrame frame;
  frame.curves = offset_curves(P);
  frame.features = offset_features(frame.curves);
  FrameBuilder(frame, are_joined).run();
  return frame;
}

}  // namespace minkref::inline disc
