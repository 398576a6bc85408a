"""The relatives of VAL-II as far as the front end tells them apart [manual language/dialects].

A dialect says which words count, how operators bind and what the three angles of a location mean.
"""

from enum import Enum
from typing import NamedTuple


class Angles(Enum):
    """What the three angles of TRANS and of location data mean."""

    OAT = "O A T"  # VAL's own: 90, -90, 0 is not turned
    ZYZ = "yaw, pitch, roll"  # plain Z Y' Z'' rotations: 0, 0, 0 is not turned


class Precedence(Enum):
    """How operators bind [manual language/operators#binding]."""

    A = "A"  # VAL-II and V+: AND like `*`, OR like `+`, comparisons last
    B = "B"  # AS: comparisons before AND and OR


class Dialect(NamedTuple):
    """One language of the family."""

    name: str  # as `--dialect` takes it
    title: str  # as messages name it
    letters: str  # columns of the vocabulary whose words count
    tolerant: bool  # takes shapes of real files that the controller would refuse
    angles: Angles
    precedence: Precedence
    max_line: int  # characters of a statement

    def __hash__(self) -> int:
        """Tell dialects apart by their names: all else is looked up by them, line by line."""
        return hash(self.name)

    @property
    def is_as(self) -> bool:
        """Whether this is Kawasaki's language."""
        return self.letters == "a"

    @property
    def is_vplus(self) -> bool:
        """Whether this is Adept's language."""
        return self.letters == "+"

    @property
    def is_val(self) -> bool:
        """Whether this is the VAL of 1979."""
        return self.letters == "1"

    @property
    def takes_all(self) -> bool:
        """Whether this is VAL-II with every spelling of its relatives."""
        return len(self.letters) > 1

    def has(self, letters: str) -> bool:
        """Return whether a word with these columns of the vocabulary counts."""
        if len(letters) == 1:
            return letters in self.letters
        return not set(self.letters).isdisjoint(letters)


# the second is ours [assumed, manual language/programs#line-length]
_STRICT_LINE, _TOLERANT_LINE = 255, 4096

VAL2 = Dialect("val2", "VAL-II", "2", False, Angles.OAT, Precedence.A, _STRICT_LINE)
VAL2_PLUS = Dialect("val2+", "VAL-II", "2+1a", True, Angles.OAT, Precedence.A, _TOLERANT_LINE)
VAL = Dialect("val", "VAL", "1", True, Angles.OAT, Precedence.A, _TOLERANT_LINE)
VPLUS = Dialect("vplus", "V+", "+", True, Angles.ZYZ, Precedence.A, _TOLERANT_LINE)
AS = Dialect("as", "AS", "a", True, Angles.ZYZ, Precedence.B, _TOLERANT_LINE)

DIALECTS = {dialect.name: dialect for dialect in (VAL2, VAL2_PLUS, VAL, VPLUS, AS)}

TITLES = {"1": "VAL", "2": "VAL-II", "+": "V+", "a": "AS"}  # of the columns of the vocabulary


def titles(letters: str) -> str:
    """Return the languages of some columns, for messages."""
    named = [TITLES[letter] for letter in letters]
    return " and ".join([", ".join(named[:-1]), named[-1]] if len(named) > 1 else named)
