"""What Gmsh and meshio find in the files of one mesh, as JSON: numbers of points and of elements by type, names of groups.

whole_mesh_figures.py STEM FIGURES: of STEM.msh, STEM.su2 and STEM.lb8.ugrid
"""

import json
import sys

import gmsh
import meshio

# Gmsh's types of elements and meshio's names by the names of ours.
TYPES = {
    "tetrahedron": (4, "tetra"),
    "pyramid": (7, "pyramid"),
    "wedge": (6, "wedge"),
    "hexahedron": (5, "hexahedron"),
    "triangle": (2, "triangle"),
    "quad": (3, "quad"),
}


def of_gmsh(path):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.logger.start()
    gmsh.open(path)
    figures = {"points": len(gmsh.model.mesh.getNodes()[0])}
    for name, (code, _) in TYPES.items():
        figures[name] = len(gmsh.model.mesh.getElementsByType(code)[0])
    figures["groups"] = sorted(gmsh.model.getPhysicalName(*group) for group in gmsh.model.getPhysicalGroups())
    figures["complaints"] = [line for line in gmsh.logger.get() if line.startswith(("Warning", "Error"))]
    gmsh.finalize()
    return figures


def of_meshio(path):
    mesh = meshio.read(path)
    figures = {"points": len(mesh.points)}
    for name, (_, own_name) in TYPES.items():
        figures[name] = sum(len(block.data) for block in mesh.cells if block.type == own_name)
    return figures


if __name__ == "__main__":
    stem, figures_path = sys.argv[1:]
    found = {"gmsh": of_gmsh(stem + ".msh")}
    for ending in ("msh", "su2", "lb8.ugrid"):
        found["meshio " + ending] = of_meshio(f"{stem}.{ending}")
    with open(figures_path, "w") as out:
        json.dump(found, out)
