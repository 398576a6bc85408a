"""`WAIT SIG 1001`, `SHIFT part BY 0, 0, 50`: a function without its parentheses."""

from itertools import pairwise

from vrts.lang.steps.broken_step import BrokenStep
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.functions import FUNCTIONS, Signature

_OPERANDS = ("NUMBER", "NAME", "STRINGNAME", "JOINTNAME", "STRING")
_ENDS = frozenset({"THEN", "DO", "OF", "TO", "STEP", "GOTO", "AND", "OR", "XOR", "ALWAYS"})
_COMPARES = frozenset({"==", "<>", "<", ">", "<=", ">=", "=<", "=>", "=", ":"})
_LONG = 60  # characters of an operand that are shown


def function_without_parentheses(step: BrokenStep) -> bool:
    """`WAIT SIG 1001`."""
    here, before = step.here, step.before
    if here is None or before is None or here.kind not in _OPERANDS:
        return False
    signature = FUNCTIONS.get(before.text.lower())
    if before.kind not in ("NAME", "STRINGNAME") or signature is None or signature.bare:
        return False
    if before.text.upper() == "TIME" and step.word is not None and step.word.text == "WAIT":
        return False  # `WAIT TIME 2`, which DELAY does
    operand = _operand(step.tokens[step.failure.at :], signature)
    if not operand:
        return False  # `$SYSDATA THEN`
    text = step.problems.source.text
    name = before.text.upper()
    written = text[operand[0].start : operand[-1].end]
    fix = None
    signs = [
        token
        for before_, token in pairwise([before, *operand])
        if token.kind == "INFIX" or (token.kind in ("MINUS", "PLUS") and before_.kind != "COMMA")
    ]
    if not signs:
        blank = before.end, operand[0].start
        fix = step.problems.replace(blank[0], operand[-1].end, f"({written})")
    help_ = f"write `{name}({written})`"
    if len(written) > _LONG:
        help_ = f"put all behind {name} between parentheses"
    step.problems.error(
        INVALID_EXPRESSION,
        f"{name} without parentheses",
        before.start,
        operand[-1].end,
        notes=("VAL-II says *Missing parenthesis*",),
        help=(help_,),
        fix=fix,
    )
    return True


def _operand(tokens: list[Token], signature: Signature) -> list[Token]:
    """Return the tokens that belong between the parentheses: an operand as a whole, or several."""
    most = signature.most
    depth, commas = 0, 0
    taken: list[Token] = []
    for token in tokens:
        depth += token.kind in ("LPAREN", "LBRACKET")
        depth -= token.kind in ("RPAREN", "RBRACKET")
        if depth < 0:
            break
        if depth == 0:
            commas += token.kind == "COMMA"
            if most is not None and commas >= most - (signature.by or 0):
                break
            if token.text.upper() in _ENDS or token.text in _COMPARES or token.kind == "FORMAT":
                break
        taken.append(token)
    while taken and taken[-1].kind == "COMMA":
        taken.pop()
    return taken
