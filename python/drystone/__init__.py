"""Drystone: how much in-plane drift a dry-joint stone wall takes.

The program's own code, with the bits of its command line. All values are in SI (m, N, Pa, rad) unless a name says otherwise;
drifts of fragility are in percent.

>>> import drystone
>>> wall = drystone.push("configs/wall.ini", set={"load.vertical_stress": "0.50 MPa"})
>>> wall.summary["peak_force_kN"]            # doctest: +SKIP
>>> plt.plot(wall.displacement, wall.force)  # doctest: +SKIP
"""
from drystone._load import core as _core
from drystone import fragility, uq
from drystone._results import Drifts, Results, open
from drystone._shaking import Shaking, shake
from drystone._study import Curve, Frame, Push, Study, push
from drystone._surrogate import ModeProbability, Prediction, Surrogate
from drystone._wall import Wall

ConfigError = _core.ConfigError
StoreError = _core.StoreError
NoFit = _core.NoFit
__version__ = _core.__version__
__solver_revision__ = _core.__solver_revision__

__all__ = ["ConfigError", "Curve", "Drifts", "Frame", "ModeProbability", "NoFit", "Prediction", "Push", "Results", "Shaking", "StoreError", "Study", "Surrogate", "Wall", "fragility", "open", "push",
           "shake", "uq"]
