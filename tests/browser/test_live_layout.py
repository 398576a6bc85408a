"""The page's parts beside each other, in a real browser: the picture first, borders, folds."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.browser.arm_in_picture import arm_in_picture
from tests.browser.support_sessions import SHOWN, Desk, student
from tests.support_live import LiveServer

pytestmark = pytest.mark.browser

LOOK = "document.querySelector('[data-look][aria-pressed=true]')?.dataset.look"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("live")) as server:
        yield server


@pytest.fixture(scope="module")
def anna(browser: Browser, server: LiveServer) -> Iterator[Desk]:
    desk = student(browser, server, "Anna")
    desk.page.set_viewport_size({"width": 1366, "height": 768})
    again(desk)
    yield desk
    assert desk.complaints() == []
    desk.context.close()


def again(desk: Desk) -> None:
    desk.page.reload()
    desk.until(SHOWN)
    desk.until(f"{LOOK} !== undefined")


def width(desk: Desk, id_: str) -> int:
    return round(desk.value(f"document.getElementById('{id_}').getBoundingClientRect().width"))


def height(desk: Desk, id_: str) -> int:
    return round(desk.value(f"document.getElementById('{id_}').getBoundingClientRect().height"))


def unfolded(desk: Desk) -> None:
    """Show the panels, whatever was done before."""
    if not width(desk, "desk"):
        desk.page.click("#fold-desk")


def drag(desk: Desk, id_: str, by: tuple[int, int]) -> None:
    box = desk.page.locator(f"#{id_}").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    desk.page.mouse.move(x, y)
    desk.page.mouse.down()
    desk.page.mouse.move(x + by[0] / 2, y + by[1] / 2)
    desk.page.mouse.move(x + by[0], y + by[1])
    desk.page.mouse.up()


@pytest.mark.thorough
def test_the_first_screen_belongs_to_the_arm(anna: Desk) -> None:
    assert anna.value(LOOK) == "table"
    seen = arm_in_picture(anna.page)
    assert not seen.cut
    assert seen.picture_of_page > 0.42
    assert seen.height > 0.8
    assert seen.of_picture > 0.09
    # before the picture had a bar above it, in Overview: 0.026
    assert seen.of_page > 0.04
    covered = anna.value(
        """(() => { const view = document.getElementById("canvas").getBoundingClientRect();
        return [...document.querySelectorAll(".floor button, .border")].filter((one) => {
          const box = one.getBoundingClientRect();
          return box.width && box.left < view.right && box.right > view.left
            && box.top < view.bottom && box.bottom > view.top; }).map((one) => one.id); })()"""
    )
    assert covered == []


@pytest.mark.thorough
def test_borders_move_by_mouse_and_by_keys_and_are_remembered(anna: Desk) -> None:
    desk, terminal, picture = (
        width(anna, "desk"),
        height(anna, "terminal-place"),
        width(anna, "view"),
    )
    drag(anna, "desk-border", (-80, 0))
    assert width(anna, "desk") == desk + 80
    assert width(anna, "view") == picture - 80
    drag(anna, "terminal-border", (0, -50))
    assert height(anna, "terminal-place") == terminal + 50
    anna.page.focus("#desk-border")
    anna.page.keyboard.press("ArrowRight")
    anna.page.keyboard.press("Shift+ArrowLeft")
    assert width(anna, "desk") == desk + 80 - 16 + 64
    anna.page.focus("#terminal-border")
    anna.page.keyboard.press("ArrowDown")
    assert height(anna, "terminal-place") == terminal + 34
    said = anna.page.get_attribute("#desk-border", "aria-valuenow")
    assert said == str(desk + 128)
    anna.page.click("[data-look=front]")
    again(anna)
    assert (width(anna, "desk"), height(anna, "terminal-place")) == (desk + 128, terminal + 34)
    assert anna.value(LOOK) == "front"
    anna.page.focus("#desk-border")
    anna.page.keyboard.press("End")
    assert width(anna, "view") >= 320, "the picture keeps its place"
    anna.page.keyboard.press("Home")
    assert width(anna, "desk") == 320


@pytest.mark.thorough
def test_parts_fold_by_button_and_by_key(anna: Desk) -> None:
    page = anna.page
    page.click("#fold-desk")
    assert width(anna, "desk") == 0
    assert page.get_attribute("#fold-desk", "aria-expanded") == "false"
    assert page.get_attribute("#desk-border", "aria-valuetext") == "folded"
    page.click("#desk-border")
    assert width(anna, "desk") == 0, "a click alone moves nothing"
    page.keyboard.press("Alt+t")
    assert height(anna, "terminal-place") == 0
    again(anna)
    assert (width(anna, "desk"), height(anna, "terminal-place")) == (0, 0)
    page.keyboard.press("Alt+m")
    assert height(anna, "terminal-place") > 0, "who wants to type sees where"
    page.focus("#desk-border")
    page.keyboard.press("Enter")
    assert width(anna, "desk") >= 320
    page.keyboard.press("Alt+p")
    page.keyboard.press("Alt+p")
    assert width(anna, "desk") >= 320


@pytest.mark.thorough
@pytest.mark.parametrize(
    "kept",
    [
        "{",
        "null",
        '{"version":99,"desk":500}',
        '{"version":1,"desk":"wide","terminal":1e9,"deskFolded":1,"look":"<b>"}',
        "x" * 10_000,
    ],
)
def test_what_is_no_layout_does_no_harm(anna: Desk, kept: str) -> None:
    read = f"import('/web/live/layout/kept.js').then(m => m.layoutFrom({kept!r}))"
    first = "import('/web/live/layout/kept.js').then(m => m.firstLayout())"
    assert anna.value(read) == anna.value(first)


@pytest.mark.thorough
def test_a_browser_without_storage_shows_the_page(anna: Desk) -> None:
    anna.page.add_init_script(
        """for (const name of ["getItem", "setItem"]) {
        const before = Storage.prototype[name];
        Storage.prototype[name] = function (key, ...rest) {
          if (key === "vrts layout") throw new DOMException("no", "SecurityError");
          return before.call(this, key, ...rest); }; }"""
    )
    again(anna)
    assert anna.value(LOOK) == "table"
    anna.page.click("#fold-desk")
    assert width(anna, "desk") == 0


NARROW = (1366, 1024, 768, 390)
CHOICES = ("past-jump", "past-span", "past-speed")


def test_the_time_line_keeps_its_choices_at_every_width(anna: Desk) -> None:
    page = anna.page
    anna.until("document.getElementById('past-menu') !== null")
    for wide in NARROW:
        page.set_viewport_size({"width": wide, "height": 768 if wide > 768 else 900})
        if wide < 800:
            assert not page.is_visible("#past-jump"), wide
        if not page.is_visible("#past-jump"):
            page.press("#past-menu", "Enter")
            page.locator("#past-jump").wait_for(state="visible")
        for id_ in CHOICES:
            box = page.locator(f"#{id_}").bounding_box()
            assert box is not None, (wide, id_)
            assert box["x"] >= 0, (wide, id_)
            assert box["x"] + box["width"] <= wide, (wide, id_)
        assert page.locator(".past .past-branch:visible").count() == 1, wide
        page.keyboard.press("Escape")
        anna.until("document.querySelector('.menu:popover-open') === null")
        assert width(anna, "past-time") > 200, "there is something to drag"
    page.set_viewport_size({"width": 1366, "height": 768})


CAMERA = "vrts.world.viewer.camera.position.toArray()"
LOOKED_AT = "vrts.world.viewer.controls.target.toArray()"


@pytest.mark.thorough
def test_the_camera_goes_by_keys_and_by_buttons_as_by_dragging(anna: Desk) -> None:
    page = anna.page
    page.set_viewport_size({"width": 1366, "height": 768})
    page.click("[data-look=front]")
    page.focus("#view")
    _, _, low = anna.value(CAMERA)
    page.keyboard.press("ArrowUp")
    high: list[float] = anna.value(CAMERA)
    assert high[2] > low + 0.1
    before: list[float] = anna.value(LOOKED_AT)
    page.keyboard.press("Shift+ArrowRight")
    after: list[float] = anna.value(LOOKED_AT)
    assert after[1] > before[1] + 0.05  # from the front, right is +Y
    assert after[2] == pytest.approx(before[2])
    page.click("#camera-button")
    page.click("[data-move='Shift ArrowLeft']")
    assert anna.value(LOOKED_AT) == pytest.approx(before)
    page.click("[data-move=ArrowDown]")
    assert anna.value(CAMERA)[2] == pytest.approx(low)
    for _ in range(20):
        page.click("[data-move=ArrowUp]")
    assert anna.value(f"{CAMERA}.concat({LOOKED_AT}).every(Number.isFinite)")
    page.keyboard.press("Escape")


FOCUS = """async (steps) => {
  const { settle, enable } = await import("/web/live/focus.js");
  const place = document.createElement("ul");
  document.getElementById("panel-pendant").append(place);
  const row = (name) => {
    const made = document.createElement("li");
    made.dataset.key = name;
    for (const textContent of ["Give", "Mute"]) {
      made.append(Object.assign(document.createElement("button"), { textContent }));
    }
    return made;
  };
  const draw = (names) => settle(place, names.map(row));
  const again = () => new Promise((done) => setTimeout(done));
  const where = () => {
    const { activeElement: at } = document;
    return `${at.closest("li")?.dataset.key} ${at.textContent}`.slice(0, 20);
  };
  const found = [];
  draw(["ada", "ben", "cas"]);
  place.children[1].lastChild.focus();
  const same = document.activeElement;
  draw(["new", "ada", "ben", "cas"]);
  found.push(where(), same === document.activeElement);
  draw(["cas", "ben", "ada"]);  // it moves
  await again();
  found.push(where());
  place.replaceChildren(...["new", "ada", "ben"].map(row));  // all are made anew
  await again();
  found.push(where());
  draw(["new", "ada"]);  // it goes: the row before it
  await again();
  found.push(where());
  const one = document.activeElement;
  enable(one, false);
  found.push(document.activeElement === one, one.disabled, one.getAttribute("aria-disabled"));
  let pressed = 0;
  one.addEventListener("click", () => pressed++);
  one.click();
  place.firstChild.firstChild.focus();
  await again();
  found.push(pressed, one.disabled, one.getAttribute("aria-disabled"));
  document.activeElement.disabled = true;  // by whoever does not ask
  await again();
  found.push(where());
  place.remove();
  await again();
  found.push(document.activeElement !== document.body);
  return found;
}"""


def test_the_keyboard_stays_where_it_is_when_rows_are_drawn_again(anna: Desk) -> None:
    unfolded(anna)
    anna.page.click("#tab-pendant")
    found = anna.page.evaluate(FOCUS)
    assert found == [
        *("ben Mute", True, "ben Mute", "ben Mute", "ada Mute"),
        *(True, False, "true", 0, True, None),
        *("new Mute", True),
    ]


def test_the_pointer_snaps_to_objects_and_two_points_are_measured(anna: Desk) -> None:
    page = anna.page
    unfolded(anna)
    page.click("#tab-pointer")
    anna.until("document.getElementById('snap-place')?.options.length > 2")
    page.select_option("#snap-place", "can1_grip")
    page.click("[aria-label='Put the pointer at the place']")
    x = "document.querySelector('[data-number=X]').value"
    anna.until(f"{x} === '800.00'")
    z = float(page.input_value("[data-number=Z]").replace("−", "-"))
    page.click("[aria-label='Put the pointer 50 mm above the place']")
    anna.until(f"Math.abs(+{x.replace('X', 'Z')}.replace('−', '-') - {z + 50}) < 0.02")
    select = "import('/web/live/selection.js').then((m) => m.select('can2'))"
    page.evaluate(select)
    anna.until(f"{x} === '750.00'")
    page.click("text=Measure")
    page.select_option("#measure-from", "body base1")
    page.select_option("#measure-to", "body base2")
    assert page.inner_text("#measured") == "390.0 mm: dx 150.0, dy 360.0, dz 0.0"
    page.click("[aria-label='Pick in the picture: To']")
    box = page.locator("#canvas").bounding_box()
    assert box is not None
    page.click("[data-look=top]")
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    anna.until("document.getElementById('measure-to').value === 'clicked'")
    assert "mm: dx" in page.inner_text("#measured")
