#pragma once

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "nearwall/io/picture.h"

namespace nearwall::io {

/// What a picture shows, moved so that `focus` is the origin: single precision on the graphics side then resolves the
/// neighbourhood of the focus, however small.
struct PictureData {
  vtkSmartPointer<vtkPolyData> skin;   ///< outer surface; with a clip plane: the part behind it
  vtkSmartPointer<vtkPolyData> cut;    ///< the cells' sections in the clip plane; null for surfaces and without plane
  vtkSmartPointer<vtkPolyData> lines;  ///< ridge edges and the like; null if there are none
  vtkSmartPointer<vtkDataSet> whole;   ///< as read, for ranges and names
  Vec3 focus;                          ///< middle of what fills the picture
  Vec3 half_size;                      ///< half the extents of that box
};

/// \throws InputError, IoError, GeometryError as render_picture
PictureData load_picture_data(const PictureRequest& request);

}  // namespace nearwall::io
