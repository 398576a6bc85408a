"""Lessons: what comes with vrts, copies that overwrite nothing, steps that look at files."""

import re
import shutil
import subprocess
from fractions import Fraction
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text
from vrts.base.source import SourceFile
from vrts.learn.lesson import DONE, AssignmentWish, LogWish, MarkedWish, ProgramWish
from vrts.learn.lesson_file import load_lesson, read_lesson
from vrts.learn.library import Bundled, bundled, copy_lesson, find_lesson
from vrts.learn.looking import LARGEST_RESULTS, Looking
from vrts.learn.progress import progress
from vrts.learn.told import progress_text
from vrts.marking.layout import Layout
from vrts.marking.row import Class, class_to_bytes
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
PLACES = EXAMPLE / "solution.v2"
HEAD = '[lesson]\nnumber = 9\ntitle = "T"\nabout = "A."\n'
STEP = '[[step]]\ntitle = "S"\nminutes = 3\ndoes = "D."\n'


def lesson_of(steps: str) -> object:
    return read_lesson(SourceFile("lesson.toml", HEAD + steps))


def test_the_six_lessons_are_bundled_in_their_order_with_steps_of_minutes() -> None:
    lessons = [one.lesson for one in bundled()]
    assert [lesson.number for lesson in lessons] == [1, 2, 3, 4, 5, 7]  # example 6 is a notebook
    for one in bundled():
        assert one.lesson.about
        assert len(one.lesson.steps) >= 3
        readme = (one.folder / "README.md").read_text("utf-8")
        headings = re.findall(r"^## (.*)$", readme, re.M)
        for step in one.lesson.steps:
            if isinstance(step.wish, ProgramWish) and step.wish.finds is not None:
                assert (ROOT / "vrts" / "pages" / f"{step.wish.finds}.md").is_file()
            assert step.tries, step.title
            assert all(command.split()[0] in {"vrts", "cp"} for command in step.tries)
            assert step.part in headings or re.fullmatch(r"\d (?:to|and) \d", step.part), step.part


def test_the_page_of_the_lessons_lists_them_with_their_numbers_and_minutes() -> None:
    page = (ROOT / "vrts" / "manual" / "learn" / "lessons.md").read_text("utf-8")
    rows = re.findall(r"^\| (\d+) ([^|]+) \| [^|]+ \| (\d+) \|$", page, re.M)
    lessons = [one.lesson for one in bundled()]
    assert rows == [(str(one.number), one.title, str(one.minutes)) for one in lessons]
    assert len(rows) == 6
    assert "Six lessons come with vrts." in page


def test_steps_of_the_first_lesson_are_short() -> None:
    first = bundled()[0].lesson
    assert max(step.minutes for step in first.steps) <= 6


@pytest.mark.parametrize("number", [1, 2, 3, 4, 5, 7])
def test_nothing_is_done_in_a_fresh_copy_and_links_lead_into_it(
    number: int, tmp_path: Path
) -> None:
    found = find_lesson(str(number))
    copy_lesson(found, tmp_path / "mine")
    here = progress(load_lesson(tmp_path / "mine"), tmp_path / "mine")
    assert not any(here.done)
    text = (tmp_path / "mine" / "README.md").read_text("utf-8")
    for link in re.findall(r"\]\(([^)#:]+)\)", text):
        assert (tmp_path / "mine" / link).exists(), link


def test_a_lesson_is_copied_whole_and_never_over_anything(tmp_path: Path) -> None:
    said = vrts_text("learn", "1", cwd=tmp_path)
    assert said.returncode == 0
    assert said.stdout == "cd 01-cans-on-bases\nvrts learn next\n"
    mine = tmp_path / "01-cans-on-bases"
    assert (mine / "submissions" / "hits-base.v2").is_file()
    (mine / "README.md").write_text("mine")
    again = vrts_text("learn", "1", cwd=tmp_path)
    assert again.returncode == 2
    assert "is there already, and nothing is overwritten" in again.stderr
    assert (mine / "README.md").read_text() == "mine"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["01-cans-on-bases"]
    assert vrts_text("learn", "1", "-o", "a/b", cwd=tmp_path).returncode == 0
    assert (tmp_path / "a" / "b" / "lesson.toml").is_file()
    with pytest.raises(CannotRead, match="is there already"):
        copy_lesson(find_lesson("1"), tmp_path / "a")


