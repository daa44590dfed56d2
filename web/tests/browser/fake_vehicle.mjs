// A server that speaks the live protocol without a vehicle: it sends what a test wants and records what it receives. It
// stages what a simulated vehicle cannot do on demand: another client drives, data grow old, the network fails.
import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { extname, join } from "node:path";
import { parse } from "@foxglove/rosmsg";
import { ros2humble } from "@foxglove/rosmsg-msgs-common";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import protocol from "@foxglove/ws-protocol";
import { WebSocketServer } from "ws";

const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };

/** /live/state of a waiting vehicle. */
const idle_state = JSON.parse(readFileSync(new URL("../idle_state.json", import.meta.url), "utf8"));

/** The schema of a type with the types that it contains, as in a session. */
function schema_of(type) {
  const needed = new Map();
  const add = (name) => {
    if (needed.has(name)) return;
    const { definitions } = ros2humble[name];
    needed.set(name, definitions);
    for (const field of definitions) if (field.isComplex && !field.isConstant) add(field.type);
  };
  add(type);
  const line = ({ type, name, isArray, arrayLength, isConstant, valueText }) =>
    isConstant ? `${type} ${name}=${valueText}` : `${type}${isArray ? `[${arrayLength ?? ""}]` : ""} ${name}`;
  const text = (definitions) => definitions.map(line).join("\n");
  return [...needed]
    .map(([name, definitions], index) =>
      index === 0 ? text(definitions) : `${"=".repeat(80)}\nMSG: ${name}\n${text(definitions)}`,
    )
    .join("\n");
}

export class FakeVehicle {
  drives = [];
  calls = [];
  answers = {};
  /** Files by path, as JSON. A posted building is stored as NAME-2. */
  files = {};
  posts = [];
  state = { ...idle_state };
  #channels = new Map();
  #latest = new Map();
  #http;
  #sockets;
  #server;
  #beat;

  constructor(page_directory) {
    this.#http = createServer((request, response) => {
      const path = new URL(request.url, "http://localhost").pathname;
      if (request.method === "POST") this.#store(path, request, response);
      else if (path in this.files) response.writeHead(200).end(JSON.stringify(this.files[path]));
      else this.#serve(join(page_directory, path === "/" ? "index.html" : path), response);
    });
  }

  #serve(file, response) {
    try {
      const body = readFileSync(file);
      response
        .writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" })
        .end(body);
    } catch {
      response.writeHead(404).end('{"problems":["there is no such file"]}');
    }
  }

  async #store(path, request, response) {
    const parts = await request.toArray();
    const body = JSON.parse(Buffer.concat(parts).toString());
    this.posts.push({ path, lease: request.headers["x-aisle-lease"], body });
    this.files[`${path}-2.json`] = body;
    const building = `${path.slice(path.lastIndexOf("/") + 1)}-2`;
    response.writeHead(201).end(JSON.stringify({ building }));
  }

  /** @returns the page's address */
  async start(port = 0) {
    await new Promise((resolve) => this.#http.listen(port, "127.0.0.1", resolve));
    this.#sockets = new WebSocketServer({ server: this.#http, handleProtocols: () => "foxglove.sdk.v1" });
    this.#server = new protocol.FoxgloveServer({
      name: "fake",
      capabilities: ["clientPublish", "services", "time"],
      supportedEncodings: ["json"],
    });
    this.#server.on("subscribe", (id) => {
      const latest = this.#latest.get(id);
      if (latest) setImmediate(() => this.#server.sendMessage(id, ...latest));
    });
    this.#server.on("message", ({ data }) => this.drives.push(JSON.parse(new TextDecoder().decode(data))));
    this.#server.on("serviceCallRequest", (request, socket) => this.#called(request, socket));
    this.#sockets.on("connection", (socket) => this.#server.handleConnection(socket, "client"));
    this.services = new Map();
    for (const name of [
      "lease/take",
      "lease/renew",
      "lease/release",
      "mission/start",
      "mission/pause",
      "mission/resume",
      "mission/stop",
      "mission/emergency_stop",
      "mission/emergency_release",
      "mission/mark",
      "mission/finish",
      "mission/go",
      "mission/goals",
      "maze/run",
      "sessions/list",
      "sessions/info",
      "sessions/rename",
      "sessions/delete",
      "buildings/list",
      "replay/start",
      "replay/play",
      "replay/pause",
      "replay/seek",
      "replay/rate",
      "replay/stop",
      "mission/trail",
      "mission/events",
    ]) {
      this.services.set(
        this.#server.addService({ name, type: name, requestSchema: "", responseSchema: "" }),
        name,
      );
    }
    this.#beat = setInterval(() => this.send_state({}), 500);
    this.send_state({});
    return `http://127.0.0.1:${this.#http.address().port}/`;
  }

  async stop() {
    clearInterval(this.#beat);
    for (const client of this.#sockets.clients) client.terminate();
    this.#sockets.close();
    this.#channels.clear();
    this.#latest.clear();
    await new Promise((resolve) => this.#http.close(resolve));
  }

  /** Stops sending, but keeps the connection. */
  stop_sending() {
    clearInterval(this.#beat);
  }

  send_state(changes) {
    Object.assign(this.state, changes);
    this.publish("/live/state", "std_msgs/String", { data: JSON.stringify(this.state) });
  }

  publish(topic, type, message, stamp_s = this.state.stamp_s) {
    if (!this.#channels.has(topic)) {
      const [package_name, name] = type.split("/");
      const schema = schema_of(type);
      const id = this.#server.addChannel({
        topic,
        encoding: "cdr",
        schemaName: `${package_name}/msg/${name}`,
        schema,
        schemaEncoding: "ros2msg",
      });
      this.#channels.set(topic, { id, writer: new MessageWriter(parse(schema, { ros2: true })) });
    }
    const { id, writer } = this.#channels.get(topic);
    const sent = [BigInt(Math.round(stamp_s * 1e9)), writer.writeMessage(message)];
    this.#latest.set(id, sent);
    this.#server.sendMessage(id, ...sent);
  }

  #called({ serviceId, callId, data }, socket) {
    const name = this.services.get(serviceId);
    const request = JSON.parse(new TextDecoder().decode(data));
    this.calls.push({ name, request });
    const answer = this.answers[name]?.(request) ?? {};
    if (answer instanceof Error) {
      socket.send(JSON.stringify({ op: "serviceCallFailure", serviceId, callId, message: answer.message }));
    } else {
      const bytes = new TextEncoder().encode(JSON.stringify(answer));
      this.#server.sendServiceCallResponse({ serviceId, callId, encoding: "json", data: bytes }, socket);
    }
  }
}
