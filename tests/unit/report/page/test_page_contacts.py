"""Pictures of contacts: at most four stills, the worst first; the page's viewer draws the rest."""

from dataclasses import replace

from tests.places import ROOT
from tests.support_runs import assessment
from tests.unit.report.page.test_html import Reader
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for
from vrts.report.assessment import Assessment
from vrts.report.page.page import page
from vrts.report.page.stills import (
    MOMENT,
    contact_name,
    contacts_of,
    page_stills,
    shown_first,
    worst_first,
)
from vrts.report.screen.assessment_text import assessment_text

HITS_BASE = ROOT / "examples" / "01-cans-on-bases" / "submissions" / "hits-base.v2"


def with_contacts(count: int, a: Assessment) -> Assessment:
    """Return a run with contacts one after another, each deeper than the one before."""
    assert a.judgement is not None
    assert a.judgement.collisions is not None
    (first,) = a.judgement.collisions.contacts
    contacts = tuple(
        first._replace(
            start_s=first.start_s + 0.1 * k,
            end_s=first.start_s + 0.1 * k + 0.05,
            deepest_s=first.start_s + 0.1 * k + 0.02,
            depth_m=0.001 * (k + 1),
        )
        for k in range(count)
    )
    report = replace(a.judgement.collisions, contacts=contacts)
    return replace(a, judgement=replace(a.judgement, collisions=report))


def test_the_moment_and_the_three_deepest_other_contacts_have_stills() -> None:
    a = with_contacts(6, assess(request_for(HITS_BASE)))
    assert shown_first(a) == 1
    stills = page_stills(a)
    assert list(stills) == [MOMENT, contact_name(5), contact_name(4), contact_name(3)]
    assert all(picture.startswith(b"\x89PNG") for picture in stills.values())
    read = Reader(page(a, stills))
    cards = [a for tag, a in read.elements if tag == "canvas" and "data-contact" in a]
    assert [card["data-contact"] for card in cards] == ["2", "1", "0"]
    pictures = [a for tag, a in read.elements if tag == "img"]
    assert len(pictures) == 4
    assert all(picture["alt"] for picture in pictures)


def test_times_of_a_contact_say_whether_they_are_its_begin_or_where_it_is_deepest() -> None:
    a = assess(request_for(HITS_BASE))
    shown = Reader(page(a, page_stills(a))).text
    assert "At 4.9 s, line 11" in shown
    assert "Watch at 4.9 s" in shown
    # the loss, the picture, the finding
    assert shown.count("deepest at 5.0 s") + shown.count("Deepest at 5.0 s") == 3
    assert "At 5.0 s" not in shown
    text = assessment_text(a, color=False)
    assert "\n  deepest at 5.0 s\n" in text
    assert "= deepest at 5.0 s: can1 and base1" in text


def test_what_ran_not_has_no_pictures() -> None:
    assert page_stills(replace(assessment(), run=None)) == {}


def test_equal_depths_stand_in_time_order() -> None:
    (contact,) = contacts_of(assessment())
    same = [contact, contact._replace(start_s=9.0)]
    assert [number for number, _ in worst_first(same)] == [0, 1]


def test_every_contact_tells_all_its_facts() -> None:
    shown = Reader(page(with_contacts(14, assessment()), {})).text
    assert "can1 touches base1, 14 mm deep" in shown
    assert "Deepest14.00 mm at 2.520 s" in shown
    assert "Where950, −100, −160 mm" in shown
    assert "2 more contacts are in the list of events." in shown
