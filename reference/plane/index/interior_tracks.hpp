// Moving points that certainly lie inside the interiors' sum, and need no further look.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/index/signed_distance.hpp"

namespace minkref::inline plane {

/// All points within reach0 + s reach1 of x0 + s x1, as doubles: each coordinate of x0 and x1 has
/// an error of at most `error`.
struct RoundedTrack {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double error = 0, reach0 = 0, reach1 = 0;
};

/// The interiors of sP and x - Q meet if a disc of sP is nearer to x - Q than its radius, or a disc
/// of x - Q nearer to sP. As s grows both the disc and the point move along a line, so a few
/// samples of a signed distance settle a stretch of scales.
class InteriorTracks {
 public:
  /// For regions; for points and segments nothing is certain. O(m + n + samples).
  InteriorTracks(const PolygonSet& P, const PolygonSet& Q);

  /// The discs that settled the last tracks, to be tried first.
  struct Hints {
    std::uint32_t of_P = 0, of_Q = 0;
  };

  /// Positive only if the points certainly lie inside int(sP) ⊕ int(Q) for all scales from `from`
  /// to `to`, 0 < from <= to < infinity: the greatest excess of a tried disc over the required
  /// reach.
  double clearance(const RoundedTrack& track, double from, double to, Hints& hints) const;

  /// Discs by number.
  struct Discs {
    std::vector<std::uint32_t> of_P, of_Q;
  };
  Discs all_discs() const;

  /// As certainly_inside for given discs, tried until one settles the question. Otherwise `hopeful`
  /// receives the discs that may settle a part of these points and scales. Some 20 ns a disc.
  bool some_disc_holds(const RoundedTrack& track, double from, double to, const Discs& discs,
                       Discs& hopeful) const;

  /// True only if the point certainly lies inside int(sP) ⊕ int(Q) for all scales from `from` to
  /// `to`, 0 < from <= to < infinity. By doubles; some 20 ns with a right hint, 1 us without any
  /// success.
  bool certainly_inside(const RoundedTrack& track, double from, double to, Hints& hints) const;

 private:
  /// A tree of discs: each node holds the largest disc below, so that successes come early.
  struct Node {
    Disc disc;
    double reach = 0;                   ///< no disc below sticks out farther from the centre
    std::uint32_t left = 0, right = 0;  ///< 0: none
  };
  class Tree {
   public:
    explicit Tree(std::vector<Disc> discs);
    const std::vector<Node>& nodes() const { return nodes_; }

   private:
    std::uint32_t build(std::vector<Disc>::iterator first, std::vector<Disc>::iterator last);
    std::vector<Node> nodes_;
  };

  /// The track for comparison with disc places: the middle of the scales and half their length, the
  /// points' possible error, the scale of a disc's least radius.
  struct Stretch {
    double middle = 0, half = 0, slack = 0, least = 0;
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    Stretch(const RoundedTrack& track, double from, double to, bool is_seen_from_P);
  };
  struct Reach {
    double away;       ///< of the middle, a signed distance
    double clearance;  ///< over all of the stretch
    double most;       ///< no part of the stretch has more
  };
  static Reach reach_of(const Disc& disc, const Stretch& stretch, const SignedDistance& to_other);

  template <class Clearance>
  static double find(const Tree& tree, std::uint32_t& hint, Clearance clearance);

  bool regions_;
  SignedDistance to_P_, to_Q_;
  Tree of_P_, of_Q_;
};

}  // namespace minkref::inline plane
