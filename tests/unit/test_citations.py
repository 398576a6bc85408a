"""Citations lead to rules of the manual, and each rule says what it stands on.

A citation in a comment or docstring names a page and a rule, as in the texts at the end, with
*assumed* in front where somebody had to decide.
"""

import posixpath
import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import NamedTuple

import pytest

from tests.places import ROOT
from tests.support_programs import compiled, program

MANUAL = ROOT / "vrts" / "manual"
PAGES = {
    path.relative_to(MANUAL).with_suffix("").as_posix(): path.read_text("utf-8")
    for path in sorted(MANUAL.rglob("*.md"))
}
RULES = ("language/", "robots/")
OF_RULES = sorted(n for n in PAGES if n.startswith(RULES) and not n.endswith("/index"))
KEYS = frozenset(
    re.findall(r"^\| \[(\w+)\] \|", (ROOT / "vrts" / "README.md").read_text("utf-8"), re.M)
)

# pages that the build makes; that links to them lead somewhere, tests/unit/site/test_built.py shows
GENERATED = re.compile(r"look-up/|learn/\d\d-|understand/assumptions$")

STATUSES = ("documented", "inferred", "assumed")
SUFFIXES = {".py", ".md", ".toml", ".lark", ".json", ".v2", ".val", ".vplus", ".as"}
DIALECTS = {"val2", "val2+", "val", "vplus", "as"}

CITATION = re.compile(r"\[(assumed,\s+)?manual\s+([^\]]+)\]")
ONE = re.compile(r"([a-z0-9/-]+)(?:#([a-z0-9-]+))?")
SECTION = re.compile(r"(?:^\(([^)\n]*)\)=\n)?^## (.+)\n((?:(?!^\(|^## ).*\n?)*)", re.M)
FIELD = re.compile(r"^- \*\*(Status|Source|On the robot|Code):\*\* (.*\S)$", re.M)
KEY = re.compile(r"\[([A-Z]\w+)\](?!\()")
LINK = re.compile(r"\]\(#([^)]*)\)")
BLOCK = re.compile(r"^```(\S+)\n(.*?)^```$", re.M | re.S)
CONSTANT = re.compile(r"^\s*(?:\w+(?:, \w+)*)(?:: \w+)? = ([^#\n]*\d[^#\n]*)", re.M)
NUMBER = re.compile(r"(?<![\w.])\d[\d_]*(?:\.\d+)?(?:e-?\d+)?")
LINKED = re.compile(r"\]\([^)]*\)")
NAMED = re.compile(r"(?<![\w/.{}*-])[\w./-]+\.md\b")
DATED = re.compile(r"\[([A-Z][A-Za-z]+\d{4}[a-z]?)\]")
TYPED = {  # commands that other tests type: tests/unit/site/test_first_page.py, tests/golden
    *(("index", "sh"), ("learn/server", "console")),
}
HERE = [path for path in ROOT.iterdir() if path.name != ".venv"]  # which holds a great deal
TEXTS = frozenset(
    [
        "sheet.md",  # written beside programs for other controllers
        *(path.name for path in HERE if path.suffix == ".md"),
        *(path.name for folder in HERE if folder.is_dir() for path in folder.rglob("*.md")),
    ]
)
NOT_HERE = re.compile(r"\b(?:val2|puma|paper|traps)\.md\b")  # notes that nobody outside has


class Rule(NamedTuple):
    """One section of a page."""

    page: str
    label: str  # of the whole manual; empty: it has none
    title: str
    fields: Mapping[str, str]
    text: str


def rules(page: str, text: str) -> list[Rule]:
    """Return the sections of a page."""
    return [
        Rule(page, label, title, dict(FIELD.findall(body)), f"{title}\n{body}")
        for label, title, body in SECTION.findall(text)
    ]


