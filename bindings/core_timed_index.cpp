// Queries of the index of all scales, timed beside the least work of any query.
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <numeric>

#include "bindings/core.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "reference/plane/index/track_numbers.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// For one scale: seconds of the query, seconds for evaluating the vertices from tracks copied to
/// output order, and the vertex count.
using Row = std::tuple<double, double, std::size_t>;

constexpr int most_passes = 1000;

class TimedQueries {
 public:
  TimedQueries(const ScaleIndex& index, int passes) : index_(index), passes_(passes) {}

  Row rounded(const Rational& scale) {
    index_.rings(scale, tracks_);
    own_.clear();
    for (const std::uint32_t track : tracks_.tracks) {
      own_.push_back(index_.columns().tracks_in_doubles[track]);
    }
    x_.resize(own_.size());
    y_.resize(own_.size());
    const double floor = least([&] {
      const double s = to_double(scale);
      for (std::size_t k = 0; k < own_.size(); ++k) {
        x_[k] = own_[k].x0 + s * own_[k].x1;
        y_[k] = own_[k].y0 + s * own_[k].y1;
      }
    });
    return {least([&] { index_.rings(scale, rounded_); }), floor, own_.size()};
  }

  Row homogeneous(const Rational& scale) {
    const IntegerColumn own = in_order(scale);
    const double floor = least([&] { evaluate(own, scale, floor_); });
    return {least([&] { index_.rings(scale, homogeneous_); }), floor, all_.size()};
  }

  Row rational(const Rational& scale) {
    const IntegerColumn own = in_order(scale);
    RationalRings reduced;
    const double floor = least([&] {
      evaluate(own, scale, floor_);
      reduced_numbers(floor_, reduced);
    });
    return {least([&] { index_.rings(scale, rational_); }), floor, all_.size()};
  }

  Row tracks(const Rational& scale) {
    index_.rings(scale, tracks_);
    const std::vector<std::uint32_t> from = tracks_.tracks;
    std::vector<std::uint32_t> to(from.size());
    const double floor = least([&] { std::copy(from.begin(), from.end(), to.begin()); });
    return {least([&] { index_.rings(scale, tracks_); }), floor, from.size()};
  }

  Row area(const Rational& scale) {
    double sum = 0;
    const double seconds = least([&] { sum += index_.area(scale).value; });
    return {sum == sum ? seconds : 0, 0, 0};
  }

 private:
  template <class Work>
  double least(Work&& work) const {
    double best = 1e300;
    for (int k = 0; k < passes_; ++k) {
      const Stopwatch watch;
      work();
      best = std::min(best, watch.seconds());
    }
    return best;
  }

  /// Copies the tracks to output order.
  IntegerColumn in_order(const Rational& scale) {
    index_.rings(scale, tracks_);
    const IntegerColumn& tracks = index_.columns().tracks;
    const std::size_t words = 5 * std::size_t{tracks.words};
    words_.clear();
    for (const std::uint32_t track : tracks_.tracks) {
      const std::uint64_t* const from = tracks.data.data() + track * words;
      words_.insert(words_.end(), from, from + words);
    }
    all_.resize(tracks_.tracks.size());
    std::iota(all_.begin(), all_.end(), 0U);
    return {tracks.words, words_};
  }
  void evaluate(const IntegerColumn& own, const Rational& scale, HomogeneousRings& to) const {
    homogeneous_numbers(own, index_.counts().track_bits, all_, scale, to);
  }

  const ScaleIndex& index_;
  int passes_;
  TrackRings tracks_;
  RoundedRings rounded_;
  HomogeneousRings homogeneous_, floor_;
  RationalRings rational_;
  std::vector<IndexTrack> own_;
  std::vector<double> x_, y_;
  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> all_;
};

std::map<std::string, std::vector<Row>> timed_queries(const std::string& path,
                                                      const std::vector<std::string>& scales,
                                                      int passes) {
  const ScaleIndex index = ScaleIndex::open(path);
  TimedQueries timed(index, std::clamp(passes, 1, most_passes));
  std::map<std::string, std::vector<Row>> rows;
  for (const std::string& text : scales) {
    const Rational scale = parse_rational(text);
    rows["double"].push_back(timed.rounded(scale));
    rows["homogeneous"].push_back(timed.homogeneous(scale));
    rows["rational"].push_back(timed.rational(scale));
    rows["track"].push_back(timed.tracks(scale));
    rows["area"].push_back(timed.area(scale));
  }
  return rows;
}

}  // namespace

void bind_timed_index(nb::module_& module) {
  module.def("timed_index_queries", &timed_queries, "path"_a, "scales"_a, "passes"_a, Released(),
             "Of an index in a file, by form and scale: least seconds of the query over some "
             "passes, least seconds of evaluating its vertices alone, vertices.");
}

}  // namespace minkref::python
