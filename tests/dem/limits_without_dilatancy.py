#!/usr/bin/python3
"""limits_without_dilatancy.py [--wall 1 to 6] [--starts N]   limits of a wall of rigid blocks whose friction does not dilate; needs scipy.

Horizontal forces are proportional to weight. A limit is a load factor, forces and a mechanism such that the forces are in equilibrium, press on
every contact and keep Coulomb's law, and the mechanism opens contacts without force and slides, without dilation, where friction is used up. Such
limits are not unique: they hang on how the weight is shared out. From each of N random ways to share it (contacts of random stiffness) the search
    1. finds the largest load factor with shear strengths that do not depend on the normal forces, by linear programming (its dual is the mechanism);
    2. among the forces that go with this limit and mechanism takes those that break Coulomb's law least;
    3. moves the strengths towards friction x their normal forces,
until no force breaks the law. What is printed is therefore an exact limit, whatever the way to it; a start that does not settle is left out.
Prints the number of starts that settled, the least, the median and the largest limit, and the limit with associated friction.
"""
import argparse

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix

from ferris_tin_loi import FRICTION, HEIGHT, UNIT, WALLS, blocks, courses

FIRST = 0.2           # load factor under which the random stiffnesses share out the forces
SHARE_OF_STEP = 0.7   # that strengths make towards friction x normal force
MOST_STEPS = 200
EXACT = 1e-6          # violation of Coulomb's law, all contacts together, over the weight of a unit
PART_OF_MECHANISM = 1e-9


class Wall:
    """Contacts of two corners each: forces (normal, normal, shear) by contact, then the load factor."""

    def __init__(self, number):
        placed = blocks(courses(number))
        self.middle = np.array([((left + right) / 2, (c + 0.5) * HEIGHT) for c, left, right in placed])
        self.weight = np.array([(right - left) / UNIT for _, left, right in placed])  # in units
        faces = list(self.faces(placed))
        self.contacts = len(faces)
        rows, columns, values = [], [], []
        for k, (below, above, ends, normal) in enumerate(faces):
            tangent = (normal[1], normal[0])
            for column, at, force in ((3 * k, ends[0], normal), (3 * k + 1, ends[1], normal), (3 * k + 2, np.mean(ends, axis=0), tangent)):
                for block, sign in ((above, 1.0), (below, -1.0)):
                    if block >= 0:
                        arm = np.array(at) - self.middle[block]
                        rows += [3 * block, 3 * block + 1, 3 * block + 2]
                        columns += [column] * 3
                        values += [sign * force[0], sign * force[1], sign * (arm[0] * force[1] - arm[1] * force[0])]
        rows += [3 * block for block in range(len(placed))]
        columns += [3 * self.contacts] * len(placed)
        values += list(self.weight)
        self.entries, self.equations = (values, (rows, columns)), 3 * len(placed)
        self.loads = np.zeros(self.equations)
        self.loads[1::3] = self.weight
        self.bounds = [(0, None), (0, None), (None, None)] * self.contacts + [(0, None)]

    @staticmethod
    def faces(placed):
        """(block below or to the left, -1 for the ground; block above or to the right; both ends; normal)"""
        for i, (c, left, right) in enumerate(placed):
            if c == 0:
                yield -1, i, ((left, 0.0), (right, 0.0)), (0.0, 1.0)
            for j, (d, left_j, right_j) in enumerate(placed):
                near, far = max(left, left_j), min(right, right_j)
                if d == c + 1 and far - near > 1e-9:
                    yield i, j, ((near, d * HEIGHT), (far, d * HEIGHT)), (0.0, 1.0)
                if d == c and abs(left_j - right) < 1e-9:
                    yield i, j, ((right, c * HEIGHT), (right, (c + 1) * HEIGHT)), (1.0, 0.0)

    def equilibrium(self, variables):
        return coo_matrix(self.entries, shape=(self.equations, variables)).tocsr()

    def shared(self, random):
        """Normal forces by contact under the weight and FIRST times the load, contacts of random stiffness."""
        stiffness = np.exp(random.normal(0.0, 1.0, 3 * self.contacts))
        matrix = self.equilibrium(3 * self.contacts + 1).toarray()
        forces = stiffness * np.linalg.lstsq(matrix[:, :-1] * stiffness, self.loads - FIRST * matrix[:, -1], rcond=None)[0]
        return np.maximum(forces[0::3] + forces[1::3], 0.0)