def faults_of_page(
    page: str, text: str, keys: frozenset[str], exists: Callable[[str], bool]
) -> Iterator[str]:
    """Yield what a page of rules lacks."""
    found = rules(page, text)
    if not found:
        yield f"{page}: no rule"
    for rule in found:
        where = f"{page}: {rule.title}"
        if not rule.label.startswith(page.replace("/", "-") + "-"):
            yield f"{where}: the label `{rule.label}` is not of this page"
        if rule.fields.get("Status") not in STATUSES:
            yield f"{where}: status is one of {', '.join(STATUSES)}"
        if not rule.fields.get("Source"):
            yield f"{where}: no source"
        if rule.fields.get("Status") == "assumed" and not rule.fields.get("On the robot"):
            yield f"{where}: nobody says how to find out on the robot"
        paths = re.findall(r"`([^`]+)`", rule.fields.get("Code", ""))
        if not paths:
            yield f"{where}: no code"
        yield from (f"{where}: there is no {path}" for path in paths if not exists(path))
    for key in KEY.findall(text):
        if key not in keys:
            yield f"{page}: the key [{key}] is not defined"


def citations(text: str) -> Iterator[tuple[bool, str]]:
    """Yield every citation in a text: whether it is of something assumed, page and rule."""
    for mark, cited in CITATION.findall(text):
        for one in cited.split(","):
            yield bool(mark), " ".join(one.split())


def faults_of_citations(name: str, text: str, pages: Mapping[str, str]) -> Iterator[str]:
    """Yield citations in a file that lead nowhere, or call assumed what is documented."""
    for assumed, cited in citations(text):
        match = ONE.fullmatch(cited)
        page, anchor = (match[1], match[2]) if match else (cited, None)
        if page not in pages:
            yield f"{name}: there is no page `{page}`"
        elif anchor is not None:
            label = f"{page.replace('/', '-')}-{anchor}"
            rule = next((r for r in rules(page, pages[page]) if r.label == label), None)
            if rule is None:
                yield f"{name}: `{page}` has no rule `{anchor}`"
            elif assumed and rule.fields.get("Status") == "documented":
                yield f"{name}: `{cited}` is documented, not assumed"


def faults_of_constants(name: str, text: str, pages: Mapping[str, str]) -> Iterator[str]:
    """Yield constants with numbers that the rule cited beside or above them does not have."""
    lines = text.splitlines()
    for above, line in zip(["", *lines], lines, strict=False):
        constant = CONSTANT.match(line)
        if constant is None:
            continue
        comment = above if above.lstrip().startswith("#") else line.partition("#")[2]
        for _, cited in citations(comment):
            page, _, anchor = cited.partition("#")
            label = f"{page.replace('/', '-')}-{anchor}"
            for rule in rules(page, pages.get(page, "")):
                if rule.label == label:
                    missing = [n for n in _numbers(constant[1]) if not _says(rule.text, n)]
                    yield from (f"{name}: {n:g} is not in `{cited}`" for n in missing)


def faults_of_names(name: str, text: str, texts: frozenset[str]) -> Iterator[str]:
    """Yield texts that a file names and nobody has, and keys of sources that nothing defines."""
    if not name.startswith("tests/"):  # tests make up files
        told = LINKED.sub("", text) if name.startswith("vrts/manual/") else text  # the site checks
        for cited in NAMED.findall(told):
            if cited.rpartition("/")[2] not in texts:
                yield f"{name}: there is no {cited}"
    yield from (
        f"{name}: the key [{k}] is not defined" for k in DATED.findall(text) if k not in KEYS
    )


def _numbers(code: str) -> list[float]:
    """Return the numbers of a constant; of a range, the first and the last that is in it."""
    numbers = [float(number) for number in NUMBER.findall(code)]
    return [numbers[0], numbers[1] - 1] if code.startswith("range(") else numbers


def _says(text: str, number: float) -> bool:
    """Return whether a text has a number, or a length in mm for one in m."""
    forms = {f"{number:.10g}", f"{number * 1000:.10g}", f"{number:.0E}".replace("E-0", "E-")}
    return any(re.search(rf"(?<![\d.]){re.escape(form)}(?!\d)", text) for form in forms)


def sources() -> Iterator[tuple[str, str]]:
    """Yield name and text of every file that may cite."""
    for folder in ("vrts", "tests", "scenes", "examples", "README.md", "pyproject.toml"):
        for path in sorted([ROOT / folder, *(ROOT / folder).rglob("*")]):
            if path.suffix in SUFFIXES and path.is_file() and _is_ours(path):
                yield path.relative_to(ROOT).as_posix(), path.read_text("utf-8", "replace")


