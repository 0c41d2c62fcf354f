//! Cavalier Contours: `Shape::parallel_offset`, rings of lines and arcs, arcs sent as polygons.
//!
//! Its defaults are absolute: positions are equal within 1e-5, slices are joined within 1e-4, and
//! tested against the distance within 1e-4. So only multiples of 1/1024 up to 10,000 are taken, and
//! the tolerance is 0.001. Arcs have 128 steps a circle: they miss 0.0003 of the radius.

mod adapter_protocol;

use adapter_protocol::{Ring, polygons_of, serve};
use cavalier_contours::polyline::{
    PlineSource, PlineSourceMut, PlineVertex, Polyline, seg_arc_radius_and_center,
};
use cavalier_contours::shape_algorithms::{Shape, ShapeOffsetOptions};
use serde_json::{Value, json};
use std::f64::consts::PI;

fn offset_of(request: &Value) -> Result<Vec<Ring>, String> {
    let rings: Vec<Ring> = polygons_of(&request["P"])?.into_iter().flatten().collect();
    let radius = request["radius"].as_f64().ok_or("no radius")?;
    if rings.iter().any(|ring| ring.len() < 3) {
        return Err("no points or segments".into());
    }
    let shape = Shape::from_plines(rings.iter().map(|ring| {
        let mut line = Polyline::new_closed();
        for [x, y] in ring {
            line.add(*x, *y, 0.0);
        }
        line
    }));
    // Positive values go to the left: into the set.
    let found = shape.parallel_offset(-radius, &ShapeOffsetOptions::new());
    Ok(found.ccw_plines.iter().chain(&found.cw_plines).map(|p| polygon(&p.polyline)).collect())
}

/// The vertices, and points of the arcs.
fn polygon(line: &Polyline<f64>) -> Ring {
    line.iter_segments().flat_map(|(a, b)| points(a, b)).collect()
}

fn points(a: PlineVertex<f64>, b: PlineVertex<f64>) -> Ring {
    let mut found = vec![[a.x, a.y]];
    if a.bulge != 0.0 {
        let (radius, center) = seg_arc_radius_and_center(a, b);
        let start = (a.y - center.y).atan2(a.x - center.x);
        let sweep = 4.0 * a.bulge.atan();
        let steps = (sweep.abs() / (PI / 64.0)).ceil() as usize;
        for k in 1..steps {
            let angle = start + sweep * k as f64 / steps as f64;
            found.push([center.x + radius * angle.cos(), center.y + radius * angle.sin()]);
        }
    }
    found
}

fn main() {
    let hello = json!({
        "name": "cavalier-contours",
        "version": "0.9.0",
        "language": "Rust",
        "arithmetic": "float64",
        "numbers": "double",
        "grid": {"unit": "1/1024", "largest": "10000"},
        "tolerance": {"absolute": "0.001", "relative": "0", "radius": "0.0005"},
        "sum": "none",
        "capabilities": ["plane", "non-convex", "holes", "components", "offset", "inset"],
    });
    serve(hello, &[("offset", offset_of)]);
}
