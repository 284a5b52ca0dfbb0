#!/usr/bin/python3
"""arch_statics.py [--stiffness GPa/m] [--points N or all] [--study FILE]   what a semicircular arch of rigid voussoirs carries as
it moves; needs scipy.

The arch (15 voussoirs, mean radius 1 m, 0.15 m thick, 0.5 m deep) has horizontal forces in proportion to its weight. Joints
are springs without tension, along all of a face or at N Gauss-Lobatto points of it, and do not slip. Blocks turn by any angle. Newton's method
finds balance at each displacement of the centre of gravity: there are no masses, no damping and no steps in time. Where the arch then is, a linear
program finds the largest force that corners of rigid blocks carry there (no tension, friction 1).
Prints displacement, force, and that limit. --study writes the same arch as a study for drystone.
"""
import argparse
import math

import numpy as np
from numpy.polynomial import legendre
from scipy.optimize import linprog

VOUSSOIRS, THICKNESS, DEPTH, DENSITY, GRAVITY = 15, 0.15, 0.5, 2300.0, 9.81
SHEAR = 1 / 2.4  # stiffness in shear over that in closing
FRICTION = 1.0
EXACT = 1e-7  # of the weight
STUDY = """[wall]
outlines = {outlines}
thickness = 0.5 m
base = joint
[stone]
young_modulus = 1000 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
normal_stiffness = {stiffness:g} GPa/m
friction_angle = 45 deg
[beam]
present = no
[load]
vertical_stress = 0 MPa
pattern = body
direction = right
[solver]
fidelity = rigid
"""


def outlines():
    """Corners of the voussoirs from the right springing to the left, the centre of the arch at the origin."""
    at = lambda r, a: (r * math.cos(a), r * math.sin(a))
    turn = [math.pi * k / VOUSSOIRS for k in range(VOUSSOIRS + 1)]
    inner, outer = 1 - THICKNESS / 2, 1 + THICKNESS / 2
    return [[at(inner, a), at(outer, a), at(outer, b), at(inner, b)] for a, b in zip(turn, turn[1:])]


def rule(n, zones=2):
    """Places and weights of the program's Gauss-Lobatto points: each weight is the integral of its polynomial along a polyline."""
    c = np.zeros(n)
    c[-1] = 1
    x = (np.concatenate([[-1], np.sort(legendre.legroots(legendre.legder(c)).real), [1]]) + 1) / 2
    nodes = [x[0]] + [a + (b - a) * k / zones for a, b in zip(x, x[1:]) for k in range(1, zones + 1)]
    shape = lambda s: np.array([np.prod([(s - x[j]) / (x[i] - x[j]) for j in range(n) if j != i]) for i in range(n)])
    return x, sum((b - a) / 2 * (shape(a) + shape(b)) for a, b in zip(nodes, nodes[1:]))


