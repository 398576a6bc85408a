"""Steps that only V+ has: what is read, what is carried out, what is refused."""

import pytest

from vrts.base.diagnostic import Severity
from vrts.base.source import SourceFile
from vrts.ir import instructions as ir
from vrts.lang.compiler import Compilation, Options, compile_source
from vrts.lang.dialect import VAL2, VPLUS, Dialect


def compiled(step: str, dialect: Dialect = VPLUS) -> Compilation:
    text = f".PROGRAM main(lun, $s, x, a[], #p)\n{step}\n.END\n"
    return compile_source(SourceFile("main.v2", text), Options(dialect))


def codes(step: str, severity: Severity = Severity.ERROR, dialect: Dialect = VPLUS) -> list[str]:
    found = compiled(step, dialect).diagnostics
    return [d.rule.code for d in found if d.severity is severity]


def first(step: str) -> ir.Instruction:
    module = compiled(step).module
    assert module is not None
    return module.programs["main"].instructions[0]


@pytest.mark.parametrize(
    "step",
    [
        "GLINE (lun) 1, 2, 3, 4",
        "GETEVENT (lun) a[]",
        "READ (lun, 1, 2) $s, x, a[3]",
        "FOPENW (lun) $s",
        "SELECT ROBOT = 2",
        "SOLVE.ANGLES a[1], x, x = HERE, a[1], x",
        "VPICTURE (1) -1, 0",
        "VPICTURE",
        "VWINDOWI (1, 2, 3, 4) a[0] = 1, 2, 3, 4, 5, 6",
        "RELEASE -1",
        "EXECUTE 1 main(1, $s, 2, a[], #p), 1",
    ],
)
def test_what_is_never_carried_out_is_read_and_said(step: str) -> None:
    assert codes(step) == []
    assert codes(step, Severity.WARNING) == ["V161"]
    assert isinstance(first(step), ir.Opaque)


@pytest.mark.parametrize(
    ("step", "code"),
    [
        ("GLINE (lun) 1 2, 3, 4", "V131"),  # a comma is missing
        ("GLINE (lun) 1, 2, 3, 4, 5", "V156"),
        ("GLINE (lun, 1) 1, 2, 3, 4", "V156"),
        ("SELECT ROBOT", "V130"),
        ("GCLEAR (lun) = 3", "V125"),
        ('GLINE (lun) 1 + "a", 2, 3, 4', "V202"),
        ("x = GETC(lun, 1, 2)", "V210"),
        ("x = ID()", "V210"),
    ],
)
def test_what_is_never_carried_out_is_still_checked(step: str, code: str) -> None:
    assert codes(step) == [code]


def test_functions_of_devices_take_anything() -> None:
    step = "x = GETC(lun)+GETC(lun, 1)+ID(3, 4)+SELECT(ROBOT, -1)+IOSTAT(lun)+TPS+BSTATUS"
    assert codes(step) == []


def test_a_profile_of_acceleration() -> None:
    assert isinstance(first("ACCEL (2) 80, 90 ALWAYS"), ir.SetAcceleration)
    assert codes("ACCEL (2) 80, 90", Severity.WARNING) == ["V229"]
    assert codes("ACCEL (x+1)*2, 80", Severity.WARNING) == []
    assert codes("ACCEL (2) 80, 90", dialect=VAL2) == ["V122"]


def test_joints_as_a_destination() -> None:
    move = first("JMOVE x, 2, 3, 4, 5, 6")
    assert isinstance(move, ir.Move)
    assert move.interpolation is ir.Interpolation.JOINT
    assert codes("JMOVE 1, 2, 3, 4, 5, 6") == []
    assert codes("JMOVE 1, 2, 3, 4, 5, 6, 7") == ["V156"]
    assert codes("JMOVE here") == ["V202"]


def test_continuous_path_by_an_instruction() -> None:
    assert first("CPON ALWAYS") == first("ENABLE CP")
    assert first("CPOFF ALWAYS") == first("DISABLE CP")
    assert isinstance(first("CPOFF"), ir.Opaque)  # for the next motion only
