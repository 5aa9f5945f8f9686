//! A headless Chromium that opens pages from files.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use asperity_report::html::source;
use serde_json::{Value, json};

use crate::png::Pixels;

/// Names under which Chromium is installed.
const NAMES: [&str; 4] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
];
/// Variable that says that a browser must be there: the project's CI sets it to "required".
const EXPECTED: &str = "ASPERITY_BROWSER";
const CHECK: &str = include_str!("check.js");

/// The browser; `None` with a notice where there is none.
///
/// # Panics
/// When there is none and the environment requires one.
pub fn find() -> Option<&'static str> {
    static FOUND: OnceLock<Option<&str>> = OnceLock::new();
    *FOUND.get_or_init(search)
}

fn search() -> Option<&'static str> {
    let works = |name: &&str| {
        Command::new(name)
            .arg("--version")
            .output()
            .is_ok_and(|out| out.status.success())
    };
    let found = NAMES.into_iter().find(|name| works(name));
    if found.is_none() {
        let is_required = std::env::var_os(EXPECTED).is_some_and(|value| value == "required");
        assert!(
            !is_required,
            "{EXPECTED}=required, and none of {} is installed",
            NAMES.join(", ")
        );
        eprintln!(
            "NOTICE: no Chromium on this machine, so no page was opened: this test proves nothing here"
        );
    }
    found
}

/// Fonts that the browser may use.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fonts {
    /// All that are installed.
    Installed,
    /// Those in a folder.
    Only(PathBuf),
    /// None at all.
    Missing,
}

impl Fonts {
    /// All fonts, those of each common family that is installed by themselves, and none.
    pub fn choices() -> Vec<Self> {
        let families = [
            "DejaVuSans.ttf",
            "LiberationSans-Regular.ttf",
            "NotoSans-Regular.ttf",
        ];
        let folders = families
            .iter()
            .filter_map(|file| folder_with(Path::new("/usr/share/fonts"), OsStr::new(file)));
        let only = folders.map(Self::Only);
        [Self::Installed]
            .into_iter()
            .chain(only)
            .chain([Self::Missing])
            .collect()
    }

    /// Configuration of fontconfig for these fonts only; `None` for those installed.
    fn configuration(&self, place: &Path) -> Option<PathBuf> {
        let folder = match self {
            Self::Installed => return None,
            Self::Only(folder) => format!("<dir>{}</dir>", folder.display()),
            Self::Missing => String::new(),
        };
        let file = place.join("fonts.conf");
        // The rules of the system choose among fonts and name no folders.
        let text = format!(
            "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig>{folder}\
             <include ignore_missing=\"yes\">/etc/fonts/conf.d</include><cachedir>{}</cachedir></fontconfig>",
            place.join("fonts").display()
        );
        std::fs::write(&file, text).unwrap();
        Some(file)
    }
}

/// The folder below `root` with the file `name`.
fn folder_with(root: &Path, name: &OsStr) -> Option<PathBuf> {
    let entries: Vec<_> = std::fs::read_dir(root).ok()?.flatten().collect();
    if entries.iter().any(|entry| entry.file_name() == name) {
        return Some(root.to_owned());
    }
    let folders = entries
        .iter()
        .map(|entry| entry.path())
        .filter(|path| path.is_dir());
    folders
        .into_iter()
        .find_map(|folder| folder_with(&folder, name))
}

/// How pages are looked at.
#[derive(Debug, Clone)]
pub struct Look {
    /// Widths of their windows.
    pub widths: Vec<u32>,
    /// Whether in dark colours.
    pub is_dark: bool,
    /// Fonts there are.
    pub fonts: Fonts,
    /// Whether their colours are looked at, and their charts are saved where they are widest.
    pub colours: bool,
    /// Whether their curves are read, their charts are zoomed and their sliders moved.
    pub drives: bool,
}

impl Look {
    /// In light colours with the fonts installed, driving the charts.
    pub fn at(widths: &[u32]) -> Self {
        Self {
            widths: widths.to_vec(),
            is_dark: false,
            fonts: Fonts::Installed,
            colours: true,
            drives: true,
        }
    }
}

/// What was seen of a page in a window.
#[derive(Debug)]
pub struct Opened {
    /// The page and its width.
    pub name: String,
    /// Findings of `check.js`.
    pub found: Value,
    /// Lines that the page wrote to the console.
    pub console: Vec<String>,
}

impl Opened {
    /// Text of the element that shows the value at `key` of the result.
    pub fn shown(&self, key: &str) -> &str {
        let text = self.found["shown"][key].as_str();
        text.unwrap_or_else(|| panic!("{key} is shown in {}", self.name))
    }
}

/// `page` with the check at its end, and with its scripts among those that the policy of the page lets run.
fn with_check(page: &str, wanted: &Value) -> String {
    const POLICY: &str = "script-src ";
    let scripts = [format!("window.CHECK = {wanted};"), CHECK.to_owned()];
    let allowed = scripts.each_ref().map(|script| source(script)).join(" ");
    // A page that a test makes around drawings has no policy.
    let policy = page.find(POLICY).map_or(0, |policy| policy + POLICY.len());
    let allowed = if policy > 0 {
        allowed + " "
    } else {
        String::new()
    };
    let end = page.rfind("</body>").expect("a page has an end");
    let [wanted, check] = scripts;
    let script = format!("<script>{wanted}</script><script>{check}</script>");
    let parts = [
        &page[..policy],
        &allowed,
        &page[policy..end],
        &script,
        &page[end..],
    ];
    parts.concat()
}