def a_clone(tmp_path: Path) -> Bundled:
    """Return a lesson in a folder that a test may write into."""
    found = find_lesson("1")
    folder = tmp_path / "clone" / found.folder.name
    for pattern in ("*", "pictures/*", "submissions/*.v2"):
        for path in found.folder.glob(pattern):
            if path.is_file():
                copy = folder / path.relative_to(found.folder)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, copy)
    return Bundled(load_lesson(folder), folder)


def names(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_what_somebody_has_made_in_the_folder_of_a_lesson_is_not_copied(tmp_path: Path) -> None:
    clone = a_clone(tmp_path)
    belongs = names(clone.folder) - {"expected.json"}
    for made in ("mine.v2", "mine.log", "out/staff/results.json", "submissions/lesson1/mine.v2"):
        (clone.folder / made).parent.mkdir(parents=True, exist_ok=True)
        (clone.folder / made).write_text("")
    copy_lesson(clone, tmp_path / "copy")
    assert names(tmp_path / "copy") == belongs


@pytest.mark.parametrize("number", [1, 2, 3, 4, 5, 7])
def test_all_that_belongs_to_a_lesson_is_copied(number: int, tmp_path: Path) -> None:
    found = find_lesson(str(number))
    asked = subprocess.run(
        ["git", "ls-files"], capture_output=True, text=True, check=False, cwd=found.folder
    )
    if asked.returncode != 0 or not asked.stdout:
        pytest.skip("this folder is no checkout")
    copy_lesson(found, tmp_path / "copy")
    assert names(tmp_path / "copy") == set(asked.stdout.splitlines()) - {"expected.json"}


@pytest.mark.parametrize("where", ["01-cans-on-bases", "submissions/01-cans-on-bases"])
def test_a_lesson_is_not_copied_into_itself(where: str, tmp_path: Path) -> None:
    clone = a_clone(tmp_path)
    before = names(clone.folder)
    (tmp_path / "link").symlink_to(clone.folder)
    for target in (clone.folder / where, tmp_path / "link" / where):
        with pytest.raises(CannotRead, match="is inside the lesson itself"):
            copy_lesson(clone, target)
    assert names(clone.folder) == before


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("learn", "99"), "there is no lesson `99`"),
        (("learn", "next"), "this folder holds no lesson"),
        (("learn", "-o", "x"), "nothing says which lesson to copy"),
        (("learn", "next", "-o", "x"), "`-o` belongs to a copy"),
    ],
)
def test_wrong_calls_are_told(words: tuple[str, ...], says: str, tmp_path: Path) -> None:
    said = vrts_text(*words, cwd=tmp_path)
    assert said.returncode == 2
    assert says in said.stderr
    assert list(tmp_path.iterdir()) == []


MINE = {step.title for step in find_lesson("1").lesson.steps[2:8]}  # about mine.v2


def program(steps: str) -> str:
    text = PLACES.read_text("utf-8")
    return f".PROGRAM main()\n{steps}.END\n" + text[text.index(".LOCATIONS") :]


GRIPS = "OPENI\nAPPRO can1_grip, 120\nMOVES can1_grip\nCLOSEI\n"


def test_the_next_step_follows_what_the_program_really_does(tmp_path: Path) -> None:
    mine = tmp_path / "lesson"
    copy_lesson(find_lesson("1"), mine)

    def next_after(text: str) -> tuple[str, str]:
        (mine / "mine.v2").write_text(text, "utf-8")
        found = progress(load_lesson(mine), mine)
        steps = [s for s, done in zip(found.lesson.steps, found.done, strict=True) if not done]
        step = next(
            s for s in steps if isinstance(s.wish, ProgramWish) and s.wish.file == "mine.v2"
        )
        return step.title, Looking(mine).at(step.wish).why

    assert next_after(program("APPRO can1_grip 120\n")) == (
        "A program that compiles",
        "line 2: a comma is missing before `120`",
    )
    title, why = next_after(program("MOVE safe\n"))
    assert (title, why) == ("Take hold of a can", "the hand never takes hold of `can1`")
    title, why = next_after(program(GRIPS))
    assert title == "One can at its goal"
    low = GRIPS + "DEPARTS 50\nMOVES base2_put\nOPENI\nDEPARTS 120\n"
    title, why = next_after(program(low))
    assert title == "Touch nothing"
    assert why.startswith("line 7: the held `can1` hits `base1`")
    high = GRIPS + "DEPARTS 200\nAPPRO base2_put, 120\nMOVES base2_put\nOPENI\nDEPARTS 120\n"
    title, why = next_after(program(high))
    assert title == "Both cans"


