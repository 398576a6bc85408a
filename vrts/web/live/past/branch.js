// A room of one's own that goes on from a moment of the past.

/**
 * Ask for such a room and enter it.
 * @param {import("../connection.js").Connection} connection @param {number} at_s session time [s]
 */
export async function goOnFrom(connection, at_s) {
  const { room } = await connection.ask("go_on_from", { at_s });
  const url = new URL(location.href);
  url.searchParams.set("room", room);
  history.replaceState(null, "", url);
  connection.enter(room);
}
