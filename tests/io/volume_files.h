#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/vtk_xml_input.h"

/// One small mesh in several forms: a vertex, a wedge, a line, a triangle and a tetrahedron on the wedge.
namespace nearwall::io::volume_files {

inline const std::string kLegacyOld =
    "# vtk DataFile Version 2.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 7 double\n"
    "0 0 0 1 0 0 0 1 0 0 0 1 1 0 1.5 0 1 1 0 0 3\nCELLS 5 21\n1 6\n6 0 2 1 3 5 4\n2 0 1\n3 0 1 2\n4 3 4 5 6\n"
    "CELL_TYPES 5\n1 13 3 5 10\nCELL_DATA 5\nSCALARS region int 1\nLOOKUP_TABLE default\n1 2 3 4 5\n";

inline const std::string kLegacyOffsets =
    "# vtk DataFile Version 5.1\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 7 float\n"
    "0 0 0 1 0 0 0 1 0 0 0 1 1 0 1.5 0 1 1 0 0 3\nCELLS 6 16\nOFFSETS vtktypeint64\n0 1 7 9 12 16\n"
    "CONNECTIVITY vtktypeint64\n6 0 2 1 3 5 4 0 1 0 1 2 3 4 5 6\nCELL_TYPES 5\n1\n13\n3\n5\n10\n";

inline const std::string kXmlAscii =
    "<VTKFile type='UnstructuredGrid'><UnstructuredGrid><Piece NumberOfPoints='7' NumberOfCells='5'><Cells>"
    "<DataArray type='UInt8' Name='types' format='ascii'>1 13 3 5 10</DataArray>"
    "<DataArray type='Int32' Name='connectivity' format='ascii'>6 0 2 1 3 5 4 0 1 0 1 2 3 4 5 6</DataArray>"
    "<DataArray type='Int32' Name='offsets' format='ascii'>1 7 9 12 16</DataArray></Cells><Points>"
    "<DataArray type='Float64' NumberOfComponents='3' format='ascii'>0 0 0 1 0 0 0 1 0 0 0 1 1 0 1.5 0 1 1 0 0 3"
    "</DataArray></Points></Piece></UnstructuredGrid></VTKFile>";

/// Values of the array of that name.
inline std::vector<double> reals_of(std::string_view bytes, std::string_view name) {
  const VtkXmlInput file(bytes, "file");
  for (const XmlArray& array : file.arrays()) {
    if (array.name() == name) return file.reals(array);
  }
  return {};
}

}  // namespace nearwall::io::volume_files
