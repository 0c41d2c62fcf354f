#include "certify/plane/sum_proof.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include "certify/plane/covering.hpp"
#include "certify/plane/separation.hpp"
#include "certify/plane/validity.hpp"
#include "certify/plane/vertical_decomposition.hpp"
#include "reference/plane/convolution/convolution.hpp"

namespace minkref::certify {
namespace {

std::vector<std::uint32_t> first_of_rings(const PolygonSet& set) {
  std::vector<std::uint32_t> first{0};
  for (const Polygon& polygon : set.polygons) {
    first.push_back(first.back() + static_cast<std::uint32_t>(polygon.outer.size()));
    for (const Ring& hole : polygon.holes) {
      first.push_back(first.back() + static_cast<std::uint32_t>(hole.size()));
    }
  }
  return first;
}

}  // namespace

/// The lines along edges of the convolution, by vertex numbers.
class ConvolutionLines {
 public:
  ConvolutionLines(const PolygonSet& P, const PolygonSet& Q)
      : first_P_(first_of_rings(P)), first_Q_(first_of_rings(Q)) {
    for (const ConvolutionEdge& edge : reduced_convolution(P, Q)) reduced_.push_back(source(edge));
  }

  const std::vector<LineSource>& reduced() const { return reduced_; }

  LineSource source(const ConvolutionEdge& edge) const {
    const bool s = edge.kind == ConvolutionEdge::Kind::S;
    const auto &ours = s ? first_P_ : first_Q_, &other = s ? first_Q_ : first_P_;
    const std::uint32_t begin = ours[edge.edge.ring], end = ours[edge.edge.ring + 1];
    const std::uint32_t i = begin + edge.edge.index;
    return {s ? LineSource::Kind::P : LineSource::Kind::Q, i, i + 1 < end ? i + 1 : begin,
            other[edge.vertex.ring] + edge.vertex.index};
  }

 private:
  std::vector<std::uint32_t> first_P_, first_Q_;
  std::vector<LineSource> reduced_;
};

namespace {

/// Makes one proof, and keeps its state to answer how far the proof holds.
class Making {
 public:
  Making(const PieceTree& P, const PieceTree& Q, NormalTable& normals,
         const ConvolutionLines& convolution, const Sum& sum, const Rational& scale,
         const std::array<Rational, 4>& box)
      : complex_(P, Q, normals, scale, box), convolution_(convolution), sum_(sum) {
    proof_.scales = {scale};
    proof_.box = box;
    find_lines();
    add_boundary();
    add_passages();
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    Decomposition cells = vertical_decomposition(complex_, edges_, corners_);
    Covering covering(complex_);
    for (Cell& cell : cells.inside) {
      for (CoveredCell& part : covering.cover(std::move(cell))) covered_.push_back(std::move(part));
    }
    outside_ = std::move(cells.outside);
    order_along_lines();
    emit();
  }

  SumProof& proof() { return proof_; }

  void add_moving_vertices() {
    for (const auto& rings : boundary_) {
      auto& polygon = proof_.vertices.emplace_back();
      for (const Cell& ring : rings) {
        auto& vertices = polygon.emplace_back();
        for (const std::uint32_t corner : ring.corners) vertices.push_back(complex_.moving(corner));
      }
    }
    proof_.touching.clear();
    for (const std::uint32_t corner : touching_) {
      proof_.touching.push_back(complex_.moving(corner));
    }
  }

  /// The scales at which the proof holds, within [from, to]; both ends equal `scale` if the proof
  /// holds nowhere else.
  std::pair<Rational, Rational> validity(const Rational& from, const Rational& to) const {
    Validity validity(complex_, from, to);
    for (std::size_t i = 0; i < covered_.size(); ++i) {
      validity.keep_cell(rings_[i]);
      validity.keep_cover(rings_[i], covered_[i].A, covered_[i].B);
    }
    for (std::size_t i = covered_.size(); i < rings_.size(); ++i) {
      validity.keep_cell(rings_[i]);
      validity.keep_code(rings_[i], codes_[i - covered_.size()]);
    }
    return validity.interval();
  }

 private:
  /// Finds each line of the convolution at this scale.
  void find_lines() {
    for (const LineSource& source : convolution_.reduced()) know(source);
    if (!sum_.tight_passages) return;
    for (const TightPassage& passage : *sum_.tight_passages) {
      for (const auto& edges : passage.contacts) {
        for (const ConvolutionEdge& edge : edges) {
          contacts_.push_back(convolution_.source(edge));
          know(contacts_.back());
        }
      }
    }
  }

