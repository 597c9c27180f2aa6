"""Holds the flow over the plate against correlations of skin friction and the law of the wall.

usage: python3 evaluate.py [--plots FOLDER]
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../openfoam"))
import foam

KARMAN, INTERCEPT = 0.41, 5.0  # of the law of the wall
STATION = 0.9  # where the profile is taken


def karman_schoenherr(re_theta):
    """Skin friction over the Reynolds number of the momentum thickness, which knows no origin of the layer."""
    log = np.log10(re_theta)
    return 1 / (17.08 * log**2 + 25.11 * log + 6.012)


CORRELATIONS = {  # over the distance from a leading edge at which the layer is turbulent at once
    "Prandtl, 0.0592 Re^-1/5": lambda re: 0.0592 * re**-0.2,
    "Schlichting, (2 log Re - 0.65)^-2.3": lambda re: (2 * np.log10(re) - 0.65) ** -2.3,
    "White, 0.455 / ln^2(0.06 Re)": lambda re: 0.455 / np.log(0.06 * re) ** 2,
}


class Plate:
    """Skin friction along the plate, from the leading edge on."""

    def __init__(self, flow):
        self.flow = flow
        self.speed, self.viscosity = flow.constant("velocity"), flow.constant("viscosity")
        x = flow.wall("C", "plate")[:, 0]
        order = np.argsort(x)
        self.x = x[order]
        self.friction = -flow.wall("wallShearStress", "plate")[order, 0] / (0.5 * self.speed**2)
        self.re = self.speed * self.x / self.viscosity
        self.y_plus = foam.y_plus(flow, "plate")[order]
        # Without a pressure gradient the momentum thickness is half the drag so far.
        steps = 0.5 * (self.friction[1:] + self.friction[:-1]) * np.diff(self.x)
        drag = self.friction[0] * self.x[0] + np.concatenate([[0.0], np.cumsum(steps)])
        self.re_theta = self.speed * drag / 2 / self.viscosity

    def profile(self):
        """y+ and u+ of the cells above one station of the plate."""
        centres, velocity = self.flow.inside("C"), self.flow.inside("U")
        nearest = self.x[np.argmin(abs(self.x - STATION))]
        above = abs(centres[:, 0] - nearest) < 1e-6
        friction = np.sqrt(0.5 * np.interp(nearest, self.x, self.friction)) * self.speed
        order = np.argsort(centres[above, 2])
        return centres[above, 2][order] * friction / self.viscosity, velocity[above, 0][order] / friction


def law_of_the_wall(y):
    return np.log(y) / KARMAN + INTERCEPT


def draw(plate, folder):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    y, u = plate.profile()
    figure, axes = pyplot.subplots(figsize=(6, 4), dpi=90)
    low, high = np.geomspace(0.3, 12, 50), np.geomspace(8, 3000, 50)
    axes.semilogx(low, low, "k--", lw=1, label="u⁺ = y⁺")
    axes.semilogx(high, law_of_the_wall(high), "k-", lw=1, label=f"u⁺ = ln(y⁺) / {KARMAN} + {INTERCEPT}")
    axes.semilogx(y, u, "o", ms=3, color="tab:blue", label=f"solved, x = {STATION}, cell centres")
    axes.set(xlabel="y⁺", ylabel="u⁺", xlim=(0.3, 2e4), ylim=(0, 32))
    axes.legend(frameon=False)
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "solver-plate-profile.png"))

    figure, axes = pyplot.subplots(figsize=(6, 4), dpi=90)
    axes.plot(plate.x, plate.friction, "tab:blue", lw=2, label="solved, k–ω SST")
    axes.plot(plate.x, karman_schoenherr(plate.re_theta), "k-", lw=1, label="Kármán–Schoenherr (of Re_θ)")
    for (name, law), style in zip(CORRELATIONS.items(), ("k--", "k-.", "k:")):
        axes.plot(plate.x, law(plate.re), style, lw=1, label=name)
    axes.set(xlabel="x [m]", ylabel="skin friction coefficient", xlim=(0, 1), ylim=(0.002, 0.006))
    axes.legend(frameon=False)
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "solver-plate-friction.png"))


def main():
    flow = foam.Flow("out/flow")
    plate = Plate(flow)
    rear = plate.x > 0.5
    checks = foam.Checks()
    print(f"{foam.cells()} cells, {flow.seconds():.0f} s; y+ on the plate: {foam.spread(plate.y_plus)}")
    for name, law in CORRELATIONS.items():
        ratio = (plate.friction / law(plate.re))[rear]
        print(f"skin friction over {name}, rear half: {ratio.min():.3f} to {ratio.max():.3f}")
    ratio = (plate.friction / karman_schoenherr(plate.re_theta))[rear]
    checks.expect("skin friction over Karman-Schoenherr, rear half, least", ratio.min(), 0.95, 1.05)
    checks.expect("skin friction over Karman-Schoenherr, rear half, greatest", ratio.max(), 0.95, 1.05)
    asked = foam.asked_y_plus()
    checks.expect("y+ over the asked one, rear half, least", plate.y_plus[rear].min() / asked, 0.8, 1.2)
    checks.expect("y+ over the asked one, rear half, greatest", plate.y_plus[rear].max() / asked, 0.8, 1.2)
    y, u = plate.profile()
    inner, outer = y < 4, (y > 40) & (y < 400)
    checks.expect("u+ over y+ below 4, greatest deviation", abs(u[inner] / y[inner] - 1).max(), 0, 0.05)
    checks.expect("u+ off the logarithmic law, 40 to 400", abs(u - law_of_the_wall(y))[outer].max(), 0, 1.0)
    checks.expect_residuals(flow, 3, ("Ux", "p", "k", "omega"))
    if "--plots" in sys.argv:
        draw(plate, sys.argv[sys.argv.index("--plots") + 1])
    checks.finish()


main()
