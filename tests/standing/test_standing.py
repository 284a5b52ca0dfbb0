#!/usr/bin/python3
"""No wall that has admissible contact forces is said to have come down, and none without them is said to stand.

test_standing.py PROGRAM [COUNT [FIRST [key=value ...]]]     200 scenes from number 0, if nothing else is asked for

Exit code 0: good, 1: not, 77: skipped, SciPy is not installed (Debian: python3-scipy).
"""
import json
import math
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

try:
    import scipy.optimize  # noqa: F401
except ImportError:
    print("skipped: python3-scipy is not installed")
    sys.exit(77)

import admissible
import scenes

GRAVITY = 9.81  # [m/s2]
NONE = 1e-9  # share of the loads below which no force is missing: the accuracy of the linear program
SOME = 1e-3  # above which the wall has no equilibrium, whatever its joints give way
# What a wall must bear beside its loads to be called one that stands with a margin: a tilt, less friction, smaller faces.
TILT, FRICTION, INSET = 0.02, 0.7, 0.02


def check(what, good):
    if not good:
        sys.exit("the linear program is wrong: " + what)


def check_the_program():
    """Against closed forms."""
    block = [scenes.box(0, 0, 1, 2)]

    def tilted(f, tan_phi):
        return admissible.missing_force(block, [[(f, -1.0, 0.5, 1.0)]], lambda a, b: tan_phi) < NONE

    check("a block of 1 x 2 turns at a tilt of 1/2", tilted(0.499, 9) and not tilted(0.501, 9))
    check("a block slides at the tilt of its friction", tilted(0.299, 0.3) and not tilted(0.301, 0.3))

    def half_circle(thickness, n=60):
        stones = [[(r * math.cos(a), r * math.sin(a)) for r, a in ((1 - thickness / 2, a0), (1 + thickness / 2, a0),
                                                                  (1 + thickness / 2, a1), (1 - thickness / 2, a1))]
                  for a0, a1 in zip([math.pi * i / n for i in range(n)], [math.pi * (i + 1) / n for i in range(n)])]
        centres = [admissible.area_and_centre(o)[1] for o in stones]
        stones = [[(x, 0.0 if abs(z) < 1e-12 else z) for x, z in o] for o in stones]
        return admissible.missing_force(stones, [[(0, -1.0, *c)] for c in centres], lambda a, b: 1.0) < NONE

    # Milankovitch: 0.1075 of the mean radius, a little less where the joints are few.
    check("half circles stand from 0.1075 of their radius on", half_circle(0.1085) and not half_circle(0.1055))


def study(s):
    outlines = "; ".join(", ".join("%.9f %.9f" % corner for corner in o) for o in s["outlines"])
    beam = "height = %g m\nyoung_modulus = 30 GPa\ndensity = 2500 kg/m3\ninterface = joint" % scenes.BEAM if s["beam"] else "present = no"
    return f"""[wall]
outlines = {outlines}
thickness = {s["thickness"]} m
base = joint
[stone]
young_modulus = 20 GPa
poisson_ratio = 0.2
density = {s["density"]} kg/m3
[joint]
normal_stiffness = {s["stiffness"] / 1e9:.6g} GPa/m
friction_angle = {s["friction_deg"]} deg
[unit]
tensile_strength = 3 MPa
fracture_energy = 80 N/m
friction_angle = 35 deg
[beam]
{beam}
[load]
vertical_stress = {s["stress"] / 1e6:.6g} MPa
max_displacement = 0.01 mm
pattern = {"beam" if s["beam"] else "body"}
[solver]
kinematics = {s["kinematics"]}
fidelity = {s["fidelity"]}
[output]
paraview = no
record_every = 0.005 mm
"""


