"""Whether the arm reaches a location, in the scene as its files are now."""

from pathlib import Path

from tests.unit.lsp.in_a_cell import setting
from vrts.base.oat import pose_from_components
from vrts.lsp.runs.reaching import reach_text
from vrts.lsp.server.background.reaching import Reaching

X_WT = pose_from_components(900.0, 0.0, 0.0, 90.0, 90.0, 0.0)


def test_reach_is_that_of_the_scene_as_it_is_now(tmp_path: Path) -> None:
    program, scene = str(setting(tmp_path)), tmp_path / "cell" / "scene.toml"
    text = scene.read_text("utf-8")
    near = reach_text(program, X_WT)
    assert near.startswith("reachable")
    scene.write_text(text.replace("puma761", "puma560"), "utf-8")  # the task stays as it is
    assert reach_text(program, X_WT) != near
    scene.write_text("nonsense", "utf-8")
    assert reach_text(program, X_WT) == ""
    scene.write_text(text, "utf-8")
    assert reach_text(program, X_WT) == near


def test_the_process_beside_the_server_says_the_same_and_is_begun_again(tmp_path: Path) -> None:
    (tmp_path / "none").mkdir()
    (tmp_path / "lab").mkdir()
    program = str(setting(tmp_path / "lab"))
    reaching = Reaching()
    assert reaching.text(str(tmp_path / "none" / "a.v2"), X_WT) == ""  # no task, so no process
    assert reaching.process is None
    try:
        assert reaching.text(program, X_WT) == reach_text(program, X_WT)
        process = reaching.process
        assert process is not None
        assert reaching.text(program, X_WT) == reach_text(program, X_WT)
        assert reaching.process is process
        process.kill()
        process.wait()
        assert reaching.text(program, X_WT) == ""
        assert reaching.text(program, X_WT) == reach_text(program, X_WT)
    finally:
        reaching.stop()
