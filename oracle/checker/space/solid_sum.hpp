// The sum of two solids at a scaling, plane by plane. docs/certificates-solids.md, "Sums"
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "oracle/checker/space/canonical_form.hpp"
#include "oracle/checker/space/solid_pieces.hpp"

namespace minkref::checker {

/// An object exists only if its trees hold.
class SolidSum {
 public:
  /// Takes the pieces' points times `unit`, which makes them whole.
  SolidSum(const Value& value, const std::array<PieceList, 2>& lists, const mpz_class& unit,
           Budget& budget);
  SolidSum(SolidSum&&) = default;
  SolidSum(const SolidSum&) = delete;

  const Triple& scaling() const { return scaling_; }
  /// Checks a claim and returns its text.
  std::string check_claim(const std::vector<const Value*>& claim) const;

 private:
  /// Components, cavities and tunnels, if claimed; returns the words.
  std::string check_numbers(const std::array<const Value*, 3>& claimed) const;
  using PiecePair = std::pair<std::size_t, std::size_t>;
  struct Reach;  // of sums of two pieces, along a plane's normal

  std::map<OrientedPlane, std::set<Whole>> find_planes() const;
  void add_edges(std::map<OrientedPlane, std::set<Whole>>& planes) const;
  const std::vector<HalfSpace>& bounds(const PiecePair& pair);
  void follow(const OrientedPlane& plane, ConvexPolygon whole, const Value& tree);
  void follow_end(const OrientedPlane& plane, const ConvexPolygon& polygon, const Value& entry,
                  const Reach& reach);
  bool is_free(const ConvexPolygon& polygon, const std::vector<PiecePair>& pairs);

  Triple scaling_;
  mpz_class unit_;
  Budget* budget_;
  std::vector<SolidPieces> operands_;
  std::map<PiecePair, std::vector<HalfSpace>> bounds_;
  Tiles faces_;
};

}  // namespace minkref::checker
