//! Reads tracks from tables that Tracker exports or copies, or from any other table of numbers.
//!
//! Tracker (physlets.org/tracker) writes one track as a line with its name, a line with the
//! headings `t`, `x`, `y`, and rows of numbers separated by tabs. A file with several tracks begins
//! with `#multi:`, and the name of each track is above its first column. Tabs, semicolons, commas
//! and spaces separate the columns, and a comma may be the decimal sign unless it separates them.

use glam::dvec2;
use indexmap::IndexMap;

use super::track::{Point, Track};
use crate::files::{FileError, FileErrors, Source, quoted, short_name};

/// The largest file in bytes: a million rows with full precision take up about 100 MB.
pub const LARGEST: usize = 1 << 28;
/// The number of lines at the start of a file among which the first row of numbers is sought.
const MOST_HEADS: usize = 100;
/// The number of errors after which reading stops.
const MOST_ERRORS: usize = 20;
/// The largest permitted absolute value of a time in seconds and of a coordinate in metres.
const MOST: f64 = 1e6;
/// The longest name of a body, in letters.
const LONGEST_NAME: usize = 24;

/// How to read a file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Reading {
    /// The columns of the time, and of x and y of each body, by their headings or numbers; empty to
    /// find them by their headings.
    pub columns: Vec<String>,
    /// The lengths of a unit of x and of y in metres, if the headings give no unit or give pixels.
    pub scale: Option<[f64; 2]>,
    /// Whether a pixel counts as 1 mm if there is no scale, so that the scale can be set later.
    pub takes_pixels: bool,
}

/// Reads the two tracks in one file, or one track in each of two; each file is given as its name
/// and its bytes.
///
/// # Errors
/// Returns messages that say what was expected and found, and where.
pub fn read(files: &[(&str, &[u8])], reading: &Reading) -> Result<[Track; 2], FileErrors> {
    let mut tracks = Vec::new();
    let mut last = "";
    for (name, bytes) in files {
        let source = Source::of_bytes(name, bytes, LARGEST)?;
        let opening = opening(&source)?;
        let table = table(name, &opening, reading)?;
        let found = rows(source, &opening, &table)?;
        if files.len() > 1 && found.len() != 1 {
            let message = format!(
                "expected one track in each of two files, found {}",
                found.len()
            );
            return Err(FileError::of_file(name, message).into());
        }
        tracks.extend(found);
        last = name;
    }
    let mut two = <[Track; 2]>::try_from(tracks).map_err(|tracks| {
        let names: Vec<_> = tracks.iter().map(|track| track.name.as_str()).collect();
        let message = match names.len() {
            ..2 => format!(
                "expected two bodies, found only {}: give the file of the other body too, or \
                 export both tracks together",
                names.first().unwrap_or(&"one")
            ),
            count => format!(
                "expected two bodies, found {count} ({}): choose two with --columns, by the \
                 numbers of the columns, such as 1,2,3,4,5",
                names.join(", ")
            ),
        };
        FileError::of_file(last, message)
    })?;
    if two[0].name == two[1].name {
        two[0].name = "body 1".into();
        two[1].name = "body 2".into();
    }
    Ok(two)
}

/// What a column contains.
#[derive(Debug, Clone, PartialEq)]
enum ColumnRole {
    Time,
    /// A coordinate (0 for x, 1 for y) of a body.
    Coordinate(String, usize),
}

/// A column in use.
#[derive(Debug, Clone)]
struct Column {
    index: usize,
    head: String,
    factor: f64,
}

impl Column {
    /// The number and the heading of this column, for a message.
    fn place(&self) -> String {
        let (number, head) = (self.index + 1, short_name(&self.head, LONGEST_NAME));
        match self.head.is_empty() {
            true => format!("column {number}"),
            false => format!("column {number} ({head})"),
        }
    }
}

/// The columns of a file.
struct TrackTable {
    time: Column,
    bodies: Vec<(String, [Column; 2])>,
}

/// The lines before the first row of numbers, the separator, and where the rows begin.
struct TableHead<'a> {
    names: Vec<&'a str>,
    heads: Vec<&'a str>,
    width: usize,
    separator: u8,
    /// The number of the line with the headings, or of the first row if there are none.
    line: usize,
    /// The number of lines before the first row.
    skipped: usize,
}

fn is_comment(line: &str) -> bool {
    line.starts_with(['#', '%']) || line.starts_with("//")
}

