#include "reference/paper/trials/precision_trial.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "reference/paper/trials/misplaced.hpp"
#include "reference/plane/convolution/convolution_rule.hpp"
#include "reference/plane/critical/pair_interval.hpp"
#include "reference/plane/kernel/arithmetic_name.hpp"
#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/sum.hpp"

namespace minkref {
namespace {

bool less(const Interval& a, const Interval& b) { return approximate(a) < approximate(b); }
template <class T>
bool less(const T& a, const T& b) {
  return a < b;
}

template <class K, class T>
class Trial {
 public:
  Trial(const K& kernel, const Arithmetic<T>& arithmetic, Form form)
      : kernel_(kernel), bits_(precision(arithmetic)), form_(form) {}

  PrecisionTrial run(const std::vector<MovingEdge<typename K::Vector>>& truth,
                     const std::vector<MovingEdge<Vector2<T>>>& edges) {
    for (std::size_t a = 0; a < edges.size(); ++a) {
      for (std::size_t b = a + 1; b < edges.size(); ++b) {
        const auto conditions = pair_conditions(kernel_, truth[a], truth[b]);
        if (conditions.turn == 0) continue;
        ++result_.pairs;
        try {
          pair(conditions, edges[a], edges[b]);
        } catch (const UndecidedSign&) {
          ++result_.undecided_pairs;
        }
      }
    }
    order();
    return result_;
  }

 private:
  struct Matched {
    typename K::Parameter truth;
    T got;
  };

  void pair(const PairConditions<typename K::Wide>& conditions, const MovingEdge<Vector2<T>>& a,
            const MovingEdge<Vector2<T>>& b) {
    const auto truth = intersection_of_half_lines<K>(kernel_, conditions.half_lines);
    BoundedScales<T> got{true, {}, {}};
    EndScales<T> scales;
    const bool parallel = sign(cross<T>(a.d, b.d)) == 0;  // in this arithmetic
    if (!parallel) {
      const auto ends = end_conditions<T>(a, b);
      scales = end_scales<T>(ends, form_);
      got = form_ == Form::printed ? printed_interval<T>(scales) : corrected_interval<T>(ends);
    }
    const bool got_point =
        got.lower && got.upper && !got.empty && sign(T(*got.lower - *got.upper)) == 0;
    // Nothing below throws: a pair is counted as a whole, or as undecided.
    for (std::size_t i = 0; i < 4 && !parallel; ++i) {
      const bool root = kernel_.sign(conditions.half_lines[i].slope) != 0;
      result_.roots += root;
      result_.false_inconsistent += root && scales[i].kind == Solution::inconsistent;
      result_.false_identity += root && scales[i].kind == Solution::identity;
      result_.invented_roots += !root && scales[i].kind == Solution::root;
    }
    compare(truth, got, got_point);
  }

  void compare(const ScaleInterval<K>& truth, const BoundedScales<T>& got, bool got_point) {
    const bool point = truth.is_point(kernel_);
    if (point || got_point) {
      result_.events += point ? 1 : 0;
      if (point && got_point) return match(truth.lower->scale, *got.lower);
      result_.missed += point ? 1 : 0;
      result_.invented += got_point ? 1 : 0;
    }
    const auto bound = [&](const auto& exact, const std::optional<T>& answer) {
      const bool is = !truth.empty && !point && exact.has_value();
      const bool answered = !got.empty && !got_point && answer.has_value();
      result_.events += is;
      if (is && answered) return match(exact->scale, *answer);
      result_.missed += is;
      result_.invented += answered;
    };
    bound(truth.lower, got.lower);
    bound(truth.upper, got.upper);
  }

  void match(const typename K::Parameter& truth, const T& got) {
    result_.misplaced += misplaced(exact_parameter(truth), got, bits_);
    matched_.push_back({truth, got});
  }
  Rational exact_parameter(const typename K::Parameter& t) const {
    if constexpr (std::is_same_v<K, PlainKernel<Rational>>) {
      return t;
    } else {
      return K::exact(t);
    }
  }

  /// Counts inversions by a Fenwick tree over the order of the answers.
  void order() {
    const std::size_t n = matched_.size();
    std::vector<std::uint32_t> by_answer(n);
    std::iota(by_answer.begin(), by_answer.end(), 0U);
    std::sort(matched_.begin(), matched_.end(), [&](const Matched& x, const Matched& y) {
      return kernel_.compare(x.truth, y.truth) < 0;
    });
    std::sort(by_answer.begin(), by_answer.end(), [&](std::uint32_t x, std::uint32_t y) {
      return less(matched_[x].got, matched_[y].got);
    });
    std::vector<std::uint32_t> place(n);  // equal answers have one place
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (i > 0 && less(matched_[by_answer[i - 1]].got, matched_[by_answer[i]].got)) ++last;
      place[by_answer[i]] = last;
    }
    std::vector<std::uint64_t> tree(n + 1, 0);
    std::uint64_t inserted = 0;
    for (std::size_t first = 0; first < n;) {
      std::size_t end = first;
      while (end < n && kernel_.compare(matched_[first].truth, matched_[end].truth) == 0) ++end;
      if (first > 0) {
        std::uint32_t before = 0;
        for (std::size_t i = first; i > 0; --i) {
          if (kernel_.compare(matched_[i - 1].truth, matched_[first - 1].truth) != 0) break;
          before = std::max(before, place[i - 1]);
        }
        const auto least = *std::min_element(place.begin() + static_cast<std::ptrdiff_t>(first),
                                             place.begin() + static_cast<std::ptrdiff_t>(end));
        result_.merged += before == least;
      }
      for (std::size_t i = first; i < end; ++i) {
        std::uint64_t not_after = 0;
        for (std::size_t k = place[i] + 1; k > 0; k -= k & (~k + 1)) not_after += tree[k];
        result_.inversions += inserted - not_after;
      }
      for (std::size_t i = first; i < end; ++i) {
        for (std::size_t k = place[i] + 1; k <= n; k += k & (~k + 1)) ++tree[k];
        ++inserted;
      }
      first = end;
    }
  }

  const K& kernel_;
  long bits_;
  Form form_;
  PrecisionTrial result_;
  std::vector<Matched> matched_;
};

}  // namespace

PrecisionTrial precision_trial(const PolygonSet& P, const PolygonSet& Q,
                               const std::string& arithmetic, Form form) {
  refuse_bad_operands(P, Q, 1);
  if (P.empty() || Q.empty()) return {};
  return on_exact_frame(P, Q, [&](const auto& frame) {
    using K = typename std::decay_t<decltype(frame)>::K;
    const auto edges = convolution_edges(frame.kernel, frame.P, frame.Q, false);
    const auto truth = moving_edges(edges, frame.P, frame.Q);
    return with_arithmetic(arithmetic, [&]<class T>(const Arithmetic<T>& in) {
      const auto moving = moving_edges(edges, scalar_operand<T>(P, in), scalar_operand<T>(Q, in));
      return Trial<K, T>(frame.kernel, in, form).run(truth, moving);
    });
  });
}

}  // namespace minkref