def test_a_full_mark_and_a_mended_program_leave_only_what_has_no_file(tmp_path: Path) -> None:
    mine = tmp_path / "lesson"
    copy_lesson(find_lesson("1"), mine)
    for name in ("first.v2", "mine.v2", "mended.v2"):
        shutil.copy(PLACES, mine / name)
    (mine / "first.v2").write_text(
        PLACES.read_text("utf-8").replace(".LOCATIONS\n", ".LOCATIONS\nown 900 0 0 90 90 0\n")
    )
    found = progress(load_lesson(mine), mine)
    assert found.step is not None
    assert (sum(found.done), found.step.title) == (9, "Mark a class")
    text = progress_text(found)
    assert "next: Mark a class (2 min; read README.md, Exercises)\n" in text
    assert "not yet: there is no folder of marks `out` yet" in text
    said = vrts_text("learn", "next", cwd=mine)
    assert (said.returncode, said.stdout) == (1, text + "\n")


def test_a_place_that_the_arm_cannot_reach_is_no_place_of_your_own(tmp_path: Path) -> None:
    copy_lesson(find_lesson("1"), tmp_path / "lesson")
    text = program("").replace(".LOCATIONS\n", ".LOCATIONS\nfar 3000 0 0 90 90 0\n")
    (tmp_path / "lesson" / "first.v2").write_text(text, "utf-8")
    found = progress(load_lesson(tmp_path / "lesson"), tmp_path / "lesson")
    assert found.answer.why == "the arm cannot reach `far`"


OUT = "`scene` leads out of the lesson's folder"


@pytest.mark.parametrize(
    ("steps", "says"),
    [
        (STEP, "a step has one of"),
        (STEP + '[step.program]\nfile = "a.v2"\n[step.marked]\nfolder = "o"\n', "a step has one"),
        (STEP + '[step.program]\nfile = "../a.v2"\n', "`file` leads out of the lesson's folder"),
        (STEP + '[step.program]\nfile = "/etc/passwd"\n', "`file` leads out"),
        (STEP + '[step.program]\nfile = "a.v2"\nmrak = 3\n', "mrak"),
        (STEP + '[step.program]\nfile = "a.v2"\nscene = "../../x/scene.toml"\n', OUT),
        (STEP + '[step.program]\nfile = "a.v2"\nscene = "/x/scene.toml"\n', OUT),
        (STEP + '[step.program]\nfile = "a.v2"\nscene = "-"\n', OUT),
        (STEP + '[step.log]\nprogram = "a.v2"\nlog = "a.csv"\nscene = "../scene.toml"\n', OUT),
        ('files = ["../x"]\n' + STEP + '[step.program]\nfile = "a.v2"\n', "`files` leads out"),
        ((STEP + '[step.program]\nfile = "a.v2"\n') * 41, "at most 40 steps"),
        ("", "step"),
    ],
)
def test_a_wrong_lesson_is_told_where(steps: str, says: str) -> None:
    with pytest.raises(Refused) as refused:
        lesson_of(steps)
    assert says in " ".join(d.headline for d in refused.value.diagnostics)
    assert all(d.primary is not None for d in refused.value.diagnostics)


def test_a_link_out_of_the_folder_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "lesson").mkdir()
    (tmp_path / "secret.v2").write_text(program(""))
    (tmp_path / "lesson" / "mine.v2").symlink_to(tmp_path / "secret.v2")
    answer = Looking(tmp_path / "lesson").at(ProgramWish("mine.v2", scene="cans-on-bases"))
    assert not answer.done
    assert answer.why == "`mine.v2` leads out of the lesson's folder"


@pytest.mark.parametrize("scene", ["cell", "cell/scene.toml", "programs/cell"])
def test_a_scene_behind_a_link_out_of_the_folder_is_not_read(scene: str, tmp_path: Path) -> None:
    lesson = tmp_path / "lesson"
    (lesson / "programs").mkdir(parents=True)
    shutil.copytree(ROOT / "scenes" / "cans-on-bases", tmp_path / "cell")
    (lesson / "programs" / "mine.v2").write_text(program(""))
    for name in ("cell", "programs/cell"):
        (lesson / name).symlink_to(tmp_path / "cell")
    for wish in (
        ProgramWish("programs/mine.v2", scene=scene),
        ProgramWish("programs/mine.v2", scene="cell"),
        LogWish("programs/mine.v2", "programs/mine.v2", scene=scene),
    ):
        answer = Looking(lesson).at(wish)
        assert not answer.done
        assert answer.why.endswith("leads out of the lesson's folder")


