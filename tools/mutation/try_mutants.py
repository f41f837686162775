#!/usr/bin/env python3
"""Tries whether the tests notice small faults in the numeric rooms of the library.

usage: tools/mutation/try_mutants.py TREE COUNT SEED RECORD.json

TREE is a clone of the project, whose sources are changed and whose build is TREE/build. COUNT mutants are drawn with
SEED (mutants.py); those that do not compile are dropped. Each has to fail the tests that stand beside its file, else
those of its room, else those of any room; one that runs ten times as long as the right program is noticed too. What
passes everything has survived. Exit codes: 0 at least 95 of 100 are noticed, 1 fewer, 2 bad usage, 3 the clone cannot
be built or fails its tests without a mutant.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from mutants import ROOMS, draw_mutants, planted  # noqa: E402
from trial_record import write_record  # noqa: E402

# Assertions of Eigen and of the standard library notice what reads beyond an end.
FLAGS = "-O1 -D_GLIBCXX_ASSERTIONS"
TESTS = [f"{room}_tests" for room in ROOMS]


def run(command, **options):
    return subprocess.run(command, capture_output=True, text=True, errors="replace", check=False, **options)


def configure(tree):
    return run(["cmake", "-S", tree, "-B", tree / "build", "-G", "Ninja", "-DWAVECURVE_TESTS=ON", "-DWAVECURVE_BENCHMARKS=OFF",
                "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_FLAGS={FLAGS}"])


def source_at_head(tree, file):
    return subprocess.run(["git", "-C", tree, "show", f"HEAD:{file}"], check=True, capture_output=True).stdout


def drawn_before(tree, count, seed):
    """The mutants, drawn at most once for a revision: that takes minutes."""
    revision = run(["git", "-C", tree, "rev-parse", "HEAD"]).stdout.strip()
    record = tree.parent / f"drawn-{revision}-{count}-{seed}.json"
    if not record.exists():
        record.write_text(json.dumps(draw_mutants(tree, count, seed)))
    return json.loads(record.read_text())


def plant_all(tree, mutants):
    """Each source with its mutants, or without any; what stands there already is not written anew."""
    of_a_file = {file: [] for file in run(["git", "-C", tree, "ls-files", "lib/wavecurve"]).stdout.split()}
    for mutant in mutants:
        of_a_file[mutant["file"]].append(mutant)
    for file, some in of_a_file.items():
        text = source_at_head(tree, file) if some else b""
        if some and (tree / file).read_bytes() != planted(text, some):
            (tree / file).write_bytes(planted(text, some))
        elif not some and b"mutation::is(" in (tree / file).read_bytes():
            (tree / file).write_bytes(source_at_head(tree, file))


def build(tree, mutants):
    """Plants and builds; returns the mutants that compile."""
    while True:
        plant_all(tree, mutants)
        built = run(["cmake", "--build", tree / "build", "--target", *TESTS, "--", "-k", "0"])
        if built.returncode == 0:
            return mutants
        places = {(file, int(line)) for file, line in re.findall(r"(lib/wavecurve/[\w/.-]+):(\d+)", built.stdout)}
        kept = [mutant for mutant in mutants if (mutant["file"], mutant["line"]) not in places]
        if len(kept) == len(mutants):
            print(built.stdout[-4000:], file=sys.stderr)
            sys.exit(3)
        mutants = kept


def nearest_tests(tree, file):
    """The test program's filter for what stands beside the file; empty if nothing does."""
    path = tree / file
    suites = set()
    for test in path.parent.glob(path.stem + "*_test.cpp"):
        suites |= set(re.findall(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP)\((\w+),", test.read_text(), re.M))
    return ":".join(f"{s}.*:*/{s}.*:{s}/*" for s in sorted(suites))


def passes(tree, program, number, limit, tests="*"):
    environment = {**os.environ, "WAVECURVE_MUTANT": str(number)}
    try:
        return run([tree / "build/bin" / program, "--gtest_brief=1", "--gtest_fail_fast", f"--gtest_filter={tests}"],
                   env=environment, timeout=limit).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def seconds_without_mutants(tree):
    seconds = {}
    for program in TESTS:
        start = time.monotonic()
        if not passes(tree, program, 0, 3600):
            print(f"{program} fails without a mutant", file=sys.stderr)
            sys.exit(3)
        seconds[program] = time.monotonic() - start
    return seconds


def noticed_by(tree, mutant, seconds):
    """The first group of tests that fails: beside, room, others; none if all pass."""
    own = mutant["room"] + "_tests"
    limit = {program: 10 + 10 * time_ for program, time_ in seconds.items()}
    beside = nearest_tests(tree, mutant["file"])
    if beside and not passes(tree, own, mutant["number"], limit[own], beside):
        return "beside"
    if not passes(tree, own, mutant["number"], limit[own]):
        return "room"
    for program in sorted(set(TESTS) - {own}, key=seconds.get):
        if not passes(tree, program, mutant["number"], limit[program]):
            return "others"
    return "none"


def main():
    if len(sys.argv) != 5 or not (sys.argv[2].isdigit() and sys.argv[3].isdigit()):
        print(__doc__.splitlines()[2], file=sys.stderr)
        return 2
    tree, count, seed, record = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
    drawn = drawn_before(tree, count, seed)
    print(f"{len(drawn)} mutants drawn", flush=True)
    configured = configure(tree)
    if configured.returncode != 0:
        print(configured.stderr, file=sys.stderr)
        return 3
    mutants = build(tree, drawn)
    print(f"{len(drawn) - len(mutants)} of {len(drawn)} mutants do not compile", flush=True)
    seconds = seconds_without_mutants(tree)
    print(f"{len(mutants)} mutants built; the tests take {sum(seconds.values()):.0f} s without one", flush=True)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        def try_one(mutant):
            by = noticed_by(tree, mutant, seconds)
            print(f"{mutant['file']}:{mutant['line']}: {mutant['from']} -> {mutant['to']}: {by}", flush=True)
            return by
        noticed = list(pool.map(try_one, mutants))
    rows = [{"room": room, "mutants": sum(m["room"] == room for m in mutants),
             **{by: sum(m["room"] == room and b == by for m, b in zip(mutants, noticed))
                for by in ("beside", "room", "others", "none")}} for room in ROOMS]
    survivors = [{key: m[key] for key in ("file", "line", "from", "to")} for m, by in zip(mutants, noticed) if by == "none"]
    write_record(record, {"seed": seed, "drawn": len(drawn), "rows": rows, "survivors": survivors})
    caught = len(mutants) - len(survivors)
    print(f"{caught} of {len(mutants)} mutants are noticed, {100 * caught / max(len(mutants), 1):.1f} %")
    return 0 if 100 * caught >= 95 * len(mutants) else 1


if __name__ == "__main__":
    sys.exit(main())
