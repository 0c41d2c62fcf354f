#include "reference/space/edges/flat_pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

constexpr std::size_t least_triangles = 3;

/// A face seen from outside, along its normal's longest axis.
class FlatView {
 public:
  FlatView(const SpaceOperand& body, const IntegerVector& normal)
      : body_(body), axis_(longest_axis(normal)), side_(normal[axis_].sign()) {}

  std::size_t across() const { return (axis_ + 1) % 3; }
  std::size_t upwards() const { return (axis_ + 2) % 3; }
  std::size_t axis() const { return axis_; }
  /// 1 where the view goes to the right along the axis `across`, else -1.
  int side() const { return side_; }

  /// 1 where the points turn to the left.
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::size_t i = across(), j = upwards();
    return side_ * filtered_sign(signs_, [&]<class T>(std::type_identity<T>) {
             const auto &p = at<T>(a), &q = at<T>(b), &r = at<T>(c);
             return T((q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]));
           });
  }
  /// Compares by place from left to right; -1, 0 or 1.
  int compare_across(std::uint32_t a, std::uint32_t b) const {
    const int order = at<Integer>(a)[across()].compare(at<Integer>(b)[across()]);
    return side_ * (order > 0 ? 1 : order < 0 ? -1 : 0);
  }
  /// Compares from left to right, ties upwards.
  int compare(std::uint32_t a, std::uint32_t b) const {
    if (const int order = compare_across(a, b); order != 0) return order;
    const int order = at<Integer>(a)[upwards()].compare(at<Integer>(b)[upwards()]);
    return order > 0 ? 1 : order < 0 ? -1 : 0;
  }
  bool is_before(std::uint32_t a, std::uint32_t b) const { return compare(a, b) < 0; }

 private:
  template <class T>
  const std::array<T, 3>& at(std::uint32_t v) const {
    return body_.points[v].as<T>();
  }

  const SpaceOperand& body_;
  std::size_t axis_;
  int side_;
  SignCounts signs_;
};

/// An edge of a face's outline, from its left end to its right end.
struct OutlineEdge {
  std::uint32_t left, right;
  bool inside_above;
  std::uint32_t edge;  ///< of the operand
};

/// A region between two edges and two walls.
struct Trapezoid {
  std::uint32_t below, above;  ///< outline edges
  std::uint32_t from, to;      ///< vertices on the left and on the right wall
};

/// Sweeps from left to right. Corners with one wall follow each other upwards, as if a vanishing
/// angle turned the view; trapezoids between them have no width and are dropped.
class TrapezoidSweep {
 public:
  TrapezoidSweep(FlatView& view, std::vector<OutlineEdge> edges)
      : view_(view),
        edges_(std::move(edges)),
        status_(Below{this}),
        places_(edges_.size(), status_.end()),
        from_(edges_.size(), none) {}

