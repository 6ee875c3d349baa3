//! The formats and table schemes that a recipe chooses, and overrides for them.

use super::{Netlist, NodeId};
use crate::base::error::{Error, Result};
use crate::number::format::Format;
use std::collections::{BTreeMap, BTreeSet};

/// Where a recipe asks for a format. The place doesn't depend on the formats before it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Place {
    /// The `number`th `narrow` of a scope, from 1.
    Narrow {
        /// The scope's path.
        scope: String,
        /// Also counts the `narrow`s that need no node.
        number: u32,
    },
    /// All tables of a name.
    Table(String),
}

/// A format that a recipe asked for while it ran.
#[derive(Debug)]
pub(super) struct Asked {
    pub(super) place: Place,
    /// The format it got.
    pub(super) format: Format,
    /// The node, if it is a `narrow`.
    pub(super) node: Option<NodeId>,
    /// The name by which the format was overridden.
    pub(super) given: Option<String>,
}

/// A format that a netlist's recipe chose: that of a `narrow` or of a table's result.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Its stable name: the node's own name, or `scope.narrow`, `scope.narrow_2` by its place in
    /// the scope; for a table, the table's name.
    pub name: String,
    /// Its format.
    pub format: Format,
    /// The node, if it is a `narrow`.
    pub node: Option<NodeId>,
    /// True if an override gave the format.
    pub overridden: bool,
    places: Vec<Place>,
}

/// Formats that replace the recipe's for some nodes of a netlist, by their [stable
/// names](Choice::name).
///
/// The recipe is run again with these formats, so later nodes' formats follow. Rounding and
/// overflow modes stay the recipe's.
///
/// ```
/// use fixpath::error::Result;
/// use fixpath::format::{Format, Overflow, Round};
/// use fixpath::netlist::{Builder, Netlist, Overrides, Quantity};
///
/// fn recipe(overrides: &Overrides) -> Result<Netlist> {
///     let mut b = Builder::with("cube", overrides);
///     let x = b.input("x", Format::signed(8, 7)?, Quantity::Number);
///     let square = b.mul(x, x);
///     let square = b.narrow(square, Format::unsigned(9, 8)?, Round::HalfEven, Overflow::Saturate);
///     b.name(square, "square");
///     let cube = b.mul(square, x);
///     b.output("cube", cube);
///     b.build()
/// }
///
/// let plain = recipe(&Overrides::default())?;
/// assert_eq!(plain.choices()[0].name, "square");
/// let coarse = recipe(&Overrides::new(&plain, &[("square", "u5f4".parse()?)])?)?;
/// let format = |netlist: &Netlist| netlist.node(netlist.outputs()[0].node).format.to_string();
/// assert_eq!((format(&plain), format(&coarse)), ("s17f15".to_owned(), "s13f11".to_owned()));
///
/// let why = Overrides::new(&plain, &[("sqare", Format::FLAG)]).unwrap_err().to_string();
/// assert!(why.contains("did you mean `square`"), "{why}");
/// # Ok::<(), fixpath::error::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Overrides {
    at: BTreeMap<Place, (Format, String)>,
    /// Schemes by table name.
    schemes: BTreeMap<String, String>,
}

/// A table whose scheme its recipe chose.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SchemeChoice {
    /// Its name.
    pub table: String,
    /// Name of its scheme.
    pub scheme: String,
    /// True if an override gave the scheme.
    pub overridden: bool,
}

impl Overrides {
    /// Formats for nodes of `plain`, which is the recipe's netlist without overrides.
    ///
    /// # Errors
    /// If a name is given twice, or the netlist has no such node.
    pub fn new<N: AsRef<str>>(plain: &Netlist, formats: &[(N, Format)]) -> Result<Self> {
        let mut at = BTreeMap::new();
        for (name, format) in formats {
            let name = name.as_ref();
            let choice = plain.choices.iter().find(|choice| choice.name == name);
            let choice = choice.ok_or_else(|| {
                let known: Vec<&str> = plain.choices.iter().map(|c| &c.name[..]).collect();
                Error::unknown_node(&plain.name, name, &known)
            })?;
            for place in &choice.places {
                if at.insert(place.clone(), (*format, name.to_owned())).is_some() {
                    return Err(Error::usage(format!(
                        "the format of node `{name}` is given twice"
                    )));
                }
            }
        }
        Ok(Self { at, schemes: BTreeMap::new() })
    }

    /// Adds schemes for tables, which replace the recipe's.
    ///
    /// # Errors
    /// If a name is given twice, or the netlist has no such table.
    pub fn with_schemes(mut self, plain: &Netlist, schemes: &[(&str, &str)]) -> Result<Self> {
        for (table, scheme) in schemes {
            if plain.schemes.iter().all(|choice| choice.table != *table) {
                let known: Vec<&str> = plain.schemes.iter().map(|c| &c.table[..]).collect();
                return Err(Error::unknown_table(&plain.name, table, &known));
            }
            if self.schemes.insert((*table).to_owned(), (*scheme).to_owned()).is_some() {
                return Err(Error::usage(format!("the scheme of table `{table}` is given twice")));
            }
        }
        Ok(self)
    }

