#pragma once

#include <stdlib.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/geometry/measures.h"
#include "nearwall/volume/domain_boundary.h"
#include "tests/support/gallery.h"
#include "tests/support/growing.h"
#include "tests/support/volume_meshes.h"
#include "tests/volume/open_shapes.h"

/// Domains with layers and tetrahedra, made by the program of this build.
namespace nearwall::volume::domains_for_tests {

using namespace open_shapes;
using growing_for_tests::geometric;

/// The program of this build that makes the tetrahedra.
inline Fill filled(const FillBoundary& boundary) {
  ::setenv("NEARWALL_TETGEN", NEARWALL_TETGEN_PROGRAM, 1);
  Fill fill = fill_with_tetgen(boundary);
  ::unsetenv("NEARWALL_TETGEN");
  return fill;
}

/// All that a domain is filled with.
struct Domain {
  TestOpenWall wall;
  layers::Growth growth;
  mesh::LayerMesh layers;
  mesh::LayerSource source;
  RestBoundary rest;
  Fill fill;
  HybridMesh hybrid;
  DomainBoundary boundary;

  Domain(surface::OpenWall open, const std::set<std::string>& with_layers, const std::vector<double>& heights)
      : wall(std::move(open)),
        growth(layers::grow(wall.wall(), wall.options(heights, with_layers))),
        layers(growth.front, growth.lines),
        source(layers, wall.surface().face_patch, wall.surface().points.raw()),
        rest(rest_boundary(layers, wall.certified_wall(), 1.3)),
        fill(filled(rest.surface)),
        hybrid(source, rest, fill),
        boundary(domain_boundary(layers, wall.certified_wall(), rest, hybrid,
                                 [this](mesh::PlaneIndex p, const Vec3&) { return wall.open().patch[p]; })) {}

  explicit Domain(const OpenShape& shape) : Domain(shape, shape.make()) {}

  DomainCertificate certificate() const {
    const auto of_layers = certify::certify_layers(layers, wall.certified_wall());
    return certify_domain(boundary, &wall.planes(), of_layers.cells_volume, fill);
  }
  double face_area(std::size_t f) const {
    double area = 0;
    const auto corner = [&](int k) { return boundary.points[boundary.faces[f][static_cast<std::size_t>(k)]]; };
    for (int k = 1; k + 1 < boundary.size_of(f); ++k) {
      area += geometry::triangle_area(corner(0), corner(k), corner(k + 1));
    }
    return area;
  }

 private:
  Domain(const OpenShape& shape, surface::OpenWall open)
      : Domain(open, shape.with_layers, geometric(0.02 * size_of(open.surface, shape.with_layers), 1.2, 6)) {}
};

/// Domains are made once for all tests.
inline const Domain& domain_of(const OpenShape& shape) {
  static std::map<std::string, std::unique_ptr<Domain>> made;
  auto& domain = made[shape.name];
  if (!domain) domain = std::make_unique<Domain>(shape);
  return *domain;
}

}  // namespace nearwall::volume::domains_for_tests
