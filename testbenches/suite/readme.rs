//! Pages are rendered from templates; their measurements come from figures.
//!
//! A template `.readme/PAGE.md.jinja` gives `PAGE.md`. It reads the documents that the commands of
//! `.readme/measure` wrote, as `f.NAME`. `.readme/figures.json` keeps the parts that templates
//! read.

use minijinja::value::{Enumerator, Kwargs, Object, ObjectRepr, Value};
use minijinja::{AutoEscape, Environment, Error, ErrorKind, UndefinedBehavior, context};
use serde_json::{Map, Value as Json};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Arc, Mutex, PoisonError};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/.readme/figures.json");

/// Held while figures are read and rewritten.
static LOCK: Mutex<()> = Mutex::new(());

fn bless() -> bool {
    std::env::var_os("FIXPATH_BLESS").is_some()
}

fn kept() -> Map<String, Json> {
    serde_json::from_str(&fs::read_to_string(FILE).unwrap()).unwrap()
}

fn keep(mut figures: Map<String, Json>) {
    figures.sort_keys();
    fs::write(FILE, serde_json::to_string_pretty(&figures).unwrap() + "\n").unwrap();
}

/// Replaces the documents that have the same name as one in the folder.
fn take(figures: &mut Map<String, Json>, folder: &Path) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        figures.insert(name, serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap());
    }
}

/// Figures that a test measures must equal the kept ones.
pub(crate) fn is_told(name: &str, measured: &Json) {
    let _lock = LOCK.lock().unwrap_or_else(PoisonError::into_inner);
    let mut figures = kept();
    if bless() {
        figures.insert(name.to_owned(), measured.clone());
        keep(figures);
    } else {
        assert_eq!(figures.get(name), Some(measured), "FIXPATH_BLESS=1 rewrites {FILE}");
    }
}

/// A part of the figures, as templates see it; it records which numbers and texts they read.
#[derive(Clone, Debug)]
struct Part {
    all: Arc<Json>,
    /// A JSON pointer.
    at: String,
    read: Arc<Mutex<BTreeSet<String>>>,
}

impl Part {
    fn json(&self) -> &Json {
        self.all.pointer(&self.at).expect("made only for an existing part")
    }

    /// The parts of `part` that were read, with the command and the version that produced it.
    fn was_read(&self, at: &str, part: &Json) -> Option<Json> {
        let inner = |key: &str, part: &Json| self.was_read(&format!("{at}/{key}"), part);
        match part {
            Json::Object(members) => {
                let mut read: Map<String, Json> = members
                    .iter()
                    .filter_map(|(key, part)| Some((key.clone(), inner(key, part)?)))
                    .collect();
                if !read.is_empty() && at.matches('/').count() == 1 {
                    let source = ["command", "version"];
                    let source = members.iter().filter(|(key, _)| source.contains(&key.as_str()));
                    read.extend(source.map(|(key, part)| (key.clone(), part.clone())));
                }
                (!read.is_empty()).then_some(Json::Object(read))
            }
            Json::Array(elements) => {
                let read = elements.iter().enumerate();
                let read: Vec<_> = read.map(|(i, part)| inner(&i.to_string(), part)).collect();
                let any = read.iter().any(Option::is_some);
                any.then(|| read.into_iter().map(Option::unwrap_or_default).collect())
            }
            Json::Null | Json::Bool(_) | Json::Number(_) | Json::String(_) => {
                self.read.lock().unwrap().contains(at).then(|| part.clone())
            }
        }
    }
}

impl Object for Part {
    fn repr(self: &Arc<Self>) -> ObjectRepr {
        if self.json().is_array() { ObjectRepr::Seq } else { ObjectRepr::Map }
    }

    fn get_value(self: &Arc<Self>, key: &Value) -> Option<Value> {
        let at = format!("{}/{key}", self.at);
        let part = self.all.pointer(&at)?;
        if part.is_object() || part.is_array() {
            return Some(Value::from_object(Self { at, ..Self::clone(self) }));
        }
        self.read.lock().unwrap().insert(at);
        Some(Value::from_serialize(part))
    }

    fn enumerate(self: &Arc<Self>) -> Enumerator {
        let array = self.json().as_array();
        array.map_or(Enumerator::NonEnumerable, |array| Enumerator::Seq(array.len()))
    }
}

/// The first element of a list with the given members.
fn pick(list: &Value, given: Kwargs) -> Result<Value, Error> {
    let keys: Vec<&str> = given.args().collect();
    'next: for element in list.try_iter()? {
        for key in &keys {
            if element.get_attr(key).unwrap_or_default() != given.get::<Value>(key)? {
                continue 'next;
            }
        }
        return Ok(element);
    }
    Err(Error::new(ErrorKind::UndefinedError, format!("nothing in the list has {given:?}")))
}

/// Rounds to significant digits; all digits before the point are kept.
fn sig(x: f64, digits: usize) -> String {
    let rounded = format!("{:.*e}", digits - 1, x);
    let exponent: i32 = rounded.split_once('e').unwrap().1.parse().unwrap();
    let places = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
    if x == 0.0 { "0".to_owned() } else { format!("{x:.places$}") }
}

