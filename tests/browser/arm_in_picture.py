"""How much of the picture the arm takes, by the viewer's own projection."""

from typing import NamedTuple

from playwright.sync_api import Page

_MEASURE = """() => {
  const { viewer } = vrts.world, { camera, canvas } = viewer;
  camera.updateMatrixWorld();
  viewer.robot.group.updateMatrixWorld(true);
  const [W, H] = [canvas.clientWidth, canvas.clientHeight];
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  viewer.robot.group.traverse((part) => {
    if (!part.isMesh) return;
    const corners = part.geometry.attributes.position, corner = part.position.clone();
    for (let i = 0; i < corners.count; i++) {
      corner.fromBufferAttribute(corners, i).applyMatrix4(part.matrixWorld).project(camera);
      const at = [(corner.x + 1) / 2 * W, (1 - corner.y) / 2 * H];
      for (const k of [0, 1]) {
        box[k] = Math.min(box[k], at[k]);
        box[k + 2] = Math.max(box[k + 2], at[k]);
      }
    }
  });
  return { box, size: [W, H], page: [innerWidth, innerHeight] };
}"""


class InPicture(NamedTuple):
    """The arm's box, as shares."""

    of_picture: float  # area of the box that is seen, of the picture's
    height: float  # of the box that is seen, of the picture's
    of_page: float  # area of the box that is seen, of the whole page's
    picture_of_page: float  # area of the picture, of the page's
    cut: bool  # whether some of the arm is outside of the picture, but for its foot


def arm_in_picture(page: Page) -> InPicture:
    """Return how much of the picture the arm takes now."""
    found = page.evaluate(_MEASURE)
    (x0, y0, x1, y1), (wide, high) = found["box"], found["size"]
    seen_wide = max(min(x1, wide) - max(x0, 0.0), 0.0)
    seen_high = max(min(y1, high) - max(y0, 0.0), 0.0)
    whole = found["page"][0] * found["page"][1]
    area = seen_wide * seen_high
    return InPicture(
        area / (wide * high),
        seen_high / high,
        area / whole,
        wide * high / whole,
        x0 < 0.0 or x1 > wide or y0 < 0.0,
    )
