"""`vrts dispatch export --to linuxcnc`: a verified program as a folder."""

import csv
from pathlib import Path

from tests.support_commands import vrts_text
from tests.support_programs import ROOT
from vrts.dispatch.linuxcnc.export import exported_folder
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.run_files.loading import load_run

STOPS = ROOT / "tests" / "data" / "linuxcnc" / "01-stops" / "program.v2"
MOVE = ".PROGRAM main\nMOVE a\n.END\n.LOCATIONS\na 460 -30 0 90 90 0\n.END\n"


def export(text: str, scene: str, tmp_path: Path) -> list[str]:
    """Return the codes of what is said of a program in a scene."""
    place = tmp_path / "prog.v2"
    place.write_text(text)
    setting = setting_for(place, Where(scene))
    assert setting is not None
    found = exported_folder(Request(ProgramFile(text.encode(), "prog.v2"), setting), None)
    return [d.rule.code for d in found.diagnostics if d.is_error]


def test_a_folder_holds_program_robot_run_and_sheet(tmp_path: Path) -> None:
    folder = tmp_path / "out"
    said = vrts_text("dispatch", "export", STOPS, "--to", "linuxcnc", "-o", folder)
    assert said.returncode == 0, said.stderr
    program = (folder / "program.ngc").read_text()
    assert "  o<v_appro> call [#<start>] [80]\n" in program
    setup = (folder / "library" / "v_setup.ngc").read_text()
    assert "#<_v_a2> = 431.8\n" in setup
    assert "#<_v_a3> = [-20.32]\n" in setup
    hal = (folder / "machine.hal").read_text()
    assert "setp genserkins.A-3 20.32\n" in hal  # Craig's sign
    assert "setp genserkins.D-5 56.25\n" in hal
    ini = (folder / "machine.ini").read_text()
    joint_3 = ini[ini.index("[JOINT_2]") :]
    assert "MIN_LIMIT = -225\nMAX_LIMIT = 45\n" in joint_3  # VAL's -45 to 225, less 180
    assert "HOME = -90\n" in joint_3
    sheet = (folder / "sheet.md").read_text()
    assert "0.01 mm | 0.15 mm" in sheet
    run = load_run((folder / "expected.vrun").read_bytes(), "expected.vrun").run
    assert run is not None
    with (folder / "expected.csv").open() as rows:
        motions = list(csv.DictReader(rows))
    assert len(motions) == len(run.motions) == 9
    assert [row["kind"] for row in motions[:3]] == ["joint", "joint", "linear"]
    # an edited table stays, and counts
    table = folder / "io.toml"
    table.write_text(table.read_text().replace("open = 0", "open = 7"))
    assert vrts_text("dispatch", "export", STOPS, "--to", "linuxcnc", "-o", folder).returncode == 0
    assert "open = 7" in table.read_text()
    assert "#<_v_open_output> = 7\n" in (folder / "library" / "v_setup.ngc").read_text()
    assert "motion.digital-out-07" in (folder / "machine.hal").read_text()


def test_what_is_not_verified_or_has_another_robot_is_refused(tmp_path: Path) -> None:
    assert export(MOVE.replace("460", "4600"), "one-can-puma560", tmp_path)[-1] == "V862"
    assert export(MOVE, "one-can-ur5", tmp_path)[-1] == "V872"
    assert export(MOVE, "one-can-puma560", tmp_path) == []
    gone = MOVE.replace("MOVE a", "MOVE a\nREACT 1001, main")
    assert export(gone, "one-can-puma560", tmp_path)[-1] in ("V870", "V862")
