"""Marks that were mistaken are named and do not move the camera."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from tests.unit.validate.camera.test_calibrate import SIZE, TRUE, VIEWS, found_in, marked, points
from vrts.base.units import DEG
from vrts.cli.main import vrts
from vrts.validate.camera.calibration_file import Marked
from vrts.validate.camera.model import View
from vrts.validate.camera.wrong_marks import told

PLACES = points(9, seed=3)


@dataclass(frozen=True)
class Moved:
    """A mark that was put somewhere else."""

    picture: int
    row: int
    by: tuple[float, float]


def wrong(what: Marked, *moved: Moved) -> Marked:
    """Return marks of which some are wrong."""
    pictures = list(what.pictures)
    for one in moved:
        pixels = pictures[one.picture].pixels.copy()
        pixels[one.row] += one.by
        pictures[one.picture] = pictures[one.picture]._replace(pixels=pixels)
    return what._replace(pictures=tuple(pictures))


def exchanged(what: Marked, picture: int, one: int, other: int) -> Marked:
    """Return marks of which two of a picture have one another's names."""
    pictures = list(what.pictures)
    pixels = pictures[picture].pixels.copy()
    pixels[[one, other]] = pixels[[other, one]]
    pictures[picture] = pictures[picture]._replace(pixels=pixels)
    return what._replace(pictures=tuple(pictures))


@pytest.mark.parametrize("views", [VIEWS, VIEWS[:1]], ids=["three pictures", "one picture"])
def test_two_marks_that_were_exchanged_are_named_and_move_nothing(views: tuple[View, ...]) -> None:
    right = marked(places=PLACES, views=views)
    what = exchanged(right, 0, 1, 4)
    found, clean = found_in(what), found_in(right)
    names = right.pictures[0].names
    assert {(one.name, one.exchanged_with) for one in found.left_out} == {
        (names[1], names[4]),
        (names[4], names[1]),
    }
    assert found.rms_px < 0.5
    assert np.linalg.norm(found.camera.eye - TRUE.eye) < 3e-3 * found.uncertain_mm
    assert clean.left_out == ()
    (said,) = told(what, found.left_out)
    assert said.headline == f"the marks of `{names[1]}` and `{names[4]}` in picture 1 are exchanged"


@pytest.mark.parametrize("by", [(8.0, 0.0), (0.0, -35.0), (300.0, 120.0)])
def test_a_wrong_mark_is_named_with_how_far_it_is_off(by: tuple[float, float]) -> None:
    what = wrong(marked(places=PLACES), Moved(1, 2, by))
    found = found_in(what)
    (one,) = found.left_out
    assert (one.picture, one.name) == (1, what.pictures[1].names[2])
    assert one.miss_px == pytest.approx(np.hypot(*by), abs=2.0)
    assert found.rms_px < 0.5


def test_two_wrong_marks_in_two_pictures_are_both_named() -> None:
    what = wrong(marked(places=PLACES), Moved(0, 0, (40.0, 10.0)), Moved(2, 3, (-25.0, 60.0)))
    found = found_in(what)
    assert [one.picture for one in found.left_out] == [0, 2]
    assert np.linalg.norm(found.camera.eye - TRUE.eye) < 0.03


@pytest.mark.thorough
def test_right_marks_are_kept_and_single_wrong_ones_found_whatever_the_noise() -> None:
    kept = named = 0
    for seed in range(40):
        what = marked(places=points(10, seed=seed), noise_px=0.2 + 0.01 * seed)
        kept += found_in(what).left_out == ()
        rows = len(what.pictures[0].names)
        found = found_in(wrong(what, Moved(0, seed % rows, (12.0 + seed, 30.0 - seed))))
        named += [one.name for one in found.left_out] == [what.pictures[0].names[seed % rows]]
    assert (kept, named) >= (39, 39)


def test_where_tilt_counts_from_is_found_once_the_camera_has_panned() -> None:
    off = TRUE._replace(tilt_zero=1.5 * DEG)
    found = found_in(marked(off, noise_px=0.05))
    assert found.camera.tilt_zero == pytest.approx(1.5 * DEG, abs=0.1 * DEG)
    assert found.rms_px < 0.5
    still = found_in(marked(off, views=(View(), View(0.0, -4 * DEG))))
    assert still.camera.tilt_zero == 0.0, "nothing tells it there: it is part of the mount"
    assert still.rms_px < 0.5


def file_of(what: Marked) -> str:
    """Return the calibration file of marks."""
    rows = [f"[camera]\nsize_px = [{SIZE[0]}, {SIZE[1]}]\n[points_mm]"]
    rows += [f"{n} = [{', '.join(f'{1e3 * v:.3f}' for v in p)}]" for n, p in what.points.items()]
    for picture in what.pictures:
        view = picture.view
        seen = ", ".join(
            f"{name} = [{u:.3f}, {v:.3f}]"
            for name, (u, v) in zip(picture.names, picture.pixels.tolist(), strict=True)
        )
        rows.append(
            f"[[pictures]]\npan_deg = {view.pan / DEG}\ntilt_deg = {view.tilt / DEG}\n"
            f"zoom = {view.zoom}\nseen_px = {{ {seen} }}"
        )
    return "\n".join(rows) + "\n"


def test_the_command_names_a_wrong_mark_and_fails_where_marks_do_not_agree(tmp_path: Path) -> None:
    program = tmp_path / "x.v2"
    program.write_text(".PROGRAM main()\n        READY\n.END\n")
    camera = tmp_path / "camera.toml"
    right = marked(places=PLACES)
    words = ["validate", str(program), "--camera", str(camera)]
    camera.write_text(file_of(exchanged(right, 0, 1, 4)))
    done = CliRunner().invoke(vrts, words)
    assert done.exit_code == 0, done.output
    assert "warning[V908 wrong-mark]: the marks of `" in done.output
    mirrored = right._replace(
        pictures=tuple(p._replace(view=p.view._replace(pan=-p.view.pan)) for p in right.pictures)
    )
    camera.write_text(file_of(mirrored))
    done = CliRunner().invoke(vrts, words)
    assert done.exit_code == 1, done.output
    assert "px off, more than 0.5 px" in done.output
