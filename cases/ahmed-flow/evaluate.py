"""Holds the flow round the body against what was asked of its mesh, and prints y+ by patch.

usage: python3 evaluate.py
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../openfoam"))
import foam

ATTACHED = ("roof", "side-right", "underbody")  # where a plate's friction stands for the body's
PATCHES = ("front", *ATTACHED, "slant", "base")


def main():
    flow = foam.Flow("out/flow")
    checks = foam.Checks()
    asked = foam.asked_y_plus()
    print(f"{foam.cells()} cells, {flow.seconds():.0f} s; y+: {foam.spread(foam.y_plus(flow, *PATCHES))}")
    for patch in PATCHES:
        print(f"  {patch}: {foam.spread(foam.y_plus(flow, patch))}")
    for patch in ATTACHED:
        checks.expect(f"mean y+ over the asked one, {patch}", foam.y_plus(flow, patch).mean() / asked, 0.8, 1.2)
    checks.expect("greatest y+", foam.y_plus(flow, *PATCHES).max(), 0, 3)
    # A coarse mesh and first-order turbulence: the experiment's 0.285 is not to be had.
    checks.expect("drag", flow.coefficients()[-1][1], 0.25, 0.5)
    checks.expect_residuals(flow, 3, ("Ux", "Uy", "Uz", "p", "k", "omega"))
    checks.finish()


main()
