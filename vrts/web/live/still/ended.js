// The end of the first picture: told by who knows that it shows what is now no more.

const ENDED = "still ended";
const UNREADY = "unready"; // class of a page whose parts do not work yet

/** All that the page shows works from now on. */
export function readyNow() {
  document.body.classList.remove(UNREADY);
}

/** The page shows parts that do not work yet. */
export function notReady() {
  document.body.classList.add(UNREADY);
}

/** The 3D view shows what is now, or there is nothing to be shown. */
export function endStill() {
  document.dispatchEvent(new CustomEvent(ENDED));
}

/** @param {() => void} tell */
export function onStillEnd(tell) {
  document.addEventListener(ENDED, tell, { once: true });
}
