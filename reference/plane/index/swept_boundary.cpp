#include "reference/plane/index/swept_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <unordered_map>

#include "reference/build/stage.hpp"
#include "reference/no_entry.hpp"
#include "reference/plane/convolution/convolution_rule.hpp"
#include "reference/plane/index/patch_clipping.hpp"
#include "reference/plane/index/patch_neighbours.hpp"
#include "reference/plane/index/patch_sweep.hpp"
#include "reference/plane/kernel/fraction.hpp"
#include "reference/plane/moving/interior_test.hpp"
#include "reference/plane/moving/right_of_edge.hpp"

namespace minkref::inline plane {
namespace {

constexpr std::size_t worth_pairs_of_pieces = 32;  // so many edges to be done

/// A number with few bits well between two numbers known up to `error`, if doubles tell; else none.
std::optional<double> between(double low, double high, double error) {
  const double room = high - low;
  if (!(room > 64 * error) || !std::isfinite(room)) return std::nullopt;
  const int unit = std::ilogb(room) - 2;
  return std::ldexp(std::nearbyint(std::ldexp(low + room / 2, -unit)), unit);
}

template <class K>
class BoundarySearch {
 public:
  using Edge = MovingEdge<typename K::Vector>;
  using Sweep = PatchSweep<K>;
  using Piece = typename Sweep::Piece;

  BoundarySearch(K kernel, const std::vector<Edge>& edges, const std::vector<RationalEdge>& moving,
                 const PatchNeighbours& neighbours, const InteriorTracks& tracks,
                 const InteriorSolids& solids, const InteriorTest& test, bool may_hide_passages,
                 const ScaleWindow& window, const BuildControl& control, SweptBoundary& result)
      : moving_(moving),
        neighbours_(neighbours),
        test_(test),
        may_hide_passages_(may_hide_passages),
        finder_(std::move(kernel), edges),
        clipping_(moving, tracks, solids),
        sweep_(window.from.value_or(Rational(0)), window.to, control),
        result_(result) {}

  void operator()(std::size_t index) {
    const auto edge = static_cast<std::uint32_t>(index);
    if (neighbours_.cells.of(edge).empty()) return;
    const std::uint32_t first = neighbours_.first[edge];
    finder_.find(edge, neighbours_.others.data() + first, neighbours_.first[edge + 1] - first,
                 nodes_);
    clipping_.clip(edge, neighbours_.cells.of(edge), nodes_);
    sweep_.run(nodes_);
    result_.pieces_in_all += sweep_.pieces().size();
    largest_.clear();
    for (std::uint32_t k = 0; k < sweep_.pieces().size(); ++k) {
      const Piece& piece = sweep_.pieces()[k];
      const std::uint32_t face = sweep_.face(piece);
      if (sweep_.is_shut(face)) continue;
      const auto [place, fresh] = largest_.try_emplace(face, Largest{k, size_of(piece), false});
      if (!fresh && size_of(piece) > place->second.size) {
        place->second = {k, size_of(piece), false};
      }
    }
    for (auto& [face, largest] : largest_) {
      largest.exposed = is_exposed(edge, sweep_.pieces()[largest.piece]);
    }
    result_.faces_tested += largest_.size();
    bool exposed = false;
    for (const Piece& piece : sweep_.pieces()) {
      const auto found = largest_.find(sweep_.face(piece));
      if (found == largest_.end() || !found->second.exposed) continue;
      exposed = true;
      std::optional<Rational> upper;
      if (std::isfinite(piece.to.near)) upper = sweep_.scale(piece.to);
      result_.pieces.push_back({edge, nodes_.nodes[piece.left].name, nodes_.nodes[piece.right].name,
                                sweep_.scale(piece.from), std::move(upper)});
    }
    if (!exposed) return;
    for (const auto& [other, scale] : nodes_.contacts) {
      const Fraction s = fraction(scale);
      result_.contacts.push_back({edge, other, Rational(s.num, s.den)});
    }
  }

