#include <fmt/format.h>

#include <optional>
#include <span>
#include <vector>

#include "io/input_hdf5.h"
#include "io/volume_builder.h"
#include "io/volume_formats.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

/// One array of a file whose pieces are read one after the other.
class PieceReader {
 public:
  PieceReader(const Hdf5File& file, Hdf5Array array) : file_(file), array_(std::move(array)) {}

  /// Calls use(run of values) for the next n values.
  template <class T, class Use>
  void next(std::uint64_t n, const Use& use) {
    if (n > array_.size() - next_) {
      file_.fail(fmt::format("{} has {} values, fewer than its pieces claim", array_.name(), array_.size()));
    }
    array_.for_each_run<T>(next_, n, use);
    next_ += n;
  }
  const Hdf5Array& array() const { return array_; }

 private:
  const Hdf5File& file_;
  Hdf5Array array_;
  std::uint64_t next_ = 0;
};

/// Numbers of one kind of the pieces, each held against the array that has as many values.
std::vector<std::uint64_t> counts(const Hdf5File& file, const Hdf5Group& grid, const std::string& name) {
  std::vector<std::uint64_t> counts;
  for (const std::int64_t n : grid.required_array(name).all<std::int64_t>()) {
    if (n < 0 || n > (std::int64_t{1} << 48)) file.fail(fmt::format("{}: {} is no count", name, n));
    counts.push_back(static_cast<std::uint64_t>(n));
  }
  return counts;
}

void require_grid(const Hdf5File& file, const Hdf5Group& grid) {
  const std::string type = grid.text("Type");
  if (type != "UnstructuredGrid") {
    throw InputError(fmt::format("{}: expected VTKHDF of the type UnstructuredGrid, found '{}'", file.name(), type));
  }
  if (grid.group("Steps")) {
    throw InputError(fmt::format("{}: holds several steps of time: save one of them", file.name()));
  }
}

/// Reads all pieces; the layers of the cells where the file has them.
class GridReader {
 public:
  GridReader(const Hdf5File& file, const Hdf5Group& grid)
      : file_(file),
        points_(file, grid.required_array("Points")),
        types_(file, grid.required_array("Types")),
        offsets_(file, grid.required_array("Offsets")),
        nodes_(file, grid.required_array("Connectivity")) {
    if (points_.array().size() % kDimension != 0) file.fail("Points: expected 3 coordinates each");
    const std::optional<Hdf5Group> cell_data = grid.group("CellData");
    std::optional<Hdf5Array> layer = cell_data ? cell_data->array("Layer") : std::nullopt;
    if (layer && layer->is_whole() && layer->size() == types_.array().size()) layers_.emplace(file, std::move(*layer));
  }

  void read_piece(std::uint64_t n_points, std::uint64_t n_cells, std::uint64_t n_nodes, VolumeBuilder& builder) {
    points_.next<double>(kDimension * n_points, [&](std::span<const double> run) { builder.add_coordinates(run); });
    types_.next<std::int64_t>(n_cells, [&](std::span<const std::int64_t> run) { builder.add_types(run); });
    // One more than there are cells: the first says where the first cell's nodes begin.
    offsets_.next<std::int64_t>(1, [&](std::span<const std::int64_t> run) {
      if (run[0] != 0) file_.fail(fmt::format("Offsets: a piece begins with {}, expected 0", run[0]));
    });
    offsets_.next<std::int64_t>(n_cells, [&](std::span<const std::int64_t> run) { builder.add_ends(run); });
    nodes_.next<std::int64_t>(n_nodes, [&](std::span<const std::int64_t> run) { builder.add_nodes(run); });
    if (layers_) {
      layers_->next<std::int64_t>(n_cells, [&](std::span<const std::int64_t> run) { builder.add_layers(run); });
    }
    builder.end_piece();
  }

 private:
  static constexpr std::uint64_t kDimension = 3;
  const Hdf5File& file_;
  PieceReader points_, types_, offsets_, nodes_;
  std::optional<PieceReader> layers_;
};

}  // namespace

VolumeFile read_vtkhdf(const std::filesystem::path& path) {
  const Hdf5File file(path);
  const std::optional<Hdf5Group> grid = file.root().group("VTKHDF");
  if (!grid) file.fail("expected VTKHDF, found no group of that name");
  require_grid(file, *grid);
  const auto n_points = counts(file, *grid, "NumberOfPoints"), n_cells = counts(file, *grid, "NumberOfCells"),
             n_nodes = counts(file, *grid, "NumberOfConnectivityIds");
  if (n_cells.size() != n_points.size() || n_nodes.size() != n_points.size()) {
    file.fail("the numbers of points, cells and connectivity are not of as many pieces");
  }
  GridReader reader(file, *grid);
  VolumeBuilder builder(file.name());
  for (std::size_t piece = 0; piece < n_points.size(); ++piece) {
    reader.read_piece(n_points[piece], n_cells[piece], n_nodes[piece], builder);
  }
  const std::optional<Hdf5Group> field_data = grid->group("FieldData");
  return builder.finish(field_data ? field_data->texts("PatchNames") : std::vector<std::string>());
}

}  // namespace nearwall::io
