"""The package as a whole: help, types, memory, threads, Ctrl-C, charts, the guide."""
import doctest
import gc
import importlib
import inspect
import os
import pathlib
import pkgutil
import resource
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy
import pytest
import wavecurve

FOLDER = pathlib.Path(wavecurve.__file__).parent
MODULES = [importlib.import_module(f"wavecurve.{info.name}") for info in pkgutil.iter_modules([str(FOLDER)])]


def public_objects():
    for name in wavecurve.__all__:
        thing = getattr(wavecurve, name)
        yield name, thing
        if inspect.isclass(thing):
            for member, value in inspect.getmembers(thing):
                if not member.startswith("_") and (callable(value) or isinstance(value, property)) and (
                        getattr(value, "__module__", "") or "").startswith("wavecurve"):
                    yield f"{name}.{member}", value


def test_help_of_everything_is_there():
    assert wavecurve.__doc__
    for name, thing in public_objects():
        if name != "data_folder":
            assert (inspect.getdoc(thing) or "").strip(), name
    charts = importlib.import_module("wavecurve.charts")
    assert all(inspect.getdoc(getattr(charts, name)) for name in charts.__all__)


def test_functions_say_what_they_return():
    for name in wavecurve.__all__:
        thing = getattr(wavecurve, name)
        if inspect.isfunction(thing):
            assert "Returns\n-------" in inspect.getdoc(thing), name


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_examples_in_the_help_hold(module):
    found = doctest.testmod(module)
    assert found.failed == 0


def test_types_are_clean(tmp_path):
    mypy = pytest.importorskip("mypy.api")
    user = tmp_path / "user.py"
    user.write_text("import wavecurve\nx: float = float(wavecurve.coefficients('db4').mu[0])\n"
                    "reveal_type(wavecurve.FilterBank('db4').dec_lo)\n")
    sources = tmp_path / "wavecurve"
    sources.mkdir()
    for file in FOLDER.iterdir():
        if file.suffix in (".py", ".pyi", ".typed"):
            (sources / file.name).write_bytes(file.read_bytes())
    os.environ["MYPYPATH"] = str(tmp_path)
    text, errors, code = mypy.run(["--ignore-missing-imports", "--cache-dir", str(tmp_path / "cache"), "--strict",
                                   "--no-warn-return-any", "--no-warn-unused-ignores", "-p", "wavecurve", "--python-version", "3.11"])
    assert code == 0, text + errors
    text, errors, code = mypy.run(["--ignore-missing-imports", "--cache-dir", str(tmp_path / "cache"), str(user)])
    assert code == 0 and "list[builtins.float]" in text, text + errors


def resident():
    """Bytes of this process in memory."""
    gc.collect()
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize()


def leaking(calls, work):
    """What calls leave, in bytes a call: the least of four windows, for caches and the allocator's arenas warm up in some,
    and a leak is in all."""
    window, left = calls // 4, []
    for _ in range(4):
        before = resident()
        for _ in range(window):
            work()
        left.append((resident() - before) / window)
    return min(left)


def test_a_hundred_thousand_calls_leave_nothing():
    x, out = numpy.zeros((2, 64)), numpy.zeros((2, 64))
    transform, bank = wavecurve.Transform("db4", 64), wavecurve.FilterBank("db4")

    def work():
        transform.forward(x)
        transform.inverse(x, out=out)
        wavecurve.forward(x, "coif2")
        bank.taps("analysis_low")
        try:
            transform.forward(x, axis=5)
        except ValueError:
            pass

    # A leaked object of Python has 16 bytes at least.
    assert leaking(100_000, work) < 4


def test_long_calls_leave_nothing():
    def work():
        wavecurve.coefficients("db3", digits=20)
        wavecurve.check([0.5], "haar", "h")
        try:
            wavecurve.coefficients("db2")
        except ArithmeticError:
            pass

    # A thread that kept its stack's or FLINT's memory would leave a page at least, 4096 bytes; a leaked result hundreds.
    assert leaking(600, work) < 200


