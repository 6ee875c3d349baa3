//! A unit, and values of its parameters.

use super::Design;
use super::param::{Kind, PIPELINE, Param, Reflection, Role, Value};
use crate::base::error::{Error, Result};
use crate::number::format::Format;

/// A parameterised datapath.
#[derive(Debug)]
pub struct Unit {
    /// Name on the command line.
    pub name: &'static str,
    /// What it computes, in one line.
    pub summary: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Its own parameters; [`PIPELINE`] follows them.
    pub params: &'static [Param],
    /// Those of its own parameters that the golden model, the sampler or the set of ports depends
    /// on: designs that differ in them share no golden values.
    pub golden_params: &'static [&'static str],
    /// Names of the input ports with what they measure, for `list`.
    pub inputs: &'static str,
    /// Names of the output ports, for `list`.
    pub outputs: &'static str,
    /// Whether it shades the pixels of a scene.
    pub shades: Shading,
    /// Builds the datapath.
    pub build: fn(&Values) -> Result<Design>,
}

/// Whether a unit shades the pixels of a scene: its inputs are then those of a [fragment](crate::units::fragment), and it has outputs
/// `diffuse` and, if it has highlights, `specular`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shading {
    /// It doesn't.
    None,
    /// It does, from vectors that floating point turned into the texture frame.
    Part,
    /// It is a pipeline of its own, or has a parameter of [`Role::Pipeline`] whose choices are.
    Pipeline,
}

impl Unit {
    /// All parameters: its own, then the pipeline's.
    pub fn all_params(&self) -> impl Iterator<Item = &'static Param> + use<> {
        self.params.iter().chain(PIPELINE)
    }

    /// The parameter of a name.
    #[must_use]
    pub fn param(&self, name: &str) -> Option<&'static Param> {
        self.all_params().find(|param| param.name == name)
    }

    /// The defaults.
    ///
    /// # Panics
    /// If a default is not legal: that is wrong code.
    #[must_use]
    pub fn defaults(&'static self) -> Values {
        let values = self
            .all_params()
            .map(|param| param.parse(param.default).expect("bug: a default is legal"))
            .collect();
        Values { unit: self, values }
    }

    /// The defaults with some `key=value` assignments.
    ///
    /// # Errors
    /// If a name is unknown or given twice, or a value is not legal.
    pub fn values<S: AsRef<str>>(&'static self, assignments: &[S]) -> Result<Values> {
        let mut values = self.defaults();
        let mut given: Vec<&str> = Vec::new();
        for assignment in assignments {
            let text = assignment.as_ref();
            let (name, value) =
                text.split_once('=').ok_or_else(|| Error::form(text, "key=value"))?;
            values.set(name, value)?;
            if given.contains(&name) {
                return Err(Error::usage(format!("parameter `{name}` is given twice")));
            }
            given.push(name);
        }
        Ok(values)
    }
}

/// One value for each parameter of a unit.
#[derive(Clone, Debug)]
pub struct Values {
    unit: &'static Unit,
    values: Vec<Value>,
}

