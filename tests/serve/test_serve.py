#!/usr/bin/python3
"""drystone serve, as clients see it. test_serve.py PROGRAM STUDY.ini

The protocol, the bits of a study from eight clients at once, and a thousand broken requests. Exit code 0: good, 1: not.
"""
import concurrent.futures
import http.client
import json
import random
import re
import select
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

PROGRAM, STUDY = sys.argv[1:3]
CHEAP = ["--set", "solver.fidelity=rigid", "--set", "solver.steps_per_mm=100", "--set", "load.max_displacement=3 mm",
         "--set", "uq.samples=8"]
RESPONSES = ["peak_force", "peak_displacement", "friction_energy"]


def start(*more, settings=CHEAP):
    server = subprocess.Popen([PROGRAM, "serve", STUDY, "--port", "0", "--threads", "2", *settings, *more],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return server, int(re.search(r"http://127\.0\.0\.1:(\d+)", server.stdout.readline()).group(1))


def ask(port, path, request=None, body=None):
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
    body = json.dumps(request) if body is None else body
    connection.request("GET" if path == "/Info" else "POST", path, None if path == "/Info" else body)
    reply = connection.getresponse()
    answer = reply.status, json.loads(reply.read())
    connection.close()
    return answer


def check_error(answer, status, kind):
    assert answer[0] == status and answer[1]["error"]["type"] == kind, (answer, status, kind)
    assert set(answer[1]) == {"error"} and set(answer[1]["error"]) == {"type", "message"}, answer


def check_protocol(port):
    status, info = ask(port, "/Info")
    assert status == 200 and info["protocolVersion"] == 1.0, info
    name = "quick_0.50_MPa"
    assert {name, name + "_normal"} <= set(info["models"]), info
    status, about = ask(port, "/ModelInfo", {"name": name})
    assert about["support"] == {"Evaluate": True, "Gradient": False, "ApplyJacobian": False, "ApplyHessian": False}
    assert set(about) == {"support"}, about
    status, columns = ask(port, "/Columns", {"name": name})
    columns = [(c["name"], c["unit"]) for c in columns["inputs"]]
    assert ("joint.friction_angle", "rad") in columns and ("unit.tensile_strength", "Pa") in columns, columns
    n = len(columns)
    assert ask(port, "/InputSizes", {"name": name}) == (200, {"inputSizes": [n]})
    assert ask(port, "/OutputSizes", {"name": name, "config": {}}) == (200, {"outputSizes": [len(RESPONSES)]})

    # Zeros are the medians of the distributions.
    status, reply = ask(port, "/Evaluate", {"name": name + "_normal", "input": [[0] * n], "config": {}})
    assert status == 200 and list(reply) == ["output"] and len(reply["output"]) == 1, reply
    assert len(reply["output"][0]) == len(RESPONSES) and 30e3 < reply["output"][0][0] < 60e3, reply

    for path in ("/Gradient", "/ApplyJacobian", "/ApplyHessian"):
        check_error(ask(port, path, {"name": name}), 400, "UnsupportedFeature")
    for path in ("/Evaluate", "/ModelInfo", "/InputSizes", "/Gradient"):
        check_error(ask(port, path, {"name": "no such"}), 400, "ModelNotFound")
    x = [0.5, 1, 3.7e6, 0.6, 1]
    for wrong in ([], [x + [1]], [x[:-1]], [x, x], x, "x", [["0.5", 1, 3.7e6, 0.6, 1]], [[None] * n], {"x": 1},
                  [[-0.1] + x[1:]], [[2.0] + x[1:]], [x[:1] + [0.0] + x[2:]]):
        check_error(ask(port, "/Evaluate", {"name": name, "input": wrong}), 400, "InvalidInput")
    check_error(ask(port, "/Evaluate", {"name": name}), 400, "InvalidInput")
    check_error(ask(port, "/Evaluate", {"name": name, "input": [x], "config": {"a": 1}}), 400, "InvalidInput")
    deep = "[" * 100000
    for text in ("", "{", "[]", "null", "1e999", '{"name": 3}', "\x00", deep, '{"name": "quick_0.50_MPa", "input": [[1e999]]}'):
        check_error(ask(port, "/Evaluate", body=text), 400, "InvalidInput")
    for path in ("/", "/info", "/Evaluate/", "/../../etc/passwd", "/" + "a" * 7000):
        check_error(ask(port, path, {"name": name}), 404, "InvalidInput")


def check_study(port):
    """Same bits as in the file of a study, from eight clients at once."""
    try:
        import h5py
    except ImportError:
        print("without python3-h5py: not compared with a study")
        return
    with tempfile.TemporaryDirectory() as folder:
        file = folder + "/quick.h5"
        subprocess.run([PROGRAM, "study", STUDY, "--out", file, "--quiet", *CHEAP], check=True, stdout=subprocess.DEVNULL)
        with h5py.File(file, "r") as study:
            levels = [f"quick_{p / 1e6:.2f}_MPa" for p in study["levels/vertical_stress"]]
            walls = [(levels[level], list(x)) for level, x in zip(study["walls/level"], study["walls/inputs"])]
            wanted = list(zip(*[study["responses"][name][:] for name in RESPONSES]))

    def push(wall):
        status, reply = ask(port, "/Evaluate", {"name": wall[0], "input": [wall[1]]})
        assert status == 200, reply
        return tuple(reply["output"][0])

    with concurrent.futures.ThreadPoolExecutor(8) as clients:
        got = list(clients.map(push, walls))
    assert len(got) == 24 and got == wanted, "not the bits of the study"
    assert push(walls[3]) == wanted[3], "a wall alone differs"


def raw(port, data, patience=0.1):
    """What comes back; after `patience` seconds without an answer this end says that no more will come."""
    with socket.create_connection(("127.0.0.1", port), timeout=30) as s:
        answer = b""
        try:
            s.sendall(data)
            if not select.select([s], [], [], patience)[0]:
                s.shutdown(socket.SHUT_WR)
            while piece := s.recv(65536):
                answer += piece
                head, _, reply = answer.partition(b"\r\n\r\n")
                length = re.search(rb"Content-Length: (\d+)", head)
                if length and len(reply) >= int(length.group(1)):
                    break
        except (ConnectionResetError, BrokenPipeError):
            pass
        return answer


def check_broken_requests(port, count):
    body = b'{"name": "quick_0.50_MPa", "input": [[0.5, 1, 3.7e6, 0.6]], "config": {}}'
    good = b"POST /Evaluate HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nContent-Length: %d\r\n\r\n" % len(body) + body

    def broken(seed):
        bits = random.Random(seed)
        data = bytearray(good)
        for _ in range(bits.randint(1, 4)):
            at = bits.randrange(len(data) or 1)
            kind = bits.randrange(5)
            if kind == 0 and data:
                data[at] ^= 1 << bits.randrange(8)
            elif kind == 1:
                del data[at:at + bits.randint(1, 20)]
            elif kind == 2:
                data[at:at] = bytes(bits.randrange(256) for _ in range(bits.randint(1, 20)))
            elif kind == 3:
                data[at:at] = data[:at]
            else:
                del data[max(1, at):]
        return bytes(data), raw(port, bytes(data))

    answered = 0
    with concurrent.futures.ThreadPoolExecutor(16) as clients:
        for data, answer in clients.map(broken, range(count)):
            if not answer:
                continue
            answered += 1
            status, reply = answer.split(b" ", 2)[1], answer.split(b"\r\n\r\n", 1)[1].split(b"HTTP/1.1 ")[0]
            assert reply[:1] == b"{", (data, answer)
            reply = json.loads(reply)
            assert ("error" in reply) == (status[:1] in b"45"), (data, answer)
    assert answered > 0.3 * count, answered
    large = b"POST /Evaluate HTTP/1.1\r\nHost: localhost\r\nContent-Length: 9000000\r\n\r\n" + b" " * 9000000
    assert b" 413 " in raw(port, large, 20).split(b"\r\n")[0], "a length beyond the limit"
    chunk = b"POST /Evaluate HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n"
    answer = raw(port, chunk + (b"100000\r\n" + b" " * 0x100000 + b"\r\n") * 20 + b"0\r\n\r\n", 20)
    assert not answer or b" 413 " in answer.split(b"\r\n")[0], answer[:100]
    slow = [socket.create_connection(("127.0.0.1", port)) for _ in range(50)]
    for s in slow:
        s.sendall(good[:-20])
    assert ask(port, "/Info")[0] == 200, "slow clients keep others out"
    for s in slow:
        s.close()


def head(path, body=b"", host=b"Host: localhost", *more):
    lines = [b"POST %s HTTP/1.1" % path, host, b"Connection: close", *more]
    if not any(line.startswith((b"Content-Length", b"Transfer-Encoding")) for line in lines):
        lines.append(b"Content-Length: %d" % len(body))
    return b"\r\n".join(lines) + b"\r\n\r\n" + body


SIZES = b'{"name": "quick_0.50_MPa"}'


def status_of(port, *request):
    return int(raw(port, head(b"/InputSizes", *request), 20).split(b" ")[1])


def check_browsers(port, own=()):
    """Pages of browsers are refused: those of another machine, and those whose name was made to point to this one."""
    for host in (b"localhost", b"LOCALHOST:4242", b"127.0.0.1:%d" % port, b"127.1.2.3", b"[::1]:4242", *own):
        assert status_of(port, SIZES, b"Host: " + host) == 200, host
    for host in (b"evil.example", b"evil.example:%d" % port, b"127.0.0.1.evil.example", b"localhost.evil.example", b"10.0.0.5", b"[", b"[::1", b"[::1]x",
                 b"localhost:80@evil.example", b"localhost:evil",
                 b"localhost\r\nHost: evil.example"):
        assert status_of(port, SIZES, b"Host: " + host) in (403, 400), host
    for origin in (b"http://localhost:8888", b"http://127.0.0.1", b"https://[::1]:8888", *(b"https://" + name for name in own)):
        assert status_of(port, SIZES, b"Host: localhost", b"Origin: " + origin) == 200, origin
    for origin in (b"http://evil.example", b"null", b"http://10.0.0.5:%d" % port, b"http://localhost.evil.example",
                   b"http://localhost@evil.example", b"http://localhost:80@evil.example", b"localhost"):
        assert status_of(port, SIZES, b"Host: localhost", b"Origin: " + origin, b"Content-Type: text/plain") == 403, origin
    reply = raw(port, head(b"/Evaluate", b"{}", b"Host: evil.example"), 20)
    assert b'evil.example\\" is not a name of this server' in reply and b"--host" in reply, reply


def check_heads(port):
    """Lengths that two programs could read otherwise, and heads without end."""
    for lines in ((b"Content-Length: 26", b"Content-Length: 3"), (b"Content-Length: abc",), (b"Content-Length: -1",), (b"Content-Length: 0x1a",),
                  (b"Content-Length: 26", b"Transfer-Encoding: chunked"), (b"Transfer-Encoding: gzip",)):
        assert status_of(port, SIZES, b"Host: localhost", *lines) == 400, lines
    chunks = b"1a\r\n" + SIZES + b"\r\n0\r\n\r\n"
    assert status_of(port, chunks, b"Host: localhost", b"Transfer-Encoding: chunked") == 200
    assert status_of(port, SIZES, b"Host: localhost", *[b"X: a"] * 1000) == 200
    with socket.create_connection(("127.0.0.1", port), timeout=30) as s:  # 64 kB are taken, then it answers and hangs up
        answer = b""
        try:
            s.sendall(b"GET /Info HTTP/1.1\r\n" + b"X: a\r\n" * 20_000)
            answer = s.recv(65536)
            s.settimeout(5)
            while s.recv(65536):
                pass
        except (ConnectionResetError, BrokenPipeError):
            pass
        assert not answer or b" 400 " in answer.split(b"\r\n")[0], answer
    with socket.create_connection(("127.0.0.1", port), timeout=30) as s:  # a client that says no more than its request
        s.sendall(head(b"/InputSizes", SIZES))
        s.shutdown(socket.SHUT_WR)
        assert s.recv(65536).startswith(b"HTTP/1.1 200 "), "no answer to a half-closed client"
    with socket.create_connection(("127.0.0.1", port), timeout=30) as s:  # several requests at once
        s.sendall(head(b"/InputSizes", SIZES).replace(b"Connection: close\r\n", b"") * 2 + head(b"/InputSizes", SIZES))
        answer = b""
        while piece := s.recv(65536):
            answer += piece
        assert answer.count(b"HTTP/1.1 200 ") == 3, answer


def check_queue():
    """Clients that come at once are taken in, all of them, while the server has no time for any."""
    server, port = start()
    try:
        server.send_signal(signal.SIGSTOP)
        clients = [socket.socket() for _ in range(64)]
        for s in clients:
            s.settimeout(0.5)  # one that is turned away tries again after a second
            s.connect(("127.0.0.1", port))
            s.close()
    finally:
        server.send_signal(signal.SIGCONT)
        server.send_signal(signal.SIGTERM)
        assert server.wait(30) == 0


def check_far_coordinates(port):
    for z in (30.0, -30.0, 8.3):
        answer = ask(port, "/Evaluate", {"name": "quick_0.50_MPa_normal", "input": [[0, 0, z, 0, 0]]})
        check_error(answer, 400, "InvalidInput")
        assert "z3 = " in answer[1]["error"]["message"] and "standard deviations" in answer[1]["error"]["message"], answer


def check_places():
    """Inputs per joint say where the joint is."""
    server, port = start("--set", "uq.spatial=independent")
    try:
        columns = ask(port, "/Columns", {"name": "quick_0.50_MPa"})[1]["inputs"]
        joint = next(c for c in columns if c["name"] == "joint.friction_angle.1")
        assert joint["meaning"].endswith(", of this joint ID, middle at x = 0.2 m, z = 0.05 m"), joint
    finally:
        server.send_signal(signal.SIGTERM)
        assert server.wait(30) == 0


def check_end():
    """A wall that would take hours holds nobody up: who waits is told, and the server ends."""
    for signal_of_the_end in (signal.SIGINT, signal.SIGTERM):
        server, port = start(settings=["--set", "solver.steps_per_mm=200000", "--set", "load.max_displacement=300 mm"])
        answers = []
        request = {"name": "quick_0.50_MPa", "input": [[0.5, 1, 3.7e6, 0.6, 1]]}
        clients = [threading.Thread(target=lambda: answers.append(ask(port, "/Evaluate", request))) for _ in range(3)]
        silent = socket.create_connection(("127.0.0.1", port))
        silent.sendall(b"POST /Evaluate HTTP/1.1\r\nX")
        for client in clients:
            client.start()
        time.sleep(0.3)
        sent = time.monotonic()
        server.send_signal(signal_of_the_end)
        assert server.wait(30) == 0
        taken = time.monotonic() - sent
        for client in clients:
            client.join()
        silent.close()
        assert taken < 4, taken
        assert len(answers) == 3, answers
        for answer in answers:
            check_error(answer, 500, "InvalidOutput")


def check_end_at_once():
    """A signal that comes before the first connection is taken in ends it too."""
    for _ in range(8):
        server, _ = start()
        server.send_signal(signal.SIGINT)
        assert server.wait(30) == 0


def check_address(port):
    try:
        socket.create_connection(("127.0.0.2", port), timeout=5).close()
    except OSError:
        return
    raise AssertionError("it listens at more than 127.0.0.1")


def check_inputs():
    server, port = start("--input", "joint.friction_angle", "--response", "peak_force")
    try:
        assert ask(port, "/Info")[1]["models"] == ["quick_0.50_MPa", "quick_1.00_MPa", "quick_1.25_MPa"]
        assert ask(port, "/InputSizes", {"name": "quick_1.00_MPa"})[1] == {"inputSizes": [1]}
        low, high = (ask(port, "/Evaluate", {"name": "quick_1.00_MPa", "input": [[phi]]})[1]["output"][0][0]
                     for phi in (0.3, 0.7))
        assert low < 0.9 * high, (low, high)
        taken = subprocess.run([PROGRAM, "serve", STUDY, "--port", str(port)], capture_output=True, text=True, timeout=30)
        assert taken.returncode == 1 and "cannot listen" in taken.stderr, taken
    finally:
        server.send_signal(signal.SIGTERM)
        assert server.wait(30) == 0
    for wrong in (["--input", "wall.length"], ["--input", "no.key"], ["--response", "peak"], ["--port", "70000"]):
        said = subprocess.run([PROGRAM, "serve", STUDY, "--port", "0", *wrong], capture_output=True, text=True, timeout=30)
        assert said.returncode == 2 and said.stderr, (wrong, said)


def main():
    server, port = start(*[word for name in RESPONSES for word in ("--response", name)])
    try:
        check_protocol(port)
        check_study(port)
        check_broken_requests(port, int(sys.argv[3]))
        check_browsers(port)
        check_heads(port)
        check_far_coordinates(port)
        check_address(port)
        assert ask(port, "/Info")[0] == 200 and server.poll() is None, "it died"
    finally:
        server.send_signal(signal.SIGINT)
        assert server.wait(30) == 0, server.returncode
    check_inputs()
    check_places()
    check_queue()
    check_end()
    check_end_at_once()
    server, port = start("--host", "lab.example", "--host", "Notebook.example")
    try:
        check_browsers(port, (b"lab.example:80", b"notebook.example"))
    finally:
        server.send_signal(signal.SIGTERM)
        assert server.wait(30) == 0


main()
