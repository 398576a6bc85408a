"""Words of a question and of a page, brought into one form so that they can be compared."""

import re
from functools import cache

from vrts.ask.everyday import ALIKE
from vrts.ask.other_languages import own_words
from vrts.ask.words import own_words as language

_WORD = re.compile(r"\$?[a-z0-9][a-z0-9_.+/-]*[a-z0-9+]|[a-z0-9]|[$#][a-z]+")
_OPERAND = re.compile(r"(?!v\d{3})[a-z]{0,2}\d[\d.]*")  # `50`, `p1`, `z10`: what a step is about
_PLAIN = re.compile(r"[a-z0-9]+")
_DOUBLED = re.compile(r"([bdgmnprt])\1$")  # `stopping`, `gripper`
_OF_CODE = re.compile(r"[{};]")  # what has these is a piece of a program
_SMALL = (  # small words, and those that every page is about
    "a about am an and any are as at be been being but by can cannot cant could did do does "
    "doing don for from get gets give got had has have having her here him his how i if in into "
    "is it its just know let like make makes me mine my need not of on one only or our please s "
    "should so some someone something such tell than that the their them then there these they "
    "thing this those to too use using us very want wants was way we were what when where which "
    "who why will with without would you your vrts val val-ii val2 program programs robot "
    "robots arm "
)
NOISE = frozenset(_SMALL.split())
_FREQUENT = (  # words of any talk, which say little of what is asked
    "about actually after against ago all almost alone along already also although always among "
    "another anybody anyone anything anyway because become begin best better between both came "
    "come comes course day days did different doesnt done during each either else enough "
    "equivalent even ever every everybody everyone everything exactly few first five found four "
    "further given gone good got great guy happen happens having hers his however id idea im "
    "instead isnt ive keeps kind knows large last later least less lets lot made many maybe "
    "might more most much must near nearly new next no nobody none nothing now often old once "
    "ones other others ought own people per perhaps possible quite rather really same saw say "
    "says see seem seen sees several shall since small somebody somehow sometimes somewhere "
    "soon still stuff sure taken takes tells than though three through today together told took "
    "toward true trying two upon used useful using usually various well went whatever whenever "
    "whether while whose within wont works year yes yet "
)
FREQUENT = frozenset(_FREQUENT.split())
_APART = frozenset({"pointer", "teacher"})  # of another matter than the verb within
_IRREGULAR = (  # forms that no ending tells, each behind the word that it belongs to
    "bend bent, bring brought, build built, buy bought, catch caught, choose chose chosen, "
    "draw drew drawn, drive drove driven, fall fell fallen, feed fed, fly flew flown, "
    "forbid forbade forbidden, forget forgot forgotten, freeze froze frozen, go gone, "
    "hide hid hidden, hold held, keep kept, know knew known, lay laid, lose lost, mean meant, "
    "run ran, send sent, shake shook shaken, show shown, sit sat, sleep slept, slide slid, "
    "spin spun, stand stood, stick stuck, strike struck, swing swung, teach taught, "
    "think thought, throw threw thrown, understand understood, write wrote written"
)
IRREGULAR = {form: row.split()[0] for row in _IRREGULAR.split(", ") for form in row.split()[1:]}


@cache
def stem(word: str) -> str:
    """Return a word without the endings that change nothing for somebody who searches."""
    word = IRREGULAR.get(word, word)
    if len(word) < 4 or not word.isalpha():
        return word
    if word.endswith("ies"):
        word = word[:-3] + "y"
    elif word.endswith("s") and not word.endswith(("ss", "us", "is")):
        word = word[:-1]
    for ending in ("ing", "ed"):
        if word.endswith(ending) and len(word) - len(ending) >= 3:
            word = _DOUBLED.sub(r"\1", word[: -len(ending)])
            break
    if word.endswith("ly") and len(word) > 5:
        word = word[:-2]
    for ending, kept in (("ation", "at"), ("ator", "at"), ("er", "")):
        if word.endswith(ending) and len(word) >= 6 and word not in _APART:
            word = _DOUBLED.sub(r"\1", word.removesuffix(ending) + kept)
            break
    word = word.removesuffix("e") if len(word) > 3 else word
    return word[:-1] + "i" if len(word) > 3 and word.endswith("y") else word