fn opening<'a>(source: &Source<'a>) -> Result<TableHead<'a>, FileError> {
    let mut before: Vec<(usize, &str)> = Vec::new();
    for (skipped, (number, line)) in source.lines().take(MOST_HEADS).enumerate() {
        if line.trim().is_empty() || is_comment(line.trim_start()) || line.starts_with("sep=") {
            continue;
        }
        let Some(separator) = separator(line) else {
            before.push((number, line));
            continue;
        };
        let fields = |line: &'a str| fields(line, separator);
        return Ok(TableHead {
            heads: before.last().map_or(Vec::new(), |(_, line)| fields(line)),
            names: match before.as_slice() {
                [.., (_, names), _] => fields(names),
                _ => Vec::new(),
            },
            width: fields(line).len(),
            separator,
            line: before.last().map_or(number, |(number, _)| *number),
            skipped,
        });
    }
    let message = "expected rows of a time and coordinates, separated by commas, semicolons, tabs \
                   or spaces";
    Err(match before.first() {
        Some((number, line)) => {
            source.error_on(*number, format!("{message}, found {}", quoted(line.trim())))
        }
        None => source.error_on(1, format!("{message}, found none")),
    })
}

/// The separator that makes a line a row of at least three numbers; `None` if none does.
fn separator(line: &str) -> Option<u8> {
    b"\t;, ".iter().copied().find(|&separator| {
        let fields = fields(line, separator);
        fields.iter().filter_map(|field| number(field)).count() >= 3
    })
}

/// The fields of a line, without spaces and quotation marks around them.
fn fields(line: &str, separator: u8) -> Vec<&str> {
    let mut fields = Vec::new();
    split(line, separator, &mut fields);
    fields
}

/// Adds the fields of a line to `fields`.
fn split<'a>(line: &'a str, separator: u8, fields: &mut Vec<&'a str>) {
    let mut quoted = false;
    let split = line.split(move |letter: char| {
        quoted ^= letter == '"';
        !quoted && letter == char::from(separator)
    });
    let trimmed = split.map(|field| field.trim().trim_matches('"'));
    match separator {
        b' ' => fields.extend(trimmed.filter(|field| !field.is_empty())),
        _ => fields.extend(trimmed),
    }
}

/// A number with a decimal point or comma. It may be infinite or NaN.
fn number(field: &str) -> Option<f64> {
    match field.contains(',') {
        false => field.parse().ok(),
        true => field.replacen(',', ".", 1).parse().ok(),
    }
}

/// The name of a column in a simple form, and its unit: `x_{1} (cm)` is "x1" and "cm".
fn head(text: &str) -> (String, Option<String>) {
    let known = |unit: &str| length_unit(unit).is_some() || time_unit(unit).is_some();
    let text = text.trim().trim_matches('"');
    let (name, unit) = if let Some((name, rest)) = text.split_once(['(', '[']) {
        (name, Some(rest.trim_end_matches([')', ']', ' '])))
    } else if let Some((name, unit)) = text.rsplit_once(['/', '_', ' ']).filter(|it| known(it.1)) {
        (name, Some(unit))
    } else {
        (text, None)
    };
    let plain = name.chars().filter(|letter| letter.is_alphanumeric());
    let plain = plain.collect::<String>().to_lowercase();
    (plain, unit.map(str::to_owned))
}

/// The length of a unit in metres; 0 for pixels, because the file does not say how large they are.
fn length_unit(unit: &str) -> Option<f64> {
    Some(match unit {
        "m" => 1.0,
        "dm" => 0.1,
        "cm" => 0.01,
        "mm" => 0.001,
        "px" | "pixel" | "pixels" => 0.0,
        _ => return None,
    })
}

fn time_unit(unit: &str) -> Option<f64> {
    match unit {
        "s" => Some(1.0),
        "ms" => Some(0.001),
        _ => None,
    }
}

/// What a column contains according to its heading; `name` is the body's name from the line above.
fn role(plain: &str, name: &str) -> Option<ColumnRole> {
    if matches!(
        plain,
        "t" | "time" | "zeit" | "temps" | "tiempo" | "tempo" | "tid"
    ) {
        return Some(ColumnRole::Time);
    }
    let of = |letter: char| {
        let numbered = |rest: &&str| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit());
        plain
            .strip_prefix(letter)
            .or_else(|| plain.strip_suffix(letter).filter(numbered))
    };
    let (key, axis) = of('x')
        .map(|key| (key, 0))
        .or_else(|| of('y').map(|key| (key, 1)))?;
    let body = match (name.is_empty(), key.is_empty()) {
        (_, true) => name.to_owned(),
        (true, false) => format!("body {}", key.to_uppercase()),
        (false, false) => format!("{name} {key}"),
    };
    Some(ColumnRole::Coordinate(body, axis))
}