/// Least and largest of a list, as `79 to 82`, both times a factor.
fn span(list: &Value, digits: usize, factor: f64) -> Result<String, Error> {
    let numbers: Result<Vec<f64>, Error> = list.try_iter()?.map(f64::try_from).collect();
    let (least, most) = numbers?
        .into_iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    let [least, most] = [least, most].map(|x| sig(x * factor, digits));
    Ok(if least == most { most } else { format!("{least} to {most}") })
}

/// An integer, from 10 000 on in groups of three digits.
fn whole(x: f64) -> String {
    let digits = format!("{x:.0}");
    let groups = digits.as_bytes().rchunks(3).rev().map(|group| str::from_utf8(group).unwrap());
    if digits.len() > 4 { groups.collect::<Vec<_>>().join(" ") } else { digits }
}

fn templates(folder: &Path) -> Vec<PathBuf> {
    let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    paths.flat_map(|path| if path.is_dir() { templates(&path) } else { vec![path] }).collect()
}

/// Every page with its path, and the part of the figures that pages use.
fn render(figures: Map<String, Json>) -> (Vec<(PathBuf, String)>, Map<String, Json>) {
    let root =
        Part { all: Arc::new(Json::Object(figures)), at: String::new(), read: Arc::default() };
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.set_auto_escape_callback(|_| AutoEscape::None);
    environment.set_keep_trailing_newline(true);
    environment.set_trim_blocks(true);
    environment.add_filter("pick", pick);
    environment.add_filter("sig", sig);
    environment.add_filter("sci", |x: f64, digits: usize| format!("{:.*e}", digits - 1, x));
    environment.add_filter("span", span);
    environment.add_filter("whole", whole);
    environment.add_filter("percent", |x: f64| format!("{:.0}", 100.0 * x));
    environment.add_filter("degrees", f64::to_degrees);
    let folder = Path::new(ROOT).join(".readme");
    let mut pages = Vec::new();
    for path in templates(&folder) {
        let Some(page) = path.to_str().unwrap().strip_suffix(".jinja") else { continue };
        let page = Path::new(ROOT).join(Path::new(page).strip_prefix(&folder).unwrap());
        let name = path.file_name().unwrap().to_str().unwrap();
        let f = Value::from_object(root.clone());
        let text = environment
            .render_named_str(name, &fs::read_to_string(&path).unwrap(), context! { f })
            .unwrap_or_else(|error| panic!("{error}; `.readme/measure` brings figures"));
        pages.push((page, text));
    }
    let Some(Json::Object(told)) = root.was_read("", &root.all) else {
        panic!("no page uses a figure")
    };
    (pages, told)
}

fn assert_same(path: &Path, is: &str, should: &str, why: &str) {
    let differs = is.lines().zip(should.lines()).find(|(is, should)| is != should);
    assert!(is == should, "{}: {why}: {differs:#?}", path.display());
}

/// FIXPATH_BLESS=1 rewrites pages and figures; FIXPATH_FIGURES names a folder of newer documents.
#[test]
fn pages_tell_the_figures() {
    let _lock = LOCK.lock().unwrap_or_else(PoisonError::into_inner);
    let mut figures = kept();
    if let Some(folder) = std::env::var_os("FIXPATH_FIGURES") {
        take(&mut figures, Path::new(&folder));
    }
    let (pages, told) = render(figures);
    if bless() {
        keep(told);
        pages.iter().for_each(|(path, text)| fs::write(path, text).unwrap());
    } else {
        assert!(
            kept() == told,
            "{FILE} holds figures that no page uses: FIXPATH_BLESS=1 rewrites it"
        );
        for (path, text) in &pages {
            let page = fs::read_to_string(path).unwrap();
            let why = "differs from its template in .readme: change that, FIXPATH_BLESS=1 rewrites the page";
            assert_same(path, &page, text, why);
        }
    }
}

/// The current program gives the figures of the pages: those that take a few seconds, or, with
/// `testbenches/run --long`, all except times.
#[test]
fn figures_are_true_today() {
    let part = if std::env::var_os("FIXPATH_LONG").is_some() { "errors" } else { "quick" };
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(Path::new(ROOT).join(".readme/measure"))
        .arg(part)
        .arg(folder.path())
        .env("FIXPATH", assert_cmd::cargo::cargo_bin("fixpath"))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let mut figures = {
        let _lock = LOCK.lock().unwrap_or_else(PoisonError::into_inner);
        kept()
    };
    let (told, _) = render(figures.clone());
    take(&mut figures, folder.path());
    let (today, _) = render(figures);
    for ((path, told), (_, today)) in told.iter().zip(&today) {
        assert_same(path, told, today, &format!("isn't true today: run .readme/measure {part}"));
    }
}

#[test]
fn numbers_as_pages_write_them() {
    let sigs = [(0.0806, 3), (147.3, 2), (99.97, 3), (0.09996, 3), (2.0, 3), (0.0, 2)];
    let texts = sigs.map(|(x, digits)| sig(x, digits));
    assert_eq!(texts, ["0.0806", "147", "100", "0.100", "2.00", "0"]);
    assert_eq!([4608.0, 13_824.0, 1e6].map(whole), ["4608", "13 824", "1 000 000"]);
    let list = Value::from_serialize([0.5, 0.25]);
    assert_eq!(span(&list, 2, 100.0).unwrap(), "25 to 50");
    assert_eq!(span(&list, 1, 0.01).unwrap(), "0.003 to 0.005");
}
