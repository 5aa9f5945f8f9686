"""The page against the command, in a headless browser.

    ASPERITY_PAGE=target/web ASPERITY_PROGRAM=target/release/asperity pytest crates/web/tests

The browser's sines and powers and its vectors of 128 bits round otherwise than the machine's, so numbers agree but for
their last digits; `BOUND` says how far.
"""

import json
import os
import re
import subprocess
from pathlib import Path

import pytest
from page import browser, ended, open_page, result, served

ROOT = Path(__file__).resolve().parents[3]
FOLDER = Path(os.environ.get("ASPERITY_PAGE", ROOT / "target/web"))
PROGRAM = os.environ.get("ASPERITY_PROGRAM", str(ROOT / "target/release/asperity"))
CASES, PROFILES = ROOT / "fixtures/cases", ROOT / "fixtures/profiles"

# Largest difference of a number of result.json, relative to it: sums and solutions differ by rounding, which a contact
# solved to a tolerance of 1e-8 multiplies; 1.7e-7 was seen. The loss is a mean over many contacts; 7e-12 was seen.
BOUND = 1e-6
LOSS_BOUND = 1e-9
# Errors that are left at the end of a solution: rounding themselves, so that their size counts and not their digits.
EVIDENCE = ("load_error", "duality_gap", "residual")
EVIDENCE_AT_MOST = 1e-7


@pytest.fixture(scope="session")
def chromium():
    with browser() as opened:
        yield opened


@pytest.fixture(scope="session")
def site():
    assert (FOLDER / "index.html").exists(), f"{FOLDER}: build the page first"
    with served(FOLDER) as (address, asked):
        yield address, asked


def complaints(context):
    """What pages of `context` and their frames write to the console as errors or warnings, and what they throw."""
    said = []
    context.on("console", lambda message: said.append(message.text) if message.type in ("error", "warning") else None)
    context.on("weberror", lambda error: said.append(str(error.error)))
    return said


@pytest.fixture
def page(chromium, site):
    """The page, which at the end has asked nobody else and complained of nothing."""
    address, asked = site
    context = chromium.new_context(viewport={"width": 1400, "height": 1000})
    sought, said = [], complaints(context)
    context.on("request", lambda request: sought.append(request.url))
    opened = open_page(context, address)
    opened.sought, opened.said = sought, said
    yield opened
    foreign = [url for url in sought if not url.startswith((address, "blob:" + address, "data:", "about:"))]
    assert foreign == []
    assert said == []
    # The server was asked for files alone, and sent nothing.
    assert all(re.match(r'"GET /[\w./-]* HTTP/1\.1" (200|304) ', line) for line in asked), asked
    context.close()


def command(case, *options, folder=None):
    """What the command writes for `case`: result.json and the summary."""
    done = subprocess.run(
        [PROGRAM, "run", str(case), "--threads", "1", "--json", "--no-output", *options],
        cwd=folder, capture_output=True, text=True, check=False,
    )
    found = json.loads(done.stdout)
    # The page does not seek measurements that would narrow the interval.
    for table in (found, found.get("uncertainty") or {}):
        table.pop("evidence", None)
    return found


def summary(case, folder=None):
    """The summary that the command prints, without what is about the command itself."""
    run = [PROGRAM, "run", str(case), "--notes", "--no-output"]
    text = subprocess.run(run, cwd=folder, capture_output=True, text=True, check=True).stdout
    return [line for line in text.splitlines() if not re.match(r"defaults used|in [\d.]+ s|solved", line)]