  void know(const LineSource& source) {
    const bool of_P = source.kind == LineSource::Kind::P;
    const auto& ours = (of_P ? complex_.P() : complex_.Q()).vertices();
    const Point &a = ours[source.a].point, &b = ours[source.b].point;
    const Point& c = (of_P ? complex_.Q() : complex_.P()).vertices()[source.c].point;
    const Rational& s = complex_.scale();
    const Rational nx = a.y - b.y, ny = b.x - a.x;
    const Rational own = nx * a.x + ny * a.y, other = nx * c.x + ny * c.y;
    known_.try_emplace(key(nx, ny, of_P ? Rational(s * own + other) : Rational(own + s * other)),
                       source);
  }

  using Key = std::pair<std::uint32_t, Rational>;
  Key key(const Rational& nx, const Rational& ny, const Rational& offset) {
    const int turned = nx < 0 || (nx == 0 && ny < 0) ? -1 : 1;
    const std::uint32_t normal = complex_.normals().add(turned * nx, turned * ny);
    const Normal& n = complex_.normals()[normal];
    return {normal,
            offset * (nx != 0 ? Rational(Rational(n.x) / nx) : Rational(Rational(n.y) / ny))};
  }

  std::uint32_t line_through(const Point& a, const Point& b) {
    const Rational nx = a.y - b.y, ny = b.x - a.x;
    const auto found = known_.find(key(nx, ny, nx * a.x + ny * a.y));
    if (found == known_.end()) throw std::logic_error("a boundary edge is on no convolution edge");
    return complex_.line(found->second);
  }

  void add_edge(std::uint32_t from, std::uint32_t to, std::uint32_t line, bool inside_left,
                bool inside_right) {
    const Point &a = complex_.corners()[from].place.point, &b = complex_.corners()[to].place.point;
    corners_.push_back(from);
    if (a.x == b.x) return;
    if (a.x < b.x) {
      edges_.push_back({from, to, line, inside_left});
    } else {
      edges_.push_back({to, from, line, inside_right});
    }
  }

  void add_boundary() {
    for (const Polygon& polygon : sum_.region.polygons) {
      auto& rings = boundary_.emplace_back();
      std::vector<const Ring*> all{&polygon.outer};
      for (const Ring& hole : polygon.holes) all.push_back(&hole);
      for (const Ring* ring : all) {
        const std::size_t n = ring->size();
        std::vector<std::uint32_t> lines(n), corners(n);
        for (std::size_t i = 0; i < n; ++i)
          lines[i] = line_through((*ring)[i], (*ring)[(i + 1) % n]);
        for (std::size_t i = 0; i < n; ++i) {
          corners[i] = complex_.meet(lines[(i + n - 1) % n], lines[i]);
        }
        for (std::size_t i = 0; i < n; ++i) {
          add_edge(corners[i], corners[(i + 1) % n], lines[i], true, false);
        }
        rings.push_back({std::move(corners), std::move(lines)});
      }
    }
  }

  void add_passages() {
    if (!sum_.tight_passages) return;
    for (const TightPassage& passage : *sum_.tight_passages) {
      Cell path;
      for (std::size_t i = 0; i + 1 < passage.points.size(); ++i) {
        path.lines.push_back(line_through(passage.points[i], passage.points[i + 1]));
      }
      for (std::size_t i = 0; i < passage.points.size(); ++i) {
        path.corners.push_back(corner_on_passage(passage.points[i], path.lines, i));
      }
      corners_.push_back(path.corners.back());
      for (std::size_t i = 0; i < path.lines.size(); ++i) {
        add_edge(path.corners[i], path.corners[i + 1], path.lines[i], true, true);
      }
      passages_.push_back(std::move(path));
    }
  }

  std::uint32_t corner_on_passage(const Point& point, const std::vector<std::uint32_t>& lines,
                                  std::size_t i) {
    if (const auto known = complex_.corner_at(point)) return *known;
    std::vector<std::uint32_t> through;
    if (i > 0) through.push_back(lines[i - 1]);
    if (i < lines.size()) through.push_back(lines[i]);
    std::vector<LineSource> sources = contacts_;
    sources.insert(sources.end(), convolution_.reduced().begin(), convolution_.reduced().end());
    for (const LineSource& source : sources) {
      if (through.size() > 1 && !complex_.parallel(through[0], through.back())) break;
      const std::uint32_t line = complex_.line(source);
      const MovingLine& l = complex_.lines()[line];
      if (dot(complex_.normals()[l.normal], point) == l.here.exact) through.push_back(line);
    }
    if (through.size() < 2) throw std::logic_error("a passage is on no convolution edge");
    return complex_.meet(through.front(), through.back());
  }

  static std::uint64_t on(std::uint32_t line, std::uint32_t corner) {
    return std::uint64_t{line} << 32 | corner;
  }

