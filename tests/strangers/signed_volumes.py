"""Prints the volumes of the cells of a mesh as meshio reads it, and the volume that its faces enclose.

One line for each type: its name, cells, smallest and largest volume, their sum. Positive where the nodes stand as in
VTK's figures but for wedges, which count as positive the other way round. Last the flux of x/3 through the faces.
"""

import sys

import meshio
import numpy as np

FACES = {
    "tetra": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
    "pyramid": [[0, 3, 2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    "wedge": [[0, 2, 1], [3, 4, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]],
    "hexahedron": [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
}


def flux(points):
    """Of x/3 through polygons, (n, corners, 3), divided round their middles."""
    middle = points.mean(axis=1)
    total = np.zeros(len(points))
    for k in range(points.shape[1]):
        total += np.einsum("ij,ij->i", middle, np.cross(points[:, k], np.roll(points, -1, axis=1)[:, k])) / 6
    return total


mesh = meshio.read(sys.argv[1])
enclosed = 0.0
for block in mesh.cells:
    if block.type in FACES:
        volume = sum(flux(mesh.points[block.data[:, face]]) for face in FACES[block.type])
        print(block.type, len(volume), repr(volume.min()), repr(volume.max()), repr(volume.sum()))
    else:
        enclosed += flux(mesh.points[block.data]).sum()
print("faces", repr(enclosed))
