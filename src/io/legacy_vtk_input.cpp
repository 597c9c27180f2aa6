#include "io/legacy_vtk_input.h"

#include <fmt/format.h>

#include "io/point_arrays.h"

namespace nearwall::io {
namespace {

struct NamedType {
  std::string_view name;
  ScalarType type;
};

/// Names of legacy files; vtkIdType has 32 bits in them whatever the program that wrote them.
constexpr NamedType kTypes[] = {
    {"unsigned_char", ScalarType::UInt8},  {"char", ScalarType::Int8},           {"unsigned_short", ScalarType::UInt16},
    {"short", ScalarType::Int16},          {"unsigned_int", ScalarType::UInt32}, {"int", ScalarType::Int32},
    {"unsigned_long", ScalarType::UInt64}, {"long", ScalarType::Int64},          {"vtktypeint64", ScalarType::Int64},
    {"vtktypeuint64", ScalarType::UInt64}, {"float", ScalarType::Float32},       {"double", ScalarType::Float64},
    {"vtkIdType", ScalarType::Int32},      {"vtktypeint32", ScalarType::Int32},
};

/// Strings of ascii files have blanks and other odd characters as %XX.
std::string percent_decoded(std::string_view text) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                  : -1;
  };
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0) {
      decoded += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

}  // namespace

template <class T>
T LegacyVtkInput::next(ScalarType type) {
  if (!is_ascii_) return decode_as<T>(type, in_.bytes(size_of(type), "a value").data(), std::endian::big);
  if constexpr (std::is_integral_v<T>) {
    return in_.integer("a whole number");
  } else {
    return in_.number("a number");
  }
}

template <class T>
std::vector<T> LegacyVtkInput::read_all(std::int64_t n, ScalarType type) {
  std::vector<T> values(in_.checked_count(n, "the number of values", least_bytes(type)));
  begin_values();
  for (T& value : values) value = next<T>(type);
  return values;
}

template std::vector<std::int64_t> LegacyVtkInput::read_all(std::int64_t n, ScalarType type);

LegacyVtkInput::LegacyVtkInput(std::string_view bytes, const std::string& file) : in_(bytes, file) {
  const std::string_view first = in_.rest_of_line();
  if (!first.starts_with("# vtk DataFile Version")) in_.fail_expected("'# vtk DataFile Version'", first);
  const auto version = first.substr(std::string_view("# vtk DataFile Version").size());
  has_offsets_ = in_.to_number(trimmed(version), "the version") > 5;
  in_.pass_line_end();
  in_.pass_line_end();  // the title
  const std::string_view encoding = in_.word();
  is_ascii_ = same_word(encoding, "ASCII");
  if (!is_ascii_ && !same_word(encoding, "BINARY")) in_.fail_expected("'ASCII' or 'BINARY'", encoding);
  if (const auto word = in_.word(); !same_word(word, "DATASET")) in_.fail_expected("'DATASET'", word);
  dataset_ = in_.word();
  if (!is_ascii_) in_.enter_binary();
}

void LegacyVtkInput::read_other(std::string_view keyword) {
  if (same_word(keyword, "CELL_DATA") || same_word(keyword, "POINT_DATA")) {
    in_cell_data_ = same_word(keyword, "CELL_DATA");
    in_point_data_ = !in_cell_data_;
    n_tuples_ = in_.integer("the number of values");
  } else if (same_word(keyword, "METADATA")) {
    skip_metadata();
  } else if (same_word(keyword, "FIELD")) {
    read_field();
  } else {
    read_attribute(keyword);
  }
}

std::vector<Vec3> LegacyVtkInput::read_points() {
  const std::int64_t n = in_.integer("the number of points");
  const ScalarType type = read_type();
  std::vector<Vec3> points(in_.checked_count(n, "the number of points", 3 * least_bytes(type)));
  begin_values();
  for (Vec3& point : points) {
    for (int axis = 0; axis < 3; ++axis) point[axis] = next<double>(type);
  }
  return points;
}

CellList LegacyVtkInput::read_cells() {
  const std::size_t n = in_.count("the number of cells", 1);
  const std::size_t size = in_.count("the size of the cells", 1);
  return has_offsets_ ? read_offset_cells(n, size) : read_counted_cells(n, size);
}

