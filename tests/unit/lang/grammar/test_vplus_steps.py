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


def test_task_1_is_the_second_program_where_nothing_is_passed_to_it() -> None:
    for step, cycles in (("EXECUTE 1 main()", None), ("EXECUTE 1 main, -1, 2", -1.0)):
        started = first(step)
        assert isinstance(started, ir.StartProcess)
        assert started.program == "main"
        assert (started.cycles is None) == (cycles is None)
        assert "V161" not in codes(step, Severity.WARNING)
    for step in (
        "EXECUTE 2 main()",
        "EXECUTE 1 main(), 1, 1, 30",
        "PRIME 1 main()",
        "EXECUTE main",
    ):
        assert isinstance(first(step), ir.Opaque), step


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


def data(text: str, dialect: Dialect = VPLUS) -> Compilation:
    source = SourceFile("main.v2", f".PROGRAM main\n.END\n.LOCATIONS\n{text}\n.END\n")
    return compile_source(source, Options(dialect))


def test_a_location_of_twelve_numbers_on_two_lines() -> None:
    module = data("a 0 -1 0 -1 0 0\n 0 0 -1 167.5 -243.25 600\nb 1 2 3 0 0 0").module
    assert module is not None
    whole = data("a 0 -1 0 -1 0 0 0 0 -1 167.5 -243.25 600\nb 1 2 3 0 0 0").module
    assert whole is not None
    assert [d.value for d in module.data] == [d.value for d in whole.data]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("0 0 -1 167.5 -243.25 600", "V145"),  # no name before it
        ("a 0 -1 0 -1 0 0\n0 0 -1 167.5 600", "V146"),  # one is missing
        ("a 0 -1 0 -1 0 0\n0 0 -1 167.5 x 600", "V145"),
        ("a 0 -1 0 -1 0 1\n0 0 -1 167.5 1 600", "V163"),  # no rotation
    ],
)
def test_two_lines_that_are_no_location(text: str, code: str) -> None:
    assert [d.rule.code for d in data(text).diagnostics if d.is_error] == [code]


def test_only_vplus_has_two_lines() -> None:
    text = "a 0 -1 0 -1 0 0\n0 0 -1 167.5 -243.25 600"
    assert [d.rule.code for d in data(text, VAL2).diagnostics if d.is_error] == ["V145"]


def test_robots_of_other_numbers_of_axes() -> None:
    four = data("#a 1 2 3 4\n#b 5 6 7 8")
    assert [d.rule.code for d in four.diagnostics] == ["V162", "V162"]
    assert [d.rule.code for d in data("#a 1 2 3 4 5 6 7").diagnostics] == ["V162"]
    torn = data("#a 1 2 3 4 5 6\n#b 5 6 7 8 9\n#c 1 2 3 4 5 6")
    assert [d.rule.code for d in torn.diagnostics if d.is_error] == ["V146"]


def test_belts() -> None:
    steps = (
        "DEFBELT %b = HERE, 1\nSETBELT %b = x\nMOVES %b:HERE\nx = BELT(%b)+WINDOW(%b:HERE, 1, 2)"
    )
    assert codes(steps) == []
    assert codes("x = x %b") == ["V107"]
    assert codes("MOVE %b:HERE", dialect=VAL2) == ["V107"]


@pytest.mark.parametrize(
    ("step", "code"),
    [
        ("MOVE BREAK", "V160"),
        ("CALL SIGNAL()", "V160"),
        ("EXECUTE END main()", "V160"),
        ("AUTO b:c", "V202"),
        ("EXECUTE 1 main 2", "V131"),
        ("SET = NULL", "V124"),
        ("IF x\nEND", "V130"),
        ('$s = $ENCODE(x, , "a")', "V210"),
    ],
)
def test_words_of_the_language_are_no_names(step: str, code: str) -> None:
    assert code in codes(step)


def test_a_variable_that_is_declared_may_have_the_name_of_an_instruction() -> None:
    assert codes("LOCAL stop\nREAD (lun) stop\nIF stop THEN\nEND") == []
    assert codes("delay = 3\nDELAY delay") == []
