// From the operands to the bytes of an index.
#pragma once

#include <memory>

#include "reference/build/build_options.hpp"
#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/index/index_image.hpp"
#include "reference/plane/index/swept_boundary.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// An index's bytes, and the boundary for updates, without edges.
struct BuiltIndex {
  IndexImage image;
  std::shared_ptr<const SweptBoundary> swept;
};

/// The index of a closed window. Exact; the same bytes for any number of threads, also with a
/// boundary `before` to start from, except for four counts of work. See ScaleIndex.
BuiltIndex built_index(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                       const BuildOptions& options, const SweptBefore* before = nullptr);

}  // namespace minkref::inline plane