class Arch:
    """Displacements are (x, z, clockwise rotation) by block; the last row is the ground."""

    def __init__(self, stiffness, points):
        self.kn, self.rule = stiffness, points and rule(points)
        stones = outlines()
        n = len(stones)
        self.weight, self.centre = np.zeros(n + 1), np.zeros((n + 1, 2))
        for b, stone in enumerate(stones):
            x, z = np.array(stone).T
            x1, z1 = np.roll(x, -1), np.roll(z, -1)
            cross = x * z1 - x1 * z
            self.weight[b] = cross.sum() / 2 * DEPTH * DENSITY * GRAVITY
            self.centre[b] = ((x + x1) * cross).sum() / (3 * cross.sum()), ((z + z1) * cross).sum() / (3 * cross.sum())
        self.a = np.array([n] + list(range(n)))  # a face lies between a and b, its normal from a to b
        self.b = np.array(list(range(n)) + [n])
        self.ends = np.array([stone[:2] for stone in stones] + [stones[-1][:1:-1]])  # (face, end, coordinate)
        along = self.ends[:, 1] - self.ends[:, 0]
        self.length = np.hypot(*along.T)
        self.normal = np.stack([-along[:, 1], along[:, 0]], 1) / self.length[:, None]
        self.blocks = n

    def at(self, q, block, point):
        """Where points of blocks are that moved by q (a row for each point)."""
        r = point - self.centre[block]
        c, s = np.cos(q[:, 2]), np.sin(q[:, 2])
        return np.stack([self.centre[block, 0] + q[:, 0] + r[:, 0] * c + r[:, 1] * s,
                         self.centre[block, 1] + q[:, 1] + r[:, 1] * c - r[:, 0] * s], 1)

    def gaps(self, qa, qb):
        """Gap at both ends and slip in the middle of every face, in the mean direction of its sides."""
        mean = (qa[:, 2] + qb[:, 2]) / 2
        c, s = np.cos(mean), np.sin(mean)
        nx, nz = self.normal[:, 0] * c + self.normal[:, 1] * s, self.normal[:, 1] * c - self.normal[:, 0] * s
        apart = [self.at(qb, self.b, self.ends[:, e]) - self.at(qa, self.a, self.ends[:, e]) for e in (0, 1)]
        middle = (apart[0] + apart[1]) / 2
        return [nx * d[:, 0] + nz * d[:, 1] for d in apart] + [nz * middle[:, 0] - nx * middle[:, 1]]

    def resultants(self, g0, g1):
        """Derivatives of the stored energy by the gaps at both ends."""
        if self.rule:
            closed = [(x, w * np.minimum(0, (1 - x) * g0 + x * g1)) for x, w in zip(*self.rule)]
            first, last = sum((1 - x) * c for x, c in closed), sum(x * c for x, c in closed)
        else:
            def opens(closed, opened):  # energy closed^3 / 6 (closed - opened)
                reach = np.where(closed < opened, closed - opened, -1.0)
                return (3 * closed**2 * reach - closed**3) / (6 * reach**2), closed**3 / (6 * reach**2)
            here, there = opens(np.minimum(g0, 0), np.maximum(g1, 0)), opens(np.minimum(g1, 0), np.maximum(g0, 0))
            both = (g0 < 0) & (g1 < 0)
            first = np.where(both, (2 * g0 + g1) / 6, np.where(g0 < 0, here[0], np.where(g1 < 0, there[1], 0)))
            last = np.where(both, (g0 + 2 * g1) / 6, np.where(g0 < 0, here[1], np.where(g1 < 0, there[0], 0)))
        k = self.kn * DEPTH * self.length
        return k * first, k * last

    def on_faces(self, qa, qb):
        """Forces that hold the blocks of every face where they are, (face, 6); the gaps are derived by complex steps."""
        g0, g1, slip = self.gaps(qa, qb)
        by = (*self.resultants(g0, g1), SHEAR * self.kn * DEPTH * self.length * slip)
        out = []
        for column in range(6):
            moved = [qa.astype(complex), qb.astype(complex)]
            moved[column // 3][:, column % 3] += 1e-20j
            out.append(sum(f * g.imag / 1e-20 for f, g in zip(by, self.gaps(*moved))))
        return np.stack(out, 1)

    def unbalance(self, q, force):
        out = np.zeros_like(q)
        on = self.on_faces(q[self.a], q[self.b])
        np.add.at(out, self.a, on[:, :3])
        np.add.at(out, self.b, on[:, 3:])
        out[:, 1] += self.weight
        out[:, 0] -= force * self.weight / self.weight.sum()
        return out[:self.blocks].ravel()

    def tangent(self, q):
        size = q.size
        out = np.zeros((size, size))
        for column in range(6):
            moved = []
            for step in (1e-10, -1e-10):
                sides = [q[self.a].copy(), q[self.b].copy()]
                sides[column // 3][:, column % 3] += step
                moved.append(self.on_faces(*sides))
            change = (moved[0] - moved[1]) / 2e-10
            for row in range(6):
                np.add.at(out, (3 * (self.a, self.b)[row // 3] + row % 3, 3 * (self.a, self.b)[column // 3] + column % 3), change[:, row])
        return out[:3 * self.blocks, :3 * self.blocks]

    def centre_moved(self, q):
        return (self.weight * q[:, 0]).sum() / self.weight.sum()

    def balance(self, q, force, target=None):
        """Newton's method for a displacement of the centre of gravity, or for no horizontal force; None where it fails."""
        n, scale = 3 * self.blocks, self.weight.sum()
        lever = np.zeros(n)
        lever[::3] = self.weight[:-1] / scale
        missing = lambda q, f: np.append(self.unbalance(q, f) / scale, 0 if target is None else 1e3 * (target - self.centre_moved(q)))
        e = missing(q, force)
        for _ in range(300 if target is None else 60):
            if np.abs(e).max() < EXACT:
                return q, force
            k = np.zeros((n + 1, n + 1))
            k[:n, :n] = self.tangent(q) / self.kn
            if target is None:
                k[:n, :n] += 1e-9 * np.abs(k).max() * np.eye(n)
                k[n, n] = 1.0
            else:
                k[:n, n], k[n, :n] = -lever, lever
            try:
                d = np.linalg.solve(k, np.append(-e[:n] * scale / self.kn, 1e-3 * e[n]))
            except np.linalg.LinAlgError:
                return None
            share = 1.0
            while True:
                tried = q.copy()
                tried[:-1] += share * d[:n].reshape(-1, 3)
                after = missing(tried, force + share * d[n] * self.kn)
                if np.linalg.norm(after) < np.linalg.norm(e) * (1 - 1e-3 * share) or share < 2e-3:
                    break
                share /= 2
            q, force, e = tried, force + share * d[n] * self.kn, after
        return None

    def pushed(self, displacements):
        """(displacement from the arch at rest, force, positions) one after the other, until a step fails."""
        q = np.zeros((self.blocks + 1, 3))
        q[:-1, 1] = -1e-7
        stiff, self.kn = self.kn, min(self.kn, 1e10)
        while (found := self.balance(q, 0.0)) and self.kn < stiff:  # softer joints first
            softer, self.kn = self.kn, min(2 * self.kn, stiff)
            q = found[0] * softer / self.kn
        if not found:
            return
        q, force = found
        rest = here = self.centre_moved(q)
        for displacement in displacements:
            step = rest + displacement - here
            while here < rest + displacement - 1e-12:
                step = min(step, rest + displacement - here)
                if found := self.balance(q, force, here + step):
                    (q, force), here, step = found, here + step, 2 * step
                elif (step := step / 4) < 1e-9:
                    return
            yield displacement, force, q

    def limit(self, q):
        """Largest force that rigid blocks in this position carry through the corners of their faces [N]."""
        ends = [(self.at(q[self.a], self.a, p) + self.at(q[self.b], self.b, p)) / 2 for p in (self.ends[:, 0], self.ends[:, 1])]
        mean = (q[self.a, 2] + q[self.b, 2]) / 2
        n = np.stack([self.normal[:, 0] * np.cos(mean) + self.normal[:, 1] * np.sin(mean),
                      self.normal[:, 1] * np.cos(mean) - self.normal[:, 0] * np.sin(mean)], 1)
        columns = []
        for f, (a, b) in enumerate(zip(self.a, self.b)):
            for x, z in (e[f] for e in ends):
                for side in (FRICTION, -FRICTION):
                    fx, fz = n[f, 0] - side * n[f, 1], n[f, 1] + side * n[f, 0]
                    on = np.zeros((self.blocks + 1, 3))
                    for block, sign in ((b, 1.0), (a, -1.0)):
                        cx, cz = self.centre[block] + q[block, :2]
                        on[block] += sign * np.array([fx, fz, (x - cx) * fz - (z - cz) * fx])
                    columns.append(on[:-1].ravel())
        total = self.weight.sum()
        push, own = np.zeros((2, self.blocks, 3))
        push[:, 0], own[:, 1] = self.weight[:-1] / total, self.weight[:-1] / total
        best = linprog(np.append(np.zeros(len(columns)), -1.0), A_eq=np.array(columns + [push.ravel()]).T, b_eq=own.ravel(), method="highs")
        return -best.fun * total if best.status == 0 else float("nan")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--stiffness", type=float, default=10.0, help="of the joints [GPa/m]")
    parser.add_argument("--points", default="all", help="Gauss-Lobatto points of a face, or all: springs along it")
    parser.add_argument("--study", help="writes the arch as a study for drystone")
    given = parser.parse_args()
    if given.study:
        low = min(x for stone in outlines() for x, _ in stone)
        text = "; ".join(", ".join("%.9f %.9f" % (x - low, z) for x, z in stone) for stone in outlines())
        with open(given.study, "w", encoding="utf-8") as out:
            out.write(STUDY.format(outlines=text, stiffness=given.stiffness))
    arch = Arch(1e9 * given.stiffness, None if given.points == "all" else int(given.points))
    print("undeformed: limit %.4f kN" % (arch.limit(np.zeros((arch.blocks + 1, 3))) / 1e3))
    last = 1.3e-3 * (10 / given.stiffness) ** (1.0 if arch.rule else 2 / 3)  # about the peak [m]
    for displacement, force, q in arch.pushed([s * last for s in (0.5, 0.75, 0.9, 1, 1.1, 1.25, 1.5, 2, 3)]):
        print("%.4f mm: %.4f kN, limit there %.4f kN" % (1e3 * displacement, force / 1e3, arch.limit(q) / 1e3), flush=True)


main()