  /// The corners of cells along each line, so that cells on both sides have the same.
  void order_along_lines() {
    along_.resize(complex_.lines().size());
    const auto add = [&](const Cell& cell) {
      for (std::size_t i = 0; i < cell.corners.size(); ++i) {
        along_[cell.lines[i]].push_back(cell.corners[i]);
        along_[cell.lines[i]].push_back(cell.corners[(i + 1) % cell.corners.size()]);
      }
    };
    for (const CoveredCell& cell : covered_) add(cell.cell);
    for (const Cell& cell : outside_) add(cell);
    // Passages may end within cell sides.
    for (const Cell& passage : passages_) {
      for (const std::uint32_t corner : passage.corners) {
        along_[complex_.vertical_through(corner)].push_back(corner);
      }
    }
    for (std::uint32_t line = 0; line < along_.size(); ++line) {
      auto& corners = along_[line];
      std::sort(corners.begin(), corners.end());
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
      std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Point &p = complex_.corners()[a].place.point, &q = complex_.corners()[b].place.point;
        return p.x != q.x ? p.x < q.x : p.y < q.y;
      });
      for (std::uint32_t i = 0; i < corners.size(); ++i) position_[on(line, corners[i])] = i;
    }
  }

  /// Corners from one to another along a line, the last one left out.
  void walk(std::uint32_t from, std::uint32_t to, std::uint32_t line,
            std::vector<std::uint32_t>& path) const {
    const std::uint32_t first = position_.at(on(line, from)), last = position_.at(on(line, to));
    for (std::uint32_t i = first; i != last; i += first < last ? 1 : -1) {
      path.push_back(along_[line][i]);
    }
  }
  std::vector<std::uint32_t> ring_of(const Cell& cell) const {
    std::vector<std::uint32_t> ring;
    const std::size_t n = cell.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      walk(cell.corners[i], cell.corners[(i + 1) % n], cell.lines[i], ring);
    }
    return ring;
  }

  std::uint32_t element_of_line(std::uint32_t line) {
    if (line < 4) return line;
    auto& known = line_element_;
    if (const auto found = known.find(line); found != known.end()) return found->second;
    const LineSource source = complex_.lines()[line].source;
    Element element{Element::Kind::up, source.a, source.b, source.c};
    if (source.kind == LineSource::Kind::up) {
      element.a = element_of_corner(source.a);
    } else {
      element.kind = source.kind == LineSource::Kind::P ? Element::Kind::P : Element::Kind::Q;
    }
    proof_.elements.push_back(element);
    return known[line] = static_cast<std::uint32_t>(proof_.elements.size()) + 3;
  }
  std::uint32_t element_of_corner(std::uint32_t corner) {
    auto& known = corner_element_;
    if (const auto found = known.find(corner); found != known.end()) return found->second;
    const Corner& c = complex_.corners()[corner];
    const std::uint32_t a = element_of_line(c.first), b = element_of_line(c.second);
    proof_.elements.push_back({Element::Kind::meet, a, b, 0});
    return known[corner] = static_cast<std::uint32_t>(proof_.elements.size()) + 3;
  }
  std::vector<std::uint32_t> elements_of(const std::vector<std::uint32_t>& corners) {
    std::vector<std::uint32_t> elements;
    for (const std::uint32_t corner : corners) elements.push_back(element_of_corner(corner));
    return elements;
  }

  std::vector<std::int64_t> renumbered(std::vector<std::int64_t> code) {
    for (std::int64_t& entry : code) {
      if (entry < 0) continue;
      const auto [place, fresh] = normal_number_.try_emplace(
          static_cast<std::uint32_t>(entry), static_cast<std::int64_t>(proof_.normals.size()));
      if (fresh) {
        const Normal& n = complex_.normals()[static_cast<std::uint32_t>(entry)];
        proof_.normals.emplace_back(n.x, n.y);
      }
      entry = place->second;
    }
    return code;
  }

  void emit() {
    for (const CoveredCell& part : covered_) {
      rings_.push_back(ring_of(part.cell));
      proof_.cells.push_back(elements_of(rings_.back()));
      proof_.proofs.push_back({true, part.A, part.B, {}});
    }
    for (const Cell& cell : outside_) {
      rings_.push_back(ring_of(cell));
      proof_.cells.push_back(elements_of(rings_.back()));
      codes_.push_back(separating_code(complex_, cell.corners));
      proof_.proofs.push_back({false, 0, 0, renumbered(codes_.back())});
    }
    std::vector<std::uint32_t> passed;  // corners, by the rings
    for (const auto& rings : boundary_) {
      auto& polygon = proof_.polygons.emplace_back();
      for (const Cell& ring : rings) {
        const std::vector<std::uint32_t> corners = ring_of(ring);
        passed.insert(passed.end(), corners.begin(), corners.end());
        polygon.push_back(elements_of(corners));
      }
    }
    std::sort(passed.begin(), passed.end());
    for (std::size_t i = 1; i < passed.size(); ++i) {
      if (passed[i] != passed[i - 1]) continue;
      touching_.push_back(passed[i]);
      proof_.touching.push_back({complex_.corners()[passed[i]].place.point, {}});
    }
    for (const Cell& passage : passages_) {
      std::vector<std::uint32_t> path;
      for (std::size_t i = 0; i < passage.lines.size(); ++i) {
        walk(passage.corners[i], passage.corners[i + 1], passage.lines[i], path);
      }
      path.push_back(passage.corners.back());
      for (std::size_t i = 0; i + 1 < path.size() || i == 0; ++i) {
        const std::vector<std::uint32_t> contact =
            path.size() == 1 ? path : std::vector{path[i], path[i + 1]};
        proof_.contacts.push_back(
            {elements_of(contact), renumbered(separating_code(complex_, contact))});
      }
      proof_.passages.push_back(elements_of(path));
      auto& points = proof_.passage_points.emplace_back();
      for (const std::uint32_t c : path) points.push_back(complex_.corners()[c].place.point);
    }
  }

  CellComplex complex_;
  const ConvolutionLines& convolution_;
  std::vector<LineSource> contacts_;  ///< passages' contacts
  const Sum& sum_;
  std::map<Key, LineSource> known_;
  std::vector<DecomposingEdge> edges_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::vector<Cell>> boundary_;  ///< the sum's rings, by polygon
  std::vector<std::uint32_t> touching_;      ///< corners that the rings pass more than once
  std::vector<Cell> passages_;               ///< open: one line less than corners
  std::vector<CoveredCell> covered_;
  std::vector<Cell> outside_;
  std::vector<std::vector<std::uint32_t>> along_;
  std::unordered_map<std::uint64_t, std::uint32_t> position_;
  std::unordered_map<std::uint32_t, std::uint32_t> line_element_, corner_element_;
  std::unordered_map<std::uint32_t, std::int64_t> normal_number_;
  std::vector<std::vector<std::uint32_t>> rings_;  ///< covered cells' corners, then outer cells'
  std::vector<std::vector<std::int64_t>> codes_;   ///< outer cells' codes, normals as in the table
  SumProof proof_;
};

}  // namespace

