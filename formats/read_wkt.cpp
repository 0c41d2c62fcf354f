#include "formats/read_wkt.hpp"

#include <string>
#include <utility>

#include "formats/message_text.hpp"
#include "formats/wkt_tokens.hpp"

namespace minkref {
namespace {

class WktReader {
 public:
  WktReader(std::string_view text, SetBuilder& set)
      : set_(set), input_(set.input()), tokens_(text, input_) {}

  void run() {
    geometry(0);
    if (!tokens_.at_end()) {
      input_.refuse("trailing-text", "there is text after the end of the geometry",
                    "keep one geometry in the file", tokens_.line());
    }
  }

 private:
  void geometry(std::size_t depth) {
    const std::size_t line = tokens_.line();
    const std::string word = tokens_.word("a geometry");
    if (word == "SRID") {
      input_.refuse("unsupported-geometry", "a reference system (SRID) has no meaning here",
                    "leave the prefix SRID=...; out", line);
    }
    refuse_dimensions(word, line);
    if (word == "POLYGON") {
      if (!empty()) polygon();
    } else if (word == "MULTIPOLYGON") {
      if (!empty())
        list([&] {
          if (!tokens_.take_word("EMPTY")) polygon();
        });
    } else if (word == "POINT") {
      if (!empty()) point();
    } else if (word == "LINESTRING") {
      if (!empty()) segment();
    } else if (word == "GEOMETRYCOLLECTION") {
      collection(depth);
    } else {
      input_.refuse("unsupported-geometry", in_quotes(word) + " is not an operand in the plane",
                    "give a POLYGON, a MULTIPOLYGON, a POINT or a LINESTRING of two points", line);
    }
  }

  void refuse_dimensions(const std::string& word, std::size_t line) {
    const bool glued = word.ends_with("Z") || word.ends_with("ZM") || word.ends_with("M");
    if (tokens_.peek_word("Z") || tokens_.peek_word("M") || tokens_.peek_word("ZM") || glued) {
      input_.refuse("three-dimensional", "the geometry has coordinates beyond x and y (Z or M)",
                    "drop them: the plane has two coordinates", line);
    }
  }

  bool empty() { return tokens_.take_word("EMPTY"); }

  void collection(std::size_t depth) {
    if (empty()) return;
    if (depth >= input_.limits().depth) {
      input_.exceed("too-deep",
                    "collections are nested deeper than " + std::to_string(input_.limits().depth),
                    "flatten the collection, or raise the limit on depth", at_line(tokens_.line()));
    }
    list([&] { geometry(depth + 1); });
  }

  /// "(" item "," item ... ")"
  template <class Item>
  void list(Item item) {
    tokens_.expect('(');
    do {
      item();
    } while (tokens_.take(','));
    tokens_.expect(')');
  }

  void vertex(TextRing& ring) {
    const std::size_t line = tokens_.line();
    const std::string_view x = tokens_.number();
    const std::string_view y = tokens_.number();
    if (tokens_.at_number()) {
      Place where = ring.place_of(ring.points.size());
      where.line = line;
      input_.refuse("three-dimensional", "a vertex has more than two coordinates",
                    "drop all but x and y", where);
    }
    set_.vertex(ring, x, y, line);
  }

  TextRing vertices() {
    TextRing ring = set_.ring(tokens_.line());
    list([&] { vertex(ring); });
    return ring;
  }

  void polygon() {
    std::vector<TextRing> rings;
    list([&] {
      rings.push_back(vertices());
      set_.close(rings.back());
    });
    TextRing outer = std::move(rings.front());
    rings.erase(rings.begin());
    set_.polygon(std::move(outer), std::move(rings));
  }

  void point() {
    TextRing ring = set_.ring(tokens_.line());
    tokens_.expect('(');
    vertex(ring);
    tokens_.expect(')');
    set_.point(std::move(ring));
  }

  void segment() { set_.segment(vertices(), "LINESTRING", "points", "POLYGON"); }

  SetBuilder& set_;
  Input& input_;
  WktTokens tokens_;
};

}  // namespace

void read_wkt(std::string_view text, SetBuilder& set) { WktReader(text, set).run(); }

}  // namespace minkref
