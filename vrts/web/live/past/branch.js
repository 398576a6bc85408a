// A room of one's own that goes on from a moment of the past.

/**
 * Ask for such a room and enter it.
 * @param {string} room @param {number} at_s session time [s] @param {import("../toasts.js").Toasts} toasts
 */
export async function goOnFrom(room, at_s, toasts) {
  const answer = await fetch("/branch", {
    method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify({ room, at_s }),
  });
  const said = await answer.json();
  if (!answer.ok) {
    toasts.warn(said.help ? `${said.text}; ${said.help}` : said.text);
    return;
  }
  const url = new URL(location.href);
  url.searchParams.set("room", said.room);
  location.assign(url);
}
