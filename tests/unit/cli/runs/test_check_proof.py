"""`vrts verify --certificate` and `vrts check-proof`: what is proven, and what is refused."""

from pathlib import Path
from typing import Any

import pytest

from tests.unit.check.proof.test_certificate import retold
from tests.unit.cli.test_commands import EXAMPLE, HITS, SOLUTION, vrts
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


def test_a_damaged_certificate_is_one_diagnostic(proofs: Path, tmp_path: Path) -> None:
    data, broken = (proofs / "run.cert").read_bytes(), tmp_path / "broken.cert"
    for damaged in (data[:2000], b"", b"PK", SOLUTION.read_bytes()):
        broken.write_bytes(damaged)
        result = vrts("check-proof", broken, *COLOR)
        assert result.returncode == 1
        assert result.stderr.decode().splitlines()[-1] == "1 error"
        assert b"error[V546 damaged-certificate]" in result.stderr


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
