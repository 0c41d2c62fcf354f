#include "oracle/sampled/events.hpp"

#include "oracle/sampled/rings.hpp"

namespace minkref::sampled {
namespace {

/// Returns the fraction with the least denominator strictly between a and b, 0 <= a < b; b may be
/// infinite.
template <class Int>
Fraction<Int> simplest_between(const Fraction<Int>& a, const Fraction<Int>& b) {
  const Int whole = a.p / a.q;
  if (Int(whole + 1) * b.q < b.p) return {Int(whole + 1), Int(1)};
  // Both lie in [whole, whole + 1]: invert the fractional parts.
  const Fraction<Int> low{Int(a.p - whole * a.q), a.q}, high{Int(b.p - whole * b.q), b.q};
  if (low.p == 0) {  // 1 / n with the least sufficient n
    const Int n = high.q / high.p + 1;
    return {Int(whole * n + 1), n};
  }
  const Fraction<Int> inverse = simplest_between<Int>({high.q, high.p}, {low.q, low.p});
  return {Int(whole * inverse.p + inverse.q), inverse.p};
}

/// The point ((x.a, y.a) + s (x.b, y.b)) / w, in lowest terms.
template <class Int>
struct Track {
  Linear<Int> x, y;
  Int w;
  auto numbers() const { return std::tie(x.a, x.b, y.a, y.b, w); }
  friend bool operator==(const Track& t, const Track& u) { return t.numbers() == u.numbers(); }
  friend bool operator<(const Track& t, const Track& u) { return t.numbers() < u.numbers(); }
  Point<Int> at(const Fraction<Int>& s) const { return reduced<Int>(x.at(s), y.at(s), w); }
};

template <class Int>
using Cycles = std::vector<std::vector<Point<Int>>>;
template <class Int>
using TrackCycles = std::vector<std::vector<Track<Int>>>;

template <class Int>
class Search {
 public:
  Search(const Question& question, const Moving<Int>& moving)
      : question_(question), moving_(moving), boundaries_(moving) {}

  Answer answer() {
    std::vector<Fraction<Int>> scales = Candidates<Int>(moving_, question_.all_candidates).scales();
    const std::size_t first = first_within(scales), end = end_within(scales);
    answer_.candidates = end - first;
    const Fraction<Int> zero{Int(0), Int(1)}, infinity{Int(1), Int(0)};
    const auto bound = [&](std::size_t k) { return k < scales.size() ? scales[k] : infinity; };
    Between below = between(first == 0 ? zero : scales[first - 1], bound(first));
    answer_.before = below.counts;
    for (std::size_t k = first; k < end; ++k) {
      if (!question_.is_in_time()) throw OutOfTime();
      const State<Int> at = state(scales[k]);
      Between above = between(scales[k], bound(k + 1));
      if (below.tracks != above.tracks || values(below.tracks, scales[k]) != places(at) ||
          distinct(below.tracks) != distinct(places(at))) {
        answer_.events.push_back({to_rational(scales[k]), below.counts, at.counts, above.counts,
                                  below.corners == above.corners});
      } else if (!(below.counts == at.counts && at.counts == above.counts)) {
        throw Fault("the counts change where the boundary does not");
      }
      below = std::move(above);
    }
    return answer_;
  }

 private:
  struct Between {
    TrackCycles<Int> tracks;   ///< with straight vertices where the boundary touches itself
    TrackCycles<Int> corners;  ///< of the canonical form
    Counts counts;
  };

  std::size_t first_within(const std::vector<Fraction<Int>>& scales) const {
    std::size_t k = 0;
    while (k < scales.size() && question_.from && to_rational(scales[k]) < *question_.from) ++k;
    return k;
  }
  std::size_t end_within(const std::vector<Fraction<Int>>& scales) const {
    std::size_t k = scales.size();
    while (k > 0 && question_.to && to_rational(scales[k - 1]) > *question_.to) --k;
    return k;
  }

  State<Int> state(const Fraction<Int>& s, bool* same = nullptr) {
    ++answer_.sums;
    bool ignored = false;
    auto edges = boundaries_.at(s, same != nullptr ? *same : ignored);
    return RingMaker<Int>(moving_.directions, std::move(edges)).state();
  }

