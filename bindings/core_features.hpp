// Features of a growing disc for Python.
#pragma once

#include <nanobind/nanobind.h>

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reference/disc/features/barcode.hpp"
#include "reference/disc/features/near_bridges.hpp"
#include "reference/disc/features/tracks.hpp"

namespace minkref::python {

struct BoundFeatures {
  explicit BoundFeatures(DiagramEvents diagram)
      : index(std::move(diagram)),
        tree(merge_tree(index)),
        bridges(index),
        codes(barcode(bridges, tree)),
        tracks(bridge_tracks(index)),
        near(index, tree, codes) {}

  /// For radius numbers between 0 and infinity.
  RootNumber squared(std::uint32_t number) const {
    const DiagramEvents& diagram = index.diagram();
    if (number == 0 || number > index.radii()) throw std::out_of_range("no radius of events");
    return diagram.exact(diagram.events.at(index.event_at(number - 1))).squared_radius;
  }

  DiscIndex index;
  MergeTree tree;
  Bridges bridges;
  Barcode codes;
  std::vector<BridgeTrack> tracks;
  NearBridges near;
  double seconds = 0;
};

void bind_features(nanobind::module_& module);
/// The regions at one radius.
void bind_feature_regions(nanobind::module_& module, nanobind::class_<BoundFeatures>& bound);
void bind_disc_closing(nanobind::module_& module);

}  // namespace minkref::python
