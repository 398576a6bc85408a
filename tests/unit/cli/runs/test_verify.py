"""`vrts verify`: which program is verified."""

from pathlib import Path

from tests.unit.cli.test_commands import EXAMPLE, SOLUTION, vrts

TWO = """.PROGRAM main
        READY
.END
.PROGRAM unload
        DRIVE 1, 20, 50
        TYPE "unloaded"
.END
"""


def test_another_program_is_verified_when_it_is_named(tmp_path: Path) -> None:
    program = tmp_path / "p.v2"
    program.write_text(TWO, "utf-8")
    scene = ("--scene", "cans-on-bases", "--no-collisions", "--html", tmp_path / "page.html")
    result = vrts("verify", program, *scene, "--entry", "Unload")
    assert result.returncode == 0
    assert "unloaded" in (tmp_path / "page.html").read_text("utf-8")
    result = vrts("verify", program, *scene[:3], "--entry", "nowhere")
    assert result.returncode == 1
    assert b"there is no program `nowhere` to execute" in result.stdout
    assert b"main, unload" in result.stdout


def test_a_mark_of_another_program_than_the_task_asks_for_says_so(tmp_path: Path) -> None:
    text = (EXAMPLE / "task.toml").read_text("utf-8")
    (tmp_path / "task.toml").write_text(text.replace("[task]", '[task]\nprogram = "main"', 1))
    (tmp_path / "p.v2").write_text(TWO + Path(SOLUTION).read_text("utf-8").replace("main", "m"))
    words = ("verify", tmp_path / "p.v2", "--no-collisions", "--format", "json")
    told = b"the task asks for the program `main`: this is the mark of `unload`"
    assert told in vrts(*words, "--entry", "unload").stderr
    assert told not in vrts(*words, "--entry", "main").stderr
