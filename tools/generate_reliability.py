#!/usr/bin/env python3
"""Writes docs/reliability.md from the records of the trials, docs/reliability/*.json.

usage: tools/generate_reliability.py RECORDS OUT.md

Each record is what a trial of this project has written, and holds the date and the revision that it was made at:
  calls.json         tools/faults/sweep.py, every failing system call of every command that writes
  allocations.json   tools/faults/try_allocations.py, every refused request for memory
  names.json         tools/hostile_texts_test.py --json, hostile names through every output
  fuzzing.json       the fuzzers' campaign
  mutations.json     tools/mutate.sh, small faults in the numeric rooms and the tests that notice them
  survivors.json     written by hand: why a mutant that no test notices is no fault, by "FILE: FROM -> TO"
Exit codes: 0 written, 2 bad usage or a record that is none.
"""
import json
import pathlib
import sys

HEAD = """# Reliability

What was tried to break the program, and what came of it. This page is written by `tools/generate_reliability.py` from the records of the
trials in `docs/reliability/`; each says when and at which revision it was made. What is promised is in `SECURITY.md`.
"""


def read(folder, name):
    path = folder / name
    return json.loads(path.read_text()) if path.is_file() else None


def made(record):
    return f"Made on {record['date']} at revision `{record['revision'][:10]}`."


def table(columns, rows):
    lines = ["| " + " | ".join(columns) + " |",
             "|" + "|".join(["---"] + ["---:"] * (len(columns) - 1)) + "|"]
    for row in rows:
        lines.append("| " + " | ".join(f"{cell:,}" if isinstance(cell, int) else str(cell) for cell in row) + " |")
    return "\n".join(lines) + "\n"


def calls(record):
    rows = {}
    for row in record["rows"]:
        sums = rows.setdefault(row["failure"], [0] * 5)
        for i, key in enumerate(("runs", "done", "refused", "ended", "broken")):
            sums[i] += row[key]
    commands = len({row["command"] for row in record["rows"]})
    total = [sum(column) for column in zip(*rows.values())]
    step = record.get("sample") or 1
    which = "every" if step == 1 else f"every {step}th"
    text = f"""
## System calls that fail

{commands} commands that write, each over the output of an older run, meet {which} failure of each kind of call, a full disk, signals, and a
second run beside them ([`tools/faults/sweep.py`](../tools/faults/sweep.py); a sample is a test). After each run the exit code is 0 and the new output complete, or it is 2 or
3 with one line; the older output or the new one is whole; no temporary file remains; nothing has crashed. *Ended* is by the signal that was
sent. {made(record)} It took {record['seconds']:.0f} seconds.

"""
    return text + table(["failure", "runs", "done", "refused", "ended", "broken"],
                        [[name] + sums for name, sums in sorted(rows.items())] + [["all"] + total])


def allocations(record):
    total = record["total"]
    rows = [[name] + [counts.get(key, 0) for key in total] for name, counts in record["commands"].items()]
    return f"""
## Memory that is refused

One request for memory after another is refused ([`tools/faults/try_allocations.py`](../tools/faults/try_allocations.py); a sample is a test). The run does what it does with
memory, or ends with one line and exit code 3, with no file written. GMP allows its functions for memory no return, so that the program ends
where it stands. {made(record)}

""" + table(["command"] + list(total), rows + [["all"] + list(total.values())])


def names(record):
    return f"""
## Hostile names

{record['names']} names (line breaks, escape sequences, markup, formulas, code, what is no UTF-8) stand as the name of a filter, the id of a layer, the title and
a column of a table, and as the name of a file, and leave by {record['outputs']} outputs, which parsers that the program does not use take apart
([`tools/hostile_texts_test.py`](../tools/hostile_texts_test.py), a test). {record['violations']} violations in {record['runs']:,} runs. {made(record)}
"""


def fuzzing(record):
    rows = [[row["fuzzer"], row["executions"], row["features"], row["found"]] for row in record["fuzzers"]]
    total = ["all", sum(row[1] for row in rows), "", sum(row[3] for row in rows)]
    return f"""
## Fuzzers

One for each reader and for the options of the commands (`*/fuzz/`), instrumented for addresses and undefined behaviour; each runs for some seconds
as a test. Executions and defects found (all mended) are those of all campaigns, {record['seconds']:,} seconds a reader; the coverage is that of the
last one. {made(record)}

""" + table(["reader", "executions", "features covered", "found"], rows + [total])


def mutations(record, arguments):
    kinds = ("mutants", "beside", "room", "others", "none")
    rows = [[row["room"]] + [row[kind] for kind in kinds] for row in record["rows"]]
    total = [sum(column) for column in zip(*(row[1:] for row in rows))]
    share = 100 * (1 - total[-1] / total[0])
    text = f"""
## Faults in the numerics

Small faults are planted in the numeric rooms, one at a time: another operator, another constant, another bound
([`tools/mutate.sh`](../tools/mutate.sh)). {record['drawn']} were drawn, {total[0]} compile, and {share:.1f} % of these are noticed: by the tests *beside* the file, else by
those of its *room*, else by those of *other* rooms. Who survives is listed below, with the reason if it is no fault. {made(record)}

""" + table(["room", "mutants", "beside", "room's", "others", "survive"], rows + [["all"] + total])
    if record["survivors"]:
        lines = []
        for mutant in record["survivors"]:
            key = f"{mutant['file']}: {mutant['from']} -> {mutant['to']}"
            place = mutant["file"].removeprefix("lib/wavecurve/")
            lines.append([f"{place}:{mutant['line']}", code(mutant["from"]), code(mutant["to"]), arguments.get(key, "")])
        text += "\n" + table(["place", "is", "was changed to", "why no test can notice"], lines)
    return text


def code(text):
    return "`" + text.replace("|", "\\|") + "`"


def others():
    return """
## Beside others

SQLite runs the same kinds of trial (out of memory, failing input and output, crashes, fuzzers; "How SQLite Is Tested") and in addition measures the
coverage of every branch, which is not done here. FLINT tests its functions against plain ones on random input, as this library does, and ends the
program where memory is refused, which this library cannot prevent, and this program turns into one line and an exit code.
"""


def main():
    if len(sys.argv) != 3:
        print(__doc__.splitlines()[2], file=sys.stderr)
        return 2
    folder = pathlib.Path(sys.argv[1])
    text = HEAD
    for name, write in (("calls.json", calls), ("allocations.json", allocations), ("names.json", names),
                        ("fuzzing.json", fuzzing),
                        ("mutations.json", lambda record: mutations(record, read(folder, "survivors.json") or {}))):
        try:
            record = read(folder, name)
            text += write(record) if record else ""
        except (KeyError, ValueError) as error:
            print(f"{folder / name} is no record: {error}", file=sys.stderr)
            return 2
    pathlib.Path(sys.argv[2]).write_text(text + others())
    return 0


if __name__ == "__main__":
    sys.exit(main())
