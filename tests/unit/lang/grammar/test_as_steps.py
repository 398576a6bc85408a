"""Steps that only AS has: which forms are read, and what is no such form."""

import pytest

from vrts.base.diagnostic import Severity
from vrts.base.source import SourceFile
from vrts.lang.compiler import Compilation, Options, compile_source
from vrts.lang.dialect import AS


def compiled(step: str) -> Compilation:
    text = f".PROGRAM main(.n, .$s, .&p)\n{step}\n.END\n"
    return compile_source(SourceFile("main.as", text), Options(AS))


def codes(step: str, severity: Severity = Severity.ERROR) -> list[str]:
    return [d.rule.code for d in compiled(step).diagnostics if d.severity is severity]


@pytest.mark.parametrize(
    "step",
    [
        "XMOVE .p TILL 1001",
        "XMOVE /ERR .p TILL sensor[1]",
        "UTIMER .@t = 0\nIF UTIMER(.@t) > 5 THEN\nEND",
        "UTIMER @t[2] = 0",
        "TCP_RECV .n, sock, $text[1], count, 5, 255",
        "TCP_STATUS .n, p[0], s[0], e[0], m[0], $ip[0]",
        "IFPWPRINT 1, 1, 1, 9, 10 = $log[1], $log[2]",
        "SOUT 3 = SIG(1001) AND SIG(-1002)",
        "SOUT 3",
        "CLAMP 1, 2",
        "COLRON",
        "COLRON 1:",
        "CVSWITCH 2: ON",
        "ABS.SPEED .n: ON",
        "L3ACCURACY .n ALWAYS",
        "POINT 2: .p = S_HERE(2)",
        "DECOMPOSE .n: a[1] = #S_HERE(.n)",
        "POINT/X .p = .p+TRANS(1)",
        "POINT /OAT .p = NULL",
        "MC EXECUTE 2: main, -1",
        "MC PRIME main",
        "MC ERESET",
        "MC HOLD 1:",
        "MC ZPOWER ON",
        "IF SWITCH(CS, 2) == ON THEN\nEND",
        "IF EXISTDATA(.$s, R) == OFF THEN\nEND",
        "SPEED 100 MM/S ALWAYS",
        "CP OFF",
        "CP, QTOOL ON",
    ],
)
def test_forms_of_as_are_read(step: str) -> None:
    assert codes(step) == []


@pytest.mark.parametrize(
    ("step", "code"),
    [
        ("XMOVE .p TILL", "V124"),
        ("XMOVE .p sensor[1]", "V126"),
        ("TCP_RECV .n, sock, $text[1], count, 5, 255, 7", "V156"),
        ("TCP_LISTEN .n = port", "V125"),
        ("POINT/X /Y .p = NULL", "V132"),
        ("PCABORT : :", "V125"),
        ("SPEED 100 /S ALWAYS", "V130"),
        ("CALL .n", "V164"),
        ("CP, OFF", "V120"),
        ("MC MC HOLD", "V126"),
        ("MC )", "V126"),
        ("MC PRIME main main", "V126"),
        ("MC PRIME IF", "V126"),
    ],
)
def test_what_is_no_such_form_is_said(step: str, code: str) -> None:
    assert codes(step) == [code]


@pytest.mark.parametrize(
    "step",
    [
        "SIGNAL SIGNAL",
        "LMOVE TRANS(1, 2, LMOVE)",
        ".n = THEN",
        "THEN = 1",
        "CALL PRINT",
        "CALL other(.n, CALL)",
        "HERE SIGNAL",
        "IF SIG(JMOVE) THEN\nEND",
        "TWAIT GOTO",
    ],
)
def test_keywords_name_nothing(step: str) -> None:
    """[AS2015] 3-3: keywords are reserved."""
    assert codes(step) == ["V160"]


@pytest.mark.parametrize("step", ["SIGNAL open, -close", "width = jaw[type]", "LMOVE home"])
def test_plain_words_in_small_letters_are_names(step: str) -> None:
    """Programs of strangers call signals and numbers like this; values may stand elsewhere."""
    assert codes(step) == []
