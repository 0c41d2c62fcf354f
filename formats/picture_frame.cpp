#include "formats/picture_frame.hpp"

#include "reference/interrupt.hpp"

namespace minkref {

void PictureFrame::include(const Point& p) {
  look_for_interrupt();
  if (!any_ || p.x < left_) left_ = p.x;
  if (!any_ || p.x > right_) right_ = p.x;
  if (!any_ || p.y < bottom_) bottom_ = p.y;
  if (!any_ || p.y > top_) top_ = p.y;
  any_ = true;
}

PictureFrame::PictureFrame(const std::vector<Layer>& layers) {
  for (const Layer& layer : layers) {
    for (const Polygon& polygon : layer.region.polygons) {
      for (const Point& p : polygon.outer) include(p);
      for (const Ring& hole : polygon.holes) {
        for (const Point& p : hole) include(p);
      }
    }
    for (const Segment& s : layer.segments) {
      include(s.start);
      include(s.end);
    }
  }
  const Rational wide = right_ - left_, high = top_ - bottom_;
  const Rational longer = wide > high ? wide : high;
  if (sign(longer) > 0) factor_ = 1000 / longer;
  width_ = to_double(wide * factor_);
  height_ = to_double(high * factor_);
}

}  // namespace minkref
