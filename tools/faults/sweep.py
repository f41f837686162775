#!/usr/bin/env python3
"""Lets every command that writes meet every failure: of each system call, by signals, on a full disk, two at once.

usage: sweep.py --program WAVECURVE --library FAILING_CALLS.so --source DIR [--sample N] [--output FILE.json]

Each run starts from a folder that holds the output of an older run. After it
  - the exit code is 0, with the complete right output, or 2 or 3, with one line on the error stream;
  - the older output is there, byte for byte, or the new one is;
  - no temporary file remains (where removing failed, or after SIGKILL: none after the next run);
  - nothing has crashed.
--sample N takes every N-th failure only. Exit codes: 0 all held, 1 some did not, each named, 2 bad usage.
The figures go to FILE.json: {"sample", "seconds", "rows": [{"command", "failure", "runs", "done", "refused", "ended",
"broken"}]}; done: exit code 0, refused: 2 or 3, ended: by the signal that was sent, as it should.
"""
import argparse
import collections
import concurrent.futures
import errno
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from trial_record import write_record

ERRORS = {"write": errno.ENOSPC, "short": 0, "fsync": errno.EIO, "rename": errno.ENOSPC, "open": errno.EMFILE,
          "close": errno.EIO, "fchmod": errno.EPERM, "chmod": errno.EPERM, "mkstemp": errno.ENOSPC,
          "mkdtemp": errno.ENOSPC, "fopen": errno.EMFILE, "tmpfile": errno.ENOSPC, "read": errno.EIO,
          "spawn": errno.EAGAIN, "ftruncate": errno.EIO, "unlink": errno.EIO, "mkdir": errno.ENOSPC,
          "link": errno.EPERM, "pipe": errno.EMFILE, "socketpair": errno.EMFILE, "thread": errno.EAGAIN}
TEMPORARY = re.compile(r"^\.wavecurve-\d+-\d+$|\.wavecurve-old$")
ENDS = {".html": b"</html>", ".svg": b"</svg>"}
PATIENCE = 60  # seconds

# A name, the arguments of an older run, and those of a newer one. What is timed differs in its seconds.
Command = collections.namedtuple("Command", "name older newer is_timed", defaults=[False])


def commands(examples):
    face = f"{examples}/face-cat.svg {examples}/face-dog.svg"
    walk = f"{examples}/dog-walk.csv"
    morph = [Command(f"morph {kind}", f"morph {face} --samples 64 --frames 3 -o o{kind}",
                     f"morph {face} --samples 32 --frames 4 -o o{kind}")
             for kind in (".svg", ".json", ".html", ".gif", ".mp4", ".webm", ".png")]
    study = "compare --samples 16 --shape star --damping 0,0 -o study --solvers decoupled"
    return morph + [
        Command("morph --sheet", f"morph {face} --sheet --frames 3 -o o.svg",
                f"morph {face} --sheet --frames 4 -o o.svg"),
        Command("describe", f"describe {examples}/three.svg --samples 16 -o o.json",
                f"describe {examples}/three.svg --samples 32 -o o.json"),
        Command("reconstruct", "reconstruct d.json --scale 16 -o o.svg", "reconstruct d.json -o o.svg"),
        Command("stiffness .mtx", "stiffness db4 --samples 16 --output o.mtx",
                "stiffness db4 --samples 32 --output o.mtx"),
        Command("stiffness .svg", "stiffness db4 --samples 16 --output o.svg",
                "stiffness db4 --samples 32 --output o.svg"),
        Command("matrix", "matrix db4 --samples 16 --output o.mtx", "matrix db4 --samples 32 --output o.mtx"),
        Command("gait fit", f"gait fit {walk} --scale 16 -o o.json", f"gait fit {walk} --scale 8 -o o.json"),
        Command("gait synthesize", f"gait synthesize g.json {examples}/dog.svg --frames 3 -o o.json",
                f"gait synthesize g.json {examples}/dog.svg --frames 4 -o o.json"),
        Command("check -o", "check t.csv -o o.html", "check u.csv -o o.html"),
        # All points are in the journal, so that every byte of the new output is known.
        Command("compare -o", study, study + ",spectral,implicit"),
        Command("compare -o, measured", study, study.replace("star", "dent") + ",implicit-ldlt --format json", True),
        Command("verify", "verify --only erratum-2-5 --output report",
                "verify --only erratum-2-5 --only decoupling --output report"),
        Command("verify --bless", "verify --only erratum-2-5 --bless --reference r.json --output report",
                "verify --only erratum-2-5 --only erratum-3-15 --bless --reference r.json --output report"),
        Command("bench history", "bench history --history one -o pages", "bench history --history two -o pages"),
    ]