def leaves(value, path=""):
    """Every number, text and truth of a JSON value with its path; a quantity is a number and its unit."""
    if isinstance(value, dict):
        for key, each in value.items():
            yield from leaves(each, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for at, each in enumerate(value):
            yield from leaves(each, f"{path}[{at}]")
    elif isinstance(value, str) and (quantity := re.fullmatch(r"(-?\d[\d.]*(?:e-?\d+)?) (\S.*)", value)):
        yield path, float(quantity[1])
        yield f"{path} unit", quantity[2]
    else:
        yield path, value


def compare(found, expected):
    """Holds the numbers of two results against each other; everything else must be equal. Gives how many there are."""
    found, expected = dict(leaves(found)), dict(leaves(expected))
    assert found.keys() == expected.keys()
    largest = (0.0, "")
    numbers = 0
    for path, one in expected.items():
        other = found[path]
        if not isinstance(one, float) or not isinstance(other, float):
            assert other == one, path
            continue
        numbers += 1
        if path.endswith(EVIDENCE):
            assert max(abs(one), abs(other)) < EVIDENCE_AT_MOST, path
            continue
        scale = max(abs(one), abs(other))
        # The deviation of equal losses is their rounding, so that it is held against the loss.
        scale = max(scale, abs(expected.get(path.replace("sliding_deviation", "sliding"), 0.0)))
        largest = max(largest, (abs(one - other) / scale if scale else 0.0, path))
    print(f"{numbers} numbers, largest difference {largest}")
    assert largest[0] < BOUND, largest
    return numbers


def drop(page, paths):
    """Drops files on the page."""
    files = [(path.name, list(path.read_bytes())) for path in paths]
    transfer = page.evaluate_handle(
        """(files) => {
            const all = new DataTransfer();
            for (const [name, bytes] of files) all.items.add(new File([new Uint8Array(bytes)], name));
            return all;
        }""",
        files,
    )
    page.dispatch_event("body", "drop", {"dataTransfer": transfer})


def run(page):
    page.click("#run")
    return ended(page)


def fill(page, key, value):
    page.fill(f"[name='{key}']", value)
    page.press(f"[name='{key}']", "Tab")


def shown_summary(page):
    # Folded, so that it is not rendered.
    return [line for line in page.text_content("#summary").splitlines() if not line.startswith("solved")]


def test_the_demo_is_the_e_drive_of_the_command(page):
    page.click("#demo")
    page.wait_for_selector("form[data-run=running]")
    assert ended(page) == "done"
    found = json.loads(result(page, "result.json"))
    expected = command(CASES / "e-drive.toml")
    assert compare(found, expected) > 1000
    loss, exact = found["summary"]["loss_w"], expected["summary"]["loss_w"]
    print(f"loss {loss!r} W, by the command {exact!r} W, difference {abs(loss / exact - 1):.1e}")
    assert abs(loss / exact - 1) < LOSS_BOUND
    # All that is printed is equal to the last digit, but for what is left of the load at the end of the solution.
    assert shown_summary(page) == summary(CASES / "e-drive.toml")
    assert result(page, "e-drive.toml") == (CASES / "e-drive.toml").read_bytes()


@pytest.mark.parametrize("name", ["e-drive-superfinished", "fzg-c"])
def test_a_worked_case_brings_its_profiles_and_runs_as_the_command_runs_it(page, name):
    page.select_option("#preset", name)
    page.wait_for_selector("#look-wheel:has-text('points')")
    assert page.is_hidden("#apart")
    assert page.input_value("#text") == (CASES / f"{name}.toml").read_text()
    assert run(page) == "done"
    assert compare(json.loads(result(page, "result.json")), command(CASES / f"{name}.toml")) > 1000
    assert shown_summary(page) == summary(CASES / f"{name}.toml")


def test_the_case_of_the_paper_runs_as_the_command_runs_it(page):
    drop(page, [CASES / "table2.toml", PROFILES / "damaged.txt"])
    page.wait_for_selector("#look-pinion:has-text('points')")
    assert run(page) == "done"
    assert compare(json.loads(result(page, "result.json")), command(CASES / "table2.toml")) > 300
    assert shown_summary(page) == summary(CASES / "table2.toml")


def test_the_report_in_the_page_is_that_of_the_command(page, tmp_path):
    page.click("#demo")
    page.wait_for_selector("form[data-run=running]")
    assert ended(page) == "done"
    subprocess.run([PROGRAM, "run", CASES / "e-drive.toml", "-o", tmp_path / "result", "--quiet"], check=True)
    names = {path.name for path in (tmp_path / "result").iterdir()}
    offered = {each.get_attribute("download") for each in page.query_selector_all("#files a")} - {"e-drive.toml"}
    assert offered | {"manifest.json"} >= names, names - offered

    def words(html):
        text = re.sub(r"<(script|style|svg)\b.*?</\1>", " ", html, flags=re.S)
        return re.sub(r"<[^>]*>", " ", text).split()

    # The page does not look for measurements that would narrow the interval.
    evidence = r"<h3>What would narrow the interval most</h3>.*?has all measurements\.</p>"
    written, found = re.subn(evidence, "", (tmp_path / "result/report.html").read_text(), flags=re.S)
    assert found == 1
    saved, left_out = re.subn(r"<h3>What would narrow the interval most</h3><p>.*?</p>", "", result(page, "report.html").decode())
    assert left_out == 1
    # Nor does it need the terms of those measurements.
    term = r"<dt>([^<]*)</dt><dd>[^<]*</dd>"
    known = set(re.findall(term, saved))
    written = re.sub(term, lambda found: found[0] if found[1] in known else "", written)
    pairs = list(zip(words(saved), words(written), strict=True))
    assert len(pairs) > 1000
    differing = [pair for pair in pairs if pair[0] != pair[1]]
    print(f"{len(pairs)} words of the report, differing: {differing}")
    assert all(re.fullmatch(r"[\d.e-]+", word) for pair in differing for word in pair)
    assert len(differing) <= 3
    frame = page.frame_locator("#report")
    assert frame.locator("h1").inner_text() == "e-drive first stage, ground flanks (synthetic profiles)"
    assert " W (" in loss(page)
    # Charts are drawn, and the script of the report runs in its frame: it adds the reading to a chart under the pointer.
    assert frame.locator("svg.chart").count() > 10


def test_two_dropped_files_and_the_form_run_as_the_command_runs_their_case(page, tmp_path):
    page.select_option("#preset", "fzg-c")
    page.wait_for_function("() => document.querySelector(\"[name='gears.module']\").value === '4.5 mm'")
    drop(page, [PROFILES / "superfinished_wheel.csv", PROFILES / "ground_pinion.csv"])
    page.wait_for_selector("#look-wheel:has-text('points')")
    assert "ground_pinion.csv: 6001 points" in page.inner_text("#look-pinion")
    assert "superfinished_wheel.csv: 6001 points" in page.inner_text("#look-wheel")
    fill(page, "title", 'dropped "by hand"')
    fill(page, "operation.torque", "150")
    assert page.input_value("[name='operation.torque']") == "150 N m"
    page.uncheck("[name='surface.wheel.mirrored']")
    assert run(page) == "done"
    for name in ("ground_pinion.csv", "superfinished_wheel.csv"):
        (tmp_path / name).write_bytes((PROFILES / name).read_bytes())
    (tmp_path / "fzg-c.toml").write_bytes(result(page, "fzg-c.toml"))
    expected = command("fzg-c.toml", folder=tmp_path)
    assert expected["inputs"]["operation"]["torque"] == "150 N m"
    assert expected["title"] == 'dropped "by hand"'
    assert compare(json.loads(result(page, "result.json")), expected) > 1000


def test_a_dropped_case_with_keys_beyond_the_form_runs_as_its_text(page, tmp_path):
    case = (CASES / "e-drive.toml").read_text().replace("../profiles/", "")
    case += "\n[model]\npositions = 4\noffsets = 2\n"
    (tmp_path / "own.toml").write_text(case)
    for name in ("ground_pinion.csv", "ground_wheel.csv"):
        (tmp_path / name).write_bytes((PROFILES / name).read_bytes())
    drop(page, sorted(tmp_path.iterdir()))
    page.wait_for_selector("#apart:visible")
    page.wait_for_selector("#look-wheel:has-text('points')")
    assert page.is_disabled("[name='operation.torque']")
    assert page.input_value("#text") == case
    assert run(page) == "done"
    found = json.loads(result(page, "result.json"))
    assert found["summary"]["positions"] == 4
    assert compare(found, command("own.toml", folder=tmp_path)) > 300
    # Back to the form, which then is all that counts.
    page.click("#to-form")
    assert "[model]" not in page.input_value("#text")
    assert page.is_enabled("[name='operation.torque']")


def refusal(page):
    code = page.inner_text("#error strong")
    message, *more = page.inner_text("#error").split("\n\n")
    return code, message.removeprefix(code).strip(), " ".join(more)


def test_a_bad_number_is_refused_as_by_the_command_and_its_field_is_marked(page, tmp_path):
    drop(page, [PROFILES / "ground_pinion.csv", PROFILES / "ground_wheel.csv"])
    page.wait_for_selector("#look-wheel:has-text('points')")
    fill(page, "operation.torque", "145 furlongs")
    assert run(page) == "refused"
    code, message, more = refusal(page)
    (tmp_path / "e-drive.toml").write_text(page.input_value("#text"))
    expected = command("e-drive.toml", folder=tmp_path)["error"]
    assert (code, message) == (expected["code"], expected["message"])
    assert code == "E204" and "furlongs" in message
    assert more.startswith("Help: ")
    assert page.get_attribute("[name='operation.torque']", "aria-invalid") == "true"
    page.click("#error button:has-text('Show line')")
    chosen = page.evaluate("() => { const t = document.getElementById('text'); return t.value.slice(t.selectionStart, t.selectionEnd); }")
    assert chosen == '"145 furlongs"'
    # Mended, it runs.
    fill(page, "operation.torque", "145 N m")
    assert page.get_attribute("[name='operation.torque']", "aria-invalid") is None
    assert run(page) == "done"


def test_a_file_that_is_no_profile_is_refused_at_once_and_by_the_run(page, tmp_path):
    bad = tmp_path / "letter.txt"
    bad.write_text("Dear colleague,\nplease find enclosed nothing.\n" * 80)
    drop(page, [bad, PROFILES / "ground_wheel.csv"])
    page.wait_for_selector("#look-pinion.refused")
    assert re.match(r"E1\d\d ", page.inner_text("#look-pinion"))
    assert run(page) == "refused"
    code, message, _ = refusal(page)
    (tmp_path / "ground_wheel.csv").write_bytes((PROFILES / "ground_wheel.csv").read_bytes())
    (tmp_path / "e-drive.toml").write_text(page.input_value("#text"))
    expected = command("e-drive.toml", folder=tmp_path)["error"]
    assert (code, message) == (expected["code"], expected["message"])


def test_heights_alone_take_their_spacing_and_unit_from_the_form(page, tmp_path):
    lines = (PROFILES / "ground_pinion.csv").read_text().splitlines()
    heights = [line.split(",")[1] for line in lines if re.match(r"[-\d]", line)]
    assert len(heights) == 6001
    (tmp_path / "heights.txt").write_text("\n".join(heights) + "\n")
    drop(page, [tmp_path / "heights.txt"])
    page.wait_for_selector("#look-pinion.refused")
    assert "dx" in page.inner_text("#look-pinion")
    fill(page, "surface.pinion.dx", "0.5")
    page.select_option("[name='surface.pinion.z_unit']", "um")
    page.wait_for_selector("#look-pinion:has-text('6001 points, 0.5 µm apart')")


TRAIN = """title = "pair and set"
train.input = "motor"
mesh.pair = { shafts = ["motor", "sun"], gears = { teeth = [23, 68], module = "1.8 mm", face_width = "32 mm" } }
mesh.set = { shafts = ["sun", "output"], planetary = { teeth = [27, 24, -75], planets = 3, module = "2 mm", face_width = ["30 mm", "30 mm", "30 mm"] } }
operation = { torque = "60 N m", speed = "4000 1/min", bulk_temperature = "90 °C" }
lubricant.oil = "m100"
surface = { pinion.file = "ground_pinion.csv", wheel = { file = "ground_wheel.csv", mirrored = true }, cutoff = "0.25 mm" }
gearbox.tables = [{ shaft = "output", file = "idle.csv" }]
model = { positions = 4, offsets = 2 }
"""


def test_a_gear_train_runs_as_the_command_runs_it_and_has_a_report_of_each_mesh(page, tmp_path):
    (tmp_path / "train.toml").write_text(TRAIN)
    (tmp_path / "idle.csv").write_text("speed_rpm,loss_torque_nm\n0,0.1\n5000,0.2\n")
    for name in ("ground_pinion.csv", "ground_wheel.csv"):
        (tmp_path / name).write_bytes((PROFILES / name).read_bytes())
    drop(page, [tmp_path / "train.toml", tmp_path / "ground_pinion.csv", tmp_path / "ground_wheel.csv"])
    page.wait_for_selector("#named:has-text('idle.csv (not chosen yet')")
    assert page.is_hidden("[name='gears.module']") and page.is_hidden("#pair")
    assert run(page) == "refused"
    assert refusal(page)[0] == "E103"
    drop(page, [tmp_path / "idle.csv"])
    page.wait_for_selector("#named:has-text('idle.csv (chosen)')")
    assert run(page) == "done"
    found, expected = json.loads(result(page, "train.json")), command("train.toml", folder=tmp_path)
    assert compare(found, expected) > 80
    whole = page.frame_locator("#report").locator("div:has(> dt:text-is('loss of all meshes')) dd")
    assert " W (" in whole.first.inner_text()
    assert page.inner_text("#reports").split("\n") == ["Whole gearbox", "Mesh pair", "Mesh set, sun and planet", "Mesh set, planet and ring"]
    frame = page.frame_locator("#report")
    frame.locator("a[href='set_sun_planet/report.html']").click()
    frame.locator("h1:has-text('sun and planet')").wait_for()
    assert page.is_visible("#files a[download='set_sun_planet_path.csv']")
    page.click("#reports button:has-text('Whole gearbox')")
    frame.locator("h1:text-is('pair and set')").wait_for()
    # Another torque beside it.
    page.fill("#text", TRAIN.replace("60 N m", "30 N m"))
    page.wait_for_selector("#stale:visible")
    assert run(page) == "done"
    assert "lower than with A" in page.inner_text("#verdict")


def test_texts_that_are_no_case_are_refused(page):
    page.click("#text-part summary")
    for text, code in (("gears = ", "E202"), ("[gearz]\nteeth = [1, 2]\n", "E203"), ("[planetary]\nteeth = [27, 24, -75]\n", "E204")):
        page.fill("#text", text)
        page.wait_for_selector("#apart:visible")
        assert run(page) == "refused"
        assert refusal(page)[0] == code
    drop(page, [CASES / "fzg-c.toml"])
    page.wait_for_selector("#look-pinion:has-text('has not been chosen')")
    assert run(page) == "refused"
    assert refusal(page)[0] == "E103"


def test_the_page_answers_while_it_computes_and_a_run_can_be_cancelled(page):
    page.click("#demo")
    page.wait_for_selector("form[data-run=running]")
    # A form that is filled meanwhile is seen in the text, which the run that began does not see.
    fill(page, "title", "meanwhile")
    assert 'title = "meanwhile"' in page.input_value("#text")
    assert page.get_attribute("form", "data-run") == "running"
    page.click("#cancel")
    assert ended(page) == "cancelled"
    assert page.is_hidden("#result") and page.is_hidden("#error")
    assert page.inner_text("#status") == "Cancelled"
    assert run(page) == "done"
    assert page.text_content("#summary").startswith("meanwhile\n")


def test_the_page_is_worked_by_keys_and_every_field_has_a_name(page):
    names = page.evaluate(
        """() => [...document.querySelectorAll('input, select, textarea, progress, iframe')].map((each) => [
            each.id || each.name,
            each.ariaLabel || each.title || [...(each.labels ?? [])].map((label) => label.textContent.trim()).join(' '),
        ])"""
    )
    assert len(names) > 25
    assert [key for key, name in names if not name] == []
    page.focus("#demo")
    page.keyboard.press("Enter")
    page.wait_for_selector("form[data-run=running]")
    assert ended(page) == "done"
    seen = set()
    page.focus("#demo")
    for _ in range(90):
        seen.add(page.evaluate("() => document.activeElement.id || document.activeElement.name || document.activeElement.tagName"))
        page.keyboard.press("Tab")
    assert seen >= {"preset", "file-pinion", "file-wheel", "gears.module", "operation.torque", "lubricant.oil", "link", "run", "SUMMARY"}


def demo(page):
    page.click("#demo")
    page.wait_for_selector("form[data-run=running]")
    assert ended(page) == "done"


def loss(page):
    return page.frame_locator("#report").locator("dd[data-key='summary.loss_w']").first.inner_text()


def test_a_result_is_grey_as_soon_as_an_input_changes_and_names_its_inputs(page):
    demo(page)
    first = loss(page)
    assert re.fullmatch(r"\d+ W \(\d+\.\.\d+\)", first)
    assert page.is_hidden("#stale")
    page.fill("[name='operation.torque']", "50")
    # Without a wait: the event of the key marks it.
    assert page.is_visible("#stale") and "run again" in page.inner_text("#stale")
    assert page.evaluate("() => getComputedStyle(document.getElementById('found')).filter") == "grayscale(1)"
    assert "145 N m, 9000 1/min, 90 °C, ground_pinion.csv and ground_wheel.csv" in page.inner_text("#time")
    fill(page, "operation.torque", "145 N m")
    assert page.is_hidden("#stale")
    # Another trace changes the result, too.
    drop(page, [PROFILES / "superfinished.csv"])
    page.wait_for_selector("#stale:visible")
    assert run(page) == "done"
    assert page.is_hidden("#stale") and "superfinished.csv" in page.inner_text("#time")


def test_two_dropped_finishes_are_compared_when_asked(page):
    names = ["ground_pinion.csv", "ground_wheel.csv", "superfinished.csv", "superfinished_wheel.csv"]
    drop(page, [PROFILES / name for name in names])
    page.wait_for_selector("#two:visible")
    assert "A, ground_pinion.csv and ground_wheel.csv; B, superfinished.csv and superfinished_wheel.csv" in page.inner_text("#two")
    page.click("#compare")
    page.wait_for_selector("#versus:visible", timeout=120_000)
    assert page.inner_text("#verdict").startswith("With B the loss is ") and "lower" in page.inner_text("#verdict")
    assert page.is_hidden("#two")
    # On a phone the button leads to the result.
    page.set_viewport_size({"width": 400, "height": 800})
    page.wait_for_selector("form[data-run=done]")
    page.evaluate("() => scrollTo(0, 0)")
    page.click("#show")
    assert page.evaluate("() => Math.abs(document.getElementById('main').getBoundingClientRect().top) < 40")


def test_two_results_stand_side_by_side_and_their_difference_is_the_loss_that_is_saved(page):
    demo(page)
    a = loss(page)
    assert page.is_hidden("#versus")
    fill(page, "operation.torque", "50")
    assert run(page) == "done"
    b = loss(page)
    row = page.locator("#both tbody tr").first.locator("td").all_inner_texts()
    assert row[:2] == [a, b] and row[2].startswith("-")
    watts = lambda text: float(re.match(r"-?[\d.]+", text)[0])
    assert abs(watts(row[2]) - (watts(b) - watts(a))) <= 20
    assert page.inner_text("#verdict").startswith("With B the loss is ")
    torque = page.locator("#both tr:has(th:text-is('Torque of the pinion')) td").all_inner_texts()
    assert torque[:2] == ["145 N m", "50 N m"]
    # A stays where it is kept.
    page.check("#hold")
    fill(page, "operation.torque", "100")
    assert run(page) == "done"
    assert page.locator("#both tbody tr").first.locator("td").first.inner_text() == a


def test_a_draft_with_its_traces_survives_a_reload_until_it_is_forgotten(page):
    drop(page, [PROFILES / "superfinished.csv", PROFILES / "superfinished_wheel.csv"])
    page.wait_for_selector("#look-wheel:has-text('points')")
    fill(page, "operation.torque", "77")
    page.wait_for_selector("#draft-note:has-text('kept in this browser, with its traces')")
    page.reload()
    page.wait_for_selector("form[data-run=ready]")
    assert page.input_value("[name='operation.torque']") == "77 N m"
    assert "superfinished.csv: " in page.inner_text("#look-pinion")
    assert run(page) == "done"
    page.click("#forget")
    page.wait_for_selector("#draft-note:has-text('forgotten')")
    page.reload()
    page.wait_for_selector("form[data-run=ready]")
    assert page.input_value("[name='operation.torque']") == "145 N m"
    assert page.evaluate("() => localStorage.length") == 0


def test_a_link_holds_the_case_and_says_that_it_holds_no_traces(page, site):
    fill(page, "operation.torque", "77")
    fill(page, "title", 'mesh "µ"')
    page.click("#link")
    page.wait_for_selector("#draft-note:has-text('not the traces')")
    # Another browser.
    page.evaluate("() => localStorage.clear()")
    linked = page.context.new_page()
    linked.goto(page.url)
    linked.wait_for_selector("form[data-run=ready]")
    assert linked.input_value("[name='operation.torque']") == "77 N m"
    assert linked.input_value("[name='title']") == 'mesh "µ"'
    assert "holds no traces" in linked.inner_text("#draft-note")


def test_traces_and_gears_are_drawn_while_they_are_given(page):
    drop(page, [PROFILES / "ground_pinion.csv", PROFILES / "ground_wheel.csv"])
    page.wait_for_selector("#trace-wheel svg")
    curve = lambda body: page.get_attribute(f"#trace-{body} svg path.curve", "d")
    forward = curve("pinion")
    page.check("[name='surface.pinion.mirrored']")
    page.wait_for_selector("#trace-pinion svg:has-text('last point')")
    assert curve("pinion") != forward
    teeth = lambda: page.text_content("#pair svg")
    assert "pinion, 23 teeth" in teeth()
    fill(page, "gears.teeth.0", "31")
    page.wait_for_selector("#pair svg:has-text('31 teeth')")
    # What cannot mesh leaves the last picture, which says that it is old.
    fill(page, "gears.module", "0")
    page.wait_for_selector("#pair.refused figcaption:has-text('Not drawn')")
    fill(page, "gears.module", "1.8")
    page.wait_for_selector("#pair:not(.refused)")


def test_dropped_traces_on_gears_and_steel_by_name_run(page, tmp_path):
    drop(page, [PROFILES / "ground_pinion.csv", PROFILES / "ground_wheel.csv"])
    page.wait_for_selector("#look-wheel:has-text('points')")
    page.select_option("#gears-by-name", "fzg-c")
    page.select_option("[name='material.pinion.steel']", "16MnCr5")
    for key in ("elastic_limit", "flow_pressure"):
        fill(page, f"material.pinion.{key}", "")
    fill(page, "gears.pinion.tip_relief.amount", "10")
    fill(page, "gears.pinion.tip_relief.length", "3")
    assert page.input_value("[name='gears.module']") == "4.5 mm"
    assert run(page) == "done"
    print(page.inner_text("#time"))
    inputs = json.loads(result(page, "result.json"))["inputs"]
    assert inputs["gears"]["teeth"] == [16, 24] and inputs["lubricant"]["oil"] == "m100"
    assert inputs["gears"]["pinion"]["tip_relief"] == {"amount": "10 um", "length": "3 mm"}
    assert inputs["material"]["pinion"]["steel"] == "16MnCr5"


def test_a_dropped_gearbox_file_fills_the_form_on_the_chosen_traces(page):
    drop(page, [PROFILES / "ground_pinion.csv", PROFILES / "ground_wheel.csv", ROOT / "crates/rexs/tests/gearboxes/chain.rexs"])
    page.wait_for_selector("#status:has-text('chain.rexs is read')")
    assert "ground_pinion.csv" in page.inner_text("#look-pinion")
    assert 'file = "ground_pinion.csv"' in page.input_value("#text")
    assert "chain.rexs" in page.input_value("[name='title']")
    # Its bevel stage is no mesh of a train: the first pair, and the list of the stages.
    assert page.input_value("#stage") == "1" and "bevel" in page.inner_text("#status")
    page.select_option("#stage", "2")
    page.wait_for_function("() => document.getElementById('text').value.startsWith('# Stage 2')")
    assert 'file = "ground_pinion.csv"' in page.input_value("#text")


@pytest.mark.parametrize(("width", "scheme"), [(1440, "light"), (1440, "dark"), (390, "light"), (390, "dark")])
def test_nothing_sticks_out_at_any_width(chromium, site, width, scheme):
    context = chromium.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme)
    said = complaints(context)
    page = open_page(context, site[0])
    page.click("#demo")
    page.wait_for_selector("form[data-run=running]")
    assert ended(page) == "done"
    page.frame_locator("#report").locator("h1").wait_for()
    page.wait_for_timeout(500)
    place = os.environ.get("ASPERITY_SCREENSHOTS")
    if place:
        page.screenshot(path=Path(place) / f"{width}-{scheme}.png", full_page=width < 1000)
    assert page.evaluate("() => document.documentElement.scrollWidth - document.documentElement.clientWidth") <= 0
    inner = page.frame_locator("#report").locator("html")
    assert inner.evaluate("(html) => html.scrollWidth - html.clientWidth") <= 0
    # The frame shows the whole report.
    assert inner.evaluate("(html) => html.scrollHeight - html.clientHeight") <= 0
    shade = page.evaluate("() => getComputedStyle(document.body).backgroundColor")
    assert (sum(map(int, re.findall(r"\d+", shade)[:3])) < 380) == (scheme == "dark")
    # Every curve of the report in the page has the colour of its class.
    off = inner.evaluate(
        """(html) => [...html.querySelectorAll('svg.chart path.curve')].filter((path) => {
            const own = [...path.classList].find((name) => /^c\\d$/.test(name));
            const probe = html.ownerDocument.body.appendChild(html.ownerDocument.createElement('i'));
            probe.style.color = own ? `var(--${own})` : 'inherit';
            const due = getComputedStyle(probe).color;
            probe.remove();
            return own && getComputedStyle(path).stroke !== due;
        }).map((path) => path.getAttribute('class'))"""
    )
    assert off == []
    assert said == []
    context.close()


