#include "volume/tetgen_exchange.h"

#include <span>

#include "nearwall/core/errors.h"
#include "volume/memory_file.h"

namespace nearwall::volume {

namespace {

/// Both ends are of one build: the first number only guards against foreign files.
constexpr std::uint64_t kProblem = 0x6e65617277617031, kFill = 0x6e65617277616631;

struct ProblemHeader {
  std::uint64_t kind = kProblem;
  std::uint64_t n_points = 0, n_triangles = 0, n_holes = 0, n_sizes = 0;
  double slope = 0, largest = 0;
};

struct FillHeader {
  std::uint64_t kind = kFill;
  std::uint64_t n_points = 0, n_tetrahedra = 0;
};

template <class Header>
Header read_header(int file) {
  Header header;
  read_bytes(file, &header, sizeof header);
  if (header.kind != Header{}.kind) throw BackendError("what the tetrahedral mesher is given or gives is no such file");
  return header;
}

}  // namespace

void write_problem(int file, const TetgenProblem& problem) {
  const auto& [points, triangles] = problem.boundary;
  const ProblemHeader header{
      kProblem,      points.size(),  triangles.size(), problem.holes.size(), problem.sizes.size(),
      problem.slope, problem.largest};
  write_bytes(file, &header, sizeof header);
  write_array(file, std::span(points));
  write_array(file, std::span(triangles));
  write_array(file, std::span(problem.holes));
  write_array(file, std::span(problem.sizes));
}

TetgenProblem read_problem(int file) {
  const auto header = read_header<ProblemHeader>(file);
  TetgenProblem problem;
  problem.boundary.points = read_array<Vec3>(file, header.n_points);
  problem.boundary.triangles = read_array<std::array<std::uint32_t, 3>>(file, header.n_triangles);
  problem.holes = read_array<Vec3>(file, header.n_holes);
  problem.sizes = read_array<SizeSource>(file, header.n_sizes);
  problem.slope = header.slope;
  problem.largest = header.largest;
  return problem;
}

void write_fill(int file, const Fill& fill) {
  const FillHeader header{kFill, fill.points.size(), fill.tetrahedra.size()};
  write_bytes(file, &header, sizeof header);
  write_array(file, std::span(fill.points));
  write_array(file, std::span(fill.tetrahedra));
}

Fill read_fill(int file) {
  const auto header = read_header<FillHeader>(file);
  Fill fill;
  fill.points = read_array<Vec3>(file, header.n_points);
  fill.tetrahedra = read_array<std::array<std::uint32_t, 4>>(file, header.n_tetrahedra);
  return fill;
}

}  // namespace nearwall::volume
