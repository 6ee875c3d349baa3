//! Pictures assembled from blocks of rows, on all threads.

use crate::base::cast;
use crate::base::error::Result;
use crate::design::Design;
use crate::measure::{OverflowCount, Stream, overflow_counts};
use crate::shading::picture::Picture;
use crate::shading::scene::Scene;
use crate::sim::batch::{Program, check_overflows};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

/// Rows that a thread processes at a time.
const ROWS: u32 = 8;
/// Blocks whose colours are in memory at a time.
const BLOCKS_TOGETHER: usize = 64;

/// The results of a block of rows.
pub(super) struct Block {
    pub(super) pixels: Vec<u32>,
    pub(super) golden: Vec<[f64; 3]>,
    pub(super) blinn: f64,
    pub(super) shots: Vec<BlockShot>,
}

pub(super) struct BlockShot {
    pub(super) colours: Vec<[f64; 3]>,
    pub(super) engine: Duration,
    pub(super) samples: u64,
    /// Overflow counts by stage and `narrow`.
    pub(super) overflows: Vec<Vec<u64>>,
    pub(super) angles: Stream,
}

impl BlockShot {
    /// An empty shot for these programs.
    pub(super) fn of<'a>(programs: impl Iterator<Item = &'a Program>) -> Self {
        Self {
            colours: Vec::new(),
            engine: Duration::ZERO,
            samples: 0,
            overflows: programs.map(|program| vec![0; program.narrows().len()]).collect(),
            angles: Stream::EMPTY,
        }
    }

    /// Adds up everything but the colours.
    pub(super) fn merge(&mut self, later: &Self) {
        self.engine += later.engine;
        self.samples += later.samples;
        for (total, count) in
            self.overflows.iter_mut().flatten().zip(later.overflows.iter().flatten())
        {
            *total += count;
        }
        self.angles.merge(&later.angles);
    }
}

/// Pictures assembled from blocks of rows.
pub(super) struct Gathered {
    pub(super) golden: Picture,
    pub(super) blinn: f64,
    /// Which pixels see an object.
    pub(super) covers: Vec<bool>,
    pub(super) pictures: Vec<Picture>,
    pub(super) totals: Vec<BlockShot>,
    /// Time and samples of each block, by picture.
    pub(super) rates: Vec<Vec<(Duration, u64)>>,
}

/// Renders a scene block by block on all threads; `totals` has an empty entry per picture.
pub(super) fn gather<L: Send>(
    scene: &Scene,
    mut totals: Vec<BlockShot>,
    lanes: impl Fn() -> L + Sync,
    shade_rows: impl Fn(&mut L, Range<u32>) -> Result<Block> + Sync,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Gathered> {
    let blocks = blocks(scene.image.height);
    let done = AtomicU64::new(0);
    let shade_rows = |lanes: &mut L, rows: &Range<u32>| {
        let block = shade_rows(lanes, rows.clone());
        let before = done.fetch_add(u64::from(rows.end - rows.start), Ordering::Relaxed);
        progress(before + u64::from(rows.end - rows.start));
        block
    };
    let (width, height) =
        (cast::index_of_u32(scene.image.width), cast::index_of_u32(scene.image.height));
    let background = scene.image.background.map(cast::f32_of);
    let blank = vec![background; width * height];
    let mut golden = blank.clone();
    let mut blinn = 0f64;
    let mut covers = vec![false; width * height];
    let mut pictures = vec![blank; totals.len()];
    let mut rates: Vec<Vec<(Duration, u64)>> = vec![Vec::new(); totals.len()];
    // A limited number of blocks at a time, so that memory beyond the pictures doesn't grow with
    // their height.
    let rounds = blocks.chunks(BLOCKS_TOGETHER);
    let results = rounds.flat_map(|some| -> Vec<Result<Block>> {
        some.par_iter().map_init(&lanes, shade_rows).collect()
    });
    for block in results {
        let block = block?;
        for pixel in &block.pixels {
            covers[cast::index_of_u32(*pixel)] = true;
        }
        blinn = blinn.max(block.blinn);
        let write = |pixels: &mut [[f32; 3]], colours: &[[f64; 3]]| {
            for (pixel, colour) in block.pixels.iter().zip(colours) {
                pixels[cast::index_of_u32(*pixel)] = colour.map(cast::f32_of);
            }
        };
        write(&mut golden, &block.golden);
        for (((picture, total), rates), shot) in
            pictures.iter_mut().zip(&mut totals).zip(&mut rates).zip(&block.shots)
        {
            write(picture, &shot.colours);
            total.merge(shot);
            rates.push((shot.engine, shot.samples));
        }
    }
    let picture = |pixels| Picture::new(width, height, pixels);
    Ok(Gathered {
        golden: picture(golden)?,
        blinn,
        covers,
        pictures: pictures.into_iter().map(picture).collect::<Result<_>>()?,
        totals,
        rates,
    })
}

/// The median rate, in samples per second, weighted by samples; 0 if there are none.
pub(super) fn median_rate(blocks: &mut [(Duration, u64)]) -> f64 {
    let rate = |(time, samples): &(Duration, u64)| {
        cast::f64_of_count(*samples) / time.as_secs_f64().max(1e-9)
    };
    blocks.sort_by(|a, b| rate(a).total_cmp(&rate(b)));
    let all: u64 = blocks.iter().map(|(_, samples)| samples).sum();
    let mut seen = 0;
    let middle = blocks.iter().find(|(_, samples)| {
        seen += samples;
        2 * seen >= all
    });
    middle.map_or(0.0, rate)
}

/// Overflow counts of some designs, summed by node.
pub(super) fn overflows<'a>(
    stages: impl Iterator<Item = (&'a Arc<Design>, &'a Program)>,
    counts: &[Vec<u64>],
) -> Result<Vec<OverflowCount>> {
    let mut all: Vec<OverflowCount> = Vec::new();
    for ((design, program), counts) in stages.zip(counts) {
        let (netlist, narrows) = (&design.netlist, program.narrows());
        check_overflows(netlist, narrows, counts)?;
        for overflow in overflow_counts(netlist, narrows, counts) {
            match all.iter_mut().find(|known| known.node == overflow.node) {
                Some(known) => known.count += overflow.count,
                None => all.push(overflow),
            }
        }
    }
    Ok(all)
}

/// The blocks of rows of an image.
pub(super) fn blocks(height: u32) -> Vec<Range<u32>> {
    (0..height.div_ceil(ROWS)).map(|b| b * ROWS..(b * ROWS + ROWS).min(height)).collect()
}

/// Number of true entries.
pub(super) fn count(covers: &[bool]) -> u64 {
    cast::count_of(covers.iter().filter(|covered| **covered).count())
}
