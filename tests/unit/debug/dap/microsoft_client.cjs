// Scenes of a debugging session, played by Microsoft's test client (@vscode/debugadapter-testsupport).
//
// node microsoft_client.cjs FOLDER VRTS SCENE PROGRAM: the folder of the client, the command vrts.
// What fails is thrown, so the exit status tells.

"use strict";

const assert = require("node:assert/strict");
const [folder, vrts, scene, program] = process.argv.slice(2);
const { DebugClient } = require(`${folder}/node_modules/@vscode/debugadapter-testsupport`);
const MOST_STEPS = 400;
const ROBOT = 1;
const PROCESS = 2;

/** Send a request that moves; return the body of the stop that follows. */
async function go(client, command, more = {}) {
  const stopped = client.waitForEvent("stopped");
  await client.send(command, { threadId: ROBOT, ...more });
  return (await stopped).body;
}

/** Begin as VS Code does; return the body of the first stop. */
async function launch(client, more = {}) {
  const stopped = client.waitForEvent("stopped");
  await Promise.all([client.configurationSequence(), client.launch({ program, ...more })]);
  return (await stopped).body;
}

/** What opens, with everything below it. */
async function opened(client, variablesReference) {
  if (!variablesReference) return [];
  const { variables } = (await client.variablesRequest({ variablesReference })).body;
  const found = [];
  for (const { name, value, variablesReference: below } of variables) {
    found.push([name, value, await opened(client, below)]);
  }
  return found;
}

/** Everything a user can look at: stacks of all threads, and all scopes of all frames. */
async function everything(client) {
  const found = [];
  for (const thread of (await client.threadsRequest()).body.threads) {
    for (const frame of (await client.stackTraceRequest({ threadId: thread.id })).body.stackFrames) {
      found.push([thread.name, frame.name, frame.line, frame.source.path]);
      for (const scope of (await client.scopesRequest({ frameId: frame.id })).body.scopes) {
        found.push([scope.name, await opened(client, scope.variablesReference)]);
      }
    }
  }
  return found;
}

/** The line at which a thread stands. */
async function line(client, threadId = ROBOT) {
  return (await client.stackTraceRequest({ threadId })).body.stackFrames[0].line;
}

/** The value of an expression. */
async function value(client, expression, more = {}) {
  return (await client.evaluateRequest({ expression, context: "watch", ...more })).body.result;
}

