// The whole library by one include: sums, events, indices and updates in the plane, with a disc and
// in space; paths, fits and traps; scenes. A single header below is enough for a single question,
// and compiles faster.
#pragma once

#include "reference/disc/index/disc_index.hpp"
#include "reference/disc/region/offset_region.hpp"
#include "reference/motion/fits_and_traps.hpp"
#include "reference/motion/held_scales.hpp"
#include "reference/motion/path_diagram.hpp"
#include "reference/motion/space/free/fits_and_traps.hpp"
#include "reference/motion/space/held_scales.hpp"
#include "reference/motion/space/valid_scales.hpp"
#include "reference/motion/valid_scales.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/decomposition/cut_pieces.hpp"
#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "reference/plane/sum.hpp"
#include "reference/plane/tight_passages.hpp"
#include "reference/scene/scene_union.hpp"
#include "reference/space/convex/dynamic_convex_sum.hpp"
#include "reference/space/definition/definition_sum.hpp"
#include "reference/space/edges/edge_sum.hpp"
