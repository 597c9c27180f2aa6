#include "nearwall/pipeline/case.h"

#include "nearwall/io/surface_reader.h"

namespace nearwall {

namespace {

std::filesystem::path beside(const std::filesystem::path& case_file, const std::filesystem::path& file) {
  return file.is_absolute() ? file : case_file.parent_path() / file;
}

}  // namespace

std::string Case::output_name() const { return name.empty() ? io::surface_stem(surface.file) : name; }

std::filesystem::path Case::surface_path() const { return beside(file, surface.file); }

std::filesystem::path Case::output_directory() const { return beside(file, output.directory); }

SurfaceFacts surface_facts(const std::filesystem::path& file, const mesh::SurfaceMesh& surface) {
  SurfaceFacts facts;
  facts.file = file;
  facts.box = geometry::bounding_box(surface.points.raw());
  facts.patch_names = surface.patch_names.raw();
  double sum = 0;
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.triangle(f);
    sum += sum3(distance(a, b), distance(b, c), distance(c, a));
  }
  if (!surface.faces.empty()) facts.mean_edge = sum / (3.0 * static_cast<double>(surface.faces.size()));
  return facts;
}

}  // namespace nearwall
