// The patch that a convolution edge sweeps, cut by its nodes: its faces, from scale to scale.
#pragma once

#include <algorithm>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <vector>

#include "reference/build/build_control.hpp"
#include "reference/plane/index/patch_nodes.hpp"
#include "reference/plane/kernel/fraction.hpp"

namespace minkref::inline plane {

/// Pieces of the patch between two nodes and two scales; a face consists of pieces connected
/// without crossing a node. In (s, position along the edge) nodes form segments, and this class
/// sweeps their arrangement (Bentley & Ottmann 1979). Exact: doubles decide if they can tell.
template <class K>
class PatchSweep {
 public:
  struct Stop {
    enum class Kind : std::uint8_t { window_start, window_end, birth, death, crossing, overlap };
    double near = 0;  ///< with a relative error of at most 2^-48
    Kind kind = Kind::window_start;
    std::uint32_t x = 0, y = 0;  ///< nodes; of an overlap its index
  };
  struct Piece {
    std::uint32_t left = 0, right = 0;  ///< nodes
    Stop from, to;
    std::uint32_t face = 0;
  };

  /// An open window; no end: infinity. `control` must outlive it.
  PatchSweep(Rational from, std::optional<Rational> to, const BuildControl& control)
      : control_(control), window_from_(std::move(from)), window_to_(std::move(to)) {}

  PatchSweep(const PatchSweep&) = delete;
  PatchSweep& operator=(const PatchSweep&) = delete;

  void run(const PatchNodes<K>& nodes) {
    nodes_ = &nodes.nodes;
    overlaps_ = &nodes.overlaps;
    pieces_.clear();
    parent_.clear();
    shut_.clear();
    begin();
    while (!events_.empty() && (!window_to_ || compare(events_.top(), last_stop()) < 0)) {
      control_.look();
      step();
      if (!events_.empty() && compare(events_.top(), now_) <= 0) {
        throw std::logic_error("the sweep of a patch stands still");
      }
    }
    events_ = {};
    for (std::size_t g = 0; g < gaps_.size(); ++g) close(g, last_stop());
  }

  const std::vector<Piece>& pieces() const { return pieces_; }
  /// The number of a piece's face: the same for all pieces of a face.
  std::uint32_t face(const Piece& piece) { return root(piece.face); }
  /// Whether some node proves the face inside the sum.
  bool is_shut(std::uint32_t face) { return shut_[root(face)]; }

  /// Exact.
  Rational scale(const Stop& stop) const {
    const Fraction value = fraction_of(stop);
    return Rational(value.num, value.den);
  }

 private:
  using W = typename K::Wide;
  using Node = PatchNode<K>;
  using Kind = typename Stop::Kind;
  static constexpr double doubt = 0x1p-45;  // relative; more than all rounding
  static constexpr std::uint32_t start = 0, end = 1;

  struct Gap {
    std::uint32_t face = 0;
    Stop from;
    std::uint64_t step = 0;  ///< that opened the gap
    bool flat = false;       ///< both nodes are one track
  };
  struct Later {
    const PatchSweep* sweep;
    bool operator()(const Stop& a, const Stop& b) const { return sweep->compare(a, b) > 0; }
  };

  const Node& node(std::uint32_t k) const { return (*nodes_)[k]; }
  Stop first_stop() const { return {to_double(window_from_), Kind::window_start, 0, 0}; }
  Stop last_stop() const {
    return {window_to_ ? to_double(*window_to_) : std::numeric_limits<double>::infinity(),
            Kind::window_end, 0, 0};
  }

  Fraction fraction_of(const Stop& m) const {
    switch (m.kind) {
      case Kind::window_start:
        return fraction(window_from_);
      case Kind::window_end:
        return fraction(*window_to_);
      case Kind::birth:
        return fraction(*node(m.x).from);
      case Kind::death:
        return fraction(*node(m.x).to);
      case Kind::overlap:
        return fraction((*overlaps_)[m.x]);
      case Kind::crossing:
        break;
    }
    const auto difference = position_difference<K>(node(m.x).position, node(m.y).position);
    return fraction(decltype(difference.value)(-difference.value), difference.slope);
  }