  /// Returns false if edges touch elsewhere than at ends.
  bool run() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> starts, ends;  // vertex, edge
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      starts.emplace_back(edges_[e].left, e);
      ends.emplace_back(edges_[e].right, e);
    }
    const auto before = [&](const auto& a, const auto& b) {
      return view_.is_before(a.first, b.first);
    };
    std::sort(starts.begin(), starts.end(), before);
    std::sort(ends.begin(), ends.end(), before);
    auto start = starts.begin(), end = ends.begin();
    while (start != starts.end() || end != ends.end()) {
      look_for_interrupt();
      const bool starts_first =
          end == ends.end() || (start != starts.end() && before(*start, *end));
      const std::uint32_t at = starts_first ? start->first : end->first;
      const auto take = [&](auto& from, const auto& last) {
        std::vector<std::uint32_t> taken;
        for (; from != last && view_.compare(from->first, at) == 0; ++from) {
          taken.push_back(from->second);
        }
        return taken;
      };
      const std::vector<std::uint32_t> ending = take(end, ends.end());
      const std::vector<std::uint32_t> starting = take(start, starts.end());
      if (!pass(at, ending, starting)) return false;
    }
    return true;
  }

  const OutlineEdge& edge(std::uint32_t number) const { return edges_[number]; }
  std::vector<Trapezoid> found;

 private:
  struct Below {
    TrapezoidSweep* sweep;
    struct Place {
      std::uint32_t vertex;
    };
    using is_transparent = void;

    bool operator()(std::uint32_t a, std::uint32_t b) const {
      if (a == b) return false;
      const OutlineEdge &e = sweep->edges_[a], &f = sweep->edges_[b];
      FlatView& view = sweep->view_;
      if (view.is_before(e.left, f.left)) {
        const int side = view.turn(e.left, e.right, f.left);
        return (side != 0 ? side : view.turn(e.left, e.right, f.right)) > 0;
      }
      const int side = view.turn(f.left, f.right, e.left);
      return (side != 0 ? side : view.turn(f.left, f.right, e.right)) < 0;
    }
    bool operator()(std::uint32_t a, Place p) const { return sweep->height(p.vertex, a) > 0; }
    bool operator()(Place p, std::uint32_t a) const { return sweep->height(p.vertex, a) < 0; }
  };
  using Status = std::set<std::uint32_t, Below>;

  int height(std::uint32_t vertex, std::uint32_t edge) {
    return view_.turn(edges_[edge].left, edges_[edge].right, vertex);
  }

  bool pass(std::uint32_t at, const std::vector<std::uint32_t>& ending,
            const std::vector<std::uint32_t>& starting) {
    const auto ends_here = [&](Status::iterator e) {
      return view_.compare(edges_[*e].right, at) == 0;
    };
    auto first =
        ending.empty() ? status_.lower_bound(typename Below::Place{at}) : places_[ending.front()];
    auto last = first;
    if (ending.empty()) {
      if (first != status_.end() && height(at, *first) == 0) return false;
    } else {
      while (first != status_.begin() && ends_here(std::prev(first))) --first;
      while (last != status_.end() && ends_here(last)) ++last;
      if (static_cast<std::size_t>(std::distance(first, last)) != ending.size()) return false;
    }
    const bool has_lower = first != status_.begin();
    const auto lower = has_lower ? std::prev(first) : status_.end();
    const bool splits = has_lower && edges_[*lower].inside_above;
    if (splits && !close(lower, at)) return false;
    for (auto e = first; e != last; ++e) {
      if (edges_[*e].inside_above && !close(e, at)) return false;
    }
    status_.erase(first, last);
    for (const std::uint32_t e : starting) {
      const auto [place, fresh] = status_.insert(e);
      if (!fresh) return false;
      places_[e] = place;
      from_[e] = at;
    }
    if (splits) from_[*lower] = at;
    return true;
  }

  /// Ends the trapezoid above an edge.
  bool close(Status::iterator below, std::uint32_t at) {
    const auto above = std::next(below);
    if (above == status_.end() || edges_[*above].inside_above) return false;
    const std::uint32_t from = from_[*below];
    if (view_.compare_across(from, at) != 0) found.push_back({*below, *above, from, at});
    return true;
  }

  FlatView& view_;
  std::vector<OutlineEdge> edges_;
  Status status_;
  std::vector<Status::iterator> places_;
  std::vector<std::uint32_t> from_;  ///< where the trapezoid above an edge begins
};

/// Trapezoids as pieces: lines and corners.
class PieceBuild {
 public:
  PieceBuild(const SpaceOperand& body, const FlatView& view, const IntegerVector& normal)
      : body_(body), view_(view) {
    const IntegerVector n = primitive(normal);
    const std::size_t a = view.axis(), j = view.upwards();
    upwards_ = {0, 0, 0};
    upwards_[j] = n[a];
    upwards_[a] = -n[j];
    if (upwards_[j].sign() < 0) upwards_ = IntegerVector{0, 0, 0} - upwards_;
  }

