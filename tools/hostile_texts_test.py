#!/usr/bin/env python3
"""Sends hostile names through every output of the program, and parses what leaves.

usage: hostile_texts_test.py PROGRAM [FILE.json]

A name comes from outside as the name of a filter, the id of a layer, the title or a column of a table, or the name
of a file. Whatever it holds, each output must be what its form says: the parsers here are Python's own for JSON,
CSV, XML and HTML and the C++ compiler, none of which the program uses. A terminal must be sent nothing that it obeys,
and a name must not begin a line. The script prints each violation and exits with 1 if there is one; its
figures go to FILE.json, for docs/reliability.md.
"""

import csv
import html.parser
import io
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unicodedata
import xml.etree.ElementTree
import xml.sax.saxutils

from trial_record import write_record

BENIGN = "plain"
HOSTILE = [
    "a\nint injected = 1;", "a\r\nb", "\x1b[31mred\x1b[2J", "\x07\x08\x7f", "\x9b31m", "\u202eabc\u2028",
    "<b>&amp;'\"", "</script><script>alert(1)</script>", "{{data}}{{title}}", "=1+1", "+cmd|x", "-1-1", "@sum",
    "a,b;c\td", "\"quoted\"", "*/ int injected; /*", "\\", "??/", "`touch obeyed`", "$(touch obeyed)", "%s%n%1$s",
    "{}{0}", "\ufffe\uffff", "\U0001f600 e\u0301 \u05d0", "\\input{x}_^~$%#&", "| a | b |", "[a](b) *c*", " a ",
    "-->", "]]>", "x" * 20000, "",
]
TAPS = ["0.4829629131445341", "0.8365163037378079", "0.2241438680420134", "-0.1294095225512604"]
PATH = "M{0} 0L{1} 0 {1} {1} {0} {2}z"

program = None
failures = []
runs = 0


def fail(what, why):
    failures.append(f"{what}: {why}")


class Pages(html.parser.HTMLParser):
    """Counts the elements that act, and collects the text of a page's data."""

    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.scripts, self.handlers = [], 0
        self.in_script = False

    def handle_starttag(self, tag, attributes):
        self.in_script = tag == "script"
        if self.in_script:
            self.scripts.append("")
        self.handlers += sum(name.startswith("on") for name, _ in attributes)

    def handle_endtag(self, tag):
        self.in_script = False

    def handle_data(self, data):
        if self.in_script:
            self.scripts[-1] += data


def is_shown(text):
    """Whether a terminal shows all of it: no control character, none that turns text around."""
    return all(c == "\n" or unicodedata.category(c) not in ("Cc", "Zl", "Zp") and
               unicodedata.bidirectional(c) not in ("LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI")
               for c in text)


def text_form(data):
    text = data.decode()
    if not is_shown(text):
        raise ValueError("a terminal obeys " + ascii(text)[:200])
    return len(text.splitlines())


def json_form(data):
    text = data.decode()
    if not is_shown(text):
        raise ValueError("a terminal obeys " + ascii(text)[:200])
    json.loads(text)


def csv_form(data):
    rows = list(csv.reader(io.StringIO(data.decode(), newline=""), strict=True))
    if len({len(row) for row in rows}) > 1:
        raise ValueError("rows of different length")
    for row in rows:
        for field in row:
            is_number = field.lstrip("+-").replace(".", "", 1).replace("e-", "", 1).replace("e+", "", 1).isdigit()
            if field[:1] in ("=", "+", "-", "@") and not is_number:
                raise ValueError("a spreadsheet takes for a formula " + ascii(field)[:100])
    return len(rows)


def xml_form(data):
    xml.etree.ElementTree.fromstring(data)


def html_form(data):
    page = Pages()
    page.feed(data.decode())
    for script in page.scripts:
        if script.lstrip().startswith("{"):
            json.loads(script)
    return len(page.scripts), page.handlers


def cpp_form(data):
    """Whether it compiles, and declares no more than it should."""
    data.decode("ascii")
    if b"int injected" in data.replace(b"// ", b"//").split(b"\n//")[0].split(b"#pragma once")[-1]:
        raise ValueError("code from a name")
    compiled = subprocess.run(["c++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c++", "-"],
                              input=data.replace(b"#pragma once", b""), capture_output=True, check=False)
    if compiled.returncode != 0:
        raise ValueError(compiled.stderr.decode()[:300])
    return data.count(b"\n")


def markup_form(data):
    text_form(data)


FORMS = {"text": text_form, "json": json_form, "csv": csv_form, "cpp": cpp_form, "markdown": markup_form,
         "latex": markup_form}
FILES = {".svg": xml_form, ".json": json_form, ".html": html_form, ".csv": csv_form}


def run(folder, arguments, form, accepted=(0, 1, 2)):
    """The count that the form finds in the standard output; None if the input was refused."""
    global runs
    runs += 1
    done = subprocess.run([program] + arguments, cwd=folder, capture_output=True, check=False)
    what = "wavecurve " + " ".join(ascii(a)[:60] for a in arguments)
    try:
        if done.returncode not in accepted:
            raise ValueError(f"exit code {done.returncode}: {ascii(done.stderr)[:300]}")
        text_form(done.stderr)
        if done.returncode == 2:
            if done.stderr.count(b"\n") != 1 or done.stdout:
                raise ValueError("a refusal that is not one line: " + ascii(done.stderr)[:200])
            if len(done.stderr) > 3000:
                raise ValueError(f"a message of {len(done.stderr)} bytes")
            return None
        return form(done.stdout)
    except (ValueError, xml.etree.ElementTree.ParseError, csv.Error) as error:
        fail(what, error)
        return None


