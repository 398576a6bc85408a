"""From an empty folder to marks, by the commands that a teacher and a student type."""

import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.laws import first
from tests.places import ROOT
from tests.support_commands import vrts_text
from tests.support_goals import SCENE_TEXT
from vrts.cli.shared.watching import LOOK_EVERY_S, watch

UNCOMMENTED = re.compile(r"^# (\[\[?[a-z.0-9]+\]\]?$|[a-z_]+ = (?!\"lab).*$)", re.MULTILINE)
MESH = re.compile(r"^# \[objects\.bracket\]\n(?:# .*\n)+", re.MULTILINE)  # wants a file of a mesh
SECRET = '\n[[via]]\nname = "high above"\nat_mm = [900, 0, 317]\nradius_mm = 291\n'


def vrts(*words: str | Path, cwd: Path) -> "subprocess.CompletedProcess[str]":
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "NO_COLOR": "1"}
    return vrts_text(*words, cwd=cwd, env=environment)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the task `lab`, made by `vrts new task`, with a hidden via point."""
    home = tmp_path_factory.mktemp("teacher")
    result = vrts("new", "task", "lab", "--title", "First lab", cwd=home)
    assert result.returncode == 0, result.stderr
    with (home / "lab" / "staff" / "task.toml").open("a") as file:
        file.write(SECRET)
    result = vrts("task", "pack", "lab", cwd=home)
    assert result.returncode == 0, result.stderr
    assert "students are told of 1 hidden check\n" in result.stdout
    return home


@pytest.fixture
def lab(made: Path, tmp_path: Path) -> Path:
    """Return a copy that a test may change."""
    return Path(shutil.copytree(made / "lab", tmp_path / "lab"))


@pytest.mark.thorough
@pytest.mark.parametrize(
    "origin",
    first(
        2,
        [
            (),
            ("--from", "one-can-ur5"),
            ("--from", "cans-on-bases"),
            ("--from", "02-dish-on-stand"),
        ],
    ),
)
def test_what_is_new_passes_its_own_checks(origin: tuple[str, ...], tmp_path: Path) -> None:
    assert vrts("new", "scene", "cell", *origin, cwd=tmp_path).returncode == 0
    seen = vrts("scene", "check", "cell", cwd=tmp_path)
    assert (seen.returncode, seen.stderr) == (0, "")
    assert vrts("new", "program", "first", *origin, cwd=tmp_path).returncode == 0
    scene = origin[1].removeprefix("02-") if origin else "cans-on-bases"
    program = vrts("verify", "first.v2", "--scene", scene, cwd=tmp_path)
    assert program.returncode == 0, program.stdout
    assert vrts("new", "task", "lab", *origin, cwd=tmp_path).returncode == 0
    task = vrts("task", "check", "lab", cwd=tmp_path)
    assert (task.returncode, task.stderr) == (0, "")
    assert "  reference      10.0 of 10\n  empty program   0.0 of 10\n" in task.stdout


@pytest.mark.thorough
def test_a_task_can_be_made_of_a_scene_that_is_there(tmp_path: Path) -> None:
    assert vrts("new", "scene", "lab", cwd=tmp_path).returncode == 0
    scene = (tmp_path / "lab" / "scene.toml").read_bytes()
    assert vrts("new", "task", "lab", cwd=tmp_path).returncode == 0
    assert (tmp_path / "lab" / "scene.toml").read_bytes() == scene
    assert vrts("task", "check", "lab", cwd=tmp_path).returncode == 0


@pytest.mark.thorough
@pytest.mark.parametrize("origin", first(1, [(), ("--from", "one-can-ur5")]))
def test_everything_that_new_files_have_as_comments_passes_too(
    origin: tuple[str, ...], tmp_path: Path
) -> None:
    """Without the `#`: objects of the scene, sections of the task, the hidden via point."""
    assert vrts("new", "task", "lab", *origin, cwd=tmp_path).returncode == 0
    for file in ("scene.toml", "task.toml", "staff/task.toml"):
        path = tmp_path / "lab" / file
        text = path.read_text()
        if origin and file == "scene.toml":
            continue
        path.write_text(UNCOMMENTED.sub(r"\1", MESH.sub("", text)))
        assert path.read_text() != text
    result = vrts("task", "check", "lab", "--write", cwd=tmp_path)  # README.md follows
    assert (result.returncode, result.stderr) == (0, f"wrote {Path('lab', 'README.md')}\n")
    for word in ("over the middle", "beside the table", "can1 upright", "tool speed", "MOVES"):
        assert word in result.stdout, result.stdout
    assert "  hidden checks   1\n" in result.stdout
    assert vrts("scene", "check", "lab", cwd=tmp_path).returncode == 0


def test_a_task_from_an_example_is_that_of_the_example(tmp_path: Path) -> None:
    words = ("--from", "03-around-obstacles", "--title", 'Round "it"')
    assert vrts("new", "task", "lab", *words, cwd=tmp_path).returncode == 0
    result = vrts("task", "check", "lab", cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert result.stdout.startswith('Round "it": ready to be handed out\n  reference      10.0')
    readme = (tmp_path / "lab" / "README.md").read_text()
    assert readme.startswith('# Round "it"\n')
    assert "passed by the point between the pads within 10 mm" in readme
    assert (tmp_path / "lab" / "scene.toml").is_file()


@pytest.mark.thorough
def test_odd_names_and_titles_do_no_harm(tmp_path: Path) -> None:
    title = 'A "can"\\n{x}\n[task]'
    made = vrts("new", "task", "Übung (1)", "--title", title, cwd=tmp_path)
    assert made.returncode == 0, made.stderr
    packed = vrts("task", "pack", "Übung (1)", cwd=tmp_path)
    assert packed.returncode == 0, packed.stderr
    words = ("Übung-1-student.zip", "Übung (1)/staff/solution.v2")
    marked = vrts("grade", *words, cwd=tmp_path)
    assert marked.stdout.startswith("10.0  solution.v2"), marked.stderr


@pytest.mark.parametrize("words", [("scene", "lab"), ("task", "lab"), ("program", "lab/start.v2")])
def test_nothing_is_overwritten(words: tuple[str, str], lab: Path) -> None:
    before = {path: path.read_bytes() for path in lab.rglob("*") if path.is_file()}
    result = vrts("new", *words, cwd=lab.parent)
    assert result.returncode == 2
    assert "is there already" in result.stderr
    assert {path: path.read_bytes() for path in lab.rglob("*") if path.is_file()} == before


def test_a_reference_below_ten_is_not_packed(lab: Path) -> None:
    solution = lab / "staff" / "solution.v2"
    solution.write_text(solution.read_text().replace("MOVES start", "MOVE safe"))
    result = vrts("task", "check", "lab", cwd=lab.parent)
    assert result.returncode == 1
    assert "V674" in result.stderr
    assert vrts("task", "pack", "lab", cwd=lab.parent).returncode == 1
    assert sorted(path.name for path in lab.parent.iterdir()) == ["lab"]


def test_times_are_proposed_from_the_reference_also_when_it_is_too_slow(lab: Path) -> None:
    task = lab / "task.toml"
    lines = [
        "reference_s = 2" if line.startswith("reference_s") else line
        for line in task.read_text().splitlines()
    ]
    task.write_text("\n".join(lines) + "\n")
    result = vrts("task", "check", "lab", cwd=lab.parent)
    assert result.returncode == 1
    assert "V674" in result.stderr
    assert "  reference_s      -     6.90\n" in result.stdout
    assert "  t_par_s       2.50     8.70\n" in result.stdout


def test_points_for_nothing_are_an_error(lab: Path) -> None:
    task = lab / "task.toml"
    text = task.read_text().replace('on = "base1"', 'on = "table"\nat_mm = [850, -300]')
    task.write_text(text)
    result = vrts("task", "check", "lab", cwd=lab.parent)
    assert result.returncode == 1
    assert "V675" in result.stderr
    assert "`can1` is at its goal from the start" in result.stderr


def test_a_task_without_reference_says_where_to_write_one(lab: Path) -> None:
    (lab / "staff" / "solution.v2").unlink()
    result = vrts("task", "check", "lab", cwd=lab.parent)
    assert result.returncode == 1
    assert "V676" in result.stderr
    assert "`staff/solution.v2`" in result.stderr


@pytest.mark.thorough
def test_a_student_is_told_how_many_checks_are_left(made: Path, tmp_path: Path) -> None:
    shutil.copy(made / "lab-student.zip", tmp_path)
    shutil.copy(made / "lab" / "staff" / "solution.v2", tmp_path / "mine.v2")
    marked = vrts("grade", "lab-student.zip", "mine.v2", cwd=tmp_path)
    assert marked.returncode == 0
    assert "all public checks passed; 1 more at marking\n" in marked.stdout
    verified = vrts("verify", "mine.v2", "--task", "lab-student.zip", cwd=tmp_path)
    assert verified.returncode == 0
    assert verified.stdout.endswith("\nall public checks passed; 1 more at marking\n")
    (tmp_path / "mine.v2").write_text(".PROGRAM main()\n.END\n")
    poor = vrts("grade", "lab-student.zip", "mine.v2", cwd=tmp_path)
    assert "not all public checks passed; 1 more at marking\n" in poor.stdout


@pytest.mark.thorough
@pytest.mark.parametrize("task", first(1, ["lab", "lab-staff.zip"]))
def test_marking_counts_hidden_checks_and_students_read_nothing_of_them(
    task: str, made: Path, tmp_path: Path
) -> None:
    solution = (made / "lab" / "staff" / "solution.v2").read_text()
    (tmp_path / "good.v2").write_text(solution)
    (tmp_path / "low.v2").write_text(solution.replace("MOVE safe", "BREAK"))
    out = tmp_path / "out"
    words = ("good.v2", "low.v2", "--recordings", "-o", "out")
    result = vrts("grade", made / task, *words, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    marks = json.loads((out / "staff" / "results.json").read_text())
    assert [row["final"] for row in marks["rows"]] == [10.0, 6.0]
    whole = (out / "staff" / "students" / "good" / "result.json").read_text()
    assert "high above" in whole
    public = json.loads((out / "students" / "low" / "result.json").read_text())
    assert public["mark"] == 10.0
    files = [path for path in (out / "students").rglob("*") if path.is_file()]
    assert len(files) == 8
    told = [path for path in files if b"high above" in path.read_bytes()]
    assert told == []


@pytest.mark.thorough
def test_no_student_artefact_holds_a_value_of_the_staff(made: Path, tmp_path: Path) -> None:
    """The zip, unpacked; and whatever the commands of a student print and write."""
    with zipfile.ZipFile(made / "lab-student.zip") as archive:
        archive.extractall(tmp_path)
    (tmp_path / "mine.v2").write_bytes((tmp_path / "lab" / "start.v2").read_bytes())
    printed = ""
    for words in (
        ("grade", "lab", "mine.v2", "-o", "out"),
        ("grade", made / "lab-student.zip", "mine.v2", "--format", "json"),
        ("verify", "mine.v2", "--task", "lab", "--html", "page.html", "--record", "run.rrd"),
        ("verify", "mine.v2", "--task", "lab", "--format", "json"),
        ("scene", "check", "lab"),
        ("scene", "show", "lab"),
    ):
        result = vrts(*words, cwd=tmp_path)
        assert result.returncode in (0, 1), result.stderr
        printed += result.stdout + result.stderr
    texts = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    assert len(texts) > 8
    for value in ("high above", "reference solution", "carry(start, goal)"):
        assert value not in printed
        assert [path for path, data in texts.items() if value.encode() in data] == []
    for number in ("317", "291"):
        small = [d for path, d in texts.items() if path.suffix in (".toml", ".v2", ".md")]
        assert all(number.encode() not in data for data in small)


@pytest.mark.thorough
def test_a_modified_scene_is_stamped_on_every_result(made: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(made / "lab-student.zip") as archive:
        archive.extractall(tmp_path)
    scene = tmp_path / "lab" / "scene.toml"
    scene.write_text(
        scene.read_text().replace("size_mm = [120, 120, 100]", "size_mm = [90, 90, 90]")
    )
    program = made / "lab" / "staff" / "solution.v2"
    stamp = "modified scene: this mark does not count"
    marked = vrts("grade", "lab", program, "-o", "out", cwd=tmp_path)
    assert stamp in marked.stderr
    assert stamp in (tmp_path / "out" / "students" / "solution" / "report.html").read_text()
    assert stamp in vrts("verify", program, "--task", "lab", cwd=tmp_path).stdout
    as_json = vrts("verify", program, "--task", "lab", "--format", "json", cwd=tmp_path)
    assert stamp in as_json.stdout


@pytest.mark.thorough
def test_scene_check_tells_what_the_reader_refuses_and_what_it_lets_pass(tmp_path: Path) -> None:
    assert vrts("new", "scene", "cell", cwd=tmp_path).returncode == 0
    scene = tmp_path / "cell" / "scene.toml"
    good = scene.read_text()
    for change, code, status in (
        (("radius_mm = 30", "radius_mm = 50"), "V615", 0),
        (("at_mm = [850, -300]", "at_mm = [850, -300]\nturn_deg = 5"), "nothing", 0),
        (('at_mm = [850, -300]\non = "table"', 'at_mm = [2850, -300]\non = "floor"'), "V791", 1),
        (("radius_mm = 30", "radius_mm = 50"), "make it narrower", 0),
        (("height_mm = 115", "height_mm = 15"), "V618", 0),
        (("at_mm = [850, -300]", "at_mm = [950, 300]"), "V613", 1),
        (('on = "table"\nradius', 'on = "floor"\nradius'), "V618", 0),
        (('at_mm = [850, -300]\non = "table"', "at_mm = [850, -300, 0]"), "V614", 1),
        (("# [locations]\n# shelf = [900,", "[locations]\nshelf = [1900,"), "V619", 0),
        (
            ("# [locations]\n# shelf = [900, 0, 130", "[locations]\nshelf = [900, 0, -310"),
            "V666",
            0,
        ),
    ):
        assert change[0] in good
        scene.write_text(good.replace(*change))
        result = vrts("scene", "check", "cell", cwd=tmp_path)
        assert code in (result.stderr or result.stdout)
        assert result.returncode == status, (code, result.stderr)


def steps(*states: dict[str, bytes]) -> tuple[Callable[[Path], bytes | None], list[float]]:
    """Return files that are in one state after the other, and the times slept."""
    slept: list[float] = []

    def seen(path: Path) -> bytes | None:
        return states[min(len(slept), len(states) - 1)].get(path.name)

    return seen, slept


def test_a_watched_file_is_drawn_once_and_after_every_change() -> None:
    a, b = {"scene.toml": b"a"}, {"scene.toml": b"b"}
    seen, slept = steps(a, a, b, b, {}, b, a)  # {}: an editor has it moved away for a moment
    drawn: list[int] = []
    count = watch(
        [Path("scene.toml")],
        lambda: drawn.append(len(slept)),
        clock=lambda: sum(slept),
        sleep=slept.append,
        until=6.5 * LOOK_EVERY_S,
        seen=seen,
    )
    assert drawn == [0, 2, 6]
    assert count == 3


def test_watching_draws_the_map_and_goes_on_after_a_mistake(tmp_path: Path) -> None:
    assert vrts("new", "scene", "cell", cwd=tmp_path).returncode == 0
    result = vrts("scene", "watch", "cell", "--svg", "map.svg", "--for", "0.1", cwd=tmp_path)
    assert result.returncode == 0
    assert "can1_grip" in result.stdout
    assert (tmp_path / "map.svg").read_text().startswith("<svg")
    (tmp_path / "cell" / "scene.toml").write_text("title = \n")
    broken = vrts("scene", "watch", "cell", "--for", "0.1", cwd=tmp_path)
    assert broken.returncode == 0
    assert "V600" in broken.stderr


@pytest.mark.thorough
def test_a_new_lab_changes_nothing_until_it_is_filled_in(tmp_path: Path) -> None:
    plain = vrts("scene", "show", "cans-on-bases", cwd=tmp_path).stdout.splitlines()
    assert vrts("new", "lab", "room", cwd=tmp_path).returncode == 0
    assert vrts("new", "lab", "room", cwd=tmp_path).returncode == 2, "nothing is overwritten"
    lab = tmp_path / "room.toml"
    same = vrts("scene", "show", "cans-on-bases", "--lab", lab, cwd=tmp_path).stdout.splitlines()
    assert same[1:] == plain[1:]
    assert "in Our laboratory" in same[0]
    lab.write_text(lab.read_text().replace("# top_z_mm = -300", "top_z_mm = -290"))
    program = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"
    example = program.parent
    lone = tmp_path / "lone.v2"
    lone.write_bytes(program.read_bytes())
    for words, status, answer in (
        (("scene", "show", "cans-on-bases"), 0, "top at Z -290"),
        (("scene", "check", example), 0, "2 goals: nothing found"),
        (("point", "cans-on-bases", "800", "-450", "-225", "--down"), 0, "reach"),
        (("task", "check", example), 0, "ready to be handed out"),
        (("verify", program), 0, "modified scene: this mark does not count"),
        (("grade", example, program), 0, "modified scene: this mark does not count"),
        (("run", program, "--scene", "cans-on-bases", "--save", "in.vrun"), 0, "in place"),
        (("run", program), 0, "as the task beside the program has it"),
        (("run", lone), 2, "give `--scene NAME`"),
        (("scene", "watch", "cans-on-bases", "--for", "0"), 0, "top at Z -290"),
    ):
        result = vrts(*words, "--lab", lab, cwd=tmp_path)
        assert result.returncode == status, (words, result.stdout, result.stderr)
        assert answer in result.stdout + result.stderr, words
    lab.unlink()
    again = vrts("run", "in.vrun", "--check", cwd=tmp_path)
    assert "everything is the same" in again.stdout + again.stderr, "a run keeps its lab"
    missing = vrts("scene", "show", "cans-on-bases", "--lab", lab, cwd=tmp_path)
    assert missing.returncode == 2
    assert "room.toml" in missing.stderr


def students_files(home: Path, hidden: str, scene: tuple[str, str]) -> dict[str, bytes]:
    """Return every byte that students get of a task with a hidden part and a hidden scene."""
    assert vrts("new", "task", "lab", "--title", "Lab", cwd=home).returncode == 0
    staff = home / "lab" / "staff"
    (staff / "task.toml").write_text(hidden)
    (staff / "scenes").mkdir()
    text = (home / "lab" / "scene.toml").read_text()
    (staff / "scenes" / "moved.toml").write_text(text.replace(*scene))
    assert vrts("task", "pack", "lab", cwd=home).returncode == 0
    (home / "mine.v2").write_bytes((home / "lab" / "start.v2").read_bytes())
    marked = vrts("grade", "lab-staff.zip", "mine.v2", "-o", "out", "--recordings", cwd=home)
    assert marked.returncode == 0, marked.stderr
    student = home / "student"
    student.mkdir()
    shutil.copy(home / "lab-student.zip", student)
    shutil.copy(home / "mine.v2", student)
    words = ("verify", "mine.v2", "--task", "lab-student.zip", "--html", "p.html")
    verified = vrts(*words, "--record", "r.rrd", cwd=student)
    graded = vrts("grade", "lab-student.zip", "mine.v2", "--format", "json", cwd=student)
    (student / "printed").write_text(verified.stdout + verified.stderr + graded.stdout)
    files = [*student.iterdir(), *(home / "out" / "students").rglob("*")]
    return {
        path.name: recorded(path) if path.suffix == ".rrd" else path.read_bytes()
        for path in files
        if path.is_file()
    }


def recorded(path: Path) -> bytes:
    """Return what a recording holds; its own bytes are packed, and others every time."""
    rerun = Path(sys.executable).parent / "rerun"
    words = [rerun, "rrd", "print", "-vvv", path]
    return subprocess.run(words, capture_output=True, check=True).stdout


@pytest.mark.thorough
def test_what_students_get_is_the_same_whatever_the_staff_hides(tmp_path: Path) -> None:
    """Byte by byte, also inside files that are packed: so nothing can be read out of them."""
    found: list[dict[str, bytes]] = []
    for name, hidden, moved in (
        ("first", SECRET, "[855, -300]"),
        ("second", '\n[[rule]]\nmust_use = "MOVES"\n', "[846, -300]"),
    ):
        home = tmp_path / name
        home.mkdir()
        found.append(students_files(home, hidden, ("[850, -300]", moved)))
    first, second = found
    wanted = {"lab-student.zip", "mine.v2", "p.html", "r.rrd", "printed"}
    for files in (first, second):  # this alone has the final mark, which hidden checks are part of
        assert files.pop("feedback.txt").startswith(b"Lab\nFinal mark: ")
    assert wanted | {"report.html", "result.json", "run.rrd"} == first.keys()
    assert b"2 more at marking" in first["printed"]
    for name in first:
        assert b"high above" not in first[name], name
        if not name.endswith(".rrd"):
            assert first[name] == second[name], name
    assert b"can1" in first["r.rrd"]
    assert b"can1" in first["run.rrd"]


def test_a_point_that_nobody_can_move_to_is_not_saved(tmp_path: Path) -> None:
    far = vrts(
        *("point", "cans-on-bases", "1700", "0", "0", "--down", "--save", "p", "p.v2"), cwd=tmp_path
    )
    assert far.returncode == 1
    assert "`p` is not saved" in far.stderr
    assert not (tmp_path / "p.v2").exists()
    behind = vrts("point", "cans-on-bases", "-691", "49", "-205", "-90", "90", "0", cwd=tmp_path)
    assert behind.returncode == 0
    assert "tried: MOVE gets there only after RIGHTY" in behind.stdout


@pytest.mark.thorough
def test_a_scene_is_shown_with_what_was_tried_in_its_task(tmp_path: Path) -> None:
    folder = tmp_path / "bricks"
    folder.mkdir()
    (folder / "scene.toml").write_text(SCENE_TEXT)
    task = '[task]\nscene = "scene.toml"\n[[goal]]\nobject = "brick"\non = "base1"\nturn_deg = 90\n'
    (folder / "task.toml").write_text(task + "[time]\nreference_s = 9\n")
    for words in (("show", "bricks"), ("watch", "bricks", "--for", "0.1")):
        shown = vrts("scene", *words, cwd=tmp_path).stdout
        assert "brick_grip, brick_put: brick on base1" in shown
        assert "Not shown: base1_put1, with which `brick` is turned 90 degrees" in shown
        assert "base1_put1  " not in shown
    assert vrts("new", "program", "mine.v2", "--from", "bricks", cwd=tmp_path).returncode == 0
    assert "brick_put" in (tmp_path / "mine.v2").read_text()


@pytest.mark.thorough
def test_a_new_task_of_a_turned_brick_is_ready(tmp_path: Path) -> None:
    folder = tmp_path / "bricks"
    folder.mkdir()
    size = "size_mm = [70, 40, 80]"
    (folder / "scene.toml").write_text(SCENE_TEXT.replace(size, f"{size}\nturn_deg = 30"))
    assert vrts("new", "task", "bricks", cwd=tmp_path).returncode == 0
    assert "turn_deg = 30" in (folder / "task.toml").read_text()
    checked = vrts("task", "check", "bricks", cwd=tmp_path)
    assert checked.returncode == 0, checked.stderr
    assert "ready to be handed out" in checked.stdout
