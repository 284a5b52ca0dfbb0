"""Random scenes of rigid blocks, many of them near the border between standing and falling."""
import math
import random

BEAM = 0.1  # height of the beam [m]


def box(x, z, length, height):
    return [(x, z), (x + length, z), (x + length, z + height), (x, z + height)]


def bond(r):
    """Courses whose units are cut anywhere."""
    length, n, h = r.uniform(0.4, 1.6), r.randint(1, 6), r.uniform(0.1, 0.3)
    out = []
    for course in range(n):
        cuts = [0.0, length]
        while max(b - a for a, b in zip(cuts, cuts[1:])) > 0.5:
            a, b = max(zip(cuts, cuts[1:]), key=lambda c: c[1] - c[0])
            cuts = sorted(cuts + [round(a + (b - a) * r.uniform(0.35, 0.65), 4)])
        out += [box(a, course * h, b - a, h) for a, b in zip(cuts, cuts[1:])]
    return out


def corbel(r):
    """A stack of units, each farther out than the one below it: the classical overhang."""
    n, length, h = r.randint(2, 7), r.uniform(0.3, 0.8), r.uniform(0.1, 0.3)
    most = length / n  # of equal steps, beyond which the blocks above the lowest turn about its edge
    step = most * r.choice((r.uniform(0.3, 0.9), r.uniform(0.9, 1.1), r.uniform(1.1, 1.6)))
    step = min(step, 0.9 * length)
    return [box(i * step, i * h, length, h) for i in range(n)]


def stepped(r):
    """Courses of two units each, of which every one may be set off: drawn walls with overhangs."""
    n, length, h = r.randint(3, 6), r.uniform(0.5, 1.0), r.uniform(0.12, 0.25)
    out, x = [], 2.0
    for i in range(n):
        cut = length * r.uniform(0.35, 0.65)
        out += [box(x, i * h, cut, h), box(x + cut, i * h, length - cut, h)]
        x += r.uniform(-0.1, 0.25) * length
    return out


def leaning(r):
    """A stack whose beds are inclined, on a wedge."""
    n, length, h = r.randint(1, 6), r.uniform(0.3, 0.9), r.uniform(0.15, 0.4)
    a = math.radians(r.uniform(3, 35))
    c, s = math.cos(a), math.sin(a)
    at = lambda u, v: (u * c - v * s + n * h * s + 0.05, u * s + v * c + 0.05)
    x0, x1 = at(0, 0), at(length, 0)
    wedge = [(x0[0], 0.0), (x1[0], 0.0), x1, x0]
    return [wedge] + [[at(0, i * h), at(length, i * h), at(length, (i + 1) * h), at(0, (i + 1) * h)] for i in range(n)]


def arch(r):
    """Semicircular or flatter, of voussoirs on blocks that stand on the floor; the least thickness of a half circle is 0.1075 R."""
    n = r.randint(5, 17)
    radius = r.uniform(0.8, 2.0)
    thickness = radius * r.choice((r.uniform(0.05, 0.095), r.uniform(0.095, 0.125), r.uniform(0.125, 0.3)))
    inner, outer = radius - thickness / 2, radius + thickness / 2
    springs = math.radians(r.choice((0, 0, r.uniform(5, 40))))
    base = 0.1 - inner * math.sin(springs)
    middle = outer + 0.5
    at = lambda rad, t: (middle + rad * math.cos(t), base + rad * math.sin(t))
    turn = [springs + (math.pi - 2 * springs) * i / n for i in range(n + 1)]
    stones = [[at(inner, a), at(outer, a), at(outer, b), at(inner, b)] for a, b in zip(turn, turn[1:])]
    right = [(at(inner, turn[0])[0] - 0.2, 0.0), (at(outer, turn[0])[0] + 0.4, 0.0),
             (at(outer, turn[0])[0] + 0.4, at(outer, turn[0])[1]), at(outer, turn[0]), at(inner, turn[0])]
    left = [(2 * middle - x, z) for x, z in reversed(right)]
    return [right, left] + stones


