// Which moving points are certainly in the sum of the interiors: what need not be looked at.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/index/signed_distance.hpp"

namespace minkref::inline plane {

/// All points within reach0 + s reach1 of x0 + s x1, in doubles: each coordinate of x0 and x1 is
/// off by at most `error`.
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

  /// The discs that settled the last tracks are tried first.
  struct Hints {
    std::uint32_t of_P = 0, of_Q = 0;
  };

  /// Positive only if the points are certainly in int(sP) ⊕ int(Q) for all scales from `from` to
  /// `to`, 0 < from <= to < infinity: by how much a disc reaches over what it has to, for the disc
  /// that does so most of those that were tried.
  double clearance(const RoundedTrack& track, double from, double to, Hints& hints) const;

  /// Discs by number.
  struct Discs {
    std::vector<std::uint32_t> of_P, of_Q;
  };
  Discs all_discs() const;

  /// The same of some discs, all of which are tried until one settles it. If none does, `hopeful`
  /// has those that may settle a part of these points and scales. Some 20 ns a disc.
  bool some_disc_holds(const RoundedTrack& track, double from, double to, const Discs& discs,
                       Discs& hopeful) const;

  /// True only if the point is certainly in int(sP) ⊕ int(Q) for all scales from `from` to `to`, 0
  /// < from <= to < infinity. In doubles; some 20 ns where a hint is right, 1 us where nothing is.
  bool certainly_inside(const RoundedTrack& track, double from, double to, Hints& hints) const;

 private:
  /// Discs as a tree: each holds the largest of its own, so that what is found is found early.
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

  /// The track that is compared with the places of discs: the middle of scales and half their
  /// length, by how much points may be off, the scale of a disc's least radius.
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
