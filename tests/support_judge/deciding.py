"""How students decide: by habit, by the lecture, by a tutor, by who sits beside them."""

from collections.abc import Mapping
from random import Random

Advice = Mapping[str, str]
Options = Mapping[str, float]


class Mind:
    """A student who decides one thing after the other, and what was decided.

    `talked` is what was talked about with a partner, `advice` what the tutor of the section says,
    `lecture` what the lecture's example has; each is followed now and then.
    """

    def __init__(self, rng: Random, lecture: Advice, advice: Advice, talked: Advice) -> None:
        self.rng = rng
        self.said = ((talked, 0.6), (advice, 0.55), (lecture, 0.35))
        self.decided: dict[str, str] = {}

    def choose(self, key: str, options: Options) -> str:
        """Return one of some options, the same each time that a key is asked for."""
        if key not in self.decided:
            self.decided[key] = self._choose(key, options)
        return self.decided[key]

    def often(self, key: str, share: float) -> bool:
        """Return whether something is done that a share of people does."""
        return self.choose(key, {"yes": share, "no": 1.0 - share}) == "yes"

    def note(self, key: str, value: object) -> None:
        """Keep something that was decided in another way."""
        self.decided[key] = str(value)

    def _choose(self, key: str, options: Options) -> str:
        for said, share in self.said:
            if key in said and self.rng.random() < share:
                return said[key]
        return self.rng.choices(list(options), list(options.values()))[0]


# Numbers that people take: round ones, some far more often than others.
HEIGHTS = {
    "100": 25.0, "150": 15.0, "120": 10.0, "80": 10.0, "200": 7.0, "50": 8.0, "60": 5.0, "130": 3.0,
    "90": 3.0, "110": 2.0, "70": 3.0, "75": 3.0, "140": 2.0, "125": 1.0, "180": 1.0, "160": 1.0,
}  # fmt: skip
LIFTS = {
    "200": 24.0, "250": 16.0, "150": 14.0, "300": 9.0, "220": 7.0, "180": 8.0, "240": 2.0,
    "160": 4.0, "210": 2.0, "230": 3.0, "170": 2.0, "280": 2.0, "190": 2.0, "260": 2.0, "225": 1.0,
}  # fmt: skip
FINE = {
    "20": 22.0, "30": 21.0, "25": 12.0, "10": 10.0, "50": 10.0, "40": 12.0, "15": 5.0, "35": 3.0,
    "60": 3.0, "45": 1.0, "12": 1.0,
}  # fmt: skip
USUAL = {"100": 42.0, "80": 18.0, "50": 9.0, "60": 8.0, "70": 8.0, "90": 7.0, "75": 4.0, "85": 2.0}
