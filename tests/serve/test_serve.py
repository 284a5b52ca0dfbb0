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

PROGRAM, STUDY = sys.argv[1:3]
CHEAP = ["--set", "solver.fidelity=rigid", "--set", "solver.steps_per_mm=100", "--set", "load.max_displacement=3 mm",
         "--set", "uq.samples=8"]
RESPONSES = ["peak_force", "peak_displacement", "friction_energy"]


def start(*more):
    server = subprocess.Popen([PROGRAM, "serve", STUDY, "--port", "0", "--threads", "2", *CHEAP, *more],
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


def check_broken_requests(port):
    body = b'{"name": "quick_0.50_MPa", "input": [[0.5, 1, 3.7e6, 0.6]], "config": {}}'
    good = b"POST /Evaluate HTTP/1.1\r\nHost: x\r\nConnection: close\r\nContent-Length: %d\r\n\r\n" % len(body) + body

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
        for data, answer in clients.map(broken, range(1000)):
            if not answer:
                continue
            answered += 1
            status, reply = answer.split(b" ", 2)[1], answer.split(b"\r\n\r\n", 1)[1].split(b"HTTP/1.1 ")[0]
            assert reply[:1] == b"{", (data, answer)
            reply = json.loads(reply)
            assert ("error" in reply) == (status[:1] in b"45"), (data, answer)
    assert answered > 300, answered
    large = b"POST /Evaluate HTTP/1.1\r\nHost: x\r\nContent-Length: 9000000\r\n\r\n" + b" " * 9000000
    assert b" 413 " in raw(port, large, 20).split(b"\r\n")[0], "a length beyond the limit"
    chunk = b"POST /Evaluate HTTP/1.1\r\nHost: x\r\nTransfer-Encoding: chunked\r\n\r\n"
    answer = raw(port, chunk + (b"100000\r\n" + b" " * 0x100000 + b"\r\n") * 20 + b"0\r\n\r\n", 20)
    assert not answer or b" 413 " in answer.split(b"\r\n")[0], answer[:100]
    slow = [socket.create_connection(("127.0.0.1", port)) for _ in range(50)]
    for s in slow:
        s.sendall(good[:-20])
    assert ask(port, "/Info")[0] == 200, "slow clients keep others out"
    for s in slow:
        s.close()


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
        check_broken_requests(port)
        check_address(port)
        assert ask(port, "/Info")[0] == 200 and server.poll() is None, "it died"
    finally:
        server.send_signal(signal.SIGINT)
        assert server.wait(30) == 0, server.returncode
    check_inputs()


main()
