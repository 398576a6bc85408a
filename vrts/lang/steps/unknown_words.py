"""First words that are no instruction of the dialect, or that could be several."""

import re

from vrts.base.diagnostic import Rule
from vrts.lang.dialect import VAL, titles
from vrts.lang.names import key
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.reading.classify import Head, is_assigned
from vrts.lang.spelling import nearest
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.commands import COMMANDS
from vrts.lang.vocabulary.foreign import FOREIGN, instead_of
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import spellings
from vrts.lang.vocabulary.relatives_commands import (
    GIVEN_BY_PROGRAMS,
    commands_of,
    languages_of,
)
from vrts.lang.vocabulary.word import Word

UNKNOWN_INSTRUCTION = Rule("V120", "unknown-instruction")
AMBIGUOUS_KEYWORD = Rule("V121", "ambiguous-keyword")
OTHER_DIALECT = Rule("V122", "not-val2")
MONITOR_COMMAND = Rule("V149", "monitor-command")
KEYWORD_AS_NAME = Rule("V160", "keyword-as-name")

_CALLING = frozenset({"CALL", "EXECUTE", "PCEXECUTE", "GOSUB", "REACTE", "ONE"})
_ENDS = frozenset({"ENDIF", "ENDFOR", "ENDWHILE", "ENDCASE", "WEND", "LOOP"})


def structural_word(tokens: list[Token], head: Head) -> str | None:
    """Return the structure word a step that cannot be parsed stands for."""
    if head.word is not None:
        jumps = head.word.text == "IF" and any(token.text.upper() == "GOTO" for token in tokens)
        return "GOTO" if jumps else head.word.text
    return "END" if tokens[0].text.upper() in _ENDS else None


def refuse(
    problems: Problems, tokens: list[Token], head: Head, program_names: frozenset[str]
) -> bool:
    """Report a step whose first word says that it cannot be parsed; return whether it was."""
    first = tokens[0]
    if head.word is not None:
        written = problems.source.text[first.start : first.end].upper()
        other = INSTRUCTIONS.get(written, head.word)
        of_val = other.dialects == VAL.letters  # GO is short for GOTO elsewhere
        if other.text != head.word.text and not of_val and len(tokens) > 1:
            _other_dialect(problems, first, written)  # READ of V+ is short for READY, but hardly
            return True
        if len(head.abbreviates) > 1:
            _guessed(problems, first, head.word)
        return False
    if first.kind != "NAME" or is_assigned(tokens):
        return False
    upper = first.text.upper()
    following = tokens[1] if len(tokens) > 1 else None
    if len(head.abbreviates) > 1:
        _ambiguous(problems, first, head.abbreviates)
    elif upper in FOREIGN:
        _other_dialect(problems, first, upper)
    elif key(first.text) in program_names:
        problems.error(
            UNKNOWN_INSTRUCTION,
            f"`{first.text}` is a program, not an instruction",
            first.start,
            first.end,
            notes=("VAL-II says *Unknown instruction*",),
            help=(f"write `CALL {first.text}`",),
            fix=problems.replace(first.start, first.start, "CALL "),
        )
    elif upper in COMMANDS:
        problems.error(
            MONITOR_COMMAND,
            f"{upper} is a command for the monitor, not a step of a program",
            first.start,
            first.end,
            notes=("VAL-II says *Unknown instruction*",),
            help=(_instead_of_command(upper),),
            fix=problems.replace(first.start, first.end, "CALL")
            if upper == "EXECUTE" and len(tokens) == 2 and tokens[1].kind == "NAME"
            else None,
        )
    elif upper in commands_of(problems.dialect) and upper not in INSTRUCTIONS:
        _other_monitor(problems, first, upper)
    elif upper in INSTRUCTIONS:
        _other_dialect(problems, first, upper)
    elif following is not None and following.text == "==":
        problems.error(
            UNKNOWN_INSTRUCTION,
            f"a comparison of `{first.text}` is not a step",
            following.start,
            following.end,
            notes=("`==` compares, `=` assigns", "VAL-II says *Unknown instruction*"),
            help=(f"to give `{first.text}` a value write `=`",),
            fix=problems.replace(following.start, following.end, "="),
        )
    else:
        _unknown(problems, first, following, program_names)
    return True


def _other_monitor(problems: Problems, first: Token, upper: str) -> None:
    """`SAVE/P file`: report a command that only the monitors of relatives have."""
    about = commands_of(problems.dialect)[upper]
    whose = titles(languages_of(upper))
    given = problems.dialect.is_as and upper in GIVEN_BY_PROGRAMS
    problems.error(
        MONITOR_COMMAND,
        f"{upper} is a command for the monitor, not a step of a program",
        first.start,
        first.end,
        f"a command of {whose}, to {about}",
        help=(f"a program gives it by `MC {upper}`" if given else _instead_of_command(upper),),
    )