def words_of(text: str) -> list[str]:
    """Return the words of a text in small letters; those with signs in them also in parts."""
    found: list[str] = []
    for word in _WORD.findall(text.lower()):
        found.append(word)
        if not word.isalnum():
            found += [part for part in _PLAIN.findall(word) if len(part) > 1]
    return found


def stems_of(text: str) -> list[str]:
    """Return what the words of a text are compared by."""
    return [stem(word) for word in words_of(text)]


@cache
def alike() -> dict[str, frozenset[str]]:
    """Return stems that mean the same, by the stem or by several of them with blanks between."""
    found: dict[str, set[str]] = {}
    for row in ALIKE:
        phrases = [" ".join(stems_of(phrase)) for phrase in row.split(",")]
        single = {phrase for phrase in phrases if " " not in phrase}
        for phrase in phrases:
            found.setdefault(phrase, set()).update(single - {phrase})
    return {phrase: frozenset(words) for phrase, words in found.items()}


class Wanted:
    """One thing that a question is about: terms that would do, each with what it is worth."""

    __slots__ = ("said", "worth")

    def __init__(self, said: str, worth: dict[str, float]) -> None:
        """Keep what was said and the terms that stand for it."""
        self.said = said
        self.worth = worth


# what a term counts by where it comes from
SAME, ALSO, ELSEWHERE, NUMBER = 1.0, 0.45, 0.7, 0.1
_LONGEST = 4  # words of a phrase that means one thing


def wanted(question: str) -> list[Wanted]:
    """Return what a question is about, in its order."""
    words: list[str] = _WORD.findall(re.sub("['’]", "", question.lower()))
    named = set(re.findall(r"\$?[A-Z][A-Z0-9.]+", question))
    if _OF_CODE.search(question):
        named |= {word.upper() for word in words} & language()
    found: list[Wanted] = []
    at = 0
    while at < len(words):
        length, others = _phrase(words, at)
        if length > 1:
            said = words[at : at + length]
            worth = dict.fromkeys(others, SAME * 0.8)
            worth |= dict.fromkeys((stem(w) for w in said if w not in NOISE), 0.6)
            found.append(Wanted(" ".join(said), worth))
        elif words[at] not in NOISE or words[at].upper() in named or len(words) == 1:
            exact = words[at].upper() in named or len(words) == 1
            found.append(Wanted(words[at], _worth(words[at], others, exact=exact)))
        at += length
    if all(max(thing.worth.values()) <= NUMBER for thing in found):  # small words are all there is
        found = [Wanted(word, _worth(word, frozenset(), exact=False)) for word in words]
    return found


def _worth(word: str, others: frozenset[str], *, exact: bool) -> dict[str, float]:
    worth = dict.fromkeys(others, ALSO)
    if not word.isalnum():
        worth |= {stem(part): 0.5 for part in _PLAIN.findall(word) if len(part) > 1}
    for own in own_words().get(word, ()):
        worth["=" + own.lower()] = ELSEWHERE
    worth[stem(word)] = NUMBER if _OPERAND.fullmatch(word) or word in FREQUENT else SAME
    if exact:
        worth["=" + word] = 1.5
    return worth


def _phrase(words: list[str], at: int) -> tuple[int, frozenset[str]]:
    """Return how many words from a place on mean one thing together, and what means the same."""
    known = alike()
    for length in range(min(_LONGEST, len(words) - at), 0, -1):
        others = known.get(" ".join(stem(word) for word in words[at : at + length]))
        if others is not None:
            return length, others
    return 1, frozenset()
