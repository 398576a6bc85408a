"""Cameras are found from marked points."""

import numpy as np
import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile, Span
from vrts.base.units import DEG
from vrts.pipeline.refused import Refused
from vrts.validate.camera.calibrate import Calibrated, calibrate
from vrts.validate.camera.calibration_file import Marked, Picture, read_marked
from vrts.validate.camera.model import Array, PtzCamera, View

SIZE = (960, 540)
VIEWS = (View(), View(12 * DEG, -4 * DEG, 1.3), View(-9 * DEG, 3 * DEG, 0.9))


def looking_at(eye: tuple[float, float, float], at: tuple[float, float, float]) -> Array:
    """Return rows right, down, forward of an upright camera."""
    forward = np.subtract(at, eye) / np.linalg.norm(np.subtract(at, eye))
    right = np.cross(forward, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(forward, right), forward])


TRUE = PtzCamera(
    np.array([2.6, -2.1, 0.9]),
    looking_at((2.6, -2.1, 0.9), (0.7, 0.0, -0.1)),
    1130.0,
    ((SIZE[0] - 1) / 2, (SIZE[1] - 1) / 2),
    (-0.11, 0.04),
    SIZE,
)


def points(count: int = 24, seed: int = 5) -> dict[str, Array]:
    """Return points round the working place, by name."""
    drawn = np.random.default_rng(seed).uniform((0.3, -0.6, -0.3), (1.1, 0.6, 0.5), (count, 3))
    return {f"p{k}": place for k, place in enumerate(drawn)}


def marked(
    camera: PtzCamera = TRUE,
    views: tuple[View, ...] = VIEWS,
    noise_px: float = 0.3,
    places: dict[str, Array] | None = None,
    *,
    fit_centre: bool = False,
) -> Marked:
    """Return marks of the points that a camera sees."""
    places = points() if places is None else places
    rng = np.random.default_rng(11)
    pictures: list[Picture] = []
    for view in views:
        pixels = camera.seen(np.array(list(places.values())), view)
        inside = np.all((pixels > 0) & (pixels < SIZE), axis=1)
        names = tuple(name for name, seen in zip(places, inside.tolist(), strict=True) if seen)
        found = pixels[inside] + rng.normal(0.0, noise_px, (int(inside.sum()), 2))
        source = SourceFile("camera.toml", "[camera]")
        pictures.append(Picture(view, names, found, Span(source, 0, 1)))
    return Marked(SIZE, None, fit_centre, True, places, tuple(pictures))


def found_in(what: Marked) -> Calibrated:
    found = calibrate(what)
    assert isinstance(found, Calibrated), found
    return found


def test_a_camera_is_found_again() -> None:
    found = found_in(marked())
    assert np.linalg.norm(found.camera.eye - TRUE.eye) < 0.005
    assert found.camera.focal_px == pytest.approx(TRUE.focal_px, rel=3e-3)
    assert found.rms_px < 0.5
    assert found.uncertain_mm < 5.0


def test_it_sees_other_points_in_other_views_where_they_are() -> None:
    found = found_in(marked())
    others = np.array(list(points(200, seed=9).values()))
    for view in (*VIEWS, View(5 * DEG, -6 * DEG, 1.6)):
        true, seen = TRUE.seen(others, view), found.camera.seen(others, view)
        inside = ((true > 0) & (true < SIZE)).all(axis=1)
        assert inside.sum() > 30
        assert np.linalg.norm((true - seen)[inside], axis=1).max() <= 0.5


def test_exact_marks_give_the_exact_camera() -> None:
    found = found_in(marked(noise_px=0.0))
    assert np.linalg.norm(found.camera.eye - TRUE.eye) < 1e-6
    assert found.largest_px < 1e-4


def test_one_picture_does_and_its_optical_axis_can_be_found() -> None:
    aside = TRUE._replace(centre_px=(500.0, 255.0))
    what = marked(aside, (View(), *VIEWS[1:]), 0.0, fit_centre=True)
    found = found_in(what)
    assert found.camera.centre_px == pytest.approx((500.0, 255.0), abs=0.01)
    alone = found_in(marked(views=VIEWS[:1], noise_px=0.0))
    assert np.linalg.norm(alone.camera.eye - TRUE.eye) < 1e-4


def test_points_in_a_plane_are_refused() -> None:
    flat = {name: place * (1, 1, 0) for name, place in points().items()}
    found = calibrate(marked(places=flat))
    assert isinstance(found, Diagnostic)
    assert found.rule.code == "V902"


@pytest.mark.thorough
def test_pan_with_the_wrong_sign_shows_in_the_errors() -> None:
    right = marked()
    wrong = right._replace(
        pictures=tuple(p._replace(view=p.view._replace(pan=-p.view.pan)) for p in right.pictures)
    )
    assert found_in(wrong).rms_px > 20.0


def test_pan_is_to_the_right_and_tilt_upward() -> None:
    ahead = TRUE.eye + 2.0 * TRUE.mount[2]
    middle = TRUE.seen(ahead[None], View())[0]
    assert middle == pytest.approx(TRUE.centre_px)
    panned = TRUE.seen(ahead[None], View(pan=0.1))[0]
    tilted = TRUE.seen(ahead[None], View(tilt=0.1))[0]
    assert panned[0] < middle[0] - 50  # what was in the middle goes to the left
    assert tilted[1] > middle[1] + 50  # and down


def test_points_behind_the_camera_are_not_seen() -> None:
    assert np.isnan(TRUE.seen((TRUE.eye - TRUE.mount[2])[None], View())).all()


FILE = """
[camera]
size_px = [960, 540]

[points_mm]
corner = [900, 300, -300]
tip = [700, 0, 250]

[[pictures]]
pan_deg = 5
seen_px = { corner = [512.5, 300.25], tip = [400, 120] }
"""


def test_a_file_of_marks_is_read() -> None:
    text = FILE.replace("tip = [700, 0, 250]", "tip = [700, 0, 250]\n" + _more(4))
    seen = ", ".join(f"q{k} = [{k}, {2 * k}]" for k in range(4))
    found = read_marked(SourceFile("camera.toml", text.replace("120] }", f"120], {seen} }}")))
    assert found.size_px == SIZE
    assert found.points["corner"] == pytest.approx([0.9, 0.3, -0.3])
    (picture,) = found.pictures
    assert picture.view.pan == pytest.approx(5 * DEG)
    assert picture.pixels[0] == pytest.approx([512.5, 300.25])


def _more(count: int) -> str:
    return "\n".join(f"q{k} = [{k}, 1, 2]" for k in range(count))


@pytest.mark.parametrize(
    ("before", "after", "code"),
    [
        ("tip = [400, 120]", "top = [400, 120]", "V900"),
        ("x", "x", "V901"),
        ("size_px = [960, 540]", "size_px = [960]", "V604"),
        ("pan_deg = 5", "pan = 5", "V602"),
        ("[points_mm]", "[points]", "V602"),
    ],
)
def test_what_is_wrong_in_a_file_is_told_at_its_place(before: str, after: str, code: str) -> None:
    with pytest.raises(Refused) as refused:
        read_marked(SourceFile("camera.toml", FILE.replace(before, after)))
    assert code in [d.rule.code for d in refused.value.diagnostics]
    assert refused.value.diagnostics[0].primary is not None
