#!/usr/bin/env python3
"""Prints the reference of the Python package as a Markdown page, from its signatures and docstrings.

usage: PYTHONPATH=FOLDER docs/python_reference.py
FOLDER holds the package wavecurve, as build/release/python does. Exit codes: 0 done, 3 the package is not there.
"""
import inspect
import re
import sys


def paragraphs(doc):
    """A numpydoc text as Markdown: its sections as bold words, its entries as lists."""
    lines, result = doc.split("\n"), []
    section = ""
    for number, line in enumerate(lines):
        rule = lines[number + 1] if number + 1 < len(lines) else ""
        if line and re.fullmatch("-+", rule) and len(rule) == len(line):
            section = line
            result += ["", f"**{section}**", ""]
        elif re.fullmatch("-+", line) and section:
            continue
        elif section in ("Parameters", "Returns", "Raises", "Attributes", "Yields") and line:
            result.append(f"    {line.strip()}" if line.startswith(" ") else f"- {entry(line)}  ")
        elif line.startswith(">>>") or section == "Examples":
            result.append(f"    {line}" if line else "")
        else:
            result.append(line)
    return "\n".join(result)


def entry(line):
    name, colon, kind = line.partition(" : ")
    return f"`{name}` : {kind}" if colon else f"`{line}`"


def signature(thing):
    try:
        found = inspect.signature(thing)
    except (TypeError, ValueError):
        return "()"
    found = found.replace(parameters=[p.replace(annotation=p.empty) for p in found.parameters.values() if p.name != "self"],
                          return_annotation=inspect.Signature.empty)
    return str(found)


def members(kind):
    """The public methods and properties of a class that say what they are."""
    for name, member in vars(kind).items():
        if not name.startswith("_") and inspect.getdoc(getattr(kind, name)):
            yield name, getattr(kind, name), isinstance(member, property) or not callable(getattr(kind, name))


def description(package, name):
    thing = getattr(package, name)
    if not callable(thing):
        return ""
    # A record's constructor is nothing that a user calls.
    shown = signature(thing) if not inspect.isclass(thing) or "Parameters" in (inspect.getdoc(thing) or "") else ""
    text = f"\n## {name}\n\n    wavecurve.{name}{shown}\n\n{paragraphs(inspect.getdoc(thing))}\n"
    if inspect.isclass(thing):
        for member, value, is_property in members(thing):
            head = member if is_property else member + signature(value)
            text += f"\n### {name}.{member}\n\n    {head}\n\n{paragraphs(inspect.getdoc(value))}\n"
    return text


def main():
    try:
        import wavecurve
    except ImportError as error:
        print(f"python_reference.py: {error}", file=sys.stderr)
        return 3
    print("# Python reference\n\n" + paragraphs(inspect.getdoc(wavecurve)))
    print("\nThe page [In Python](guide/python.md) is where to start.")
    for name in sorted(wavecurve.__all__, key=str.lower):
        print(description(wavecurve, name), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
