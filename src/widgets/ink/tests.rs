//! Tests of the whole painter: marks appear where the geometry requires.

pub(crate) mod centres;

use std::f64::consts::TAU;

use glam::{DVec2, dvec2};
use ratatui::{buffer::Buffer, layout::Rect, style::Color};

use super::Canvas;
use crate::widgets::picture::{Body, DrawLayer, LabelSide, Pen, Picture, View};
use crate::widgets::text::blocks::{LEFT, LOWER, QUARTERS, octants, sextants};
use crate::widgets::theme::Rgb;
use crate::widgets::{Blocks, Charset, Depth, Look, Palette, Role, Theme};
use centres::seen_at;

const CHARSETS: [Charset; 2] = [Charset::Ascii, Charset::Unicode];
const AREA: Rect = Rect::new(2, 1, 60, 30);

/// A canvas on which one metre is one column, with the origin in the middle.
fn canvas(charset: Charset) -> Canvas {
    Canvas::new(View::new(AREA, DVec2::ZERO, 1.0), charset)
}

fn drawn(canvas: &Canvas) -> Buffer {
    let mut buffer = Buffer::empty(Rect::new(0, 0, 64, 32));
    canvas.draw(&mut buffer, &Theme::default());
    buffer
}

fn is_blank(symbol: &str) -> bool {
    matches!(symbol, " " | "\u{2800}")
}

/// The cells that are not blank, as (column, row).
fn inked(buffer: &Buffer) -> Vec<(u16, u16)> {
    buffer
        .area
        .positions()
        .filter(|&at| !is_blank(buffer[at].symbol()))
        .map(|at| (at.x, at.y))
        .collect()
}

#[test]
fn a_circle_is_round() {
    for charset in CHARSETS {
        for radius in [4.0, 6.3, 8.5, 10.0, 13.2] {
            let mut canvas = canvas(charset);
            canvas.circle(DVec2::ZERO, radius, Role::Arc);
            let (columns, rows) = super::grid(charset);
            // The lowest and highest coordinates of the samples, in paper columns.
            let mut low = DVec2::MAX;
            let mut high = DVec2::MIN;
            for (index, cell) in canvas.cells.iter().enumerate() {
                for sample in (0..columns * rows).filter(|sample| cell.ink >> sample & 1 == 1) {
                    let x =
                        (index % 60) as f64 + ((sample % columns) as f64 + 0.5) / columns as f64;
                    let y = (index / 60) as f64 + ((sample / columns) as f64 + 0.5) / rows as f64;
                    low = low.min(dvec2(x, y * 2.0));
                    high = high.max(dvec2(x, y * 2.0));
                }
            }
            let centre = canvas.paper(DVec2::ZERO);
            for extent in [centre - low, high - centre] {
                let off = (extent - DVec2::splat(radius)).abs().max_element();
                assert!(off <= 0.5, "{charset:?} {radius} {extent}");
            }
        }
    }
}

#[test]
fn a_circle_has_no_gaps() {
    for radius in [3.0, 5.5, 8.0, 10.0, 12.7] {
        let mut canvas = canvas(Charset::Unicode);
        canvas.circle(dvec2(0.2, 0.1), radius, Role::Arc);
        let dot = |x: i32, y: i32| {
            let index = (y / 4 * 60 + x / 2) as usize;
            canvas.cells[index].ink >> (y % 4 * 2 + x % 2) & 1 == 1
        };
        for y in 1..119 {
            for x in 1..119 {
                if dot(x, y) {
                    let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy)));
                    let neighbours = around.filter(|(dx, dy)| dot(x + dx, y + dy)).count() - 1;
                    assert!(neighbours >= 2, "{radius}: a loose end at {x} {y}");
                }
            }
        }
    }
}

#[test]
fn a_filled_disc_covers_its_true_area() {
    for radius in [3.0, 5.0, 8.5, 12.0] {
        let mut canvas = canvas(Charset::Unicode);
        canvas.disc(&Body::new(dvec2(0.3, -0.4), radius, Role::Coin, ' '));
        let covered: u32 = canvas
            .cells
            .iter()
            .map(|cell| cell.cover().count_ones())
            .sum();
        // A cell has an area of two square columns and consists of 64 parts.
        let area = f64::from(covered) / 32.0;
        let exact = TAU / 2.0 * radius * radius;
        assert!(
            (area / exact - 1.0).abs() < 0.02,
            "{radius}: {area} {exact}"
        );
    }
}