/// A block of names and values up to an empty line.
void LegacyVtkInput::skip_metadata() {
  in_.pass_line_end();
  while (in_.left() > 0 && !in_.rest_of_line().empty()) in_.pass_line_end();
}

CellList LegacyVtkInput::read_counted_cells(std::size_t n_cells, std::size_t size) {
  CellList cells;
  begin_values();
  for (std::size_t i = 0; i < n_cells; ++i) {
    const std::size_t n = in_.checked_count(next<std::int64_t>(ScalarType::Int32), "the number of corners",
                                            least_bytes(ScalarType::Int32));
    for (std::size_t k = 0; k < n; ++k) cells.points.push_back(next<std::int64_t>(ScalarType::Int32));
    cells.ends.push_back(static_cast<std::int64_t>(cells.points.size()));
  }
  if (cells.points.size() + n_cells != size) {
    in_.fail(fmt::format("the cells have {} entries, {} were announced", cells.points.size() + n_cells, size));
  }
  return cells;
}

CellList LegacyVtkInput::read_offset_cells(std::size_t n_offsets, std::size_t size) {
  CellList cells;
  if (const auto word = in_.word(); word != "OFFSETS") in_.fail_expected("'OFFSETS'", word);
  cells.ends = read_integers(static_cast<std::int64_t>(n_offsets), read_type());
  if (!cells.ends.empty()) cells.ends.erase(cells.ends.begin());  // the first one is 0
  if (const auto word = in_.word(); word != "CONNECTIVITY") in_.fail_expected("'CONNECTIVITY'", word);
  cells.points = read_integers(static_cast<std::int64_t>(size), read_type());
  return cells;
}

LegacyGrid LegacyVtkInput::read_grid() {
  LegacyGrid grid;
  for (std::string_view keyword = next_section(); !keyword.empty(); keyword = next_section()) {
    if (same_word(keyword, "POINTS")) {
      grid.points = read_points();
    } else if (same_word(keyword, "CELLS")) {
      grid.cells = read_cells();
    } else if (same_word(keyword, "CELL_TYPES")) {
      grid.types = read_integers(in_.integer("the number of cells"), ScalarType::Int32);
    } else {
      read_other(keyword);
    }
  }
  return grid;
}

void LegacyVtkInput::read_field() {
  in_.word_of_line();  // its name
  const std::int64_t n_arrays = in_.integer("the number of arrays");
  for (std::int64_t i = 0; i < n_arrays; ++i) {
    std::string name = percent_decoded(in_.word());
    if (name == "METADATA") {
      skip_metadata();
      name = percent_decoded(in_.word());
    }
    const std::int64_t n_components = in_.to_integer(in_.word_of_line(), "the number of components");
    const std::int64_t n = in_.to_integer(in_.word_of_line(), "the number of values");
    if (n_components < 0 || n < 0) in_.fail("a negative number of values");
    in_.checked_count(n, "the number of values", 0);
    read_array(name, n_components, n);
  }
}

void LegacyVtkInput::read_attribute(std::string_view keyword) {
  const bool is_table = same_word(keyword, "LOOKUP_TABLE");
  const std::string name = percent_decoded(in_.word_of_line());
  if (is_table || same_word(keyword, "COLOR_SCALARS")) {  // bytes in binary files, numbers from 0 to 1 in ascii ones
    const std::int64_t n = in_.to_integer(in_.word_of_line(), "the number of colours or components");
    return skip_values(is_table ? 4 : n, is_table ? n : n_tuples_, ScalarType::UInt8);
  }
  std::int64_t n_components = 1;
  if (same_word(keyword, "TEXTURE_COORDINATES")) {
    n_components = in_.to_integer(in_.word_of_line(), "the dimension");
  } else if (same_word(keyword, "VECTORS") || same_word(keyword, "NORMALS")) {
    n_components = 3;
  } else if (same_word(keyword, "TENSORS")) {
    n_components = 9;
  } else if (same_word(keyword, "TENSORS6")) {
    n_components = 6;
  } else if (!same_word(keyword, "SCALARS") && !same_word(keyword, "GLOBAL_IDS") &&
             !same_word(keyword, "PEDIGREE_IDS")) {
    in_.fail_expected("a section of a VTK file", keyword);
  }
  const ScalarType type = read_type();
  if (same_word(keyword, "SCALARS")) {
    if (const auto word = in_.word_of_line(); !word.empty())
      n_components = in_.to_integer(word, "the number of components");
    const std::size_t before = in_.offset();
    if (same_word(in_.word(), "LOOKUP_TABLE")) {
      in_.word_of_line();
    } else {
      in_.seek(before);
    }
  }
  read_values(name, n_components, n_tuples_, type);
}

