// Which free part the boundary of the sum goes on with.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "reference/disc/free_part.hpp"

namespace minkref::inline disc {

class OffsetLinks {
 public:
  /// Of all patches, those of one in order one after the other. Both must outlive it.
  OffsetLinks(const PatchesAt& at, const std::vector<FreePart>& parts);

  /// The part after one, by the names of the curves; where several start at the point, so that both
  /// bound one wedge of the interior. Throws std::logic_error where there is none.
  std::uint32_t next(std::uint32_t k) const;

 private:
  std::uint32_t feature_of(const FreePart& part) const {
    return at_.curves().patches[part.patch].feature;
  }

  const PatchesAt& at_;
  const std::vector<FreePart>& parts_;
  std::vector<std::uint32_t> starts_;  ///< by patch: the part from its start on
  /// By the feature that ends and the one that goes on.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> after_;
};

}  // namespace minkref::inline disc
