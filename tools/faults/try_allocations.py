#!/usr/bin/env python3
"""Refuses memory to every command of the program, one request at a time, and tells how it ends.

usage: tools/faults/try_allocations.py PROGRAM LIBRARY [--runs N] [--seed S] [--json FILE] [--processes P] [--only COMMAND]
PROGRAM is wavecurve, LIBRARY the built tools/faults/fail_allocation.cpp. N (40) of the requests for memory that
each command makes are refused, one a run, chosen at random from the seed (1), but always the
first and the last ones; in every other run all requests after it are refused, too. A run ends well if it
does what it does with memory (exit code, output and files alike), or says in one line that memory is lacking,
with exit code 3, no file written. glibc itself ends a program that has no memory for the variables of a thread, with
one line and exit code 127: counted by itself. Writes the counts as JSON. Exit codes: 0 all runs end
well, 1 some do not, each named, 2 bad usage.
"""
import argparse
import concurrent.futures
import gzip
import json
import os
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from trial_record import write_record

SQUARE = '<svg viewBox="0 0 9 9"><style>.a{fill:red}</style><path class="a" d="M0 0H9V9H0Z"/></svg>'
DISC = '<svg viewBox="0 0 9 9"><g transform="scale(2)"><circle id="c" cx="2" cy="2" r="2"/></g></svg>'
TABLE = "filter,quantity,index,printed\ndb2,h,0,0.48296\ndb2,alpha,0,1.0\ndb3,mu,0,5.26794\n"
TAPS = ('{"taps": ["0.48296291314453", "0.83651630373781", "0.22414386804201", "-0.12940952255126"], '
        '"sum": "sqrt2"}')
NUMBERS = "0.48296291314453, 0.83651630373781, 0.22414386804201, -0.12940952255126"
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "docs/examples"
COMMANDS = {
    "help": "--help",
    "version": "--version",
    "filter": "filter coif2",
    "filter, own": "filter own.json --format json",
    "coefficients": "coefficients db3 --digits 20",
    "coefficients, integral": "coefficients db4 --integral \"phi' phi(l)\" --digits 20",
    "coefficients, interval": "coefficients db4 --integral \"phi' phi(l) phi(m)\" --on 0,1/2 --digits 20",
    "coefficients, operator": "coefficients db4 --operator hilbert --digits 20",
    "coefficients, moments": "coefficients db4 --moments 4 --digits 20",
    "coefficients, up to x": "coefficients db3 --integral \"phi'(l) phi\" --on 0,x --digits 20",
    "coefficients, fractions": "coefficients bspline2.2 --integral \"phi phi(l) phi(m)\"",
    "check": "check table.csv --format json",
    "identify": "identify numbers.txt",
    "stiffness": "stiffness db4 --samples 32 --output K.mtx",
    "matrix": "matrix db4 --samples 32 --form nonstandard --output D.mtx",
    "describe": "describe a.svg --samples 32 -o d.json",
    "distance": "distance a.svg b.svg --samples 32",
    "reconstruct": "reconstruct in.json -o r.svg",
    "morph, svg": "morph a.svg b.svg --samples 32 --frames 4 -o m.svg",
    "morph, json": "morph a.svg b.svg --samples 32 --frames 4 --motion physical -o m.json",
    "morph, gif": "morph a.svg b.svg --samples 32 --frames 2 -o m.gif",
    "compare": "compare --samples 16 --shape ellipse --damping 0,0 --solvers spectral,implicit --format json",
    "gait fit": "gait fit walk.csv.gz --samples 16 --scale 4 --model linear -o f.json",
    "gait show": "gait show gait.json",
    "gait synthesize": f"gait synthesize gait.json '{EXAMPLES / 'dog.svg'}' --samples 32 --frames 4 -o w.svg",
    "verify": "verify --only erratum-2-5 --output report",
    "refused drawing": "describe bad.svg",
}


def untried_commands(program):
    """Those that help lists and no line above calls. bench runs programs, so its requests are of any number."""
    listed = subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout
    names = re.findall(r"^  ([a-z]+) ", listed.partition("Subcommands:")[2], re.MULTILINE)
    return sorted(set(names) - {line.split()[0] for line in COMMANDS.values()} - {"bench"})


