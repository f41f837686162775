#!/usr/bin/env python3
"""Holds both ends of morphs between drawings of a set against librsvg's pictures of the two files.

Usage: ends_of_morphs.py PROGRAM NAME=FOLDER... [--pairs 60] [--seed 1] [--jobs 2] [--describe] [--keep FOLDER]

A seeded sample of pairs of files is morphed from every folder of SVG files, with what lies below it; both
files of a pair lie in the same folder. The first and the last frame are compared with what rsvg-convert
makes of the files, as intersection over union. Exit codes: 0 where that is at least 0.99 for every pair
that the program did not warn of (and, with --describe, every file is described), 1 where not, 2 bad usage,
3 rsvg-convert or ffmpeg is missing.
"""
import argparse
import concurrent.futures
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

LEAST = 0.99
SIDE = 128  # of the compared pictures, in pixels, each the mean of several of the rendered ones
# Colours differ by one in 255 where two renderers round them, and by one more where the mean is rounded.
ROUNDING = 2


def sample_of_pairs(folder, count, seed):
    """Pairs of files of one folder each, as many folders as there are taking part by their sizes."""
    files = sorted(folder.rglob("*.svg"))
    of_folder = {}
    for file in files:
        of_folder.setdefault(file.parent, []).append(file)
    chooser = random.Random(seed)
    candidates = [file for file in files if len(of_folder[file.parent]) > 1]
    if not candidates:
        raise SystemExit(f"ends_of_morphs: {folder} has no folder with two SVG files")
    pairs = []
    for _ in range(count):
        first = chooser.choice(candidates)
        others = [file for file in of_folder[first.parent] if file != first]
        pairs.append((first, chooser.choice(others)))
    return pairs


def size_of(png):
    data = png.read_bytes()[16:24]
    return int.from_bytes(data[:4], "big"), int.from_bytes(data[4:], "big")


def pixels_of(png, width, height):
    """Colours times opacity, of the picture centred in that size and reduced; one byte a channel."""
    steps = ("format=gbrap", "premultiply=inplace=1",
             f"pad={width}:{height}:(ow-iw)/2:(oh-ih)/2:color=black@0", f"scale={SIDE}:{SIDE}:flags=area", "format=rgba")
    return subprocess.run(["ffmpeg", "-v", "error", "-i", png, "-vf", ",".join(steps), "-f", "rawvideo", "-"],
                          check=True, stdout=subprocess.PIPE).stdout


def overlap(a, b):
    """Intersection over union of what two pictures paint: 1 minus the sum of the differences over that of
    the larger opacities. For pictures in one colour that is the sum of the smaller over the larger ones."""
    different = union = 0
    for i in range(0, len(a), 4):
        if a[i + 3] == 0 and b[i + 3] == 0:
            continue
        difference = max(abs(a[i] - b[i]), abs(a[i + 1] - b[i + 1]), abs(a[i + 2] - b[i + 2]), abs(a[i + 3] - b[i + 3]))
        different += difference if difference > ROUNDING else 0
        union += max(a[i + 3], b[i + 3])
    return 1 - different / union if union else 1


def end_of(frame, svg, scratch):
    width, height = size_of(frame)
    picture = scratch / "file.png"
    subprocess.run(["rsvg-convert", "--keep-aspect-ratio", "-w", str(width), "-h", str(height), svg, "-o", picture],
                   check=True, stderr=subprocess.DEVNULL)
    return overlap(pixels_of(frame, width, height), pixels_of(picture, width, height))


def compared(program, pair, keep):
    """What came of a pair: the overlaps at both ends, the warnings, or the error."""
    with tempfile.TemporaryDirectory() as name:
        scratch = pathlib.Path(name)
        start = time.monotonic()
        run = subprocess.run([program, "morph", *pair, "--frames", "2", "-o", scratch / "frames.png"],
                             capture_output=True, text=True)
        took = time.monotonic() - start
        if run.returncode != 0:
            return {"pair": pair, "error": run.stderr.strip(), "took": took}
        frames = sorted((scratch / "frames.png").iterdir())
        ends = [end_of(frame, svg, scratch) for frame, svg in zip((frames[0], frames[-1]), pair)]
        if keep and min(ends) < LEAST:
            target = keep / f"{pair[0].parent.name}-{pair[0].stem}-{pair[1].stem}"
            shutil.copytree(scratch / "frames.png", target, dirs_exist_ok=True)
        return {"pair": pair, "ends": ends, "warning": run.stderr.strip(), "took": took}


def undescribed(program, folder):
    """The files that cannot be described, with what the program says."""
    failures = []
    for file in sorted(folder.rglob("*.svg")):
        run = subprocess.run([program, "describe", file, "-o", "/dev/null"], capture_output=True, text=True)
        if run.returncode != 0:
            failures.append(f"{file}: {run.stderr.strip()}")
    return failures


def names_of(pair):
    return f"{pair[0].parent.name}/{pair[0].stem} to {pair[1].stem}"


def report(name, results):
    """Prints what came of a set; returns the number of pairs that are wrong without a warning."""
    failed = [result for result in results if "error" in result]
    done = [result for result in results if "ends" in result]
    wrong = [result for result in done if min(result["ends"]) < LEAST]
    silent = [result for result in wrong if not result["warning"]]
    slowest = max(result["took"] for result in results)
    print(f"{name}: {len(results)} pairs, {len(wrong)} below {LEAST} at an end, {len(silent)} of them without a "
          f"warning, {len(failed)} refused; {sum(1 for r in done if r['warning'])} warned of; slowest {slowest:.1f} s")
    for result in failed:
        print(f"  {names_of(result['pair'])}: {result['error']}")
    for result in sorted(wrong, key=lambda result: min(result["ends"])):
        start, end = result["ends"]
        print(f"  {names_of(result['pair'])}: {start:.4f} and {end:.4f} {result['warning']}")
    return len(silent) + len(failed)


def main():
    parser = argparse.ArgumentParser(description="Holds both ends of morphs against pictures of the two files.")
    parser.add_argument("program")
    parser.add_argument("sets", nargs="+", metavar="NAME=FOLDER")
    parser.add_argument("--pairs", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--describe", action="store_true", help="describe every file, too")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the frames of pairs that are wrong")
    options = parser.parse_args()
    for program in ("rsvg-convert", "ffmpeg"):
        if not shutil.which(program):
            print(f"ends_of_morphs: {program} is missing", file=sys.stderr)
            return 3
    wrong = 0
    for named in options.sets:
        name, _, folder = named.partition("=")
        if not folder or not pathlib.Path(folder).is_dir():
            print(f"ends_of_morphs: {named} is not NAME=FOLDER with a folder", file=sys.stderr)
            return 2
        pairs = sample_of_pairs(pathlib.Path(folder), options.pairs, options.seed)
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            wrong += report(name, list(pool.map(lambda pair: compared(options.program, pair, options.keep), pairs)))
        if options.describe:
            failures = undescribed(options.program, pathlib.Path(folder))
            print("\n".join([f"{name}: {len(failures)} files cannot be described", *failures]))
            wrong += len(failures)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
