use super::flip::flip;
use super::pixels::encode;
use super::ssim::ssim;
use super::*;
use crate::base::cast;
use std::fs;

/// Gradients, a checkerboard and a disc with sharp edges.
fn scene(width: usize, height: usize) -> Srgb8 {
    let mut codes = Vec::new();
    let (wide, high) = (width.max(2) - 1, height.max(2) - 1);
    let radius = width.min(height) * 2 / 3;
    for y in 0..height {
        for x in 0..width {
            let colour = [255 * x / wide, 255 * y / high, 96 + 64 * ((x / 8 + y / 8) % 2)];
            let inside =
                (2 * x).abs_diff(width).pow(2) + (2 * y).abs_diff(height).pow(2) < radius * radius;
            codes.push(colour.map(|c| if inside { 255 - byte(c) } else { byte(c) }));
        }
    }
    Srgb8::new(width, height, codes).unwrap()
}

fn byte(x: usize) -> u8 {
    u8::try_from(x).unwrap()
}

/// The picture with each code changed by a function of it, x, y and channel.
fn changed(picture: &Srgb8, change: impl Fn(u8, usize, usize, usize) -> u8) -> Srgb8 {
    let width = picture.width_px();
    let codes = picture.codes().iter().enumerate();
    let codes = codes.map(|(i, pixel)| {
        std::array::from_fn(|channel| change(pixel[channel], i % width, i / width, channel))
    });
    Srgb8::new(width, picture.height_px(), codes.collect()).unwrap()
}

fn noisy(picture: &Srgb8) -> Srgb8 {
    changed(picture, |code, x, y, c| {
        let noise = byte((x * 73 + y * 151 + x * y * 7 + c * 57) % 17);
        // code + noise - 8, kept inside a byte.
        if noise < 8 { code.saturating_sub(8 - noise) } else { code.saturating_add(noise - 8) }
    })
}

/// The picture shifted two pixels to the left; the last columns repeat the border.
fn shifted(picture: &Srgb8) -> Srgb8 {
    let width = picture.width_px();
    changed(picture, |_, x, y, c| picture.codes()[y * width + (x + 2).min(width - 1)][c])
}

fn brighter(picture: &Srgb8) -> Srgb8 {
    changed(picture, |code, _, _, _| code.saturating_add(10))
}

fn negative(picture: &Srgb8) -> Srgb8 {
    changed(picture, |code, _, _, _| 255 - code)
}

type Change = fn(&Srgb8) -> Srgb8;

/// Figures of other implementations for `scene` against each change of it:
///
/// - SSIM by scikit-image 0.26.0: `structural_similarity(golden, picture, gaussian_weights=True,
///   sigma=1.5, use_sample_covariance=False, data_range=255)` on float luma, codes times 0.2126,
///   0.7152 and 0.0722;
/// - FLIP by its authors' `flip-evaluator` 1.7:
///   `evaluate(golden, picture, "LDR", parameters={"ppd": ppd})` on float32 codes over 255, at 67
///   and at 20 pixels per degree.
///
/// SSIM is the same formula in f64 and differs only by rounding: 1e-9 is far above that and far
/// below the effect of another window or other constants. The authors' FLIP computes in f32, with
/// colour matrices rounded to it: means agree to 2e-5.
const OUTSIDE: [(usize, usize, Change, f64, [f64; 2]); 8] = [
    (96, 64, noisy, 0.934_213_550_909_644, [0.050_145_227, 0.135_701_731]),
    (96, 64, shifted, 0.856_188_280_048_52, [0.173_928_723, 0.212_279_856]),
    (96, 64, brighter, 0.995_202_900_887_538, [0.207_165_495, 0.199_640_200]),
    (96, 64, negative, -0.057_663_349_039_856_8, [0.906_211_317, 0.925_777_853]),
    (40, 75, noisy, 0.933_974_173_526_372_9, [0.050_677_504, 0.137_283_266]),
    (40, 75, shifted, 0.836_865_015_395_432, [0.206_599_429, 0.240_379_795]),
    (40, 75, brighter, 0.995_091_936_585_649_2, [0.204_803_586, 0.199_079_096]),
    (40, 75, negative, -0.079_978_303_250_385_4, [0.894_515_693, 0.925_868_750]),
];

