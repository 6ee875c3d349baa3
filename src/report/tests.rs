use super::chart::{Along, Chart, Front, Series, Style};
use super::record::{Figures, Header, Measured, Point, Real, Record};
use super::*;
use crate::measure::{Basis, Speed};
use serde_json::{Map, json};

#[test]
fn pareto_by_hand() {
    assert_eq!(pareto(&[]), [0usize; 0]);
    assert_eq!(pareto(&[(1.0, 1.0)]), [0]);
    //            best in 2   beaten      tie of 5    best in 1   tie of 2    same first, worse
    let costs = [(9.0, 0.0), (6.0, 5.0), (5.0, 2.0), (1.0, 7.0), (5.0, 2.0), (5.0, 3.0)];
    assert_eq!(pareto(&costs), [3, 2, 4, 0]);
    // Same second number, dearer: beaten.
    assert_eq!(pareto(&[(2.0, 1.0), (1.0, 1.0), (3.0, 0.5)]), [1, 2]);
    assert_eq!(pareto(&[(1.0, f64::NAN), (2.0, f64::INFINITY), (f64::NAN, 0.0)]), [1]);
    assert_eq!(pareto(&[(4.0, 4.0); 3]), [0, 1, 2]);
}

fn chart(points: &[(f64, f64)], along: Along) -> String {
    let series = |style| Series {
        label: "a < b".to_owned(),
        colour: 9,
        mark: 5,
        style,
        points: points.to_vec(),
    };
    let front = points.iter().map(|(x, y)| (*x, *y, "label".to_owned())).collect();
    let chart = Chart {
        title: "title".to_owned(),
        caption: vec!["caption ".repeat(40)],
        x: ("x".to_owned(), along),
        y: ("y".to_owned(), Along::Log10),
        series: vec![series(Style::Joined), series(Style::Marks), series(Style::Dashed)],
        front: Some(Front { label: "front".to_owned(), points: front }),
    };
    chart.svg()
}

/// Every coordinate of a chart is a number inside it.
fn check(svg: &str) {
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    for name in ["x", "y", "cx", "cy"] {
        for part in svg.split(&format!(" {name}=\"")).skip(1) {
            let number: i32 = part.split('"').next().unwrap().parse().unwrap();
            assert!((0..=900).contains(&number), "{name}={number} in {svg}");
        }
    }
}

#[test]
fn scales_hold_any_numbers() {
    let odd = [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300, 1e300, f64::MIN_POSITIVE];
    for along in [Along::Linear, Along::Log2, Along::Log10] {
        check(&chart(&[], along));
        for x in [1.0, 3.0, 0.01] {
            check(&chart(&[(x, 1e-3)], along));
            check(&chart(&[(x, 2e-3); 3], along));
            check(&chart(&[(x, 0.0), (x, 0.0)], along));
            check(&chart(&[(x, 0.0), (2.0 * x, 1e-5)], along));
            for y in odd {
                check(&chart(&[(x, y), (4.0 * x, 0.5)], along));
            }
        }
        check(&chart(&odd.map(|x| (if x.abs() > 1e9 { 7.0 } else { x }, 1.0)), along));
    }
}

fn record(errors: &[(f64, u64)]) -> Record {
    let figures = |error: f64| Figures {
        quantity: "angle".to_owned(),
        unit: "rad".to_owned(),
        over: None,
        basis: Basis::Total,
        max: Real(error),
        max_ulp: None,
        witness: None,
        mean: Real(error),
        bias: Real(0.0),
        rms: Real(error),
        p50: Real(error),
        p99: Real(error),
        p999: Real(error),
    };
    let point = |(index, (error, rom)): (usize, &(f64, u64))| {
        let mut counts = Map::new();
        counts.insert("rom_bits_dual_port".to_owned(), (*rom).into());
        let mut parameters = Map::new();
        parameters.insert("table_addr_bits".to_owned(), index.into());
        let measured = Measured {
            input_ports: Vec::new(),
            output_ports: Vec::new(),
            counts,
            input_formats: String::new(),
            samples: 1,
            figures: vec![figures(*error)],
            picture: None,
            overflows: Vec::new(),
            speed: Speed::default(),
        };
        Point { parameters, error: None, measured: Some(measured) }
    };
    let header = Header {
        format_version: record::FORMAT_VERSION,
        crate_version: "1".to_owned(),
        unit: "unit".to_owned(),
        base: Map::new(),
        axes: vec![record::Axis {
            key: "table_addr_bits".to_owned(),
            values: (0..errors.len()).map(|index| json!(index)).collect(),
        }],
        sampler: "lit".to_owned(),
        samples: 1,
        seed: 1,
        scene: None,
        error: None,
    };
    Record { header, points: errors.iter().enumerate().map(point).collect() }
}

#[test]
fn reports_of_odd_numbers() {
    let cases: [&[(f64, u64)]; 5] = [
        &[(0.0, 0)],
        &[(0.1, 100)],
        &[(0.0, 10), (0.0, 10), (0.0, 10)],
        &[(f64::NAN, 10), (0.1, 20)],
        &[(f64::INFINITY, 0), (1e-300, u64::MAX), (0.2, 5)],
    ];
    for errors in cases {
        let folder = tempfile::tempdir().unwrap();
        let mut record = record(errors);
        write(folder.path(), &record).unwrap();
        let text = std::fs::read_to_string(folder.path().join("report.md")).unwrap();
        assert!(text.contains(&format!("{} measured, 0 failed", errors.len())), "{text}");
        let plot = std::fs::read_to_string(folder.path().join("error_vs_rom.svg")).unwrap();
        for (there, word) in [
            (errors.iter().any(|(error, _)| *error == 0.0), "lower edge have zero error"),
            (errors.iter().any(|(error, _)| *error == f64::INFINITY), "upper edge are infinite"),
            (errors.iter().any(|(_, rom)| *rom == 0), "left edge are at 0"),
            (errors.iter().any(|(error, _)| error.is_nan()), "Left out: 1 without a number"),
        ] {
            assert_eq!(plot.contains(word), there, "{errors:?}: {plot}");
        }
        for file in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            check(&std::fs::read_to_string(folder.path().join(file)).unwrap());
        }
        record.points.push(Point {
            parameters: Map::new(),
            error: Some("a | b".to_owned()),
            measured: None,
        });
        write(folder.path(), &record).unwrap();
        let text = std::fs::read_to_string(folder.path().join("report.md")).unwrap();
        assert!(text.contains("a \\| b") && text.contains("1 failed"), "{text}");
    }
}

#[test]
fn report_lists_the_front() {
    let text = markdown::sweep(&record(&[(0.2, 10), (0.1, 20), (0.3, 30), (0.1, 20)]), &[]);
    let front = text.split("## Points").next().unwrap();
    let front = front.split("## Pareto-optimal points").nth(1).unwrap();
    assert!(
        front.contains("| 0 | 11.46 | 10 |\n| 1 | 5.730 | 20 |\n| 3 | 5.730 | 20 |\n\n"),
        "{front}"
    );
}