void LegacyVtkInput::read_array(const std::string& name, std::int64_t n_components, std::int64_t n) {
  const std::string_view type = in_.word_of_line();
  if (type == "string") return read_strings(name, n_components, n);
  in_.seek(in_.offset() - type.size());
  read_values(name, n_components, n, read_type());
}

void LegacyVtkInput::read_values(const std::string& name, std::int64_t n_components, std::int64_t n, ScalarType type) {
  if (point_arrays_ && in_cell_data_) point_arrays_->meet_other(name, "a cell array");
  if (point_arrays_ && in_point_data_ && n_components != 1) {
    point_arrays_->meet_other(name, fmt::format("a point array of {} components", n_components));
  }
  if (in_cell_data_ && n_components == 1 && is_patch_array_name(name) && !is_real(type)) {
    cell_arrays_.push_back({name, read_integers(n, type)});
  } else if (in_point_data_ && n_components == 1 && point_arrays_ && point_arrays_->meet(name)) {
    point_arrays_->take(name, read_all<double>(n, type));
  } else {
    skip_values(n_components, n, type);
  }
}

void LegacyVtkInput::read_strings(const std::string& name, std::int64_t n_components, std::int64_t n) {
  begin_values();
  const bool wanted = name == kPatchNames;
  for (std::int64_t i = 0; i < total(n_components, n); ++i) {
    std::string text = is_ascii_ ? percent_decoded(in_.word()) : std::string(in_.bytes(string_length(), "a string"));
    if (in_.left() == 0 && text.empty()) in_.fail_expected("a string", "");
    if (wanted) patch_names_.push_back(std::move(text));
  }
}

/// The two high bits of the first byte say how many bytes the length takes: 1, 2, 4 or 8.
std::size_t LegacyVtkInput::string_length() {
  const std::string_view rest = in_.all().substr(in_.offset());
  if (rest.empty()) in_.fail_expected("the length of a string", "");
  const unsigned width = static_cast<unsigned char>(rest[0]) >> 6;
  switch (width) {
    case 3:
      return in_.value<std::uint8_t>(std::endian::big, "a length") & 0x3f;
    case 2:
      return in_.value<std::uint16_t>(std::endian::big, "a length") & 0x3fff;
    case 1:
      return in_.value<std::uint32_t>(std::endian::big, "a length") & 0x3fffffff;
    default:
      return in_.value<std::uint64_t>(std::endian::big, "a length");
  }
}

void LegacyVtkInput::skip_values(std::int64_t n_components, std::int64_t n, ScalarType type) {
  const std::size_t values = in_.checked_count(total(n_components, n), "the number of values", least_bytes(type));
  begin_values();
  if (!is_ascii_) {
    in_.bytes(values * size_of(type), "values");
    return;
  }
  for (std::size_t i = 0; i < values; ++i) {
    if (in_.word().empty()) in_.fail_expected("a value", "");
  }
}

std::int64_t LegacyVtkInput::total(std::int64_t n_components, std::int64_t n) const {
  std::int64_t product = 0;
  if (n_components < 0 || n < 0 || __builtin_mul_overflow(n_components, n, &product)) {
    in_.fail(fmt::format("{} values of {} components cannot be", n, n_components));
  }
  return product;
}

ScalarType LegacyVtkInput::read_type() {
  const std::string_view word = in_.word_of_line();
  for (const NamedType& named : kTypes) {
    if (same_word(word, named.name)) return named.type;
  }
  in_.fail_expected("a type such as 'double' or 'int'", word);
}

std::size_t LegacyVtkInput::least_bytes(ScalarType type) const { return is_ascii_ ? 1 : size_of(type); }

void LegacyVtkInput::begin_values() {
  if (!is_ascii_) in_.pass_line_end();
}

}  // namespace nearwall::io