/// FLIP by the same `flip-evaluator` at 67 pixels per degree, for pictures smaller than its
/// filters.
const OUTSIDE_SMALL: [(usize, usize, Change, f64); 6] = [
    (1, 1, brighter, 0.206_272_498),
    (1, 1, negative, 0.981_559_455),
    (7, 5, brighter, 0.228_872_359),
    (7, 5, negative, 0.954_641_402),
    (3, 1, brighter, 0.145_875_886),
    (3, 1, negative, 0.980_373_323),
];

#[test]
fn ssim_and_flip_are_those_of_outside_implementations() {
    for (i, (width, height, change, expected_ssim, expected_flip)) in
        OUTSIDE.into_iter().enumerate()
    {
        let golden = scene(width, height);
        let picture = change(&golden);
        let found = ssim(&picture, &golden);
        assert!((found - expected_ssim).abs() < 1e-9, "case {i}: SSIM {found}");
        for (ppd, expected) in [67.0, 20.0].into_iter().zip(expected_flip) {
            let found = flip(&picture, &golden, ppd);
            assert!((found - expected).abs() < 2e-5, "case {i}: FLIP {found} at {ppd}");
            assert_eq!(found, flip(&golden, &picture, ppd), "case {i}");
        }
        assert_eq!(found, ssim(&golden, &picture), "case {i}");
        assert_eq!((ssim(&golden, &golden), flip(&golden, &golden, 67.0)), (1.0, 0.0), "case {i}");
    }
    for (i, (width, height, change, expected)) in OUTSIDE_SMALL.into_iter().enumerate() {
        let golden = scene(width, height);
        let found = flip(&change(&golden), &golden, 67.0);
        assert!((found - expected).abs() < 2e-5, "small case {i}: FLIP {found}");
    }
}

#[test]
fn ssim_of_a_side_shorter_than_the_window() {
    // One window without variance: only the means count.
    let grey = |code| Srgb8::new(1, 1, vec![[code; 3]]).unwrap();
    let expected = (2.0 * 100.0 * 150.0 + 6.5025) / (100.0 * 100.0 + 150.0 * 150.0 + 6.5025);
    assert!((ssim(&grey(100), &grey(150)) - expected).abs() < 1e-12);
    // Two pixels, mirrored: equal weights and variances, and the negated covariance.
    let pair = |a, b| Srgb8::new(2, 1, vec![[a; 3], [b; 3]]).unwrap();
    let expected = (58.5225 - 2.0 * 625.0) / (58.5225 + 2.0 * 625.0);
    assert!((ssim(&pair(100, 150), &pair(150, 100)) - expected).abs() < 1e-12);
}

fn grey(width: usize, values: &[f32]) -> Picture {
    let pixels: Vec<_> = values.iter().map(|v| [*v; 3]).collect();
    Picture::new(width, values.len() / width, pixels).unwrap()
}

fn between(picture: &Picture, golden: &Picture) -> Difference {
    Difference::between(picture, golden, PIXELS_PER_DEGREE).unwrap()
}

#[test]
fn codes_are_the_rounded_transfer() {
    let transfer = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        255.0 * if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 }
    };
    for i in -1000..70_000_i32 {
        let x = cast::f32_of(f64::from(i) / 65_536.0);
        let exact = transfer(f64::from(x));
        let [code, ..] = encode([x; 3]);
        assert!((f64::from(code) - exact).abs() <= 0.5 + 1e-4, "{x} gives {code}, not {exact}");
    }
    let whole: Vec<_> = (0..=255).map(|code| [code, 255 - code, code / 2]).collect();
    let whole = Srgb8::new(16, 16, whole).unwrap();
    assert_eq!(whole.to_linear().to_srgb8(), whole);
    assert_eq!(encode([f32::INFINITY, f32::NEG_INFINITY, 1.5]), [255, 0, 255]);
    assert_eq!(encode([0.2, f32::NAN, 0.2]), NAN_COLOUR);
    // 188 is the code nearest to half the light.
    assert_eq!(encode([0.5, 0.0, 1.0]), [188, 0, 255]);
}

