"""How numbers are written by TYPE and $ENCODE [manual language/formats]."""

import math

from vrts.base.numbers import round_half_away
from vrts.ir.expressions import Format, FormatKind

FREE_LOWEST = 0.01  # smaller magnitudes are written with an exponent
FREE_HIGHEST = 999_999.0
FREE_DIGITS = 7  # what single precision holds [assumed]
WORD = 1 << 24  # hexadecimal and octal show 24-bit two's complement

NUMBER_KINDS = frozenset(
    {
        FormatKind.FREE,
        FormatKind.FIXED,
        FormatKind.INTEGER,
        FormatKind.GENERAL,
        FormatKind.EXPONENT,
        FormatKind.HEX,
        FormatKind.OCTAL,
        FormatKind.HEX_FILLED,
        FormatKind.DECIMAL_FILLED,
        FormatKind.TIGHT,
    }
)

FREE = Format(FormatKind.FREE)


def number(value: float, form: Format) -> str:
    """Return a number in a format; what does not fit its field is shown as asterisks."""
    width, decimals = form.width or 0, form.decimals or 0
    match form.kind:
        case FormatKind.FIXED:
            return _fitted(_fixed(value, decimals), width)
        case FormatKind.INTEGER:
            return _fitted(str(round_half_away(value)), width)
        case FormatKind.EXPONENT:
            return _fitted(f"{value:.{decimals}E}", width)
        case FormatKind.GENERAL:
            fixed = _fixed(value, decimals)
            if abs(value) > FREE_LOWEST and (not width or len(fixed) <= width):
                return _fitted(fixed, width)
            return _fitted(f"{value:.{decimals}E}", width)
        case FormatKind.HEX:
            return _fitted(f"{round_half_away(value) % WORD:X}", width)
        case FormatKind.OCTAL:
            return _fitted(f"{round_half_away(value) % WORD:o}", width)
        case FormatKind.HEX_FILLED:
            return _fitted(f"{round_half_away(value) % WORD:X}".rjust(width, "0"), width)
        case FormatKind.DECIMAL_FILLED:
            return _fitted(str(round_half_away(value)).rjust(width, "0"), width)
        case FormatKind.TIGHT:
            return free(value)
        case _:
            return " " + free(value)


def control(form: Format) -> str:
    """Return what a control that writes no number adds to the line."""
    count = 1 if form.width is None else form.width
    match form.kind:
        case FormatKind.NEWLINE:
            return "\r\n" * count
        case FormatKind.BLANK:
            return " " * count
        case FormatKind.BELL:
            return "\a"
        case FormatKind.UP:
            return "\x1b[A" * count
        case _:
            return ""


def free(value: float) -> str:
    """Return a number in free format, without the leading blank."""
    if value == 0.0:
        return "0"
    magnitude = abs(value)
    if magnitude <= FREE_HIGHEST and value == int(value):
        return str(int(value))
    if FREE_LOWEST <= round(magnitude, 9) <= FREE_HIGHEST:
        whole = math.floor(math.log10(magnitude)) + 1
        decimals = min(8, max(0, FREE_DIGITS - whole))
        text = f"{value:.{decimals}f}"
        return text.rstrip("0").rstrip(".") if "." in text else text
    mantissa, exponent = f"{value:.{FREE_DIGITS - 1}E}".split("E")
    return f"{mantissa.rstrip('0').rstrip('.')}E{exponent}"


def _fixed(value: float, decimals: int) -> str:
    scaled = abs(value) * 10.0**decimals
    if scaled < 1e15:  # round half away from zero on the decimal the reader sees
        digits = str(math.floor(scaled + 0.5)).rjust(decimals + 1, "0")
        text = f"{digits[:-decimals]}.{digits[-decimals:]}" if decimals else digits
    else:
        text = f"{abs(value):.{decimals}f}"
    return f"-{text}" if value < 0 and text.strip("0.") else text


def _fitted(text: str, width: int) -> str:
    if not width:
        return text
    return text.rjust(width) if len(text) <= width else "*" * width