  FlatPiece piece(const OutlineEdge& below, const OutlineEdge& above, std::uint32_t from,
                  std::uint32_t to) const {
    FlatPiece result;
    result.edges = {below.edge, above.edge};
    const auto add = [&](FlatPiece::Corner corner, FlatPiece::Side side) {
      result.corners[result.size] = std::move(corner);
      result.sides[result.size++] = std::move(side);
    };
    const bool left_tip = meet(below.left, above.left, from),
               right_tip = meet(below.right, above.right, to);
    add(on(below, from), along(below, true));
    if (!right_tip) add(on(below, to), wall(to, true));
    add(on(above, to), along(above, false));
    if (!left_tip) add(on(above, from), wall(from, false));
    return result;
  }

 private:
  bool meet(std::uint32_t a, std::uint32_t b, std::uint32_t at) const {
    return view_.compare(a, b) == 0 && view_.compare(a, at) == 0;
  }

  FlatPiece::Side along(const OutlineEdge& e, bool to_the_right) const {
    const std::uint32_t from = to_the_right ? e.left : e.right,
                        to = to_the_right ? e.right : e.left;
    return {body_.points[from],
            FilteredVector(body_.points[to].exact - body_.points[from].exact, body_.shift), e.edge};
  }
  FlatPiece::Side wall(std::uint32_t at, bool up) const {
    return {body_.points[at], FilteredVector(up ? upwards_ : IntegerVector{0, 0, 0} - upwards_, 0),
            none};
  }

  /// An edge's point on the wall through a vertex.
  FlatPiece::Corner on(const OutlineEdge& e, std::uint32_t at) const {
    for (const std::uint32_t end : {e.left, e.right}) {
      if (view_.compare_across(end, at) == 0) return {body_.points[end].exact, 1, end};
    }
    const std::size_t i = view_.across();
    const IntegerVector& start = body_.points[e.left].exact;
    const IntegerVector way = body_.points[e.right].exact - start;
    const Integer reach = body_.points[at].exact[i] - start[i];
    FlatPiece::Corner corner;
    corner.weight = way[i];
    for (std::size_t k = 0; k < 3; ++k) corner.point[k] = start[k] * way[i] + reach * way[k];
    Integer common = corner.weight;
    for (const Integer& c : corner.point) common = gcd(common, c);
    if (corner.weight.sign() < 0) common = -common;
    corner.weight /= common;
    for (Integer& c : corner.point) c /= common;
    return corner;
  }

  const SpaceOperand& body_;
  const FlatView& view_;
  IntegerVector upwards_;
};

/// Joins coplanar triangles across edges.
class FlatFaces {
 public:
  explicit FlatFaces(const SpaceOperand& body) : body_(body), root_(body.triangles.size()) {
    std::iota(root_.begin(), root_.end(), 0U);
    for (const SpaceOperand::Edge& edge : body.edges) {
      look_for_interrupt();
      if (edge.left != none && !edge.convex && is_flat(edge))
        root_[find(edge.left)] = find(edge.right);
    }
  }
  std::uint32_t find(std::uint32_t t) {
    while (root_[t] != t) t = root_[t] = root_[root_[t]];
    return t;
  }

 private:
  bool is_flat(const SpaceOperand::Edge& edge) {
    const SpaceOperand::Triangle &left = body_.triangles[edge.left],
                                 &right = body_.triangles[edge.right];
    std::uint32_t apex = none;
    for (const std::uint32_t v : right.corners) {
      if (v != edge.from && v != edge.to) apex = v;
    }
    const int height = filtered_sign(signs_, [&]<class T>(std::type_identity<T>) {
      return dot(left.normal.as<T>(), body_.points[apex].as<T>() - body_.points[edge.from].as<T>());
    });
    return height == 0 && dot(left.normal.exact, right.normal.exact) > 0;
  }

  const SpaceOperand& body_;
  std::vector<std::uint32_t> root_;
  SignCounts signs_;
};

/// Areas of boxes about parts of a face, as seen: slivers have large boxes.
class BoxAreas {
 public:
  explicit BoxAreas(const FlatView& view) : view_(view) {}

