// From the plane to the picture: the common bounding box of all layers, its longer side 1000 long.
#pragma once

#include <vector>

#include "formats/svg.hpp"

namespace minkref {

class PictureFrame {
 public:
  explicit PictureFrame(const std::vector<Layer>& layers);

  double width() const { return width_; }
  double height() const { return height_; }
  double x(const Point& p) const { return to_double((p.x - left_) * factor_); }
  double y(const Point& p) const { return to_double((top_ - p.y) * factor_); }  ///< y points up

 private:
  void include(const Point& p);

  bool any_ = false;
  Rational left_ = 0, right_ = 0, bottom_ = 0, top_ = 0, factor_ = 1;
  double width_ = 0, height_ = 0;
};

}  // namespace minkref
