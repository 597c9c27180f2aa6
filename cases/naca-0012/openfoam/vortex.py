"""Adds a vortex at the quarter chord to the free stream at the far field, and the pressure that goes with it.

Its circulation is that of the lift to be expected; evaluate.py holds the lift found against it. Source of the method:
J. L. Thomas, M. D. Salas, Far-Field Boundary Conditions for Transonic Lifting Solutions to the Euler Equations, AIAA
Journal 24 (1986).
"""

import math
import re

EXPECTED_LIFT = 1.08 / math.sin(math.radians(10))  # coefficient over the sine of the angle of attack
PATCHES = [f"farfield-{axis}-{end}" for axis in "xz" for end in ("min", "max")]


def face_centres(text, patch):
    begin = re.search(rf"\n\s*{patch}\s*\{{", text).end()
    head = re.compile(r"List<vector>\s*\d+\s*\(").search(text, begin)
    values = text[head.end() : text.index(";", head.end())]
    return [tuple(map(float, found)) for found in re.findall(r"\((\S+) (\S+) (\S+)\)", values)]


def listed(kind, values):
    return f"nonuniform List<{kind}> {len(values)}\n(\n" + "\n".join(values) + "\n)"


def main():
    with open("flow", encoding="ascii") as file:
        flow = file.read()
    stream = [float(value) for value in re.search(r"stream\s+\((.*)\);", flow)[1].split()]
    speed = math.hypot(*stream)
    circulation = 0.5 * speed * EXPECTED_LIFT * stream[2] / speed  # chord 1
    with open("0/C", encoding="ascii") as file:
        centres = file.read()
    velocities, pressures = {}, {}
    for patch in PATCHES:
        rows = []
        for x, _, z in face_centres(centres, patch):
            factor = circulation / (2 * math.pi * ((x - 0.25) ** 2 + z**2))
            rows.append((stream[0] + factor * z, stream[2] - factor * (x - 0.25)))
        velocities[patch] = listed("vector", [f"({u:.9g} 0 {w:.9g})" for u, w in rows])
        pressures[patch] = listed("scalar", [f"{0.5 * (speed**2 - u * u - w * w):.9g}" for u, w in rows])
    for field, kind, values in (("U", "freestreamVelocity", velocities), ("p", "freestreamPressure", pressures)):
        with open(f"0/{field}", encoding="ascii") as file:
            text = file.read()
        patches = "\n".join(f"    {p} {{ type {kind}; freestreamValue {v}; value {v}; }}" for p, v in values.items())
        with open(f"0/{field}", "w", encoding="ascii") as file:
            file.write(re.sub(r'    "farfield.*"    \{.*\}', lambda _: patches, text))


main()
