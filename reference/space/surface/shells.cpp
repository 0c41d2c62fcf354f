#include "reference/space/surface/shells.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"
#include "reference/number/balanced_sum.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline space {
namespace {

/// Six times the volume, measured from one corner; bounded.
BoundedDouble sextuple_volume_nearly(const SurfaceEdges& surface, const Shell& shell) {
  const auto at = [&](std::uint32_t h) -> const BoundedVector& {
    return surface.points[surface.half_edges[h].from].rounded;
  };
  const BoundedVector& origin = at(surface.faces[shell.faces[0]].walks[0]);
  BoundedDouble volume = 0;
  for (const std::uint32_t f : shell.faces) {
    const SurfaceFace& face = surface.faces[f];
    const BoundedVector& centre = at(face.walks[0]);
    BoundedVector area{0, 0, 0};
    for (const std::uint32_t first : face.walks) {
      std::uint32_t h = first;
      do {
        const std::uint32_t next = surface.half_edges[h].next;
        area = area + cross(at(h) - centre, at(next) - centre);
        h = next;
      } while (h != first);
    }
    volume = volume + dot(centre - origin, area);
  }
  return volume;
}

bool is_positive(const SurfaceEdges& surface, const Shell& shell) {
  int side = sextuple_volume_nearly(surface, shell).certain_sign();
  if (side == BoundedDouble::undecided) side = sign(volume(surface, shell));
  if (side == 0) throw std::logic_error("a shell bounds no volume");
  return side > 0;
}

class ShellSearch {
 public:
  ShellSearch(const SurfaceEdges& surface, Pairing pairing)
      : surface_(surface), pairing_(pairing), shell_of_(surface.faces.size(), no_entry) {}

  std::vector<Shell> run() {
    for (std::uint32_t f = 0; f < surface_.faces.size(); ++f) {
      if (shell_of_[f] == no_entry) gather(f);
    }
    count_vertices();
    for (Shell& shell : shells_) {
      look_for_interrupt();
      std::sort(shell.faces.begin(), shell.faces.end());
      shell.edges /= 2;  // they were counted from both sides
      shell.characteristic += static_cast<long>(shell.vertices) - static_cast<long>(shell.edges);
      if (shell.characteristic > 2 || shell.characteristic % 2 != 0) {
        throw std::logic_error("a shell is no closed orientable surface");
      }
      shell.positive = is_positive(surface_, shell);
    }
    return std::move(shells_);
  }

 private:
  /// Gathers all faces reachable from `start`.
  void gather(std::uint32_t start) {
    const auto number = static_cast<std::uint32_t>(shells_.size());
    Shell& shell = shells_.emplace_back();
    shell.faces.push_back(start);
    shell_of_[start] = number;
    for (std::size_t k = 0; k < shell.faces.size(); ++k) {
      look_for_interrupt();
      const SurfaceFace& face = surface_.faces[shell.faces[k]];
      shell.characteristic += 2 - static_cast<long>(face.walks.size());
      for (const std::uint32_t first : face.walks) {
        std::uint32_t h = first;
        do {
          ++shell.edges;
          const std::uint32_t beyond =
              surface_.half_edges[surface_.half_edges[h].mate(pairing_)].face;
          if (shell_of_[beyond] == no_entry) {
            shell_of_[beyond] = number;
            shell.faces.push_back(beyond);
          }
          h = surface_.half_edges[h].next;
        } while (h != first);
      }
    }
  }

  /// A vertex is a fan: half-edges that leave a point, each reached across the previous half-edge.
  void count_vertices() {
    const std::vector<HalfEdge>& half_edges = surface_.half_edges;
    std::vector<bool> counted(half_edges.size(), false);
    for (std::uint32_t start = 0; start < half_edges.size(); ++start) {
      if (counted[start]) continue;
      ++shells_[shell_of_[half_edges[start].face]].vertices;
      for (std::uint32_t h = start; !counted[h];
           h = half_edges[half_edges[h].mate(pairing_)].next) {
        look_for_interrupt();
        counted[h] = true;
      }
    }
  }

  const SurfaceEdges& surface_;
  const Pairing pairing_;
  std::vector<std::uint32_t> shell_of_;
  std::vector<Shell> shells_;
};

}  // namespace

std::vector<Shell> shells(const SurfaceEdges& surface, Pairing pairing) {
  const FloatEnvironment standard;
  return ShellSearch(surface, pairing).run();
}

SpaceTopology topology(const SurfaceEdges& surface) {
  const FloatEnvironment standard;
  SpaceTopology result;
  for (const Shell& shell : shells(surface, Pairing::interior)) {
    result.components += shell.positive;
    result.tunnels += static_cast<std::uint64_t>(shell.genus());
  }
  for (const Shell& shell : shells(surface, Pairing::outside)) result.cavities += !shell.positive;
  return result;
}

Rational seen_area(const SurfaceEdges& surface, std::uint32_t face) {
  const OrientedPlane& plane = surface.planes[surface.faces[face].plane];
  const std::size_t axis = viewing_axis(plane.normal);
  std::vector<Rational> terms;
  for (const std::uint32_t first : surface.faces[face].walks) {
    for (const std::uint32_t h : surface.walk(first)) {
      const HalfEdge& half_edge = surface.half_edges[h];
      const Point p = seen(surface.points[half_edge.from].exact, axis);
      const Point q = seen(surface.points[half_edge.to].exact, axis);
      terms.push_back((p.x - q.x) * (p.y + q.y));
    }
  }
  const Rational doubled = balanced_sum(std::move(terms));
  return doubled / (is_mirrored(plane) ? -2 : 2);
}

Rational volume(const SurfaceEdges& surface, const Shell& shell) {
  std::vector<Rational> terms;
  for (const std::uint32_t f : shell.faces) {
    const OrientedPlane& plane = surface.planes[surface.faces[f].plane];
    const Integer& height = plane.normal[viewing_axis(plane.normal)];
    terms.push_back(plane.offset * seen_area(surface, f) / Rational(abs(height)));
  }
  return balanced_sum(std::move(terms)) / 3;
}

}  // namespace minkref::inline space
