#!/usr/bin/env python3
"""Drives simulated vehicles of `aisle fleet` by one broker and a small master control that reserves edges.

The master sends each idle vehicle somewhere along free nodes and edges, reserves the whole route, releases it a
few edges at a time, and frees what the vehicle has left. Halfway the broker is killed and started again. What is
checked does not rest on the reservations alone: every position that a vehicle reports must lie near its own
released edges, and no two vehicles may report the same edge.

Exit status: 0 all held, 1 something did not, 77 mosquitto or Paho for Python is missing.
"""

import argparse
import collections
import json
import math
import os
import pathlib
import random
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

try:
    import paho.mqtt.client as mqtt
except ImportError:
    print("skipped: Paho for Python (python3-paho-mqtt) is missing")
    sys.exit(77)

RELEASED_EDGES = 2
RESEND_S = 3.0
APART_M = 2.5  # nodes nearer to each other are not given to two vehicles
OFF_BASE_M = 2.0  # base_link may lie behind a node that the front has reached
USER, PASSWORD = "robots", "only for this test"


def find_mosquitto():
    return shutil.which("mosquitto", path=os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Broker:
    """Mosquitto on the loopback; with TLS and login if asked."""

    def __init__(self, directory, with_tls):
        self.directory, self.with_tls, self.port, self.process = directory, with_tls, free_port(), None
        lines = [f"listener {self.port} 127.0.0.1", "persistence false", "log_type error"]
        if with_tls:
            self.make_certificates()
            passwords = directory / "passwords"
            passwords.touch(mode=0o600)
            subprocess.run(["mosquitto_passwd", "-b", str(passwords), USER, PASSWORD], check=True)
            (directory / "secret.txt").write_text(PASSWORD + "\n")
            lines += [f"cafile {directory}/ca.pem", f"certfile {directory}/broker.pem",
                      f"keyfile {directory}/broker.key", f"password_file {passwords}", "allow_anonymous false"]
            for name in ("ca.pem", "broker.pem", "broker.key", "passwords"):
                (directory / name).chmod(0o644)
            directory.chmod(0o755)
        else:
            lines += ["allow_anonymous true"]
        self.config = directory / "mosquitto.conf"
        self.config.write_text("\n".join(lines) + "\n")

    def make_certificates(self):
        def openssl(*arguments):
            subprocess.run(["openssl", *arguments], check=True, cwd=self.directory, capture_output=True)

        openssl("req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", "ca.key", "-out", "ca.pem", "-days",
                "2", "-subj", "/CN=test")
        openssl("req", "-newkey", "rsa:2048", "-nodes", "-keyout", "broker.key", "-out", "broker.csr", "-subj",
                "/CN=localhost")
        (self.directory / "names").write_text("subjectAltName=DNS:localhost,IP:127.0.0.1\n")
        openssl("x509", "-req", "-in", "broker.csr", "-CA", "ca.pem", "-CAkey", "ca.key", "-CAcreateserial", "-out",
                "broker.pem", "-days", "2", "-extfile", "names")

    def start(self):
        self.process = subprocess.Popen([find_mosquitto(), "-c", str(self.config)])
        deadline = time.monotonic() + 20
        while time.monotonic() < deadline:
            try:
                socket.create_connection(("127.0.0.1", self.port), 1).close()
                return
            except OSError:
                time.sleep(0.05)
        raise RuntimeError("mosquitto does not answer")

    def kill(self):
        if self.process:
            self.process.kill()
            self.process.wait()
            self.process = None

    def url(self):
        return f"{'mqtts' if self.with_tls else 'mqtt'}://localhost:{self.port}"

    def options(self):
        if not self.with_tls:
            return []
        return ["--ca", f"{self.directory}/ca.pem", "--user", USER, "--password-file", f"{self.directory}/secret.txt"]


class Graph:
    """Nodes and undirected edges of a LIF file."""

    def __init__(self, lif):
        layout = lif["layouts"][0]
        self.map_id = layout["nodes"][0]["mapId"]
        self.at = {n["nodeId"]: (n["nodePosition"]["x"], n["nodePosition"]["y"]) for n in layout["nodes"]}
        self.edge_ids = {(e["startNodeId"], e["endNodeId"]): e["edgeId"] for e in layout["edges"]}
        self.next = collections.defaultdict(list)
        for start, end in self.edge_ids:
            self.next[start].append(end)

    def distance(self, a, b):
        return math.dist(self.at[a], self.at[b])

    def near(self, node, within_m):
        return {other for other in self.at if self.distance(node, other) < within_m}

    def routes(self, start, taken, longest):
        """Shortest routes (in edges) from a node over what is free, to each node that can be reached."""
        found, queue = {start: [start]}, collections.deque([start])
        while queue:
            node = queue.popleft()
            if len(found[node]) > longest:
                continue
            for other in self.next[node]:
                if other not in found and other not in taken and frozenset((node, other)) not in taken:
                    found[other] = found[node] + [other]
                    queue.append(other)
        return found


def off_segment(p, a, b):
    along = (b[0] - a[0], b[1] - a[1])
    square = along[0] ** 2 + along[1] ** 2
    share = 0 if square == 0 else max(0, min(1, ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / square))
    return math.dist(p, (a[0] + share * along[0], a[1] + share * along[1]))


class Robot:
    def __init__(self, serial, node):
        self.serial, self.node = serial, node
        self.state, self.connection, self.position = None, None, None
        self.route, self.first, self.released, self.order_id, self.update = [], 0, 0, "", 0
        self.sent_s, self.begun_s = 0, 0
        self.done, self.reported, self.orders = 0, 0, 0

    def is_busy(self):
        return bool(self.order_id)

    def has_horizon(self):
        """It drives an order of which not all is released."""
        return (self.is_busy() and self.state and self.state["orderId"] == self.order_id and
                self.released < len(self.route) - 1)

    def reserved(self):
        """What it may still be on: from the node that it reported last to the end of its route."""
        if not self.is_busy():
            return {self.node}
        left = self.route[self.first:]
        return set(left) | {frozenset(pair) for pair in zip(left, left[1:])}


class Master:
    def __init__(self, graph, broker, robots, orders, seed):
        self.graph, self.orders, self.random = graph, orders, random.Random(seed)
        self.robots = {robot.serial: robot for robot in robots}
        self.given, self.lock = 0, threading.Lock()
        self.problems, self.off_base_m, self.least_apart_m, self.header = [], 0.0, math.inf, 0
        self.resent, self.pauses = 0, 0
        self.client = mqtt.Client(client_id="master")
        if broker.with_tls:
            self.client.tls_set(f"{broker.directory}/ca.pem")
            self.client.username_pw_set(USER, PASSWORD)
        self.client.reconnect_delay_set(1, 2)
        self.client.on_connect = lambda *_: self.client.subscribe("uagv/v2/aisle/+/+", 1)
        self.client.on_message = self.take
        self.client.connect("localhost", broker.port, keepalive=10)
        self.client.loop_start()

    def take(self, _client, _data, message):
        _, _, _, serial, topic = message.topic.split("/")
        robot = self.robots.get(serial)
        if robot is None or topic not in ("state", "connection", "visualization"):
            return
        content = json.loads(message.payload)
        with self.lock:
            if topic == "connection":
                robot.connection = content["connectionState"]
                return
            if topic == "state":
                robot.state = content
                self.check_edges()
            if content["agvPosition"]["positionInitialized"]:
                robot.position = (content["agvPosition"]["x"], content["agvPosition"]["y"])
                self.check_position(robot)

    def check_edges(self):
        """By what the vehicles say themselves: no edge is driven by two."""
        seen = {}
        for robot in self.robots.values():
            state = robot.state
            if not state or not state["edgeStates"] or not state["edgeStates"][0]["released"]:
                continue
            edge = state["edgeStates"][0]["edgeId"]
            key = next((frozenset(pair) for pair, name in self.graph.edge_ids.items() if name == edge), edge)
            if key in seen and seen[key] != robot.serial:
                self.problems.append(f"{robot.serial} and {seen[key]} are both on {edge}")
            seen[key] = robot.serial

    def check_position(self, robot):
        line = robot.route[:robot.released + 1] if robot.is_busy() else [robot.node]
        off_m = min(off_segment(robot.position, self.graph.at[a], self.graph.at[b])
                    for a, b in zip(line, line[1:] or line))
        self.off_base_m = max(self.off_base_m, off_m)
        if off_m > OFF_BASE_M:
            self.problems.append(f"{robot.serial} is {off_m:.1f} m off its base")
        for other in self.robots.values():
            if other is not robot and other.position:
                self.least_apart_m = min(self.least_apart_m, math.dist(robot.position, other.position))

    def send(self, robot, topic, content):
        self.header += 1
        head = {"headerId": self.header, "timestamp": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()),
                "version": "2.1.0", "manufacturer": "aisle", "serialNumber": robot.serial}
        self.client.publish(f"uagv/v2/aisle/{robot.serial}/{topic}", json.dumps(head | content), 1)

    def send_order(self, robot, first):
        """The route from its node `first` on; what is released comes from `robot.released`."""
        nodes, edges = [], []
        for i in range(first, len(robot.route)):
            x, y = self.graph.at[robot.route[i]]
            nodes.append({"nodeId": robot.route[i], "sequenceId": 2 * i, "released": i <= robot.released, "actions": [],
                          "nodePosition": {"x": x, "y": y, "mapId": self.graph.map_id, "allowedDeviationXY": 1.5}})
            if i > first:
                pair = (robot.route[i - 1], robot.route[i])
                edges.append({"edgeId": self.graph.edge_ids[pair], "sequenceId": 2 * i - 1,
                              "released": i <= robot.released, "startNodeId": pair[0], "endNodeId": pair[1],
                              "actions": []})
        robot.order = {"orderId": robot.order_id, "orderUpdateId": robot.update, "nodes": nodes, "edges": edges}
        robot.sent_s = time.monotonic()
        self.send(robot, "order", robot.order)

    def taken(self, by_others_than):
        taken = set()
        for robot in self.robots.values():
            if robot is by_others_than:
                continue
            for one in robot.reserved():
                taken |= {one} if isinstance(one, frozenset) else self.graph.near(one, APART_M)
        return taken

    def give_order(self, robot):
        routes = self.graph.routes(robot.node, self.taken(robot), 6)
        far = [route for route in routes.values() if len(route) > 2]
        if not far:
            return
        robot.route = self.random.choice(sorted(far))
        self.given += 1
        robot.orders += 1
        robot.order_id, robot.update = f"{robot.serial}-{robot.orders}", 0
        robot.first, robot.released = 0, min(RELEASED_EDGES, len(robot.route) - 1)
        robot.begun_s = time.monotonic()
        self.send_order(robot, 0)

    def follow(self, robot):
        state = robot.state
        is_known = state["orderId"] == robot.order_id and state["orderUpdateId"] == robot.update
        if not is_known:
            if [e for e in state["errors"] if e["errorLevel"] == "WARNING" and
                    any(r["referenceValue"] == robot.order_id for r in e["errorReferences"])]:
                robot.reported += 1
                self.problems.append(f"{robot.serial}: {state['errors']}")
                robot.order_id, robot.node = "", robot.route[robot.first]
            elif time.monotonic() - robot.sent_s > RESEND_S:
                self.resent += 1
                robot.sent_s = time.monotonic()
                self.send(robot, "order", robot.order)
            return
        robot.first = max(robot.first, state["lastNodeSequenceId"] // 2)
        robot.node = robot.route[robot.first]
        if not state["nodeStates"]:
            robot.done += 1
            robot.order_id = ""
            return
        if robot.released < len(robot.route) - 1 and robot.first + 1 >= robot.released:
            stitch = robot.released
            robot.released = min(robot.released + RELEASED_EDGES, len(robot.route) - 1)
            robot.update += 1
            self.send_order(robot, stitch)

    def step(self):
        with self.lock:
            for robot in self.robots.values():
                if not robot.state or robot.connection != "ONLINE":
                    continue
                if robot.is_busy():
                    self.follow(robot)
                elif (self.given < self.orders and not robot.state["driving"] and
                      robot.state["agvPosition"]["positionInitialized"]):
                    self.give_order(robot)

    def is_done(self):
        with self.lock:
            return self.given >= self.orders and not any(robot.is_busy() for robot in self.robots.values())

    def count(self, what):
        return sum(getattr(robot, what) for robot in self.robots.values())


def start_of(world):
    text = pathlib.Path(world).read_text()
    x, y, heading = re.search(r"start: \{at: \[([\d.-]+), ([\d.-]+)\], heading_deg: ([\d.-]+)", text).groups()
    return float(x), float(y), math.radians(float(heading))


def to_world(world, building, x, y, heading_rad):
    """A pose of the map in the world: the map's home is where the world's vehicles start."""
    sx, sy, st = start_of(world)
    home = next(p for p in building["places"] if p["name"] == "home")
    hx, hy = home["at_m"]
    turn = st - math.radians(home["heading_deg"])
    dx, dy = x - hx, y - hy
    return (sx + math.cos(turn) * dx - math.sin(turn) * dy, sy + math.sin(turn) * dx + math.cos(turn) * dy,
            math.degrees(heading_rad + turn))


def spread_nodes(graph, count, apart_m, generator):
    """Nodes to begin at, on corridors and apart from each other."""
    chosen = []
    names = sorted(graph.at, key=lambda _: generator.random())
    for node in names:
        if len(graph.next[node]) >= 2 and all(graph.distance(node, other) >= apart_m for other in chosen):
            chosen.append(node)
        if len(chosen) == count:
            return chosen
    raise RuntimeError(f"the building has no room for {count} vehicles")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--aisle", required=True, help="the program")
    parser.add_argument("--world", required=True, help="world file (YAML)")
    parser.add_argument("--building", help="building file of that world (default: it is explored first)")
    parser.add_argument("--vehicles", type=int, default=1)
    parser.add_argument("--orders", type=int, default=3)
    parser.add_argument("--pace", type=float, default=1)
    parser.add_argument("--spacing", type=float, default=4, help="metres between nodes at most")
    parser.add_argument("--tls", action="store_true", help="TLS and login")
    parser.add_argument("--dead", type=float, default=0, help="seconds for which the broker is dead, halfway")
    parser.add_argument("--longest", type=float, default=900, help="seconds until it gives up")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if not find_mosquitto():
        print("skipped: mosquitto is missing")
        return 77
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    with tempfile.TemporaryDirectory(prefix="aisle-fleet-") as directory:
        return run(options, pathlib.Path(directory))


def run(options, directory):
    building_file = options.building
    if not building_file:
        subprocess.run([options.aisle, "--quiet", "explore", options.world, "--out", str(directory / "explored")],
                       check=True, capture_output=True)
        building_file = str(directory / "explored/building.json")
    building = json.loads(pathlib.Path(building_file).read_text())
    spacing = ["--set", f"node_spacing_m={options.spacing}"]
    lif_file = directory / "graph.lif.json"
    subprocess.run([options.aisle, "fleet", building_file, "--lif", str(lif_file), *spacing], check=True,
                   capture_output=True)
    graph = Graph(json.loads(lif_file.read_text()))
    broker = Broker(directory, options.tls)
    broker.start()
    generator = random.Random(options.seed)
    robots, processes = [], []
    try:
        for i, node in enumerate(spread_nodes(graph, options.vehicles, APART_M, generator)):
            serial = f"{i + 1:04}"
            x, y = graph.at[node]
            other = graph.at[max(graph.next[node], key=lambda name: graph.distance(node, name))]
            heading = math.atan2(other[1] - y, other[0] - x)
            start = ",".join(f"{v:.3f}" for v in to_world(options.world, building, x, y, heading))
            processes.append(subprocess.Popen(
                [options.aisle, "--json", "--quiet", "fleet", building_file, "--broker", broker.url(), "--serial",
                 serial, "--world", options.world, "--start", start, "--at",
                 f"{x:.3f},{y:.3f},{math.degrees(heading):.3f}", "--seed", str(i + 1), "--pace", str(options.pace),
                 *spacing, *broker.options()], stdout=subprocess.PIPE, text=True))
            robots.append(Robot(serial, node))
        return conduct(options, graph, broker, robots, processes)
    finally:
        for process in processes:
            if process.poll() is None:
                process.kill()
                process.wait()
        broker.kill()


def conduct(options, graph, broker, robots, processes):
    master = Master(graph, broker, robots, options.orders, options.seed)
    begun_s, killed_s, restarts, seen_dead = time.monotonic(), None, 0, 0
    bases = {}
    while not master.is_done() and time.monotonic() - begun_s < options.longest:
        master.step()
        if any(process.poll() is not None for process in processes):
            master.problems.append("a vehicle has ended")
            break
        done = master.count("done")
        with master.lock:
            is_halfway = done >= options.orders // 2 and any(robot.has_horizon() for robot in robots)
        if options.dead and restarts == 0 and killed_s is None and is_halfway:
            with master.lock:
                bases = {r.serial: (r.order_id, 2 * r.released) for r in robots if r.is_busy()}
            broker.kill()
            killed_s = time.monotonic()
            print(f"{done} orders are done: the broker is killed for {options.dead:.0f} s", flush=True)
        if killed_s and time.monotonic() - killed_s > options.dead:
            with master.lock:
                for robot in robots:
                    robot.state = robot.connection = None
            broker.start()
            killed_s, restarts = None, restarts + 1
            wait_for_states(master, robots, 30)
            with master.lock:
                for robot in robots:
                    if robot.serial not in bases or not robot.state:
                        continue
                    order_id, end = bases[robot.serial]
                    if robot.state["orderId"] == order_id and robot.state["lastNodeSequenceId"] > end:
                        master.problems.append(f"{robot.serial} drove beyond its base without a broker")
                    seen_dead += robot.state["orderId"] == order_id and robot.state["lastNodeSequenceId"] == end
        time.sleep(0.05)
    took_s = time.monotonic() - begun_s
    if options.dead and not restarts:
        master.problems.append("the broker was never killed")
    unfinished = [f"{r.serial} at {r.node}, {r.position}, for {r.route[r.first:]}: {what_it_says(r)}"
                  for r in robots if r.is_busy()]
    for process in processes:
        process.send_signal(signal.SIGINT)
    figures = {"vehicles": len(robots), "orders_given": master.given, "orders_done": master.count("done"),
               "orders_reported": master.count("reported"), "broker_restarts": restarts,
               "at_the_end_of_their_base_when_it_came_back": seen_dead, "orders_sent_again": master.resent,
               "off_base_max_m": round(master.off_base_m, 2),
               "least_apart_m": None if math.isinf(master.least_apart_m) else round(master.least_apart_m, 2),
               "seconds": round(took_s, 1), "unfinished": unfinished, "problems": master.problems[:20]}
    for process in processes:
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            figures["problems"].append("a vehicle did not end when it was interrupted")
    master.client.loop_stop()
    print(json.dumps(figures, indent=1))
    is_complete = figures["orders_done"] + figures["orders_reported"] == options.orders
    return 0 if is_complete and not figures["problems"] else 1


def what_it_says(robot):
    state = robot.state
    if not state:
        return "nothing"
    return (f"update {state['orderUpdateId']} of {robot.update}, driving {state['driving']}, "
            f"{len(state['nodeStates'])} nodes left, {[e['errorDescription'] for e in state['errors']]}")


def wait_for_states(master, robots, seconds):
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        with master.lock:
            if all(robot.state and robot.connection == "ONLINE" for robot in robots):
                return
        time.sleep(0.1)


if __name__ == "__main__":
    sys.exit(main())