#[test]
fn figures_of_a_tiny_picture() {
    let golden = Picture::new(2, 2, vec![[0.5; 3]; 4]).unwrap();
    let mut pixels = golden.pixels().to_vec();
    pixels[1] = [0.5, 0.25, 0.5];
    pixels[2] = [0.5, 0.5, 1.0];
    pixels[3] = [1.0, 0.5, 0.5];
    let difference = between(&Picture::new(2, 2, pixels).unwrap(), &golden);
    // Red and blue differ equally: the first channel is named.
    let red = Extreme {
        difference: 0.5,
        channel: Channel::Red,
        x_px: 1,
        y_px: 1,
        value: 1.0,
        golden: 0.5,
    };
    assert_eq!(difference.max, red);
    let green =
        Extreme { difference: 0.25, channel: Channel::Green, x_px: 1, y_px: 0, value: 0.25, ..red };
    assert_eq!(difference.channels[1], ChannelDifference { max: green, mean: 0.0625 });
    let blue = Extreme { channel: Channel::Blue, x_px: 0, ..red };
    assert_eq!(difference.channels[2], ChannelDifference { max: blue, mean: 0.125 });
    assert_eq!(difference.mean, (0.5 + 0.25 + 0.5) / 12.0);
    let square: f64 = (0.25 + 0.0625 + 0.25) / 12.0;
    assert_eq!(difference.psnr_db, -10.0 * square.log10());
    assert_eq!(difference.srgb8_differing, 0.75);
    // Codes of 1/4, 1/2 and 1 are 137, 188 and 255.
    assert_eq!(difference.srgb8_max_codes, 67);
    assert!(difference.ssim < 1.0 && difference.flip > 0.0);
}

#[test]
fn equal_pictures_and_one_pixel() {
    for picture in [scene(40, 30).to_linear(), grey(1, &[0.3]), grey(3, &[0.0, 0.5, 1.0])] {
        let none = between(&picture, &picture);
        assert_eq!((none.max.difference, none.max.x_px, none.max.y_px), (0.0, 0, 0));
        assert_eq!((none.mean, none.psnr_db), (0.0, f64::INFINITY));
        assert_eq!((none.srgb8_differing, none.srgb8_max_codes), (0.0, 0));
        assert_eq!((none.ssim, none.flip), (1.0, 0.0));
    }
    let apart = between(&grey(1, &[1.0]), &grey(1, &[0.0]));
    assert_eq!((apart.max.difference, apart.psnr_db, apart.srgb8_max_codes), (1.0, 0.0, 255));
    assert!(apart.ssim < 1e-3 && apart.flip > 0.9, "{} {}", apart.ssim, apart.flip);
}

/// Only covered pixels count, wherever they are; others are ignored.
#[test]
fn figures_are_over_what_is_covered() {
    let golden = grey(3, &[0.0, 0.0, 0.0, 0.25, 0.5, 0.5]);
    let picture = grey(3, &[1.0, 0.0, 0.0, 0.5, 0.5, f32::NAN]);
    let covered = [false, true, true, true, true, false];
    let over = Difference::over(&covered, &picture, &golden, 67.0).unwrap();
    assert_eq!((over.covered_px, over.background_px), (4, 2));
    assert_eq!((over.max.difference, over.max.x_px, over.max.y_px), (0.25, 0, 1));
    assert_eq!((over.mean, over.channels[2].mean), (0.25 / 4.0, 0.25 / 4.0));
    assert_eq!(over.psnr_db, -10.0 * (0.0625f64 / 4.0).log10());
    assert_eq!((over.srgb8_differing, over.srgb8_max_codes), (0.25, 51));
    let message = Difference::over(&[false; 6], &picture, &golden, 67.0).unwrap_err().to_string();
    assert!(message.starts_with("nothing is in view"), "{message}");
    let message = Difference::over(&[true; 5], &picture, &golden, 67.0).unwrap_err().to_string();
    assert!(message.contains("`covered` has 5 entries"), "{message}");
}

#[test]
fn a_difference_below_a_code_is_in_linear_light_alone() {
    let difference = between(&grey(2, &[0.5, 0.5]), &grey(2, &[0.5, 0.500_01]));
    assert!(difference.max.difference > 0.0 && difference.psnr_db < 110.0);
    assert_eq!((difference.srgb8_differing, difference.ssim, difference.flip), (0.0, 1.0, 0.0));
}

