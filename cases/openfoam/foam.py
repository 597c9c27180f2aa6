"""Reads what OpenFOAM's simpleFoam left in a folder: fields at the walls and inside, residuals, forces."""

import json
import os
import re
import sys

import numpy as np


def _numbers(text, start):
    """The list of scalars or vectors that begins at or after `start`."""
    head = re.compile(r"List<(\w+)>\s*(\d+)\s*\(").search(text, start)
    values = text[head.end() : text.index(";", head.end())].replace("(", " ").replace(")", " ")
    numbers = np.array(values.split(), float)
    return numbers.reshape(int(head[2]), 3) if head[1] == "vector" else numbers


class Flow:
    """The last time of a run."""

    def __init__(self, folder):
        self.folder = folder
        times = [name for name in os.listdir(folder) if re.fullmatch(r"\d+", name) and name != "0"]
        if not times:
            sys.exit(f"{folder}: the solver did not come to its end")
        self.time = max(times, key=int)
        with open(os.path.join(folder, "flow"), encoding="ascii") as file:
            self.constants = dict(re.findall(r"(\w+)\s+([^;]+);", file.read()))

    def constant(self, name):
        return float(self.constants[name])

    def _text(self, field):
        with open(os.path.join(self.folder, self.time, field), encoding="ascii") as file:
            return file.read()

    def inside(self, field):
        return _numbers(self._text(field), 0)

    def wall(self, field, *patches):
        """Values on the faces of patches; the field must have a list of them there."""
        text = self._text(field)
        boundary = text.index("boundaryField")
        found = []
        for patch in patches:
            entry = re.compile(rf"\n\s*{re.escape(patch)}\s*\{{([^}}]*)\}}").search(text, boundary)
            if entry is None or "List<" not in entry[1]:
                sys.exit(f"{self.folder}: {field} has no list of values on {patch}")
            found.append(_numbers(entry[1], 0))
        return np.concatenate(found)

    def first_cells(self, field, *patches):
        """Values in the cells that touch patches, in the order of their faces."""
        mesh = os.path.join(self.folder, "constant/polyMesh")
        with open(os.path.join(mesh, "owner"), "rb") as file:
            owner = file.read()
        head = re.search(rb"\n(\d+)\s*\(", owner[owner.index(b"}") :])
        first = owner.index(b"}") + head.end()
        cell = np.frombuffer(owner, "<i4", int(head[1]), first)
        with open(os.path.join(mesh, "boundary"), encoding="ascii") as file:
            boundary = file.read()
        faces = []
        for patch in patches:
            entry = re.search(rf"\n\s*{re.escape(patch)}\s*\{{([^}}]*)\}}", boundary)[1]
            n, start = (int(re.search(rf"{key}\s+(\d+);", entry)[1]) for key in ("nFaces", "startFace"))
            faces.append(np.arange(start, start + n))
        return self.inside(field)[cell[np.concatenate(faces)]]

    def residuals(self):
        """Initial residuals of each equation, by its name, iteration by iteration."""
        found = {}
        with open(os.path.join(self.folder, "log.simpleFoam"), encoding="ascii") as file:
            for name, value in re.findall(r"Solving for (\w+), Initial residual = (\S+),", file.read()):
                found.setdefault(name, []).append(float(value))
        return found

    def seconds(self):
        with open(os.path.join(self.folder, "log.simpleFoam"), encoding="ascii") as file:
            return float(re.findall(r"ExecutionTime = (\S+) s", file.read())[-1])

    def coefficients(self):
        """Iteration, drag, side force, lift and so on, as forceCoeffs writes them: one row an iteration."""
        return np.loadtxt(os.path.join(self.folder, "postProcessing/forceCoeffs/0/coefficient.dat"), ndmin=2)


def y_plus(flow, *patches):
    """Of the first node, as nearwall means it: OpenFOAM has that of the centre of the first cell, half as high."""
    return 2 * flow.wall("yPlus", *patches)


def asked_y_plus(case_file="case.toml"):
    import tomllib

    with open(case_file, "rb") as file:
        return tomllib.load(file)["layers"]["y_plus"]


def cells(report="out/report.json"):
    with open(report, encoding="utf-8") as file:
        return sum(json.load(file)["cells"].values())


def spread(values):
    """Mean, least, 5 %, 50 %, 95 % and greatest, as a row of a table."""
    low, middle, high = np.percentile(values, (5, 50, 95))
    return f"mean {values.mean():.3f} min {values.min():.3f} p05 {low:.3f} p50 {middle:.3f} p95 {high:.3f} max {values.max():.3f}"


class Checks:
    """Figures held against their ranges: prints each, and exits with 1 at the end if one was outside."""

    def __init__(self):
        self.failed = 0

    def expect(self, what, value, low, high):
        is_inside = bool(low <= value <= high)
        self.failed += not is_inside
        print(f"{what}: {value:.5g} ({'in' if is_inside else 'NOT IN'} {low:.5g} to {high:.5g})")

    def expect_residuals(self, flow, orders, equations):
        """Each equation's residual must have fallen by so many orders from its greatest one."""
        for name, values in flow.residuals().items():
            if name in equations:
                self.expect(f"fall of the residual of {name} [orders]", np.log10(max(values) / values[-1]), orders, 99)

    def finish(self):
        sys.exit(1 if self.failed else 0)
