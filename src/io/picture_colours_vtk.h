#pragma once

#include <vtkDataSet.h>
#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>

#include <array>

#include "nearwall/io/picture.h"

namespace nearwall::io {

/// How an array becomes colours.
struct Colours {
  vtkSmartPointer<vtkScalarsToColors> table;
  std::array<double, 2> range = {0, 1};
  bool of_cells = false;
  bool is_categorical = false;  ///< few whole numbers: a colour for each
  int n_categories = 0;
};

/// \throws InputError if the array does not exist, naming those that do
Colours colours_for(vtkDataSet* data, const PictureRequest& request);

}  // namespace nearwall::io
