"""One wall under two friction angles, plotted: python3 examples/python/one_wall.py"""
import pathlib

import matplotlib
matplotlib.use("Agg")  # into a file; leave out in a notebook
import matplotlib.pyplot as plt

import drystone

wall_ini = pathlib.Path(__file__).parents[2] / "configs/wall.ini"
for angle in (25.0, 31.8):
    wall = drystone.push(wall_ini, set={"joint.friction_angle": f"{angle} deg", "solver.fidelity": "simple"})
    plt.plot(1e3 * wall.displacement, 1e-3 * wall.force, label=f"{angle}°: {wall.summary['mode']}")
    print(f"{angle}°: {wall.summary['peak_force_kN']:.1f} kN at {wall.summary['peak_displacement_mm']:.1f} mm")
plt.xlabel("displacement [mm]")
plt.ylabel("horizontal load [kN]")
plt.legend()
plt.savefig("one_wall.png")
