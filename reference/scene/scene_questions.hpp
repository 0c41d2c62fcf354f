// Questions about a scene that need no union: a place, a way, and room to grow.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "reference/motion/valid_scales.hpp"
#include "reference/plane/witness.hpp"
#include "reference/scene/scene.hpp"

namespace minkref::inline scene {

/// A copy that the robot meets, with or without common interior points.
struct Holder {
  std::uint32_t copy = 0;
  Contact contact = Contact::touching;
  friend bool operator==(const Holder&, const Holder&) = default;
};

/// How far all copies may grow by one factor, each about its own place, before one of them stops
/// the robot.
struct Growth {
  std::optional<Rational> factor;  ///< at least 1; none: no copy ever stops the robot
  bool included = false;           ///< the robot still passes at this very factor
  /// A copy that stops it, the robot's place on the way then, the features that touch, and where.
  std::uint32_t copy = 0;
  PathPlace at;
  TouchingFeature of_robot, of_copy;
  Point touching;
  /// Copies that stop it together, beside a robot without area; then `copy` and the features say
  /// nothing. `included` tells whether they do so just above the factor, or at the factor itself.
  std::vector<std::uint32_t> seam;
};

/// A scene, ready to be asked. All answers are exact. Obstacles without seams count: beside a
/// robot without area, copies that touch are merged first (docs/scenes.md). The first question
/// about some copy costs the time to cut its shape into pieces.
class SceneQuestions {
 public:
  /// Throws BadInput ("bad-scale", "no-shape", "no-area").
  explicit SceneQuestions(Scene scene);

  /// Copies that the robot meets at a place, ascending. The place is free, with contact forbidden,
  /// iff there is none. O(n) boxes, and the decision of a point for each box that holds the place.
  std::vector<Holder> holders(const Point& place) const;

  /// Whether the robot's way along a polyline is free, and the copies that stop it by themselves,
  /// ascending: none of a way that is not free means that a seam of copies stops a robot without
  /// area. Throws BadInput ("bad-path" for a way without vertices).
  struct WayAnswer {
    bool free = true;
    std::vector<std::uint32_t> stopped_by;
  };
  WayAnswer way(const std::vector<Point>& path, ContactRule rule) const;

  /// The least upper bound of the factors f >= 1 up to which the way stays free while all copies
  /// grow from 1 to f times their scales; none if the way is not free now. Throws as way().
  std::optional<Growth> growth(const std::vector<Point>& path, ContactRule rule) const;

 private:
  struct ExactBox {
    Point low, high;
  };
  static ExactBox box_of(const std::vector<Point>& points);
  static ExactBox box_of(const PolygonSet& set);
  bool may_meet(std::uint32_t copy, const ExactBox& path) const;
  std::optional<Rational> first_factor(std::uint32_t copy, const ExactBox& path) const;
  ValidScales scales(std::uint32_t copy, const std::vector<Point>& path, ContactRule rule,
                     const ScaleWindow& window) const;
  bool seam_stops(const std::vector<Point>& path) const;
  void end_at_seam(const std::vector<Point>& path,
                   const std::vector<std::pair<Rational, std::uint32_t>>& near,
                   Growth& growth) const;

  Scene scene_;
  PolygonSet turned_robot_;                ///< -R
  std::vector<PolygonSet> turned_shapes_;  ///< the shapes, turned
  ExactBox robot_box_;
  std::vector<ExactBox> shape_boxes_;
};

}  // namespace minkref::inline scene