  /// Returns the boundary between two neighbouring candidates: the vertices are crossings of their
  /// edges' lines, confirmed at a second scale.
  Between between(const Fraction<Int>& a, const Fraction<Int>& b) {
    const Fraction<Int> s = simplest_between(a, b), second = simplest_between(s, b);
    bool same = false, same_at_second = false;
    const State<Int> here = state(s, &same), there = state(second, &same_at_second);
    Between found{tracks(here, true), tracks(here, false), here.counts};
    if (!same || !same_at_second || values(found.tracks, second) != places(there) ||
        !(here.counts == there.counts)) {
      throw Fault("the boundary changes between two candidates");
    }
    return found;
  }

  Linear<Int> line(const State<Int>& of, int edge) const {
    const auto& e = of.edges[static_cast<std::size_t>(edge)];
    return moving_.segments[static_cast<std::size_t>(e.segment)].offset;
  }
  const Vec<Int>& direction(const State<Int>& of, int edge) const {
    const auto& e = of.edges[static_cast<std::size_t>(edge)];
    return moving_.directions[static_cast<std::size_t>(e.direction)];
  }

  TrackCycles<Int> tracks(const State<Int>& of, bool straight) const {
    TrackCycles<Int> found;
    for (const auto& ring : of.rings) {
      auto& cycle = found.emplace_back();
      for (const RingVertex& v : ring) {
        if (!straight && direction(of, v.in) == direction(of, v.out)) continue;
        const auto& [one, other] = of.lines[static_cast<std::size_t>(v.point)];
        const Vec<Int>&d = direction(of, one), &e = direction(of, other);
        const Linear<Int> f = line(of, one), g = line(of, other);
        Int w = cross(d, e);
        Track<Int> track{{Int(f.a * e.x - g.a * d.x), Int(f.b * e.x - g.b * d.x)},
                         {Int(f.a * e.y - g.a * d.y), Int(f.b * e.y - g.b * d.y)},
                         w};
        Int common = w < 0 ? Int(-w) : w;
        for (const Int* n : {&track.x.a, &track.x.b, &track.y.a, &track.y.b}) {
          common = gcd_of<Int>(common, *n);
        }
        if (w < 0) common = -common;
        for (Int* n : {&track.x.a, &track.x.b, &track.y.a, &track.y.b, &track.w}) *n /= common;
        cycle.push_back(std::move(track));
      }
    }
    return canonical(std::move(found));
  }

  static Cycles<Int> values(const TrackCycles<Int>& tracks, const Fraction<Int>& s) {
    Cycles<Int> found;
    for (const auto& cycle : tracks) {
      auto& ring = found.emplace_back();
      for (const Track<Int>& track : cycle) ring.push_back(track.at(s));
    }
    return canonical(std::move(found));
  }

  template <class T>
  static std::size_t distinct(const std::vector<std::vector<T>>& cycles) {
    std::set<T> all;
    for (const auto& cycle : cycles) all.insert(cycle.begin(), cycle.end());
    return all.size();
  }

  static Cycles<Int> places(const State<Int>& of) {
    Cycles<Int> found;
    for (const auto& cycle : of.rings) {
      auto& ring = found.emplace_back();
      for (const RingVertex& v : cycle)
        ring.push_back(of.points[static_cast<std::size_t>(v.point)]);
    }
    return canonical(std::move(found));
  }

  const Question& question_;
  const Moving<Int>& moving_;
  Boundaries<Int> boundaries_;
  Answer answer_;
};

template <class Int>
Answer events_in(const Question& question, std::size_t bits) {
  const Operand<Int> P = operand_of<Int>(question.P), Q = operand_of<Int>(question.Q);
  if (P.is_empty || Q.is_empty) return {};
  const Moving<Int> moving(P, Q);
  Answer answer = Search<Int>(question, moving).answer();
  answer.bits = bits;
  return answer;
}

}  // namespace

Answer events(const Question& question) {
  try {
    return events_in<Narrow>(question, 64);
  } catch (const TooLarge&) {
  }
  try {
    return events_in<Wide>(question, 128);
  } catch (const TooLarge&) {
  }
  return events_in<mpz_class>(question, 0);
}

}  // namespace minkref::sampled
