"""Prints what VTK's own readers find in a .vtkhdf and the .vtu of the same mesh: `same`, or what differs.

vtk_figures.py MESH.vtkhdf MESH.vtu
"""

import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    figures = {"points": vtk_to_numpy(grid.GetPoints().GetData()).tobytes()}
    figures["types"] = [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())]
    figures["nodes"] = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).tolist()
    for data in (grid.GetPointData(), grid.GetCellData()):
        for i in range(data.GetNumberOfArrays()):
            figures[data.GetArrayName(i)] = vtk_to_numpy(data.GetArray(i)).tobytes()
    names = grid.GetFieldData().GetAbstractArray("PatchNames")
    figures["patches"] = [names.GetValue(i) for i in range(names.GetNumberOfValues())]
    return figures


a = read(vtkHDFReader(), sys.argv[1])
b = read(vtkXMLUnstructuredGridReader(), sys.argv[2])
differences = [key for key in sorted(a.keys() | b.keys()) if a.get(key) != b.get(key)]
expected = {"points", "types", "nodes", "patches", "Layer", "Column", "Patch", "Line", "Level"}
print("same" if not differences and expected <= a.keys() else f"{differences} of {sorted(a)}")
