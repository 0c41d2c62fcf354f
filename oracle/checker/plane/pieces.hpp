// The step `pieces`: convex pieces that tile an operand, and groups of pieces.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <unordered_map>

#include "oracle/checker/budget.hpp"
#include "oracle/checker/reading.hpp"

namespace minkref::checker {

inline mpz_class cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }
inline mpz_class dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }
inline Vector minus(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y}; }

/// Whether edges in these directions turn left, or go straight on, once around altogether.
bool is_convex(const std::vector<Vector>& directions);

/// Directed edges, each counted positively or negatively; tests whether their ends cancel on each
/// line.
class EdgeSum {
 public:
  void add(const Point& from, const Point& to, int times);
  bool is_nothing() const;

 private:
  struct Less {
    bool operator()(const std::vector<mpq_class>& a, const std::vector<mpq_class>& b) const {
      return a < b;
    }
  };
  std::map<std::vector<mpq_class>, long, Less> ends_;
};

/// Normals without repetition, by number.
class Normals {
 public:
  std::uint32_t add(const Vector& normal);
  const Vector& operator[](std::uint32_t n) const { return all_[n]; }

 private:
  std::map<std::pair<mpz_class, mpz_class>, std::uint32_t> known_;
  std::vector<Vector> all_;
};

class Pieces {
 public:
  /// Checks the step. Throws NotVerified.
  Pieces(const Value& of, const Value& pieces, const Value& groups, const Operand& operand,
         Normals& normals, Budget& budget);

  const Operand& operand;
  std::size_t count = 0;  ///< number of pieces
  std::vector<std::vector<Vector>> hulls;
  std::vector<std::vector<std::uint32_t>> children;
  std::vector<bool> solid;

  std::uint32_t last() const { return static_cast<std::uint32_t>(hulls.size() - 1); }
  /// Returns a normal's largest value on a node's hull.
  const mpz_class& most(std::uint32_t node, std::uint32_t normal) const;

 private:
  void check_tiling(const Value& pieces) const;
  void add_group(const std::vector<std::uint32_t>& members);

  Normals& normals_;
  Budget& budget_;
  mutable std::unordered_map<std::uint64_t, mpz_class> most_;
};

/// Follows a code of `sep`, which takes pairs of nodes off a stack: calls `answer` with each pair
/// of nodes of P and Q that an entry answers for, and with this entry. Throws NotVerified.
void follow_code(const Pieces& P, const Pieces& Q, const Value* first, const Value* last,
                 const std::function<void(std::uint32_t, std::uint32_t, const Value&)>& answer);
/// Reads normals: whole numbers, not both 0. Returns the number of each.
std::vector<std::uint32_t> read_normals(const Value& value, Normals& normals);

}  // namespace minkref::checker