  int compare(const Stop& a, const Stop& b) const {
    const double bound = doubt * (std::fabs(a.near) + std::fabs(b.near));
    if (a.near - b.near > bound) return 1;
    if (b.near - a.near > bound) return -1;
    if (a.kind == b.kind && a.x == b.x && a.y == b.y) return 0;
    const Fraction u = fraction_of(a), v = fraction_of(b);
    return sign(Integer(u.num * v.den - v.num * u.den));
  }

  /// The sign of x less y, at the sweep's current scale.
  int compare_here(std::uint32_t x, std::uint32_t y) {
    const Node &a = node(x), &b = node(y);
    const double s = now_.near, u = a.slope * s, v = b.slope * s;
    const double difference = (u + a.value) - (v + b.value);
    const double bound =
        doubt * (std::fabs(u) + std::fabs(a.value) + std::fabs(v) + std::fabs(b.value)) + 1e-300;
    if (difference > bound) return 1;
    if (difference < -bound) return -1;
    if (!exact_now_) exact_now_ = fraction_of(now_);
    const auto exact = position_difference<K>(a.position, b.position);
    return sign_at(exact.slope, exact.value, *exact_now_);
  }

  /// The order just above the scale, for nodes that coincide at the scale.
  bool before_afterwards(std::uint32_t x, std::uint32_t y) const {
    if (x == y) return false;
    if (x == start || y == end) return true;
    if (y == start || x == end) return false;
    const int by_slope = compare_slopes(x, y);
    return by_slope != 0 ? by_slope < 0 : x < y;
  }
  int compare_slopes(std::uint32_t x, std::uint32_t y) const {
    const double u = node(x).slope, v = node(y).slope;
    const double bound = doubt * (std::fabs(u) + std::fabs(v)) + 1e-300;
    if (u - v > bound) return 1;
    if (v - u > bound) return -1;
    return wide_sign(position_difference<K>(node(x).position, node(y).position).slope);
  }
  bool is_one_track(std::uint32_t x, std::uint32_t y) const {
    if (compare_slopes(x, y) != 0) return false;
    const auto difference = position_difference<K>(node(x).position, node(y).position);
    return wide_sign(difference.slope) == 0 && wide_sign(difference.value) == 0;
  }

  std::uint32_t root(std::uint32_t face) {
    while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
    return face;
  }
  std::uint32_t new_face() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    shut_.push_back(false);
    return parent_.back();
  }
  std::uint32_t united(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[b] = a;
    shut_[a] = shut_[a] || shut_[b];
    return a;
  }

  /// Opens a gap between the nodes at its place and the next.
  Gap opened(std::uint32_t left, std::uint32_t right, std::uint32_t face) {
    if (!node(left).open_after || !node(right).open_before) shut_[root(face)] = true;
    return {face, now_, steps_, is_one_track(left, right)};
  }
  void close(std::size_t gap, const Stop& at) {
    const Gap& g = gaps_[gap];
    if (g.flat || (g.step == steps_ && at.kind != Kind::window_end)) return;
    pieces_.push_back({order_[gap], order_[gap + 1], g.from, at, g.face});
  }

