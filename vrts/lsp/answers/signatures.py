"""What the call or instruction takes that is being typed."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.lang.names import key
from vrts.lang.vocabulary.function_forms import argument_names
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.lsp.answers.symbols import header_of
from vrts.lsp.answers.wanted import argument_of
from vrts.lsp.documents.asking import asked_at
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.words import function_help, instruction_help, named_usage, parameters_of


class Help(NamedTuple):
    """A signature, and which of its parameters comes now."""

    text: str
    about: str
    parameters: tuple[str, ...]  # each stands in the text, in this order
    active: int


def signature(document: Document, offset: int, group: Sequence[Document]) -> Help | None:
    """Return what the call or instruction at an offset takes; None outside of any."""
    asked = asked_at(document, offset)
    if asked.silent:
        return None
    call = asked.call
    if call is not None:
        if asked.word is not None and asked.word.text == "CALL":
            for other in group:
                for program in other.names.programs:
                    if program.name == key(call.name):
                        formals = tuple(
                            f.name.text.lower() + ("[]" if f.array else "") for f in program.formals
                        )
                        text, about = header_of(program), f"in `{other.source.name}`"
                        return Help(text, about, formals, _within(call.argument, formals))
        function = FUNCTIONS.get(call.name.lower())
        if function is not None:
            given = argument_names(function)
            kinds = parameters_of(function)
            about = f"{function_help(function)}; takes {', '.join(kinds) or 'nothing'}"
            at = _within(argument_of(call, function), given)
            return Help(named_usage(function), about, given, at)
    word = asked.word
    if word is None or not word.usage:
        return None
    rest = word.usage.partition(" ")[2]
    operands = tuple(part.strip() for part in rest.split(",") if part.strip())
    return Help(word.usage, instruction_help(word), operands, _within(asked.operand, operands))


def _within(argument: int, parameters: tuple[str, ...]) -> int:
    """Return which parameter an argument is; the last one where it repeats."""
    if parameters and parameters[-1].endswith("..."):
        return min(argument, len(parameters) - 1)
    return argument