fn table(file: &str, opening: &TableHead, reading: &Reading) -> Result<TrackTable, FileError> {
    let refuse = |message: String| FileError::on_line(file, opening.line, message);
    let roles = match reading.columns.as_slice() {
        [] => found(opening),
        chosen => self::chosen(opening, chosen).map_err(refuse)?,
    };
    let mut time = None;
    let mut bodies: IndexMap<String, [Option<Column>; 2]> = IndexMap::new();
    for (index, role) in roles {
        let text = opening.heads.get(index).copied().unwrap_or_default();
        let mut column = Column {
            index,
            head: text.to_owned(),
            factor: 1.0,
        };
        column.factor = factor(head(text).1.as_deref(), &role, reading)
            .map_err(|expected| refuse(format!("{}: {expected}", column.place())))?;
        match role {
            ColumnRole::Time => time.get_or_insert(column),
            ColumnRole::Coordinate(body, axis) => {
                bodies.entry(body).or_default()[axis].get_or_insert(column)
            }
        };
    }
    let heads = || match opening.heads.as_slice() {
        [] => format!("no headings above {} columns", opening.width),
        heads => quoted(&heads.join(" ")),
    };
    let time = time.ok_or_else(|| {
        refuse(format!(
            "expected a column t (or choose it with --columns), found {}",
            heads()
        ))
    })?;
    let mut whole = Vec::new();
    for (number, (name, columns)) in (1..).zip(bodies) {
        let name = match short_name(&name, LONGEST_NAME) {
            empty if empty.is_empty() => format!("body {number}"),
            name => name,
        };
        match columns {
            [Some(x), Some(y)] => whole.push((name, [x, y])),
            [x, _] => {
                let (found, lacks) = if x.is_some() { ("x", "y") } else { ("y", "x") };
                return Err(refuse(format!(
                    "expected a column {lacks} of {name}, found only {found}"
                )));
            }
        }
    }
    if whole.is_empty() {
        let found = heads();
        return Err(refuse(format!(
            "expected columns x and y (or choose them with --columns), found {found}"
        )));
    }
    Ok(TrackTable {
        time,
        bodies: whole,
    })
}

/// The factor from the unit in a column's heading to SI units.
fn factor(unit: Option<&str>, role: &ColumnRole, reading: &Reading) -> Result<f64, String> {
    let found = quoted(unit.unwrap_or_default());
    let ColumnRole::Coordinate(_, axis) = role else {
        let factor = unit.map_or(Some(1.0), time_unit);
        return factor.ok_or_else(|| format!("expected a time in s or ms, found {found}"));
    };
    let scale = reading.scale.map(|scale| scale[*axis]);
    let Some(unit) = unit else {
        return Ok(scale.unwrap_or(1.0));
    };
    match (length_unit(unit), scale) {
        (Some(factor), _) if factor > 0.0 => Ok(factor),
        (Some(_), Some(scale)) => Ok(scale),
        (Some(_), None) if reading.takes_pixels => Ok(0.001),
        (Some(_), None) => Err(
            "expected --scale with the millimetres of a pixel, because this column is in pixels"
                .into(),
        ),
        (None, _) => Err(format!(
            "expected a length in m, dm, cm, mm or px, found {found}"
        )),
    }
}

/// The columns found by their headings; five or three columns without headings are in the usual
/// order.
fn found(opening: &TableHead) -> Vec<(usize, ColumnRole)> {
    if opening.heads.is_empty() {
        return match opening.width {
            3 | 5 => in_order(0..opening.width),
            _ => Vec::new(),
        };
    }
    // Names are above the first column of each track.
    let mut name = "";
    let heads = opening.heads.iter().enumerate();
    let roles = heads.filter_map(|(index, text)| {
        if let Some(above) = opening.names.get(index).filter(|above| !above.is_empty()) {
            name = above;
        }
        Some((index, role(&head(text).0, name)?))
    });
    roles.collect()
}

