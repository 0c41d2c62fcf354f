#include "reference/disc/distance/static_offset.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "reference/build/stage.hpp"
#include "reference/disc/distance/free_part.hpp"
#include "reference/disc/distance/near_edges.hpp"
#include "reference/disc/distance/offset_links.hpp"

namespace minkref::inline disc {
namespace {

/// All patches' free parts, in order.
std::vector<FreePart> all_free_parts(const PatchesAt& at, const BuildOptions& options,
                                     OffsetCounts& counts) {
  const std::size_t count = at.curves().patches.size();
  const NearEdges near(at);
  const BuildControl control(options, "the offset");
  std::vector<std::vector<FreePart>> of_patch(count);
  std::vector<OffsetCounts> of_thread(control.threads());
  in_parallel(count, control, BuildProgress::Stage::patches, [&](unsigned thread) {
    return [&, thread](std::size_t number) {
      const auto k = static_cast<std::uint32_t>(number);
      if (near.is_inside(k)) return;
      std::vector<std::uint32_t> edges;
      near.find(k, edges);
      std::vector<BlockedPart> blocked;
      for (const std::uint32_t edge : edges) {
        for (BlockedPart& part : at.blocked(k, edge, of_thread[thread])) {
          blocked.push_back(std::move(part));
        }
      }
      of_patch[k] = free_parts(at, k, std::move(blocked), of_thread[thread]);
    };
  });
  std::vector<FreePart> parts;
  for (std::vector<FreePart>& some : of_patch) {
    std::move(some.begin(), some.end(), std::back_inserter(parts));
  }
  for (const OffsetCounts& some : of_thread) counts.add(some);
  return parts;
}

}  // namespace

StaticOffset static_offset(const PolygonSet& P, const Rational& squared_radius,
                           const BuildOptions& options) {
  StaticOffset result{
      std::make_shared<const PatchesAt>(offset_curves(P), squared_radius), {}, {}, {}};
  const PatchesAt& at = *result.at;
  const std::vector<FreePart> parts = all_free_parts(at, options, result.counts);
  const std::vector<std::uint32_t> links = offset_links(at, parts);
  std::vector<bool> seen(parts.size(), false);
  for (const FreePart& part : parts) result.pieces.push_back({part.patch, part.from, part.to});
  for (std::uint32_t first = 0; first < parts.size(); ++first) {
    if (seen[first]) continue;
    std::vector<std::uint32_t> ring;
    std::uint32_t k = first;
    for (; !seen[k]; k = links[k]) {
      seen[k] = true;
      ring.push_back(k);
    }
    if (k != first) throw std::logic_error("an offset curve does not close up");
    result.rings.push_back(std::move(ring));
  }
  return result;
}

}  // namespace minkref::inline disc
