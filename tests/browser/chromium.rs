//! A headless Chromium that opens a page from a file.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// Names under which Chromium is installed.
const NAMES: [&str; 4] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
];

/// A page after its scripts have run.
pub struct Opened {
    /// The document as it then stands.
    pub document: String,
    /// Lines that the page wrote to the console.
    pub console: Vec<String>,
}

/// The browser; `None` with a notice where there is none.
pub fn find() -> Option<&'static str> {
    let works = |name: &&str| {
        Command::new(name)
            .arg("--version")
            .output()
            .is_ok_and(|out| out.status.success())
    };
    let found = NAMES.into_iter().find(|name| works(name));
    if found.is_none() {
        eprintln!(
            "NOTICE: no Chromium on this machine, so no page was opened: this test proves nothing here"
        );
    }
    found
}

/// Opens `page` with its self-test, without any network, in a window of `width`.
pub fn open(browser: &str, page: &Path, width: u32) -> Opened {
    let profile = tempfile::tempdir().unwrap();
    let output = Command::new(browser)
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-quic",
            "--no-first-run",
        ])
        .args([
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
        ])
        .args([
            "--host-resolver-rules=MAP * ~NOTFOUND",
            "--enable-logging=stderr",
        ])
        .args(["--virtual-time-budget=5000", "--dump-dom"])
        .arg(format!("--window-size={width},900"))
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .arg(format!("file://{}#selftest", page.display()))
        .output()
        .unwrap();
    let messages = String::from_utf8_lossy(&output.stderr);
    Opened {
        document: String::from_utf8_lossy(&output.stdout).into_owned(),
        console: messages
            .lines()
            .filter(|line| line.contains("CONSOLE"))
            .map(str::to_owned)
            .collect(),
    }
}

impl Opened {
    /// Findings of the page's self-test.
    pub fn selftest(&self) -> Value {
        let start = self
            .document
            .find("<pre id=\"selftest\"")
            .expect("the page has run its self-test");
        let text = &self.document[start..];
        let (from, to) = (text.find('>').unwrap() + 1, text.find("</pre>").unwrap());
        serde_json::from_str(
            &text[from..to]
                .replace("&amp;", "&")
                .replace("&lt;", "<")
                .replace("&gt;", ">"),
        )
        .unwrap()
    }

    /// Text of the element that shows the value at `key` of the result.
    pub fn shown(&self, key: &str) -> String {
        let start = self
            .document
            .find(&format!("data-key=\"{key}\""))
            .unwrap_or_else(|| panic!("{key} is shown"));
        let text = &self.document[start..];
        text[text.find('>').unwrap() + 1..text.find("</").unwrap()].to_owned()
    }
}
