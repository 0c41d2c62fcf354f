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
    reference_system();
    const std::size_t line = tokens_.line();
    std::string word = tokens_.word("a geometry");
    dimensions(word);
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
      if (!empty()) open_line();
    } else if (word == "MULTIPOINT") {
      if (!empty()) list([&] { inner_point(); });
    } else if (word == "MULTILINESTRING") {
      if (!empty())
        list([&] {
          if (!tokens_.take_word("EMPTY")) open_line();
        });
    } else if (word == "GEOMETRYCOLLECTION") {
      collection(depth);
    } else {
      input_.refuse("unsupported-geometry", in_quotes(word) + " is not an operand in the plane",
                    "give a POLYGON, a POINT or a LINESTRING, or several: MULTIPOLYGON", line);
    }
  }

  /// Skips the prefix SRID=...; of extended well-known text.
  void reference_system() {
    const std::size_t line = tokens_.line();
    if (!tokens_.take_word("SRID")) return;
    tokens_.expect('=');
    tokens_.number();
    tokens_.expect(';');
    set_.drop("the reference system (SRID): numbers are coordinates in the plane", line);
  }

  /// Takes Z, M or ZM behind the geometry's name, apart or together: more coordinates than two.
  void dimensions(std::string& word) {
    count_ = 0;
    for (const std::string_view more : {"ZM", "Z", "M"}) {
      const bool glued = word.ends_with(more);
      if (!glued && !tokens_.take_word(more)) continue;
      if (glued) word.resize(word.size() - more.size());
      count_ = 2 + more.size();
      return;
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
    Place where = ring.place_of(ring.points.size());
    where.line = line;
    std::size_t count = 2;
    for (; tokens_.at_number(); ++count) set_.drop_coordinate(tokens_.number(), where);
    // A missing comma makes two vertices one of four coordinates.
    if (count_ == 0) count_ = count;
    if (count != count_ || count > 4) {
      input_.refuse("three-dimensional",
                    "a vertex has " + std::to_string(count) + " coordinates" +
                        (count > 4 ? "" : ", and " + std::to_string(count_) + " are expected"),
                    "give each vertex x and y, and all of them as many more; a comma separates "
                    "two vertices",
                    where);
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

  /// A point of several, with or without parentheses.
  void inner_point() {
    if (tokens_.take_word("EMPTY")) return;
    if (!tokens_.at_number()) return point();
    TextRing ring = set_.ring(tokens_.line());
    vertex(ring);
    set_.point(std::move(ring));
  }

  void open_line() { set_.line(vertices(), "LINESTRING", "points"); }

  SetBuilder& set_;
  Input& input_;
  WktTokens tokens_;
  std::size_t count_ = 0;  ///< coordinates of each vertex of the geometry; 0: not known
};

}  // namespace

void read_wkt(std::string_view text, SetBuilder& set) { WktReader(text, set).run(); }

}  // namespace minkref
