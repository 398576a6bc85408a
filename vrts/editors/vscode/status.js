// The mark of the program that is being edited, in the status bar: live, with the reasons.

"use strict";

const vscode = require("vscode");

const LANGUAGE = "val2";

/** One item of the status bar, about the program in front. */
class Status {
  /** @param {any} context of the extension */
  constructor(context) {
    this.item = vscode.window.createStatusBarItem("vrts.mark", vscode.StatusBarAlignment.Left, 50);
    this.item.name = "VAL-II: mark and readiness";
    this.item.command = "vrts.showArm";
    /** @type {Map<string, any>} */
    this.known = new Map(); // by program
    context.subscriptions.push(
      this.item,
      vscode.window.onDidChangeActiveTextEditor(() => this.show()),
      vscode.languages.onDidChangeDiagnostics(() => this.show()),
      vscode.workspace.onDidChangeTextDocument(() => this.show()),
      vscode.workspace.onDidCloseTextDocument((/** @type {any} */ document) => this.known.delete(String(document.uri))),
    );
    this.show();
  }

  /** Take what the language server tells of a program. @param {any} told */
  told(told) {
    const before = this.known.get(String(vscode.Uri.parse(told.uri)));
    const shown = told.shown || (before && before.version === told.version ? before.shown : undefined);
    this.known.set(String(vscode.Uri.parse(told.uri)), { version: told.version, whole: told.whole, shown });
    this.show();
  }

  show() {
    const editor = vscode.window.activeTextEditor;
    if (!editor) return; // a panel is in front: the mark stays that of the program beside it
    if (editor.document.languageId !== LANGUAGE) return this.item.hide();
    const { text, tooltip, bad } = this.words(editor.document);
    this.item.text = text;
    this.item.tooltip = tooltip;
    this.item.backgroundColor = bad ? new vscode.ThemeColor("statusBarItem.warningBackground") : undefined;
    this.item.accessibilityInformation = { label: `${text.replace(/\$\([^)]*\)\s*/g, "")}. ${tooltip}` };
    this.item.show();
  }

  /** @param {any} document */
  words(document) {
    const errors = vscode.languages.getDiagnostics(document.uri)
      .filter((/** @type {any} */ one) => one.source === "vrts" && one.severity === vscode.DiagnosticSeverity.Error);
    if (errors.length) return { text: "$(error) does not compile", tooltip: errors[0].message, bad: true };
    const known = this.known.get(String(document.uri));
    const shown = known && known.shown;
    if (known && known.version === document.version && !shown && known.whole) {
      return { text: "$(circle-slash) not run", tooltip: "This program is not run by itself.", bad: false };
    }
    if (!shown) return { text: "$(sync~spin) verifying", tooltip: "The program is being verified beside the editor.", bad: false };
    const old = known.version !== document.version;
    const mark = shown.mark ? `${shown.mark}${shown.settled ? "" : " at most"} · ` : "";
    const answer = shown.ready ? "ready" : `not ready: ${shortened(shown.reasons[0] || "")}`;
    const icon = old ? "$(sync~spin)" : shown.ready ? "$(check)" : "$(warning)";
    const lines = [shown.cause, ...shown.reasons.map((/** @type {string} */ reason) => `• ${reason}`)];
    if (shown.ready) lines.push(`Ready for the real robot in ${shown.readyIn}.`);
    if (!shown.settled) lines.push("The task asks for every future, which `vrts verify` looks at: the mark may be lower.");
    if (old) lines.push("Of the text before; the present one is being verified.");
    return { text: `${icon} ${mark}${answer}`, tooltip: lines.filter(Boolean).join("\n"), bad: !shown.ready && !old };
  }
}

/** @param {string} text */
function shortened(text) {
  return text.length > 60 ? `${text.slice(0, 59)}…` : text;
}

module.exports = { Status };