#[test]
fn a_line_reaches_both_ends_and_no_further() {
    for charset in CHARSETS {
        for turn in 0..32 {
            let along = DVec2::from_angle(TAU * f64::from(turn) / 32.0) * 11.7;
            let (from, to) = (along * -0.4 + dvec2(3.0, 1.0), along + dvec2(3.0, 1.0));
            let mut canvas = canvas(charset);
            canvas.line(from, to, Role::Aim);
            let cells = inked(&drawn(&canvas));
            for end in [from, to] {
                let cell = canvas.view().to_cell(end);
                let nearest = cells.iter().map(|&(x, y)| {
                    let middle = dvec2(f64::from(x) + 0.5, f64::from(y) + 0.5);
                    ((middle - cell) * dvec2(1.0, 2.0)).length()
                });
                // The middle of the nearest cell with ink is less than the height of a cell away.
                assert!(nearest.fold(f64::MAX, f64::min) < 1.9, "{charset:?} {turn}");
            }
            let (a, b) = (canvas.view().to_cell(from), canvas.view().to_cell(to));
            for (x, y) in cells {
                let (low, high) = (a.min(b) - DVec2::ONE, a.max(b) + DVec2::ONE);
                let middle = dvec2(f64::from(x) + 0.5, f64::from(y) + 0.5);
                assert!(middle.cmpge(low).all() && middle.cmple(high).all());
            }
        }
    }
}

#[test]
fn a_horizontal_line_looks_the_same_in_every_position() {
    for tenth in 0..20 {
        let y = f64::from(tenth) / 10.0 - 7.0;
        let mut canvas = canvas(Charset::Ascii);
        canvas.line(dvec2(-20.0, y), dvec2(20.0, y), Role::BoardLine);
        let buffer = drawn(&canvas);
        let cells = inked(&buffer);
        assert!((40..=41).contains(&cells.len()), "{}", cells.len());
        for at in cells {
            assert_eq!(buffer[at].symbol(), "-");
        }
    }
}

#[test]
fn the_tip_of_an_arrow_is_in_its_cell_and_has_a_head() {
    for charset in CHARSETS {
        for turn in 0..24 {
            let angle = TAU * (f64::from(turn) + 0.3) / 24.0;
            let (from, tip) = (dvec2(0.4, 0.3), DVec2::from_angle(angle) * 10.0);
            let mut canvas = canvas(charset);
            canvas.arrow(from, tip, Role::StrikerOut);
            let buffer = drawn(&canvas);
            let Some(cell) = canvas.view().cell_at(tip) else {
                panic!("the tip is outside");
            };
            let symbol = buffer[cell].symbol();
            if charset == Charset::Ascii {
                let (x, y) = (angle.cos(), angle.sin());
                let head = match (x.abs() > y.abs(), x > 0.0, y > 0.0) {
                    (true, true, _) => ">",
                    (true, false, _) => "<",
                    (false, _, true) => "^",
                    (false, _, false) => "v",
                };
                assert_eq!(symbol, head, "{turn}");
            }
            // The head is always attached to the shaft.
            let beside = inked(&buffer).into_iter().filter(|&(x, y)| {
                (x, y) != cell && x.abs_diff(cell.0) <= 1 && y.abs_diff(cell.1) <= 1
            });
            assert!(beside.count() > 0, "{charset:?} {turn}");
        }
    }
}

#[test]
fn labels_do_not_cover_each_other_or_important_marks() {
    for charset in CHARSETS {
        let mut canvas = canvas(charset);
        canvas.disc(&Body::new(DVec2::ZERO, 8.0, Role::Striker, 'S'));
        canvas.reserve(dvec2(12.0, 0.0));
        canvas.arrow(dvec2(0.0, 9.0), dvec2(5.0, 20.0), Role::StrikerOut);
        let before: Vec<_> = canvas.cells.iter().map(|cell| cell.layer()).collect();
        let mut placed = 0;
        for turn in 0..120 {
            let out = DVec2::from_angle(TAU * f64::from(turn) / 120.0);
            let text = format!("θ = {turn}°");
            placed += usize::from(canvas.label(
                &text,
                out * 12.0,
                &LabelSide::towards(out),
                Role::Arc,
                false,
            ));
        }
        assert!((30..120).contains(&placed), "{placed}");
        assert_eq!(placed, canvas.labels.len());
        for (i, label) in canvas.labels.iter().enumerate() {
            let place = label.place;
            assert_eq!(place.intersection(AREA), place);
            for other in &canvas.labels[i + 1..] {
                assert!(!place.intersects(other.place), "{place} {}", other.place);
            }
            for at in place.positions() {
                let index = usize::from(at.y - AREA.y) * 60 + usize::from(at.x - AREA.x);
                assert!(before[index].is_none() && !canvas.cells[index].reserved);
            }
        }
    }
}

