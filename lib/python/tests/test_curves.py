"""Drawings, descriptors, distances of shapes, curves, morphs."""
import json
import pickle

import numpy
import pytest
import wavecurve

EXAMPLES = wavecurve.data_folder / "examples"


def circle(samples=64, bumps=0.0):
    turns = 2 * numpy.pi * numpy.arange(samples) / samples
    radius = 1 + bumps * numpy.cos(5 * turns)
    return numpy.column_stack([radius * numpy.cos(turns), radius * numpy.sin(turns)])


@pytest.mark.parametrize("mode", ["samples", "interpolate"])
def test_descriptors_are_the_programs(program, tmp_path, mode):
    file = tmp_path / "d.json"
    program("describe", EXAMPLES / "face-dog.svg", "--samples", 64, "--levels", 3, "-o", file, text=True,
            *(["--interpolate"] if mode == "interpolate" else []))
    found = wavecurve.describe(EXAMPLES / "face-dog.svg", samples=64, levels=3, mode=mode)
    shown = json.loads(file.read_text())
    assert json.loads(found.to_json()) == shown
    for ours, theirs in zip(found.layers, shown["layers"]):
        assert ours.id == theirs["id"]
        for contour, their in zip(ours.contours, theirs["contours"]):
            assert numpy.array_equal(contour.coefficients, numpy.column_stack([their["x"], their["y"]]))
            assert (contour.closed, contour.length) == (their["closed"], their["length"])
            assert contour.energy_shares.sum() == pytest.approx(1)


def test_reconstructions_are_the_samples():
    drawing = wavecurve.read_drawing(EXAMPLES / "face-dog.svg")
    descriptor = wavecurve.describe(drawing, samples=64)
    for id in drawing.layers:
        for again, points in zip(descriptor.reconstruct(id), drawing.contours(id, 64)):
            assert numpy.max(numpy.abs(again - points)) < 1e-9 * max(drawing.view_box)
    assert len(descriptor.reconstruct(0, 16)[0]) == 64
    for bad in (lambda: descriptor.reconstruct("nobody"), lambda: descriptor.reconstruct(0, 17), lambda: descriptor.reconstruct(99)):
        with pytest.raises(ValueError):
            bad()


def test_coefficients_and_back():
    points = circle(32, 0.2)
    for mode in ("samples", "interpolate"):
        c = wavecurve.to_coefficients(points, "bspline4.4", 3, mode=mode)
        assert numpy.max(numpy.abs(wavecurve.to_samples(c, "bspline4.4", 3, mode=mode) - points)) < 1e-12
    with pytest.raises(ValueError):
        wavecurve.to_coefficients(points, "db4", mode="what")
    with pytest.raises(ArithmeticError):
        wavecurve.to_coefficients(points, "bspline3.3", 3, mode="interpolate")


def test_a_curve_passes_through_what_it_interpolates():
    points = circle(32, 0.2)
    finest = wavecurve.to_coefficients(points, "bspline4.4", 0, mode="interpolate")
    curve = wavecurve.Curve("bspline4.4", finest)
    t = numpy.arange(32) / 32
    assert numpy.max(numpy.abs(curve(t) - points)) < 1e-12
    assert curve(0.25).shape == (2,) and curve(t.reshape(4, 8)).shape == (4, 8, 2)
    step = 1e-6
    assert numpy.allclose(curve(t, 1), (curve(t + step) - curve(t - step)) / (2 * step), rtol=1e-6, atol=1e-6)
    round = wavecurve.Curve("bspline4.4", wavecurve.to_coefficients(circle(64), "bspline4.4", 0, mode="interpolate"))
    # The second derivative of a cubic spline through points h apart is off by h^2 / 12 of the fourth, here h = 2 pi / 64.
    assert round.curvature(t) == pytest.approx(numpy.ones(32), abs=1.01 * (2 * numpy.pi / 64) ** 2 / 12)
    with pytest.raises(ArithmeticError, match="exponent"):
        curve(t, 9)
    again = pickle.loads(pickle.dumps(curve))
    assert numpy.array_equal(again(t), curve(t))


