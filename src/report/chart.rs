//! Draws one chart as SVG text: scales, marks, lines, labels and a legend.
//!
//! Scales and layout are computed here, not by the plotting crate: its logarithmic axes can't hold
//! zeros, and its legends cover the data.

use crate::base::cast;
use crate::base::escape;
use plotters::coord::Shift;
use plotters::element::{Drawable, PointCollection};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

const WIDTH: u32 = 900;
const HEIGHT: u32 = 600;
/// Font sizes in px.
const TITLE: f64 = 20.0;
const AXIS: f64 = 16.0;
const SMALL: f64 = 14.0;
/// Height of a line of small text.
const LINE: i32 = 20;
/// Width of a character relative to the height of its font, with a margin.
const CHARACTER: f64 = 0.56;
/// Half the size of a mark.
const MARK: i32 = 5;
/// Largest number of labels in a chart.
const MAX_LABELS: usize = 12;

const TEXT: RGBColor = RGBColor(30, 30, 30);
const FAINT: RGBColor = RGBColor(225, 225, 225);
const LEADER: RGBColor = RGBColor(130, 130, 130);
/// Okabe and Ito's palette, which is distinguishable with every common kind of colour blindness;
/// without yellow, which is faint on white.
const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(0, 0, 0),
];

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Place = (i32, i32);

/// The scale of an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Along {
    /// Linear.
    Linear,
    /// Logarithmic, with ticks at powers of 2.
    Log2,
    /// Logarithmic, with ticks at 1, 2 and 5 times powers of 10. Numbers without a logarithm (0)
    /// lie on the lower edge.
    Log10,
}

/// How a series is drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Style {
    /// Marks joined by lines.
    Joined,
    /// Marks.
    Marks,
    /// A thin dashed line.
    Dashed,
}

/// A series of points.
pub(super) struct Series {
    pub(super) label: String,
    pub(super) colour: usize,
    pub(super) mark: usize,
    pub(super) style: Style,
    pub(super) points: Vec<(f64, f64)>,
}

/// Points to ring, join and label.
pub(super) struct Front {
    pub(super) label: String,
    pub(super) points: Vec<(f64, f64, String)>,
}

/// A chart.
pub(super) struct Chart {
    pub(super) title: String,
    pub(super) caption: Vec<String>,
    pub(super) x: (String, Along),
    pub(super) y: (String, Along),
    pub(super) series: Vec<Series>,
    pub(super) front: Option<Front>,
}

/// Maps numbers to pixels.
struct Scale {
    along: Along,
    /// Ends of the axis, as logarithms on a logarithmic axis.
    lo: f64,
    hi: f64,
    from_px: f64,
    to_px: f64,
}

/// Positions of 1, 2 and 5 in a decade.
const STEPS: [(u32, f64); 3] =
    [(1, 0.0), (2, std::f64::consts::LOG10_2), (5, 0.698_970_004_336_018_8)];
const CLOSE: f64 = 1e-9;

/// The tick at 1, 2 or 5 times a power of 10 at or below a decimal logarithm.
fn step_below(x: f64) -> f64 {
    let decade = (x + CLOSE).floor();
    let steps = STEPS.iter().rev();
    let mut below = steps.map(|(_, step)| decade + step).filter(|mark| *mark <= x + CLOSE);
    below.next().unwrap_or(decade)
}

/// The tick at or above.
fn step_above(x: f64) -> f64 {
    let decade = (x + CLOSE).floor();
    let mut above = STEPS.iter().map(|(_, step)| decade + step).filter(|mark| *mark >= x - CLOSE);
    above.next().unwrap_or(decade + 1.0)
}

impl Scale {
    /// A scale that covers the numbers. It has a nonzero length even if all are equal or there is
    /// none.
    fn fit(
        numbers: impl Iterator<Item = f64> + Clone,
        along: Along,
        (from, to): (i32, i32),
    ) -> Self {
        let place = |x: f64| match along {
            Along::Linear => x,
            Along::Log2 => libm::log2(x),
            Along::Log10 => libm::log10(x),
        };
        let placed = numbers.clone().map(place).filter(|x| x.is_finite());
        let lo = placed.clone().fold(f64::INFINITY, f64::min);
        let hi = placed.fold(f64::NEG_INFINITY, f64::max);
        let (mut lo, mut hi) = if lo <= hi { (lo, hi) } else { (0.0, 0.0) };
        match along {
            Along::Linear => {
                let pad = if hi > lo { 0.05 * (hi - lo) } else { 1.0 };
                (lo, hi) = (lo - pad, hi + pad);
            }
            Along::Log2 => (lo, hi) = (lo - 0.4, hi + 0.4),
            Along::Log10 => {
                // Leave room for marks, and for zeros below everything else.
                let zeros = numbers.into_iter().any(|x| x <= 0.0);
                let pad = 0.03 * (hi - lo) + 0.02;
                lo = step_below(lo - pad - if zeros { 0.3 } else { 0.0 });
                hi = step_above(hi + pad);
            }
        }
        Self { along, lo, hi, from_px: f64::from(from), to_px: f64::from(to) }
    }

