// All sums sP + Q of a window of scales, built once: any sum can then be read off.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "reference/build/build_options.hpp"
#include "reference/plane/history/topology_timeline.hpp"
#include "reference/plane/index/index_columns.hpp"
#include "reference/plane/index/index_rings.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

struct BuiltIndex;
struct SweptBoundary;

/// Throws BadInput ("outside-window") for a scale that a closed window does not hold.
void refuse_outside(const ScaleWindow& window, const Rational& scale);

/// Immutable, and safe to ask from several threads at once; copies share their bytes.
class ScaleIndex {
 public:
  /// Exact: the boundary of {(x, s) : x in sP + Q} (docs/scale-index.md). A window is closed, and
  /// open towards 0 or infinity without a bound. Operands must have passed `validate`. Throws
  /// BadInput ("bad-window", and as minkowski_sum does), LimitExceeded ("memory-limit").
  ScaleIndex(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
             const BuildOptions& options = {});

  /// One that was saved. Throws BadInput as IndexImage::read does; where a forged file contradicts
  /// itself, questions may too ("damaged-index"). O(bytes).
  static ScaleIndex open(const std::string& path);

  void save(const std::string& path) const { image_.save(path); }
  std::size_t bytes() const { return image_.bytes(); }

  /// The index of changed operands, in the same window: equal to a new one, byte for byte except
  /// for four counts of work (IndexCounts). Patches outside the change keep their pieces
  /// (kept_edges.hpp); pairs, patches and tests of points concern the rest (`reuse`). Putting
  /// together the boundary takes O(n log n) as in a build. Without this index's pieces, so after
  /// `open`, builds everything. Throws as the constructor.
  ScaleIndex updated(const PolygonSet& P, const PolygonSet& Q,
                     const BuildOptions& options = {}) const;
  /// Convolution edges kept from the index before, and done anew; pairs of edges compared by
  /// doubles, faces tested by a point.
  struct Reuse {
    std::uint64_t reused = 0, rebuilt = 0, pairs = 0, faces = 0;
  };
  Reuse reuse() const;

  const ScaleWindow& window() const { return window_; }
  PolygonSet P() const;
  PolygonSet Q() const;
  std::vector<ConvolutionEdge> edges() const;  ///< of the reduced convolution, S-edges first
  const IndexCounts& counts() const { return columns_.counts; }
  const IndexColumns& columns() const { return columns_; }

  /// Scales of boundary events, ascending; a few lie beside the window.
  std::size_t events() const { return columns_.events_in_doubles.size(); }
  Rational event(std::uint32_t k) const;
  /// The window's events: from the first number on, up to before the second.
  std::pair<std::uint32_t, std::uint32_t> events_within() const;
  std::size_t tracks() const { return columns_.tracks_in_doubles.size(); }
  Track track(std::uint32_t k) const;

  /// The place of a scale within the window: the interval around the scale, or the interval below
  /// the event at the scale. Interval k lies between events k - 1 and k. Throws BadInput
  /// ("outside-window"). O(log e) for e events, mostly by doubles.
  struct Place {
    std::uint32_t interval = 0;
    bool at_event = false;
  };
  Place place(const Rational& scale) const;

  /// The boundary. Throws as `place`. O(b) for a boundary of b edges: nanoseconds a vertex for
  /// doubles and for integers of up to 128 bits, some 0.3 us for lowest terms. At the few events
  /// with touching or folding rings O(b) milliseconds.
  void rings(const Rational& scale, TrackRings& rings) const;
  void rings(const Rational& scale, RoundedRings& rings) const;
  void rings(const Rational& scale, HomogeneousRings& rings) const;
  void rings(const Rational& scale, RationalRings& rings) const;

  /// The rings of an interval rather than a scale. O(b).
  void rings_of_interval(std::uint32_t interval, TrackRings& rings) const;

  /// The sum in canonical form. Exact. O(b log b). Tight passages, if asked for, come from the
  /// static route (tight_passages.hpp).
  Sum sum(const Rational& scale, Passages passages = Passages::leave) const;

  /// Without the boundary. O(log e).
  struct Features {
    std::uint32_t components = 0, holes = 0;
  };
  Features features(const Rational& scale) const;

  /// The area within `error` of the truth. O(log e).
  struct RoundedArea {
    double value = 0, error = 0;
  };
  RoundedArea area(const Rational& scale) const;

  /// a0 + a1 s + a2 s^2 during an interval. Exact; denominators multiply. O(b log b)
  /// multiplications of numbers that grow to the result's length.
  std::array<Rational, 3> area_polynomial(std::uint32_t interval) const;

  /// Boundary and topology events, life spans. Groups are events.
  TopologyTimeline timeline() const;

 private:
  explicit ScaleIndex(IndexImage image, std::shared_ptr<const SweptBoundary> swept = nullptr);
  explicit ScaleIndex(BuiltIndex built);

  /// A contradiction of an opened index means a fault of the file.
  void collect(const Place& at, TrackRings& rings) const;
  void collect_from_bucket(const Place& at, TrackRings& rings) const;
  void collect_touching(std::uint32_t event, TrackRings& rings) const;
  /// Rings and features of an interval into the shape; take(entry, k) for each corner k.
  template <class Take>
  std::size_t each_ring(std::uint32_t interval, RingShape& shape, Take&& take) const;
  void require_interval(std::uint32_t interval) const;
  void drop_what_vanishes(std::uint32_t event, TrackRings& rings) const;
  std::uint32_t standing_for(std::uint32_t event, std::uint32_t track) const;
  Vector2<Rational> direction(const IndexEdge& edge) const;
  bool is_plain(const Place& at) const;

  IndexImage image_;
  IndexColumns columns_;
  ScaleWindow window_;
  double largest_ = 0;                          ///< of the tracks' coefficients
  std::shared_ptr<const SweptBoundary> swept_;  ///< none of an opened index
};

}  // namespace minkref::inline plane
