"""The server of `coilwright bench`, asked as its page asks."""

import concurrent.futures
import html
import http.client
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time
import unittest

from program import CONFIGS, PAPER_FINGER, PROGRAM, ProgramTest, run

FINGER = CONFIGS / "actuators" / "finger.json"
STUDY = {
    "variables": {"gap_mm": {"lower": 0.6, "upper": 1.8}, "turns_radial": {"lower": 8, "upper": 20},
                  "current_A": {"lower": 0.2, "upper": 1.4}},
    "objectives": [{"maximise": "peak_bending_speed_deg_s"}],
    "constraints": [{"quantity": "mass_g", "at_most": 80}],
}


class Server:
    """A server of the built program. Use it in a `with`, which ends it."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([PROGRAM, "bench", *map(str, arguments), "--no-browser"],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
        self.said = [self.process.stdout.readline() for _ in range(3)]
        self.address = self.said[1].strip()
        _, _, host, self.token, _ = self.address.split("/")
        self.port = int(host.split(":")[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end(signal.SIGKILL)

    def end(self, how=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(how)
        _, errors = self.process.communicate(timeout=60)
        return self.process.returncode, errors

    def ask(self, path, body=None, *, method=None, token=None, headers=None):
        """Status, headers and text of one request; `body` is JSON, or bytes as they are."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=300)
        data = body if body is None or isinstance(body, bytes) else json.dumps(body).encode()
        given = {"Content-Type": "application/json"} if data is not None else {}
        connection.request(method or ("GET" if data is None else "POST"), f"/{token or self.token}/{path}", data,
                           {**given, **(headers or {})})
        answer = connection.getresponse()
        text = answer.read().decode()
        connection.close()
        return answer.status, dict(answer.getheaders()), text

    def json(self, path, body=None):
        status, _, text = self.ask(path, body)
        assert status == 200, (status, text)
        return json.loads(text)

    def status(self, *arguments, **how):
        return self.ask(*arguments, **how)[0]

    def work(self, until=("done", "stopped", "failed")):
        deadline = time.monotonic() + 600
        while True:
            now = self.json("api/work")
            if now["state"] in until:
                return now
            assert time.monotonic() < deadline, now
            time.sleep(0.05)


