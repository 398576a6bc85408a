"""Pages made of schemas, commands, codes, docstrings and examples say all that these say."""

from pathlib import Path

import click
import pytest
from markdown_it import MarkdownIt

from tests.places import ROOT
from vrts.cli.main import vrts
from vrts.cli.schema_command import command as schema_command
from vrts.site.generated.assumptions_page import assumptions_page
from vrts.site.generated.command_pages import command_pages, prose
from vrts.site.generated.lessons import LIST, lesson, write_lessons
from vrts.site.generated.markdown import anchor, block, code, table, text
from vrts.site.generated.message_pages import message_pages
from vrts.site.generated.python_page import docstring, python_page
from vrts.site.generated.schema_pages import schema_names, schema_page, schema_pages
from vrts.site.generated.schema_tables import Schema, tables

PACKAGE = ROOT / "vrts"

# --- files ----------------------------------------------------------------------------------------

SCHEMA: Schema = {
    "title": "A small file",
    "type": "object",
    "required": ["name"],
    "properties": {
        "name": {"type": "string", "description": "What it is called."},
        "size_mm": {"type": "number", "minimum": 0, "exclusiveMinimum": True, "default": 5.0},
        "robot": {"type": "object", "properties": {"at_mm": {"$ref": "#/$defs/Point"}}},
        "goal": {
            "type": "array",
            "description": "One thing to reach.",
            "items": {
                "type": "object",
                "properties": {"place": {"type": "array", "items": {"$ref": "#/$defs/Point"}}},
            },
        },
        "objects": {
            "type": "object",
            "additionalProperties": {
                "anyOf": [
                    {"type": "object", "title": "A can", "properties": {"kind": {"const": "can"}}},
                    {"type": "object", "title": "A box", "properties": {"kind": {"const": "box"}}},
                ]
            },
        },
    },
    "$defs": {"Point": {"type": "object", "properties": {"x_mm": {"type": "integer"}}}},
}


def test_every_table_of_a_file_is_found_with_its_path() -> None:
    found = [table.heading for table in tables(SCHEMA) if table.path]
    assert found == ["[robot]", "[[goal]]", "[objects.NAME]"]


def test_a_page_tells_each_key_and_what_it_may_be() -> None:
    page = schema_page("small", SCHEMA)
    assert "# A small file\n" in page
    assert "| `name` *(needed)* | text |  | What it is called. |" in page
    assert "| `size_mm` | number, more than 0 | `5.0` |  |" in page
    assert "| `robot` | [`[robot]`](#file-small-at-robot) |" in page
    assert "(file-small-at-robot)=\n## `[robot]`" in page
    assert "## `[[goal]]`\n\nOne thing to reach." in page
    assert "| `place` | list of [Point](#file-small-point) |" in page
    assert "### A can\n" in page
    assert '| `kind` | `"box"` |' in page
    assert "(file-small-point)=\n## Point\n" in page


def test_every_schema_of_the_command_has_a_page_with_its_keys() -> None:
    choices = next(p.type for p in schema_command.params if isinstance(p.type, click.Choice))
    assert set(schema_names()) == set(choices.choices)
    pages = schema_pages()
    assert set(pages) == {*schema_names(), "index"}
    for name in schema_names():
        assert f"(#file-{name})" in pages["index"]
    assert "## `[objects.NAME]`" in pages["scene"]
    assert "`radius_mm`" in pages["scene"]
    assert "## `[[goal]]`" in pages["task"]


# --- commands -------------------------------------------------------------------------------------


def walked(command: click.Command, context: click.Context) -> list[click.Context]:
    found = [context]
    if isinstance(command, click.Group):
        for name in command.list_commands(context):
            below = command.get_command(context, name)
            if below is not None and not below.hidden:
                found += walked(below, click.Context(below, context, name))
    return found


def test_every_command_and_every_option_has_its_place() -> None:
    pages = command_pages()
    top = click.Context(vrts, info_name="vrts", help_option_names=["-h", "--help"])
    contexts = walked(vrts, top)[1:]
    assert len(contexts) > 60
    for context in contexts:
        path = context.command_path.split()
        section = pages[path[1]]
        assert f"# {context.command_path}\n" in section
        for parameter in context.command.get_params(context):
            record = parameter.get_help_record(context)
            if record is not None and record[1]:
                assert f"{code(record[0])}\n: " in section, (context.command_path, record[0])


def test_help_that_is_set_off_stays_as_it_stands() -> None:
    words = "First line\ngoes on.\n\n\b\n  a   b\n  c   d\n"
    assert prose(words) == "First line goes on.\n\n```text\na   b\nc   d\n```\n"


# --- messages, assumptions, Python ----------------------------------------------------------------


