// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/minkowski_sum_3.h>

#include <chrono>

#include "oracle/cgal/facet_triangles.hpp"
#include "oracle/cgal/kernel.hpp"
#include "oracle/cgal/polygon.hpp"
#include "oracle/cgal/shells.hpp"

namespace minkref::cgal_oracle {
namespace {

using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using HalfFacet = Nef::Halffacet_const_handle;

struct BuildShell : CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
  const Solid& shell;
  explicit BuildShell(const Solid& given) : shell(given) {}

  void operator()(Polyhedron::HalfedgeDS& structure) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(structure);
    builder.begin_surface(shell.vertices.size(), shell.faces.size());
    for (const SpacePoint& v : shell.vertices) {
      builder.add_vertex(Kernel::Point_3(to_cgal(v.x), to_cgal(v.y), to_cgal(v.z)));
    }
    for (const Face& face : shell.faces) {
      if (!builder.test_facet(face.begin(), face.end())) throw BadOperand("a shell is no manifold");
      builder.add_facet(face.begin(), face.end());
    }
    builder.end_surface();
  }
};

/// Makes the set enclosed by a shell; `inside_out` reverses faces that run the other way.
Nef enclosed(Solid shell, bool inside_out) {
  if (inside_out) {
    for (Face& face : shell.faces) std::reverse(face.begin(), face.end());
  }
  Polyhedron polyhedron;
  BuildShell build(shell);
  polyhedron.delegate(build);
  if (!polyhedron.is_closed()) throw BadOperand("a shell is not closed");
  return Nef(polyhedron);
}

/// Adds shell by shell, the larger ones first, because a Nef polyhedron of a surface fills its
/// cavities.
Nef to_nef(const Solid& solid) {
  Nef result(Nef::EMPTY);
  for (const Solid& shell : shells_by_size(solid)) {
    const bool cavity = six_volumes(shell) < 0;
    const Nef part = enclosed(shell, cavity);
    result = cavity ? result - part : result + part;
  }
  return result.regularization();
}

/// Returns the surface between marked and unmarked volumes, which may be no manifold.
Solid from_nef(const Nef& nef) {
  Solid result;
  std::map<const void*, std::size_t> numbers;
  for (auto v = nef.vertices_begin(); v != nef.vertices_end(); ++v) {
    numbers[&*v] = result.vertices.size();
    result.vertices.push_back(
        {from_cgal(v->point().x()), from_cgal(v->point().y()), from_cgal(v->point().z())});
  }
  for (HalfFacet f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f) {
    if (!f->incident_volume()->mark() || f->twin()->incident_volume()->mark()) continue;
    std::vector<Face> cycles;
    for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle) {
      if (!cycle.is_shalfedge()) continue;  // a single vertex in the facet
      Face& ring = cycles.emplace_back();
      Nef::SHalfedge_around_facet_const_circulator h(cycle), end(h);
      do {
        ring.push_back(numbers.at(&*h->source()->center_vertex()));
      } while (++h != end);
    }
    const auto normal = f->plane().orthogonal_vector();
    // The plane of a half-facet looks into its volume.
    triangulate_facet(result.vertices, cycles,
                      {-from_cgal(normal.x()), -from_cgal(normal.y()), -from_cgal(normal.z())},
                      result.faces);
  }
  return result;
}

}  // namespace

Solid sum_of_nef_polyhedra(const Solid& p, const Solid& q) {
  Nef first = to_nef(p), second = to_nef(q);
  const auto start = std::chrono::steady_clock::now();
  const Nef sum = CGAL::minkowski_sum_3(first, second);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  Solid result = from_nef(sum);
  result.seconds = taken.count();
  return result;
}

std::string cgal_version_of_nef() { return CGAL_VERSION_STR; }

}  // namespace minkref::cgal_oracle
