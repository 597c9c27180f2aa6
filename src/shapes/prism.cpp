#include "shapes/prism.h"

namespace nearwall::shapes {

void add_flat_face(SurfaceBuilder& builder, std::string_view patch, const std::vector<VertexId>& corners, double size) {
  std::vector<Row> edges;
  Vec3 normal;
  const std::size_t n = corners.size();
  const Vec3 origin = builder.point(corners[0]);
  for (std::size_t i = 0; i < n; ++i) {
    const VertexId a = corners[i], b = corners[(i + 1) % n];
    edges.push_back(builder.edge(a, b, size));
    normal += cross(builder.point(a) - origin, builder.point(b) - origin);
  }
  builder.fill(builder.patch(patch), {loop_of(edges)}, plane_chart(origin, normal), size);
}

void add_prism(SurfaceBuilder& builder, const std::vector<PrismCorner>& polygon, double low, double high,
               std::string_view low_patch, std::string_view high_patch, double size) {
  std::vector<VertexId> near, far;
  for (const PrismCorner& c : polygon) {
    near.push_back(builder.add_point({c.x, low, c.z}));
    far.push_back(builder.add_point({c.x, high, c.z}));
  }
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    add_flat_face(builder, polygon[i].side, {near[j], near[i], far[i], far[j]}, size);
  }
  add_flat_face(builder, low_patch, near, size);
  add_flat_face(builder, high_patch, reversed(far), size);
}

void add_box(SurfaceBuilder& builder, const Vec3& low, const Vec3& high, const std::string& prefix, double size) {
  add_prism(builder,
            {{low.x(), low.z(), prefix + "z-min"},
             {high.x(), low.z(), prefix + "x-max"},
             {high.x(), high.z(), prefix + "z-max"},
             {low.x(), high.z(), prefix + "x-min"}},
            low.y(), high.y(), prefix + "y-min", prefix + "y-max", size);
}

}  // namespace nearwall::shapes