class Rows:
    """Inequalities, one after the other."""

    def __init__(self):
        self.columns, self.values, self.rows, self.limits = [], [], [], []

    def add(self, columns, values, limit):
        self.rows += [len(self.limits)] * len(columns)
        self.columns += columns
        self.values += values
        self.limits.append(limit)

    def matrix(self, variables):
        return coo_matrix((self.values, (self.rows, self.columns)), shape=(len(self.limits), variables)).tocsr()


def largest(wall, friction, strength):
    """Largest load factor with |shear| <= strength + friction x normal: solution of the linear programme."""
    rows, count = Rows(), 3 * wall.contacts + 1
    for k in range(wall.contacts):
        for side in (1.0, -1.0):
            rows.add([3 * k, 3 * k + 1, 3 * k + 2], [-friction, -friction, side], strength[k])
    aim = np.zeros(count)
    aim[-1] = -1.0
    return linprog(aim, A_ub=rows.matrix(count), b_ub=rows.limits, A_eq=wall.equilibrium(count), b_eq=wall.loads, bounds=wall.bounds,
                   method="highs")


def nearest_to_coulomb(wall, limit, strength):
    """(normal forces by contact, violation) of the forces of this limit and mechanism that break Coulomb's law least; None if none is found."""
    contacts, count = wall.contacts, 5 * wall.contacts + 1
    used = np.abs(limit.ineqlin.marginals)
    slides = used[0::2] + used[1::2] > PART_OF_MECHANISM
    opens = np.abs(limit.lower.marginals)[:3 * contacts] > PART_OF_MECHANISM
    rows = Rows()
    for k in range(contacts):
        broken, off = 3 * contacts + 1 + k, 4 * contacts + 1 + k
        for side in (1.0, -1.0):
            rows.add([3 * k, 3 * k + 1, 3 * k + 2, broken], [-FRICTION, -FRICTION, side, -1.0], 0.0)
            rows.add([3 * k + 2], [side], strength[k])
            if slides[k]:  # there friction must be used up: strength = friction x normal force
                rows.add([3 * k, 3 * k + 1, off], [side * FRICTION, side * FRICTION, -1.0], side * strength[k])
    bounds = [(0, 0) if opens[c] and c % 3 < 2 else wall.bounds[c] for c in range(3 * contacts)]
    bounds += [(limit.x[-1] - 1e-9, limit.x[-1] + 1e-9)] + [(0, None)] * (2 * contacts)
    aim = np.zeros(count)
    aim[3 * contacts + 1:] = 1.0
    solved = linprog(aim, A_ub=rows.matrix(count), b_ub=rows.limits, A_eq=wall.equilibrium(count), b_eq=wall.loads, bounds=bounds,
                     method="highs")
    if solved.status != 0:
        return None
    return solved.x[0:3 * contacts:3] + solved.x[1:3 * contacts:3], solved.fun


def limit_from(wall, seed):
    """The limit that is reached from one way to share out the weight, or None."""
    strength = FRICTION * wall.shared(np.random.default_rng(seed))
    for _ in range(MOST_STEPS):
        limit = largest(wall, 0.0, strength)
        if limit.status != 0:
            return None
        found = nearest_to_coulomb(wall, limit, strength)
        normal, violation = found or (limit.x[0:-1:3] + limit.x[1:-1:3], np.inf)
        if violation < EXACT:
            return limit.x[-1]
        strength = (1.0 - SHARE_OF_STEP) * strength + SHARE_OF_STEP * FRICTION * normal
    return None


arguments = argparse.ArgumentParser()
arguments.add_argument("--wall", type=int, choices=WALLS, default=5)
arguments.add_argument("--starts", type=int, default=16)
asked = arguments.parse_args()
whole = Wall(asked.wall)
limits = [limit for limit in (limit_from(whole, seed) for seed in range(1, asked.starts + 1)) if limit is not None]
associated = largest(whole, FRICTION, np.zeros(whole.contacts)).x[-1]
print(f"wall {asked.wall}: {len(limits)} of {asked.starts} starts settled")
if limits:
    print(f"without dilatancy {min(limits):.4f} to {max(limits):.4f}, median {np.median(limits):.4f}; associated {associated:.5f}")
