"""check and identify, held against the program's JSON."""
import math
import pickle
from decimal import Decimal

import numpy
import pandas
import pytest
import wavecurve

PUBLISHED = wavecurve.data_folder / "published"
FIELDS = ["filter", "quantity", "index", "printed", "verdict", "certified", "detail"]


@pytest.mark.parametrize("file", ["table_1.csv", "table_2.csv"])
def test_files_are_judged_as_the_program_does(program, file):
    shown, found = program("check", PUBLISHED / file, "--format", "json"), wavecurve.check(PUBLISHED / file)
    assert found.title == shown["table"] and found.counts == shown["counts"]
    assert [[getattr(row, name) for name in FIELDS] for row in found.rows] == [[row[name] for name in FIELDS]
                                                                               for row in shown["rows"]]
    assert [row.route or None for row in found.rows] == [row["route"] for row in shown["rows"]]
    for ours, theirs in zip(found.rows, shown["rows"]):
        assert math.isnan(ours.ulps) if theirs["ulps"] is None else ours.ulps == pytest.approx(theirs["ulps"], rel=1e-5)
    assert [(c.filter, c.matched, c.of, c.route) for c in found.columns] == [
        (c["filter"], c["matched"], c["of"], c["route"]) for c in shown["columns"]]
    assert found.is_right == (file == "table_1.csv")


def test_a_list_an_array_and_a_frame_are_a_table():
    right = wavecurve.FilterBank("db3").synthesis_low.taps
    wrong = [*right[:-1], right[-1] + 1e-6]
    for numbers in (right, list(right), pandas.DataFrame({"index": range(6), "printed": right}),
                    pandas.DataFrame({"printed": right})):
        found = wavecurve.check(numbers, "db3", "h")
        assert found.is_right and found.counts == {"certified": 6}, str(found)
    assert not wavecurve.check(wrong, "db3", "h").is_right
    assert wavecurve.check(right[::-1], "db3", "h", convention="reversed").is_right
    assert wavecurve.check(["0.3326706", Decimal("0.80689151")], wavecurve.FilterBank("db3"), "h").is_right


def test_a_frame_may_say_all():
    table = pandas.DataFrame({"Filter": ["db4", "db4"], "quantity": ["mu", "mu"], "index": [0, 1],
                              "value": ["4.16597364069", "-2.642070208103"], "page": [7, 8]})
    found = wavecurve.check(table)
    assert [row.extra for row in found.rows] == [["7"], ["8"]] and found.extra_columns == ["page"]
    assert list(found.to_frame()["page"]) == ["7", "8"]


def test_coiflets_start_at_their_own_index():
    taps = wavecurve.FilterBank("coif1").synthesis_low.taps
    found = wavecurve.check(taps, "coif1", "h")
    assert found.is_right and found.rows[0].index == -2


def test_departing_digits_are_marked_in_colour():
    found = wavecurve.check(["0.48296201"], "db2", "h")
    row = found.rows[0]
    assert "".join(text for text, _ in row.marked) == "0.48296201" and any(departs for _, departs in row.marked)
    html = found._repr_html_()
    assert "<mark" in html and row.verdict in html and "background:" in html
    assert str(found) and repr(found).startswith("<CheckedTable of 1 numbers")


def test_results_are_pickled():
    for found in (wavecurve.check(["0.5"], "haar", "h"), wavecurve.identify([0.4829629131, 0.8365163037, 0.224143868])):
        assert pickle.loads(pickle.dumps(found)) == found or math.isnan(found.rows[0].ulps)


def test_hostile_names_leave_no_markup():
    table = wavecurve.check(pandas.DataFrame({"index": [0], "printed": ["0.7071067811865476"], "<b>": ["<script>"]}), "haar", "h")
    assert "<script>" not in table._repr_html_()


@pytest.mark.parametrize("call", [
    lambda: wavecurve.check([1.0]),
    lambda: wavecurve.check([1.0], "db4", "what"),
    lambda: wavecurve.check([1.0], "nonsense", "h"),
    lambda: wavecurve.check(["word"], "db4", "h"),
    lambda: wavecurve.check([1.0], "db4", "h", first_index=99),
    lambda: wavecurve.check([], "db4", "h"),
    lambda: wavecurve.check("/nowhere/table.csv"),
    lambda: wavecurve.identify("nothing\nhere\n"),
])
def test_bad_tables_are_value_errors(call):
    with pytest.raises(ValueError) as caught:
        call()
    assert str(caught.value)


def test_what_is_no_number_is_a_type_error():
    with pytest.raises(TypeError):
        wavecurve.check([object()], "db4", "h")


LISTS = {
    "pywt": "dec_lo = [-0.12940952255092145, 0.22414386804185735, 0.836516303737469, 0.48296291314469025]\n",
    "columns": "0 0.4829629131\n1 0.8365163037\n2 0.2241438680\n3 -0.1294095226\n",
}


@pytest.mark.parametrize("name", LISTS)
def test_lists_are_identified_as_the_program_does(program, tmp_path, name):
    file = tmp_path / "list.txt"
    file.write_text(LISTS[name])
    shown = program("identify", file, "--format", "json")["columns"]
    for found in (wavecurve.identify(file), wavecurve.identify(LISTS[name])):
        assert [(one.name, one.numbers) for one in found] == [(one["name"], one["numbers"]) for one in shown]
        for ours, theirs in zip(found, shown):
            assert len(ours.matches) >= len(theirs["matches"]) >= 1
            for match, their in zip(ours.matches, theirs["matches"]):
                for field in ("filter", "quantity", "reversed", "negated", "alternating", "scale", "shift", "in_order",
                              "matched", "of", "known_as"):
                    assert getattr(match, field) == their[field], field
                assert match.digits == pytest.approx(their["digits"], abs=0.051)
            assert [near[:2] for near in ours.nearest] == [(n["filter"], n["quantity"]) for n in theirs["nearest"]]


def test_files_have_bounds_and_encodings(tmp_path):
    with pytest.raises(ValueError, match="16 MiB"):
        wavecurve.identify("/dev/zero")
    with pytest.raises(OSError):
        wavecurve.identify(tmp_path / "missing.txt")
    file = tmp_path / "wide.txt"
    file.write_text(LISTS["columns"], encoding="utf-16")
    assert wavecurve.identify(file)[0].matches[0].filter == "db2"


def test_arrays_and_frames_are_identified_by_column():
    a, b = wavecurve.FilterBank("db4").synthesis_low.taps, wavecurve.FilterBank("sym4").synthesis_low.taps
    for numbers in (numpy.column_stack([a, b]), pandas.DataFrame({"first": a, "second": b})):
        assert [one.matches[0].filter for one in wavecurve.identify(numbers)] == ["db4", "sym4"]
    assert wavecurve.identify(list(a))[0].matches[0].quantity == "h"
    unknown = wavecurve.identify([1.2345, 2.3456, 7.891])[0]
    assert unknown.matches == [] and "no known column" in repr(unknown) and len(unknown.nearest) == 3
    assert "db4" in wavecurve.identify(a)[0]._repr_html_()
