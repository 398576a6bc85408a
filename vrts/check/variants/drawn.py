"""Which variant a student gets: a draw that a key, the assignment and the student decide alone.

The seed is HMAC-SHA256 of the key over assignment, student and the number of the try. A draw is
uniform over all combinations: numbers at the end, that would favour the first ones, are drawn
again, and so is what no student may get. So one key gives one student one variant, on every
machine, and nobody without the key can tell whose it is. Nor does a tag tell what is hidden in a
variant: the same key goes into it.
"""

import hashlib
import hmac
from typing import NamedTuple

from vrts.check.variants.model import Combination, Variants

SCHEME = "vrts.variant/1"
LETTERS = "bcdfghjklmnpqrstvwxz"  # no digits, which spreadsheets change; no vowels, so no words
LENGTH, GROUP = 8, 4  # letters of a tag: 34 bits
MOST_TRIES = 1_000_000
WIDTH = 1 << 256  # numbers that a digest may be


class Variant(NamedTuple):
    """One variant of a task."""

    combination: Combination
    tag: str  # "bcdf-ghjk": what it is called; the same values, the same tag


def drawn(variants: Variants, key: bytes, student: str) -> Variant:
    """Return the variant that a key gives to a student.

    Args:
        variants: Of the task.
        key: The teacher's.
        student: What tells the student from all others: the same whenever it is asked.

    Raises:
        ValueError: No try gave a combination that a student may get.
    """
    count = variants.total
    fair = WIDTH - WIDTH % count  # from here on numbers would favour the first combinations
    for number in range(MOST_TRIES):
        text = "\0".join((SCHEME, variants.assignment, student, str(number)))
        seed = int.from_bytes(hmac.digest(key, text.encode(), hashlib.sha256))
        if seed < fair:
            found = variants.combination(seed % count)
            if variants.allowed(found):
                return variant(variants, found, key)
    raise ValueError("nearly every combination is excluded")


def variant(variants: Variants, combination: Combination, key: bytes | None = None) -> Variant:
    """Return a combination with its tag: the same values have the same, in whatever order.

    Args:
        variants: Of the task.
        combination: Of them.
        key: The teacher's; None: that of `variants`, without one a tag that nobody is handed out.
    """
    parts = [SCHEME, "tag", variants.assignment]
    chosen = zip(variants.varies, combination, strict=True)
    for vary, choice in sorted(chosen, key=lambda pair: pair[0].name):
        parts += [vary.name, *vary.choices[choice]]
    secret = variants.key if key is None else key
    number = int.from_bytes(hmac.digest(secret, "\0".join(parts).encode(), hashlib.sha256))
    letters = ""
    for _ in range(LENGTH):
        number, letter = divmod(number, len(LETTERS))
        letters += LETTERS[letter]
    return Variant(combination, "-".join(letters[k : k + GROUP] for k in range(0, LENGTH, GROUP)))