#[test]
fn a_label_without_room_is_left_out() {
    let mut canvas = canvas(Charset::Unicode);
    assert!(!canvas.label(
        &"long ".repeat(20),
        DVec2::ZERO,
        &LabelSide::ALL,
        Role::Text,
        false
    ));
    assert!(!canvas.label("far", dvec2(1e9, 0.0), &LabelSide::ALL, Role::Text, false));
    assert!(!canvas.label("nowhere", DVec2::NAN, &LabelSide::ALL, Role::Text, false));
    assert!(!canvas.label("", DVec2::ZERO, &LabelSide::ALL, Role::Text, false));
    assert!(inked(&drawn(&canvas)).is_empty());
}

#[test]
fn a_point_is_visible_wherever_it_is_in_its_cell() {
    for charset in CHARSETS {
        for (x, y) in (0..12).flat_map(|x| (0..24).map(move |y| (x, y))) {
            let mut canvas = canvas(charset);
            let at = dvec2(f64::from(x) / 12.0 + 0.01, f64::from(y) / 12.0 + 0.01);
            canvas.dot(at, Role::CoinOut);
            assert_eq!(inked(&drawn(&canvas)).len(), 1, "{at}");
        }
    }
}

#[test]
fn a_measured_point_hides_the_lines_in_its_cell_in_any_order() {
    let point = Pen::new(Role::CoinOut).on(DrawLayer::Point);
    for charset in CHARSETS {
        let at = canvas(charset).view().cell_at(DVec2::ZERO).unwrap();
        let drawn = |marks: &[bool]| {
            let mut canvas = canvas(charset);
            for is_point in marks {
                match is_point {
                    true => canvas.dot(DVec2::ZERO, point),
                    false => canvas.line(dvec2(-9.0, 0.1), dvec2(9.0, 0.1), Role::Predicted),
                }
            }
            drawn(&canvas)[at].clone()
        };
        let alone = drawn(&[true]);
        assert_ne!(alone, drawn(&[false]));
        assert_eq!(
            [drawn(&[true, false]), drawn(&[false, true])],
            [alone.clone(), alone]
        );
    }
}

#[test]
fn the_higher_layer_wins_in_any_order() {
    for charset in CHARSETS {
        let strokes = [(Role::StrikerOut, 0.0), (Role::LineOfImpact, 0.0)];
        let colours = [strokes, [strokes[1], strokes[0]]].map(|order| {
            let mut canvas = canvas(charset);
            for (role, y) in order {
                canvas.line(dvec2(-9.0, y), dvec2(9.0, y), role);
            }
            drawn(&canvas)[(31, 15)].fg
        });
        assert_eq!(colours, [Theme::default().colour(Role::StrikerOut); 2]);
    }
}

#[test]
fn a_disc_hides_the_board_below_it_in_any_order() {
    for charset in CHARSETS {
        let pictures = [true, false].map(|line_first| {
            let mut canvas = canvas(charset);
            let line = |canvas: &mut Canvas| {
                canvas.line(dvec2(-20.0, 3.0), dvec2(20.0, 3.0), Role::BoardLine);
            };
            if line_first {
                line(&mut canvas);
            }
            canvas.disc(&Body::new(DVec2::ZERO, 8.0, Role::Coin, 'C'));
            if !line_first {
                line(&mut canvas);
            }
            drawn(&canvas)
        });
        assert_eq!(pictures[0], pictures[1]);
        let inside = pictures[0][(30, 13)].symbol();
        assert_eq!(
            inside,
            if charset == Charset::Ascii {
                " "
            } else {
                "█"
            }
        );
    }
}

