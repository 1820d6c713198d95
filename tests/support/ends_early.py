#!/usr/bin/env python3
"""Every command that can take long ends soon when it is told to, and leaves valid files: by SIGINT (exit 130), by
--max-seconds (exit 5), while it reads and while it works. On a terminal it shows how far it is.

Usage: ends_early.py CAROM [COMMAND ...]

Each task takes seconds to minutes on an idle machine. A loaded machine must not fail the test, so that the bound is wide; what was measured is
printed. Uses nothing but the standard library."""
import glob
import json
import os
import pty
import select
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

CAROM = os.path.abspath(sys.argv[1])
WANTED = sys.argv[2:]
BOUND = 20  # s
LIMIT = 0.5  # s, of --max-seconds
AFTER = 0.3  # s: when the signal comes, counted from when the command listens to it

GAS = {"format": "carom-scene/1", "end_time": 1e6, "box": {"min": [0, 0, 0], "max": [20, 20, 20]},
       "fill": [{"pattern": "cubic", "count": 5000, "radius": 0.25, "speed": 1}],
       "checks": [{"type": "no_overlap"}], "compare": {"methods": ["event", "pbd"], "dt": [1e-3]}}
# So many that finding their places takes long.
CROWD = {"format": "carom-scene/1", "end_time": 1, "box": {"min": [0, 0, 0], "max": [100, 100, 100]},
         "fill": [{"pattern": "random", "count": 8000000, "radius": 0.02, "speed": 1},
                  {"pattern": "random", "count": 2000000, "radius": 0.02, "speed": 1}]}


SILENCE = os.pipe()  # nobody ever writes into it, nor closes it


def command(*args):
    return [CAROM, *args]


def listens(process):
    """Whether the process has taken SIGINT over."""
    with open(f"/proc/{process.pid}/status") as status:
        caught = next(line for line in status if line.startswith("SigCgt:"))
    return int(caught.split()[1], 16) >> (signal.SIGINT - 1) & 1