def rubble(r):
    """Quadrilaterals between courses that go up and down and head joints that lean; the top is level."""
    rows, cols = r.randint(2, 5), r.randint(2, 5)
    w, h = r.uniform(0.2, 0.35), r.uniform(0.15, 0.3)
    wild = r.uniform(0.1, 0.35)
    level = lambda i: i * h + (0 if i in (0, rows) else r.uniform(-wild, wild) * h)
    # Each course has head joints of its own, so that a bed has corners where either has one.
    beds = []
    heads = [[0.0] + [(j + (0.5 if i % 2 else 0.0) + r.uniform(-0.2, 0.2)) * w for j in range(1, cols)] + [cols * w] for i in range(rows)]
    lean = r.uniform(-0.25, 0.25)
    for i in range(rows + 1):
        xs = {0.0, cols * w}
        if i > 0:
            xs |= set(heads[i - 1][1:-1])
        if i < rows:
            xs |= set(heads[i][1:-1])
        xs = sorted(xs)
        keep = [xs[0]]
        for x in xs[1:]:
            if x - keep[-1] > 0.02 or x == xs[-1]:
                keep.append(x)
        beds.append([(x, level(i)) for x in keep])

    def between(bed, a, b):
        near = lambda x: min(bed, key=lambda c: abs(c[0] - x))[0]
        return [c for c in bed if near(a) <= c[0] <= near(b)]

    out = []
    for i in range(rows):
        for a, b in zip(heads[i], heads[i][1:]):
            low, high = between(beds[i], a, b), between(beds[i + 1], a, b)
            out.append(low + high[::-1])
    shear = lambda c: (c[0] + lean * c[1] + 2.0, c[1])
    return [[shear(c) for c in o] for o in out]


def wedge_arch(r):
    """A flat arch of an odd number of wedges between two abutments: it slides out where friction is small."""
    n, span, h = r.choice((3, 5, 7)), r.uniform(0.5, 1.2), r.uniform(0.15, 0.4)
    tilt = math.radians(r.uniform(4, 20))
    deep = r.uniform(0.3, 1.0)
    z0 = 0.3
    lean = [math.tan(tilt) * (2 * i / n - 1) for i in range(n + 1)]
    low = [deep + span * i / n for i in range(n + 1)]
    out = [[(0, 0), (deep, 0), (deep, z0), (low[0] + lean[0] * h, z0 + h), (0, z0 + h)],
           [(low[-1], 0), (low[-1] + deep, 0), (low[-1] + deep, z0 + h), (low[-1] + lean[-1] * h, z0 + h), (low[-1], z0)]]
    for i in range(n):
        out.append([(low[i], z0), (low[i + 1], z0), (low[i + 1] + lean[i + 1] * h, z0 + h), (low[i] + lean[i] * h, z0 + h)])
    return out


KINDS = {"bond": bond, "corbel": corbel, "stepped": stepped, "leaning": leaning, "arch": arch, "rubble": rubble,
         "wedges": wedge_arch}
THRUST = ("arch", "wedges", "leaning")  # faces of every direction carry


def scene(number):
    """Scene of that number: outlines [m] and everything that a study needs."""
    r = random.Random(f"standing {number}")
    kind = list(KINDS)[number % len(KINDS)]
    outlines = KINDS[kind](r)
    top = max(z for o in outlines for _, z in o)
    level_top = kind in ("bond", "corbel", "stepped", "rubble", "wedges")
    beam = level_top and r.random() < 0.5
    return {
        "number": number, "kind": kind, "outlines": outlines, "top": top, "beam": beam,
        "thickness": round(r.uniform(0.15, 0.4), 3),
        "density": round(r.uniform(1800, 2600)),
        "stiffness": 10 ** r.uniform(9, 15),
        "friction_deg": round(r.uniform(10, 60), 2),
        "stress": r.choice((0.0, 10 ** r.uniform(3, 5.7))) if beam else 0.0,
        "fidelity": r.choice(("rigid", "simple")), "kinematics": r.choice(("small", "finite")),
    }
