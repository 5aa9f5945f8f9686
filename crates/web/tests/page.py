"""The page served on this machine and opened in a headless browser."""

import functools
import http.server
import shutil
import threading
from contextlib import contextmanager

from playwright.sync_api import sync_playwright

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
# A run takes seconds; this is for a machine that does much else [ms].
PATIENCE = 240_000


@contextmanager
def served(folder):
    """Serves `folder` on 127.0.0.1; gives its address and the lines of the requests that came."""
    asked = []

    class Handler(http.server.SimpleHTTPRequestHandler):
        def log_message(self, format, *given):
            asked.append(format % given)

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/", asked
    finally:
        server.shutdown()
        server.server_close()


@contextmanager
def browser():
    """A headless browser of this machine that finds no other address."""
    place = next(filter(None, map(shutil.which, BROWSERS)), None)
    if place is None:
        raise SystemExit(f"none of {', '.join(BROWSERS)} is here")
    with sync_playwright() as playwright:
        rules = "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"
        opened = playwright.chromium.launch(executable_path=place, args=["--no-sandbox", rules])
        try:
            yield opened
        finally:
            opened.close()


def open_page(context, address):
    """The page, ready for input."""
    page = context.new_page()
    page.set_default_timeout(PATIENCE)
    page.goto(address)
    page.wait_for_selector("form[data-run=ready]")
    return page


def ended(page):
    """Waits for the end of a run and gives how it ended."""
    page.wait_for_selector("form[data-run=done], form[data-run=refused], form[data-run=cancelled]")
    return page.get_attribute("form", "data-run")


def result(page, name):
    """The bytes of a file that the page offers to save."""
    with page.expect_download() as saved:
        page.click(f"#files a[download='{name}']")
    return saved.value.path().read_bytes()
