#!/usr/bin/env python3
"""Prepares a Markdown page for Doxygen, which calls this (docs/Doxyfile): prints FILE as the site needs it.

usage: docs/site_filter.py FILE

- Links to files that are no page of the site become their names.
- Pages and pictures stand in one folder there, and a link goes to a page as a whole.
- Code with an apostrophe, `phi'`, is put between two backticks, for Doxygen takes `...' for a quotation.
"""
import pathlib
import re
import sys

page = pathlib.Path(sys.argv[1]).read_text()
blocks = re.split(r"(^```.*?^```$)", page, flags=re.S | re.M)
for i, text in enumerate(blocks):
    if text.startswith("```"):
        continue
    text = re.sub(r"\[([^\]]*)\]\((?:\.\./)*(?:lib|verification|tools|CITATION)[^)]*\)", r"\1", text)
    text = re.sub(r"\((?:\.\./)*(?:docs/)?images/", "(", text)
    text = re.sub(r"(\.md)#[-a-z]+\)", r"\1)", text)
    blocks[i] = re.sub(r"(?<!`)`([^`\n]+)`(?!`)", lambda m: f"``{m[1]}``" if "'" in m[1] else m[0], text)
sys.stdout.write("".join(blocks))