#[test]
fn what_is_no_number_is_seen() {
    let golden = grey(3, &[0.5; 9]);
    let mut values = [0.5; 9];
    values[4] = f32::NAN;
    values[5] = 1.0;
    let broken = grey(3, &values);
    for (a, b) in [(&broken, &golden), (&golden, &broken), (&broken, &broken)] {
        let difference = between(a, b);
        assert!(difference.max.difference.is_nan());
        assert_eq!((difference.max.x_px, difference.max.y_px), (1, 1));
        for figure in [difference.mean, difference.psnr_db, difference.ssim, difference.flip] {
            assert!(figure.is_nan());
        }
        assert_eq!(difference.srgb8_max_codes, 255);
        assert!(difference.srgb8_differing >= 1.0 / 9.0);
        let json = serde_json::to_value(&difference).unwrap();
        assert_eq!((&json["flip"], &json["max"]["difference"]), (&"NaN".into(), &"NaN".into()));
    }
    // One NaN channel is enough, and doesn't affect the others.
    let golden_pixel = Picture::new(1, 1, vec![[0.5; 3]]).unwrap();
    let difference =
        between(&Picture::new(1, 1, vec![[0.5, 0.5, f32::NAN]]).unwrap(), &golden_pixel);
    assert_eq!(difference.max.channel, Channel::Blue);
    assert!(difference.mean.is_nan() && difference.flip.is_nan());
    assert_eq!((difference.channels[0].mean, difference.srgb8_differing), (0.0, 1.0));
    let mut values = [0.5; 9];
    values[0] = f32::INFINITY;
    let difference = between(&grey(3, &values), &golden);
    assert_eq!((difference.max.difference, difference.psnr_db), (f64::INFINITY, f64::NEG_INFINITY));
    let equal = serde_json::to_value(between(&golden, &golden)).unwrap();
    assert_eq!(equal["psnr_db"], "inf");
    assert_eq!(equal["channels"][2]["max"]["channel"], "blue");
}

#[test]
fn wrong_sizes_and_settings_are_errors() {
    let (wide, high) = (grey(2, &[0.0; 6]), grey(3, &[0.0; 6]));
    let message = Difference::between(&wide, &high, 67.0).unwrap_err().to_string();
    assert_eq!(
        message,
        "the picture has 2 x 3 px and the golden one 3 x 2 px: only equal sizes can be compared"
    );
    assert!(absolute_map(&wide, &high, Amplify::Fit).is_err());
    assert!(signed_map(&wide, &high, Amplify::Fit).is_err());
    for ppd in [0.0, -67.0, f64::NAN, f64::INFINITY] {
        let message = Difference::between(&wide, &wide, ppd).unwrap_err().to_string();
        assert!(
            message.contains("pixels_per_degree") && message.contains("1 to 1000"),
            "{message}"
        );
    }
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(absolute_map(&wide, &wide, Amplify::By(factor)).is_err());
        assert!(signed_map(&wide, &wide, Amplify::By(factor)).is_err());
    }
    assert!(Picture::new(0, 1, Vec::new()).is_err());
    assert!(Picture::from_fn(1, 0, |_, _| [0.0; 3]).is_err());
    assert!(Picture::from_fn(usize::MAX, 2, |_, _| [0.0; 3]).is_err());
    assert!(Srgb8::new(1, MAX_SIDE_PX + 1, vec![[0; 3]; MAX_SIDE_PX + 1]).is_err());
    let message = Picture::new(2, 2, vec![[0.0; 3]; 3]).unwrap_err().to_string();
    assert_eq!(message, "a picture of 2 x 2 px has 4 pixels and 3 were given");
    assert!(sheet(&[], 1).is_err());
    let tile = scene(2, 2);
    assert!(sheet(&[Panel { caption: "", picture: &tile }], 0).is_err());
}

#[test]
fn figures_don_t_depend_on_threads() {
    let golden = scene(150, 140);
    let (picture, golden) = (noisy(&golden).to_linear(), golden.to_linear());
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let map = absolute_map(&picture, &golden, Amplify::Fit).unwrap();
            (between(&picture, &golden), map)
        })
    };
    let one = with(1);
    for threads in [2, 3, 7] {
        assert_eq!(with(threads), one);
    }
}

fn pixel(picture: &Srgb8, x: usize, y: usize) -> [u8; 3] {
    picture.codes()[y * picture.width_px() + x]
}

/// Reads a pixel of a map, whose picture has a frame of one px.
fn inside(map: &Srgb8, x: usize, y: usize) -> [u8; 3] {
    pixel(map, 1 + x, 1 + y)
}