def _unknown(
    problems: Problems, first: Token, following: Token | None, programs: frozenset[str]
) -> None:
    name = first.text
    shown = len(problems.found) < LIMIT  # what is not shown needs no suggestion
    meant = nearest(name.upper(), spellings(problems.dialect)) if shown else None
    glued = _glued(problems, name, programs) if shown else None
    if meant is not None:
        help_ = (f"did you mean `{meant}`?",)
        fix = problems.replace(first.start, first.end, meant)
    elif glued is not None:
        help_ = (f"write a blank: `{glued} {name[len(glued) :]}`",)
        fix = problems.replace(first.start, first.end, f"{glued} {name[len(glued) :]}")
    elif following is None or following.kind == "LPAREN":
        help_ = (f"if `{name}` is a program, write `CALL {name}`",)
        fix = None
    else:
        help_ = ("a step begins with an instruction, as in `MOVE part`, or assigns, as in `n = 1`",)
        fix = None
    problems.error(
        UNKNOWN_INSTRUCTION,
        f"`{name if len(name) <= 40 else name[:37] + '...'}` is not an instruction",
        first.start,
        first.end,
        notes=("VAL-II says *Unknown instruction*",),
        help=help_,
        fix=fix,
        data={"word": name},
    )


def _glued(problems: Problems, name: str, programs: frozenset[str]) -> str | None:
    """Return the instruction a word begins with: `MOVESpart`, `TYPE.x`, `END.`, `CALLplace`.

    That is the longest, but for one that leaves the name of a program, or a name used elsewhere.
    """
    upper = name.upper()
    found = [
        text
        for text in spellings(problems.dialect)
        if len(text) > 2 and upper.startswith(text) and upper != text
    ]
    named = [text for text in found if text in _CALLING and key(name[len(text) :]) in programs]
    used = [text for text in found if _is_used(problems.source.text, name[len(text) :])]
    longest = max(named or used or found, key=len, default=None)
    return (
        longest if longest and len(name) > len(longest) and name[len(longest)].isalpha() else None
    )


def _is_used(text: str, name: str) -> bool:
    """Whether a file has a name elsewhere."""
    if not name[:1].isalpha():
        return False
    return re.search(rf"(?<![\w.$#]){re.escape(name)}(?![\w.])", text, re.IGNORECASE) is not None


def _ambiguous(problems: Problems, first: Token, candidates: tuple[Word, ...]) -> None:
    texts = [word.text for word in candidates]
    problems.error(
        AMBIGUOUS_KEYWORD,
        f"`{first.text}` can be short for {_either(texts)}",
        first.start,
        first.end,
        notes=("VAL-II says *Ambiguous keyword*",),
        help=("write the word in full",),
    )


def _guessed(problems: Problems, first: Token, word: Word) -> None:
    written = problems.source.text[first.start : first.end]
    problems.warning(
        AMBIGUOUS_KEYWORD,
        f"`{written}` is taken for {word.text}",
        first.start,
        first.end,
        notes=("VAL-II says *Ambiguous keyword*",),
        help=("write the word in full",),
        fix=problems.replace(first.start, first.end, word.text),
    )


def _other_dialect(problems: Problems, first: Token, upper: str) -> None:
    origin, hint = FOREIGN.get(upper, ("", ""))
    word = INSTRUCTIONS.get(upper)
    if word is not None:
        origin = titles(word.dialects)
        if not hint and word.means:
            hint = f"use {word.means}"
        if not hint and problems.dialect.has("2"):
            hint = instead_of(upper)
    title = problems.dialect.title
    problems.error(
        OTHER_DIALECT,
        f"{upper} is not {'an' if title == 'AS' else 'a'} {title} instruction",
        first.start,
        first.end,
        f"a word of {origin}" if origin else "",
        notes=("VAL-II says *Unknown instruction*",),
        help=(hint,) if hint else (),
    )


def _instead_of_command(upper: str) -> str:
    match upper:
        case "EXECUTE":
            return "use CALL to run another program: `CALL name`"
        case "WHERE":
            return "use `HERE p`, and then `TYPE DX(p), DY(p), DZ(p)`"
        case "POINT" | "TEACH":
            return "use SET to give a location a value"
        case "ABORT":
            return "use HALT to end the execution"
        case _:
            return "give it to the monitor when no program is running"


def _either(texts: list[str]) -> str:
    more = len(texts) - 6
    shown = texts[:6] + ([f"{more} other{'' if more == 1 else 's'}"] if more > 0 else [])
    return ", ".join(shown[:-1]) + f" or {shown[-1]}"
