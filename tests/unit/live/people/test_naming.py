"""Names of people: any script, nobody else's, and none that passes for a role."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vrts.live.people.letters import clusters
from vrts.live.people.naming import LONGEST, RESERVED, Taken, is_role, own_name, person_name
from vrts.live.people.skeleton import look

SCRIPTS = [
    *("Anna-Maria O'Neil", "Łukasz Żółć", "Dr. Lee", "Ана Марија", "Γιώργος", "Նարե", "ნინო"),
    *("שרה", "מג'ד", "محمد", "نی\u200cنا", "ܡܪܝܡ", "अनुष्का", "শ্রী", "ਗੁਰਪ੍ਰੀਤ", "தமிழ்", "ಕನ್ನಡ"),
    *("ශ්\u200dරී", "น้ำฝน", "ສົມ", "བཀྲ་ཤིས", "မောင်", "ሰላም", "ᏣᎳᎩ", "ᠮᠣᠩᠭᠣᠯ", "李雷", "さくら"),
    *("ジャン・ポール", "김민준", "ꦱꦫꦶ", "𞤀𞤣𞤤𞤢𞤥", "L·luís", "Nguyễn Thị Ánh"),
]


@pytest.mark.parametrize("name", SCRIPTS)
def test_names_of_every_script_stay_as_they_are(name: str) -> None:
    name = unicodedata.normalize("NFC", name)
    assert person_name(name) == name
    assert own_name(name, Taken(SCRIPTS[:0]), guest=True) == name


@pytest.mark.parametrize(
    ("given", "shown"),
    [
        ("  Anna  Maria ", "Anna Maria"),
        ("Jose\u0301", "José"),
        ("Ａｎｎａ", "Anna"),
        ("𝕾𝖚𝖕𝖊𝖗", "Super"),
        ("a\u202eb\u2066c\u200fd\u061c", "abcd"),  # marks of direction
        ("An\u200bna\u2060\ufeff\u00ad", "Anna"),  # invisible
        ("An\u200dna\u200c", "Anna"),  # joiners where they join nothing
        ("A\U000e0061nna\ufe0f", "Anna"),  # tags, selectors
        ("\u3164Anna\u2800\u115f", "Anna"),  # letters that are blanks
        ("x\x1b[2Jy\n", "x 2Jy"),
        ("Anna ⭐ (supervisor) 🤖", "Anna supervisor"),
        ("A\u20ddB\u20de", "A B"),  # enclosed in a circle, in a square
        ("Ⓐ🅱", "A"),
        ("<b>Ben</b>", "b Ben b"),
        ("Z" + "\u0301\u0302\u0303\u0304\u0305\u0306" * 9, "Ź\u0302\u0303\u0304\u0305"),
        ("\u0301\u0302", ""),
        ("⭐🤖", ""),
        ("-'.", ""),
        (" \u200b ", ""),
        ("n" * 99, "n" * LONGEST),
        ("क्षि" * 99, "क्षि" * LONGEST),
        ("", ""),
    ],
)
def test_names_have_what_people_see_and_nothing_else(given: str, shown: str) -> None:
    assert person_name(given) == shown


@given(st.text(max_size=60))
def test_what_is_shown_of_a_name_is_safe_and_stays(text: str) -> None:
    name = person_name(text)
    assert person_name(name) == name
    assert unicodedata.is_normalized("NFC", name)
    assert len(clusters(name)) <= LONGEST
    kinds = {unicodedata.category(character) for character in name}
    assert kinds <= {"Lu", "Ll", "Lt", "Lm", "Lo", "Mn", "Mc", "Nd", "Zs", "Po", "Pd", "Pf", "Cf"}
    assert not set(name) & set('<>&"`\\\u202a\u202b\u202d\u202e\u2066\u2067\u2068\u2069\u200e')
    assert "".join(clusters(name)) == name


@given(st.lists(st.sampled_from(["Anna", "Аnnа", "ANNA", "Anna 2", "Annа 2", "аnna"]), max_size=12))
def test_nobody_can_be_taken_for_another(wanted: list[str]) -> None:
    had: list[str] = []
    for one in wanted:
        had.append(own_name(person_name(one), Taken(had), guest=True))
    for index, one in enumerate(had):
        assert not any(look(one).alike(look(other)) for other in had[:index]), had


def test_the_number_is_the_next_that_is_free() -> None:
    assert own_name("Anna", Taken(["Anna", "Anna 2"]), guest=True) == "Anna 3"
    assert own_name("Αnna", Taken(["Anna"]), guest=True) == "Αnna 2"  # its A is Greek


@pytest.mark.parametrize(
    "name", [*RESERVED, "Supervisor", "ѕuреrvіѕоr", "super-visor", "VRTS", "vrtѕ"]
)
def test_a_word_of_a_role_is_no_guests_name(name: str) -> None:
    assert is_role(name)
    assert own_name(name, Taken([]), guest=True) == f"{name} 2"
    assert own_name(name, Taken([]), guest=False) == name