class Sweep:
    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.environment = dict(os.environ, SOURCE_DATE_EPOCH="1000000000", LC_ALL="C")
        self.rows = collections.Counter()
        self.broken = []

    def start(self, arguments, folder, **faults):
        environment = dict(self.environment, **{name: str(value) for name, value in faults.items()})
        if faults:
            environment["LD_PRELOAD"] = self.options.library
        return subprocess.Popen([self.options.program, *arguments.split()], cwd=folder, env=environment,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run(self, arguments, folder, **faults):
        process = self.start(arguments, folder, **faults)
        try:
            out, err = process.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return "endless", b"", b""
        return process.returncode, out, err

    def must_run(self, arguments, folder):
        code, out, err = self.run(arguments, folder)
        if code != 0:
            sys.exit(f"sweep.py: {arguments} ends with {code}: {err.decode(errors='replace')}")
        return out

    def template(self, command):
        """The folder from which each run starts, and the output before and after."""
        folder = self.folder / re.sub(r"\W+", "_", command.name)
        folder.mkdir()
        examples = self.options.source + "/docs/examples"
        (folder / "t.csv").write_text("filter,quantity,index,printed\ndb4,alpha,1,1.196289\n")
        (folder / "u.csv").write_text("filter,quantity,index,printed\ndb4,alpha,1,1.19629\n")
        history = sorted(pathlib.Path(self.options.source, "benchmarks/history").glob("*.json"))
        for name, records in (("one", history[:1]), ("two", history[:2])):
            (folder / name).mkdir()
            for record in records:
                (folder / name / record.name).write_text(json.dumps(small_record(json.loads(record.read_text()))))
        if command.name == "reconstruct":
            self.must_run(f"describe {examples}/three.svg --samples 64 -o d.json", folder)
        if command.name == "gait synthesize":
            self.must_run(f"gait fit {examples}/dog-walk.csv --scale 16 -o g.json", folder)
        if command.name == "compare -o":  # the journal of the newer run, and the output of the older
            self.must_run(command.newer, folder)
            journal = (folder / "study/compare.points.jsonl").read_bytes()
            shutil.rmtree(folder / "study")
            (folder / "study").mkdir()
            (folder / "study/compare.points.jsonl").write_bytes(journal)
        self.must_run(command.older, folder)
        before = contents(folder, command)
        after_folder = self.copy(folder)
        out = self.must_run(command.newer, after_folder)
        after = contents(after_folder, command)
        if before == after:
            sys.exit(f"sweep.py: {command.name} changes nothing")
        shutil.rmtree(after_folder)
        return folder, before, after, without_seconds(out) if command.is_timed else out

    def copy(self, folder):
        copy = pathlib.Path(tempfile.mkdtemp(dir=self.folder)) / "work"
        shutil.copytree(folder, copy, symlinks=True)
        return copy

    def judge(self, command, failure, folder, states, result, sent=None):
        """What became of a run: counted, and what is wrong with it kept."""
        before, after, expected_out = states
        code, out, err = result
        now = contents(folder, command)
        problems = []
        if temporaries(now) and (failure.startswith("unlink") or sent == signal.SIGKILL):
            self.run(command.newer, folder)  # the next run tidies up
            left = temporaries(contents(folder, command))
            now = {name: content for name, content in now.items() if name not in temporaries(now)}
        else:
            left = temporaries(now)
        if left:
            problems.append(f"leaves {sorted(left)[0]}")
        if sent is not None and code == -sent:
            outcome = "ended"
        elif code == 0:
            outcome = "done"
            if now != after:
                problems.append("exit code 0 without the right output: " + difference(now, after))
            if (without_seconds(out) if command.is_timed else out) != expected_out:
                problems.append("exit code 0 with another text")
        elif code in (2, 3):
            outcome = "refused"
            if err.count(b"\n") != 1 or not err.endswith(b"\n"):
                problems.append(f"no single line: {err[:300]!r}")
        else:
            outcome = "broken"
            problems.append(f"ends with {code}: {err[-300:]!r}")
        mixed = {name for name in now if now[name] not in (before.get(name), after.get(name))}
        if sent == signal.SIGKILL:  # within the renames of several files each is whole
            if mixed:
                problems.append(f"{sorted(mixed)[0]} is neither the old nor the new one")
        else:  # each file or folder that is written, the report and the reference say, by itself
            for unit in sorted({name.split("/")[0] for name in {*now, *before, *after}}):
                found, old, new = (part(files, unit) for files in (now, before, after))
                if found not in (old, new):
                    problems.append("neither the old output nor the new: " + difference(found, old))
        if command.is_timed and code != 0:  # what was measured is taken up
            self.must_run(command.newer, folder)
            if contents(folder, command) != after:
                problems.append("cannot be taken up")
        self.rows[command.name, failure.split()[0], "broken" if problems else outcome] += 1
        self.broken += [f"{command.name}, {failure}: {problem}" for problem in problems]

    def one_call(self, command, template, call, number, program, more):
        folder = self.copy(template[0])
        result = self.run(command.newer, folder, FAULT_CALL=call, FAULT_AT=number, FAULT_ERROR=ERRORS[call],
                          FAULT_PROGRAM=program, **more)
        where = call if program == "wavecurve" else f"{program}:{call}"
        self.judge(command, f"{where} {number}", folder, template[1:], result)
        shutil.rmtree(folder.parent)

    def one_signal(self, command, template, number, seconds, more):
        folder = self.copy(template[0])
        process = self.start(command.newer, folder, **more)
        try:
            time.sleep(seconds)
            process.send_signal(number)
            out, err = process.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
        name = signal.Signals(number).name
        self.judge(command, f"{name} {seconds:.3f}", folder, template[1:], (process.returncode, out, err), number)
        shutil.rmtree(folder.parent)

    def two_at_once(self, command, template):
        folder = self.copy(template[0])
        runs = [self.start(command.newer, folder) for _ in range(2)]
        results = [(run, *run.communicate(timeout=PATIENCE)) for run in runs]
        for run, out, err in results:
            self.judge(command, "two-at-once", folder, template[1:], (run.returncode, out, err))
        shutil.rmtree(folder.parent)

    def jobs(self, command):
        """All runs of a command, to be called in any order."""
        template = self.template(command)
        yield from self.faults_and_signals(command, template)
        if command.name == "morph .png":
            yield from self.faults_and_signals(command, template, FAULT_NO_EXCHANGE=1)
        yield lambda: self.two_at_once(command, template)

    def faults_and_signals(self, command, template, **more):
        programs = ["wavecurve"] + (["ffmpeg"] if command.name in ("morph .gif", "morph .mp4") else [])
        for program in programs:
            for call, count in self.counts(command, template[0], program, more).items():
                if program != "wavecurve" and call not in ("write", "short", "read"):
                    continue
                # ffmpeg reads its frames in many calls; one like the other.
                step = 1 if program == "wavecurve" else max(1, count // 8)
                for number in range(1, count + 1, step):
                    yield lambda p=program, c=call, n=number: self.one_call(command, template, c, n, p, more)
        start = time.monotonic()
        timed = self.copy(template[0])
        self.must_run(command.newer, timed)
        shutil.rmtree(timed.parent)
        duration = time.monotonic() - start
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
            # Not before the program has begun to listen.
            for step in range(5):
                seconds = 0.03 + duration * step / 5
                yield lambda n=number, s=seconds: self.one_signal(command, template, n, s, more)

    def counts(self, command, template, program, more):
        folder = self.copy(template)
        counts = collections.Counter()
        self.run(command.newer, folder, FAULT_AT=0, FAULT_PROGRAM=program, FAULT_COUNTS=folder.parent / "counts",
                 **more)
        for line in (folder.parent / "counts").read_text().splitlines():
            call, count = line.split()
            counts[call] = max(counts[call], int(count))
        shutil.rmtree(folder.parent)
        return counts


def small_record(record):
    """With no more than one kernel and one benchmark, so with few charts."""
    record["kernels"] = dict(list(record.get("kernels", {}).items())[:1])
    record["benchmarks"] = record.get("benchmarks", [])[:1]
    return record


def temporaries(names):
    return {name for name in names if any(TEMPORARY.search(part) for part in name.split("/"))}


def without_seconds(text):
    def stripped(value):
        if isinstance(value, dict):
            return {key: stripped(item) for key, item in value.items() if key != "seconds"}
        return [stripped(item) for item in value] if isinstance(value, list) else value

    return json.dumps(stripped(json.loads(text)))


def contents(folder, command):
    """{path: bytes, or where a link leads}; a folder is known by its files. What is timed counts by its numbers but
    the seconds, and by whether the other files have their ends; the journal, which only grows, does not count."""
    found = raw_contents(folder)
    if not command.is_timed:
        return found
    found.pop("study/compare.points.jsonl", None)
    for name, content in found.items():
        if name.endswith(".json") and name.startswith("study"):
            found[name] = without_seconds(content)
        elif name.startswith("study"):
            found[name] = content.rstrip().endswith(ENDS.get(pathlib.Path(name).suffix, b""))
    return found


def raw_contents(folder):
    found = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.is_symlink():
            found[name] = os.readlink(path)
        elif path.is_file():
            found[name] = path.read_bytes()
        elif TEMPORARY.search(path.name):
            found[name] = b""
    return found


def part(files, unit):
    return {name: content for name, content in files.items() if name.split("/")[0] == unit}


def difference(one, other):
    names = [name for name in sorted({*one, *other}) if one.get(name) != other.get(name)]
    return ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", required=True, type=os.path.abspath)
    parser.add_argument("--library", required=True, type=os.path.abspath)
    parser.add_argument("--source", required=True, type=os.path.abspath)
    parser.add_argument("--sample", type=int, default=1)
    parser.add_argument("--only", default="", help="commands whose name matches this regular expression")
    parser.add_argument("--output", type=pathlib.Path)
    options = parser.parse_args()
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="wavecurve-faults-") as folder:
        sweep = Sweep(options, pathlib.Path(folder))
        chosen = [command for command in commands(options.source + "/docs/examples")
                  if re.search(options.only, command.name)]
        jobs = [job for command in chosen for job in sweep.jobs(command)]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for done in [pool.submit(job) for job in jobs[::options.sample]]:
                done.result()
    rows = {}
    for (command, failure, outcome), count in sorted(sweep.rows.items()):
        row = rows.setdefault((command, failure), {"command": command, "failure": failure, "runs": 0, "done": 0,
                                                   "refused": 0, "ended": 0, "broken": 0})
        row["runs"] += count
        row[outcome] += count
    figures = {"sample": options.sample, "seconds": round(time.monotonic() - start), "rows": list(rows.values())}
    if options.output:
        write_record(options.output, figures)
    for line in sweep.broken:
        print(line)
    total = sum(row["runs"] for row in figures["rows"])
    print(f"{total} runs in {figures['seconds']} s: {len(sweep.broken)} problems")
    return 1 if sweep.broken else 0


if __name__ == "__main__":
    sys.exit(main())
