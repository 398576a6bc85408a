"""`vrts verify --certificate` and `vrts check-proof`: what is proven, and what is refused."""

import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.places import ROOT
from tests.unit.check.proof.test_certificate import formatted, members, retold
from tests.unit.cli.test_commands import EXAMPLE, HITS, SOLUTION, vrts
from vrts.base.zips import packed
from vrts.check.proof.certificate import digest

COLOR = ("--color", "never")


@pytest.fixture(scope="module")
def proofs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the certificates of the first example, and of one that hits a base."""
    folder = tmp_path_factory.mktemp("proofs")
    for program, name in ((SOLUTION, "run.cert"), (HITS, "hits.cert")):
        result = vrts("verify", program, "--certificate", folder / name)
        assert f"wrote {folder / name}".encode() in result.stderr
    return folder


@pytest.mark.thorough
def test_a_certificate_says_what_is_proven_and_of_what(proofs: Path) -> None:
    result = vrts("check-proof", proofs / "run.cert", SOLUTION)
    assert result.returncode == 0
    text = result.stdout.decode()
    assert "holds: for every instant from 0 to" in text
    assert "nothing touches anything" in text
    assert "mm remain everywhere" in text
    assert "solution.v2" in text
    assert "cans-on-bases, sha256" in text
    assert "controller  val2, sha256" in text


@pytest.mark.thorough
def test_contacts_are_proven_too_and_no_others(proofs: Path) -> None:
    result = vrts("check-proof", proofs / "hits.cert", HITS)
    assert result.returncode == 0
    text = result.stdout.decode()
    assert "one contact, and no other:" in text
    assert "robot and base1, between" in text


def test_a_certificate_needs_nothing_beside_it(proofs: Path, tmp_path: Path) -> None:
    elsewhere = tmp_path / "proof"
    elsewhere.write_bytes((proofs / "run.cert").read_bytes())
    assert vrts("check-proof", elsewhere, cwd=tmp_path).returncode == 0


TURN = b".PROGRAM main()\n DRIVE 1, 20, 50\n READY\n.END\n"


@pytest.fixture(scope="module", name="described")
def described_arm(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a program, and a scene beside whose file an arm is described."""
    folder = tmp_path_factory.mktemp("described")
    shutil.copytree(ROOT / "scenes" / "one-can-urdf", folder / "cell")
    (folder / "turn.v2").write_bytes(TURN)
    return folder


@pytest.mark.thorough
def test_a_certificate_does_not_depend_on_where_it_was_written(described: Path) -> None:
    """Nor on how paths were typed: none is in it."""
    found: set[bytes] = set()
    for number, (cwd, program, scene) in enumerate(
        (
            (described, "turn.v2", "cell/scene.toml"),
            (described / "cell", "../turn.v2", "scene.toml"),
            (described / "cell", "../turn.v2", "../cell"),
            (Path("/"), described / "turn.v2", described / "cell" / "scene.toml"),
        )
    ):
        target = described / f"{number}.cert"
        result = vrts("verify", program, "--scene", scene, "--certificate", target, cwd=cwd)
        assert result.returncode == 0, result.stderr
        found.add(target.read_bytes())
    (data,) = found
    said = members(data)["proof.json"].decode()
    assert described.name not in said
    assert '[["turn.v2",' in said
    assert '"name":"cell.toml"' in said