    fn at(&self, x: f64) -> i32 {
        let placed = match self.along {
            Along::Linear => x,
            Along::Log2 => libm::log2(x),
            Along::Log10 => libm::log10(x),
        };
        // The logarithm of 0 is -∞ and of negative numbers NaN: both go to the lower edge.
        let placed = if placed.is_nan() { self.lo } else { placed.clamp(self.lo, self.hi) };
        let share = (placed - self.lo) / (self.hi - self.lo);
        cast::pixel_of(self.from_px + share * (self.to_px - self.from_px))
    }

    /// Tick positions with their labels; at most as many as fit with `room_px` each.
    fn ticks(&self, room_px: f64) -> Vec<(i32, String)> {
        let most = ((self.to_px - self.from_px).abs() / room_px).max(2.0);
        let numbers: Vec<f64> = match self.along {
            Along::Linear => {
                let step = libm::exp10(step_above(libm::log10((self.hi - self.lo) / most)));
                let (first, last) = (whole(self.lo / step, true), whole(self.hi / step, false));
                (first..=last).map(|i| cast::f64_of(i) * step).collect()
            }
            Along::Log2 => {
                let (first, last) = (whole(self.lo, true), whole(self.hi, false));
                let stride = 1 + cast::usize_of(cast::f64_of(last - first) / most);
                (first..=last).step_by(stride).map(|i| libm::exp2(cast::f64_of(i))).collect()
            }
            Along::Log10 => {
                let (first, last) = (whole(self.lo, false), whole(self.hi, true));
                let fine = (self.hi - self.lo) * 3.0 <= most;
                let stride = if fine { 1 } else { 1 + cast::usize_of((self.hi - self.lo) / most) };
                (first - 1..=last)
                    .step_by(stride)
                    .flat_map(|decade| {
                        STEPS[..if fine { 3 } else { 1 }].iter().map(move |(m, _)| (*m, decade))
                    })
                    // Parsed from text, so that 0.002 is the `f64` nearest to 0.002.
                    .filter_map(|(m, decade)| format!("{m}e{decade}").parse::<f64>().ok())
                    .filter(|x| {
                        let placed = libm::log10(*x);
                        placed >= self.lo - CLOSE && placed <= self.hi + CLOSE
                    })
                    .collect()
            }
        };
        numbers.into_iter().map(|x| (self.at(x), label(x, self.along))).collect()
    }
}

/// The next whole number up or down.
fn whole(x: f64, up: bool) -> i64 {
    cast::i64_of(if up { (x - CLOSE).ceil() } else { (x + CLOSE).floor() })
}

/// A tick's label.
fn label(x: f64, along: Along) -> String {
    if along == Along::Log2 || x == 0.0 {
        return format!("{x}");
    }
    let size = x.abs();
    if size < 1e-3 {
        return format!("{x:e}");
    }
    for (unit, letter) in [(1e9, "G"), (1e6, "M"), (1e3, "k")] {
        if size >= unit {
            return format!("{} {letter}", rounded(x / unit));
        }
    }
    rounded(x)
}

/// A number without the noise in its last bits.
fn rounded(x: f64) -> String {
    let text = format!("{x:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Width of a text in px.
fn width(text: &str, size: f64) -> i32 {
    cast::pixel_of(cast::f64_of_len(text.chars().count()) * size * CHARACTER)
}

/// Breaks a text into lines that fit the chart.
fn wrapped(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if width(line, SMALL) + width(word, SMALL) < 800 => {
                line.push(' ');
                line.push_str(word);
            }
            Some(_) | None => lines.push(word.to_owned()),
        }
    }
    lines
}

/// A box in px: left, top, right, bottom.
#[derive(Clone, Copy)]
struct Box4(i32, i32, i32, i32);

impl Box4 {
    fn around((x, y): Place, half: i32) -> Self {
        Self(x - half, y - half, x + half, y + half)
    }

    fn meets(&self, other: &Self) -> bool {
        self.0 < other.2 && other.0 < self.2 && self.1 < other.3 && other.1 < self.3
    }

