"""The first line of examples/cpp/push_one_wall, from Python: peak.py WALL.ini"""
import sys

import drystone

print(f"peak_force_kN {drystone.push(sys.argv[1]).summary['peak_force_kN']:.15g}")
