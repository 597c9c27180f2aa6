"""Makes the surface of this case: a NACA 0012 section as a wing between two planes, open at both.

Patches: upper, lower. The section is the one of NASA's turbulence modelling resource, with its sharp trailing edge.
"""

import math

SPAN = 0.1
STRIPS = 3
STATIONS = 72
LEADING = 0.004  # length of the triangles at the leading edge, over the chord
TRAILING = 0.006


def thickness(x):
    """Half the thickness at x; both are over the chord."""
    polynomial = ((-0.105174606 * x + 0.291984971) * x - 0.357907906) * x - 0.127125232
    return 0.594689181 * (0.298222773 * math.sqrt(x) + polynomial * x)


def arc_of(x):
    """Points of one side, dense, and their distance along it from the leading edge."""
    arc = [0.0]
    for (x0, z0), (x1, z1) in zip(x, x[1:]):
        arc.append(arc[-1] + math.hypot(x1 - x0, z1 - z0))
    return arc


def spread(length):
    """Vinokur's distribution along a length with given steps at both ends."""
    first, last = LEADING * STATIONS / length, TRAILING * STATIONS / length
    middle = 1 / math.sqrt(first * last)
    low, high = 1e-6, 50.0
    for _ in range(200):
        delta = (low + high) / 2
        low, high = (delta, high) if math.sinh(delta) / delta < middle else (low, delta)
    ratio = math.sqrt(last / first)
    positions = []
    for i in range(STATIONS + 1):
        even = 0.5 * (1 + math.tanh(delta * (i / STATIONS - 0.5)) / math.tanh(delta / 2))
        positions.append(length * even / (ratio + (1 - ratio) * even))
    return positions


def side():
    """Points (x, z >= 0) of the upper side, from the leading to the trailing edge."""
    dense = [((i / 20000) ** 2, thickness((i / 20000) ** 2)) for i in range(20001)]
    arc = arc_of(dense)
    points, k = [(0.0, 0.0)], 0
    for s in spread(arc[-1])[1:-1]:
        while arc[k + 1] < s:
            k += 1
        t = (s - arc[k]) / (arc[k + 1] - arc[k])
        x = dense[k][0] + t * (dense[k + 1][0] - dense[k][0])
        points.append((x, thickness(x)))
    return points + [(1.0, 0.0)]


def main():
    upper = side()
    loop = upper + [(x, -z) for x, z in upper[-2:0:-1]]
    with open("naca-0012.obj", "w", encoding="ascii") as out:
        for j in range(STRIPS + 1):
            out.writelines(f"v {x:.12g} {SPAN * j / STRIPS:.12g} {z:.12g}\n" for x, z in loop)
        for patch, first, last in (("upper", 0, STATIONS), ("lower", STATIONS, len(loop))):
            out.write(f"g {patch}\n")
            for j in range(STRIPS):
                for i in range(first, last):
                    a, b = (j * len(loop) + k % len(loop) + 1 for k in (i, i + 1))
                    c, d = a + len(loop), b + len(loop)
                    if (i + j) % 2:  # diagonals in turn: neither way along the span is favoured
                        out.write(f"f {a} {b} {d}\nf {a} {d} {c}\n")
                    else:
                        out.write(f"f {a} {b} {c}\nf {b} {d} {c}\n")


main()
