"""What Gmsh and meshio see in a mesh of ours, as JSON; Gmsh saves it again in its formats.

gmsh_figures.py MESH OUT_FOLDER FIGURES
"""

import json
import os
import sys

import gmsh
import meshio
import numpy

# Gmsh's types of elements by the names of ours.
CELLS = {"tetrahedron": 4, "pyramid": 7, "wedge": 6, "hexahedron": 5}
FACES = {"triangle": 2, "quad": 3}
MESHIO_NAMES = {"tetrahedron": "tetra"}


def of_gmsh(path, folder):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.logger.start()
    gmsh.open(path)
    figures = {"nodes": len(gmsh.model.mesh.getNodes()[0])}
    for name, code in {**CELLS, **FACES}.items():
        figures[name] = len(gmsh.model.mesh.getElementsByType(code)[0])
    # The determinant of each element's map at points of a rule of high order.
    for name, code in CELLS.items():
        if figures[name]:
            points, weights = gmsh.model.mesh.getIntegrationPoints(code, "Gauss4")
            determinants = numpy.reshape(gmsh.model.mesh.getJacobians(code, points)[1], (-1, len(weights)))
            figures[name + " smallest determinant"] = float(determinants.min())
            figures[name + " volume"] = float((determinants @ weights).sum())
    figures["groups"] = {}
    for dimension, group in gmsh.model.getPhysicalGroups():
        n = 0
        for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, group):
            n += sum(len(tags) for tags in gmsh.model.mesh.getElements(dimension, entity)[1])
        figures["groups"][gmsh.model.getPhysicalName(dimension, group)] = n
    for version in (2.2, 4.1):
        for binary in (0, 1):
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            gmsh.write(os.path.join(folder, f"{version}-{binary}.msh"))
    gmsh.option.setNumber("Mesh.BdfFieldFormat", 2)  # 16 characters
    gmsh.write(os.path.join(folder, "again.bdf"))
    figures["complaints"] = [line for line in gmsh.logger.get() if not line.startswith("Info")]
    gmsh.finalize()
    return figures


def of_meshio(path):
    mesh = meshio.read(path)
    figures = {"nodes": len(mesh.points)}
    for name in {**CELLS, **FACES}:
        own_name = MESHIO_NAMES.get(name, name)
        figures[name] = sum(len(block.data) for block in mesh.cells if block.type == own_name)
    figures["groups"] = sorted(mesh.field_data)
    return figures


if __name__ == "__main__":
    mesh_path, out_folder, figures_path = sys.argv[1:]
    with open(figures_path, "w") as out:
        json.dump({"gmsh": of_gmsh(mesh_path, out_folder), "meshio": of_meshio(mesh_path)}, out)