def test_a_fault_is_told_and_the_next_question_is_answered(page):
    told = page.evaluate(
        """async () => {
            const { questions } = await import(new URL('engine.js', document.baseURI));
            const [fault, beside] = await Promise.all(
                ['no such task', 'library'].map((task) => questions.ask(task).catch((failure) => failure)));
            return [fault.code, fault.message, beside.code ?? 'answered', (await questions.ask('library')).oils.length];
        }"""
    )
    assert told[0] == "E501" and told[1].startswith("a fault of the program: ")
    # Who asked beside it is told, too, since the worker ends.
    assert told[2] == "E501"
    assert told[3] >= 3


def test_a_page_without_its_program_says_so(chromium, site):
    context = chromium.new_context()
    context.route("**/asperity_bg.wasm", lambda route: route.fulfill(status=404, body=""))
    page = context.new_page()
    page.goto(site[0])
    page.wait_for_selector("#error:visible")
    assert "asperity_bg.wasm: 404" in page.inner_text("#error")
    context.close()


def test_a_page_opened_as_a_file_says_what_to_do(chromium):
    context = chromium.new_context()
    page = context.new_page()
    page.goto((FOLDER / "index.html").as_uri())
    assert "http.server" in page.inner_text("#unserved")
    context.close()


def test_a_case_as_json_is_filled_into_the_form_and_goes_on_as_toml(page, tmp_path):
    inputs = command(CASES / "e-drive.toml", "--no-band", "--set", "model.positions=2", "--set", "model.offsets=1")["inputs"]
    inputs["model"] = {}
    (tmp_path / "own.json").write_text(json.dumps(inputs))
    drop(page, [tmp_path / "own.json", PROFILES / "ground_pinion.csv", PROFILES / "ground_wheel.csv"])
    page.wait_for_selector("#look-wheel:has-text('points')")
    assert page.is_hidden("#apart")
    fill(page, "title", "from JSON")
    assert page.input_value("#text").startswith('title = "from JSON"\n\n[gears]\n')
    assert run(page) == "done"
    assert b"from JSON" in result(page, "own.toml")


def test_the_page_may_ask_no_other_address(page):
    refused = page.evaluate("() => fetch('http://127.0.0.1:9/').then(() => 'sent', () => 'refused')")
    assert refused == "refused"
    assert any("Content Security Policy" in text for text in page.said)
    page.said.clear()
    page.sought.clear()
