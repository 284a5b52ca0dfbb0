"""python3 bench/evidence.py FOLDER OUT   the evidence.csv of each calibration in FOLDER as OUT.csv and OUT.md; bench/evidence.sh calls it."""
import csv
import math
import pathlib
import sys

LAWS = {"linear_coulomb": ("linear", "Coulomb"), "closing_coulomb": ("exponential closure", "Coulomb"),
        "linear_hyperbolic": ("linear", "hyperbolic"), "closing_hyperbolic": ("exponential closure", "hyperbolic")}
HEAD = ["joints", "envelope of cracks", "ln evidence", "standard error", "odds to the first", "without discrepancy"]


def has_ended(folder, name):
    return (folder / name / "evidence.csv").exists()


def rows(folder):
    first = None
    for name, laws in LAWS.items():
        if not has_ended(folder, name):
            continue
        with open(folder / name / "evidence.csv", encoding="utf-8", newline="") as file:
            by = {row["discrepancy"]: row for row in csv.DictReader(file)}
        value, error = float(by["yes"]["ln evidence"]), float(by["yes"]["standard error"])
        first = value if first is None else first
        yield [*laws, f"{value:.2f}", f"{error:.3f}", f"{math.exp(value - first):.2f}", f"{float(by['no']['ln evidence']):.2f}"]


def main(folder, out):
    table = list(rows(pathlib.Path(folder)))
    with open(out + ".csv", "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([HEAD, *table])
    lines = ["# Evidence of laws, by seven tests", "",
             "Written by `bash bench/evidence.sh`. The table has ln of the evidence with a discrepancy ([calibration.md](../calibration.md)) for walls of "
             "`configs/calibration.ini` and the seven tests of `configs/lourenco2005.csv`, law by law, pushed with `solver.accuracy = 3 %`. Odds below 3 to 1 say little.", "",
             "| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD), *("| " + " | ".join(row) + " |" for row in table), ""]
    missing = ["joints " + " and envelope ".join(laws) for name, laws in LAWS.items() if not has_ended(pathlib.Path(folder), name)]
    if missing:
        lines += [f"Not in the table, because their calibrations have not ended: {'; '.join(missing)}. The same command adds them.", ""]
    pathlib.Path(out + ".md").write_text("\n".join(lines), encoding="utf-8")


main(*sys.argv[1:])