impl Values {
    /// The unit that they belong to.
    #[must_use]
    pub fn unit(&self) -> &'static Unit {
        self.unit
    }

    /// Sets one parameter from text.
    ///
    /// # Errors
    /// If the name is unknown or the value not legal.
    #[expect(clippy::missing_panics_doc, reason = "the index was found just before")]
    pub fn set(&mut self, name: &str, text: &str) -> Result<()> {
        let position = self.unit.all_params().position(|param| param.name == name);
        let index = position.ok_or_else(|| {
            Error::unknown_parameter(self.unit.name, name, self.unit.all_params().map(|p| p.name))
        })?;
        let param = self.unit.all_params().nth(index).expect("bug: found above");
        self.values[index] = param.parse(text)?;
        Ok(())
    }

    /// As [`Values::iter`], without what only counts for shared units where none are.
    pub fn told(&self) -> impl Iterator<Item = (&'static str, Value)> + '_ {
        let flat = self.choice("schedule") == "flat";
        let silent = move |role: Role| flat && (role == Role::Schedule || role.is_of_sharing());
        self.params()
            .filter(move |(param, _)| !silent(param.role))
            .map(|(p, value)| (p.name, value))
    }

    /// Pairs of parameter and value, in order.
    pub fn params(&self) -> impl Iterator<Item = (&'static Param, Value)> + '_ {
        self.unit.all_params().zip(self.values.iter().copied())
    }

    /// Pairs of name and value in the order of the parameters.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, Value)> + '_ {
        self.params().map(|(param, value)| (param.name, value))
    }

    /// The value of a parameter.
    ///
    /// # Panics
    /// If there is no such parameter.
    #[must_use]
    pub fn get(&self, name: &str) -> Value {
        self.iter().find(|(known, _)| *known == name).expect("bug: unknown parameter").1
    }

    /// A whole number; `None` for `auto`.
    ///
    /// # Panics
    /// If the parameter is none.
    #[must_use]
    pub fn int(&self, name: &str) -> Option<i64> {
        match self.get(name) {
            Value::Int(number) => Some(number),
            Value::Auto => None,
            Value::Real(_) | Value::Choice(_) => panic!("bug: `{name}` is no whole number"),
        }
    }

    /// The value of what it takes of the reflection formula, if it takes that.
    #[must_use]
    pub fn reflection(&self, part: Reflection) -> Option<Value> {
        self.params().find(|(param, _)| param.role == Role::Material(part)).map(|(_, value)| value)
    }

    /// A number.
    ///
    /// # Panics
    /// If the parameter is none.
    #[must_use]
    pub fn real(&self, name: &str) -> f64 {
        match self.get(name) {
            Value::Real(number) => number.get(),
            Value::Int(_) | Value::Auto | Value::Choice(_) => panic!("bug: `{name}` is no number"),
        }
    }

    /// A count of bits that has no `auto`.
    ///
    /// # Panics
    /// If the parameter is none.
    #[must_use]
    pub fn bits(&self, name: &str) -> u32 {
        let number = self.int(name).expect("bug: no auto here");
        u32::try_from(number).expect("bug: counts of bits are small")
    }

    /// A name.
    ///
    /// # Panics
    /// If the parameter is none.
    #[must_use]
    pub fn choice(&self, name: &str) -> &'static str {
        match self.get(name) {
            Value::Choice(choice) => choice,
            Value::Int(_) | Value::Real(_) | Value::Auto => panic!("bug: `{name}` is no name"),
        }
    }

    /// The error for a value that is legal by itself and not together with others.
    #[must_use]
    pub fn refuse(&self, name: &str, legal: &str) -> Error {
        Error::parameter_value(name, &self.get(name).to_string(), legal.to_owned())
    }

    /// Builds the datapath.
    ///
    /// # Errors
    /// If these values don't go together, or a word would be wider than 63 bits.
    pub fn build(&self) -> Result<Design> {
        let build = self.unit.build;
        build(self).map_err(|error| self.with_remedy(error, &|values| build(values).map(|_| ())))
    }

    /// An error of a word that is too wide in what `make` makes, with the parameters that make it narrower.
    pub(crate) fn with_remedy(&self, error: Error, make: &dyn Fn(&Self) -> Result<()>) -> Error {
        let (node, place, needed) = match error.bits_needed() {
            Some((node, place, bits)) if bits > Format::MAX_BITS => (node, place, bits),
            Some(_) | None => return error,
        };
        let narrower = |step: i64, (index, param): (usize, &Param)| -> Option<String> {
            let (Kind::Int { min, max, .. }, Value::Int(number)) = (param.kind, self.values[index])
            else {
                return None;
            };
            let changed = (number + step).clamp(min, max);
            let mut other = self.clone();
            other.values[index] = Value::Int(changed);
            let helps = changed != number
                && match make(&other) {
                    Ok(()) => true,
                    // Another node is the next one that is too wide: the first one isn't any more.
                    Err(other) => other.bits_needed().is_some_and(|(other, later, bits)| {
                        bits < needed || (other != node && later > place)
                    }),
                };
            helps.then(|| format!("`{}`", param.name))
        };
        let all = |step| -> Vec<String> {
            self.unit.params.iter().enumerate().filter_map(|param| narrower(step, param)).collect()
        };
        // Where one bit shows nothing, many may: sums of many terms pass the limit at another term.
        let steps = [(-1, "lower"), (-64, "lower"), (1, "raise")];
        let mut remedies = steps.into_iter().filter_map(|(step, verb)| {
            let names = all(step);
            (!names.is_empty()).then(|| format!("{verb} {}", names.join(" or ")))
        });
        match remedies.next() {
            Some(remedy) => error.with_remedy(remedy),
            None => error,
        }
    }
}