def prepare(folder, program):
    with gzip.open(folder / "walk.csv.gz", "wb") as packed:
        packed.write((EXAMPLES / "dog-walk.csv").read_bytes())
    (folder / "a.svg").write_text(SQUARE)
    (folder / "b.svg").write_text(DISC)
    (folder / "bad.svg").write_text("<svg><path")
    (folder / "table.csv").write_text(TABLE)
    (folder / "own.json").write_text(TAPS)
    (folder / "numbers.txt").write_text(NUMBERS)
    for line in ("describe a.svg --samples 32 -o in.json",
                 f"gait fit '{EXAMPLES / 'dog-walk.csv'}' --model cubic -o gait.json"):
        subprocess.run([program, *shlex.split(line)], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def untimed(text):
    """Without the seconds that a run took, which differ."""
    return re.sub(rb'"seconds": *[-+.e0-9]+', b"", text)


def files_of(folder):
    """All but temporary ones: a program without memory may leave them, and the next run removes them."""
    return {str(path.relative_to(folder)): untimed(path.read_bytes())
            for path in sorted(folder.rglob("*")) if path.is_file() and ".wavecurve-" not in str(path)}


class Trial:
    """One command in a folder of its own, run again and again."""

    def __init__(self, options, ground, command):
        self.options, self.ground, self.command = options, ground, command

    def run(self, environment):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "here"
            shutil.copytree(self.ground, folder)
            variables = {**os.environ, "LD_PRELOAD": self.options.library, "LC_ALL": "C",
                         "SOURCE_DATE_EPOCH": "0",
                         **{name: value.replace("HERE", place) for name, value in environment.items()}}
            ended = subprocess.run([self.options.program, *shlex.split(self.command)], cwd=folder, env=variables,
                                   stdin=subprocess.DEVNULL, capture_output=True, timeout=300)
            count = pathlib.Path(place) / "count"
            requests = int(count.read_text()) if count.exists() else 0
            return ended, files_of(folder), requests

    def outcome(self, environment, usual, before):
        ended, files, _ = self.run(environment)
        lines = ended.stderr.count(b"\n")
        if ended.returncode < 0:
            return "signal"
        if ended.returncode == 127:
            return "glibc" if lines <= 1 else "other"
        if ended.returncode == 3 and lines == 1 and set(files) >= set(before):
            return "refused"
        same_output = untimed(ended.stdout) == untimed(usual[0].stdout)
        if ended.returncode == usual[0].returncode and files == usual[1] and same_output:
            return "unharmed"
        return "other"


def requests_to_refuse(total, runs, chance):
    edges = [1, 2, 3, total - 1, total]
    return sorted({n for n in edges if 1 <= n <= total} |
                  {chance.randint(1, total) for _ in range(max(0, runs - len(edges)))})


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("library")
    parser.add_argument("--runs", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json")
    parser.add_argument("--only", choices=COMMANDS)
    parser.add_argument("--processes", type=int, default=os.cpu_count())
    options = parser.parse_args()
    options.program, options.library = map(os.path.abspath, (options.program, options.library))
    chance, report = random.Random(options.seed), {}
    bad = [f"{name}: not among the commands that are tried" for name in untried_commands(options.program)]
    with tempfile.TemporaryDirectory() as place:
        ground = pathlib.Path(place) / "ground"
        ground.mkdir()
        prepare(ground, options.program)
        before = files_of(ground)
        for name, command in COMMANDS.items():
            if options.only and options.only != name:
                continue
            trial = Trial(options, ground, command)
            usual = trial.run({"COUNT_ALLOCATIONS": "HERE/count"})
            chosen = [f"{n}{'+' if i % 2 else ''}" for i, n in
                      enumerate(requests_to_refuse(usual[2], options.runs, chance))]
            with concurrent.futures.ThreadPoolExecutor(options.processes) as pool:
                ends = list(pool.map(
                    lambda n, t=trial, u=usual: t.outcome({"FAIL_ALLOCATION": n}, u, before), chosen))
            report[name] = {"requests": usual[2], "runs": len(chosen),
                            **{kind: ends.count(kind)
                               for kind in ("unharmed", "refused", "glibc", "signal", "other")}}
            bad += [f"{name}: request {n}: {end}" for n, end in zip(chosen, ends)
                    if end in ("signal", "other")]
    total = {key: sum(row[key] for row in report.values()) for key in
             ("runs", "unharmed", "refused", "glibc", "signal", "other")}
    figures = {"commands": report, "total": total}
    print(json.dumps(figures, indent=1))
    if options.json:
        write_record(options.json, figures)
    for line in bad:
        print(line, file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