/// The time, then x and y of each body.
fn in_order(columns: impl IntoIterator<Item = usize>) -> Vec<(usize, ColumnRole)> {
    let coordinate =
        |place: usize| ColumnRole::Coordinate(format!("body {}", place / 2 + 1), place % 2);
    let roles = std::iter::once(ColumnRole::Time).chain((0..).map(coordinate));
    columns.into_iter().zip(roles).collect()
}

/// The columns as chosen by the user.
fn chosen(opening: &TableHead, chosen: &[String]) -> Result<Vec<(usize, ColumnRole)>, String> {
    if !matches!(chosen.len(), 3 | 5) {
        return Err(format!(
            "expected five columns after --columns (t,x1,y1,x2,y2), or three for a file with one \
             body, found {}",
            chosen.len()
        ));
    }
    let width = opening.width.max(opening.heads.len());
    let column = |name: &String| {
        let number = name.parse::<usize>().ok();
        let number = number.and_then(|number| number.checked_sub(1));
        let is_head = |text: &str| text.eq_ignore_ascii_case(name) || head(text).0 == head(name).0;
        let named = || opening.heads.iter().position(|text| is_head(text));
        let index = number.filter(|index| *index < width).or_else(named);
        index.ok_or_else(|| {
            let found = quoted(name);
            format!("expected the heading of a column or a number from 1 to {width}, found {found}")
        })
    };
    let columns: Result<Vec<_>, _> = chosen.iter().map(column).collect();
    columns.map(in_order)
}

fn rows(source: Source, opening: &TableHead, table: &TrackTable) -> Result<Vec<Track>, FileErrors> {
    let named = table.bodies.iter().map(|(name, _)| Track {
        name: name.clone(),
        points: Vec::new(),
    });
    let mut tracks: Vec<_> = named.collect();
    let mut found = Vec::new();
    let mut last = f64::NEG_INFINITY;
    let mut errors = 0;
    for (line, text) in source.lines().skip(opening.skipped) {
        if errors == MOST_ERRORS {
            break;
        }
        if text.trim_start().is_empty() || is_comment(text.trim_start()) {
            continue;
        }
        found.clear();
        split(text, opening.separator, &mut found);
        if found.iter().all(|field| field.is_empty()) {
            continue;
        }
        let made = row(table, &found, line, &mut last, &mut tracks);
        errors += usize::from(source.accept(line, made).is_none());
    }
    source.finish(Some(tracks))
}

/// Reads the fields of a row, and adds a point to the track of each body that has one in this row.
fn row(
    table: &TrackTable,
    fields: &[&str],
    line: usize,
    last: &mut f64,
    tracks: &mut [Track],
) -> Result<(), String> {
    let at = |column: &Column, expected: &str| format!("{}: expected {expected}", column.place());
    let read = |column: &Column| {
        let text = fields.get(column.index).copied().unwrap_or_default();
        value(column, text).map_err(|expected| at(column, &expected))
    };
    let time = &table.time;
    let t = read(time)?.ok_or_else(|| at(time, "a time, found nothing"))?;
    if t <= *last {
        return Err(at(time, &format!("a time after {last} s, found {t} s")));
    }
    *last = t;
    for ((name, [x, y]), track) in table.bodies.iter().zip(tracks) {
        match (read(x)?, read(y)?) {
            (Some(x), Some(y)) => track.points.push(Point {
                t,
                at: dvec2(x, y),
                weight: 1.0,
                line: u32::try_from(line).unwrap_or(u32::MAX),
            }),
            (None, None) => {}
            (one, _) => {
                let lacking = if one.is_some() { y } else { x };
                let expected = format!("both coordinates of {name} or neither, found one");
                return Err(at(lacking, &expected));
            }
        }
    }
    Ok(())
}