def check_file(path, form):
    try:
        return form(path.read_bytes())
    except (OSError, ValueError, xml.etree.ElementTree.ParseError, csv.Error) as error:
        fail(ascii(str(path.name))[:80], error)
        return None


def xml_name(text):
    """As an attribute's value, with character references for what is allowed only so; without what never is."""
    kept = "".join(c for c in text if c in "\t\n\r" or (ord(c) >= 32 and c not in "\ufffe\uffff"))
    return xml.sax.saxutils.quoteattr(kept, {"\n": "&#10;", "\r": "&#13;", "\t": "&#9;"})


def drawing(name, size):
    path = PATH.format(0, size, 2 * size)
    return f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 40"><path id={xml_name(name)} d="{path}"/></svg>"""


def counts_of(folder, name):
    """What the forms count in all outputs for a name: the same for a hostile name as for a benign one."""
    counts = {}
    (folder / "f.json").write_text(json.dumps({"name": name, "taps": TAPS}))
    for format_name, form in FORMS.items():
        counts["filter", format_name] = run(folder, ["filter", "f.json", "--format", format_name], form)
        counts["quantity", format_name] = run(
            folder, ["coefficients", "f.json", "--quantity", "h", "--format", format_name], form)
    (folder / "a.svg").write_text(drawing(name, 10))
    (folder / "b.svg").write_text(drawing(name, 15))
    morph = ["morph", "a.svg", "b.svg", "--samples", "16", "--frames", "3"]
    for ending, form in FILES.items():
        if ending == ".csv":
            continue
        run(folder, morph + ["-o", "o" + ending], text_form, (0,))
        counts["morph", ending] = check_file(folder / ("o" + ending), form)
    counts["crossings"] = run(folder, morph + ["-o", "o.svg", "--sheet", "--crossings", "report"], text_form, (0,))
    check_file(folder / "o.svg", xml_form)
    counts["describe"] = run(folder, ["describe", "a.svg", "--samples", "16"], text_form, (0,))
    run(folder, ["describe", "a.svg", "--samples", "16", "-o", "d.json"], text_form, (0,))
    check_file(folder / "d.json", json_form)
    for ending in (".svg", ".csv"):
        run(folder, ["reconstruct", "d.json", "-o", "r" + ending], text_form, (0,))
        counts["reconstruct", ending] = check_file(folder / ("r" + ending), FILES[ending])
    line = name.replace("\n", " ").replace("\r", " ")
    table = io.StringIO()
    writer = csv.writer(table, lineterminator="\n")
    writer.writerow(["filter", "quantity", "index", "printed", "note " + line])
    writer.writerow(["db2", "h", "0", "0.48296", line])
    (folder / "t.csv").write_text(f"# title: a {line}\n" + table.getvalue())
    for format_name, form in FORMS.items():
        if format_name != "cpp":
            counts["check", format_name] = run(folder, ["check", "t.csv", "--format", format_name], form)
    run(folder, ["check", "t.csv", "-o", "p.html"], text_form)
    counts["check", "page"] = check_file(folder / "p.html", html_form) if (folder / "p.html").exists() else None
    return counts


def check_file_names(folder):
    """Names of files, which may be no UTF-8 either."""
    names = [name.replace("/", "_")[:100] for name in HOSTILE if name] + ["\udcff\udcfe", "a\udc9b"]
    for name in names:
        path = folder / (name + ".svg")
        path.write_text(drawing("x", 10))
        arguments = ["morph", "--samples", "16", "--frames", "3", "-o", name + ".html", "--", name + ".svg", name + ".svg"]
        run(folder, arguments, text_form)
        if (folder / (name + ".html")).exists():
            check_file(folder / (name + ".html"), html_form)
        for arguments in (["check", "--", name], ["filter", "--", name + ".json"], ["gait", "show", "--", name],
                          ["verify", "--reference=" + name], ["compare", "--shape=" + name], ["bench", "compare", "--", name],
                          ["identify", "--", name], ["reconstruct", "-o", "o.svg", "--", name], [name], ["morph", "--" + name]):
            run(folder, arguments, text_form, (2, 3))
    name = "a`b\x1b[31m\nc\".csv"
    (folder / name).write_text("0,0\n4,0\n4,3\n1,5\n")
    for format_name in ("json", "csv", "text"):
        run(folder, ["compare", "--shape", name, "--samples", "16", "--levels", "4", "--damping", "0,1", "--solvers",
                     "decoupled,spectral", "--format", format_name, "-o", "study"], FORMS[format_name], (0,))
    check_file(folder / "study" / "index.html", html_form)
    for picture in (folder / "study" / "figures").glob("*.svg"):
        check_file(picture, xml_form)


def main():
    global program
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__.splitlines()[2])
    program = os.path.abspath(sys.argv[1])
    folder = pathlib.Path(tempfile.mkdtemp(prefix="wavecurve_hostile_"))
    try:
        expected = counts_of(folder, BENIGN)
        for name in HOSTILE:
            for output, count in counts_of(folder, name).items():
                if count is not None and count != expected[output]:
                    fail(f"{output} with {ascii(name)[:60]}", f"{count}, but {expected[output]} with a plain name")
        check_file_names(folder)
        if list(folder.rglob("obeyed")):
            fail("a shell", "ran what a name says")
    finally:
        shutil.rmtree(folder)
    for failure in failures:
        print(failure)
    print(f"{len(HOSTILE)} names, {runs} runs, {len(failures)} violations")
    if len(sys.argv) == 3:
        write_record(sys.argv[2], {"names": len(HOSTILE), "outputs": len(expected), "runs": runs,
                                   "violations": len(failures)})
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
