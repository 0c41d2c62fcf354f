#include "formats/read_poly.hpp"

#include <string>
#include <utility>
#include <vector>

#include "formats/containment.hpp"
#include "formats/poly_lines.hpp"

namespace minkref {
namespace {

class PolyReader {
 public:
  PolyReader(std::string_view text, SetBuilder& set)
      : set_(set), input_(set.input()), lines_(text, input_) {}

  void run() {
    const std::size_t count = ring_count();
    for (std::size_t i = 0; i < count; ++i) ring(i, count);
    if (lines_.line()) {
      input_.refuse(
          "trailing-text", "there is text after the last of " + std::to_string(count) + " rings",
          "correct the number of rings at the top, or remove the text", lines_.line()->number);
    }
    assign();
  }

 private:
  using Tokens = std::vector<std::string_view>;

  std::size_t count_of(std::string_view token, const char* what, std::size_t line) const {
    return input_.whole_number(token, what, at_line(line));
  }

  std::size_t ring_count() {
    const TextLine& line = lines_.due("the number of rings");
    if (line.tokens.size() != 1) {
      input_.refuse("syntax", "the first line must hold the number of rings alone",
                    "write the number of rings on a line of its own", line.number);
    }
    const std::size_t count = count_of(line.tokens[0], "a number of rings", line.number);
    lines_.advance();
    return count;
  }

  static bool is_header(const Tokens& tokens) {
    return tokens.size() == 2 && (tokens[1] == "in" || tokens[1] == "out");
  }

  void ring(std::size_t index, std::size_t count) {
    const TextLine& header =
        lines_.due("ring " + std::to_string(index + 1) + " of " + std::to_string(count));
    if (!is_header(header.tokens)) {
      input_.refuse("syntax", "a ring must begin with its number of vertices and `in` or `out`",
                    "write, for example, \"275 out\"", header.number);
    }
    const bool hole = header.tokens[1] == "in";
    const std::size_t size = count_of(header.tokens[0], "a number of vertices", header.number);
    TextRing fresh = set_.ring(header.number);
    lines_.advance();
    for (std::size_t i = 0; i < size; ++i) vertex(fresh, size);
    if (size < 3 && !set_.keeps_faults()) {
      input_.refuse("too-few-vertices", "a ring needs three or more vertices",
                    "complete the ring or leave it out; give a point or a segment as WKT",
                    fresh.place());
    }
    indices(fresh);
    // A ring of fewer than three vertices, kept with its faults, holds nothing.
    if (fresh.points.size() < 3) return set_.polygon(std::move(fresh), {});
    (hole ? holes_ : outers_).push_back(std::move(fresh));
  }

  void vertex(TextRing& ring, std::size_t size) {
    const TextLine& line = lines_.due("vertex " + std::to_string(ring.points.size() + 1) + " of " +
                                      std::to_string(size));
    if (line.tokens.size() != 2 || is_header(line.tokens)) {
      Place where = ring.place_of(ring.points.size());
      where.line = line.number;
      input_.refuse(line.tokens.size() == 3 ? "three-dimensional" : "syntax",
                    "a vertex line must hold two numbers",
                    "write x and y, and check the number of vertices of the ring", where);
    }
    set_.vertex(ring, line.tokens[0], line.tokens[1], line.number);
    lines_.advance();
  }

  /// Reads the order of the ring's vertices, each named once, from 1, possibly on several lines.
  /// Without such lines the order stays.
  void indices(TextRing& ring) {
    const std::size_t size = ring.points.size();
    std::vector<std::size_t> order;
    std::vector<bool> named(size, false);
    while (lines_.line() && order.size() < size && !is_header(lines_.line()->tokens)) {
      for (const std::string_view token : lines_.line()->tokens) {
        order.push_back(index(token, ring, order.size(), named));
      }
      lines_.advance();
    }
    if (order.empty()) return;
    if (order.size() < size) {
      Place where = ring.place();
      where.line = lines_.last_number();
      input_.refuse(lines_.line() ? "syntax" : "truncated",
                    "the ring has " + std::to_string(size) + " vertices and " +
                        std::to_string(order.size()) + " indices",
                    "complete them, or leave out the line of indices", where);
    }
    Ring points(size);
    std::vector<std::uint32_t> lines(size);
    for (std::size_t i = 0; i < size; ++i) {
      points[i] = std::move(ring.points[order[i]]);
      lines[i] = ring.lines[order[i]];
    }
    ring.points = std::move(points);
    ring.lines = std::move(lines);
  }

  /// Reads an index, counted from 0; `before`: the number of indices so far.
  std::size_t index(std::string_view token, const TextRing& ring, std::size_t before,
                    std::vector<bool>& named) const {
    const std::size_t size = named.size(), line = lines_.line()->number;
    const std::size_t value = count_of(token, "an index", line);
    const auto refuse = [&](const std::string& problem) {
      Place where = ring.place();
      where.line = line;
      input_.refuse("syntax", problem,
                    "name each vertex once, in the order in which the ring runs, or leave the line "
                    "of indices out",
                    where);
    };
    if (before == size)
      refuse("there are more indices than the " + std::to_string(size) + " vertices of the ring");
    if (value < 1 || value > size) {
      refuse("the index " + std::to_string(value) + " is none of 1 to " + std::to_string(size));
    }
    if (named[value - 1]) refuse("the index " + std::to_string(value) + " comes twice");
    named[value - 1] = true;
    return value - 1;
  }

  /// Sorts the holes under their outer rings.
  void assign() {
    std::vector<const Ring*> outers, holes;
    std::vector<Place> places;
    for (const TextRing& outer : outers_) outers.push_back(&outer.points);
    for (const TextRing& hole : holes_) {
      holes.push_back(&hole.points);
      places.push_back(hole.place_of(0));
    }
    const auto owners = owners_of(outers, holes, places);
    std::vector<std::vector<TextRing>> held(outers_.size());
    for (std::size_t h = 0; h < holes_.size(); ++h) held[owners[h]].push_back(std::move(holes_[h]));
    for (std::size_t o = 0; o < outers_.size(); ++o) {
      set_.polygon(std::move(outers_[o]), std::move(held[o]));
    }
  }

  /// The outer ring of each hole. If faults are kept, a hole in no outer ring goes to the first.
  std::vector<std::size_t> owners_of(const std::vector<const Ring*>& outers,
                                     const std::vector<const Ring*>& holes,
                                     const std::vector<Place>& places) const {
    if (!set_.keeps_faults() || outers.empty()) {
      return containing_outers(outers, holes, places, input_);
    }
    std::vector<std::size_t> owners;
    for (std::size_t h = 0; h < holes.size(); ++h) {
      try {
        owners.push_back(containing_outers(outers, {holes[h]}, {places[h]}, input_).front());
      } catch (const BadInput& fault) {
        if (fault.code() != "hole-outside") throw;
        owners.push_back(0);
      }
    }
    return owners;
  }

  SetBuilder& set_;
  Input& input_;
  PolyLines lines_;
  std::vector<TextRing> outers_, holes_;
};

}  // namespace

void read_poly(std::string_view text, SetBuilder& set) { PolyReader(text, set).run(); }

}  // namespace minkref