def interrupted(args):
    """Exit code and seconds from the signal to the end."""
    process = subprocess.Popen(args, stdin=SILENCE[0], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    while process.poll() is None and not listens(process):
        time.sleep(0.01)
    time.sleep(AFTER)
    assert process.poll() is None, f"was done before the signal: {args}"
    process.send_signal(signal.SIGINT)
    start = time.monotonic()
    out, err = process.communicate(timeout=10 * BOUND)
    return process.returncode, time.monotonic() - start, out.decode(), err.decode()


def limited(args):
    """Exit code and seconds beyond the limit."""
    start = time.monotonic()
    done = subprocess.run([*args, "--max-seconds", str(LIMIT)], stdin=SILENCE[0], capture_output=True,
                          timeout=10 * BOUND)
    return done.returncode, time.monotonic() - start - LIMIT, done.stdout.decode(), done.stderr.decode()


def check_files(folder):
    """Whatever files there are, they are whole."""
    for name in glob.glob(os.path.join(folder, "**"), recursive=True):
        if name.endswith(".json"):
            json.load(open(name))
        elif name.endswith(".carom"):
            with sqlite3.connect(name) as recording:
                assert recording.execute("PRAGMA integrity_check").fetchone() == ("ok",), name
                assert recording.execute("SELECT count(*) FROM meta WHERE key = 'status'").fetchone() == (1,), name
        elif name.endswith(".csv"):
            lines = open(name).read().split("\n")
            assert lines.pop() == "", f"{name}: its last line is cut"
            commas = lines[0].count(",")
            assert all(line.count(",") >= commas for line in lines), f"{name}: a line lacks columns"
        elif name.endswith(".html"):
            assert open(name).read().rstrip().endswith("</html>"), name
        assert not name.endswith(".part"), name


def progress(args, words, seconds):
    """What a command writes to a terminal until all these words are there, or so many seconds are over."""
    terminal, end = pty.openpty()
    process = subprocess.Popen(args, stdout=subprocess.DEVNULL, stderr=end)
    os.close(end)
    text, start = "", time.monotonic()
    while time.monotonic() < start + seconds and not all(word in text for word in words):
        if not select.select([terminal], [], [], 0.1)[0]:
            continue
        try:
            text += os.read(terminal, 65536).decode()
        except OSError:  # the command is done
            break
    process.send_signal(signal.SIGINT)
    process.wait()
    os.close(terminal)
    return text


def main():
    with tempfile.TemporaryDirectory() as work:
        def file(name, scene):
            path = os.path.join(work, name)
            with open(path, "w") as stream:
                json.dump(scene, stream)
            return path

        gas, crowd = file("gas.json", GAS), file("crowd.json", CROWD)
        out = os.path.join(work, "out")
        recording, pages = os.path.join(work, "recording"), os.path.join(work, "pages")
        subprocess.run(command("run", gas, "--until", "40", "-q", "-o", recording), check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run(command("compare", "bouncing_ball", "--methods", "event", "-q", "-o", pages), check=True,
                       stdout=subprocess.DEVNULL)
        traced = os.path.join(work, "traced")
        subprocess.run(command("run", gas, "--until", "8", "--frames", "30", "-q", "-o", traced), check=True,
                       stdout=subprocess.DEVNULL)
        trace = os.path.join(traced, "frames.csv")
        # What a command does, whether it has a result when it is stopped, and how it says that it was stopped.
        tasks = {
            "read": (command("run", crowd, "--json"), None),
            "read a pipe": (command("check", "/dev/stdin", "--json"), None),
            "run": (command("run", gas, "--json", "-o", out, "--events", os.path.join(work, "events.csv")), "status"),
            "run pbd": (command("run", gas, "--json", "--method", "pbd", "-o", out), "status"),
            "run moreau": (command("run", gas, "--json", "--method", "moreau", "-o", out), "status"),
            "compare": (command("compare", gas, "--json", "-o", out), "stopped"),
            "compare rows": (command("compare", "gas_1000", "--until", "0.01", "--methods", "pbd,velocity", "--dt",
                                     "1e-8", "--json", "-o", out), "stopped"),
            "check": (command("check", "cradle", gas, "--json"), "stopped"),
            "stress": (command("stress", "--json", "-o", out), "stopped"),
            "tunnel": (command("tunnel", "--trials", "100000", "--json", "-o", out), "stopped"),
            "tunnel scene": (command("tunnel", gas, "--trials", "1000000", "--json", "-o", out), "stopped"),
            "verify": (command("verify", recording, "--all-pairs", "--json"), "stopped"),
            "audit": (command("audit", trace, "--scene", gas, "--json", "-o", out), None),
            "report": (command("report", *[pages] * 20000, "--json", "-o", os.path.join(out, "all.html")), None),
        }
        print(f"{'':14}{'SIGINT: exit':>14}{'after':>10}{'limit: exit':>14}{'beyond':>10}")
        wrong = []
        for name, (args, key) in tasks.items():
            if WANTED and name not in WANTED:
                continue
            line = f"{name:14}"
            for stop, expected, word in ((interrupted, 130, "interrupted"), (limited, 5, "time_limit")):
                subprocess.run(["rm", "-rf", out], check=True)
                code, seconds, said, err = stop(args)
                line += f"{code:14}{seconds:8.2f} s"
                try:
                    assert code == expected, f"exit {code}: {err}"
                    assert seconds < BOUND, f"{seconds:.1f} s"
                    if key:
                        assert json.loads(said)[key] == word, said[:1000]
                    check_files(work)
                except (AssertionError, ValueError, KeyError) as problem:
                    wrong.append(f"{name}, {word}: {problem}")
            print(line, flush=True)
        for name, args, words in (("read", command("run", crowd), ("fill-0: ", " spheres/s")),
                                  ("run", command("run", gas), ("run: t = ", " s left")),
                                  ("compare", command("compare", gas, "-o", out), ("reference", " %")),
                                  ("stress", command("stress"), (", ", " %")),
                                  ("tunnel", command("tunnel", "--trials", "100000"), ("event", " %")),
                                  ("verify", command("verify", recording, "--all-pairs"), ("flights: ", " %"))):
            if WANTED and name not in WANTED:
                continue
            text = progress(args, words, BOUND)
            if not all(word in text for word in words):
                wrong.append(f"{name}: progress {text[-300:]!r}")
        for option in ("--no-progress", "-q"):
            # Long enough for a line that comes after a second.
            text = progress(command("run", gas, option), ("run: t = ",), 1.5)
            if text:
                wrong.append(f"run {option}: progress {text[-300:]!r}")
        for problem in wrong:
            print(problem)
        return 1 if wrong else 0


sys.exit(main())