/// A canvas with marks of many kinds.
fn everything(view: View, charset: Charset, size: f64) -> Canvas {
    let mut it = Picture::new(view);
    it.rectangle(dvec2(-size, -size), dvec2(size, size), Role::BoardLine);
    it.circle(DVec2::ZERO, size / 3.0, Role::BoardLine);
    it.disc(dvec2(size / 9.0, 0.0), size / 5.0, Role::Striker, 'θ');
    let coins = [Role::Coin, Role::Black, Role::Queen, Role::Marble];
    for (i, role) in coins.into_iter().enumerate() {
        let at = DVec2::from_angle(i as f64) * size * 0.7;
        it.disc(at, size / 20.0, role, 'C');
        it.line(at, -at, Pen::new(Role::Predicted).dashed());
        it.arrow(at * 0.5, at, Pen::new(Role::CoinOut).bold());
        it.dot(at * 0.9, Pen::new(Role::Trail).aged(0.5));
        it.fill(-at, at, Role::Trail);
        it.text(at, "θ", Role::Text);
        it.label("θ₁ = 60°", at, &LabelSide::towards(at), Role::Arc);
    }
    let arc = Pen::new(Role::Arc).dotted();
    it.arc(DVec2::ZERO, size / 2.0, 0.2, 2.2, arc);
    let ways = [DVec2::X, DVec2::Y];
    it.square_corner(DVec2::ZERO, ways, size / 8.0, Role::SquareCorner);
    let look = Look {
        charset,
        ..Look::default()
    };
    it.draw(&mut Buffer::empty(Rect::new(0, 0, 64, 32)), &look);
    Canvas::of(&it, &look)
}

#[test]
fn in_ascii_every_cell_is_printable_ascii() {
    for theme in [
        Theme::default(),
        Theme::new(Default::default(), Depth::None),
    ] {
        let view = View::fit(AREA, dvec2(-1.0, -1.0), dvec2(1.0, 1.0));
        let mut buffer = Buffer::empty(Rect::new(0, 0, 64, 32));
        everything(view, Charset::Ascii, 1.0).draw(&mut buffer, &theme);
        for cell in buffer.content() {
            let symbol = cell.symbol();
            assert!(
                symbol.bytes().all(|byte| (b' '..=b'~').contains(&byte)),
                "{symbol}"
            );
        }
    }
}

