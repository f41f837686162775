#!/usr/bin/env python3
"""Runs every fuzzer of a build for some time, as many at once as there are cores, and adds what came of it to a
record. The inputs differ from run to run; those that reach something new are kept in the build tree, and the next
campaign starts with them.

usage: tools/fuzz_campaign.py BUILD SECONDS FILE.json
BUILD is a build tree (build/release) whose tests fuzz.* are the fuzzers, each of which runs for SECONDS. Where
FILE.json holds earlier campaigns, executions, seconds and findings are added up. Exit codes: 0 nothing found,
1 something, each named, 2 bad usage.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

from trial_record import write_record


def fuzzers(build):
    listed = subprocess.run(["ctest", "--test-dir", build, "-R", "^fuzz\\.", "--show-only=json-v1"], check=True,
                            capture_output=True, text=True)
    return {test["name"].removeprefix("fuzz."): test["command"] for test in json.loads(listed.stdout)["tests"]}


def campaign(command, seconds):
    """What one fuzzer did: its last line of coverage and its final statistics."""
    fuzzer, *words = command
    prefix = next(word for word in words if word.startswith("-artifact_prefix="))
    kept = pathlib.Path(prefix.removeprefix("-artifact_prefix=").removesuffix("-"))
    kept.mkdir(exist_ok=True)
    bounds = ("-seed=", "-runs=", "-max_total_time=", "-verbosity=")
    words = [word for word in words if not word.startswith(bounds)]
    # What a campaign keeps goes into the first folder.
    command = [fuzzer, f"-max_total_time={seconds}", "-verbosity=1", str(kept), *words]
    ended = subprocess.run(command + ["-print_final_stats=1"], capture_output=True, text=True, errors="replace", check=False)
    executions = re.search(r"number_of_executed_units: (\d+)", ended.stderr)
    features = re.findall(r" ft: (\d+)", ended.stderr)
    return {"executions": int(executions.group(1)) if executions else 0, "features": int(features[-1]) if features else 0,
            "found": 0 if ended.returncode == 0 else 1}


def with_earlier(rows, seconds, record):
    """The figures of this campaign, and those of the earlier ones that the record holds; coverage is the last."""
    path = pathlib.Path(record)
    earlier = json.loads(path.read_text()) if path.exists() else {"seconds": 0, "fuzzers": []}
    known = {row["fuzzer"]: row for row in earlier["fuzzers"]}
    for row in rows:
        for figure in ("executions", "found"):
            row[figure] += known.get(row["fuzzer"], {}).get(figure, 0)
    return {"seconds": earlier["seconds"] + seconds, "fuzzers": rows}


def main():
    if len(sys.argv) != 4 or not sys.argv[2].isdigit():
        print(__doc__.splitlines()[4], file=sys.stderr)
        return 2
    build, seconds, record = sys.argv[1], int(sys.argv[2]), sys.argv[3]

    def one(named):
        row = {"fuzzer": named[0], **campaign(named[1], seconds)}
        print(row, flush=True)
        return row

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        rows = list(pool.map(one, sorted(fuzzers(pathlib.Path(build)).items())))
    found = any(row["found"] for row in rows)
    write_record(record, with_earlier(rows, seconds, record))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