 private:
  using Stop = typename Sweep::Stop;
  struct Largest {
    std::uint32_t piece;
    double size;
    bool exposed;
  };

  static double finite(const Stop& to, const Stop& from) {
    return std::isfinite(to.near) ? to.near : 2 * from.near + 1;
  }
  double near(std::uint32_t node, double s) const {
    return nodes_.nodes[node].slope * s + nodes_.nodes[node].value;
  }
  /// Bounds the error of near(): each term, even if the terms nearly cancel, has its relative
  /// error.
  double error(std::uint32_t node, double s) const {
    const double terms =
        std::fabs(nodes_.nodes[node].slope) * s + std::fabs(nodes_.nodes[node].value);
    return terms * 0x1p-46 + 1e-290;
  }
  double size_of(const Piece& piece) const {
    const double to = finite(piece.to, piece.from), s = (piece.from.near + to) / 2;
    return (to - piece.from.near) / to * (near(piece.right, s) - near(piece.left, s));
  }
  Rational along(std::uint32_t node, const Rational& s) const {
    const auto& [slope, value, den] = nodes_.nodes[node].position;
    return (exact(slope) * s + exact(value)) / exact(den);
  }
  static Rational exact(const Rational& value) { return value; }
  template <class W>
  static Rational exact(const W& value) {
    return Rational(grid_integer(value));
  }

  /// Decides by a point within the piece.
  bool is_exposed(std::uint32_t edge, const Piece& piece) const {
    Rational s;
    const double to = finite(piece.to, piece.from);
    if (const auto middle = between(piece.from.near, to, to * 0x1p-46 + 1e-290)) {
      s = from_double(*middle);
    } else {
      s = (sweep_.scale(piece.from) + sweep_.scale(piece.to)) / 2;
    }
    const double near_s = to_double(s);
    Rational t;
    if (const auto middle = between(near(piece.left, near_s), near(piece.right, near_s),
                                    error(piece.left, near_s) + error(piece.right, near_s))) {
      t = from_double(*middle);
    } else {
      t = (along(piece.left, s) + along(piece.right, s)) / 2;
    }
    const RationalEdge& e = moving_[edge];
    const Point x{e.p.x() * s + e.q.x() + e.d.x() * t, e.p.y() * s + e.q.y() + e.d.y() * t};
    if (test_.inside(x, s)) return false;
    return !may_hide_passages_ || !sum_on_the_right(e, x, s, test_);
  }

