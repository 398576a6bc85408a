"""Files for people who join in: a citation, a changelog, forms for issues, a page to begin with."""

import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

from tests.places import ROOT
from vrts import __version__

GITHUB = ROOT / ".github"
FORMS = sorted((GITHUB / "ISSUE_TEMPLATE").glob("*.yml"))
PAGES = [
    *(ROOT / "README.md", ROOT / "CHANGELOG.md"),
    *(GITHUB / "CONTRIBUTING.md", GITHUB / "SECURITY.md"),
    *sorted((ROOT / "vrts" / "manual" / "learn").glob("*.md")),
]

# of the published schema of the Citation File Format, 1.2.0
CFF_REQUIRED = {"authors", "cff-version", "message", "title"}
CFF_ALLOWED = CFF_REQUIRED | {
    *("abstract", "commit", "contact", "date-released", "doi", "identifiers", "keywords"),
    *("license", "license-url", "preferred-citation", "references", "repository"),
    *("repository-artifact", "repository-code", "type", "url", "version"),
}
ENTITY_OR_PERSON = {"name", "family-names"}  # one of which an author needs

# of GitHub's documentation of issue forms and of its form schema
FORM_REQUIRED = {"name", "description", "body"}
FORM_ALLOWED = FORM_REQUIRED | {"assignees", "labels", "projects", "title", "type"}
ELEMENTS = {  # type: what its attributes need
    "markdown": {"value"},
    "textarea": {"label"},
    "input": {"label"},
    "dropdown": {"label", "options"},
    "checkboxes": {"label", "options"},
}
ATTRIBUTES = {"label", "description", "placeholder", "value", "render", "options", "multiple"}


def read(path: Path) -> dict[str, Any]:
    return yaml.safe_load(path.read_text("utf-8"))


def test_the_citation_holds_what_the_published_schema_asks_for() -> None:
    cited = read(ROOT / "CITATION.cff")
    assert CFF_REQUIRED <= set(cited) <= CFF_ALLOWED
    assert cited["cff-version"] == "1.2.0"
    assert cited["authors"]
    assert all(ENTITY_OR_PERSON & set(author) for author in cited["authors"])
    assert cited["type"] in {"software", "dataset"}
    assert re.fullmatch(r"\d{4}-\d{2}-\d{2}", cited["date-released"])


def test_citation_changelog_and_package_agree_on_version_and_licence() -> None:
    cited = read(ROOT / "CITATION.cff")
    assert str(cited["version"]) == __version__
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert cited["license"] == project["license"]
    assert f"\n## {__version__}" in (ROOT / "CHANGELOG.md").read_text("utf-8")


@pytest.mark.parametrize("form", [f for f in FORMS if f.stem != "config"], ids=lambda f: f.stem)
def test_a_form_has_the_keys_that_github_asks_for(form: Path) -> None:
    found = read(form)
    assert FORM_REQUIRED <= set(found) <= FORM_ALLOWED
    names = [element["id"] for element in found["body"] if element["type"] != "markdown"]
    assert len(set(names)) == len(names)
    assert any(element["type"] != "markdown" for element in found["body"])
    for element in found["body"]:
        assert set(element) <= {"type", "id", "attributes", "validations"}
        assert ELEMENTS[element["type"]] <= set(element["attributes"]) <= ATTRIBUTES
        if element["type"] != "markdown":
            assert re.fullmatch(r"[\w-]+", element["id"])
            assert set(element.get("validations", {})) <= {"required"}


def test_there_are_forms_and_blank_issues_stay_possible() -> None:
    assert len(FORMS) >= 3
    assert read(GITHUB / "ISSUE_TEMPLATE" / "config.yml") == {"blank_issues_enabled": True}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_links_lead_to_files_that_exist(page: Path) -> None:
    for link in re.findall(r"\]\(([^)#]+)\)", page.read_text("utf-8")):
        assert (page.parent / link).exists(), link


def test_the_page_for_contributors_names_folders_that_exist_and_is_one_page() -> None:
    text = (GITHUB / "CONTRIBUTING.md").read_text("utf-8")
    assert len(text.splitlines()) <= 60
    named = re.findall(r"`((?:vrts|tests|examples)(?:/[\w.]+)*)`", text)
    assert len(named) > 15
    assert [name for name in named if not (ROOT / name).exists()] == []
