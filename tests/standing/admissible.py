"""Rigid-block limit analysis: whether contact forces exist that hold every block under its weight and the vertical load.

Each straight piece where two outlines touch has a contact point at either end. A point carries what its cone of friction
holds, N >= 0 and |T| <= N tan(phi), and no moment. The blocks are in balance if the linear program

    least   sum |force that is missing|    such that   contact forces + missing force = -load    on every block

has the optimum zero. With friction that dilates (normality) this is the limit theorem: the wall stands if and only if the
optimum is zero. Coulomb friction does not dilate. A wall without admissible forces comes down with it too; a wall with them
stands in at least one state of stress, which need not be the one that its way of building leads to.
"""
import math

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix

TOUCHES = 1e-7  # [m]


def area_and_centre(outline):
    """Of a polygon given counter-clockwise: area [m2] and centre of gravity [m]."""
    x, z = np.array(outline).T
    x1, z1 = np.roll(x, -1), np.roll(z, -1)
    cross = x * z1 - x1 * z
    a = cross.sum() / 2
    return a, (((x + x1) * cross).sum() / (6 * a), ((z + z1) * cross).sum() / (6 * a))


def sides(outlines):
    """Block, ends, unit direction of every side; the inside is to the left of it."""
    for b, outline in enumerate(outlines):
        for p, q in zip(outline, outline[1:] + outline[:1]):
            length = math.hypot(q[0] - p[0], q[1] - p[1])
            yield b, p, ((q[0] - p[0]) / length, (q[1] - p[1]) / length), length


def faces(outlines):
    """(block, other block or -1 for the floor, end, end, unit tangent); the block is to the left of the tangent."""
    every = list(sides(outlines))
    for i, (a, p, t, length) in enumerate(every):
        if abs(p[1]) < TOUCHES and t[0] > 1 - 1e-12:
            yield a, -1, p, (p[0] + t[0] * length, p[1]), t
        for b, q, s, other in every[i + 1:]:
            if a == b or t[0] * s[0] + t[1] * s[1] > -1 + 1e-9:
                continue
            dx, dz = q[0] - p[0], q[1] - p[1]
            if abs(dx * -t[1] + dz * t[0]) > TOUCHES:
                continue
            end = dx * t[0] + dz * t[1]
            low, high = max(0.0, end - other), min(length, end)
            if high - low > TOUCHES:
                yield a, b, (p[0] + t[0] * low, p[1] + t[1] * low), (p[0] + t[0] * high, p[1] + t[1] * high), t


def missing_force(outlines, loads, friction, inset=0.0, held=None, heads=True):
    """Force that admissible contact forces leave unbalanced, as a share of all loads [-]; 0: the wall can stand.

    outlines  corners of every block [m], counter-clockwise, in contact along whole or parts of their sides
    loads     (horizontal, vertical) force on every block at its centre of gravity, or any number of
              (horizontal, vertical, x, z), [N], up and to the right positive
    friction  tan(phi) of a face between two blocks, as a function of both (-1: the floor)
    inset     share of its length by which the points of a face lie within its ends [-]
    heads     whether faces steeper than 45 degrees carry anything
    held      (block, x, z) of a point that something holds horizontally, as the drive holds the beam
    """
    centre = [area_and_centre(o)[1] for o in outlines]
    span = max(max(c) for o in outlines for c in o)
    rows, columns, values = [], [], []
    column = 0

    def push(block, x, z, fx, fz):
        if block < 0:
            return
        moment = ((x - centre[block][0]) * fz - (z - centre[block][1]) * fx) / span
        for row, value in enumerate((fx, fz, moment)):
            rows.append(3 * block + row)
            columns.append(column)
            values.append(value)

    for a, b, p, q, t in faces(outlines):
        if not heads and abs(t[1]) > abs(t[0]):
            continue
        n, mu = (-t[1], t[0]), friction(a, b)  # the other block presses along n
        for s in (inset, 1 - inset):
            x, z = p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])
            for side in (mu, -mu):
                fx, fz = n[0] + side * t[0], n[1] + side * t[1]
                push(a, x, z, fx, fz)
                push(b, x, z, -fx, -fz)
                column += 1
    if held:
        for direction in (1.0, -1.0):
            push(*held, direction, 0.0)
            column += 1
    count = 3 * len(outlines)
    wanted = np.zeros(count)
    scale = 0.0
    for block, given in enumerate(loads):
        for fx, fz, x, z in given:
            wanted[3 * block] -= fx
            wanted[3 * block + 1] -= fz
            wanted[3 * block + 2] -= ((x - centre[block][0]) * fz - (z - centre[block][1]) * fx) / span
            scale += abs(fz)
    for sign in (1.0, -1.0):
        rows += range(count)
        columns += range(column, column + count)
        values += [sign] * count
        column += count
    cost = np.zeros(column)
    cost[-2 * count:] = 1.0
    best = linprog(cost, A_eq=coo_matrix((values, (rows, columns)), shape=(count, column)).tocsr(), b_eq=wanted / scale,
                   method="highs")
    if best.status != 0:
        raise RuntimeError("linear program: " + best.message)
    return best.fun