    fn inside(&self, other: &Self) -> bool {
        self.0 >= other.0 && self.1 >= other.1 && self.2 <= other.2 && self.3 <= other.3
    }
}

/// The drawing surface; drawing into a string can't fail.
struct Canvas<'a>(Area<'a>);

impl<'a> Canvas<'a> {
    fn text(&self, text: &str, at: Place, size: f64, anchor: (HPos, VPos)) {
        // The SVG backend divides sizes by 1.24.
        let style = ("sans-serif", size * 1.24).into_font().color(&TEXT);
        let text = escape::line(text).into_owned();
        self.draw(&Text::new(text, at, style.pos(Pos::new(anchor.0, anchor.1))));
    }

    fn upright_text(&self, text: &str, at: Place, size: f64) {
        let font = ("sans-serif", size * 1.24).into_font().transform(FontTransform::Rotate270);
        let style = font.color(&TEXT).pos(Pos::new(HPos::Center, VPos::Center));
        self.draw(&Text::new(escape::line(text).into_owned(), at, style));
    }

    fn line(&self, points: Vec<Place>, style: impl Into<ShapeStyle>) {
        self.draw(&PathElement::new(points, style));
    }

    /// Draws dashes along a line, in phase across its corners.
    fn dashes(&self, points: &[Place], style: ShapeStyle) {
        const DASH: f64 = 7.0;
        const PERIOD: f64 = 12.0;
        let mut phase = 0.0;
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|(x, y)| (f64::from(x), f64::from(y)));
            let length = libm::hypot(b.0 - a.0, b.1 - a.1);
            let at = |along: f64| {
                let share = along / length;
                let x = a.0 + share * (b.0 - a.0);
                (cast::pixel_of(x), cast::pixel_of(a.1 + share * (b.1 - a.1)))
            };
            let mut start = -phase;
            while start < length {
                let (from, to) = (start.max(0.0), (start + DASH).min(length));
                if from < to {
                    self.line(vec![at(from), at(to)], style);
                }
                start += PERIOD;
            }
            phase = length - (start - PERIOD);
        }
    }

    fn mark(&self, mark: usize, (x, y): Place, colour: RGBColor) {
        let r = MARK;
        let polygon = |corners: Vec<Place>| self.draw(&Polygon::new(corners, colour.filled()));
        match mark % 4 {
            0 => self.draw(&Circle::new((x, y), r, colour.filled())),
            1 => polygon(vec![(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)]),
            2 => polygon(vec![(x, y - r - 1), (x + r + 1, y + r), (x - r - 1, y + r)]),
            _ => polygon(vec![(x, y - r - 2), (x + r + 2, y), (x, y + r + 2), (x - r - 2, y)]),
        }
    }

    fn ring(&self, at: Place) {
        self.draw(&Circle::new(at, MARK + 4, BLACK.stroke_width(2)));
    }

    fn draw<E>(&self, element: &E)
    where
        for<'b> &'b E: PointCollection<'b, Place>,
        E: Drawable<SVGBackend<'a>>,
    {
        self.0.draw(element).expect("bug: drawing into a string can't fail");
    }
}

impl Chart {
    /// The chart as SVG.
    pub(super) fn svg(&self) -> String {
        let mut svg = String::new();
        {
            let area = SVGBackend::with_string(&mut svg, (WIDTH, HEIGHT)).into_drawing_area();
            area.fill(&WHITE).expect("bug: drawing into a string can't fail");
            let canvas = Canvas(area);
            self.draw(&canvas);
            canvas.0.present().expect("bug: drawing into a string can't fail");
        }
        svg
    }

    /// Points that have a position, by series, and notes on those that an axis can't show. NaN has
    /// no position; infinity lies on the edge, and so does 0 on a logarithmic axis.
    fn placed(&self) -> (Vec<String>, Vec<Vec<(f64, f64)>>) {
        let is_placed = |(x, y): &(f64, f64)| !x.is_nan() && !y.is_nan();
        let kept = |series: &Series| series.points.iter().copied().filter(is_placed).collect();
        let series: Vec<Vec<(f64, f64)>> = self.series.iter().map(kept).collect();
        let any = |is: &dyn Fn(&(f64, f64)) -> bool| series.iter().flatten().any(is);
        let none = |x: f64, along| along != Along::Linear && x <= 0.0;
        let mut told = Vec::new();
        for (there, text) in [
            (any(&|p| none(p.1, self.y.1)), "Points on the lower edge have zero error."),
            (any(&|p| p.1 == f64::INFINITY), "Points on the upper edge are infinite."),
            (any(&|p| none(p.0, self.x.1)), "Points on the left edge are at 0."),
            (any(&|p| p.0 == f64::INFINITY), "Points on the right edge are infinite."),
        ] {
            if there {
                told.push(text.to_owned());
            }
        }
        let all: usize = self.series.iter().map(|series| series.points.len()).sum();
        let left_out = all - series.iter().map(Vec::len).sum::<usize>();
        if left_out > 0 {
            told.push(format!("Left out: {left_out} without a number (NaN)."));
        }
        (told, series)
    }

