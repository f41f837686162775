#!/usr/bin/env python3
"""Proves the arrows of docs/architecture.md: who may include whom, and that nothing goes round in a circle.

usage: tools/check_architecture.py [FOLDER]
Reads the #include lines of the source files below FOLDER (this project). Exit codes: 0 all is well,
1 something is not, each in one line, 2 bad usage.
"""
import pathlib
import re
import sys

# A room, and the rooms that it may include besides itself. Tests of lib may include any room of lib, since
# a fast function is often tried on real files.
ALLOWED = {
    "filters": [],
    "elementary": ["filters"],
    "integrals": ["filters"],
    "certified": ["filters", "elementary", "integrals"],
    "transform": ["filters", "elementary"],
    "operators": ["filters", "elementary", "integrals", "transform"],
    "dynamics": ["filters", "elementary", "transform", "operators"],
    "curves": ["filters", "elementary", "transform"],
    "motion": ["filters", "elementary", "transform", "dynamics", "curves"],
    "io": ["filters", "elementary", "integrals", "certified", "transform", "curves", "motion"],
    "verification": ["lib"],
    # The Python package, which nothing includes.
    "lib/python": ["lib", "verification"],
    "reports": ["lib", "verification"],
    # What measures performance knows no numerics: it measures any revision.
    "benchmarks/tracking": ["io/files"],
    "benchmarks/pages": ["io/files", "benchmarks/tracking", "reports", "verification"],
    "benchmarks": ["lib", "verification", "benchmarks/tracking"],
    "tools": ["lib", "verification", "reports", "benchmarks/tracking", "benchmarks/pages"],
}
LIB_ROOMS = ["filters", "elementary", "integrals", "certified", "transform", "operators", "dynamics", "curves", "motion", "io"]
MOST_CONCEPTS = 25


def fail(problems, text):
    if text not in problems:
        problems.append(text)


def room_of(path):
    """The room of a file, by its path from the root of the project."""
    parts = path.split("/")
    if parts[:2] == ["lib", "python"]:
        return "lib/python"
    if parts[0] == "lib":
        return parts[2] if len(parts) > 3 and parts[1] == "wavecurve" else "lib"
    inner = "/".join(parts[:2])
    return inner if inner in ALLOWED else parts[0]


def may_include(source, target):
    room, other = room_of(source), room_of(target)
    if room == other or room == "lib":
        return True
    is_test = re.search(r"_test\.[ch]pp$", source)
    if room in LIB_ROOMS and other in LIB_ROOMS and is_test:
        return True
    for allowed in ALLOWED[room]:
        if allowed == other or (allowed == "lib" and other in LIB_ROOMS + ["lib"]):
            return True
        if allowed == "io/files" and target.startswith("lib/wavecurve/io/files/"):
            return True
    return False


def read_includes(root):
    """{file: [included file]}, by paths from the root; with what an include does not name by such a path."""
    files = [p for folder in ("lib", "verification", "reports", "benchmarks", "tools")
             for p in sorted((root / folder).rglob("*"))
             if p.suffix in (".hpp", ".cpp") and "node_modules" not in p.parts]
    includes, problems = {}, []
    for path in files:
        name = path.relative_to(root).as_posix()
        includes[name] = []
        for include in re.findall(r'^\s*#\s*include\s+"([^"]+)"', path.read_text(), re.MULTILINE):
            # The examples are a project of their own, which knows no root but its folder.
            places = ["lib/examples/" + include] if name.startswith("lib/examples/") else ["lib/" + include, include]
            found = [c for c in places if (root / c).is_file() and "/" in c]
            if found:
                includes[name].append(found[0])
            else:
                fail(problems, f'{name} includes "{include}", which is no path from the root or from lib')
    return includes, problems


def unchecked_json(root):
    """Constant JSON documents that are read by the operator [], which is undefined for a key that is not there."""
    problems = []
    declared = re.compile(r"const\s+(?:nlohmann::)?(?:ordered_json|json|Json)\s*&?\s+(\w+)\s*[,);=:{(]")
    for folder in ("lib", "verification", "reports", "benchmarks", "tools"):
        for path in sorted((root / folder).rglob("*.cpp")):
            if path.name.endswith("_test.cpp") or "node_modules" in path.parts:
                continue
            text = path.read_text()
            for match in declared.finditer(text):
                name = match.group(1)
                scope = text[match.end():].split("\n}\n")[0]  # to the end of the function
                if re.search(rf"(?<![\w.]){name}\[", scope):
                    fail(problems, f"{path.relative_to(root).as_posix()} reads the constant JSON document {name} "
                                   "by [], not through JsonPlace or at()")
    return problems


def circle_in(graph):
    """A list of nodes that leads back to its first, or None."""
    state = {}

    def visit(node, trail):
        state[node] = "open"
        for following in sorted(graph.get(node, ())):
            if state.get(following) == "open":
                return trail[trail.index(following):] + [following]
            if following not in state:
                circle = visit(following, trail + [following])
                if circle:
                    return circle
        state[node] = "done"
        return None

    for start in sorted(graph):
        if start not in state:
            circle = visit(start, [start])
            if circle:
                return circle
    return None


def folder_graphs(includes):
    """For each folder with subfolders the arrows among these; tests and what stands in the folder itself aside."""
    graphs = {}
    for source, targets in includes.items():
        if re.search(r"_test\.[ch]pp$", source):
            continue
        for target in targets:
            # The Python package stands in lib, but above the suite.
            a, b = (path.replace("lib/python/", "python/").split("/")[:-1] for path in (source, target))
            common = 0
            while common < min(len(a), len(b)) and a[common] == b[common]:
                common += 1
            if common < len(a) and common < len(b):
                graph = graphs.setdefault("/".join(a[:common]), {})
                graph.setdefault(a[common], set()).add(b[common])
    return graphs


def problems_of(root):
    includes, problems = read_includes(root)
    for source, targets in includes.items():
        for target in targets:
            if not may_include(source, target):
                fail(problems, f"{source} includes {target}: "
                               f"{room_of(source)} may not know {room_of(target)}")
            is_face = source.startswith("lib/wavecurve/") and source.endswith(".hpp")
            if is_face and "/detail/" in target and "/detail/" not in source and "_test." not in source:
                fail(problems, f"{source} includes {target}: a public header, and detail is not installed")
    problems += unchecked_json(root)
    circle = circle_in({s: set(t) for s, t in includes.items()})
    if circle:
        fail(problems, "files that include each other in a circle: " + " -> ".join(circle))
    for folder, graph in folder_graphs(includes).items():
        circle = circle_in(graph)
        if circle:
            fail(problems, f"a circle in {folder or 'the root'}: " + " -> ".join(circle))
    concepts = {}
    for name in includes:
        folder, _, file = name.rpartition("/")
        if not re.search(r"_test\.", file):
            concepts.setdefault(folder, set()).add(re.sub(r"(-inl)?\.[ch]pp$", "", file))
    for folder, stems in sorted(concepts.items()):
        if len(stems) > MOST_CONCEPTS:
            fail(problems, f"{folder} holds {len(stems)} concepts, more than {MOST_CONCEPTS}")
    return problems


def main(arguments):
    if len(arguments) > 1 or any(a.startswith("-") for a in arguments):
        print(__doc__, file=sys.stderr)
        return 2
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).resolve().parent.parent
    if not (root / "lib").is_dir():
        print(f"check_architecture: {root} has no folder lib", file=sys.stderr)
        return 2
    problems = problems_of(root)
    for problem in problems:
        print(problem)
    if not problems:
        print("every include goes where it may, and none in a circle")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
