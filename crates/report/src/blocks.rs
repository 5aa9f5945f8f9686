//! Report of a study: a list of blocks, each stated once, which terminal, page and folder walk.
//!
//! | block | terminal | page | folder |
//! |---|---|---|---|
//! | [`verdict`](Report::verdict): the answer | a line | bold | |
//! | [`text`](Report::text) | a paragraph | a paragraph | |
//! | [`warning`](Report::warning) | indented after its code | a paragraph | |
//! | [`method`](Report::method): how to read the numbers | a paragraph | folded, at the end | |
//! | [`table`](Report::table) | aligned columns | a table | its file, if it has one |
//! | [`figures`](Report::figures) | | charts | |
//! | [`code`](Report::code): text to copy | as it is | as it is | |
//! | [`rows`](Report::rows), [`text_file`](Report::text_file), [`file`](Report::file) | | | a file |
//! | [`markup`](Report::markup) | | as it is | |
//!
//! [`section`](Report::section) and [`heading`](Report::heading) part them; [`on_page`](Report::on_page) and
//! [`in_terminal`](Report::in_terminal) leave blocks to one face, [`in_folder`](Report::in_folder) leaves a table to the folder.

use std::fmt::Display;
use std::path::Path;

use asperity_core::message::gravest_first;
use asperity_core::{Code, Fault, PROGRAM, capitalised};
use asperity_storage::one_line;
use maud::{Markup, Render, html};
use serde::Serialize;

use crate::chart::Drawing;
use crate::columns::Table;
use crate::html::overview::DOUBTFUL;
use crate::html::{PageSection, figure, page_of};
use crate::wrap::wrapped;
use crate::{tables, write_text};

/// The code at the beginning of a warning.
fn code_of(warning: &str) -> Option<Code> {
    warning.split(' ').next()?.parse().ok()
}

/// Whether a warning makes the result doubtful.
fn is_doubtful(warning: &str) -> bool {
    code_of(warning).is_some_and(|code| code.doubt().is_some())
}

/// Number of lines that a first screen leaves out, and of the warnings among them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct LeftOut {
    /// Lines.
    pub lines: usize,
    /// Warnings.
    pub warnings: usize,
}

impl Display for LeftOut {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let plural = |count: usize| if count == 1 { "" } else { "s" };
        let Self { lines, warnings } = *self;
        write!(f, "{lines} more line{}", plural(lines))?;
        match warnings {
            0 => Ok(()),
            _ => write!(f, " with {warnings} warning{}", plural(warnings)),
        }
    }
}

/// Report of a study.
///
/// ```
/// use asperity_core::Estimate;
/// use asperity_report::{Cell, Report, columns};
/// let ground = Estimate::new(706.2, [562.0, 918.0]);
/// let superfinished = Estimate::new(452.1, [361.0, 557.0]);
/// let table = columns! { (name, loss) in [("ground", ground), ("superfinished", superfinished)];
///     head finish "finish" "" = name;
///     interval loss_w "loss" "W" = Cell::interval(loss);
/// };
/// let report = Report::new("Two finishes", "example")
///     .section("Losses")
///     .verdict(["Superfinished flanks lose less."])
///     .table(table.in_file("losses.csv"));
/// let lines = [
///     "Two finishes",
///     "Superfinished flanks lose less.",
///     "finish               loss [W]",
///     "ground         710 (560..920)",
///     "superfinished  450 (360..560)",
/// ];
/// assert_eq!(report.terminal().lines().collect::<Vec<_>>(), lines);
/// assert!(report.page().contains("<td class=\"number\">710 (560..920)</td>"));
/// ```
#[must_use]
pub struct Report<'a> {
    title: String,
    subtitle: String,
    blocks: Vec<(BlockFaces, Block<'a>)>,
    /// Number of the first block of the last call.
    last: usize,
}

/// The faces that show a block.
#[derive(Clone, Copy, PartialEq, Eq)]
enum BlockFaces {
    Both,
    Page,
    Terminal,
    Folder,
}

/// Writes a file of the folder.
type Writer<'a> = Box<dyn Fn(&Path) -> Result<(), Fault> + 'a>;

