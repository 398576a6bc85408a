// The page in front of the rooms: class code and name, or an account.

import { enter, howIn, logIn } from "../account.js";
import { byId, onSubmit, write } from "../dom.js";

const CODE = 39; // characters of a class code at most; a link has more

let ready = false;

/** @param {string} problem to be shown at once; empty: none @param {string} token that wants a name with it */
export function showDoor(problem, token) {
  byId("enter").hidden = false;
  document.title = "Enter · vrts";
  tell(problem);
  const link = token.length > CODE;
  byId("enter-code").parentElement.hidden = link;
  byId("enter-link").hidden = !link;
  if (token) byId("enter-code").value = token;
  byId(byId("enter-code").value ? "enter-name" : "enter-code").focus();
  if (ready) return;
  ready = true;
  void ways();
  const form = byId("enter-form");
  onSubmit(form, () => attempt(enter(form.elements.code.value.trim(), form.elements.name.value.trim())));
  const account = byId("login-form");
  onSubmit(account, () => attempt(logIn(account.elements.user.value, account.elements.password.value)));
}

/** Offer the ways in that there are: with a course, log-in may be the only one. */
async function ways() {
  const { guests, title, provider } = await howIn();
  if (title) write(byId("enter-title"), title);
  const there = byId("enter-provider");
  there.hidden = !provider;
  write(there, provider);
  byId("enter-form").hidden = !guests && byId("enter-code").value.length <= CODE; // a supervisor's link works still
  const account = byId("enter-account");
  if (guests) return;
  account.open = true;
  write(byId("enter-account-words"), "Log in with e-mail address and password");
  byId("enter-lost").hidden = false;
  if (byId("enter-form").hidden) byId(provider ? "enter-provider" : "enter-user").focus();
}

/** @param {Promise<import("../account.js").Me>} entering */
async function attempt(entering) {
  try {
    document.dispatchEvent(new CustomEvent("entered", { detail: await entering }));
  } catch (error) {
    tell(/** @type {Error} */ (error).message);
  }
}

/** @param {string} text */
function tell(text) {
  const place = byId("enter-problem");
  place.hidden = !text;
  place.textContent = text;
}