def _is_file(path: str) -> bool:
    return (ROOT / path).is_file()


def _is_ours(path: Path) -> bool:
    return path != Path(__file__) and not {"vendor", "node_modules"} & set(path.parts)


def test_every_citation_leads_to_a_rule() -> None:
    found = [fault for name, text in sources() for fault in faults_of_citations(name, text, PAGES)]
    assert found == []
    cited = {one for name, text in sources() if name.endswith(".py") for one in citations(text)}
    assert len(cited) > 50, "few citations found: the pattern is wrong"


def test_numbers_in_the_source_are_those_of_the_rules() -> None:
    python = [(name, text) for name, text in sources() if name.startswith("vrts/")]
    assert [f for name, text in python for f in faults_of_constants(name, text, PAGES)] == []


def test_nothing_names_notes_that_nobody_has() -> None:
    assert [name for name, text in sources() if NOT_HERE.search(text)] == []


def test_every_text_and_every_key_that_is_named_is_there() -> None:
    found = [fault for name, text in sources() for fault in faults_of_names(name, text, TEXTS)]
    assert found == []


@pytest.mark.parametrize("page", OF_RULES)
def test_every_rule_has_a_status_a_source_and_code(page: str) -> None:
    assert list(faults_of_page(page, PAGES[page], KEYS, _is_file)) == []


def test_labels_are_unique_and_links_lead_to_them() -> None:
    labels = [rule.label for page, text in PAGES.items() for rule in rules(page, text)]
    labels = [label for label in labels if label]
    assert sorted(labels) == sorted(set(labels))
    linked = {link for text in PAGES.values() for link in LINK.findall(text)}
    assert linked - set(labels) == set()


def test_the_index_lists_every_page_and_every_rule_with_its_status() -> None:
    for folder in ("language", "robots"):
        index = PAGES[f"{folder}/index"]
        expected = [page for page in OF_RULES if page.startswith(folder)]
        listed = re.findall(r"^## \[.+\]\((.+)\.md\)$", index, re.M)
        assert sorted(f"{folder}/{page}" for page in listed) == expected
        found = [rule for page in listed for rule in rules(folder, PAGES[f"{folder}/{page}"])]
        lines = [f"- [{r.title}](#{r.label}): {r.fields.get('Status')}" for r in found]
        assert re.findall(r"^- .*$", index, re.M) == lines


def linked_pages(page: str) -> set[str]:
    """Return the pages that a page links to."""
    found = re.findall(r"\]\(([^)#:]+)\.md(?:#[^)]*)?\)", PAGES[page])
    folder = PurePosixPath(page).parent
    return {posixpath.normpath(folder / name) for name in found}


def test_links_to_pages_lead_somewhere() -> None:
    gone = {page: linked_pages(page) - set(PAGES) for page in PAGES}
    assert {link for links in gone.values() for link in links if not GENERATED.match(link)} == set()


def test_the_first_page_leads_to_the_four_parts_and_they_to_their_pages() -> None:
    parts = {"learn/index", "do/index", "look-up/index", "understand/index"}
    assert linked_pages("index") >= parts
    assert linked_pages("look-up/index") >= {"language/index", "robots/index"}
    understand = {page for page in PAGES if page.startswith("understand/")}
    made = {"understand/assumptions"}
    assert linked_pages("understand/index") - made == understand - {"understand/index"}


def blocks() -> list[tuple[str, str, str]]:
    """Return page, language and text of the manual's blocks of code; recipes are executed whole."""
    return [(name, *block) for name, text in PAGES.items() for block in BLOCK.findall(text)]


@pytest.mark.parametrize("page", sorted(p for p in PAGES if not p.startswith("do/")))
def test_every_program_of_a_page_compiles(page: str) -> None:
    for name, language, text in blocks():
        if name == page:
            typed = (name, language) in TYPED
            assert language in DIALECTS | {"text"} or typed, language
            if language in DIALECTS:
                compiled(text if ".PROGRAM" in text else program(text.rstrip()), language)


