// The steps `eq` and `move`: the sum at a scale, or between two scales.
#pragma once

#include <array>
#include <functional>
#include <set>

#include "oracle/checker/plane/pieces.hpp"

namespace minkref::checker {

/// x, y; or x0, x1, y0, y1: the point (x0 + s x1, y0 + s y1).
using Vertex = std::vector<mpq_class>;
using Rings = std::vector<std::vector<Vertex>>;  ///< the outer ring, and the holes

/// Starts rings at their least vertex, and sorts holes and polygons.
std::vector<Rings> canonical_order(std::vector<Rings> polygons);
std::string canonical_json(const std::vector<Rings>& polygons);

/// The boundary: its canonical form, and, sorted, the points passed more than once.
struct Form {
  std::vector<Rings> polygons;
  std::vector<Vertex> touching;
  bool operator==(const Form&) const = default;
};

class Region {
 public:
  using Contact = std::vector<std::uint32_t>;

  /// Checks the step. Throws NotVerified.
  Region(const Value& step, const Pieces& P, const Pieces& Q, const mpz_class& unit,
         Normals& normals, Budget& budget);

  const std::vector<mpq_class>& scales() const { return scales_; }
  std::size_t components() const { return components_; }
  std::size_t holes() const { return holes_; }
  const Form& form() const { return form_; }
  const std::vector<Rings>& polygons() const { return form_.polygons; }
  /// The form at a scale between, if the boundary keeps its vertices there.
  Form at(const mpq_class& scale) const;
  Vertex vertex(std::uint32_t point) const;
  std::uint32_t point_number(const Value& value) const;
  bool is_contact(const Contact& contact) const { return contacts_.count(contact) > 0; }
  /// Whether the sum covers all cells around a point, or on both sides of an edge.
  bool is_within(const Contact& contact) const;

  using NodePair = std::pair<std::uint32_t, std::uint32_t>;
  /// The sides between two covered cells, without their ends, and the points around which all cells
  /// are covered; each with the nodes that cover these cells.
  std::map<Contact, std::set<NodePair>> places_between() const;
  /// Reads a pair of solid nodes.
  NodePair solid_pair(const Value& value) const;
  /// Whether the insides of these sums of two solids hold a point, or together a segment without
  /// its ends.
  bool is_in_open_sums(const Contact& place, const std::set<NodePair>& nodes) const;

 private:
  /// A line a x + b y = c, or the point (a / c, b / c), c > 0.
  struct Triple {
    mpz_class a, b, c;
  };
  using Ends = std::vector<Triple>;  ///< for each scale
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  void add_element(const Value& value);
  Triple moving_line(bool of_P, const std::vector<Value>& entry, const mpq_class& s) const;
  const Ends& line(const Value& value) const;
  void check_cell(std::uint32_t cell);
  void check_box() const;
  void check_cover(std::uint32_t cell, const Value* first, const Value* last);
  void check_apart(const std::vector<std::uint32_t>& corners, const Value* first,
                   const Value* last);
  mpz_class most(std::size_t end, std::uint32_t A, std::uint32_t B, std::uint32_t normal) const;
  mpz_class least(std::size_t end, const std::vector<std::uint32_t>& corners, const Vector& normal,
                  int side) const;
  mpq_class room(std::uint32_t point, std::uint32_t A, std::uint32_t B, std::uint32_t normal) const;
  void count();
  void read_polygons(const Value& value);

  const Pieces &P_, &Q_;
  const mpz_class& unit_;
  Normals& normals_;
  Budget& budget_;
  std::vector<mpq_class> scales_;
  std::array<mpq_class, 4> box_;
  std::vector<Ends> elements_;
  std::vector<bool> is_point_;
  std::vector<std::vector<std::uint32_t>> cells_;
  std::map<Edge, std::uint32_t> owner_;
  std::map<Edge, Vector> direction_;
  std::vector<std::uint32_t> own_normals_;
  std::vector<bool> inside_;
  std::map<std::uint32_t, NodePair> covers_;  ///< the nodes of each covered cell
  std::set<Contact> contacts_;
  std::vector<std::uint32_t> root_;
  std::size_t components_ = 0, holes_ = 0;
  Form form_;
};

}  // namespace minkref::checker