#[test]
fn unusual_sizes_and_numbers_are_drawn_without_a_panic() {
    let odd = [
        0.0,
        1.0,
        -1.0,
        1e-300,
        1e300,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    for charset in CHARSETS {
        for (width, height) in [(0, 0), (1, 1), (0, 9), (3, 1), (300, 100)] {
            let area = Rect::new(1, 1, width, height);
            for size in odd {
                let corner = DVec2::splat(size);
                for view in [
                    View::fit(area, -DVec2::ONE, DVec2::ONE),
                    View::fit(area, -corner, corner),
                    View::stretch(area, -corner, corner),
                ] {
                    // If the buffer is smaller than the canvas, the part that fits is drawn.
                    let mut buffer = Buffer::empty(Rect::new(0, 0, 40, 20));
                    everything(view, charset, size).draw(&mut buffer, &Theme::default());
                }
            }
        }
    }
}

#[test]
fn a_round_disc_appears_at_its_true_position() {
    let mut worst = DVec2::ZERO;
    for step in 0..100 {
        let step = f64::from(step);
        // The radii range from that of a coin on the whole board at 100 × 30 to more than that at
        // 200 × 60.
        let radius = 1.1 + 1.7 * (step * 0.618).fract();
        let at = dvec2((step * 0.755).fract() * 9.0, (step * 0.57).fract() * 9.0);
        for letter in ['W', ' '] {
            let mut canvas = canvas(Charset::Unicode);
            canvas.has_shades = true;
            canvas.discs(&[Body::new(at, radius, Role::Coin, letter)]);
            let true_place = canvas.view().to_cell(at);
            let off = (seen_at(&drawn(&canvas), Role::Coin) - true_place).abs();
            worst = worst.max(off);
        }
    }
    println!("worst: {worst} cells");
    assert!(worst.max_element() <= 0.25, "{worst}");
}

/// Whether a block element covers a point of its cell, with coordinates from 0 to 1.
fn covers(symbol: char, at: DVec2) -> bool {
    let of = |symbols: &[char]| symbols.iter().position(|it| *it == symbol);
    let has_part = |bits: u32, rows: f64| {
        let part = 2 * (at.y * rows) as u32 + (at.x * 2.0) as u32;
        bits >> part & 1 == 1
    };
    if let Some(bits) = of(&QUARTERS) {
        has_part(bits as u32, 2.0)
    } else if let Some(eighths) = of(&LOWER) {
        at.y > 1.0 - (eighths as f64 + 1.0) / 8.0
    } else if let Some(eighths) = of(&LEFT) {
        at.x < (eighths as f64 + 1.0) / 8.0
    } else if let Some((_, bits)) = sextants().find(|it| it.0 == symbol) {
        has_part(bits.into(), 3.0)
    } else {
        let octant = octants().find(|it| it.0 == symbol);
        octant.is_some_and(|(_, bits)| has_part(bits.into(), 4.0))
    }
}

/// The mean and the greatest distance between the rim of a drawn disc and the true circle, in
/// columns. A point is inside if its colour is closer to the disc's colour than to the
/// background's; the rim is the boundary between inside and outside.
fn rim(blocks: Blocks, depth: Depth, at: DVec2, radius: f64) -> (f64, f64) {
    // Pixels per cell, chosen so that every edge of a block element lies between two pixels.
    const ACROSS: usize = 8;
    const DOWN: usize = 24;
    let pixel = dvec2(1.0 / ACROSS as f64, 2.0 / DOWN as f64);
    let theme = Theme::new(Palette::Dark, depth);
    let area = Rect::new(0, 0, 9, 5);
    let mut canvas = Canvas::new(View::new(area, DVec2::ZERO, 1.0), Charset::Unicode);
    canvas.blocks = blocks;
    canvas.has_shades = theme.has_shades();
    canvas.round(&Body::new(at, radius, Role::Coin, ' '));
    let mut buffer = Buffer::empty(area);
    canvas.draw(&mut buffer, &theme);
    let sum = |Rgb(red, green, blue)| [red, green, blue].map(f64::from).iter().sum::<f64>();
    let [disc, paper] = [Role::Coin, Role::Background].map(|role| sum(theme.rgb(role)));
    let is_disc = |colour| match colour {
        Color::Rgb(red, green, blue) => (sum(Rgb(red, green, blue)) - paper) / (disc - paper) > 0.5,
        colour => colour == theme.colour(Role::Coin),
    };
    let middle_of = |x: usize, y: usize| (dvec2(x as f64, y as f64) + 0.5) * pixel;
    let (columns, rows) = (9 * ACROSS, 5 * DOWN);
    let inside: Vec<bool> = (0..columns * rows)
        .map(|i| {
            let (x, y) = (i % columns, i / columns);
            let cell = &buffer[((x / ACROSS) as u16, (y / DOWN) as u16)];
            let in_cell = middle_of(x % ACROSS, y % DOWN) / dvec2(1.0, 2.0);
            let is_ink = covers(cell.symbol().chars().next().unwrap(), in_cell);
            is_disc(if is_ink { cell.fg } else { cell.bg })
        })
        .collect();
    let middle = canvas.paper(at);
    let (mut sum, mut worst, mut length) = (0.0, 0.0_f64, 0.0);
    for (x, y) in (1..columns).flat_map(|x| (1..rows).map(move |y| (x, y))) {
        let left = (inside[y * columns + x - 1], dvec2(pixel.x, 0.0), pixel.y);
        let above = (inside[(y - 1) * columns + x], dvec2(0.0, pixel.y), pixel.x);
        for (there, way, edge) in [left, above] {
            if there != inside[y * columns + x] {
                let place = middle_of(x, y) - way / 2.0;
                let off = (place.distance(middle) - radius).abs();
                sum += off * edge;
                worst = worst.max(off);
                length += edge;
            }
        }
    }
    (sum / length, worst)
}

#[test]
fn finer_blocks_make_discs_rounder() {
    let sets = [Blocks::Quadrants, Blocks::Sextants, Blocks::Octants];
    println!("distance of the rim from the circle in columns, of {sets:?}: mean, worst");
    for depth in [Depth::Ansi16, Depth::True] {
        // On the whole board a coin has a radius of 1.5 columns at 120 × 40 and 2.4 columns at 200
        // × 60.
        for radius in [1.2, 1.4, 1.7, 2.0, 2.2, 2.5] {
            let places = (0..40).map(f64::from);
            let places = places.map(|it| dvec2((it * 0.755).fract(), 2.0 * (it * 0.57).fract()));
            let rims = sets.map(|set| {
                let rims = places.clone().map(|at| rim(set, depth, at, radius));
                rims.fold((0.0, 0.0), |all, it| (all.0 + it.0 / 40.0, it.1.max(all.1)))
            });
            let means @ [quadrants, sextants, octants] = rims.map(|(mean, _)| mean);
            let worst = rims.map(|(_, worst)| worst);
            println!("{depth:?}, radius {radius:.1}: {means:.3?} {worst:.2?}");
            assert!(octants <= sextants && sextants <= quadrants, "{rims:?}");
        }
    }
}
