#!/usr/bin/python3
"""Ctrl-C and requests to end, as a terminal or a batch system sends them. test_interrupt.py PROGRAM SOURCE_DIR CLAIM

Each claim waits for a file that the program writes, then sends the signal. Exit code 0: good, 1: not.
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM, SOURCE, CLAIM = sys.argv[1:4]
WALL, QUICK = (os.path.join(SOURCE, "configs", name) for name in ("wall.ini", "quick.ini"))
FAR = 60.0  # [s] after which a wait has failed
RIGID = ["--set", "solver.fidelity=rigid"]


def catches_interrupts(process):
    """Whether it has said to the system what it does with Ctrl-C."""
    with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
        caught = next((line.split()[1] for line in status if line.startswith("SigCgt")), "0")
    return int(caught, 16) >> (signal.SIGINT - 1) & 1 == 1


def exists(path):
    return lambda process: path.exists()


def wait_for(there, process):
    end = time.monotonic() + FAR
    while not there():
        assert process.poll() is None, ("it ended by itself", process.returncode, process.communicate())
        assert time.monotonic() < end, "it never came so far"
        time.sleep(0.002)


def interrupted(words, there, signals=(signal.SIGINT,), **settings):
    """Starts the program, and sends the signals when `there` says so of its process. What it says on stderr."""
    process = subprocess.Popen([PROGRAM, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **settings)
    wait_for(lambda: there(process), process)
    for one in signals:
        process.send_signal(one)
        time.sleep(0.002)
    _, said = process.communicate(timeout=FAR)
    assert process.returncode == 130, (process.returncode, said)
    assert said.count("drystone: interrupted; ") == 1 and "terminate" not in said, said
    return said


def run(*words):
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=FAR)
    assert done.returncode == 0, (done.returncode, done.stderr)
    return done


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def claim_push(folder):
    """The curve so far is that of the whole push, and nothing else changes."""
    out = folder / "wall"
    push = ["push", WALL, "--out", out, "--quiet", *RIGID, "--set", "solver.steps_per_mm=4000", "--set", "load.max_displacement=4 mm",
            "--set", "output.snapshot_every=0.2 mm"]
    run(*push)
    before, whole = names(out), (out / "capacity.csv").read_text()
    said = interrupted(push, exists(out / "series.part/wall_0003.vtu"))
    assert "nothing was written but the curve so far, " in said and "capacity_interrupted.csv (up to " in said, said
    assert names(out) == sorted([*before, "capacity_interrupted.csv"]), names(out)
    curve = (out / "capacity_interrupted.csv").read_text()
    assert whole.startswith(curve) and 5 < curve.count("\n") < whole.count("\n") and (out / "capacity.csv").read_text() == whole, curve

    new = folder / "new"
    push[3] = new
    interrupted(push, exists(new / "series.part/wall_0003.vtu"), [signal.SIGTERM])
    assert names(new) == ["capacity_interrupted.csv", "drystone_push_files.txt"], names(new)
    run("push", WALL, "--out", new, "--quiet", *RIGID, "--set", "load.max_displacement=0.2 mm")
    assert "capacity_interrupted.csv" not in names(new) and "capacity.csv" in names(new), names(new)


def core_seconds(process):
    """User and system time of the process so far [s]."""
    with open(f"/proc/{process.pid}/stat", encoding="ascii") as stat:
        return sum(map(int, stat.read().rpartition(")")[2].split()[11:13])) / os.sysconf("SC_CLK_TCK")


def claim_other_way(folder):
    """A push that is over keeps all its results, and the program says what is missing."""
    out, pushed = folder / "out", []
    push = ["push", WALL, "--out", out, "--quiet", "--threads", "1", *RIGID, "--set", "wall.openings=0.1 m, 0 m, 0.3 m, 0.4 m",
            "--set", "load.max_displacement=1 mm", "--set", "output.snapshot_every=1 mm", "--set", "solver.steps_per_mm=20000"]

    def on_the_other_way(process):
        """The last picture of the push is written, and the program works on."""
        if not pushed and (out / "series.part/wall_0001.vtu").exists():
            pushed.append(core_seconds(process))
        return pushed and core_seconds(process) > pushed[0] + 0.05

    said = interrupted(push, on_the_other_way)
    assert said == f"drystone: interrupted; all results of the push are in {out}; only the push the other way was left out\n", said
    assert {"capacity.csv", "summary.json", "series", "wall.svg"} <= set(names(out)) and "capacity_interrupted.csv" not in names(out), names(out)
    assert "was pushed to the right alone" in (out / "summary.json").read_text()


def claim_several_walls(folder):
    """Of walls pushed side by side each has its curve so far."""
    said = interrupted(["push", WALL, "--out", folder / "out", "--quiet", "--threads", "1", *RIGID, "--set", "load.vertical_stress=0.5, 1, 1.25 MPa",
                        "--set", "joint.wall_modulus=768, 1057, 1200 MPa", "--set", "solver.steps_per_mm=8000", "--set", "load.max_displacement=20 mm", "--set", "output.snapshot_every=0.2 mm"],
                       exists(folder / "out/1.00_MPa/series.part/wall_0003.vtu"))
    assert "the curves so far, " in said, said
    for level in ("0.50_MPa", "1.00_MPa", "1.25_MPa"):
        assert names(folder / "out" / level) == ["capacity_interrupted.csv"], level


def claim_study(folder):
    file = folder / "quick.h5"
    study = ["study", QUICK, "--out", file, "--quiet", *RIGID, "--set", "solver.steps_per_mm=1000", "--set", "load.max_displacement=2 mm"]
    said = interrupted([*study, "--set", "uq.design=monte_carlo", "--set", "uq.samples=4000"], exists(file))
    assert said == "drystone: interrupted; the same command resumes where it stopped\n", said


def claim_page(folder):
    """While the page of a finished study is made."""
    file = folder / "quick.h5"
    study = ["study", QUICK, "--out", file, "--quiet", "--threads", "1", *RIGID, "--set", "solver.steps_per_mm=4000", "--set",
             "load.max_displacement=3 mm", "--set", "uq.samples=2"]
    run(*study)
    said = interrupted([*study, "--report"], exists(folder / "quick/README.md"))
    assert said == f"drystone: interrupted; all walls are in {file}, and the same command makes the tables and the page\n", said
    said = interrupted(["report", file, "--quiet", "--threads", "1"], catches_interrupts)
    # the second where the file of the study is still being read
    assert said in ("drystone: interrupted; nothing was written\n", "drystone: interrupted; no result was finished\n"), said
    left = [name for name in names(folder) if not name.startswith("quick_summary")]
    assert left == ["quick", "quick.h5"], left


def claim_before_any_result(folder):
    """Verbs that write nothing before their end leave nothing behind."""
    said = interrupted(["scene", WALL, "--out", folder / "out", "--set", "wall.length=20 m", "--set", "wall.courses=400", "--set",
                        "load.height=40.1 m"], catches_interrupts)
    assert said == "drystone: interrupted; no result was finished\n" and not names(folder), (said, names(folder))


def claim_nohup(folder):
    """A signal that was ignored at the start stays so."""
    process = subprocess.Popen([PROGRAM, "study", QUICK, "--out", folder / "quick.h5", "--quiet", *RIGID, "--set", "uq.samples=4",
                                "--set", "solver.steps_per_mm=1000", "--set", "load.max_displacement=2 mm"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                               preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    wait_for(lambda: catches_interrupts(process) and (folder / "quick.h5").exists(), process)
    process.send_signal(signal.SIGHUP)
    _, said = process.communicate(timeout=FAR)
    assert process.returncode == 0, (process.returncode, said)


def claim_program(folder):
    """Runs of another program end with their directories, whatever the signals."""
    (folder / "model.sh").write_text("echo $$ >pid.new; mv pid.new $1/pid; sleep 100")
    (folder / "s.ini").write_text("[model]\ncommand = sh {here}/model.sh {here}\nresponses = r\nconcurrent = 1\n"
                                  "[variables]\na = normal(mean 1, sd 0.5)\n[reliability]\ndemand = 1\nbudget = 20\n")
    tmp, pid = folder / "tmp", folder / "pid"
    tmp.mkdir()
    for signals in ([signal.SIGQUIT], [signal.SIGINT] * 4, [signal.SIGTERM]):
        said = interrupted(["reliability", "s.ini", "--out", "out", "--quiet"], exists(pid),
                           signals, cwd=folder, env={**os.environ, "TMPDIR": str(tmp)})
        assert "the evaluations made so far are in out/evaluations.csv" in said, said
        assert (folder / "out/evaluations.csv").exists() and not list(tmp.iterdir()), list(tmp.iterdir())
        assert not os.path.exists(f"/proc/{pid.read_text().strip()}"), "the program still runs"
        pid.unlink()


with tempfile.TemporaryDirectory() as place:
    globals()["claim_" + CLAIM](pathlib.Path(place))
