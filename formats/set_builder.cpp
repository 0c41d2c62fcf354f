#include "formats/set_builder.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "reference/number/message_number.hpp"
#include "reference/plane/lines.hpp"

namespace minkref {
namespace {

[[noreturn]] void too_few(const Input& input, const TextRing& ring) {
  input.refuse("too-few-vertices",
               "the ring has " + std::to_string(ring.points.size()) +
                   (ring.points.size() == 1 ? " vertex" : " different vertices") +
                   ", a ring has three or more",
               "complete the ring or leave it out; write a point or a segment as such, alone",
               ring.place());
}

RingOrigin::Order turned(const Ring& before, const Ring& after) {
  if (before == after) return RingOrigin::Order::as_read;
  return before.front() == after.front() ? RingOrigin::Order::reversed_after_first
                                         : RingOrigin::Order::reversed;
}

}  // namespace

Place TextRing::place() const {
  Place where = at_line(line);
  where.ring = number;
  return where;
}

Place TextRing::place_of(std::size_t vertex) const {
  Place where = place();
  where.vertices.push_back(vertex);
  if (vertex < points.size()) {
    where.line = lines[vertex];
    where.coordinates.push_back("(" + message_text(points[vertex].x) + ", " +
                                message_text(points[vertex].y) + ")");
  }
  return where;
}

TextRing SetBuilder::ring(std::size_t line) {
  TextRing fresh;
  fresh.number = rings_++;
  fresh.line = line;
  return fresh;
}

void SetBuilder::vertex(TextRing& ring, std::string_view x, std::string_view y, std::size_t line) {
  Place where = ring.place_of(ring.points.size());
  where.line = line;
  input_.count_vertex(where);
  Rational first = input_.number(x, where);
  Rational second = input_.number(y, where);
  ring.points.push_back({std::move(first), std::move(second)});
  ring.lines.push_back(static_cast<std::uint32_t>(line));
}

void SetBuilder::drop(const std::string& what, std::size_t line) {
  const auto known = [&](const auto& one) { return one.first == what; };
  if (std::ranges::none_of(dropped_, known)) dropped_.emplace_back(what, line);
}

void SetBuilder::drop_coordinate(std::string_view token, const Place& place) {
  const bool is_nan = token.size() == 3 && std::ranges::equal(token, std::string_view("nan"), {},
                                                              [](char c) { return c | 0x20; });
  if (!is_nan) input_.number(token, place);
  if (coordinates_dropped_++ == 0) coordinates_line_ = place.line.value_or(0);
}

void SetBuilder::tell_dropped() {
  for (const auto& [what, line] : dropped_) input_.warn(line, "dropped: " + what);
  dropped_.clear();
  if (coordinates_dropped_ > 0) {
    input_.warn(coordinates_line_, "dropped: " + std::to_string(coordinates_dropped_) +
                                       " coordinates beyond x and y, from here on");
  }
  coordinates_dropped_ = 0;
}

void SetBuilder::close(TextRing& ring) const {
  if (keeps_faults()) {
    ring.is_open = ring.points.size() > 1 && ring.points.front() != ring.points.back();
    if (ring.points.size() < 2 || ring.is_open) return;
    ring.points.pop_back();
    ring.lines.pop_back();
    return;
  }
  if (ring.points.empty()) too_few(input_, ring);
  if (ring.points.front() != ring.points.back()) {
    Place where = ring.place_of(0);
    Place last = ring.place_of(ring.points.size() - 1);
    where.line = last.line;
    where.vertices.push_back(last.vertices.front());
    where.coordinates.push_back(last.coordinates.front());
    input_.refuse("ring-not-closed", "the last vertex of the ring differs from the first",
                  "repeat the first vertex at the end of the ring", where);
  }
  if (ring.points.size() > 1) {
    ring.points.pop_back();
    ring.lines.pop_back();
  }
  if (ring.points.size() < 3) too_few(input_, ring);
}

void SetBuilder::point(TextRing vertex) { polygon(std::move(vertex), {}); }

void SetBuilder::line(const TextRing& vertices, std::string_view line, std::string_view points) {
  const std::size_t size = vertices.points.size();
  if (size < 2) {
    input_.refuse("not-a-segment",
                  "a " + std::string(line) + " of " + std::to_string(size) + " " +
                      std::string(points) + " has no segment",
                  "give two " + std::string(points) + " or more", vertices.place());
  }
  for (std::size_t k = 1; k < size; ++k) {
    if (vertices.points[k - 1] == vertices.points[k]) {
      Place where = vertices.place_of(k - 1);
      where.vertices.push_back(k);
      where.coordinates.push_back(where.coordinates.front());
      input_.refuse("zero-length-edge", "two consecutive vertices are equal", "remove one of them",
                    where);
    }
    TextRing ends{{vertices.points[k - 1], vertices.points[k]},
                  vertices.number,
                  vertices.line,
                  {vertices.lines[k - 1], vertices.lines[k]}};
    polygon(std::move(ends), {});
  }
}

void SetBuilder::polygon(TextRing outer, std::vector<TextRing> holes) {
  std::vector<TextRing> rings;
  rings.push_back(std::move(outer));
  for (TextRing& hole : holes) rings.push_back(std::move(hole));
  polygons_.push_back(std::move(rings));
}

Reading SetBuilder::finish_as_read() {
  const bool are_thin = std::all_of(polygons_.begin(), polygons_.end(), [](const auto& rings) {
    return rings.size() == 1 && rings[0].points.size() < 3;
  });
  for (const auto& rings : polygons_) {
    for (const TextRing& ring : rings) {
      const std::size_t size = ring.points.size();
      if (size >= 3 || (are_thin && size > 0) || keeps_faults()) continue;
      if (size == 0 || &ring != &rings[0] || rings.size() > 1) too_few(input_, ring);
      input_.refuse("mixed-operand",
                    std::string(size == 1 ? "a point" : "a segment") +
                        " occurs together with "
                        "polygons",
                    "give points and lines in a file of their own", ring.place_of(0));
    }
  }
  Reading reading;
  for (auto& rings : polygons_) {
    Polygon polygon;
    for (TextRing& ring : rings) {
      RingOrigin origin;
      origin.ring = ring.number;
      origin.lines = std::move(ring.lines);
      open_.push_back(ring.is_open);
      reading.origins.push_back(std::move(origin));
      (&ring == &rings[0] ? polygon.outer : polygon.holes.emplace_back()) = std::move(ring.points);
    }
    reading.set.polygons.push_back(std::move(polygon));
  }
  polygons_.clear();
  tell_dropped();
  reading.warnings = input_.take_warnings();
  return reading;
}

Reading SetBuilder::finish() {
  Reading reading = finish_as_read();
  if (!has_area(reading.set)) return reading;
  const PolygonSet before = reading.set;
  orient(reading.set);
  auto origin = reading.origins.begin();
  for (std::size_t i = 0; i < before.polygons.size(); ++i) {
    const Polygon& old = before.polygons[i];
    const Polygon& now = reading.set.polygons[i];
    (origin++)->order = turned(old.outer, now.outer);
    for (std::size_t j = 0; j < old.holes.size(); ++j) {
      (origin++)->order = turned(old.holes[j], now.holes[j]);
    }
  }
  return reading;
}

}  // namespace minkref