enum Block<'a> {
    Section { name: String, is_folded: bool },
    Heading(String),
    Verdict(String),
    Text(String),
    Warning(String),
    Method(String),
    Code(String),
    Table(Table),
    Figures(Box<dyn Fn() -> Vec<Drawing> + 'a>),
    Markup(Box<dyn Fn() -> Markup + 'a>),
    File(Writer<'a>),
}

impl Block<'_> {
    /// The block within a section.
    fn markup(&self) -> Markup {
        match self {
            Self::Verdict(line) => html! { p.answer { (line) } },
            Self::Text(line) => html! { p { (line) } },
            Self::Warning(line) => {
                if is_doubtful(line) {
                    html! { p.grave { strong { (DOUBTFUL) } " " (line) } }
                } else {
                    html! { p { (line) } }
                }
            }
            Self::Heading(line) => html! { h3 { (line) } },
            Self::Code(code) => html! { pre { code { (code) } } },
            Self::Table(table) => table.render(),
            Self::Figures(draw) => {
                let drawings = draw();
                // Fields are compared side by side.
                let is_field = |drawing: &Drawing| matches!(drawing, Drawing::Contour(_));
                let are_fields = drawings.len() > 1 && drawings.iter().all(is_field);
                html! { @if !drawings.is_empty() {
                    div.charts.fields[are_fields] { @for drawing in &drawings { (figure(drawing)) } }
                } }
            }
            Self::Markup(write) => write(),
            Self::Method(line) => html! { p.note { (line) } },
            Self::Section { .. } | Self::File(_) => html! {},
        }
    }
}

/// Indent of the lines after the first of a sentence in a terminal.
const HANGING: &str = "    ";
/// Name of the section of a page with the method.
const METHOD: &str = "Method";

/// Scope of the losses of studies.
pub const OF_MESHES: &str =
    "The losses are of the meshes only, without bearings, seals and churning.";

impl<'a> Report<'a> {
    /// A report with `title`; below it the page says which kind of study it is.
    pub fn new(title: &str, subtitle: impl Display) -> Self {
        Self {
            title: title.to_owned(),
            subtitle: subtitle.to_string(),
            blocks: Vec::new(),
            last: 0,
        }
    }

    fn with(mut self, blocks: impl IntoIterator<Item = Block<'a>>) -> Self {
        self.last = self.blocks.len();
        let blocks = blocks.into_iter().map(|block| (BlockFaces::Both, block));
        self.blocks.extend(blocks);
        self
    }

    fn only(mut self, faces: BlockFaces) -> Self {
        for (of, _) in &mut self.blocks[self.last..] {
            *of = faces;
        }
        self
    }

    /// Leaves the blocks of the last call to the page.
    pub fn on_page(self) -> Self {
        self.only(BlockFaces::Page)
    }

    /// Leaves the blocks of the last call to the terminal.
    pub fn in_terminal(self) -> Self {
        self.only(BlockFaces::Terminal)
    }

    /// Leaves the tables of the last call to the folder.
    pub fn in_folder(self) -> Self {
        self.only(BlockFaces::Folder)
    }

    /// A section of the page; the terminal goes on without a line. An empty section is omitted.
    pub fn section(self, name: &str) -> Self {
        let name = name.to_owned();
        let is_folded = false;
        self.with([Block::Section { name, is_folded }])
    }

    /// A section of the page that is folded on the screen.
    pub fn folded(self, name: &str) -> Self {
        let name = name.to_owned();
        let is_folded = true;
        self.with([Block::Section { name, is_folded }])
    }

    /// A heading of what follows, within a section.
    pub fn heading(self, text: impl Into<String>) -> Self {
        self.with([Block::Heading(text.into())])
    }

    /// Sentences that answer the question, each with a capital at its beginning.
    pub fn verdict(self, lines: impl IntoIterator<Item = impl AsRef<str>>) -> Self {
        let lines = lines.into_iter();
        self.with(lines.map(|line| Block::Verdict(capitalised(line.as_ref()))))
    }

    /// Paragraphs.
    pub fn text(self, lines: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.with(lines.into_iter().map(|line| Block::Text(line.into())))
    }

    /// A paragraph of the page with operating point, positions and offsets of the runs, and the scope of their losses; none without `conditions`.
    pub fn at(self, conditions: &str) -> Self {
        self.text((!conditions.is_empty()).then(|| format!("At {conditions}. {OF_MESHES}")))
            .on_page()
    }

    /// Warnings, the gravest first; each begins with its code.
    pub fn warning<W: Display>(self, warnings: impl IntoIterator<Item = W>) -> Self {
        let warnings = warnings.into_iter().map(|warning| warning.to_string());
        let mut warnings: Vec<String> = warnings.collect();
        gravest_first(&mut warnings, |text| code_of(text));
        self.with(warnings.into_iter().map(Block::Warning))
    }

    /// How the numbers are made and what they mean.
    pub fn method(self, lines: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.with(lines.into_iter().map(|line| Block::Method(line.into())))
    }

    /// Text to copy.
    pub fn code(self, text: impl Into<String>) -> Self {
        self.with([Block::Code(text.into())])
    }

    /// A table; it is not shown without rows.
    pub fn table(self, table: Table) -> Self {
        self.with([Block::Table(table)])
    }

    /// Charts, which only the page draws.
    pub fn figures<I: IntoIterator<Item = Drawing>>(self, draw: impl Fn() -> I + 'a) -> Self {
        let draw = move || draw().into_iter().collect();
        self.with([Block::Figures(Box::new(draw))])
    }

    /// Markup of the page for which there is no other block.
    pub fn markup(self, write: impl Fn() -> Markup + 'a) -> Self {
        self.with([Block::Markup(Box::new(write))])
    }

    /// `rows` as the table `file` of the folder.
    pub fn rows<R: Serialize, I: IntoIterator<Item = R>>(
        self,
        file: impl Into<String>,
        rows: impl Fn() -> I + 'a,
    ) -> Self {
        let file = file.into();
        self.file(move |folder| tables::write(&folder.join(&file), rows()))
    }

    /// `text` as the file `name` of the folder.
    pub fn text_file(self, name: &'static str, text: String) -> Self {
        self.file(move |folder| write_text(&folder.join(name), &text))
    }

    /// Files of the folder that `write` writes.
    pub fn file(self, write: impl Fn(&Path) -> Result<(), Fault> + 'a) -> Self {
        self.with([Block::File(Box::new(write))])
    }

    /// The report in a terminal, with everything that it holds.
    #[must_use]
    pub fn terminal(&self) -> String {
        let mut text = self.title_line();
        let mut is_after_table = false;
        for (block, part) in self.parts() {
            let is_table = matches!(block, Block::Table(_));
            let is_parted = is_table || matches!(block, Block::Heading(_));
            if is_parted && is_after_table && !part.is_empty() {
                text.push('\n');
            }
            is_after_table = is_table && (is_after_table || !part.is_empty());
            text += &part;
        }
        text
    }

    /// The first screen in a terminal, of at most `lines` lines, and what it leaves out: the verdict, a short warning, then the
    /// first table with its heading as far as there is room, or all of it if it is the answer, then texts and other warnings.
    #[must_use]
    pub fn brief(&self, lines: usize) -> (String, LeftOut) {
        let title = self.title_line();
        let parts = self.parts();
        let count = |part: &str| part.lines().count();
        let mut shown: Vec<usize> = vec![0; parts.len()];
        let mut room = lines.saturating_sub(count(&title));
        // Shows whole parts, and of the last of them as many lines as there is room for, but `least`; `None` shows all of it.
        let mut show = |of: &[usize], least: Option<usize>| {
            let Some((last, before)) = of.split_last() else {
                return;
            };
            let above: usize = before.iter().map(|k| count(&parts[*k].1)).sum();
            let all = count(&parts[*last].1);
            let fits = match least {
                Some(_) => all.min(room.saturating_sub(above)),
                None => all,
            };
            if fits >= least.unwrap_or(all).min(all) {
                for k in before {
                    shown[*k] = count(&parts[*k].1);
                }
                shown[*last] = fits;
                room = room.saturating_sub(above + fits);
            }
        };
        let of = |is_wanted: fn(&Block<'_>) -> bool| {
            let blocks = parts.iter().enumerate();
            let wanted = blocks.filter(move |(_, (block, _))| is_wanted(block));
            wanted.map(|(k, _)| k).collect::<Vec<usize>>()
        };
        let height = |of: &[usize]| of.iter().map(|k| count(&parts[*k].1)).sum::<usize>();
        let verdicts = of(|block| matches!(block, Block::Verdict(_)));
        let below = lines.saturating_sub(count(&title) + height(&verdicts));
        for k in verdicts {
            show(&[k], Some(1));
        }
        let table = of(|block| matches!(block, Block::Table(table) if !table.is_empty()));
        let table: Vec<usize> = table.first().map_or(Vec::new(), |k| {
            let title = k.checked_sub(1);
            let title = title.filter(|above| matches!(parts[*above].0, Block::Heading(_)));
            title.into_iter().chain([*k]).collect()
        });
        // Of the warnings the first is worth more than rows of a table, unless it is a paragraph, or the only reason why the table
        // is cut.
        let warnings = of(|block| matches!(block, Block::Warning(_)));
        let cuts = |own: usize| height(&table) <= below && own + height(&table) > below;
        let first = warnings.first().filter(|k| {
            let own = count(&parts[**k].1);
            own <= 3 && !cuts(own)
        });
        if let Some(k) = first {
            show(&[*k], Some(usize::MAX));
        }
        if let Some(k) = table.last() {
            // Of a table there are its headings and a row at least.
            let (heading, is_answer) = match parts[*k].0 {
                Block::Table(table) => (table.heading_height(), table.is_answer()),
                _ => (0, false),
            };
            show(&table, (!is_answer).then_some(heading + 1));
        }
        let texts = of(|block| matches!(block, Block::Text(_)));
        let others = warnings.iter().skip(usize::from(first.is_some()));
        for k in texts.iter().chain(others) {
            show(&[*k], Some(usize::MAX));
        }
        let all: usize = parts.iter().map(|(_, part)| count(part)).sum();
        let left_out = LeftOut {
            lines: all - shown.iter().sum::<usize>(),
            warnings: warnings.iter().filter(|k| shown[**k] == 0).count(),
        };
        let parts = parts.iter().zip(shown);
        let text = parts.flat_map(|((_, part), lines)| part.split_inclusive('\n').take(lines));
        (title + &text.collect::<String>(), left_out)
    }

    fn title_line(&self) -> String {
        if self.title.is_empty() {
            String::new()
        } else {
            format!("{}\n", one_line(&self.title))
        }
    }

    /// The blocks of the terminal with their lines.
    fn parts(&self) -> Vec<(&Block<'a>, String)> {
        let blocks = self.blocks.iter();
        let blocks =
            blocks.filter(|(faces, _)| matches!(faces, BlockFaces::Both | BlockFaces::Terminal));
        let part = |(_, block): &'_ (BlockFaces, Block<'a>)| -> Option<String> {
            let (shown, indent) = match block {
                Block::Verdict(line) | Block::Text(line) => (line, HANGING),
                Block::Heading(line) | Block::Method(line) => (line, ""),
                Block::Warning(line) => (line, "     "),
                Block::Code(code) => return Some(code.clone()),
                Block::Table(table) => return Some(table.text("")),
                _ => return None,
            };
            Some(wrapped(&one_line(shown), indent) + "\n")
        };
        blocks
            .filter_map(|block| Some((&block.1, part(block)?)))
            .collect()
    }

    /// The lines of the verdict in a terminal.
    #[must_use]
    pub fn verdict_lines(&self) -> Vec<String> {
        let verdicts = self.blocks.iter().filter_map(|(_, block)| match block {
            Block::Verdict(line) => Some(wrapped(&one_line(line), HANGING)),
            _ => None,
        });
        let lines = verdicts.flat_map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>());
        lines.collect()
    }

    /// The report as a page.
    #[must_use]
    pub fn page(&self) -> String {
        let mut sections = vec![PageSection::new("", false)];
        let mut method = Vec::new();
        for block in self.on_pages() {
            let markup = match block {
                Block::Section { name, is_folded } => {
                    sections.push(PageSection::new(name, *is_folded));
                    continue;
                }
                Block::Method(line) => {
                    method.push(line);
                    continue;
                }
                block => block.markup(),
            };
            if let Some(section) = sections.last_mut() {
                section.body.0 += &markup.0;
            }
        }
        sections.push(PageSection {
            body: html! { @for line in method { p { (line) } } },
            ..PageSection::new(METHOD, true)
        });
        let subtitle = format!("{PROGRAM} · {}", self.subtitle);
        page_of(&self.title, &subtitle, Some("study"), &sections)
    }

    /// The blocks that a page shows.
    fn on_pages(&self) -> impl Iterator<Item = &Block<'a>> {
        let blocks = self.blocks.iter();
        let blocks =
            blocks.filter(|(faces, _)| matches!(faces, BlockFaces::Both | BlockFaces::Page));
        blocks.map(|(_, block)| block)
    }

    /// Writes the files of the report into `folder`.
    ///
    /// # Errors
    /// When a file cannot be written, or a number is not finite.
    pub(crate) fn write_files(&self, folder: &Path) -> Result<(), Fault> {
        self.blocks.iter().try_for_each(|(_, block)| match block {
            Block::File(write) => write(folder),
            Block::Table(table) if table.is_file() => table.write(folder),
            _ => Ok(()),
        })
    }
}
