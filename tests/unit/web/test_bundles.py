"""Bundles: what a page needs in few files, each module once, after what it imports."""

import re

import pytest

from vrts.web import bundles
from vrts.web.assets import CODEMIRROR, THREE, asset, closure, imports
from vrts.web.bundles import Bundles, taken_apart

PAGE = Bundles("live/index.html")
MAIN = "live/main.js"
ALL = sorted(path for bundle in PAGE.paths for path in PAGE.parts(bundle))


def test_a_page_asks_for_few_files_before_it_can_begin() -> None:
    page = PAGE.html()
    named = re.findall(r'<link rel="modulepreload" href="/web/([^"]+)"( fetch\S+)?>', page)
    assert named[0] == ("live/early.js", "")
    assert all(priority == ' fetchpriority="low"' for _, priority in named[1:])
    assert {MAIN, THREE} <= {path for path, _ in named}
    assert len(named) <= 5  # six answers at a time are on their way
    assert page.index("modulepreload") < page.index("<body>")
    assert re.findall(r'<link rel="stylesheet" href="/web/([^"]+)">', page) == [PAGE.sheet]


def test_the_first_page_waits_for_no_editor() -> None:
    assert CODEMIRROR not in PAGE.html()
    assert CODEMIRROR not in PAGE.text(MAIN)
    assert "live/editor/panel.js" in PAGE.parts(MAIN)  # it loads the rest when it is opened
    assert 'import("/web/live/editor/workbench.js")' in PAGE.text(MAIN)


def test_one_style_sheet_holds_all_in_their_order() -> None:
    sheets = re.findall(r'<link rel="stylesheet" href="/web/([^"]+)">', asset("live/index.html"))
    assert len(sheets) > 5
    places = [PAGE.css().index(asset(sheet)) for sheet in sheets]
    assert places == sorted(places)


def test_all_modules_of_the_page_stand_in_bundles() -> None:
    assert {path for path in closure(MAIN) if not path.startswith("vendor/")} <= set(ALL)
    assert {"live/past/past.js", "live/panels/chat.js", "live/editor/workbench.js"} <= set(ALL)


@pytest.mark.parametrize("path", ALL)
def test_every_module_stands_in_one_bundle_after_what_it_imports(path: str) -> None:
    bundle = PAGE.owner(path)
    parts = PAGE.parts(bundle)
    assert parts.count(path) == 1
    for needed in imports(path):
        if needed in parts:
            assert parts.index(needed) < parts.index(path)
    for needed, names in _wanted(path):
        if not needed.startswith("vendor/"):
            assert names <= set(taken_apart(needed, asset(needed)).exports)


@pytest.mark.parametrize("path", PAGE.paths)
def test_a_bundle_imports_only_what_others_give(path: str) -> None:
    text = PAGE.text(path)
    assert "/**" not in text
    taken = re.findall(r'^import \{ (\S+) \} from "/web/([^"]+)";$', text, re.M)
    for name, bundle in taken:
        given = PAGE.text(bundle).rsplit("export {", 1)[1]
        assert name in re.findall(r"[\w$]+", given)
    whole = re.findall(r'^import \* as \S+ from "/web/([^"]+)";$', text, re.M)
    assert all(other.startswith("vendor/") for other in whole)
    assert len(re.findall(r"^import\b", text, re.M)) == len(taken) + len(whole)


def test_the_address_of_a_module_gives_the_one_of_its_bundle() -> None:
    assert PAGE.owner("live/dom.js") == MAIN
    assert PAGE.text("live/dom.js").startswith('import { $live_dom } from "/web/live/main.js";\n')
    assert "byId" in PAGE.text("live/dom.js")


def test_imports_and_exports_are_what_a_bundle_makes_of_them() -> None:
    module = taken_apart(
        "live/a.js",
        'import {\n  one, two as second,\n} from "./b.js";\n'
        'import { Vector3 } from "three";\n\n'
        "/** @param {import('./c.js').C} c */\nexport async function ask(c) {\n"
        '  await import("./later.js");\n  // what is so\n  return one(c, "// kept");\n}\n'
        "export const A = 1;\nexport class B {}\n",
    )
    assert [path for _, path in module.taken] == ["live/b.js", THREE]
    assert module.exports == ("ask", "A", "B")
    assert module.body == (
        '\n\nasync function ask(c) {\n  await import("/web/live/later.js");\n'
        '  return one(c, "// kept");\n}\nconst A = 1;\nclass B {}\n'
    )


@pytest.mark.parametrize(
    "line",
    [
        "export let changing = 0;",
        "export default one;",
        'export * from "./b.js";',
        'import * as all from "./b.js";',
        "const me = await who();",
        "await begin();",
        "const here = import.meta.url;",
        'const one = import("./later.js").then((all) => all.one) + import("./b.js") + 1;',
        'void import( "./later.js");',
        "void import(`./later.js`);",
    ],
)
def test_another_style_is_refused(line: str) -> None:
    with pytest.raises(ValueError, match=r"live/a\.js cannot stand in a bundle"):
        taken_apart("live/a.js", f"const one = 1;\n{line}\n")


def test_what_is_loaded_later_runs_only_in_the_page_that_it_belongs_to() -> None:
    assert f'<meta name="vrts-made" content="{PAGE.made}">' in PAGE.html()
    later = [path for path in PAGE.paths if path not in PAGE.entries]
    assert "live/editor/workbench.js" in later
    for path in later:
        begins = re.sub(r"^import .*\n", "", PAGE.text(path), flags=re.M)
        assert begins.startswith("if (document.querySelector("), path
        assert PAGE.made in begins.splitlines()[0]
    assert all(PAGE.made not in PAGE.text(entry) for entry in PAGE.entries)


def test_other_modules_are_another_make(monkeypatch: pytest.MonkeyPatch) -> None:
    def longer(path: str) -> str:
        return f"{asset(path)}\n"

    assert Bundles("live/index.html").made == PAGE.made
    monkeypatch.setattr(bundles, "asset", longer)
    assert Bundles("live/index.html").made != PAGE.made


def test_modules_that_import_each_other_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    ring = {"live/a.js": ("live/b.js",), "live/b.js": ("live/c.js",), "live/c.js": ("live/b.js",)}

    def all_of_them(_entry: str) -> tuple[str, ...]:
        return tuple(ring)

    def nothing(_path: str) -> tuple[str, ...]:
        return ()

    def page(_path: str) -> str:
        return '<script type="module" src="/web/live/a.js">'

    monkeypatch.setattr(bundles, "imports", ring.__getitem__)
    monkeypatch.setattr(bundles, "closure", all_of_them)
    monkeypatch.setattr(bundles, "_later", nothing)
    monkeypatch.setattr(bundles, "asset", page)
    with pytest.raises(ValueError, match=r"live/b\.js imports live/c\.js imports live/b\.js"):
        Bundles("live/index.html").parts("live/a.js")


def _wanted(path: str) -> list[tuple[str, set[str]]]:
    taken = taken_apart(path, asset(path)).taken
    return [
        (source, {name.split(" as ")[0].strip() for name in names.split(",") if name.strip()})
        for names, source in taken
    ]
