// Disjoint sets, joined two at a time.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace minkref::inline disc {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parents_(count), count_(count) {
    std::iota(parents_.begin(), parents_.end(), 0U);
  }

  std::uint32_t root(std::uint32_t k) {
    while (parents_[k] != k) k = parents_[k] = parents_[parents_[k]];
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parents_[a] = b;
    --count_;
  }
  /// The set count.
  std::size_t count() const { return count_; }
  /// The element count over all sets.
  std::size_t size() const { return parents_.size(); }

 private:
  std::vector<std::uint32_t> parents_;
  std::size_t count_;
};

}  // namespace minkref::inline disc