# --- the checker finds faults ---------------------------------------------------------------------

PAGE = """# Signals

(language-signals-ranges)=
## Which signals there are

Outputs are 1 to 32.

- **Status:** assumed
- **Source:** no document, but see [Known2000]
- **On the robot:** Type SIGNAL with a larger number.
- **Code:** `vrts/engine.py`

(language-signals-sign)=
## A minus means off

- **Status:** documented
- **Source:** [Known2000]
- **Code:** `vrts/engine.py`
"""
SMALL = {"language/signals": PAGE}


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("OUTPUTS = 32  # [assumed, manual language/signals#ranges]", ""),
        ("x  # [manual language/signals]", ""),
        ("x  # [manual language/signals#sign, language/signals#ranges]", ""),
        ("x  # [manual language/signals#no-such]", "`language/signals` has no rule `no-such`"),
        ("x  # [manual language/signal#sign]", "there is no page `language/signal`"),
        ("x  # [manual Signals]", "there is no page `Signals`"),
        ("x  # [manual language/signals#sign, robots]", "there is no page `robots`"),
        (
            "x  # [assumed, manual language/signals#sign]",
            "`language/signals#sign` is documented, not assumed",
        ),
    ],
)
def test_a_wrong_citation_is_found(text: str, fault: str) -> None:
    found = list(faults_of_citations("a.py", text, SMALL))
    assert found == ([f"a.py: {fault}"] if fault else [])


@pytest.mark.parametrize(
    ("name", "text", "fault"),
    [
        ("vrts/a.py", "see docs/there.md and [FGL1987]", ""),
        ("vrts/a.py", "see notes/gone.md", "there is no notes/gone.md"),
        ("tests/a.py", "writes gone.md", ""),
        ("tests/a.py", "as in [Nobody1999]", "the key [Nobody1999] is not defined"),
    ],
)
def test_a_text_or_a_key_that_is_not_there_is_found(name: str, text: str, fault: str) -> None:
    found = list(faults_of_names(name, text, frozenset({"there.md"})))
    assert found == ([f"{name}: {fault}"] if fault else [])


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("OUTPUTS = range(1, 33)  # [assumed, manual language/signals#ranges]", ""),
        ("# [assumed, manual language/signals#ranges]\nOUTPUTS = 32", ""),
        ("OUTPUTS = 64  # [manual language/signals#ranges]", "64"),
        ("# [manual language/signals#ranges]\nOUTPUTS = 7", "7"),
    ],
)
def test_another_number_than_that_of_the_rule_is_found(text: str, fault: str) -> None:
    found = list(faults_of_constants("a.py", text, SMALL))
    said = f"a.py: {fault} is not in `language/signals#ranges`"
    assert found == ([said] if fault else [])


@pytest.mark.parametrize(
    ("before", "after", "fault"),
    [
        ("", "", ""),
        ("assumed", "guessed", "status is one of documented, inferred, assumed"),
        ("- **Status:** assumed\n", "", "status is one of documented, inferred, assumed"),
        ("- **Source:** no document, but see [Known2000]\n", "", "no source"),
        ("(language-signals-ranges)=\n", "", "the label `` is not of this page"),
        ("language-signals-ranges", "ranges", "the label `ranges` is not of this page"),
        ("vrts/engine.py", "vrts/gone.py", "there is no vrts/gone.py"),
        ("- **Code:** `vrts/engine.py`\n", "", "no code"),
        (
            "- **On the robot:** Type SIGNAL with a larger number.\n",
            "",
            "nobody says how to find out on the robot",
        ),
        ("[Known2000]", "[Else1999]", "the key [Else1999] is not defined"),
    ],
)
def test_a_rule_that_lacks_something_is_found(before: str, after: str, fault: str) -> None:
    text = PAGE.replace(before, after, 1) if before else PAGE
    keys, code = frozenset({"Known2000"}), "vrts/engine.py"
    found = list(faults_of_page("language/signals", text, keys, code.__eq__))
    prefix = "language/signals: " + ("" if "key" in fault else "Which signals there are: ")
    assert found == ([prefix + fault] if fault else [])
