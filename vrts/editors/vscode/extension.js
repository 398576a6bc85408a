// VAL-II in VS Code: `vrts lsp` tells what is wrong while you type, `vrts dap` debugs; the arm stands
// beside the text, and the mark in the status bar.
//
// Programs are run by the command of the setting `vrts.path`, which a workspace cannot change.

"use strict";

const vscode = require("vscode");
const { Beside, shows } = require("./beside.js");
const { Status } = require("./status.js");
const { LanguageClient } = require("./vendor/languageclient.js");

const LANGUAGE = "val2";
const SETTINGS = ["**/{scene,task,lab,scenario,environment,columns}.toml", "**/*-{lab,scenario,environment,columns}.toml"]
  .map((pattern) => ({ scheme: "file", pattern }));
/** @type {any} */
let client;
/** @type {Beside | undefined} */
let beside;

/** The command to start. */
function command() {
  return vscode.workspace.getConfiguration("vrts").get("path") || "vrts";
}

/** The program that a command is about: that of an argument, else the one being edited. */
function programOf(/** @type {any} */ argument) {
  if (argument instanceof vscode.Uri) return argument.fsPath;
  if (typeof argument === "string") return vscode.Uri.parse(argument).fsPath;
  const editor = vscode.window.activeTextEditor;
  return editor && editor.document.languageId === LANGUAGE ? editor.document.uri.fsPath : undefined;
}

/** What is to be shown: the same, or the scene or task that is being edited. */
function shownOf(/** @type {any} */ argument) {
  const editor = vscode.window.activeTextEditor;
  return programOf(argument) || (editor && shows(editor.document) ? editor.document.uri.fsPath : undefined);
}

/**
 * Run a command of vrts on a file, in the terminal panel; no shell reads its name.
 * @param {string} word @param {any} argument @param {any} entry the program of the file, if one is meant
 */
async function inTerminal(word, argument, entry) {
  const program = programOf(argument);
  if (!program) return;
  await vscode.workspace.saveAll(false);
  const which = typeof entry === "string" ? ["--entry", entry] : [];
  const execution = new vscode.ProcessExecution(command(), [word, program, ...which]);
  const scope = vscode.TaskScope.Workspace;
  const task = new vscode.Task({ type: "vrts", command: word }, scope, word, "vrts", execution);
  await vscode.tasks.executeTask(task);
}

/**
 * Debug a file.
 * @param {any} argument @param {any} entry the program of the file, if one is meant
 */
async function debug(argument, entry) {
  const program = programOf(argument);
  if (!program) return;
  const folder = vscode.workspace.getWorkspaceFolder(vscode.Uri.file(program));
  const wish = { type: "vrts", request: "launch", name: "Debug", program, stopOnEntry: true };
  await vscode.debug.startDebugging(folder, typeof entry === "string" ? { ...wish, entry } : wish);
}

/**
 * Let the arm go one set point forward or back, which is less than a step of the program.
 * @param {number} count
 */
async function tick(count) {
  const session = vscode.debug.activeDebugSession;
  if (!session || session.type !== "vrts") return;
  await session.customRequest("vrts.tick", { count });
}

/** A configuration without a program is about the one being edited. */
const configurations = {
  resolveDebugConfiguration(/** @type {any} */ _folder, /** @type {any} */ config) {
    const complete = { type: "vrts", request: "launch", name: "Debug", ...config };
    complete.program = complete.program || programOf(undefined);
    return complete.program ? complete : undefined;
  },
};

const adapters = {
  createDebugAdapterDescriptor() {
    return new vscode.DebugAdapterExecutable(command(), ["dap"]);
  },
};

/** VS Code itself says nothing when a debugger cannot be started. */
const trackers = {
  createDebugAdapterTracker(/** @type {any} */ session) {
    let answered = false;
    const listen = beside && beside.listener(session);
    return {
      onDidSendMessage(/** @type {any} */ message) {
        answered = true;
        if (listen) listen(message);
      },
      onError(/** @type {any} */ problem) {
        if (!answered) warn(problem);
        answered = true;
      },
    };
  },
};

