"""Writes what a set-up needs of the flow, as a dictionary for OpenFOAM, from a case file and the report of its mesh.

usage: python3 flow.py CASE.toml REPORT.json ITERATIONS [ANGLE] > flow

The free stream flies ANGLE degrees upwards (in x and z). Its turbulence is the one of NASA's turbulence modelling
resource, k = 2.25e-7 U^2 and nut = 0.009 nu. The wall has omega = 60 nu / (beta1 h1^2) with the height h1 of the first
layer (Menter 1994, AIAA Journal 32); OpenFOAM's omegaWallFunction would hold omega in the first cell instead.
"""

import json
import math
import sys
import tomllib

BETA_1 = 0.075


def first_height(report):
    """The median of the wall patches; they must agree, as there is one omega for all."""
    heights = [p["first_height"]["median"] for p in report["patches"].values() if p.get("first_height")]
    if max(heights) > 1.01 * min(heights):
        sys.exit("flow.py: walls differ in their first heights; give each its omega")
    return heights[0]


def main():
    case_file, report_file, iterations = sys.argv[1:4]
    angle = math.radians(float(sys.argv[4]) if len(sys.argv) > 4 else 0.0)
    with open(case_file, "rb") as file:
        flow = tomllib.load(file)["flow"]
    with open(report_file, encoding="utf-8") as file:
        height = first_height(json.load(file))
    speed, viscosity = flow["velocity"], flow["kinematic_viscosity"]
    along = (math.cos(angle), math.sin(angle))
    k = 2.25e-7 * speed**2
    print(f"iterations {iterations};")
    print(f"velocity   {speed:.9g};")
    print(f"viscosity  {viscosity:.9g};")
    print(f"stream     ({speed * along[0]:.9g} 0 {speed * along[1]:.9g});")
    print(f"drag       ({along[0]:.9g} 0 {along[1]:.9g});")
    print(f"lift       ({-along[1]:.9g} 0 {along[0]:.9g});")
    print(f"k          {k:.9g};")
    print(f"omega      {k / (0.009 * viscosity):.9g};")
    print(f"omegaWall  {60 * viscosity / (BETA_1 * height**2):.9g};")


main()
