// An adapter for `minkref verify` in Rust without crates: sums of convex polygons.
// Put your own call into `minkowski_sum`, and say in DECLARATION what it can do (the words are in
// docs/adapter-protocol.md). rustc -O NAME_adapter.rs; minkref verify ./NAME_adapter
use std::io::{self, BufRead};

type Point = (f64, f64);
type Ring = Vec<Point>;

#[allow(dead_code)] // the convex sum asks for no holes
struct Polygon {
    outer: Ring,
    holes: Vec<Ring>, // clockwise
}

const DECLARATION: &str = r#""result","protocol":"adapter-v1","name":"NAME","version":"1",
"language":"Rust","arithmetic":"float64","numbers":"double",
"tolerance":{"absolute":"0","relative":"1e-9"},"sum":"region","capabilities":["plane"]"#;

/// PUT YOUR OWN CALL HERE. Outer rings run counter-clockwise. The sum is a list of rings: the points
/// that they wind around. To be asked for more, declare "non-convex", "holes" and "components".
fn minkowski_sum(p: &[Polygon], q: &[Polygon]) -> Vec<Ring> {
    vec![convex_sum(&p[0].outer, &q[0].outer)]
}

/// P grown by a disc, likewise: here the sum with a polygon of 128 corners. To be asked for it,
/// declare "offset", and in the tolerance "radius":"0.0004".
fn offset(p: &[Polygon], radius: f64) -> Vec<Ring> {
    let angle = |k: u32| f64::from(k) * std::f64::consts::PI / 64.0;
    let corner = |k: u32| (radius * angle(k).cos(), radius * angle(k).sin());
    vec![convex_sum(&p[0].outer, &(0..128).map(corner).collect::<Ring>())]
}

/// The edges of both rings in the order of their directions, from the leftmost vertices.
fn convex_sum(p: &[Point], q: &[Point]) -> Ring {
    let (p, q) = (from_left(p), from_left(q));
    let (n, m, mut i, mut j, mut sum) = (p.len() - 1, q.len() - 1, 0, 0, Vec::new());
    while i < n || j < m {
        sum.push((p[i].0 + q[j].0, p[i].1 + q[j].1));
        let mut turn = if j == m { 1.0 } else { -1.0 };
        if i < n && j < m {
            let (a, b) = (p[i + 1].0 - p[i].0, p[i + 1].1 - p[i].1);
            turn = a * (q[j + 1].1 - q[j].1) - b * (q[j + 1].0 - q[j].0);
        }
        i += (turn >= 0.0) as usize;
        j += (turn <= 0.0) as usize;
    }
    sum
}

fn from_left(ring: &[Point]) -> Ring {
    let first = (0..ring.len()).min_by(|&a, &b| ring[a].partial_cmp(&ring[b]).unwrap()).unwrap();
    (0..=ring.len()).map(|k| ring[(first + k) % ring.len()]).collect()
}

/// The set under the key, the last of its line: no JSON reader, but enough for what minkref sends.
fn set_of(line: &str, key: &str) -> Option<Vec<Polygon>> {
    let polygons = line.split_once(key)?.1.split("\"outer\"").skip(1);
    let read = |text: &str| {
        let (outer, holes) = text.split_once("\"holes\"")?;
        Some(Polygon { outer: rings_of(outer)?.pop()?, holes: rings_of(holes)? })
    };
    polygons.map(read).collect::<Option<Vec<_>>>().filter(|set| !set.is_empty())
}

fn rings_of(text: &str) -> Option<Vec<Ring>> {
    let ring = |text: &str| {
        let words = text.split_once("]]")?.0.split(|c: char| " ,[]".contains(c));
        let numbers = words.filter(|word| !word.is_empty()).map(|word| word.parse().ok());
        let numbers: Vec<f64> = numbers.collect::<Option<_>>()?;
        Some(numbers.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect())
    };
    text.split("[[").skip(1).map(ring).collect()
}

fn radius_of(line: &str) -> Option<f64> {
    let text = line.split_once("\"radius\"")?.1.trim_start_matches([':', ' ']);
    text.split([',', '}']).next()?.trim().parse().ok()
}

fn answer(line: &str, loaded: &mut Option<Vec<Polygon>>) -> String {
    if line.contains("\"hello\"") { return DECLARATION.replace('\n', ""); }
    if line.contains("\"load\"") { *loaded = set_of(line, "\"Q\""); }
    if line.contains("\"load\"") || line.contains("\"stop\"") { return "\"result\"".into(); }
    let sum = match (set_of(line, "\"sP\""), set_of(line, "\"P\""), radius_of(line), loaded) {
        (Some(sp), _, _, Some(q)) => minkowski_sum(&sp, q),
        (_, Some(p), Some(radius), _) => offset(&p, radius),
        _ => return r#""errored","reason":"not understood""#.into(),
    };
    let rings = sum.iter().map(|ring| written(ring)).collect::<Vec<_>>();
    format!(r#""result","rings":[{}]"#, rings.join(","))
}

fn written(ring: &[Point]) -> String {
    let points: Vec<String> = ring.iter().map(|v| format!("[{:?},{:?}]", v.0, v.1)).collect();
    format!("[{}]", points.join(","))
}

fn main() {
    let mut loaded = None;
    for line in io::stdin().lock().lines().map_while(Result::ok) {
        let digits = line.split_once("\"seq\":").map_or("", |parts| parts.1.trim_start());
        let seq = digits.split(|c: char| !c.is_ascii_digit()).next().unwrap_or("");
        let seq = if seq.is_empty() { "null" } else { seq };
        println!("{{\"seq\":{seq},\"status\":{}}}", answer(&line, &mut loaded));
        if line.contains("\"stop\"") { return; }
    }
}
