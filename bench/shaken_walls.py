"""Tables of docs/dynamics.md from the folders that bench/shaken_walls.sh fills: python3 shaken_walls.py WORK FILE.md"""

import csv
import pathlib
import sys

BEGIN = "<!-- bench/shaken_walls.sh writes what follows -->"
END = "<!-- bench/shaken_walls.sh wrote what stands above -->"
WIDEST = 100.0  # ratio of the ends of an interval that is printed
MEASURES = (("pga", "g"), ("pgv", "m/s"), ("sa", "g"))
NAMES = {"pga": "PGA [g]", "pgv": "PGV [m/s]", "sa": "Sa(0.3 s) [g]"}


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def value(text, digits=3):
    return f"{float(text):.{digits}g}" if text not in ("", None) else ""


def with_band(row, name, unit=""):
    middle = value(row[name + unit])
    low, high = value(row[f"{name} lower{unit}"]), value(row[f"{name} upper{unit}"])
    if not middle:
        return "no curve"
    if not (low and high):
        return middle
    useful = float(high) <= WIDEST * float(low)
    return f"{middle} [{low}, {high}]" if useful else f"{middle} [?]"


def table(head, body):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in body])


def chosen(path):
    """One row for each stress and state: stripes, else IDA, else the cloud."""
    best = {}
    for row in rows(path):
        key = (row["stress [MPa]"], row["state"])
        unit = next(k for k in row if k.startswith("median ["))
        if key not in best or (not best[key][unit] and row[unit]):
            best[key] = row
    return best


def fragility_table(work):
    limits = {m: chosen(work / m / "intensity_limits.csv") for m, _ in MEASURES}
    peaks = [float(r["median pga [g]"]) for r in rows(work / "pga" / "intensity_stripes.csv")]
    body = []
    for key, row in limits["pga"].items():
        cells = [with_band(limits[m][key], "median", f" [{unit}]") for m, unit in MEASURES]
        median = row["median [g]"]
        if median and not min(peaks) <= float(median) <= max(peaks):
            cells[0] += " \\*"
        body.append([*key, *cells, value(row["dispersion"], 2), row["method"], f"{row['reached']} of {row['n']}"])
    head = ["stress [MPa]", "state", *(NAMES[m] for m, _ in MEASURES), "dispersion on PGA", "method", "reached"]
    return table(head, body)


def stripe_table(work):
    body = []
    for row in rows(work / "pga" / "intensity_stripes.csv"):
        modes = [value(row[f"{m} [%]"]) for m in ("rocking", "sliding", "mixed")]
        states = [value(row[k]) for k in row if k.endswith("[%]") and not k.split(" [")[0].endswith(("lower", "upper"))
                  and k.split(" [")[0] not in ("rocking", "sliding", "mixed")]
        body.append([row["stress [MPa]"], value(row["median pga [g]"]), row["histories"], row["failed"], *states, *modes])
    first = rows(work / "pga" / "intensity_stripes.csv")[0]
    names = [k for k in first if k.endswith("[%]") and not k.split(" [")[0].endswith(("lower", "upper"))]
    return table(["stress [MPa]", "PGA [g]", "histories", "failed", *names], body)


def push_table(work):
    def ultimate(name):
        all_rows = rows(work / name / "performance_limits.csv")
        return {r["stress [MPa]"]: r for r in all_rows if r["limit state"] == "paper ultimate"}

    def cell(row):
        if row is None:
            return ""
        if row["median drift [%]"]:
            return with_band(row, "median drift", " [%]")
        return "> " + value(row["tested up to [%]"])

    one_way, cyclic = ultimate("one_way"), ultimate("cyclic")
    body = [[stress, row["n"], cell(row), row["censored [%]"] and value(row["censored [%]"]),
             cell(cyclic.get(stress)), value(cyclic[stress]["censored [%]"]) if stress in cyclic else ""]
            for stress, row in one_way.items()]
    head = ["stress [MPa]", "walls", "one way: ultimate drift [%]", "stood [%]", "to and fro: ultimate drift [%]", "stood [%]"]
    return table(head, body)


def main():
    work, page = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    stripes = rows(work / "pga" / "intensity_stripes.csv")
    count = sum(int(r["histories"]) for r in stripes)
    failed = sum(int(r["failed"]) for r in stripes)
    limits = rows(work / "pga" / "intensity_limits.csv")[0]
    peaks = [float(r["median pga [g]"]) for r in stripes]
    asked = int(limits["walls"]) * int(limits["records"]) * len({(r["stress [MPa]"], r["pga [g]"]) for r in stripes})
    part = "" if count == asked else f" of {asked}"
    text = (
        f"{count}{part} histories ({failed} failed): {limits['walls']} walls under each stress x {limits['records']} motions x "
        f"{len({r['pga [g]'] for r in stripes})} intensities. **In-plane shaking of dry-joint walls is verified against closed forms and not "
        "validated: no open test of such a wall is known.** The first table has the median intensity at which each state is reached, with 95 % intervals clustered by record and by wall if there are several ([?]: wider than 1 to 100). \\*: beyond the "
        f"intensities of the study, {min(peaks):g} to {max(peaks):g} g; the value is extrapolated by the law, or along a line from zero.\n\n"
        f"{fragility_table(work)}\n\n"
        "Shares of the histories that reached each state, and modes at the turn or fall of the walls, in percent:\n\n"
        f"{stripe_table(work)}\n\n"
        "Median drift at which the force has fallen to 80 % of its peak, for the same walls pushed at their top, one way and to and fro:\n\n"
        f"{push_table(work)}"
    )
    old = page.read_text()
    before, rest = old.split(BEGIN)
    page.write_text(f"{before}{BEGIN}\n{text}\n{END}{rest.split(END)[1]}")


main()