/** What the names of a line stand for where the debugger stands, behind the line. */
const inlineValues = {
  async provideInlineValues(/** @type {any} */ document, /** @type {any} */ range, /** @type {any} */ context) {
    const session = vscode.debug.activeDebugSession;
    if (!session || session.type !== "vrts") return [];
    const asked = { path: document.uri.fsPath, frameId: context.frameId, first: range.start.line + 1, last: range.end.line + 1 };
    const found = await session.customRequest("vrts.inline", asked);
    return found.values
      .filter((/** @type {any} */ one) => one.line <= document.lineCount)
      .map((/** @type {any} */ one) => new vscode.InlineValueText(document.lineAt(one.line - 1).range, one.text));
  },
};

/** Show the arm beside a program. */
async function showArm(/** @type {any} */ argument) {
  const program = shownOf(argument);
  if (!program || !beside) return;
  const open = vscode.workspace.textDocuments.find((/** @type {any} */ one) => one.uri.fsPath === program);
  await beside.show(open ? open.uri : vscode.Uri.file(program));
}

/** Ask the language server; nothing where it is not there. */
async function ask(/** @type {string} */ method, /** @type {unknown} */ params) {
  return client && client.isRunning() ? client.sendRequest(method, params) : undefined;
}

/** Keys and what they mean come from Even Better TOML where that is there: it has our schemas. */
const middleware = {
  provideCompletionItem: (/** @type {any} */ document, /** @type {any} */ ...rest) => helped(document, rest),
  provideHover: (/** @type {any} */ document, /** @type {any} */ ...rest) => helped(document, rest),
};

/** @param {any} document @param {any[]} rest */
function helped(document, rest) {
  const others = document.languageId !== LANGUAGE && vscode.extensions.getExtension("tamasfe.even-better-toml");
  return others ? undefined : rest[rest.length - 1](document, ...rest.slice(0, -1));
}

/** Say that vrts cannot be started. */
function warn(/** @type {any} */ problem) {
  const why = `${command()} cannot be started (${problem.message || problem})`;
  void vscode.window.showWarningMessage(`Is vrts[ide] installed, and named by the setting vrts.path? ${why}`);
}

exports.activate = async function activate(/** @type {any} */ context) {
  beside = new Beside(context, ask);
  const status = new Status(context);
  context.subscriptions.push(
    vscode.debug.registerDebugAdapterDescriptorFactory("vrts", adapters),
    vscode.debug.registerDebugAdapterTrackerFactory("vrts", trackers),
    vscode.debug.registerDebugConfigurationProvider("vrts", configurations),
    vscode.languages.registerInlineValuesProvider({ language: LANGUAGE }, inlineValues),
    vscode.commands.registerCommand("vrts.run", (file, entry) => inTerminal("run", file, entry)),
    vscode.commands.registerCommand("vrts.verify", (file, entry) => inTerminal("verify", file, entry)),
    vscode.commands.registerCommand("vrts.debug", debug),
    vscode.commands.registerCommand("vrts.showArm", showArm),
    vscode.commands.registerCommand("vrts.tickBack", () => tick(-1)),
    vscode.commands.registerCommand("vrts.tickForward", () => tick(1)),
  );
  const server = { command: command(), args: ["lsp"] };
  const documents = [{ language: LANGUAGE, scheme: "file" }, { language: LANGUAGE, scheme: "untitled" }, ...SETTINGS];
  const initializationOptions = { commands: ["vrts.run", "vrts.verify", "vrts.debug"] }; // of the editor's own
  client = new LanguageClient("vrts", "VAL-II", server, { documentSelector: documents, initializationOptions, middleware });
  client.onNotification("vrts/shown", (/** @type {any} */ told) => {
    status.told(told);
    if (beside && (told.shown || told.scene) && String(beside.uri) === String(vscode.Uri.parse(told.uri))) void beside.refresh();
  });
  try {
    await client.start();
    await client.sendNotification("vrts/beside", {});
  } catch (problem) {
    client = undefined;
    warn(problem);
  }
};

exports.deactivate = function deactivate() {
  return client ? client.stop() : undefined;
};
