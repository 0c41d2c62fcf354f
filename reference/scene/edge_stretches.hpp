// The parts of a placed sum's edge that count in the union of all sums.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "reference/no_entry.hpp"
#include "reference/scene/edge_contacts.hpp"

namespace minkref::inline scene {

/// Node 0 is the edge's start, node 1 its end, node k + 2 cut k.
struct EdgeStretches {
  /// A stretch without contacts between its ends: of the union's boundary, or tight.
  struct Piece {
    std::uint32_t from = 0, to = 0;
    bool tight = false;
  };
  std::vector<FilteredPoint> cuts;
  std::vector<Piece> pieces;
  /// Nodes between covered stretches that lie in no open sum. Tight points, unless they end a piece
  /// of some edge.
  std::vector<std::uint32_t> points;

  const FilteredPoint& node(std::uint32_t k, const PlacedSum& sum, std::uint32_t edge) const {
    return k == 0 ? sum.start(edge) : k == 1 ? sum.end(edge) : cuts[k - 2];
  }
};

/// The stretches of each edge of a placed sum; null for an edge without any.
using SumStretches = std::vector<std::shared_ptr<const EdgeStretches>>;

/// The stretches of each placed sum of a scene.
using SceneStretches = std::vector<std::shared_ptr<const SumStretches>>;

using PlacedSums = std::vector<std::shared_ptr<const PlacedSum>>;

/// Finds the stretches of edges, one placed sum after the other. The *open sum* of a placed sum
/// means its interior without tight passages.
class StretchFinder {
 public:
  /// `sums` must outlive it. Without `passages` only stretches of the boundary are found.
  StretchFinder(const PlacedSums& sums, bool passages) : sums_(sums), passages_(passages) {}

  /// `neighbours`, all other sums with boxes that meet the box of sum `own`, must outlive the use.
  void set(std::uint32_t own, std::span<const std::uint32_t> neighbours);

  /// Exact. Linear in the contacts, up to their sorting; edges in the order of their numbers share
  /// work.
  std::shared_ptr<const EdgeStretches> find(std::uint32_t edge);

 private:
  /// What is known of a neighbour along the edge, at a point beside the edge on its right.
  struct State {
    int right = 0, along = 0;
    bool touches_end = false;
    bool meets = false;             ///< the edge's box
    std::uint32_t edge = no_entry;  ///< edge at whose end `right` holds
    std::uint32_t group = 0;        ///< the last group of contacts that it was in
    bool open() const { return right != 0 && along == 0; }
  };
  enum class Kind : std::uint8_t { covered, boundary, tight };

  const PlacedSum& sum(std::uint32_t neighbour) const {
    return neighbour == neighbours_.size() ? *own_ : *sums_[neighbours_[neighbour]];
  }
  std::shared_ptr<const EdgeStretches> find_point(std::uint32_t edge) const;
  bool start(std::uint32_t edge);
  bool start_beside(std::uint32_t neighbour, std::uint32_t edge, EndContacts& ends);
  void count(const State& state, int sign);
  Kind kind() const;
  void sweep(EdgeStretches& result);
  std::size_t pass_group(std::size_t first, bool& hidden_in_one);

  const PlacedSums& sums_;
  bool passages_;
  const PlacedSum* own_ = nullptr;
  std::span<const std::uint32_t> neighbours_;
  std::vector<State> states_;
  std::vector<EdgeContact> contacts_;
  ContactEdge line_;
  bool is_passage_ = false;
  std::uint32_t covers_ = 0, opens_ = 0;  ///< neighbours on the right, with their open sums
  bool start_in_one_ = false;             ///< the edge's start lies in a neighbour's open sum
  std::uint32_t group_ = 0;
  std::uint32_t favourite_ = 0;  ///< the neighbour whose open sum held a whole edge last
};

}  // namespace minkref::inline scene