    fn draw(&self, canvas: &Canvas<'_>) {
        let (width_px, height_px) = (cast::pixel_of(WIDTH.into()), cast::pixel_of(HEIGHT.into()));
        let centre = width_px / 2;
        canvas.text(&self.title, (centre, 22), TITLE, (HPos::Center, VPos::Center));
        let (edges, series) = self.placed();
        let caption = self.caption.iter().chain(&edges);
        let caption: Vec<String> = caption.flat_map(|text| wrapped(text)).collect();
        let mut y = 48;
        for line in &caption {
            canvas.text(line, (centre, y), SMALL, (HPos::Center, VPos::Center));
            y += LINE;
        }
        let legend = self.legend(width_px - 40);
        let rows = legend.last().map_or(0, |(_, (_, row))| row + 1);
        let plot = Box4(92, y + 2, width_px - 32, height_px - 62 - rows * (LINE + 2));
        let front = self.front.iter().flat_map(|front| &front.points);
        let all = series.iter().flatten().copied();
        let all = all.chain(front.map(|(x, y, _)| (*x, *y)));
        let xs = Scale::fit(all.clone().map(|(x, _)| x), self.x.1, (plot.0, plot.2));
        let ys = Scale::fit(all.map(|(_, y)| y), self.y.1, (plot.3, plot.1));
        self.axes(canvas, &plot, &xs, &ys);
        let place = |&(x, y): &(f64, f64)| (xs.at(x), ys.at(y));
        for (series, points) in self.series.iter().zip(&series) {
            let colour = PALETTE[series.colour % PALETTE.len()];
            let points: Vec<Place> = points.iter().map(place).collect();
            match series.style {
                Style::Joined => canvas.line(points.clone(), colour.stroke_width(2)),
                Style::Dashed => canvas.dashes(&points, colour.stroke_width(1)),
                Style::Marks => {}
            }
            if series.style != Style::Dashed {
                points.iter().for_each(|at| canvas.mark(series.mark, *at, colour));
            }
        }
        if let Some(front) = &self.front {
            let points: Vec<Place> =
                front.points.iter().map(|(x, y, _)| place(&(*x, *y))).collect();
            canvas.line(points.clone(), BLACK.stroke_width(1));
            points.iter().for_each(|at| canvas.ring(*at));
            let others: Vec<Place> = series.iter().flatten().map(place).collect();
            // A label may lie beside a line of a series, but not on it.
            let joined = self.series.iter().zip(&series);
            let joined = joined.filter(|(series, _)| series.style == Style::Joined);
            let mut lines: Vec<Vec<Place>> =
                joined.map(|(_, points)| points.iter().map(place).collect()).collect();
            lines.push(points.clone());
            labels(canvas, &plot, &points, &others, &lines, front);
        }
        self.draw_legend(canvas, &legend, plot.3 + 70);
    }