def evaluate(file, *arguments):
    done = run("evaluate", file, *arguments, "--json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class BenchTest(ProgramTest):
    def assert_as_evaluated(self, shown, file, *arguments):
        told = evaluate(file, *arguments)
        told.pop("assumptions", None)
        self.assertEqual(shown["evaluation"], told)

    def test_gives_the_numbers_of_evaluate_to_the_digit(self):
        cases = [
            (["gap_mm=1.17", "turns_axial=26", "magnet_length_mm=7.3", "current_A=0.93"],
             ["--set", "gap_mm=1.17", "--set", "turns_axial=26", "--set", "magnet_length_mm=7.3", "--current-A", 0.93]),
            (["configuration=C", "magnet_grade=N45SH", "silicone=Dragon Skin 10", "current_A=0.5", "wiring=series", "duty=0.37",
              "supply_voltage_V=7.3", "supply_resistance_Ohm=0.13", "grasp_opening_deg=13.7", "grasp_height_mm=7.7"],
             ["--set", "configuration=C", "--set", "magnet_grade=N45SH", "--set", "silicone=Dragon Skin 10", "--current-A", 0.5,
              "--wiring", "series", "--duty", 0.37, "--supply-voltage-V", 7.3, "--supply-resistance-Ohm", 0.13,
              "--grasp-opening-deg", 13.7, "--grasp-height-mm", 7.7]),
        ]
        for file in (FINGER, PAPER_FINGER):
            with Server(file) as server:
                for changes, arguments in cases:
                    with self.subTest(file=file.name, changes=changes):
                        shown = server.json("api/evaluate", {"page": "one", "changes": changes})
                        self.assert_as_evaluated(shown, file, *arguments)
                        for change in changes:
                            name, value = change.split("=")
                            self.assertEqual(str(shown["values"][name]), value)

    def test_gives_at_every_current_of_a_curve_what_evaluate_does(self):
        with Server(FINGER, "--current-A", 0.8) as server:
            curves = server.json("api/curves", {"page": "one", "changes": ["gap_mm=1.1"]})
            self.assertIn(0.8, curves["current_A"])
            for place in (2, len(curves["current_A"]) - 1):
                told = evaluate(FINGER, "--set", "gap_mm=1.1", "--current-A", curves["current_A"][place])
                self.assertEqual(curves["steady_angle_deg"][place], told["steady_angle_deg"])
                self.assertEqual(curves["grasp_force_N"][place], told["grasp_force_N"])

    def test_has_a_knob_with_unit_meaning_and_range_for_every_number(self):
        parameters = json.loads(run("list", "parameters", "--json").stdout)
        with Server(FINGER) as server:
            knobs = {each["name"]: each for each in server.json("api/bench")["knobs"]}
            for each in parameters:
                knob = knobs[each["key"]]
                self.assertEqual(knob["meaning"], each["meaning"])
                self.assertTrue("words" in knob or knob["range"] in each["range"], knob)
            self.assertEqual(knobs["configuration"]["words"], ["A", "B", "C", "D"])

    def test_says_in_a_line_what_is_wrong_with_a_number(self):
        with Server(FINGER) as server:
            for change, line in (("gap_mm=-1", "gap_mm=-1: must be from 0.05 to 1000"),
                                 ("gap_mm=abc", "gap_mm=abc: must be a finite number"),
                                 ("duty=2", f"{FINGER}: duty: must be from 0 to 1; got 2"),
                                 ("wiring=ring", "wiring=ring: must be parallel or series"),
                                 ("gap=1", "gap=1: is not a number of a design")):
                status, _, text = server.ask("api/evaluate", {"page": "one", "changes": [change]})
                self.assertEqual(status, 422)
                self.assertTrue(json.loads(text)["error"].startswith(line), text)
            for body in (b"[", b"{}", b'{"changes": 1}', b'{"changes": [], "spread": {"posterior": "/etc/passwd"}}',
                         b'{"changes": [], "study": {"variables": {}, "objectives": [], "constraints": [], "spread": {}}}'):
                self.assertEqual(server.status("api/evaluate", body), 422, body)

    def test_refuses_who_is_not_its_page(self):
        with Server(FINGER) as server:
            question = {"page": "one", "changes": []}
            self.assertEqual(server.status("api/bench"), 200)
            self.assertEqual(server.status("api/bench", headers={"Origin": f"http://127.0.0.1:{server.port}"}), 200)
            for token in ("0" * 32, server.token[:-1], server.token + "0", "x"):
                self.assertEqual(server.status("api/bench", token=token), 403, token)
            for headers in ({"Host": "example.org"}, {"Host": f"evil.example:{server.port}"}, {"Host": "127.0.0.1:1"},
                            {"Origin": "http://example.org"}, {"Origin": "null"}, {"Origin": "http://127.0.0.1:1"}):
                self.assertEqual(server.status("api/bench", headers=headers), 403, headers)
                self.assertEqual(server.status("api/evaluate", question, headers=headers), 403, headers)
            for path in ("../../etc/passwd", "..%2f..%2fetc/passwd", "/etc/passwd", "bench.js/../..", "api", "api/none"):
                self.assertIn(server.status(path), (403, 404), path)
            for method in ("HEAD", "PUT", "DELETE", "OPTIONS", "PATCH"):
                self.assertIn(server.status("api/bench", method=method), (404, 405), method)
            self.assertEqual(server.status("api/evaluate"), 405)
            self.assertEqual(server.status("api/bench", question), 405)

    def test_bounds_what_it_is_sent(self):
        with Server(FINGER) as server:
            self.assertEqual(server.status("api/evaluate", {"changes": ["x" * 100000]}), 413)
            self.assertEqual(server.status("api/evaluate", b"{}", headers={"Content-Type": "text/plain"}), 415)
            for header in ("Transfer-Encoding: chunked", "Content-Encoding: gzip\r\nContent-Length: 2", "X: y"):
                with socket.create_connection(("127.0.0.1", server.port), timeout=60) as raw:
                    raw.sendall(f"POST /{server.token}/api/evaluate HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
                                f"Content-Type: application/json\r\n{header}\r\n\r\n".encode())
                    self.assertIn(b" 411 ", raw.recv(1000).split(b"\r\n")[0], header)
            silent = [socket.create_connection(("127.0.0.1", server.port), timeout=60) for _ in range(24)]
            self.assertEqual(server.status("api/bench"), 200)  # when those that say nothing have been given up
            for each in silent:
                each.close()

    def test_tells_browsers_to_keep_the_page_to_itself(self):
        with Server(FINGER) as server:
            for path, kind in (("", "text/html"), ("bench.js", "text/javascript"), ("bench.css", "text/css"), ("page.css", "text/css")):
                status, headers, text = server.ask(path)
                self.assertEqual(status, 200)
                self.assertTrue(headers["Content-Type"].startswith(kind))
                self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
                self.assertNotIn("unsafe", headers["Content-Security-Policy"])
                self.assertEqual(headers["Referrer-Policy"], "no-referrer")
                self.assertNotIn("https://", text)

    def test_sends_its_answers_as_they_are(self):
        with Server(FINGER) as server:
            status, headers, text = server.ask("api/evaluate", {"page": "one", "changes": []}, headers={"Accept-Encoding": "gzip, deflate, br"})
            self.assertEqual(status, 200)
            self.assertNotIn("Content-Encoding", headers)  # brotli takes 50 ms for them
            json.loads(text)

    def test_answers_the_newest_of_many_questions_of_a_page(self):
        with Server(FINGER) as server:
            def ask(number):
                time.sleep(0.01 * number)  # in this order
                status, _, text = server.ask("api/evaluate", {"page": "one", "changes": ["configuration=D", f"gap_mm={1 + 0.01 * number:.2f}"]})
                return status, json.loads(text)
            with concurrent.futures.ThreadPoolExecutor(12) as pool:
                answers = list(pool.map(ask, range(12)))
            states = [status for status, _ in answers]
            self.assertEqual(states[-1], 200)
            self.assertEqual(answers[-1][1]["values"]["gap_mm"], 1.11)
            self.assertIn(409, states)  # those that waited, or were overtaken
            self.assertTrue(set(states) <= {200, 409}, states)

    def test_searches_and_stops_when_told(self):
        with Server(FINGER) as server:
            begun = server.json("api/search", {"changes": [], "study": STUDY})
            self.assertEqual((begun["kind"], begun["state"]), ("search", "running"))
            self.assertEqual(server.status("api/yield", {"changes": [], "study": STUDY}), 409)
            shown = server.json("api/evaluate", {"page": "one", "changes": ["gap_mm=1.2"]})  # meanwhile
            self.assert_as_evaluated(shown, FINGER, "--set", "gap_mm=1.2", "--current-A", shown["values"]["current_A"])
            server.json("api/stop", {"changes": []})
            self.assertEqual(server.work()["state"], "stopped")

    def test_improves_a_design_and_gives_the_files_for_size(self):
        with Server(FINGER) as server:
            question = {"changes": ["gap_mm=1.3", "current_A=0.7"], "study": STUDY}
            server.json("api/search", question)
            work = server.work()
            self.assertEqual(work["state"], "done", work["error"])
            self.assertEqual((work["done"], work["of"]), (300, 300))
            for name in ("actuator", "study"):
                self.write(f"{name}.json", server.ask(f"api/{name}", question)[2])
            done = run("size", "study.json", "--out", "found", "--max-evaluations", 30, "--answer-only", "--quiet", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(work["result"]["feasible"])
            best = server.json("api/evaluate", {"page": "one", "changes": work["result"]["changes"]})["evaluation"]
            shown = server.json("api/evaluate", {"page": "one", "changes": question["changes"]})
            told = evaluate(self.folder / "actuator.json")
            for quantity in ("peak_bending_speed_deg_s", "grasp_force_N", "mass_g"):
                self.assertAlmostEqual(told[quantity] / shown["evaluation"][quantity], 1.0, places=9)
            self.assertGreater(best["peak_bending_speed_deg_s"], shown["evaluation"]["peak_bending_speed_deg_s"])
            self.assertLessEqual(best["mass_g"], 80)

    def test_says_what_limits_a_design_and_how_many_builds_keep_it(self):
        with Server(FINGER) as server:
            for kind, words in (("limits", ["0.9 -> 0.888", "0.9 -> 0.912", "0.5 -> 0.512", "15 -> 16"]), ("yield", ["1000 builds"])):
                server.json(f"api/{kind}", {"changes": ["current_A=0.5"], "study": STUDY})
                work = server.work()
                self.assertEqual(work["state"], "done", work["error"])
                for each in words:
                    self.assertIn(each, html.unescape(work["result"]["html"]))

    def test_is_found_again_with_its_port_and_token(self):
        with Server(FINGER, "--token-file", self.folder / "token") as first:
            self.assertEqual((self.folder / "token").stat().st_mode & 0o777, 0o600)
            self.assertEqual(first.end(signal.SIGKILL)[0], -signal.SIGKILL)
            with Server(FINGER, "--token-file", self.folder / "token", "--port", first.port) as again:
                self.assertEqual(again.address, first.address)
                self.assertEqual(again.end(), (0, ""))

    def test_tells_a_program_its_address(self):
        process = subprocess.Popen([PROGRAM, "bench", FINGER, "--no-browser", "--json"], stdout=subprocess.PIPE, encoding="utf-8")
        said = "".join(process.stdout.readline() for _ in range(3))
        self.assertRegex(json.loads(said)["address"], "^http://127.0.0.1:[0-9]+/[0-9a-f]{32}/$")
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0)

    def test_leaves_no_file_and_takes_no_port_that_is_taken(self):
        before = sorted(os.listdir(self.folder))
        with Server(FINGER) as server:
            taken = run("bench", FINGER, "--port", server.port, "--no-browser")
            self.assertEqual(taken.returncode, 2)
            self.assertEqual(taken.stderr, f"coilwright: --port: must be a free port of 127.0.0.1; got {server.port}\n")
            with Server(FINGER) as other:
                self.assertNotEqual(other.port, server.port)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_refuses_in_a_line_what_it_cannot_show(self):
        lumped = pathlib.Path(os.environ["COILWRIGHT_TEST_DATA"]) / "formats" / "lumped_model.json"
        (self.folder / "empty").mkdir()
        self.write("bad.token", "abc\n")
        for arguments, words in (([lumped], "lumped model"), ([self.folder / "none.json"], "none.json"), ([self.folder / "empty"], "folder"),
                                 ([FINGER, "--current-A", "nan"], "--current-A"), ([FINGER, "--token-file", self.folder / "bad.token"], "token")):
            done = run("bench", *arguments, "--no-browser")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(words, done.stderr)

    def test_opens_folders_of_results_with_their_study(self):
        study = json.loads((CONFIGS / "studies" / "speed_against_grip.json").read_text())
        study["actuator"] = str(FINGER)
        self.write("study.json", json.dumps(study))
        run("pareto", self.folder / "study.json", "--out", self.folder / "front", "--max-evaluations", 150, "--quiet")
        with Server(self.folder / "front") as server:
            further = server.json("api/bench")["further"]
            self.assertEqual(list(further["study"]["variables"]), list(study["variables"]))
            self.assertEqual(further["study"]["constraints"], study["constraints"])
            rows = further["designs"]
            changes = [f"{name}={rows[name][0]:g}" for name in study["variables"]]
            shown = server.json("api/evaluate", {"page": "one", "changes": changes})["evaluation"]
            for quantity in ("peak_bending_speed_deg_s", "grasp_force_N", "mass_g", "thermal_load"):
                self.assertEqual(shown[quantity], rows[quantity][0])
        # As every command that reads such a folder (damaged_folders_test.py).
        front = self.folder / "front" / "front.csv"
        front.write_text(front.read_text().replace("1", "2"))
        done = run("bench", self.folder / "front", "--no-browser")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"^coilwright: \S*front\.csv: is not there, or not as the run of this folder wrote it[^\n]*\n$")

    def test_opens_a_diagnosis_on_what_was_measured(self):
        data, found = self.folder / "data", self.folder / "found"
        shutil.copytree(CONFIGS.parent / "studies" / "undeclared_effect" / "data", data)
        done = run("diagnose", data, "--actuator", PAPER_FINGER, "--out", found, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        told = self.result("found/diagnosis.json")
        rows = self.table("found/residuals.csv")
        with Server(found) as server:
            about = server.json("api/bench")["further"]["diagnosis"]
            self.assertEqual(about["verdict"], told["summary"]["verdict"])
            drag = "quadratic_drag.drag_Nmms2_rad2"
            number = told["effects"][0]["parameters"]["drag_Nmms2_rad2"]
            self.assertEqual(about["intervals"], {drag: number["ci95"]})
            for each in server.json("api/errors", {"page": "one", "changes": []}):
                stated = told["error"][each["role"]]
                self.assertEqual([each["quantity"], each["unit"], each["samples"]], [stated["quantity"], "deg", stated["samples"]])
                # Sums of the same squares, in another order; the corrected design went through a file, which rounds.
                self.assertAlmostEqual(each["declared"] / stated["declared"]["rmse_deg"], 1, delta=1e-12)
                self.assertAlmostEqual(each["corrected"] / stated["after"]["rmse_deg"], 1, delta=1e-9)
                self.assertEqual(each["turned"], each["corrected"])

            names = [each["run"] for each in about["channels"]]
            self.assertEqual(sorted(names), sorted({row["run"] for row in rows}))
            for name in ("step_1.4A.csv", "sine_4Hz.csv", "hold_1.3A.csv"):
                shown = server.json("api/record", {"page": "one", "changes": [], "channel": names.index(name)})
                own = [row for row in rows if row["run"] == name]
                drawn = own[::shown["every"]]
                self.assertLessEqual(len(drawn), 2000)
                for key, column in (("at", "time_s"), ("measured", "measured"), ("declared", "declared")):
                    self.assertEqual(shown[key], [float(row[column]) for row in drawn], (name, key))
                for one, other in zip(shown["corrected"], drawn, strict=True):
                    self.assertAlmostEqual(one, float(other["after"]), delta=1e-7)  # deg
                squares = [(float(row["measured"]) - float(row["after"])) ** 2 for row in own]
                self.assertAlmostEqual(shown["rmse"]["corrected"], (sum(squares) / len(squares)) ** 0.5, delta=1e-9)

            # A number of the effect moves the prediction to that of simulate, which takes other steps.
            question = {"page": "one", "changes": [f"{drag}=0.03"], "channel": names.index("step_1.4A.csv")}
            turned = server.json("api/record", question)
            self.assertGreater(turned["rmse"]["turned"], 1.5 * turned["rmse"]["corrected"])
            self.assertEqual(turned["corrected"], server.json("api/record", {**question, "changes": []})["turned"])
            for changes in (question["changes"], ["configuration=C", "gap_mm=1.1"]):
                turned = server.json("api/record", {**question, "changes": changes})
                self.write("turned.json", server.ask("api/actuator", {"changes": changes})[2])
                done = run("simulate", "turned.json", "--input", data / "step_1.4A.csv", "--out", "motion.csv", "--force", cwd=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                motion = {float(row["time_s"]): float(row["bending_angle_deg"]) for row in self.table("motion.csv")}
                for time_s, angle in zip(turned["at"], turned["turned"], strict=True):
                    self.assertAlmostEqual(angle, motion[time_s], delta=1e-3)  # deg
            for channel in (len(names), -1):
                self.assertEqual(server.status("api/record", {**question, "channel": channel}), 422)

        # What it is of must be there as it was.
        def refused(words):
            done = run("bench", found, "--no-browser")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.removeprefix(f"coilwright: {found}: cannot be opened: "), words + "\n")
        again = ", which this diagnosis is of, is not there as it was; run diagnose again"
        record = data / "sine_4Hz.csv"
        before = record.read_text()
        record.write_text(before + "\n")
        refused(str(record) + again)
        record.write_text(before)
        (data / "dataset.json").rename(data / "other.json")
        refused(str(data / "dataset.json") + again)
        (found / "provenance.json").unlink()
        done = run("bench", found, "--no-browser")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, f"coilwright: {found}: cannot be opened: it has no provenance.json that names its data set\n")

    def test_says_where_nothing_tells_whether_a_folder_is_as_it_was_written(self):
        shutil.copy(FINGER, self.folder / "actuator.json")
        with Server(self.folder) as server:
            self.assertEqual(server.status("api/bench"), 200)
            self.assertEqual(server.end(), (0, f"coilwright: {self.folder}/provenance.json is not there: nothing tells whether "
                                               "these results are as they were written\n"))


if __name__ == "__main__":
    unittest.main()