def standing(s):
    """'stands' with a margin, 'falls' beyond doubt, or 'unsure'.

    The margin is wide, because Coulomb's friction does not dilate: forces that only blocks in a squeeze have are
    admissible, and nothing need bring them about. In courses head joints count for nothing for the same reason.
    """
    outlines = list(s["outlines"])
    areas, centres = zip(*map(admissible.area_and_centre, outlines))
    weights = [GRAVITY * s["density"] * s["thickness"] * a for a in areas]
    centres, held = list(centres), None
    if s["beam"]:
        ends = [x for o in outlines for p, q in zip(o, o[1:] + o[:1])
                if p[1] == q[1] == s["top"] for x in (p[0], q[0])]
        length, top = max(ends) - min(ends), s["top"] + scenes.BEAM
        outlines.append(scenes.box(min(ends), s["top"], length, scenes.BEAM))
        weights.append(s["thickness"] * length * (GRAVITY * 2500 * scenes.BEAM + s["stress"]))
        centres.append((min(ends) + length / 2, s["top"] + scenes.BEAM / 2))
        held = (len(outlines) - 1, centres[-1][0], top)  # the load line: it moves with the drive only
    mu = math.tan(math.radians(s["friction_deg"]))

    def missing(tilt=0.0, share=1.0, inset=0.0, heads=True):
        loads = [[(tilt * w, -w, *c)] for w, c in zip(weights, centres)]
        return admissible.missing_force(outlines, loads, lambda a, b: share * mu, inset, held, heads)

    if missing() > SOME:
        return "falls"

    def bears(heads):
        return all(missing(tilt, FRICTION, INSET, heads) < NONE for tilt in (TILT, -TILT))

    return "stands" if bears(s["kind"] in scenes.THRUST) else "unsure"


def said(program, s, sets):
    """What the program says: 'down' under the vertical load, 'lost' at once, 'stood' or 'moved' at the beginning of
    its push, 'failed' for another reason."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "s.ini"), "w") as f:
            f.write(study(s))
        command = [program, "push", f.name, "--quiet", "--threads", "1", "--out", os.path.join(folder, "o")]
        ran = subprocess.run(command + [word for one in sets for word in ("--set", one)], capture_output=True, text=True)
        path = os.path.join(folder, "o", "summary.json")
        if not os.path.exists(path):
            sys.exit(f"scene {s['number']}: {ran.stderr}")
        with open(path) as f:
            summary = json.load(f)
    if "came down under vertical load" in summary["no_reading"]:
        return "down", summary
    if "as soon as" in summary["no_reading"]:
        return "lost", summary
    if summary["outcome"] not in ("reached target", "decided", "lost equilibrium"):
        return "failed", summary
    return ("stood" if summary["settled_before_push"] else "moved"), summary


def main(program, count=200, first=0, *sets):
    check_the_program()
    wrong, tally = 0, {}
    with ThreadPoolExecutor(2) as pool:
        every = [scenes.scene(i) for i in range(int(first), int(first) + int(count))]
        for s, (answer, summary) in zip(every, pool.map(lambda s: said(program, s, sets), every)):
            truth = standing(s)
            moved = s["kinematics"] == "finite" and abs(summary["settlement_mm"] or 0.0) > 0.3
            if (truth, answer) == ("falls", "stood") and moved:
                answer = "stood elsewhere"  # of which the linear program of the drawn wall knows nothing
            saved = " after a slow start" if answer not in ("down", "failed") and summary["slow_starts"] else ""
            tally[truth, answer + saved] = tally.get((truth, answer + saved), 0) + 1
            if (truth, answer) in (("stands", "down"), ("stands", "lost"), ("falls", "stood"), ("falls", "moved")):
                wrong += 1
                print(f"scene {s['number']}, {s['kind']}, {s['fidelity']}, {s['kinematics']}, {s['stiffness']:.1e} Pa/m, "
                      f"{s['friction_deg']} deg: the linear program says it {truth}, the push: {answer}")
    for (truth, answer), n in sorted(tally.items()):
        print(f"{truth:7} {answer:7} {n:4}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
