//! The hardware requested by a design's pipeline parameters.

use crate::base::error::Result;
use crate::design::{Design, Role, Value, Values};
use crate::hardware::rtl::Rtl;
use crate::schedule::{Depth, Plan, Rom, Schedule, Share};
use std::sync::Arc;

impl Design {
    /// Builds the hardware requested by the pipeline parameters.
    ///
    /// # Errors
    /// If the requested latency or interval is too short, a shared unit would have words over 63
    /// bits, or a parameter of one kind of schedule is set for another.
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
        // Parameters of a shared schedule must be unset for any other.
        for (param, value) in values.params().filter(|(param, _)| param.role.is_of_sharing()) {
            if kind != "shared" && *value != param.default {
                let legal = format!(
                    "{} with schedule={kind}; it applies only to schedule=shared",
                    param.default
                );
                return Err(values.refuse(&param.name, &legal));
            }
        }
        if kind != "flat" && stages.is_some() {
            let legal = format!("auto with schedule={kind}: the schedule sets the latency");
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
                        "flat or shared: {} has no printed schedule for these parameters; that of emboss needs \
                         setting=gx and every auto switch left at auto",
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