def test_distance_is_of_shapes():
    a, b = circle(64, 0.3) * [1.5, 1], circle(64, 0.25) * [1.5, 1]  # whose first ellipses are no circles
    turned = 3 * a @ numpy.array([[0.6, -0.8], [0.8, 0.6]]) + [5, 7]
    assert wavecurve.shape_distance(a, turned).total < 1e-7
    found = wavecurve.shape_distance(a, b)
    assert found.total > 0.01 and numpy.linalg.norm(found.by_scale) == pytest.approx(found.total)
    assert wavecurve.elliptic_fourier_distance(a, turned) < 1e-6 < wavecurve.elliptic_fourier_distance(a, b)
    assert numpy.max(numpy.abs(wavecurve.normalized_contour(a) - wavecurve.normalized_contour(turned))) < 1e-6
    with pytest.raises(ValueError):
        wavecurve.shape_distance(a, circle(32))
    with pytest.raises(ValueError, match="n x 2"):
        wavecurve.shape_distance(a, a.T)


def test_crossings_and_samples():
    eight = [[0, 0], [1, 1], [1, 0], [0, 1]]
    assert wavecurve.count_crossings(eight) == 1 and wavecurve.count_crossings(circle()) == 0
    square = wavecurve.sample_contour([[0, 0], [1, 0], [1, 1], [0, 1]], 8)
    assert numpy.max(numpy.abs(square - [[0, 0], [.5, 0], [1, 0], [1, .5], [1, 1], [.5, 1], [0, 1], [0, .5]])) < 1e-12


def test_morphs_end_as_the_drawings(program, tmp_path):
    source, destination = EXAMPLES / "face-dog.svg", EXAMPLES / "face-cat.svg"
    morph = wavecurve.morph(source, destination, samples=64)
    animation = morph.animate()
    assert animation.duration == 2
    first, last = animation.frame(0), animation.frame(2)
    assert {layer.id for layer in first} and all(c.shape[1] == 2 for layer in last for c in layer.contours)
    middle = {layer.id: layer for layer in animation.frame(1)}
    ends = {layer.id: layer for layer in last}
    for layer in first:
        for a, b, c in zip(layer.contours, middle[layer.id].contours, ends[layer.id].contours):
            assert numpy.max(numpy.abs((a + c) / 2 - b)) < 1e-9
    program("morph", source, destination, "--samples", 64, "--frames", 5, "-o", tmp_path / "theirs.json", text=True)
    morph.write(tmp_path / "ours.json", frames=5)
    assert (tmp_path / "ours.json").read_bytes().replace(b"ours", b"theirs") == (tmp_path / "theirs.json").read_bytes()
    moved = morph.move(frames=5)
    assert moved.duration > 0 and len(moved.frame(0)) == len(first)
    moved.write(tmp_path / "moved.svg", frames=5)
    assert (tmp_path / "moved.svg").read_text().startswith("<")


def test_bad_drawings_and_files_have_messages(tmp_path):
    with pytest.raises(ValueError, match="nobody.svg"):
        wavecurve.read_drawing(tmp_path / "nobody.svg")
    morph = wavecurve.morph(EXAMPLES / "face-dog.svg", EXAMPLES / "face-cat.svg", samples=16)
    with pytest.raises(OSError, match="nowhere"):
        morph.write(tmp_path / "nowhere" / "a.svg")
    with pytest.raises(ValueError):
        morph.write(tmp_path / "a.doc")
    with pytest.raises(ValueError, match="detail"):
        wavecurve.morph(EXAMPLES / "face-dog.svg", EXAMPLES / "face-cat.svg", detail="what")


def test_descriptors_and_drawings_are_pickled():
    descriptor = wavecurve.describe(EXAMPLES / "face-dog.svg", samples=32)
    assert pickle.loads(pickle.dumps(descriptor)).to_json() == descriptor.to_json()
    assert "contours" in repr(descriptor) and "layers" in repr(wavecurve.read_drawing(EXAMPLES / "three.svg"))
