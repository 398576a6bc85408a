"""Markdown as lines of a terminal."""

import pytest

from vrts.ask.terminal import Look, rendered, to_type

PLAIN = Look(40, color=False)
PAGE = """# A `TITLE`

(label-one)=
## Under it

Some words that are long enough to be wrapped with `code that stays whole` in them.

- one *thing*
- another, which is longer than a line can be
  and goes on
1. first

```val2
MOVES a      ; as it stands, however long the line may be
```

| key | what |
|---|---|
| `a` | b |

:::{toctree}
:hidden:
x
:::
<!-- nobody sees this -->
![no picture](x.png)
See [motion](../language/motion.md).
- **Code:** `vrts/engine.py`
"""


def shown(text: str, look: Look = PLAIN) -> str:
    return rendered(text, look, lambda words, target: f"{words} ({target})")


def test_a_page() -> None:
    assert (
        shown(PAGE)
        == """\
A TITLE
=======

Under it
--------

Some words that are long enough to be
wrapped with `code that stays whole` in
them.

  • one thing
  • another, which is longer than a line
    can be and goes on
  1. first

    MOVES a      ; as it stands, however long the line may be

key  what
`a`  b

See motion (../language/motion.md)."""
    )


def test_colours_take_no_room_and_no_marks() -> None:
    text = shown("Some words that are `code` and more of **them** to wrap.", Look(30, color=True))
    assert "`" not in text
    assert "**" not in text
    assert "\x1b[36mcode\x1b[0m" in text
    bare = text.replace("\x1b[36m", "").replace("\x1b[1m", "").replace("\x1b[0m", "")
    assert max(map(len, bare.splitlines())) <= 30


def test_a_wide_table_becomes_a_list() -> None:
    text = shown(f"| a | {'long words ' * 6} |\n|---|---|\n")
    assert text.splitlines()[0] == "  a"
    assert all(len(line) <= 40 for line in text.splitlines())


def test_nothing_in_a_page_steers_the_terminal() -> None:
    assert "\x1b" not in shown("bad \x1b[2J text\n\n```text\n\x1b]0;x\x07\n```\n")
    assert "\x1b[2J" not in shown("bad \x1b[2J text", Look(40, color=True))


@pytest.mark.parametrize(
    ("target", "at", "typed"),
    [
        ("../language/motion.md", "do/go-straight", "language/motion"),
        ("wait-a-time.md", "do/go-straight", "do/wait-a-time"),
        ("#language-motion-move", "do/go-straight", "language/motion#move"),
        ("signals.md#language-motion-move", "language/motion", "language/motion#move"),
        ("index.md", "index", "index"),
        ("#nowhere", "index", ""),
        ("https://example.org/x", "index", ""),
        ("picture.png", "index", ""),
    ],
)
def test_what_to_type_for_a_link(target: str, at: str, typed: str) -> None:
    assert to_type(target, at, {"language-motion-move": "language/motion#move"}) == typed
