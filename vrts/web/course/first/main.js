// The first entry: who has a personal link chooses a password.

import { byId, onSubmit, write } from "../../live/dom.js";
import { inText } from "../../live/names.js";
import { told } from "../people/asking.js";

const form = byId("first-form");
const code = location.hash.slice(1);
history.replaceState(null, "", location.pathname); // the link is of no use to who looks on, or back

/** @param {string} text */
function problem(text) {
  const place = byId("first-problem");
  place.hidden = !text;
  write(place, text);
}

async function begin() {
  if (code.length < 40) {
    problem("This link is not whole: open it once more, or ask your teacher for another.");
    return;
  }
  try {
    const { course, name, email } = await told("/course/letter", { code });
    document.title = `Choose a password · ${course} · vrts`;
    write(byId("first-title"), course);
    write(byId("first-who"), `You are ${inText(name)}. Later you log in as ${email || inText(name)}, with the password that you choose now.`);
    form.elements.user.value = email || name;
    form.hidden = false;
    form.elements.password.focus();
  } catch (error) {
    problem(/** @type {Error} */ (error).message);
  }
}

onSubmit(form, async () => {
  const { password, again } = form.elements;
  if (password.value !== again.value) {
    problem("The two passwords are not the same.");
    again.focus();
    return;
  }
  try {
    await told("/course/password", { code, password: password.value });
    location.assign("/");
  } catch (error) {
    problem(/** @type {Error} */ (error).message);
  }
});

// a whole link that comes into the address of this page, after half of one
window.addEventListener("hashchange", () => { if (location.hash.length > 1) location.reload(); });
void begin();