/// Runs the browser on `page` in `place`; the document as it stands at the end, and the console.
fn run(
    browser: &str,
    page: &Path,
    place: &Path,
    look: &Look,
    more: &[String],
) -> (String, Vec<String>) {
    let mut command = Command::new(browser);
    command
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
            "--hide-scrollbars",
        ])
        // Time of the page, which stands still while the machine computes.
        .args(["--virtual-time-budget=5000", "--dump-dom"])
        .arg(format!(
            "--blink-settings=preferredColorScheme={}",
            if look.is_dark { 0 } else { 1 }
        ))
        .arg(format!(
            "--user-data-dir={}",
            place.join("profile").display()
        ))
        .args(more);
    if let Some(file) = look.fonts.configuration(place) {
        command.env("FONTCONFIG_FILE", file);
    }
    let output = command
        .arg(format!("file://{}", page.display()))
        .output()
        .unwrap();
    let messages = String::from_utf8_lossy(&output.stderr);
    let console = messages.lines().filter(|line| line.contains("CONSOLE"));
    (
        String::from_utf8_lossy(&output.stdout).into_owned(),
        console.map(str::to_owned).collect(),
    )
}

/// What the check wrote into `document`, a line each page.
fn found(document: &str) -> Vec<Value> {
    let start = document
        .find("<pre id=\"found\"")
        .expect("the pages were checked");
    let text = &document[start..];
    let (from, to) = (text.find('>').unwrap() + 1, text.find("</pre>").unwrap());
    let text = text[from..to]
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&amp;", "&");
    let pages = text.lines().map(|line| serde_json::from_str(line).unwrap());
    pages.collect()
}

/// Opens `pages`, of a name and a text each, in one browser without any network, page by page in all widths.
pub fn open(browser: &str, pages: &[(&str, &str)], look: &Look) -> Vec<Opened> {
    let place = tempfile::tempdir().unwrap();
    let mut windows = Vec::new();
    for (name, text) in pages {
        for width in &look.widths {
            windows.push((format!("{name} at {width}"), *text, *width));
        }
    }
    let frames: String = (windows.iter().enumerate())
        .map(|(k, (_, text, width))| {
            let save = look.colours && look.widths.iter().max() == Some(width);
            let wanted = json!({
                "page": k, "drive": look.drives, "colours": look.colours, "save": save, "pixels": false
            });
            let file = format!("page-{k}.html");
            std::fs::write(place.path().join(&file), with_check(text, &wanted)).unwrap();
            format!("<iframe src=\"{file}\" width=\"{width}\" height=\"900\"></iframe>")
        })
        .collect();
    let around = format!(
        "<!doctype html><meta charset=\"utf-8\"><pre id=\"found\" hidden></pre><script>\
         addEventListener(\"message\", (e) => document.getElementById(\"found\").append(JSON.stringify(e.data), \"\\n\"));</script>{frames}"
    );
    let file = place.path().join("around.html");
    std::fs::write(&file, around).unwrap();
    let (document, console) = run(browser, &file, place.path(), look, &[]);
    let mut all = found(&document);
    all.sort_by_key(|found| found["page"].as_u64());
    let seen: Vec<u64> = all
        .iter()
        .filter_map(|found| found["page"].as_u64())
        .collect();
    let due: Vec<u64> = (0..windows.len() as u64).collect();
    assert_eq!(
        seen, due,
        "every page was checked; the console: {console:?}"
    );
    let pairs = windows.into_iter().zip(all).enumerate();
    pairs
        .map(|(k, ((name, ..), found))| {
            let own = format!("page-{k}.html");
            let console = console.iter().filter(|line| line.contains(&own));
            Opened {
                name: format!("{name}, {look:?}"),
                found,
                console: console.cloned().collect(),
            }
        })
        .collect()
}

/// A page as it was rendered.
pub struct Picture {
    pixels: Pixels,
    /// Findings of `check.js`, with places on the curves.
    pub found: Value,
}

impl Picture {
    /// Whether a pixel at `place` or next to it has about the colour `due`.
    pub fn shows(&self, place: [f64; 2], due: [f64; 3]) -> bool {
        /// Smoothing mixes a thin line with what it lies on.
        const NEAR: f64 = 60.0;
        let [x, y] = place.map(|at| at.floor() as i64);
        let close = |rgb: [u8; 3]| (0..3).all(|k| (f64::from(rgb[k]) - due[k]).abs() < NEAR);
        (-1..=1).any(|dx| (-1..=1).any(|dy| self.pixels.at(x + dx, y + dy).is_some_and(close)))
    }
}

/// Renders `page` as a whole, `size` pixels large.
pub fn render(browser: &str, page: &str, size: [u32; 2], look: &Look) -> Picture {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("page.html");
    let wanted = json!({"page": 0, "pixels": true});
    std::fs::write(&file, with_check(page, &wanted)).unwrap();
    let image = place.path().join("page.png");
    let more = [
        format!("--window-size={},{}", size[0], size[1]),
        format!("--screenshot={}", image.display()),
    ];
    let (document, _) = run(browser, &file, place.path(), look, &more);
    Picture {
        pixels: crate::png::pixels(&std::fs::read(&image).unwrap()),
        found: found(&document).remove(0),
    }
}