  const std::vector<RationalEdge>& moving_;
  const PatchNeighbours& neighbours_;
  const InteriorTest& test_;
  const bool may_hide_passages_;
  PatchNodeFinder<K> finder_;
  PatchClipping<K> clipping_;
  Sweep sweep_;
  PatchNodes<K> nodes_;
  std::unordered_map<std::uint32_t, Largest> largest_;
  SweptBoundary& result_;
};

void sort_by_edge(SweptBoundary& result) {
  std::stable_sort(result.pieces.begin(), result.pieces.end(),
                   [](const ExposedPiece& a, const ExposedPiece& b) { return a.edge < b.edge; });
}

/// Takes the pieces and contacts of kept edges, with their new numbers.
void keep(const SweptBoundary& before, const KeptEdges& kept, SweptBoundary& result) {
  std::vector<char> is_kept(kept.after.size(), 0);
  for (std::uint32_t k = 0; k < kept.before.size(); ++k) {
    if (kept.before[k] == no_entry) continue;
    is_kept[kept.before[k]] = 1;
    result.live[k] = before.live[kept.before[k]];
  }
  const auto number = [&](std::uint32_t old) {
    if (kept.after[old] != no_entry) return kept.after[old];
    throw std::logic_error("an edge that is gone met a kept one");
  };
  for (const ExposedPiece& old : before.pieces) {
    if (is_kept[old.edge] == 0) continue;
    ExposedPiece piece = old;
    for (std::uint32_t* edge : {&piece.edge, &piece.from.other, &piece.to.other}) {
      *edge = number(*edge);
    }
    result.pieces.push_back(std::move(piece));
  }
  for (const EndContact& old : before.contacts) {
    if (is_kept[old.edge] == 0) continue;
    result.contacts.push_back({number(old.edge), number(old.other), old.scale});
  }
  result.edges_kept = kept.count;
  sort_by_edge(result);
}

/// Gathers the parts of all threads, sorted by edge.
void gather(std::vector<SweptBoundary>& parts, SweptBoundary& result) {
  for (SweptBoundary& part : parts) {
    result.pieces_in_all += part.pieces_in_all;
    result.faces_tested += part.faces_tested;
    std::move(part.pieces.begin(), part.pieces.end(), std::back_inserter(result.pieces));
    std::move(part.contacts.begin(), part.contacts.end(), std::back_inserter(result.contacts));
  }
  sort_by_edge(result);
}

}  // namespace

SweptBoundary swept_boundary(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                             const BuildOptions& options, const SweptBefore* before) {
  const BuildControl control(options, "the swept boundary");
  refuse_bad_window(window);
  SweptBoundary result;
  result.window = window;
  if (P.empty() || Q.empty()) return result;
  result.edges = reduced_convolution(P, Q);
  const auto as_vectors = [](const PolygonSet& set) {
    return operand<Vector2<Rational>>(set,
                                      [](const Point& p) { return Vector2<Rational>(p.x, p.y); });
  };
  result.moving = moving_edges(result.edges, as_vectors(P), as_vectors(Q));
  control.look_now();
  KeptEdges kept;
  std::vector<Kept> state;
  result.live.assign(result.edges.size(), 0);
  if (before != nullptr) {
    kept = kept_edges(before->operands, {P, Q, result.edges}, result.moving, window);
  }
  if (kept.count > 0) {
    keep(before->boundary, kept, result);
    for (std::size_t k = 0; k < result.edges.size(); ++k) {
      state.push_back(kept.before[k] == no_entry ? Kept::no
                      : result.live[k] != 0      ? Kept::live
                                                 : Kept::inside);
    }
  }
  std::vector<std::uint32_t> fresh;
  for (std::uint32_t k = 0; k < result.edges.size(); ++k) {
    if (state.empty() || state[k] == Kept::no) fresh.push_back(k);
  }
  if (fresh.empty()) return result;
  const InteriorTracks tracks(P, Q);
  control.look_now();
  // Finding pairs of pieces costs more than it saves few edges.
  const bool are_few = kept.count > 0 && fresh.size() < worth_pairs_of_pieces;
  InteriorSolids solids(are_few ? PolygonSet{} : P, are_few ? PolygonSet{} : Q);
  const PatchNeighbours neighbours =
      patch_neighbours(tracks, solids, result.moving, window, control, state);
  result.meeting_pairs = neighbours.meeting;
  result.pairs_inside = neighbours.inside;
  result.pairs_looked_at = neighbours.looked_at;
  for (const std::uint32_t k : fresh) result.live[k] = neighbours.cells.of(k).empty() ? 0 : 1;
  control.look_now();
  const auto [part_of_P, part_of_Q] =
      kept.count == 0 ? std::pair(P, Q) : parts_near(P, Q, result.moving, fresh, window);
  const InteriorTest test(part_of_P, part_of_Q);
  const bool hidden = may_hide_passages(P, Q);
  on_exact_frame(P, Q, [&](const auto& frame) {
    using K = typename std::decay_t<decltype(frame)>::K;
    const auto edges = moving_edges(result.edges, frame.P, frame.Q);
    std::vector<SweptBoundary> parts(control.threads());
    in_parallel(fresh.size(), control, BuildProgress::Stage::patches, [&](unsigned thread) {
      return
          [&fresh, search = std::make_shared<BoundarySearch<K>>(
                       frame.kernel, edges, result.moving, neighbours, tracks, solids, test, hidden,
                       window, control, parts[thread])](std::size_t k) { (*search)(fresh[k]); };
    });
    gather(parts, result);
  });
  return result;
}

}  // namespace minkref::inline plane