  void add(std::span<const BoundedVector> corners) {
    double area = 1;
    for (const std::size_t axis : {view_.across(), view_.upwards()}) {
      double low = SpaceBox::infinity, high = -SpaceBox::infinity;
      for (const BoundedVector& corner : corners) {
        low = std::min(low, corner[axis].value);
        high = std::max(high, corner[axis].value);
      }
      area *= high - low;
    }
    sum += area;
  }
  double sum = 0;

 private:
  const FlatView& view_;
};

/// Empty where triangles will do.
std::vector<FlatPiece> cut_face(const SpaceOperand& body,
                                const std::vector<std::uint32_t>& triangles,
                                const std::vector<OutlineEdge>& directed, double least_gain) {
  const IntegerVector& normal = body.triangles[triangles.front()].normal.exact;
  FlatView view(body, normal);
  std::vector<OutlineEdge> outline = directed;
  for (OutlineEdge& e : outline) {
    e.inside_above = view.is_before(e.left, e.right);
    if (!e.inside_above) std::swap(e.left, e.right);
  }
  TrapezoidSweep sweep(view, std::move(outline));
  if (!sweep.run()) return {};
  const PieceBuild build(body, view, normal);
  std::vector<FlatPiece> pieces;
  for (const Trapezoid& t : sweep.found) {
    pieces.push_back(build.piece(sweep.edge(t.below), sweep.edge(t.above), t.from, t.to));
  }
  BoxAreas of_triangles(view), of_pieces(view);
  for (const std::uint32_t t : triangles) {
    std::array<BoundedVector, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = body.points[body.triangles[t].corners[k]].rounded;
    of_triangles.add(corners);
  }
  for (const FlatPiece& piece : pieces) {
    std::array<BoundedVector, 4> corners;
    for (std::size_t k = 0; k < piece.size; ++k) {
      corners[k] = rounded_point(piece.corners[k].point, piece.corners[k].weight, body.shift);
    }
    of_pieces.add({corners.data(), piece.size});
  }
  if (!(least_gain * of_pieces.sum < of_triangles.sum)) return {};
  return pieces;
}

}  // namespace

FlatPieces flat_pieces(const SpaceOperand& body, double least_gain) {
  FlatPieces result;
  result.face_of.assign(body.triangles.size(), none);
  FlatFaces faces(body);
  std::vector<std::vector<std::uint32_t>> triangles(body.triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) triangles[faces.find(t)].push_back(t);
  std::vector<std::uint32_t> uses(body.edges.size());
  for (const SpaceOperand::Triangle& triangle : body.triangles) {
    for (const std::uint32_t e : triangle.edges) ++uses[e];
  }
  for (const std::vector<std::uint32_t>& face : triangles) {
    look_for_interrupt();
    if (face.size() < least_triangles) continue;
    std::vector<OutlineEdge> outline;
    bool is_plain = true;  // the two sides of a polygon share diagonals
    for (const std::uint32_t t : face) {
      const SpaceOperand::Triangle& triangle = body.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t e = triangle.edges[k];
        const SpaceOperand::Edge& edge = body.edges[e];
        is_plain = is_plain && uses[e] == 2;
        if (faces.find(edge.left) == faces.find(edge.right)) continue;
        outline.push_back({triangle.corners[k], triangle.corners[(k + 1) % 3], true, e});
      }
    }
    if (!is_plain) continue;
    std::vector<FlatPiece> pieces = cut_face(body, face, outline, least_gain);
    if (pieces.empty()) continue;
    std::set<std::uint32_t> bare;
    for (const OutlineEdge& e : outline) bare.insert(e.edge);
    for (const FlatPiece& piece : pieces) {
      for (const std::uint32_t e : piece.edges) bare.erase(e);
    }
    for (const std::uint32_t t : face) {
      result.face_of[t] = static_cast<std::uint32_t>(result.pieces.size());
    }
    result.pieces.push_back({face.front(), std::move(pieces), {bare.begin(), bare.end()}});
  }
  return result;
}

}  // namespace minkref::inline space