    /// The scheme of a table, if it is overridden.
    pub(super) fn scheme(&self, table: &str) -> Option<&str> {
        self.schemes.get(table).map(String::as_str)
    }

    /// The format at a place, with the node's name if it is overridden.
    pub(super) fn at(&self, place: &Place, format: Format) -> (Format, Option<String>) {
        match self.at.get(place) {
            Some((given, name)) => (*given, Some(name.clone())),
            None => (format, None),
        }
    }

    /// An overridden node that the recipe didn't ask for.
    pub(super) fn unasked(&self, asked: &[Asked]) -> Option<&str> {
        let met: BTreeSet<&str> = asked.iter().filter_map(|asked| asked.given.as_deref()).collect();
        self.at.values().map(|(_, name)| &name[..]).find(|name| !met.contains(name))
    }

    /// A table whose scheme is overridden but wasn't asked for by the recipe.
    pub(super) fn unasked_scheme(&self, asked: &[SchemeChoice]) -> Option<&str> {
        let met = |table: &str| asked.iter().any(|choice| choice.table == table);
        self.schemes.keys().map(String::as_str).find(|table| !met(table))
    }
}

impl Netlist {
    /// The nodes whose formats the recipe chose, in order of first use.
    #[must_use]
    pub fn choices(&self) -> &[Choice] {
        &self.choices
    }

    /// The tables whose schemes the recipe chose, in order.
    #[must_use]
    pub fn schemes(&self) -> &[SchemeChoice] {
        &self.schemes
    }

    /// The name by which a node's format can be [overridden](Overrides); `None` for a node whose
    /// format follows from its operands.
    #[must_use]
    pub fn stable_name(&self, id: NodeId) -> Option<&str> {
        self.choices.iter().find(|choice| choice.node == Some(id)).map(|choice| &choice.name[..])
    }

    /// Names the formats that a recipe asked for. `asked` holds the ids of this netlist, without
    /// nodes that no output needs.
    pub(super) fn choose(&mut self, asked: Vec<Asked>) {
        let labels = self.ids().filter(|id| self.node(*id).name.is_some()).map(|id| self.label(id));
        let given = asked.iter().filter_map(|asked| asked.given.clone());
        let mut taken: BTreeSet<String> = labels.chain(given).collect();
        let mut choices: Vec<Choice> = Vec::new();
        for Asked { place, format, node, given } in asked {
            let same = |known: &&mut Choice| match &given {
                Some(name) => known.overridden && known.name == *name,
                None => {
                    !known.overridden
                        && known.node == node
                        && (node.is_some() || known.places[0] == place)
                }
            };
            if let Some(known) = choices.iter_mut().find(same) {
                if known.places.iter().all(|known| *known != place) {
                    known.places.push(place);
                }
                continue;
            }
            let overridden = given.is_some();
            let own = node.filter(|id| self.node(*id).name.is_some()).map(|id| self.label(id));
            let name = given.or(own).unwrap_or_else(|| place.name(&mut taken));
            choices.push(Choice { name, format, node, overridden, places: vec![place] });
        }
        self.choices = choices;
    }
}

impl Place {
    /// A name for an unnamed node, derived from its place.
    fn name(&self, taken: &mut BTreeSet<String>) -> String {
        let base = match self {
            Self::Narrow { scope, number } => {
                let dot = if scope.is_empty() { "" } else { "." };
                let number = if *number == 1 { String::new() } else { format!("_{number}") };
                format!("{scope}{dot}narrow{number}")
            }
            Self::Table(name) => name.clone(),
        };
        let other = if let Self::Table(_) = self { "table" } else { "here" };
        let name = (0..)
            .map(|n| match n {
                0 => base.clone(),
                1 => format!("{base}_{other}"),
                n => format!("{base}_{other}_{n}"),
            })
            .find(|name| !taken.contains(name))
            .expect("bug: there is no end of numbers");
        taken.insert(name.clone());
        name
    }
}

/// Runs a recipe with other formats for some of its nodes. Runs it once without overrides, to
/// resolve the names.
///
/// # Errors
/// The recipe's errors, or that it has no such node.
pub fn with_formats<N: AsRef<str>>(
    formats: &[(N, Format)],
    recipe: impl Fn(&Overrides) -> Result<Netlist>,
) -> Result<Netlist> {
    let plain = recipe(&Overrides::default())?;
    if formats.is_empty() {
        return Ok(plain);
    }
    recipe(&Overrides::new(&plain, formats)?)
}
