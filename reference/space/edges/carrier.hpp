// A carrier cut into pieces: a side of facets, or the crossing of two facets, with everything along
// it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/space/edges/interior_cells.hpp"
#include "reference/space/edges/line.hpp"

namespace minkref::inline space {

/// A cut of a line. A side's ends have parameters 0 and 1 and no plane.
struct Cut {
  CutterPlane plane;
  int end = 0;  ///< of a side: the parameter there
  BoundedDouble t;
};

/// A facet along a piece lies on one side of the line or, if the line runs inside the facet, on
/// both. A half-plane of a facet with the normal n lies on the side of direction x n (`ahead`), or
/// on the other side, for the line's direction.
struct AlongFacet {
  std::uint32_t facet;
  bool ahead, behind;
};

/// An open segment of a line, between two consecutive cuts, along which nothing changes.
struct CarrierPiece {
  Cut from, to;
  std::vector<AlongFacet> facets;  ///< that contain it, ascending
};

/// Cuts carrier after carrier; each cut discards the previous carrier's pieces.
class CarrierCutting {
 public:
  /// `near` lists, for each facet, the facets that may touch it, ascending.
  CarrierCutting(const Convolution& convolution,
                 const std::vector<std::vector<std::uint32_t>>& near, const InteriorCells& cells)
      : convolution_(convolution), facets_(convolution.facets), near_(near), cells_(cells) {}

  /// The pieces of a side, except pieces that belong to a lesser side or lie below a facet next to
  /// an end. Empty if cells cover the side. Exact.
  const std::vector<CarrierPiece>& cut_side(std::uint32_t side);
  /// The same for the crossing of two facets: pieces that lie along no side and belong to no lesser
  /// pair. Facets that are parallel, or do not cross, have none.
  const std::vector<CarrierPiece>& cut_crossing(std::uint32_t a, std::uint32_t b);

  /// The line of the carrier last cut.
  const CarrierLine& line() const { return *line_; }

  SignCounts signs;

 private:
  static constexpr std::uint32_t start = UINT32_MAX - 1, end = UINT32_MAX;
  struct MarkedCut {
    Cut cut;
    bool covers_before = false, covers_after = false;  ///< what is next to it is in the sum
    std::uint32_t position = 0;
  };
  struct Cover {
    AlongFacet along;
    std::uint32_t from, to;  ///< of cuts_, or start, end
  };

  void begin(CarrierLine line);
  bool is_covered() const;
  bool lies_in_one_plane(const FacetSide& side, const std::vector<std::uint32_t>& candidates);
  bool clip(const ConvolutionFacet& facet, Cut& from, Cut& to, int& border);
  bool spans_crossing(std::uint32_t a, std::uint32_t b);
  bool ends_at_border(const ConvolutionFacet& facet) const;
  void add_transversal(std::uint32_t facet, int slope);
  void add_flat(std::uint32_t facet);
  void look_at(std::uint32_t facet);
  int within(const ConvolutionFacet& facet, int slope);
  int compare(const Cut& a, const Cut& b);
  static std::uint32_t side_of(const Cut& cut);
  Cut cut_at(const ConvolutionFacet& facet, int side);
  AlongFacet along_border(std::uint32_t facet, std::size_t side);
  void make_pieces();
  void sort_cuts();

  const Convolution& convolution_;
  const std::vector<ConvolutionFacet>& facets_;
  const std::vector<std::vector<std::uint32_t>>& near_;
  std::optional<CarrierLine> line_;
  const FacetSide* whole_side_ = nullptr;  ///< null for a crossing
  Cut from_, to_;                          ///< the ends of the carrier
  bool start_covered_ = false, end_covered_ = false;
  std::vector<MarkedCut> cuts_;
  std::vector<Cover> covers_;
  std::vector<CarrierPiece> pieces_;
  const InteriorCells& cells_;
};

}  // namespace minkref::inline space
