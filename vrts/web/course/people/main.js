// The people of a course: for teachers, who add others who teach and give out new links.

import { button, byId, make, onSubmit, write } from "../../live/dom.js";
import { settle } from "../../live/focus.js";
import { isolated } from "../../live/names.js";
import { when } from "../work/words.js";
import { asked, told } from "./asking.js";

const EVERY = 5_000; // [ms]
const WAYS = { password: "password", provider: "log-in elsewhere", link: "a link, not used yet", none: "nothing yet: give them a link" };

/**
 * @typedef {{account: number, name: string, email: string, rank: string, rooms: string[], team: string, seen: number, here: boolean,
 *   way: "password"|"provider"|"link"|"none", listed: boolean, origin: string}} Row
 * @typedef {{title: string, fault: string, rooms: string[], people: Row[]}} People
 */

const find = byId("people-find");
const form = byId("people-add");
let shown = "";
/** @type {People | null} */
let now = null;

function draw() {
  if (!now) return;
  const { title, people } = now;
  document.title = `People · ${title} · vrts`;
  write(byId("people-title"), `${title}: people`);
  const words = find.value.trim().toLowerCase();
  const fits = people.filter(({ name, email, team, rank }) => `${name} ${email} ${team} ${rank}`.toLowerCase().includes(words));
  const order = ["teacher", "assistant", "student"];
  fits.sort((a, b) => Number(b.listed) - Number(a.listed) || order.indexOf(a.rank) - order.indexOf(b.rank) || a.name.localeCompare(b.name));
  write(byId("people-count"), fits.length === people.length ? `${people.length} people` : `${fits.length} of ${people.length} people`);
  settle(byId("people-rows"), fits.map(row));
}

/** @param {Row} person */
function row(person) {
  const { account, name, email, rank, rooms, team, seen, here, way, listed, origin } = person;
  const leads = rank === "assistant" ? ` in ${rooms.length ? rooms.join(", ") : "all rooms"}` : "";
  const is = listed ? `${rank}${leads}` : "on no list any more: does not come in";
  const last = here ? make("span", { class: "people-here", text: "here now" }) : seen ? when(seen) : "never";
  const acts = listed ? [button("New link", () => void attempt(link(account)), { "aria-label": `New link for ${name}` })] : [];
  if (listed && origin === "page") acts.push(button("End", () => void attempt(end(account)), { "aria-label": `End for ${name}`, title: "Let them in no more" }));
  return make("tr", { "data-key": String(account), class: listed ? "" : "away" },
    make("th", { scope: "row" }, isolated(name), ...(origin === "page" ? [make("span", { class: "tag", text: "added here" })] : [])),
    make("td", { class: "people-mail" }, make("bdi", {}, ...address(email))), make("td", { text: is }), make("td", { "data-of": "Team" }, make("bdi", { text: team })),
    make("td", { "data-of": "Was here last" }, last), make("td", { "data-of": "Comes in by" }, listed ? WAYS[way] : ""), make("td", { class: "people-acts" }, ...acts));
}

/** Return an address that breaks before its signs, where it has to. @param {string} email */
function address(email) {
  return email.split(/(?=[@.])/).flatMap((part, index) => (index ? [document.createElement("wbr"), part] : [part]));
}

/** @param {number} account */
async function link(account) {
  give(await told("/course/people/link", { account }));
}

/** @param {number} account */
async function end(account) {
  await told("/course/people/end", { account });
}

/** @param {{name: string, url: string}} made */
function give({ name, url }) {
  write(byId("people-new-name"), name);
  byId("people-new-url").value = url;
  const box = byId("people-new");
  box.hidden = false;
  box.focus();
}

/** @param {Promise<void>} doing */
async function attempt(doing) {
  try {
    await doing;
    problem("");
  } catch (error) {
    problem(/** @type {Error} */ (error).message);
  }
  await look();
}

/** @param {string} text */
function problem(text) {
  const place = byId("people-problem");
  place.hidden = !text;
  write(place, text);
}

async function look() {
  try {
    /** @type {People} */
    const found = await asked("/course/people/list");
    const text = JSON.stringify(found);
    if (text === shown) return;
    const fault = now?.fault ?? "";
    shown = text;
    now = found;
    byId("people-list").hidden = byId("people-more").hidden = false; // nothing to fill in for who may not
    if (found.fault) problem(`The files of the course are faulty, so people stay as they were: ${found.fault}`);
    else if (fault) problem("");
    rooms(found.rooms);
    draw();
  } catch (error) {
    problem(/** @type {Error} */ (error).message);
  }
}

/** @param {string[]} names */
function rooms(names) {
  const place = byId("people-rooms");
  const there = [...place.querySelectorAll("input")].map(({ value }) => value);
  if (there.join("\n") === names.join("\n")) return;
  for (const old of place.querySelectorAll("label")) old.remove();
  place.append(...names.map((name) => make("label", {}, make("input", { type: "checkbox", name: "room", value: name }), make("bdi", { text: name }))));
}

find.addEventListener("input", draw);
form.elements.rank.addEventListener("change", () => { byId("people-rooms").hidden = form.elements.rank.value !== "assistant"; });
byId("people-new-copy").addEventListener("click", () => {
  byId("people-new-url").select();
  void navigator.clipboard?.writeText(byId("people-new-url").value);
});
onSubmit(form, () => void attempt((async () => {
  const ticked = [...form.querySelectorAll("input[name=room]:checked")].map((one) => /** @type {HTMLInputElement} */ (one).value);
  const rank = form.elements.rank.value;
  const made = await told("/course/people/add", {
    name: form.elements.name.value, email: form.elements.email.value, rank, rooms: rank === "assistant" ? ticked : [],
  });
  form.reset();
  byId("people-rooms").hidden = true;
  give(made);
})()));

window.setInterval(() => { if (!document.hidden) void look(); }, EVERY);
void look();