Prover::Prover(const PolygonSet& P, const PolygonSet& Q)
    : set_P_(P),
      set_Q_(Q),
      P_(P, normals_),
      Q_(Q, normals_),
      convolution_(std::make_unique<ConvolutionLines>(P, Q)) {
  refuse_bad_operands(P, Q, 1);
}

Prover::~Prover() = default;

std::array<Rational, 4> Prover::box(const Rational& largest) const {
  std::array<Rational, 4> box{0, 0, 0, 0};
  bool first = true;
  for (const Rational& s : {Rational(0), largest}) {
    for (const Place& p : P_.vertices()) {
      for (const Place& q : Q_.vertices()) {
        const Rational x = s * p.point.x + q.point.x, y = s * p.point.y + q.point.y;
        if (first || x < box[0]) box[0] = x;
        if (first || y < box[1]) box[1] = y;
        if (first || x > box[2]) box[2] = x;
        if (first || y > box[3]) box[3] = y;
        first = false;
      }
    }
  }
  const auto floor = [](const Rational& x) {
    const Integer quotient = numerator(x) / denominator(x);  // towards zero
    return x < Rational(quotient) ? Integer(quotient - 1) : quotient;
  };
  for (int i = 0; i < 2; ++i) {
    box[static_cast<std::size_t>(i)] = Rational(floor(box[static_cast<std::size_t>(i)]) - 1);
    box[static_cast<std::size_t>(i + 2)] =
        Rational(floor(box[static_cast<std::size_t>(i + 2)]) + 2);
  }
  return box;
}

SumProof Prover::prove(const Sum& sum, const Rational& scale, const std::array<Rational, 4>& box) {
  return std::move(Making(P_, Q_, normals_, *convolution_, sum, scale, box).proof());
}

std::optional<SumProof> Prover::prove_around(const Sum& sum, const Rational& scale,
                                             const std::array<Rational, 4>& box,
                                             const Rational& from, const Rational& to) {
  Making making(P_, Q_, normals_, *convolution_, sum, scale, box);
  const auto [low, high] = making.validity(from, to);
  if (low == high) return std::nullopt;
  making.proof().scales = {low, high};
  making.add_moving_vertices();
  return std::move(making.proof());
}

}  // namespace minkref::certify