def test_files_that_a_scene_names_come_along(described: Path, tmp_path: Path) -> None:
    target = tmp_path / "run.cert"
    words = ("verify", "turn.v2", "--scene", "cell", "--certificate", target)
    assert vrts(*words, cwd=described).returncode == 0
    result = vrts("check-proof", "run.cert", cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert b"scene       cell, sha256" in result.stdout
    arm = (described / "cell" / "arm.urdf").read_bytes()
    parts = members(target.read_bytes())
    assert parts["files"] == arm
    longer = arm.replace(b"0.4", b"0.5", 1)
    assert longer != arm
    target.write_bytes(packed({**parts, "files": longer}, 0o600))
    result = vrts("check-proof", "run.cert", *COLOR, cwd=tmp_path)
    assert result.returncode == 1
    assert b"its scene is not the one that it names" in result.stderr
    target.write_bytes(packed({**parts, "files": arm + b" "}, 0o600))
    result = vrts("check-proof", "run.cert", *COLOR, cwd=tmp_path)
    assert result.returncode == 1
    assert b"the files of its scene have other lengths" in result.stderr


@pytest.mark.thorough
def test_it_is_about_one_program_scene_and_run(proofs: Path, tmp_path: Path) -> None:
    for words, what in (
        ((HITS,), b"it is about another program"),
        ((SOLUTION, "--scene", "one-can-puma761"), b"it is about another scene"),
    ):
        result = vrts("check-proof", proofs / "run.cert", *words, *COLOR)
        assert result.returncode == 1
        assert b"error[V549 other-certificate]" in result.stderr
        assert what in result.stderr
    saved = tmp_path / "saved.vrun"
    vrts("run", SOLUTION, "--scene", "cans-on-bases", "--save", saved)
    result = vrts("check-proof", proofs / "run.cert", "--run", saved, *COLOR)
    assert result.returncode == 0  # though the task has limits of its own
    vrts("run", HITS, "--scene", "cans-on-bases", "--save", saved, "--overwrite")
    result = vrts("check-proof", proofs / "run.cert", "--run", saved, *COLOR)
    assert result.returncode == 1
    assert b"it is about another program" in result.stderr


@pytest.mark.thorough
def test_the_controller_model_is_part_of_what_a_certificate_is_about(
    proofs: Path, tmp_path: Path
) -> None:
    target = tmp_path / "vplus.cert"
    vrts("verify", SOLUTION, "--controller", "vplus", "--certificate", target)
    for words in ((), (SOLUTION, "--controller", "vplus"), ("--controller", "vplus")):
        result = vrts("check-proof", target, *words, *COLOR)
        assert result.returncode == 0, (words, result.stderr)
        assert b"controller  vplus, sha256" in result.stdout
    for certificate, words, ours, rest in (
        (target, (SOLUTION,), "vplus", "the program given by `val2`"),
        (proofs / "run.cert", (SOLUTION, "--controller", "vplus"), "val2", "given by `vplus`"),
        (proofs / "run.cert", ("--controller", "vplus"), "val2", "asked for is `vplus`"),
    ):
        result = vrts("check-proof", certificate, *words, *COLOR)
        assert result.returncode == 1
        text = result.stderr.decode()
        assert "error[V549 other-certificate]" in text
        assert f"its run goes by the controller model `{ours}`" in text
        assert rest in text
        assert f"help: give `--controller {ours}`" in text


def test_a_damaged_certificate_is_one_diagnostic(proofs: Path, tmp_path: Path) -> None:
    data, broken = (proofs / "run.cert").read_bytes(), tmp_path / "broken.cert"
    for damaged in (data[:2000], b"", b"PK", SOLUTION.read_bytes()):
        broken.write_bytes(damaged)
        result = vrts("check-proof", broken, *COLOR)
        assert result.returncode == 1
        assert result.stderr.decode().splitlines()[-1] == "1 error"
        assert b"error[V546 damaged-certificate]" in result.stderr
    assert b"is damaged: it is none, or its beginning was changed" in result.stderr


def test_a_certificate_of_another_format_is_told_as_such_and_how_to_write_it_anew(
    proofs: Path, tmp_path: Path
) -> None:
    old = tmp_path / "old.cert"
    for number, which in ((1, "an older"), (3, "an older"), (5, "a newer")):
        old.write_bytes(formatted((proofs / "run.cert").read_bytes(), number))
        result = vrts("check-proof", old, SOLUTION, *COLOR)
        assert result.returncode == 1
        assert not result.stdout
        text = result.stderr.decode()
        assert "error[V550 certificate-format]" in text
        assert f"old.cert` was written by {which} vrts" in text
        assert f"its format is `vrts.proof/{number}`, not `vrts.proof/4`" in text
        assert "help: write it again with `vrts verify PROGRAM --certificate FILE`" in text


@pytest.mark.parametrize(
    ("words", "exit_status"),
    [(("missing.v2",), 2), (("--run", "missing.vrun"), 2), (("--controller", "none"), 2)],
)
def test_what_is_missing_is_told_and_nothing_else(
    proofs: Path, words: tuple[str, ...], exit_status: int
) -> None:
    result = vrts("check-proof", proofs / "run.cert", *words, *COLOR)
    assert result.returncode == exit_status
    assert not result.stdout
    assert words[-1] in result.stderr.decode()


def test_a_false_certificate_names_the_first_thing_that_does_not_hold(
    proofs: Path, tmp_path: Path
) -> None:
    def hide(said: dict[str, Any]) -> None:
        said["claims"]["contacts"] = []

    false = tmp_path / "false.cert"
    false.write_bytes(retold((proofs / "hits.cert").read_bytes(), hide))
    result = vrts("check-proof", false, *COLOR)
    assert result.returncode == 1
    text = result.stderr.decode()
    assert "error[V547 certificate-does-not-prove]" in text
    assert "base1" in text
    assert " s (" in text


def test_another_program_in_a_certificate_is_not_proven_by_it(proofs: Path, tmp_path: Path) -> None:
    false = tmp_path / "false.cert"

    def change(said: dict[str, Any]) -> None:
        source = said["origin"]["programs"]["sources"][0]
        source[1] = HITS.read_text()
        said["sha256"]["origin"] = digest(said["origin"])

    false.write_bytes(retold((proofs / "run.cert").read_bytes(), change))
    result = vrts("check-proof", false, *COLOR)
    assert result.returncode == 1
    assert b"its programs compile to something else now" in result.stderr


def test_scene_and_controller_are_those_that_are_named(proofs: Path, tmp_path: Path) -> None:
    false = tmp_path / "false.cert"
    for part, name in (("scene", "sha256"), ("controller", "sha256"), ("programs", "sha256")):

        def change(said: dict[str, Any], part: str = part, name: str = name) -> None:
            said["origin"][part][name] = 64 * "0"
            said["sha256"]["origin"] = digest(said["origin"])

        false.write_bytes(retold((proofs / "run.cert").read_bytes(), change))
        result = vrts("check-proof", false, *COLOR)
        assert result.returncode == 1
        assert b"error[V549 other-certificate]" in result.stderr


def test_a_certificate_is_of_the_check_of_collisions(tmp_path: Path) -> None:
    words = ("--certificate", tmp_path / "run.cert", "--no-collisions")
    result = vrts("verify", SOLUTION, *words)
    assert result.returncode == 2
    assert not (tmp_path / "run.cert").exists()


def test_what_cannot_be_shown_is_said(tmp_path: Path) -> None:
    program = tmp_path / "empty.v2"
    program.write_text(".PROGRAM main\n TYPE 1\n.END\n")
    target = tmp_path / "run.cert"
    result = vrts("verify", program, "--scene", "cans-on-bases", "--certificate", target, *COLOR)
    assert result.returncode == 1
    assert b"error[V548 not-certified]" in result.stderr
    assert not target.exists()


def test_a_task_may_be_given_that_the_certificate_is_of(proofs: Path) -> None:
    result = vrts("check-proof", proofs / "run.cert", SOLUTION, "--task", EXAMPLE / "task.toml")
    assert result.returncode == 0