    fn axes(&self, canvas: &Canvas<'_>, plot: &Box4, xs: &Scale, ys: &Scale) {
        let &Box4(left, top, right, bottom) = plot;
        for (x, label) in xs.ticks(60.0) {
            canvas.line(vec![(x, top), (x, bottom)], FAINT.stroke_width(1));
            canvas.text(&label, (x, bottom + 16), SMALL, (HPos::Center, VPos::Center));
        }
        for (y, label) in ys.ticks(30.0) {
            canvas.line(vec![(left, y), (right, y)], FAINT.stroke_width(1));
            canvas.text(&label, (left - 8, y), SMALL, (HPos::Right, VPos::Center));
        }
        let frame = vec![(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        canvas.line(frame, TEXT.stroke_width(1));
        let middle = ((left + right) / 2, (top + bottom) / 2);
        canvas.text(&self.x.0, (middle.0, bottom + 42), AXIS, (HPos::Center, VPos::Center));
        canvas.upright_text(&self.y.0, (20, middle.1), AXIS);
    }

    /// Entries of the legend with their positions: x in px and row.
    fn legend(&self, room: i32) -> Vec<(usize, Place)> {
        let mut labels: Vec<&str> =
            self.series.iter().map(|series| series.label.as_str()).collect();
        labels.extend(self.front.iter().map(|front| front.label.as_str()));
        let (mut x, mut row) = (0, 0);
        let mut entries = Vec::new();
        for (index, label) in labels.into_iter().enumerate() {
            let wide = width(label, SMALL) + 62;
            if x > 0 && x + wide > room {
                (x, row) = (0, row + 1);
            }
            entries.push((index, (x + 92, row)));
            x += wide;
        }
        entries
    }

    fn draw_legend(&self, canvas: &Canvas<'_>, legend: &[(usize, Place)], top: i32) {
        for (index, (x, row)) in legend {
            let (x, y) = (*x, top + row * (LINE + 2));
            let ends = vec![(x, y), (x + 34, y)];
            let middle = (x + 17, y);
            let label = match (self.series.get(*index), &self.front) {
                (Some(series), _) => {
                    let colour = PALETTE[series.colour % PALETTE.len()];
                    match series.style {
                        Style::Joined => canvas.line(ends, colour.stroke_width(2)),
                        Style::Dashed => canvas.dashes(&ends, colour.stroke_width(1)),
                        Style::Marks => {}
                    }
                    if series.style != Style::Dashed {
                        canvas.mark(series.mark, middle, colour);
                    }
                    &series.label
                }
                (None, Some(front)) => {
                    canvas.line(ends, BLACK.stroke_width(1));
                    canvas.ring(middle);
                    &front.label
                }
                (None, None) => continue,
            };
            canvas.text(label, (x + 42, y), SMALL, (HPos::Left, VPos::Center));
        }
    }
}

/// The point `px` from `a` on the way to `b`.
fn toward(a: Place, b: Place, px: i32) -> Place {
    let (dx, dy) = (f64::from(b.0 - a.0), f64::from(b.1 - a.1));
    let share = f64::from(px) / libm::hypot(dx, dy).max(1.0);
    (a.0 + cast::pixel_of(share * dx), a.1 + cast::pixel_of(share * dy))
}

/// Writes labels beside the front's points: below and to the left, where a front leaves room,
/// otherwise wherever no label, mark or edge is in the way. A label without room is left out.
fn labels(
    canvas: &Canvas<'_>,
    plot: &Box4,
    points: &[Place],
    others: &[Place],
    lines: &[Vec<Place>],
    front: &Front,
) {
    let shown = points.len().min(MAX_LABELS);
    let mut taken: Vec<Box4> = points.iter().map(|at| Box4::around(*at, MARK + 5)).collect();
    taken.extend(others.iter().map(|at| Box4::around(*at, MARK + 1)));
    // Small boxes along the lines keep labels off them.
    for pair in lines.iter().flat_map(|line| line.windows(2)) {
        let (a, b) = (pair[0], pair[1]);
        let length = (a.0 - b.0).abs() + (a.1 - b.1).abs();
        taken.extend((0..length).step_by(8).map(|px| Box4::around(toward(a, b, px), 1)));
    }
    for i in 0..shown {
        // Evenly spaced along the front, both ends included.
        let index = if shown > 1 { i * (points.len() - 1) / (shown - 1) } else { 0 };
        let (text, (x, y)) = (&front.points[index].2, points[index]);
        let wide = width(text, SMALL);
        let near = MARK + 6;
        let offers = [near, 2 * near, 4 * near, 6 * near].into_iter().flat_map(|away| {
            [
                (x - near - wide, y + away),
                (x + near, y - away - LINE),
                (x - wide / 2, y + away),
                (x - wide / 2, y - away - LINE),
                (x + near, y + away),
                (x - near - wide, y - away - LINE),
                (x + away + 4, y - LINE / 2),
                (x - away - 4 - wide, y - LINE / 2),
            ]
        });
        let boxes = offers.map(|(left, top)| Box4(left, top, left + wide, top + LINE));
        let free = |area: &Box4| area.inside(plot) && taken.iter().all(|other| !area.meets(other));
        let Some(area) = boxes.clone().find(free) else { continue };
        // A thin line connects the label with its point.
        let corner = (x.clamp(area.0, area.2), y.clamp(area.1 + 3, area.3 - 3));
        canvas.line(vec![toward((x, y), corner, MARK + 4), corner], LEADER.stroke_width(1));
        canvas.text(
            text,
            ((area.0 + area.2) / 2, (area.1 + area.3) / 2),
            SMALL,
            (HPos::Center, VPos::Center),
        );
        taken.push(area);
    }
}