  void begin() {
    events_ = Queue(Later{this});
    set_now(first_stop());
    order_.clear();
    for (std::uint32_t k = 0; k < nodes_->size(); ++k) {
      const Node& n = node(k);
      if (n.to) {
        const Stop death{K::approximation(*n.to), Kind::death, k, 0};
        if (compare(death, now_) <= 0) continue;
        events_.push(death);
      }
      if (n.from) {
        const Stop birth{K::approximation(*n.from), Kind::birth, k, 0};
        if (compare(birth, now_) > 0) {
          events_.push(birth);
          continue;
        }
      }
      order_.push_back(k);
    }
    for (std::uint32_t k = 0; k < overlaps_->size(); ++k) {
      const Stop overlap{K::approximation((*overlaps_)[k]), Kind::overlap, k, 0};
      if (compare(overlap, now_) > 0) events_.push(overlap);
    }
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t x, std::uint32_t y) {
      const int order = compare_here(x, y);
      return order != 0 ? order < 0 : before_afterwards(x, y);
    });
    gaps_.clear();
    for (std::size_t k = 0; k + 1 < order_.size(); ++k) {
      gaps_.push_back(opened(order_[k], order_[k + 1], new_face()));
    }
    for (std::size_t k = 0; k + 1 < order_.size(); ++k) foresee(k);
  }

  void set_now(const Stop& stop) {
    now_ = stop;
    exact_now_.reset();
  }

  /// All that happens at the next scale.
  void step() {
    set_now(events_.top());
    born_.clear();
    touched_.clear();
    dying_.clear();
    bool overlapped = false;
    while (!events_.empty() && compare(events_.top(), now_) == 0) {
      const Stop m = events_.top();
      events_.pop();
      switch (m.kind) {
        case Kind::birth:
          born_.push_back(m.x);
          break;
        case Kind::death:
          dying_.push_back(m.x);
          touched_.push_back(m.x);
          break;
        case Kind::crossing:
          touched_.push_back(m.x);
          touched_.push_back(m.y);
          break;
        default:
          overlapped = true;
      }
    }
    ++steps_;
    if (overlapped) cut_everywhere();  // nothing below is connected with anything above
    mend();
    if (overlapped) cut_everywhere();
  }

  /// A run [first, last) of coincident nodes, with the nodes born there.
  struct Run {
    std::size_t first = 0, last = 0;
    std::vector<std::uint32_t> born;
  };

  void mend() {
    runs_.clear();
    for (const std::uint32_t x : touched_) {
      const auto found = std::find(order_.begin(), order_.end(), x);
      if (found != order_.end()) add_run(static_cast<std::size_t>(found - order_.begin()));
    }
    for (const std::uint32_t x : born_) {
      const auto place = static_cast<std::size_t>(
          std::partition_point(order_.begin(), order_.end(),
                               [&](std::uint32_t y) { return compare_here(y, x) < 0; }) -
          order_.begin());
      Run* run = nullptr;
      if (place < order_.size() && compare_here(order_[place], x) == 0) {
        run = add_run(place);
      } else {
        for (Run& other : runs_) {
          if (other.first == place && other.last == place &&
              compare_here(other.born.front(), x) == 0) {
            run = &other;
          }
        }
        if (run == nullptr) run = &runs_.emplace_back(Run{place, place, {}});
      }
      run->born.push_back(x);
    }
    // Works from right to left: runs on the left keep their places. Places order the runs born
    // within one gap.
    std::sort(runs_.begin(), runs_.end(), [&](const Run& a, const Run& b) {
      if (a.first != b.first) return a.first > b.first;
      if (a.last != b.last) return a.last > b.last;
      return a.last == a.first && compare_here(a.born.front(), b.born.front()) > 0;
    });
    for (Run& run : runs_) replace(run);
  }

  Run* add_run(std::size_t at) {
    for (Run& run : runs_) {
      if (run.first <= at && at < run.last) return &run;
    }
    Run run{at, at + 1, {}};
    while (run.first > 0 && compare_here(order_[run.first - 1], order_[at]) == 0) --run.first;
    while (run.last < order_.size() && compare_here(order_[run.last], order_[at]) == 0) ++run.last;
    return &runs_.emplace_back(std::move(run));
  }

  void replace(Run& run) {
    const auto at = [](std::size_t k) { return static_cast<std::ptrdiff_t>(k); };
    std::vector<std::uint32_t> next = std::move(run.born);
    for (std::size_t k = run.first; k < run.last; ++k) {
      if (std::find(dying_.begin(), dying_.end(), order_[k]) == dying_.end()) {
        next.push_back(order_[k]);
      }
    }
    std::sort(next.begin(), next.end(),
              [&](std::uint32_t x, std::uint32_t y) { return before_afterwards(x, y); });
    // The edge's ends have one neighbour only.
    const bool has_left = run.first > 0, has_right = run.last < order_.size();
    const bool was_empty = run.first == run.last;
    if (was_empty && next.empty()) return;
    const std::size_t left_gap = run.first - 1, right_gap = was_empty ? left_gap : run.last - 1;
    if (!was_empty) {
      for (std::size_t g = run.first; g + 1 < run.last; ++g) close(g, now_);
    }
    const bool left_stays =
        has_left && !was_empty && !next.empty() && next.front() == order_[run.first];
    const bool right_stays =
        has_right && !was_empty && !next.empty() && next.back() == order_[run.last - 1];
    if (has_left && !left_stays) close(left_gap, now_);
    if (has_right && !right_stays && !(was_empty && has_left)) close(right_gap, now_);
    const Gap left_before = has_left ? gaps_[left_gap] : Gap{},
              right_before = has_right ? gaps_[right_gap] : Gap{};
    // Makes new gaps, from the gap before the run to the gap behind it.
    std::vector<Gap> gaps;
    if (next.empty()) {
      if (has_left && has_right) {
        gaps.push_back(opened(order_[run.first - 1], order_[run.last],
                              united(left_before.face, right_before.face)));
      }
    } else {
      if (has_left) {
        gaps.push_back(left_stays ? left_before
                                  : opened(order_[run.first - 1], next.front(), left_before.face));
      }
      for (std::size_t k = 0; k + 1 < next.size(); ++k) {
        gaps.push_back(opened(next[k], next[k + 1], new_face()));
      }
      if (has_right) {
        gaps.push_back(right_stays ? right_before
                                   : opened(next.back(), order_[run.last], right_before.face));
      }
    }
    const std::size_t first_gap = has_left ? left_gap : 0,
                      end_gap = has_right ? right_gap + 1 : gaps_.size();
    gaps_.erase(gaps_.begin() + at(first_gap), gaps_.begin() + at(end_gap));
    gaps_.insert(gaps_.begin() + at(first_gap), gaps.begin(), gaps.end());
    order_.erase(order_.begin() + at(run.first), order_.begin() + at(run.last));
    order_.insert(order_.begin() + at(run.first), next.begin(), next.end());
    const std::size_t last = std::min(first_gap + gaps.size(), gaps_.size());
    for (std::size_t g = first_gap; g < last; ++g) foresee(g);
  }

  /// Whatever a parallel edge covers at the scale; more cuts than need be do no harm.
  void cut_everywhere() {
    for (std::size_t g = 0; g < gaps_.size(); ++g) {
      close(g, now_);
      gaps_[g] = opened(order_[g], order_[g + 1], new_face());
    }
  }

  /// Finds the scale at which the nodes on either side of a gap meet.
  void foresee(std::size_t gap) {
    const std::uint32_t x = order_[gap], y = order_[gap + 1];
    const Node &a = node(x), &b = node(y);
    const double closing = a.slope - b.slope,
                 error = doubt * (std::fabs(a.slope) + std::fabs(b.slope)) + 1e-300;
    if (closing < -error) return;
    double limit = last_stop().near;
    if (a.to) limit = std::min(limit, K::approximation(*a.to));
    if (b.to) limit = std::min(limit, K::approximation(*b.to));
    const double apart = b.value - a.value - doubt * (std::fabs(a.value) + std::fabs(b.value));
    if (apart > (closing + error) * limit * (1 + doubt)) return;
    const auto difference = position_difference<K>(a.position, b.position);
    if (wide_sign(difference.slope) <= 0) return;
    using Product = WideProduct<K>;
    const double near = wide_quotient(Product(-difference.value), difference.slope);
    if (near < now_.near * (1 - doubt) || near > limit * (1 + doubt)) return;
    events_.push({near, Kind::crossing, x, y});
  }

  using Queue = std::priority_queue<Stop, std::vector<Stop>, Later>;

  const BuildControl& control_;
  Rational window_from_;
  std::optional<Rational> window_to_;
  const std::vector<Node>* nodes_ = nullptr;
  const std::vector<typename K::Parameter>* overlaps_ = nullptr;
  Stop now_;
  std::optional<Fraction> exact_now_;
  Queue events_{Later{this}};
  std::uint64_t steps_ = 0;
  std::vector<std::uint32_t> order_;  // nodes along the edge
  std::vector<Gap> gaps_;             // gap k is between nodes k and k + 1 of the order
  std::vector<std::uint32_t> born_, touched_, dying_;
  std::vector<Run> runs_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> parent_;
  std::vector<bool> shut_;
};

}  // namespace minkref::inline plane
