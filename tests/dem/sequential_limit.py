#!/usr/bin/python3
"""sequential_limit.py [STEP] [--wall 1 to 6 | --block] [--steps N]   load factor of a wall of rigid blocks by linear programming; needs scipy.

The walls of Ferris and Tin-Loi (units of 0.4 x 0.175 m, friction 0.65; 3 to 6 have openings), default 1; or one block of 0.2 x 1.0 m, whose
load factor tan(alpha - th) is exact: zero at 0.19612 m. Horizontal forces are proportional to weight. In each step of STEP metres
(default 1e-3) of the centre of gravity, the blocks make the displacements that raise the weight least while every contact point keeps
    gap + normal displacement >= friction x |tangential displacement|.
The gaps are those of the displaced blocks: dilation of one step is taken up by the next. So the first step gives the limit with associated
friction, and the steps after it, as STEP goes to 0, those of friction that does not dilate.
Prints the displacement of the top right corner [m] and the load factor [-]: of the first N steps, or on the way until no force is left.
"""
import argparse

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix

from ferris_tin_loi import FRICTION, HEIGHT, WALLS, blocks, courses

NEAR = 0.03  # [m]; faces farther apart cannot meet within a step
arguments = argparse.ArgumentParser()
arguments.add_argument("step", nargs="?", type=float, default=1e-3)
arguments.add_argument("--wall", type=int, choices=WALLS, default=1)
arguments.add_argument("--block", action="store_true")
arguments.add_argument("--steps", type=int)
asked = arguments.parse_args()
step, height, friction = asked.step, HEIGHT, FRICTION
rows = courses(asked.wall)
if asked.block:
    height, friction, rows = 1.0, 10.0, [[0.2]]

course, left, right_edge = (np.array(values) for values in zip(*blocks(rows)))
x, half = (left + right_edge) / 2, (right_edge - left) / 2
z = (course + 0.5) * height
turned = np.zeros(len(x))  # clockwise [rad]
weight = half / half.sum()


def axes(i):
    c, s = np.cos(turned[i]), np.sin(turned[i])
    return np.array([c, -s]), np.array([s, c])


def corner(i, right, up):
    along, upward = axes(i)
    return np.array([x[i], z[i]]) + right * half[i] * along + up * height / 2 * upward


def against(i, corner_block, corners, right, up):
    """Corners of a block against the face of block i that looks to the right (1) or left (-1), up (1) or down (-1)."""
    along, upward = axes(i)
    normal, tangent = (right * along, -right * upward) if right else (up * upward, up * along)
    middle = np.array([x[i], z[i]]) + normal * (half[i] if right else height / 2)
    for p in (corner(corner_block, *c) for c in corners):
        gap, place = (p - middle) @ normal, (p - middle) @ tangent
        if abs(place) <= (height / 2 if right else half[i]) + 1e-7 and abs(gap) < NEAR:
            yield p, normal, tangent, corner_block, i, gap


def contacts():
    """(point, normal, tangent, block of the corner, block of the face or -1 for the ground, gap)."""
    for i in range(len(x)):
        if course[i] == 0:
            for right in (-1, 1):
                p = corner(i, right, -1)
                yield p, np.array([0.0, 1.0]), np.array([1.0, 0.0]), i, -1, p[1]
        for j in range(len(x)):
            if course[j] == course[i] + 1:
                yield from against(i, j, [(-1, -1), (1, -1)], 0, 1)
                yield from against(j, i, [(-1, 1), (1, 1)], 0, -1)
            if course[j] == course[i] and j == i + 1:
                yield from against(i, j, [(-1, -1), (-1, 1)], 1, 0)
                yield from against(j, i, [(1, -1), (1, 1)], -1, 0)


def least_raised():
    """Displacements (x, z, rotation of each block) of the step and the load factor."""
    rows, columns, values, gaps = [], [], [], []
    for p, normal, tangent, a, b, gap in contacts():
        for side in (-1, 1):
            d = side * friction * tangent - normal
            for block, sign in ((a, 1.0), (b, -1.0)):
                if block >= 0:
                    rows += [len(gaps)] * 3
                    columns += [3 * block, 3 * block + 1, 3 * block + 2]
                    values += [sign * d[0], sign * d[1], sign * (d[0] * (p[1] - z[block]) - d[1] * (p[0] - x[block]))]
            gaps.append(gap)
    raised, pushed = np.zeros(3 * len(x)), np.zeros((1, 3 * len(x)))
    raised[1::3] = pushed[0, 0::3] = weight
    most = 30 * step
    solved = linprog(raised, A_ub=coo_matrix((values, (rows, columns)), shape=(len(gaps), 3 * len(x))).tocsr(), b_ub=gaps, A_eq=pushed,
                     b_eq=[step], bounds=[(-most, most), (-most, most), (-5 * most, 5 * most)] * len(x), method="highs")
    assert solved.status == 0, solved.message
    return solved.x, solved.eqlin.marginals[0]


start = corner(len(x) - 1, 1, 1)[0]
history = []
while len(history) < asked.steps if asked.steps else not history or (history[-1][1] > 0 and history[-1][0] < 2):
    moved, factor = least_raised()
    history.append((corner(len(x) - 1, 1, 1)[0] - start, factor))
    x, z, turned = x + moved[0::3], z + moved[1::3], turned + moved[2::3]
corners, factors = np.array(history).T
if asked.steps:
    for at, factor in history:
        print(f"{at:.6f} {factor:.5f}")
else:
    for at in (0.0, 0.02, 0.06, 0.10, 0.15, 0.20, 0.30):
        if at < corners[-1]:
            print(f"{at:.2f} {np.interp(at, corners, factors):.4f}")
    print(f"{corners[-1]:.4f} {factors[-1]:.4f}")
