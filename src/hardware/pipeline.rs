//! The hardware that a design's pipeline parameters ask for.

use crate::base::error::Result;
use crate::design::{Design, Role, Value, Values};
use crate::hardware::rtl::Rtl;
use crate::schedule::{Depth, Plan, Rom, Schedule, Share};
use std::sync::Arc;

impl Design {
    /// The hardware that the pipeline parameters ask for.
    ///
    /// # Errors
    /// If the latency or interval asked for is too short, a shared unit would have words over 63
    /// bits, or parameters of one schedule are set for another.
    pub fn rtl(&self) -> Result<Rtl> {
        let make = |values: &Values| values.design()?.hardware().map(|_| ());
        self.hardware().map_err(|error| self.values.with_remedy(error, &make))
    }

    fn hardware(&self) -> Result<Rtl> {
        let values = &self.values;
        let rom = if values.choice("rom") == "block" { Rom::Block } else { Rom::Distributed };
        let count = |n: i64| u32::try_from(n).expect("bug: legal values are small");
        let period = count(values.int("period_ps").expect("bug: no auto here"));
        let stages = values.int("stages").map(count);
        let kind = values.choice("schedule");
        // What only a found schedule takes must not be set for another.
        for (param, value) in values.params().filter(|(param, _)| param.role.is_of_sharing()) {
            if kind != "shared" && *value != param.default {
                let legal = format!(
                    "{} with schedule={kind}; it counts with schedule=shared",
                    param.default
                );
                return Err(values.refuse(&param.name, &legal));
            }
        }
        if kind != "flat" && stages.is_some() {
            let legal = format!("auto with schedule={kind}: the schedule makes the latency");
            return Err(values.refuse("stages", &legal));
        }
        let schedule = match kind {
            "flat" => {
                let depth = stages.map_or(Depth::Period(period), Depth::Stages);
                Schedule::pipeline(&self.netlist, rom, depth)?
            }
            "shared" => {
                let latency = values.int("share_latency").map(count);
                let loads = values.choice("share_loads") == "yes";
                let shares =
                    values.params().filter_map(|(param, value)| match (param.role, value) {
                        (Role::Share(kind), Value::Int(units)) => {
                            Some(Share { kind, units: count(*units), latency, loads })
                        }
                        _ => None,
                    });
                let interval = values.int("interval").map(count);
                let plan = Plan { shares: shares.collect(), interval };
                Schedule::shared(&self.netlist, rom, period, &plan)?
            }
            _ => {
                let Some(binding) = &self.binding else {
                    let legal = format!(
                        "flat or shared: {} has no printed schedule with these parameters; that of emboss is for \
                         setting=gx and every switch that is auto left there",
                        values.unit().name
                    );
                    return Err(values.refuse("schedule", &legal));
                };
                Schedule::bound(&self.netlist, rom, period, binding)?
            }
        };
        Ok(Rtl::new(Arc::clone(&self.netlist), schedule))
    }
}