const scenes = {
  /** As many steps back as forward are the same state, all the way; so are the two ends. */
  async "forward and back"(client) {
    assert.equal((await launch(client)).reason, "entry");
    const known = [await everything(client)];
    for (let ended = false; !ended; ) {
      ended = (await go(client, "stepIn")).reason === "pause";
      known.push(await everything(client));
      assert.ok(known.length < MOST_STEPS, "it ends");
    }
    assert.ok(known.length > 10);
    for (let k = known.length - 2; k >= 0; k--) {
      await go(client, "stepBack");
      assert.deepEqual(await everything(client), known[k], `step ${k}`);
    }
    await client.setExceptionBreakpointsRequest({ filters: [] });
    assert.equal((await go(client, "continue")).reason, "pause");
    assert.deepEqual(await everything(client), known.at(-1));
    assert.equal((await go(client, "reverseContinue")).reason, "entry");
    assert.deepEqual(await everything(client), known[0]);
  },

  /** The first contact stops; the line that caused it is told; going on backward leaves it. */
  async contact(client) {
    await launch(client);
    assert.equal((await go(client, "continue")).reason, "exception");
    const info = (await client.exceptionInfoRequest({ threadId: ROBOT })).body;
    assert.equal(info.exceptionId, "contact");
    assert.match(info.description, /can1 touches base1.*line 11: APPROS base2_put, 60/);
    const there = await everything(client);
    await go(client, "stepBack", { granularity: "instruction" });
    assert.notDeepEqual(await everything(client), there);
    const { text } = await go(client, "continue");
    const said = info.description.split(";").slice(0, 2).join(";");
    assert.equal(text, `${said}; caused by line 11; the program is at line 12`);
    const { stackFrames } = (await client.stackTraceRequest({ threadId: ROBOT })).body;
    assert.deepEqual(stackFrames.slice(0, 2).map((frame) => frame.line), [11, 12]);
    assert.equal((await go(client, "reverseContinue")).reason, "entry");
    await client.setExceptionBreakpointsRequest({ filters: [] });
    assert.equal((await go(client, "continue")).reason, "pause");
  },

  /** The client's own check of a breakpoint: set before the launch is over, hit, at its line. */
  async breakpoint(client) {
    await client.hitBreakpoint({ program, stopOnEntry: false }, { path: program, line: 5 });
    assert.equal(await value(client, "n"), "0");
    await go(client, "next");
    await go(client, "stepIn");
    const { stackFrames } = (await client.stackTraceRequest({ threadId: ROBOT })).body;
    assert.deepEqual(stackFrames.map((frame) => frame.line), [15, 6]);
    const [inner, outer] = stackFrames.map((frame) => frame.id);
    assert.equal(await value(client, "a", { frameId: inner }), "1");
    await assert.rejects(value(client, "a", { frameId: outer }), /no value/);
    await go(client, "stepOut");
    assert.equal(await line(client), 7);
  },

  /** A value given at a stop makes another future; restart forgets it. */
  async "another future"(client) {
    const source = { path: program };
    await client.hitBreakpoint({ program, stopOnEntry: false }, { path: program, line: 5 });
    const frame = (await client.stackTraceRequest({ threadId: ROBOT })).body.stackFrames[0].id;
    const { scopes } = (await client.scopesRequest({ frameId: frame })).body;
    const { variablesReference } = scopes.find((scope) => scope.name === "Variables");
    const given = { variablesReference, name: "n", value: "1+2" };
    assert.equal((await client.setVariableRequest(given)).body.value, "3");
    assert.equal((await go(client, "continue")).reason, "pause");
    assert.equal(await value(client, "m"), "8");
    await go(client, "restart");
    assert.equal((await go(client, "continue")).reason, "breakpoint");
    assert.equal(await value(client, "n"), "0");
    const { targets } = (await client.gotoTargetsRequest({ source, line: 12 })).body;
    assert.equal((await go(client, "goto", { targetId: targets[0].id })).reason, "goto");
    assert.equal(await line(client), 12);
    const said = await client.evaluateRequest({ expression: "WHERE", context: "repl" });
    assert.match(said.body.result, /JT1/);
  },

  /** Variables and signals are watched in either direction, of both programs. */
  async changes(client) {
    await launch(client);
    for (const [name, text] of [["seen", "seen: 0 -> 1"], ["SIG(5)", "signal 5 is on"]]) {
      const { dataId } = (await client.dataBreakpointInfoRequest({ name })).body;
      await client.setDataBreakpointsRequest({ breakpoints: [{ dataId }] });
      const stop = await go(client, "continue");
      assert.deepEqual([stop.reason, stop.text], ["data breakpoint", text]);
      await go(client, "continue");
      assert.equal((await go(client, "reverseContinue")).text, text);
      await go(client, "reverseContinue");
    }
    const names = (await client.threadsRequest()).body.threads.map((thread) => thread.name);
    assert.deepEqual(names, ["robot program", "process control program"]);
    await go(client, "next", { threadId: PROCESS });
    assert.equal(await line(client, PROCESS), 20);
  },

  /** Without debugging it runs to its end, writes what it writes, and is over. */
  async "without debugging"(client) {
    const over = [client.waitForEvent("exited"), client.waitForEvent("terminated")];
    const written = client.assertOutput("stdout", "done 8\n");
    await Promise.all([client.configurationSequence(), client.launch({ program, noDebug: true })]);
    assert.equal((await over[0]).body.exitCode, 0);
    await Promise.all([over[1], written]);
  },
};

async function main() {
  const client = new DebugClient(vrts, "dap", "vrts");
  client.defaultTimeout = 60_000;
  await client.start();
  const adapter = client._adapterProcess;
  const gone = new Promise((resolve) => adapter.on("exit", resolve));
  try {
    await scenes[scene](client);
    await client.disconnectRequest();
    assert.equal(await gone, 0, "the adapter ends by itself");
  } finally {
    adapter.kill();
  }
}

main().catch((problem) => {
  console.error(problem);
  process.exit(1);
});