@pytest.mark.parametrize("scene", ["cans-on-bases", "cell", "cell/scene.toml"])
def test_a_scene_in_the_folder_or_one_of_vrts_is_taken(scene: str, tmp_path: Path) -> None:
    shutil.copytree(ROOT / "scenes" / "cans-on-bases", tmp_path / "cell")
    (tmp_path / "mine.v2").write_text(program(""))
    answer = Looking(tmp_path).at(ProgramWish("mine.v2", scene=scene, teaches=("can1_grip",)))
    assert answer == DONE


def test_marks_behind_a_link_out_of_the_folder_are_not_read(tmp_path: Path) -> None:
    marks = Layout(tmp_path / "lesson" / "out").results
    marks.parent.mkdir(parents=True)
    outside = tmp_path / "results.json"
    outside.write_bytes(class_to_bytes(Class("vrts.class/1", "Group 3", ())))
    marks.symlink_to(outside)
    looking = Looking(tmp_path / "lesson")
    answer = looking.at(MarkedWish("out", rows=0))
    assert answer.why == "`out/staff/results.json` leads out of the lesson's folder"
    marks.unlink()
    outside.rename(marks)
    assert looking.at(MarkedWish("out", rows=0)) == DONE


def test_marks_that_are_too_large_are_not_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    marks = Layout(tmp_path / "out").results
    marks.parent.mkdir(parents=True)
    with marks.open("wb") as file:
        file.truncate(LARGEST_RESULTS + 1)  # a hole: it takes no room
    monkeypatch.delattr("vrts.learn.looking.read_bytes")
    answer = Looking(tmp_path).at(MarkedWish("out", rows=1))
    assert answer.why == "`results.json` is too large"


def test_a_scene_of_an_assignment_behind_a_link_is_not_read(tmp_path: Path) -> None:
    folder = tmp_path / "lesson" / "pallet"
    folder.mkdir(parents=True)
    (folder / "scene.toml").symlink_to(ROOT / "scenes" / "cans-on-bases" / "scene.toml")
    answer = Looking(tmp_path / "lesson").at(AssignmentWish("pallet", task=False))
    assert answer.why == "`pallet/scene.toml` leads out of the lesson's folder"


def test_names_that_lead_to_no_file_are_told_in_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "mine.v2").symlink_to("mine.v2")
    (tmp_path / "lost.v2").symlink_to("gone.v2")
    for name, why in (
        ("mine.v2", "`mine.v2` is a link that leads nowhere"),
        ("lost.v2", "`lost.v2` is a link that leads nowhere"),
        ("a\0.v2", "`a\0.v2` is no name of a file"),
    ):
        assert Looking(tmp_path).at(ProgramWish(name)).why == why
    assert Looking(tmp_path).at(MarkedWish("mine.v2", rows=1)).why == (
        "`mine.v2` is a link that leads nowhere"
    )


def test_an_endless_program_ends_the_look_as_it_ends_verify(tmp_path: Path) -> None:
    copy_lesson(find_lesson("1"), tmp_path / "lesson")
    shutil.copy(EXAMPLE / "submissions" / "endless-loop.v2", tmp_path / "lesson" / "mine.v2")
    wish = ProgramWish("mine.v2", mark=Fraction(10))
    answer = Looking(tmp_path / "lesson").at(wish)
    assert not answer.done
    assert "this loop never ends: it repeats its state" in answer.why
    assert answer.hint == "line 6: nothing in the loop changes `n`"


def test_names_that_steer_a_terminal_are_shown_harmless(tmp_path: Path) -> None:
    (tmp_path / "lesson.toml").write_text(
        HEAD + STEP.replace('"D."', r'"\u001b[31mD."') + '[step.program]\nfile = "a.v2"\n'
    )
    assert "\x1b" not in progress_text(progress(load_lesson(tmp_path), tmp_path))


@pytest.mark.thorough
@pytest.mark.parametrize("number", [2, 3, 4])
def test_our_solutions_pass_every_step_of_their_lessons(number: int, tmp_path: Path) -> None:
    mine = tmp_path / "lesson"
    copy_lesson(find_lesson(str(number)), mine)
    solution = (mine / "solution.v2").read_text("utf-8")
    (mine / "mine.v2").write_text(solution, "utf-8")
    if number == 2:  # the hand stays straight: A is 90 at the stand
        straight = re.sub(r"(?m)^(stand_mid .*) 70\.00 ", r"\1 90.00 ", solution)
        assert straight != solution
        (mine / "straight.v2").write_text(straight, "utf-8")
    found = progress(load_lesson(mine), mine)
    assert found.step is None, (found.step, found.answer)
