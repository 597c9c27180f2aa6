"""Makes the surface of this case: a box round the fluid, its floor in strips that are short at the leading edge.

Patches: upstream (floor before the plate), plate, inlet, outlet, top, side-left, side-right.
"""

LENGTH = 1.0  # of the plate, from x = 0
UPSTREAM = 0.3  # from the inlet to the leading edge
HEIGHT = 0.4
WIDTH = 0.04
STRIPS = 2  # across the width
FIRST = 0.003  # length of the triangles at the leading edge
GROWTH = 1.15  # of their lengths
LARGEST = 0.02  # length of the triangles away from it


def stations(length):
    """Distances from the leading edge, geometric up to the largest length, then even, ending at `length`."""
    steps = []
    while sum(steps) < length:
        steps.append(min(FIRST * GROWTH ** len(steps), LARGEST))
    scale = length / sum(steps)
    positions = [0.0]
    for step in steps:
        positions.append(positions[-1] + step * scale)
    positions[-1] = length
    return positions


class Surface:
    """Points, numbered once, and triangles by patch."""

    def __init__(self):
        self.points = {}
        self.patches = {}

    def add(self, patch, *corners):
        numbers = [self.points.setdefault(corner, len(self.points) + 1) for corner in corners]
        self.patches.setdefault(patch, []).append(numbers)

    def add_strip(self, patch, first, second):
        """Triangles between two rows of points, the second one on the left of the first."""
        i = j = 0
        while i + 1 < len(first) or j + 1 < len(second):
            if j + 1 == len(second) or (i + 1 < len(first) and (i + 1) * (len(second) - 1) <= (j + 1) * (len(first) - 1)):
                self.add(patch, first[i], first[i + 1], second[j])
                i += 1
            else:
                self.add(patch, first[i], second[j + 1], second[j])
                j += 1

    def write(self, name):
        with open(name, "w", encoding="ascii") as out:
            for x, y, z in self.points:
                out.write(f"v {x:.9g} {y:.9g} {z:.9g}\n")
            for patch, triangles in self.patches.items():
                out.write(f"g {patch}\n")
                out.writelines("f {} {} {}\n".format(*triangle) for triangle in triangles)


def row(xs, y, z):
    return [(x, y, z) for x in xs]


def main():
    before = [-x for x in reversed(stations(UPSTREAM))]
    along = stations(LENGTH)
    floor = before[:-1] + along
    n_top = round((LENGTH + UPSTREAM) / (2 * LARGEST))
    ceiling = [-UPSTREAM + (LENGTH + UPSTREAM) * i / n_top for i in range(n_top)] + [LENGTH]
    across = [WIDTH * j / STRIPS for j in range(STRIPS)] + [WIDTH]

    surface = Surface()
    for low, high in zip(across, across[1:]):  # normals point out of the fluid
        surface.add_strip("upstream", row(before, low, 0.0)[::-1], row(before, high, 0.0)[::-1])
        surface.add_strip("plate", row(along, low, 0.0)[::-1], row(along, high, 0.0)[::-1])
    surface.add_strip("top", row(ceiling, 0.0, HEIGHT), row(ceiling, WIDTH, HEIGHT))
    surface.add_strip("side-right", row(floor, 0.0, 0.0), row(ceiling, 0.0, HEIGHT))
    surface.add_strip("side-left", row(floor, WIDTH, 0.0)[::-1], row(ceiling, WIDTH, HEIGHT)[::-1])
    low = [(y, 0.0) for y in across]
    high = [(0.0, HEIGHT), (WIDTH, HEIGHT)]
    for patch, x, turn in (("outlet", LENGTH, 1), ("inlet", -UPSTREAM, -1)):
        first = [(x, y, z) for y, z in low][::turn]
        second = [(x, y, z) for y, z in high][::turn]
        surface.add_strip(patch, first, second)
    surface.write("flat-plate.obj")


main()