#[test]
fn the_absolute_map_shows_amplified_differences() {
    // 5/64 fits under 1/8, so the factor is 8.
    let golden = grey(2, &[0.25, 0.25, 0.25, 0.25]);
    let picture = grey(2, &[0.25, 0.25 + 5.0 / 64.0, 0.25 - 1.0 / 64.0, 0.25]);
    let map = absolute_map(&picture, &golden, Amplify::Fit).unwrap();
    assert_eq!(inside(&map, 0, 0), [0; 3]);
    assert_eq!(inside(&map, 1, 0), encode([0.625; 3]));
    assert_eq!(inside(&map, 0, 1), encode([0.125; 3]));
    assert_eq!(map, absolute_map(&picture, &golden, Amplify::By(8.0)).unwrap());
    let strong = absolute_map(&picture, &golden, Amplify::By(64.0)).unwrap();
    assert_eq!(inside(&strong, 1, 0), [255; 3]);
    // The bar runs from white to black; its scale is the map's.
    let bar = 1 + 2 + 16 + 4;
    assert_eq!(pixel(&map, bar, 1), [255; 3]);
    assert_eq!(pixel(&map, bar, 1 + 63), [0; 3]);
    // A power of two is its own limit, and equal pictures are not amplified.
    let difference = |d: f32| absolute_map(&grey(1, &[d]), &grey(1, &[0.0]), Amplify::Fit).unwrap();
    assert_eq!(inside(&difference(0.125), 0, 0), [255; 3]);
    assert_eq!(inside(&difference(4.0), 0, 0), [255; 3]);
    assert_eq!(inside(&difference(0.0), 0, 0), [0; 3]);
    assert_eq!(inside(&difference(f32::NAN), 0, 0), NAN_COLOUR);
    // The scale shows the NaN colour: more than one pixel has it.
    let marked = |map: &Srgb8| map.codes().iter().filter(|codes| **codes == NAN_COLOUR).count();
    assert!(marked(&difference(f32::NAN)) > 100 && marked(&difference(0.5)) == 0);
}

#[test]
fn the_signed_map_tells_darker_from_brighter() {
    let golden = grey(2, &[0.5; 4]);
    let map = signed_map(&grey(2, &[0.5, 0.75, 0.25, f32::NAN]), &golden, Amplify::Fit).unwrap();
    assert_eq!(inside(&map, 0, 0), [255; 3]);
    assert_eq!(inside(&map, 1, 0), [178, 24, 43]);
    assert_eq!(inside(&map, 0, 1), [33, 102, 172]);
    assert_eq!(inside(&map, 1, 1), NAN_COLOUR);
    // Green weighs most: too much of it outweighs too little blue.
    let picture = Picture::new(1, 1, vec![[0.5, 0.6, 0.0]]).unwrap();
    let map = signed_map(&picture, &grey(1, &[0.5]), Amplify::By(1.0)).unwrap();
    let [red, _, blue] = inside(&map, 0, 0);
    assert!(red > blue);
}

#[test]
fn a_sheet_holds_every_picture_and_caption() {
    let (a, b) = (scene(30, 20), negative(&scene(30, 20)));
    let panels = ["a", "b", "a longer caption"].map(|caption| {
        let picture = if caption == "b" { &b } else { &a };
        Panel { caption, picture }
    });
    let whole = sheet(&panels, 2).unwrap();
    // A caption of 16 letters is wider than the pictures.
    let across = draw::text_width("a longer caption") + 16;
    assert_eq!((whole.width_px(), whole.height_px()), (2 * across, 2 * (20 + 16 + 16) + 8));
    for (panel, (left, top)) in panels.iter().zip([(8, 8), (across + 8, 8), (8, 60)]) {
        for y in 0..20 {
            for x in 0..30 {
                assert_eq!(pixel(&whole, left + x, top + y), pixel(panel.picture, x, y));
            }
        }
        let below = (0..16).flat_map(|y| (0..8).map(move |x| (left + x, top + 24 + y)));
        assert!(below.into_iter().any(|(x, y)| pixel(&whole, x, y)[0] < 100), "{}", panel.caption);
    }
    // Fewer panels than columns; and characters that the font lacks are no error.
    let one = sheet(&[Panel { caption: "\u{4e00}", picture: &a }], 5).unwrap();
    assert_eq!(one.width_px(), 30 + 16);
}

#[test]
fn png_files_hold_the_codes_or_nothing() {
    let scratch = crate::base::output::Scratch::new().unwrap();
    let path = scratch.path().join("scene.png");
    let picture = scene(33, 17);
    picture.to_linear().save_png(&path).unwrap();
    let read = image::load_from_memory(&fs::read(&path).unwrap()).unwrap().into_rgb8();
    assert_eq!(read.dimensions(), (33, 17));
    assert_eq!(read.as_raw(), picture.codes().as_flattened());
    let missing = scratch.path().join("missing").join("scene.png");
    let message = picture.save_png(&missing).unwrap_err().to_string();
    assert!(message.contains("can't write"), "{message}");
    assert!(!missing.exists());
}
