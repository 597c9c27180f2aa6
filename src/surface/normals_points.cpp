#include <vector>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/surface/normals.h"
#include "surface/normals_cap.h"
#include "surface/normals_visible.h"

namespace nearwall::surface {

namespace {

/// Vertices that one thread takes at a time.
constexpr std::size_t kBlock = 4096;

/// Normals of one vertex after the other, with room for its faces that is used again.
class VertexNormals {
 public:
  VertexNormals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                NormalMethod method)
      : surface_(surface), topology_(topology), features_(features), method_(method) {}

  PointNormal at(VertexId v) {
    const Vec3 mean = gather(v);
    if (normals_.empty()) return {{}, geometry::kPi / 2, false};
    const double to_worst = squared_chord_to_worst(mean, normals_);
    if (method_ == NormalMethod::MostVisible && !(1.0 - 0.5 * to_worst > kVisibilityTrigger)) {
      if (const auto best = most_visible_of(normals_, normals_)) {
        return judged(best->direction, normals_, squared_chord_to_worst(best->direction, normals_));
      }
    }
    return judged(mean, normals_, to_worst);
  }

 private:
  /// Fills `normals_` with those of the faces round v and returns their angle-weighted mean, a unit vector.
  Vec3 gather(VertexId v) {
    normals_.clear();
    const auto fan = topology_.fan(v);
    if (fan.empty()) return {};
    const Vec3 apex = surface_.points[v];
    Vec3 b = surface_.points[topology_.target(fan.front())] - apex;
    Vec3 sum;
    for (const HalfedgeId h : fan) {
      const Vec3 c = surface_.points[topology_.origin(mesh::Topology::previous(h))] - apex;
      const Vec3& normal = features_.face_normal[mesh::Topology::face(h)];
      if (normal != Vec3{}) {
        normals_.push_back(normal);
        sum += normal * geometry::angle_between(b, c);
      }
      b = c;
    }
    // Faces whose normals cancel leave no mean: any direction is as good, and none sees them all.
    if (sum == Vec3{}) return normals_.empty() ? Vec3{} : normals_.front();
    return unit_vector(sum);
  }

  const mesh::SurfaceMesh& surface_;
  const mesh::Topology& topology_;
  const Features& features_;
  NormalMethod method_;
  std::vector<Vec3> normals_;
};

}  // namespace

IdVector<VertexId, PointNormal> point_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                              const Features& features, NormalMethod method) {
  expect(surface.points.size() == topology.n_vertices(), "point_normals: surface and topology are of the same mesh");
  expect(features.face_normal.size() == topology.n_faces(), "point_normals: features are of the same mesh");
  IdVector<VertexId, PointNormal> normals(surface.points.size());
  parallel_blocks(normals.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    VertexNormals vertex_normals(surface, topology, features, method);
    for (std::size_t i = begin; i < end; ++i) normals[VertexId(i)] = vertex_normals.at(VertexId(i));
  });
  return normals;
}

}  // namespace nearwall::surface
