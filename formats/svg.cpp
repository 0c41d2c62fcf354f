#include "formats/svg.hpp"

#include <array>
#include <charconv>

#include "formats/picture_frame.hpp"
#include "reference/interrupt.hpp"

namespace minkref {
namespace {

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string short_number(double value) {
  std::array<char, 40> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 9);
  return {text.data(), end.ptr};
}

/// The shortest text that reads as this double.
std::string shortest(double value) {
  std::array<char, 40> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

class Picture {
 public:
  explicit Picture(const std::vector<Layer>& layers) : frame_(layers) {
    for (const Layer& layer : layers) draw(layer);
  }

  std::string text() const {
    constexpr double margin = 20;
    const double width = frame_.width() + 2 * margin, height = frame_.height() + 2 * margin;
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + short_number(-margin) + " " +
           short_number(-margin) + " " + short_number(width) + " " + short_number(height) +
           "\" width=\"" + short_number(width) + "\" height=\"" + short_number(height) + "\">\n" +
           body_ + "</svg>\n";
  }

 private:
  std::string position(const Point& p) const {
    look_for_interrupt();
    return shortest(frame_.x(p)) + "," + shortest(frame_.y(p));
  }

  void append_ring(std::string& path, const Ring& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i) path += (i == 0 ? "M" : "L") + position(ring[i]);
    if (ring.size() > 2) path += "Z";
  }

  void draw(const Layer& layer) {
    body_ += "<g stroke=\"" + escaped(layer.stroke) + "\" stroke-width=\"" +
             short_number(layer.stroke_width) + "\" stroke-linejoin=\"round\">\n";
    if (!layer.name.empty()) body_ += "<title>" + escaped(layer.name) + "</title>\n";
    std::string path;
    for (const Polygon& polygon : layer.region.polygons) {
      if (polygon.outer.size() == 1) {
        draw_point(polygon.outer[0], layer);
        continue;
      }
      append_ring(path, polygon.outer);
      for (const Ring& hole : polygon.holes) append_ring(path, hole);
    }
    draw_path(path, layer.fill, layer.opacity);
    std::string lines;
    for (const Segment& s : layer.segments)
      lines += "M" + position(s.start) + "L" + position(s.end);
    draw_path(lines, "none", 1);
    body_ += "</g>\n";
  }

  void draw_point(const Point& p, const Layer& layer) {
    body_ += "<circle cx=\"" + shortest(frame_.x(p)) + "\" cy=\"" + shortest(frame_.y(p)) +
             "\" r=\"" + short_number(2 * layer.stroke_width + 1) + "\" fill=\"" +
             escaped(layer.stroke) + "\"/>\n";
  }

  void draw_path(const std::string& path, const std::string& fill, double opacity) {
    if (path.empty()) return;
    body_ += "<path d=\"" + path + "\" fill=\"" + escaped(fill) + "\" fill-rule=\"evenodd\"" +
             " fill-opacity=\"" + short_number(opacity) + "\"/>\n";
  }

  PictureFrame frame_;
  std::string body_;
};

}  // namespace

std::string write_svg(const std::vector<Layer>& layers) { return Picture(layers).text(); }

}  // namespace minkref