def test_eight_threads_get_the_same_results():
    def work(_):
        found = wavecurve.coefficients("coif1", digits=25)
        table = wavecurve.check([0.48296, 0.8365163], "db2", "h")
        k = wavecurve.stiffness("db4", 64)
        return str(found), str(table), k.data.tobytes()

    with ThreadPoolExecutor(8) as pool:
        results = list(pool.map(work, range(24)))
    assert len(set(results)) == 1


def test_others_run_while_a_long_call_does():
    ticks = []
    ended = threading.Event()

    def tick():
        while not ended.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.005)

    other = threading.Thread(target=tick)
    other.start()
    start = time.monotonic()
    while time.monotonic() - start < 0.3:
        wavecurve.coefficients("coif5", (1, 1), 60)
    ended.set()
    other.join()
    assert len(ticks) > 5


def test_ctrl_c_is_answered():
    code = """
import os, signal, threading, time
import wavecurve
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background job ignores it
threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
start = time.monotonic()
try:
    while True:
        wavecurve.coefficients("coif17", (1, 1), 3000)
except KeyboardInterrupt:
    print("interrupted", time.monotonic() - start < 20, flush=True)
    os._exit(0)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.stdout == "interrupted True\n", done.stderr


def test_charts_are_drawn():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    charts = importlib.import_module("wavecurve.charts")
    studied = wavecurve.study(samples=[16], shapes=["star"], dampings=[(0, 0)], solvers=["decoupled", "coupled"])
    drawn = [charts.plot_filter("db4"), charts.plot_numbers(wavecurve.coefficients("db3", digits=8).mu),
             charts.plot_checked(wavecurve.check([0.5], "haar", "h")), charts.plot_matrix(wavecurve.stiffness("db4", 16)),
             charts.plot_schulz(wavecurve.schulz_inverse(numpy.diag([1.0, 2.0]))), charts.plot_study(studied),
             charts.plot_contours(wavecurve.describe(wavecurve.data_folder / "examples" / "face-dog.svg", samples=32))]
    for axes in drawn:
        axes.figure.canvas.draw()
        assert axes.has_data()


def test_matplotlib_scipy_and_pandas_are_imported_when_asked_for():
    code = "import sys, wavecurve; print([m for m in ('matplotlib', 'scipy', 'pandas') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


GUIDE = pathlib.Path(__file__).resolve().parents[3] / "docs" / "guide" / "python.md"


def test_the_guide_shows_what_python_prints():
    blocks, inside = [], False
    for number, line in enumerate(GUIDE.read_text().splitlines(), 1):
        if line.startswith("```"):
            inside = line == "```python"
        blocks.append(line if inside and not line.startswith("```") else "")
    test = doctest.DocTestParser().get_doctest("\n".join(blocks) + "\n", {}, GUIDE.name, str(GUIDE), 0)
    assert len(test.examples) > 20
    shown = []
    doctest.DocTestRunner(verbose=False).run(test, out=shown.append)
    assert not shown, "".join(shown)


def test_a_wheel_holds_the_package(tmp_path, monkeypatch):
    build = os.environ.get("WAVECURVE_BUILD")
    if build is None:
        pytest.skip("WAVECURVE_BUILD names no build tree")
    monkeypatch.syspath_prepend(str(pathlib.Path(__file__).resolve().parents[1]))
    name = importlib.import_module("build_wheel").pack(pathlib.Path(build), tmp_path)
    code = f"import sys; sys.path.insert(0, '{tmp_path}/here'); import wavecurve; print(wavecurve.__file__, wavecurve.check([0.5], 'haar', 'h'))"
    subprocess.run([sys.executable, "-m", "pip", "install", "--no-deps", "--no-index", "--quiet", "--target", tmp_path / "here", tmp_path / name],
                   check=True)
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment)
    assert done.stdout.startswith(str(tmp_path)) and "1 " in done.stdout, done.stderr
