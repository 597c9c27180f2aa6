#include "io/picture_colours_vtk.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"
#include "nearwall/mesh/limit_reason.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kMostCategories = 12;
constexpr std::array<std::string_view, 5> kPointKindNames = {"smooth", "ridge", "corner", "ridge end", "tip"};

using Rgb = std::array<double, 3>;

/// Distinct on white and beside each other; the first is a quiet grey, as the first value mostly is the usual case.
constexpr std::array<Rgb, kMostCategories> kPalette = {{{0.80, 0.82, 0.85},
                                                        {0.84, 0.19, 0.15},
                                                        {0.13, 0.40, 0.67},
                                                        {0.99, 0.68, 0.20},
                                                        {0.20, 0.60, 0.30},
                                                        {0.58, 0.32, 0.66},
                                                        {0.35, 0.75, 0.85},
                                                        {0.60, 0.40, 0.20},
                                                        {0.95, 0.55, 0.75},
                                                        {0.45, 0.50, 0.10},
                                                        {0.10, 0.20, 0.45},
                                                        {0.35, 0.35, 0.35}}};

/// Dark blue over green to yellow, even in lightness.
constexpr std::array<Rgb, 5> kRamp = {
    {{0.25, 0.05, 0.40}, {0.20, 0.32, 0.55}, {0.13, 0.56, 0.55}, {0.40, 0.78, 0.38}, {0.98, 0.90, 0.15}}};

std::vector<std::string> array_names(vtkDataSet* data) {
  std::vector<std::string> names;
  for (vtkDataSetAttributes* a : {static_cast<vtkDataSetAttributes*>(data->GetCellData()),
                                  static_cast<vtkDataSetAttributes*>(data->GetPointData())}) {
    for (int i = 0; i < a->GetNumberOfArrays(); ++i) {
      if (a->GetArray(i) && a->GetArrayName(i)) names.emplace_back(a->GetArrayName(i));
    }
  }
  return names;
}

[[noreturn]] void fail_unknown(vtkDataSet* data, const std::string& name) {
  const auto names = array_names(data);
  const std::string near = nearest(name, names);
  throw InputError(fmt::format("no array '{}' to colour by; there are: {}{}", name, fmt::join(names, " "),
                               near.empty() ? "" : "; did you mean " + near + "?"));
}

/// Values of an integer array, if they are few; else nothing.
std::set<int> categories(vtkDataArray* array) {
  std::set<int> values;
  const int type = array->GetDataType();
  if (array->GetNumberOfComponents() != 1 || type == VTK_DOUBLE || type == VTK_FLOAT) return {};
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    values.insert(static_cast<int>(array->GetTuple1(i)));
    if (values.size() > kMostCategories) return {};
  }
  return values;
}

std::string name_of(int value, const std::string& array, vtkDataSet* data) {
  const auto from = [&](std::span<const std::string_view> names) {
    return value >= 0 && static_cast<std::size_t>(value) < names.size()
               ? std::string(names[static_cast<std::size_t>(value)])
               : std::to_string(value);
  };
  if (array == "PointKind") return from(kPointKindNames);
  if (array == "LimitReason") return from(mesh::kLimitReasonNames);
  auto* patches = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("PatchNames"));
  if (array == "Patch" && patches && value >= 0 && value < patches->GetNumberOfValues())
    return patches->GetValue(value);
  return std::to_string(value);
}

vtkSmartPointer<vtkScalarsToColors> palette(const std::set<int>& values, const std::string& array, vtkDataSet* data) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->IndexedLookupOn();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(values.size()));
  vtkIdType i = 0;
  for (const int value : values) {
    const Rgb& c = kPalette[static_cast<std::size_t>(i)];
    table->SetAnnotation(vtkVariant(value), name_of(value, array, data));
    table->SetTableValue(i++, c[0], c[1], c[2], 1);
  }
  table->SetNanColor(0.6, 0.6, 0.6, 1);
  return table;
}

vtkSmartPointer<vtkScalarsToColors> ramp(const std::array<double, 2>& range, bool logarithmic) {
  constexpr int kSteps = 256;
  vtkSmartPointer<vtkColorTransferFunction> smooth = vtkSmartPointer<vtkColorTransferFunction>::New();
  smooth->SetColorSpaceToLab();
  for (std::size_t i = 0; i < kRamp.size(); ++i) {
    smooth->AddRGBPoint(static_cast<double>(i) / (kRamp.size() - 1), kRamp[i][0], kRamp[i][1], kRamp[i][2]);
  }
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kSteps);
  for (int i = 0; i < kSteps; ++i) {
    double c[3];
    smooth->GetColor(static_cast<double>(i) / (kSteps - 1), c);
    table->SetTableValue(i, c[0], c[1], c[2], 1);
  }
  table->SetTableRange(range[0], range[1]);
  if (logarithmic) table->SetScaleToLog10();
  table->SetNanColor(0.6, 0.6, 0.6, 1);
  return table;
}

}  // namespace

Colours colours_for(vtkDataSet* data, const PictureRequest& request) {
  Colours colours;
  const char* name = request.colour_by.c_str();
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  colours.of_cells = array != nullptr;
  if (!array) array = data->GetPointData()->GetArray(name);
  if (!array) fail_unknown(data, request.colour_by);

  const std::set<int> values = request.range || request.logarithmic ? std::set<int>() : categories(array);
  if (!values.empty()) {
    colours.is_categorical = true;
    colours.n_categories = static_cast<int>(values.size());
    colours.table = palette(values, request.colour_by, data);
    return colours;
  }
  array->GetFiniteRange(colours.range.data(), array->GetNumberOfComponents() == 1 ? 0 : -1);
  if (request.range) colours.range = *request.range;
  if (request.logarithmic && !(colours.range[0] > 0)) {
    throw InputError(fmt::format("array '{}' has values from {}: no logarithm", request.colour_by, colours.range[0]));
  }
  if (!(colours.range[0] < colours.range[1]))
    colours.range[1] = colours.range[0] + std::max(1.0, std::abs(colours.range[0]));
  colours.table = ramp(colours.range, request.logarithmic);
  return colours;
}

}  // namespace nearwall::io
