// A subset of the numbers 0 to n - 1, kept in insertion order.
#pragma once

#include <cstdint>
#include <vector>

namespace minkref::inline space {

class IndexSet {
 public:
  explicit IndexSet(std::uint32_t size) : contains_(size) {}

  void insert(std::uint32_t index) {
    if (contains_[index] != 0) return;
    contains_[index] = 1;
    members_.push_back(index);
  }
  bool contains(std::uint32_t index) const { return contains_[index] != 0; }
  const std::vector<std::uint32_t>& members() const { return members_; }
  void clear() {
    for (const std::uint32_t index : members_) contains_[index] = 0;
    members_.clear();
  }

 private:
  std::vector<std::uint8_t> contains_;
  std::vector<std::uint32_t> members_;
};

}  // namespace minkref::inline space
