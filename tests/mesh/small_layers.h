#pragma once

#include <algorithm>
#include <random>

#include "nearwall/geometry/box.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/mesh/topology.h"
#include "tests/support/shapes.h"

/// Small layer meshes made by hand, three levels high.
namespace nearwall::mesh {

using namespace shapes_for_tests;

struct Layers {
  SurfaceMesh wall;
  Front front;
  Lines lines;
};

inline void add_line(Layers& layers, VertexId v, const Vec3& direction) {
  layers.front.line_vertex.push_back(v);
  layers.lines.base.push_back(layers.wall.points[v]);
  layers.lines.pieces.push_back({direction, 0});
  layers.lines.heights.push_back({});
  layers.lines.windows.push_back({0, 3});
}

inline void finish(Layers& layers, std::size_t n_lines) {
  layers.front.first_line.push_back(static_cast<std::uint32_t>(n_lines));
  for (std::size_t k = 0; k <= n_lines; ++k) layers.lines.first_piece.push_back(static_cast<std::uint32_t>(k));
  layers.lines.table = HeightTable({{0, 0.01, 0.03, 0.07}});
}

/// A cube of side 1 whose vertices have one line each, away from its centre.
inline Layers plain_cube() {
  Layers layers;
  layers.wall = cube();
  for (const VertexId v : layers.wall.points.ids()) {
    layers.front.first_line.push_back(v.index());
    add_line(layers, v, layers.wall.points[v] - geometry::bounding_box(layers.wall.points.raw()).centre());
  }
  finish(layers, layers.wall.points.size());
  layers.front.faces = plain_front(layers.wall).faces;
  layers.front.n_wall_faces = layers.wall.faces.size();
  return layers;
}

/// The same, but with two lines at the vertices of the top: one for its faces, one for the sides; virtual quads
/// between.
inline Layers cube_with_two_lines_round_its_top() {
  Layers layers;
  layers.wall = cube();
  const auto box = geometry::bounding_box(layers.wall.points.raw());
  const double top = box.high.z();
  std::uint32_t n = 0;
  for (const VertexId v : layers.wall.points.ids()) {
    layers.front.first_line.push_back(n);
    Vec3 out = layers.wall.points[v] - box.centre();
    if (layers.wall.points[v].z() == top) {
      add_line(layers, v, Vec3(out.x() / 8, out.y() / 8, 1));
      add_line(layers, v, Vec3(out.x(), out.y(), 0.1));
      n += 2;
    } else {
      add_line(layers, v, out);
      ++n;
    }
  }
  finish(layers, n);
  const auto is_top = [&](const std::array<VertexId, 3>& face) {
    return std::all_of(face.begin(), face.end(), [&](VertexId v) { return layers.wall.points[v].z() == top; });
  };
  const auto line_on = [&](VertexId v, bool of_top) {
    const std::uint32_t first = layers.front.first_line[v.index()];
    return LineId(layers.wall.points[v].z() == top && !of_top ? first + 1 : first);
  };
  const Topology topology(layers.wall);
  std::vector<FrontFace> quads;
  for (const FaceId f : layers.wall.faces.ids()) {
    const auto& face = layers.wall.faces[f];
    const bool on_top = is_top(face);
    layers.front.faces.push_back({{line_on(face[0], on_top), line_on(face[1], on_top), line_on(face[2], on_top), {}}});
    for (int k = 0; on_top && k < 3; ++k) {
      const HalfedgeId h = Topology::halfedge(f, k);
      if (is_top(layers.wall.faces[Topology::face(topology.twin(h))])) continue;
      const VertexId a = topology.origin(h), b = topology.target(h);
      quads.push_back({{line_on(b, true), line_on(a, true), line_on(a, false), line_on(b, false)}});
    }
  }
  layers.front.n_wall_faces = layers.front.faces.size();
  for (const FrontFace& quad : quads) layers.front.faces.push_back(quad);
  return layers;
}

inline void randomise_windows(Layers& layers, std::mt19937& random, bool late_starts) {
  std::uniform_int_distribution<int> end(0, 3), start(0, late_starts ? 1 : 0);
  for (std::size_t v = 0; v + 1 < layers.front.first_line.size(); ++v) {
    const Window w{static_cast<Level>(start(random)), static_cast<Level>(end(random))};
    for (std::uint32_t k = layers.front.first_line[v]; k < layers.front.first_line[v + 1]; ++k) {
      layers.lines.windows[LineId(k)] = w;
    }
  }
}

}  // namespace nearwall::mesh