/// The value of a field in SI units, `None` if it is empty, or what was expected and found.
fn value(column: &Column, text: &str) -> Result<Option<f64>, String> {
    if text.is_empty() {
        return Ok(None);
    }
    match number(text).map(|number| number * column.factor) {
        Some(value) if value.abs() <= MOST => Ok(Some(value)),
        Some(value) if value.is_finite() => {
            Err(format!("a number of at most {MOST:e}, found {text}"))
        }
        _ => Err(format!(
            "a number, or nothing for a missing point, found {}",
            quoted(text)
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tracks(text: &str) -> Result<[Track; 2], String> {
        with(text, &Reading::default())
    }

    fn with(text: &str, reading: &Reading) -> Result<[Track; 2], String> {
        read(&[("a.txt", text.as_bytes())], reading).map_err(|errors| errors.to_string())
    }

    fn chosen(columns: &str, scale: Option<[f64; 2]>) -> Reading {
        Reading {
            columns: columns
                .split(',')
                .filter(|it| !it.is_empty())
                .map(str::to_owned)
                .collect(),
            scale,
            takes_pixels: false,
        }
    }

    /// The first and the last point of each body, as t, x, y, line.
    fn ends(tracks: &[Track; 2]) -> Vec<[f64; 4]> {
        let ends = tracks
            .iter()
            .flat_map(|track| [track.points.first(), track.points.last()]);
        let numbers = ends
            .flatten()
            .map(|it| [it.t, it.at.x, it.at.y, f64::from(it.line)]);
        numbers.collect()
    }

    #[test]
    fn tracker_files_of_two_bodies_are_read() {
        let text = "#multi:\n\tmass A\t\tmass B\t\t\nt\tx\ty\tx\ty\t\n0.000E0\t1.0\t2.0\t3.0\t4.0\t\n\
                    3.3E-2\t1.5\t2.5\t\t\t\n6.7E-2\t2.0\t3.0\t5.0\t6.0\t\n";
        let tracks = tracks(text).unwrap();
        assert_eq!(
            tracks.each_ref().map(|it| it.name.as_str()),
            ["mass A", "mass B"]
        );
        assert_eq!(tracks.each_ref().map(|it| it.points.len()), [3, 2]);
        let last = [[0.067, 2.0, 3.0, 6.0], [0.067, 5.0, 6.0, 6.0]];
        let ends = ends(&tracks);
        assert_eq!([ends[1], ends[3]], last);
    }

    #[test]
    fn tracker_files_of_one_body_each_are_put_together() {
        let [a, b] = [
            "mass_A\nt\tx\ty\n0\t1\t2\n1\t2\t3\n",
            "mass_B\nt\tx\ty\n0\t5\t6\n",
        ];
        let both = [("a", a.as_bytes()), ("b", b.as_bytes())];
        let tracks = read(&both, &Reading::default()).unwrap();
        assert_eq!(tracks[1].name, "mass_B");
        assert_eq!(tracks[0].points.len() + tracks[1].points.len(), 3);
        let one = read(&both[..1], &Reading::default()).unwrap_err();
        assert!(one.to_string().contains("found only mass_A"), "{one}");
    }

    #[test]
    fn separators_decimal_commas_comments_and_units_are_understood() {
        let same = [[0.0, 0.01, 0.02, 2.0], [0.1, 0.015, 0.025, 3.0]];
        for text in [
            "t (s),x1 (cm),y1 (cm),x2 (cm),y2 (cm)\n0,1,2,3,4\n0.1,1.5,2.5,3,4\n",
            "t;x_1/mm;y_1/mm;x_2/mm;y_2/mm\n0;10;20;30;40\n0,1;15,0;25;30;40\n",
            "time_ms\txA [cm]\tyA [cm]\txB [cm]\tyB [cm]\n0\t1\t2\t3\t4\n100\t1,5\t2,5\t3\t4\n",
            "t x1_m y1_m x2_m y2_m\n0  0,01 0,02  0,03 0,04\n0,1 0,015 0,025 0,03 0,04\n",
            "t,\"x1 (cm)\",\"y1 (cm)\",x2 (cm),y2 (cm)\n0,1,2,3,4\n\"0,1\",\"1,5\",\"2,5\",3,4\n",
            "t,x1 cm,y1 cm,x2 cm,y2 cm\r\n0,1,2,3,4\r\n0.1,1.5,2.5,3,4\r\n",
        ] {
            let tracks = tracks(text).unwrap_or_else(|error| panic!("{text}: {error}"));
            for (found, expected) in ends(&tracks).iter().zip(same) {
                let near = found
                    .iter()
                    .zip(expected)
                    .all(|(a, b)| (a - b).abs() < 1e-12);
                assert!(near, "{text}: {found:?}");
            }
        }
        let text = "# filmed on Monday\n% by Ada\n\n0 1 2 3 4\n# a pause\n1 1 2 3 4\n";
        assert_eq!(ends(&tracks(text).unwrap())[1], [1.0, 1.0, 2.0, 6.0]);
    }

    #[test]
    fn columns_are_chosen_by_heading_or_number_and_pixels_are_scaled() {
        let text = "frame;t;xA (px);yA (px);xB (px);yB (px)\n0;0;1;2;3;4\n1;1;1;2;3;4\n";
        let refused = tracks(text).unwrap_err();
        assert!(
            refused.contains("a.txt:1: column 3 (xA (px)): expected --scale"),
            "{refused}"
        );
        for columns in ["", "t,xA,yA,xB,yB", "2,3,4,5,6"] {
            let tracks = with(text, &chosen(columns, Some([0.001, -0.002]))).unwrap();
            assert_eq!(ends(&tracks)[0], [0.0, 0.001, -0.004, 2.0]);
        }
        let refused = with(text, &chosen("t,x,y,z,q", None)).unwrap_err();
        assert!(
            refused.contains("a number from 1 to 6, found \"x\""),
            "{refused}"
        );
        let refused = with(text, &chosen("t,xA", None)).unwrap_err();
        assert!(refused.contains("expected five columns"), "{refused}");
    }

    #[test]
    fn faults_are_reported_with_line_and_column() {
        let rows = |rows: &str| format!("t,x1,y1,x2,y2\n0,1,2,3,4\n{rows}\n");
        for (text, expected) in [
            (
                rows("1,a,2,3,4"),
                "a.txt:3: column 2 (x1): expected a number, or nothing for a \
                missing point, found \"a\"",
            ),
            (
                rows("1,1,2,NaN,4"),
                "a.txt:3: column 4 (x2): expected a number, or nothing for a \
                missing point, found \"NaN\"",
            ),
            (
                rows("1,1,2,1e9,4"),
                "a.txt:3: column 4 (x2): expected a number of at most 1e6",
            ),
            (
                rows("1,1,,3,4"),
                "a.txt:3: column 3 (y1): expected both coordinates of body 1",
            ),
            (
                rows("0,1,2,3,4"),
                "a.txt:3: column 1 (t): expected a time after 0 s, found 0 s",
            ),
            (
                rows("1,1,2,3,4\n0.5,1,2,3,4"),
                "a.txt:4: column 1 (t): expected a time after 1 s",
            ),
            (
                rows(",1,2,3,4"),
                "a.txt:3: column 1 (t): expected a time, found nothing",
            ),
            (
                rows("1,1,2,3"),
                "a.txt:3: column 5 (y2): expected both coordinates of body 2",
            ),
            (
                "".into(),
                "a.txt:1: expected rows of a time and coordinates",
            ),
            (
                "hello\nworld\n".into(),
                "a.txt:1: expected rows of a time and coordinates, separated \
                by commas, semicolons, tabs or spaces, found \"hello\"",
            ),
            (
                "x1,y1,x2,y2\n1,2,3,4\n".into(),
                "a.txt:1: expected a column t",
            ),
            (
                "t,x1,y1,x2\n0,1,2,3\n".into(),
                "a.txt:1: expected a column y of body 2, found only x",
            ),
            (
                "t,a,b,c\n0,1,2,3\n".into(),
                "a.txt:1: expected columns x and y",
            ),
            ("0,1,2,3\n".into(), "found no headings above 4 columns"),
            (
                "t,x1 (in),y1,x2,y2\n0,1,2,3,4\n".into(),
                "column 2 (x1 (in)): expected a length in",
            ),
            (
                "t (h),x1,y1,x2,y2\n0,1,2,3,4\n".into(),
                "column 1 (t (h)): expected a time in s or ms",
            ),
            (
                "t,x1,y1,x2,y2,x3,y3\n0,1,2,3,4,5,6\n".into(),
                "a.txt: expected two bodies, found 3 \
                (body 1, body 2, body 3): choose two",
            ),
        ] {
            let error = tracks(&text).unwrap_err();
            assert!(error.contains(expected), "{text}\n{error}\n{expected}");
        }
        let many = rows(&"1,a,2,3,4\n".repeat(99));
        assert!(tracks(&many).unwrap_err().lines().count() <= 21);
        assert!(read(&[("a", b"\xff\xfe0")], &Reading::default()).is_err());
    }

    #[test]
    fn other_columns_of_tracker_are_ignored() {
        let text =
            "mass A\tmass A\nt\tx\ty\tv_{x}\tpixelx\tx2\ty2\tframe\n0\t1\t2\t9\t9\t3\t4\t0\n";
        assert_eq!(tracks(text).unwrap()[1].points[0].at, dvec2(3.0, 4.0));
    }
}
