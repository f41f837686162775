"""Mutants of the library's numeric rooms: small faults, planted so that a program runs with one of them at a time.

An expression such as a < b becomes (mutation::is(17) ? a <= b : a < b), and one build holds all mutants. They are
drawn at random, at most one a line, from the operators and constants in bodies of functions; texts of errors are left
alone. Needs Debian's python3-clang.
"""
import multiprocessing
import pathlib
import random

from clang import cindex
from clang.cindex import CursorKind

MUTANT_HEADER = pathlib.Path(__file__).resolve().parent / "mutant.hpp"

ROOMS = ("elementary", "filters", "transform", "certified", "operators", "curves", "dynamics", "motion")
FLAGS = ["-x", "c++", "-std=c++20", "-isystem/usr/include/eigen3"]

OPERATORS = {"+": "-", "-": "+", "*": "+", "/": "*", "%": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">",
             "==": "!=", "!=": "==", "&&": "||", "||": "&&", "+=": "-=", "-=": "+=", "*=": "+=", "/=": "*="}
BODIES = {CursorKind.COMPOUND_STMT, CursorKind.LAMBDA_EXPR}
LEFT_ALONE = {CursorKind.CXX_THROW_EXPR, CursorKind.STATIC_ASSERT, CursorKind.STRING_LITERAL}


class File:
    """A source, whose bytes are what libclang's offsets count."""

    def __init__(self, path):
        self.path = path
        self.bytes = path.read_bytes()

    def text(self, start, end):
        return self.bytes[start:end].decode()


def operands(cursor):
    if cursor.kind in (CursorKind.BINARY_OPERATOR, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR):
        children = list(cursor.get_children())
        return children if len(children) == 2 else None
    if cursor.kind == CursorKind.CALL_EXPR and cursor.spelling.startswith("operator"):
        arguments = [argument for argument in cursor.get_arguments() if argument is not None]
        return arguments if len(arguments) == 2 else None
    return None


def mutation_of_operator(source, cursor):
    pair = operands(cursor)
    if pair is None:
        return None
    start, end = cursor.extent.start.offset, cursor.extent.end.offset
    left, right = pair[0].extent, pair[1].extent
    operator = source.text(left.end.offset, right.start.offset).strip()
    if operator not in OPERATORS or left.start.offset != start or right.end.offset != end:
        return None
    a, b = source.text(start, left.end.offset), source.text(right.start.offset, end)
    return {"from": f"{a} {operator} {b}", "to": f"{a} {OPERATORS[operator]} {b}"}


def mutation_of_constant(source, cursor):
    if cursor.kind not in (CursorKind.INTEGER_LITERAL, CursorKind.FLOATING_LITERAL):
        return None
    literal = source.text(cursor.extent.start.offset, cursor.extent.end.offset)
    return {"from": literal, "to": f"({literal} + 1)"} if literal[:1].isdigit() else None


def mutation_of_negation(source, cursor):
    if cursor.kind != CursorKind.UNARY_OPERATOR:
        return None
    text = source.text(cursor.extent.start.offset, cursor.extent.end.offset)
    return {"from": text, "to": f"!{text}"} if text.startswith("!") else None


def candidates(source, cursor, in_body, found):
    for child in cursor.get_children():
        if child.location.file is not None and child.location.file.name != str(source.path):
            continue
        if child.kind in LEFT_ALONE:
            continue
        inside = in_body or child.kind in BODIES
        start, end = child.extent.start, child.extent.end
        if inside and start.line == end.line:
            for mutate in (mutation_of_operator, mutation_of_constant, mutation_of_negation):
                change = mutate(source, child)
                if change:
                    found[(start.offset, end.offset)] = {"line": start.line, "column": start.column, **change}
        candidates(source, child, inside, found)


def candidates_of(source, tree):
    unit = cindex.Index.create().parse(str(source.path), args=FLAGS + [f"-I{tree}/lib"])
    found = {}
    candidates(source, unit.cursor, False, found)
    return [{"start": start, "end": end, **change} for (start, end), change in sorted(found.items())]


def files(tree):
    for room in ROOMS:
        for path in sorted((tree / "lib/wavecurve" / room).rglob("*.[ch]pp")):
            if not path.name.endswith(("_test.cpp", "_test.hpp")):
                yield room, path


def candidates_by_line(path, tree):
    of_a_line = {}
    for candidate in candidates_of(File(path), tree):
        of_a_line.setdefault(candidate["line"], []).append(candidate)
    return of_a_line


def draw_mutants(tree, count, seed):
    """At most count mutants, each on a line of its own."""
    sources = list(files(tree))
    with multiprocessing.Pool() as pool:
        lines = pool.starmap(candidates_by_line, [(path, tree) for _, path in sources], chunksize=1)
    draw = random.Random(seed)
    everywhere = [(i, line) for i, of_a_line in enumerate(lines) for line in of_a_line]
    mutants = []
    for number, (i, line) in enumerate(sorted(draw.sample(everywhere, min(count, len(everywhere)))), 1):
        room, path = sources[i]
        mutants.append({"number": number, "room": room, "file": str(path.relative_to(tree)), **draw.choice(lines[i][line])})
    return mutants


def planted(text, mutants):
    """A source with its mutants; its lines keep their numbers."""
    for mutant in sorted(mutants, key=lambda m: -m["start"]):
        new = f"(mutation::is({mutant['number']}) ? {mutant['to']} : {mutant['from']})"
        text = text[:mutant["start"]] + new.encode() + text[mutant["end"]:]
    return f'#include "{MUTANT_HEADER}"\n#line 1\n'.encode() + text