def test_every_code_has_its_text() -> None:
    pages = message_pages(PACKAGE / "pages")
    for path in sorted((PACKAGE / "pages").glob("V*.md")):
        title, _, body = path.read_text("utf-8").partition("\n")
        page = pages[path.stem[:2].lower()]
        assert f"(message-{path.stem.lower()})=\n#{title}\n" in page
        assert body.strip().splitlines()[-1] in page
        assert f"(#message-{path.stem.lower()})" in pages["index"]


def test_every_decision_and_every_reading_is_told() -> None:
    page = assumptions_page(PACKAGE)
    assert "| time between set points | 0.028 s | [inferred](#language-motion-tick) |" in page
    assert page.count("\n| `") > 80


INTERFACE = '''"""A package.

>>> 1 + 1
2
"""

__all__ = ["Thing", "act", "far"]

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vrts.elsewhere.there import far


def act(what: str, *, time_s: float = 0.0) -> int:
    """Act once.

    Args:
        what: The word, as `vrts run` takes it,
            on two lines.
        time_s: When [s].

    Raises:
        ValueError: It cannot be done.
    """


class Thing:
    """A thing."""

    name: str

    def at(self, time_s: float) -> "Thing":
        """Return it at a time."""
'''


def test_the_python_page_reads_names_wherever_they_are_defined(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "__init__.py").write_text(INTERFACE)
    (tmp_path / "elsewhere" / "there.py").write_text('def far() -> None:\n    """Far away."""\n')
    page = python_page(tmp_path)
    assert "```pycon\n>>> 1 + 1\n2\n```" in page
    assert "## act\n\n```python\nact(what: str, *, time_s: float=0.0) -> int\n```" in page
    assert "`what`\n: The word, as `vrts run` takes it, on two lines." in page
    assert "**Raises**\n\n`ValueError`\n: It cannot be done." in page
    assert "`name`\n: `str`" in page
    assert "### Thing.at\n\n```python\nat(time_s: float) -> 'Thing'\n```" in page
    assert "## far\n\n```python\nfar() -> None\n```\n\nFar away." in page


def test_a_docstring_without_sections_is_a_paragraph() -> None:
    assert docstring("One.\n\nTwo,\nthree.") == "One.\n\nTwo, three.\n\n"


def test_what_is_set_off_in_a_docstring_is_code() -> None:
    assert docstring("Like this::\n\n    x = 1\n    y = 2") == (
        "Like this:\n\n```python\nx = 1\ny = 2\n```\n\n"
    )


# --- lessons --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("written", "shown"),
    [
        ("![A can](pictures/a.png)", "![A can](01-cans/pictures/a.png)"),
        ("[next](../02-dish-on-stand/README.md)", "[next](02-dish-on-stand.md)"),
        ("[own](../07-own-assignment/README.md#goals)", "[own](07-own-assignment.md#goals)"),
        ("[front page](../../README.md)", "[front page](../index.md)"),
        (
            "[futures](../../vrts/manual/understand/futures.md)",
            "[futures](../understand/futures.md)",
        ),
        ("[a solution](solution.v2)", "a solution (`examples/01-cans/solution.v2`)"),
        ("[there](https://example.org)", "[there](https://example.org)"),
        ("<!-- file: a.toml -->\nx", "x"),
    ],
)
def test_links_of_a_lesson_lead_within_the_manual(written: str, shown: str) -> None:
    assert lesson(written, "01-cans") == shown


def test_every_example_is_a_lesson_with_its_pictures(tmp_path: Path) -> None:
    (tmp_path / "index.md").write_text(f"# Learn\n\n{LIST}\n")
    write_lessons(ROOT / "examples", tmp_path)
    names = {path.stem for path in tmp_path.glob("*.md")} - {"index"}
    assert names == {path.parent.name for path in (ROOT / "examples").glob("*/README.md")}
    assert (tmp_path / "01-cans-on-bases" / "pictures" / "put.png").is_file()
    listed = (tmp_path / "index.md").read_text()
    assert all(f"]({name}.md)" in listed for name in names)
    first = (tmp_path / "01-cans-on-bases.md").read_text()
    assert "steps. `vrts learn 1` copies this lesson" in first


# --- Markdown -------------------------------------------------------------------------------------


def test_signs_mean_nothing_in_plain_words() -> None:
    assert text("a_b *c* [d] <e>") == r"a\_b \*c\* \[d\] \<e\>"
    assert text("see `a_b` and `c`") == "see `a_b` and `c`"
    assert code("a|b") == "`a|b`"
    assert block("text", "```\nx\n```") == "````text\n```\nx\n```\n````\n"
    assert anchor("word", "function", "$MID") == "word-function-text-mid"


def test_a_bar_in_a_cell_ends_no_cell() -> None:
    rows = table(("h", "i"), [(code("a|b"), text("c|d"))])
    html = MarkdownIt().enable("table").render(rows)
    assert "<td><code>a|b</code></td>\n<td>c|d</td>\n</tr>" in html
